"""No option is dropped in silence, and every error is one sentence about what was given."""

from __future__ import annotations

import io
import json
from pathlib import Path

import numpy as np
import pytest

from report.command import COMMAND as REPORT
from report.rendering.request import Format, Paper, Request
from trimmer.command_line import simulate
from trimmer.command_line.main import main
from trimmer.command_line.parser import Parser
from trimmer.parameters import TrimmerParameters
from trimmer.signals.signal import Signal
from trimmer.signals.write import write_signal

PLAY = ["--element", "friction", "--gap", "4e-5"]
DRIVEN = ["simulate", "--drive", "110", "--amplitude", "1e-3"]
SHORT = [*DRIVEN, "--duration", "0.05"]


@pytest.fixture
def file(tmp_path: Path) -> Path:
    path = tmp_path / "measured.csv"
    write_signal(path, Signal(np.sin(2 * np.pi * 110 * np.arange(4000) / 8000), 8000.0, "x", "m"))
    return path


def error(capsys: pytest.CaptureFixture[str], *words: object) -> str:
    """Give a command that is wrong, and return its message, which is one sentence."""
    try:
        code = main([str(word) for word in words])
    except SystemExit as stopped:
        code = stopped.code
    told = capsys.readouterr()
    assert (code, told.out) == (2, "")
    assert told.err.startswith("trimmer: ")
    assert told.err.count("\n") == 1
    return told.err.removeprefix("trimmer: ")


@pytest.mark.parametrize(
    ("words", "option", "use"),
    [
        ([*SHORT, "--gap", "2e-4"], "--gap", "--element"),
        ([*SHORT, "--time-constant", "1e-3"], "--time-constant", "--element"),
        ([*SHORT, "--force", "1"], "--force", "--element"),
        ([*SHORT, "--sample-rate", "20000"], "--sample-rate", "--csv or --wav"),
        ([*SHORT, "--overwrite"], "--overwrite", "--csv or --wav"),
        (["limit-cycles", *PLAY, "--overwrite"], "--overwrite", "--plot"),
        (["spectrum", "{file}", "--overwrite"], "--overwrite", "--plot or --wav"),
        (["spectrum", "{file}", "--output", "q2"], "--output", "--gap"),
        (["spectrum", "{file}", "--channels", "both"], "--channels", "--gap"),
        (["spectrum", "{file}", "--bits", "16"], "--bits", "--wav"),
        (["report", "--format", "html", "--paper", "a4"], "--paper", "pdf among --format"),
        (["report", "--format", "json", "--thesis", "{file}"], "--thesis", "html among --format"),
        (["report", "--other-copy"], "--other-copy", "--thesis"),
    ],
)
def test_an_option_without_effect_is_an_error(
    capsys, file: Path, words: list[str], option: str, use: str
) -> None:
    told = error(capsys, *(word.format(file=file) for word in words))
    assert told.startswith(f"{option} has no effect without {use}")


@pytest.mark.parametrize(
    "words",
    [
        ["limit-cycles", *PLAY, "--gap", "4e-5"],
        ["limit-cycles", *PLAY, "--plot", "a.svg", "--plot", "b.svg"],
        ["limit-cycles", *PLAY, "--omega-range", "1", "2", "--omega-range", "3", "4"],
        ["linear", "--output", "q2", "--output", "q2"],
        ["linear", "--channels", "both", "--channels", "displacement"],
        ["simulate", *PLAY, "--drive", "1", "--drive", "2"],
        ["report", "--paper", "a4", "--paper", "letter"],
    ],
)
def test_a_single_value_given_twice_is_an_error(capsys, words: list[str]) -> None:
    assert "given twice, but only one value can be used" in error(capsys, *words)


def report_request(*words: str) -> Request:
    from report.command import _request

    parser = Parser(prog="trimmer report")
    REPORT.configure(parser)
    return _request(parser.parse_args(words))


def test_what_may_be_repeated_adds_up() -> None:
    assert report_request() == Request()
    request = report_request("--only", "ch5", "--only", "ch2", "appA", "--format", "html", "--format", "pdf")
    assert request == Request(("ch5", "ch2", "appA"), frozenset({Format.HTML, Format.PDF}))
    assert report_request("--paper", "letter").paper is Paper.LETTER


def test_a_report_keeps_files_of_another_kind(tmp_path: Path, capsys) -> None:
    (tmp_path / "claims.json").write_text('{"mine": 1}')
    told = error(capsys, "report", "--directory", tmp_path, "--format", "json")
    assert told.startswith(f"{tmp_path / 'claims.json'} is there already and is no JSON file of claims")
    assert [path.name for path in tmp_path.iterdir()] == ["claims.json"]


def test_another_text_than_the_one_judged_is_refused_before_anything_is_computed(
    capsys, file: Path, tmp_path: Path
) -> None:
    folder = tmp_path / "report"
    told = error(capsys, "report", "--directory", folder, "--thesis", file)
    assert told.startswith(f"--thesis {file}: is another text than the one that was judged")
    assert report_request("--thesis", str(file), "--other-copy").copy.lines[0].startswith("time")
    assert not folder.exists()


def test_what_is_no_file_of_claims_is_refused_before_anything_is_computed(
    capsys, file: Path, tmp_path: Path
) -> None:
    folder = tmp_path / "report"
    told = error(capsys, "report", "--directory", folder, "--compare", file)
    assert told.startswith(f"--compare {file}: it is no JSON in UTF-8")
    told = error(capsys, "report", "--compare", "-", "--thesis", "-")
    assert told.startswith("--thesis and --compare both read standard input")
    assert not folder.exists()


def test_a_motion_without_files_may_have_any_length(capsys, monkeypatch) -> None:
    monkeypatch.setattr(simulate, "MOST_SAMPLES", 100)
    assert main([*SHORT, "--json"]) == 0
    assert json.loads(capsys.readouterr().out)["duration"] == 0.05
    assert "are 1e+03 samples; give 2 to 100" in error(capsys, *SHORT, "--csv", "a.csv")
    assert main([*DRIVEN, "--duration", "1e-5"]) == 0  # less than a sample


NEGATIVE = ("-1", "-1.5", "-.5", "-1e-3", "-2.E5", "-1_000", "-inf", "-Infinity")


@pytest.mark.parametrize("value", [*NEGATIVE, "-nan"])
@pytest.mark.parametrize(
    ("words", "option", "unit"),
    [
        (["simulate", "--drive", "110", "--amplitude", "{}"], "--amplitude", "(m)"),
        (["simulate", "--amplitude", "1", "--drive", "{}"], "--drive", "(Hz)"),
        ([*DRIVEN, "--duration", "{}"], "--duration", "(s)"),
        (["simulate", "--element", "friction", "--gap", "{}"], "--gap", "(m)"),
        (["simulate", "--element", "relay", "--force", "{}"], "--force", "(N)"),
        (["orbits", "--element", "viscous", "--gap", "1", "--time-constant", "{}"], "--time-constant", "(s)"),
        (["limit-cycles", "--element", "friction", "--gap", "{}"], "--gap", "(m)"),
        (["identify", "--frequency", "740", "--gap", "{}"], "--gap", "(m)"),
        (["identify", "--gap", "1", "--frequency", "{}"], "--frequency", "(Hz)"),
        (["limit-cycles", *PLAY, "--omega-range", "{}", "10"], "--omega-range", "(rad/s)"),
        (["limit-cycles", *PLAY, "--omega-range", "10", "{}"], "--omega-range", "(rad/s)"),
        ([*DRIVEN, "--csv", "a.csv", "--sample-rate", "{}"], "--sample-rate", "(Hz)"),
        (["spectrum", "a.csv", "--drive", "{}"], "--drive", "(Hz)"),
        (["spectrum", "a.csv", "--gap", "{}"], "--gap", "(m)"),
        (["spectrum", "a.csv", "--rate", "{}"], "--rate", "(Hz)"),
        ([*DRIVEN, "--friction", "q2-q4={}"], "--friction", "(N)"),
    ],
)
def test_a_negative_number_is_a_value_of_its_option_and_refused_in_its_unit(
    capsys, words: list[str], option: str, unit: str, value: str
) -> None:
    told = error(capsys, *(word.format(value) for word in words))
    assert option in told
    assert unit in told
    assert "expected" not in told


def test_a_negative_number_with_a_unit_is_a_value(capsys, project_folder: Path) -> None:
    file = str(project_folder / "examples" / "thesis-play.toml")
    told = error(capsys, "follow", file, "--vary", "plays.bridge.gap", "--from", "-1 um", "--to", "4e-5")
    assert "plays.bridge.gap" in told
    assert "expected" not in told


def test_a_range_without_length_is_refused(capsys, project_folder: Path) -> None:
    file = str(project_folder / "examples" / "thesis-play.toml")
    told = error(capsys, "follow", file, "--vary", "frequency", "--from", "100", "--to", "100")
    assert "the interval has no length" in told


def test_a_negative_impulse_is_one(capsys) -> None:
    told = []
    for impulse in ("1e-6", "-1e-6"):
        assert main(["simulate", *PLAY, "--impulse", impulse, "--duration", "0.02", "--json"]) == 0
        told.append(json.loads(capsys.readouterr().out))
    assert [each["time"] for each in told[0]["events"]] == [each["time"] for each in told[1]["events"]]
    assert {each["events"][1]["mode"] for each in told} == {"upper contact", "lower contact"}


def test_an_aborted_simulation_is_no_success(tmp_path: Path, capsys) -> None:
    unstable = ["--element", "dead-zone", "--threshold", "1e-5", "--slope", "1000", "--output", "q1-q2"]
    words = ["simulate", *unstable, "--impulse", "1", "--duration", "1"]
    assert main([*words, "--json"]) == 3
    told = capsys.readouterr()
    content = json.loads(told.out)
    assert content["outcome"] == "diverged"
    assert told.err.startswith(f"trimmer: only {content['duration']:.6g} s of 1 s: a state grew beyond 1e150")
    assert told.err.count("\n") == 1
    # Too short for a file: what was computed is told all the same.
    assert main([*words, "--csv", str(tmp_path / "a.csv"), "--sample-rate", "500"]) == 2
    told = capsys.readouterr()
    assert "a state grew beyond 1e150" in told.out
    assert "wrote" not in told.out
    assert told.err.count("\n") == 1
    assert list(tmp_path.iterdir()) == []


def stand_in(monkeypatch: pytest.MonkeyPatch, content: bytes) -> None:
    monkeypatch.setattr("sys.stdin", io.TextIOWrapper(io.BytesIO(content)))


def test_a_dash_is_standard_input(monkeypatch, capsys, file: Path) -> None:
    stand_in(monkeypatch, file.read_bytes())
    assert main(["spectrum", "-", "--json"]) == 0
    piped = json.loads(capsys.readouterr().out)
    assert main(["spectrum", str(file), "--json"]) == 0
    assert piped == json.loads(capsys.readouterr().out) | {"file": "-"}
    mine = TrimmerParameters.thesis().to_toml().replace("m1 = 0.035", "m1 = 0.07")
    stand_in(monkeypatch, mine.encode())
    assert main(["linear", "--parameters", "-", "--json"]) == 0
    assert json.loads(capsys.readouterr().out)["parameters"]["m1"] == 0.07


def test_standard_input_has_one_use_and_may_be_closed(monkeypatch, capsys) -> None:
    assert "cannot both be read from standard input" in error(capsys, "spectrum", "-", "--parameters", "-")
    monkeypatch.setattr("sys.stdin", None)
    for words in (["spectrum", "-"], ["linear", "--parameters", "-"]):
        assert error(capsys, *words).startswith("-: cannot be read: standard input is closed; ")


def test_a_file_named_dash_can_be_read(monkeypatch, capsys, tmp_path: Path) -> None:
    monkeypatch.chdir(tmp_path)
    (tmp_path / "-").write_text(TrimmerParameters.thesis().to_toml())
    monkeypatch.setattr("sys.stdin", None)
    assert main(["linear", "--parameters", "./-"]) == 0


@pytest.mark.parametrize(
    "words",
    [
        [*SHORT, "--csv"],
        [*SHORT, "--wav"],
        ["limit-cycles", *PLAY, "--plot"],
        ["parameters", "--output"],
        ["derive", "--latex"],
    ],
)
def test_a_dash_is_no_file_to_write(capsys, words: list[str]) -> None:
    assert "'-' is no file; write /dev/stdout for standard output" in error(capsys, *words, "-")


def test_files_of_the_user_are_kept(monkeypatch, capsys, tmp_path: Path, file: Path) -> None:
    monkeypatch.chdir(tmp_path)
    mine = tmp_path / "mine.toml"
    mine.write_text(TrimmerParameters.thesis().to_toml())
    (tmp_path / "notes.svg").write_text("notes")
    (tmp_path / "link.wav").symlink_to("mine.toml")
    before = {path: path.read_bytes() for path in tmp_path.iterdir()}
    for words, message in (
        (
            [*SHORT, "--csv", "mine.toml"],
            "mine.toml is there already and is no CSV file of simulated signals",
        ),
        ([*SHORT, "--wav", "link.wav"], "link.wav is there already and is no WAV file"),
        ([*SHORT, "--wav", "a.mp3"], "--wav a.mp3: the name must end in .wav"),
        ([*SHORT, "--csv", "a.wav", "--wav", "./a.wav"], "--csv and --wav both write a.wav: name two files"),
        (["limit-cycles", *PLAY, "--plot", "notes.svg"], "notes.svg is there already and is no SVG picture"),
        (["spectrum", file, "--plot", "notes.svg"], "notes.svg is there already and is no SVG picture"),
        (["derive", "--module", "mine.toml"], "mine.toml is there already and is no derived module"),
        (["derive", "--latex", "a", "--module", "a"], "--module and --latex both write a: name two files"),
        (
            [*SHORT, "--csv", "mine.toml", "--parameters", "mine.toml", "--overwrite"],
            "--csv mine.toml: is the file of the parameters; name another one to write",
        ),
    ):
        assert error(capsys, *words).startswith(message)
    assert {path: path.read_bytes() for path in tmp_path.iterdir()} == before
    assert main([*SHORT, "--csv", "mine.toml", "--overwrite"]) == 0
    assert mine.read_text().startswith("time [s],")
    assert main([*SHORT, "--csv", "mine.toml"]) == 0


@pytest.mark.skipif(not Path("/dev/stdout").exists(), reason="needs /dev/stdout")
def test_a_file_on_standard_output_stands_there_alone(capfd) -> None:
    assert main([*SHORT, "--csv", "/dev/stdout"]) == 0
    told = capfd.readouterr()
    assert told.out.startswith("time [s],q2-q4 [m],")
    assert told.out.count("\n") == 1001
    assert "Motion of 0.05 s" in told.err
    assert main(["parameters", "--output", "/dev/stdout"]) == 0
    assert capfd.readouterr() == (TrimmerParameters.thesis().to_toml(), "wrote /dev/stdout\n")
    told = error(capfd, *SHORT, "--csv", "/dev/stdout", "--wav", "/dev/fd/1")
    assert told == "--csv and --wav both write /dev/stdout: name two files\n"
