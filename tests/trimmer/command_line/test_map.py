from __future__ import annotations

import json
from pathlib import Path

import numpy as np
import pytest

from tests.complaints import complaints
from tests.json_document import documented, keys
from trimmer.command_line.main import main

FILE = str(Path(__file__).parents[3] / "examples" / "thesis-play.toml")
GAP = "plays.bridge.gap=40um:200um:2"
FORCE = "frictions.blade.force=1:2:2"
MAP = ["map", FILE, "--vary", GAP, "--vary", FORCE, "--jobs", "1"]
NAMED_BY_DATA = {"outputs", "bodies", "frictions"}
NAMED_IN_TEXT = {"periodic", "failed"}
OSCILLATOR = str(Path(FILE).parent / "oscillator-stop.toml")
STOP = ["--vary", "frequency=0.86:0.8865:2", "--vary", "stops.stop.gap=9.9:10.1:2"]
CURVES = ["map", OSCILLATOR, *STOP, "--jobs", "1", "--special", "1"]


def run(capsys: pytest.CaptureFixture[str], *arguments: str, code: int = 0) -> str:
    assert main([*arguments]) == code
    printed = capsys.readouterr()
    assert (complaints(printed.err) == "") == (code == 0)
    return printed.err if code else printed.out


def test_json_has_the_keys_of_the_document_and_the_known_motions(capsys) -> None:
    found = json.loads(run(capsys, *MAP, "--json"))
    printed = set(keys(found, NAMED_BY_DATA))
    of_curves = {key for key in documented("trimmer map") if key.startswith("special.")}
    assert printed == documented("trimmer map") - NAMED_IN_TEXT - of_curves
    assert found["places"] == ["plays.bridge.gap", "frictions.blade.force"]
    assert found["values"] == [[40e-6, 200e-6], [1.0, 2.0]]
    assert found["period_count"][0][0] == 1
    assert found["period_count"][1][1] == 3
    assert found["kind"][1][1] == "periodic"
    assert found["outputs"]["stroke"]["peak_to_peak"][0][0] == pytest.approx(2.933334121400e-3, rel=5e-13)
    assert found["bodies"]["motor"]["rms_acceleration"][0][0] == pytest.approx(118.754895, abs=5e-7)


def test_text_counts_the_motions_and_says_what_was_searched(capsys) -> None:
    text = run(capsys, *MAP)
    assert "plays.bridge.gap from 4e-05 to 0.0002 m, 2 values" in text
    assert "period 3" in text
    assert "motor, rms acceleration" in text
    assert "searched: 4 cells, each from rest" in text


def test_other_numbers_are_set_first(capsys) -> None:
    line = ["map", FILE, "--vary", GAP, "--set", "frictions.blade.force=2", "--json"]
    assert json.loads(run(capsys, *line))["period_count"] == [[1, 3]]


def test_more_motions_are_looked_for(capsys) -> None:
    assert "were tried in the 8 cells around it" in run(capsys, *MAP, "--coexisting")


def test_starts_and_seed(capsys) -> None:
    text = run(capsys, *MAP, "--starts", "2", "--seed", "5", "--periods", "20")
    assert "1 random states (seed 5), for at most 20 drive periods" in text


def test_special_points_are_followed_over_both_numbers(tmp_path: Path, capsys) -> None:
    picture = tmp_path / "map.svg"
    found = json.loads(run(capsys, *CURVES, "--json", "--plot", str(picture)))
    printed = set(keys(found, NAMED_BY_DATA))
    of_meetings = {key for key in documented("trimmer map") if key.startswith("special.meetings[].")}
    assert (
        printed - {"special.meetings"}
        == documented("trimmer map") - NAMED_IN_TEXT - {"special"} - of_meetings
    )
    assert found["special"]["meetings"] == []
    special = found["special"]
    assert "at stops.stop.gap = 10: 4 special points, which lie on 2 curves" in special["searched"]
    grazing, doubling = sorted(special["curves"], key=lambda curve: curve["kind"])
    assert (grazing["kind"], doubling["kind"]) == ("grazing", "period-doubling")
    assert (grazing["parts"], doubling["parts"]) == (["stop"], [])
    assert grazing["drive_periods"] == 1
    frequencies, gaps = np.array(grazing["values"]).T
    assert sorted(gaps[[0, -1]]) == pytest.approx([9.9, 10.1])
    omega = 2.0 * np.pi * frequencies
    # Below the gap the oscillator is linear.
    assert gaps == pytest.approx(100.0 / abs(40.0 - omega**2 + 0.1j * np.sqrt(40.0) * omega), rel=1e-10)
    assert [end["reason"] for end in grazing["ends"]] == ["left", "left"]
    assert picture.read_bytes() != b""


def test_the_text_names_the_curves(capsys) -> None:
    text = run(capsys, *CURVES)
    assert "grazing, stop: " in text
    assert "it leaves the ranges, at frequency = " in text
    assert "others were not looked for" in text


def test_an_interrupt_while_curves_are_followed_says_what_is_kept(tmp_path, capsys, monkeypatch) -> None:
    from trimmer.maps import special_work

    def interrupted(*_, **__):
        raise KeyboardInterrupt

    monkeypatch.setattr(special_work, "follow", interrupted)
    file = tmp_path / "map.jsonl"
    told = run(capsys, *CURVES, "--output", str(file), code=130)
    assert f"the map is in {file}; the same call with --resume goes on with the special points" in told
    assert "name a file (--output) to keep it" in run(capsys, *CURVES, code=130)


@pytest.mark.parametrize("end", ["svg", "png", "pdf"])
def test_a_picture_is_the_same_each_time(tmp_path: Path, capsys, end: str) -> None:
    pictures = [tmp_path / f"{name}.{end}" for name in ("first", "second")]
    for picture in pictures:
        assert f"wrote {picture}" in run(capsys, *MAP, "--periods", "20", "--plot", str(picture))
    first, second = (picture.read_bytes() for picture in pictures)
    assert first == second


def test_a_file_is_gone_on_with(tmp_path: Path, capsys) -> None:
    file = tmp_path / "map.jsonl"
    fresh = run(capsys, *MAP, "--output", str(file), "--json")
    lines = file.read_text("utf-8").splitlines(keepends=True)
    file.write_text("".join(lines[:3]) + lines[3][:50], "utf-8")
    assert run(capsys, *MAP, "--output", str(file), "--resume", "--json") == fresh
    assert sorted(file.read_text("utf-8").splitlines()) == sorted(line.rstrip("\n") for line in lines)


def test_an_interrupt_says_how_to_go_on(tmp_path: Path, capsys, monkeypatch) -> None:
    from trimmer.runners.runner import SerialRunner

    def interrupted(self, work, cells):
        yield work(next(iter(cells)))
        raise KeyboardInterrupt

    monkeypatch.setattr(SerialRunner, "results", interrupted)
    told = run(capsys, *MAP, "--output", str(tmp_path / "map.jsonl"), code=130)
    assert "interrupted after 1 of 4 cells" in told
    assert "--resume" in told


@pytest.mark.parametrize(
    ("options", "message"),
    [
        ([], "--vary is missing: give it once for a line or twice for a map"),
        (["--vary", GAP, "--vary", FORCE, "--vary", "frequency=60:200:3"], "--vary was given 3 times"),
        (["--vary", GAP, "--vary", GAP], "plays.bridge.gap was given twice"),
        (["--vary", "plays.bridg.gap=0:1:3"], "did you mean plays.bridge.gap?"),
        (["--vary", "plays.bridge.gap"], "write PLACE=VALUE"),
        (["--vary", "plays.bridge.gap=0:1e-4"], "write PLACE=A:B:N"),
        (["--vary", "plays.bridge.gap=0:1e-4:0"], "0 is no number of values"),
        (["--vary", "plays.bridge.gap=0:1e-4:-3"], "-3 is no number of values"),
        (["--vary", "plays.bridge.gap=0:1e-4:2.5"], "2.5 is no number of values"),
        (["--vary", "plays.bridge.gap=0:1e-4:1"], "set a single value with --set"),
        (["--vary", "plays.bridge.gap=1e-4:100um:3"], "from 1e-4 to the same"),
        (["--vary", "plays.bridge.gap=-1um:1um:3"], "must be zero or greater"),
        (["--vary", "plays.bridge.gap=0kg:1kg:3"], "'kg' does not measure what m does"),
        (["--vary", "plays.bridge.gap=0:nan:3"], "'nan': is no number"),
        (["--vary", "plays.bridge.gap=0:exit():3"], "text is not evaluated"),
        (["--vary", "pins.pin.order=1:2:3"], "must be a whole number"),
        (["--vary", GAP, "--set", "plays.bridge.gap"], "write PLACE=VALUE"),
        (["--vary", GAP, "--jobs", "0"], "--jobs 0: give a whole number from 1 on"),
        (["--vary", GAP, "--periods", "1"], "--periods 1: give a whole number from 2 on"),
        (["--vary", GAP, "--starts", "0"], "--starts 0"),
        (["--vary", GAP, "--seed", "2"], "--seed has no effect without --starts"),
        (["--vary", GAP, "--special", "2"], "--special follows points over two numbers"),
        (["--vary", GAP, "--resume"], "--resume goes on with the file of --output"),
        (["--vary", GAP, "--overwrite"], "--overwrite has no effect without"),
        (["--vary", GAP, "--plot", "map.txt"], "the name must end in"),
        (["--vary", GAP, "--output", FILE], "is the file of the mechanism"),
    ],
)
def test_wrong_use_is_told_in_a_sentence(capsys, options, message: str) -> None:
    told = run(capsys, "map", FILE, *options, code=2)
    assert message in told
    assert told.startswith("trimmer: ")
    assert told.count("\n") == 1


def test_a_file_that_is_no_mechanism_is_named(tmp_path: Path, capsys) -> None:
    file = tmp_path / "none.toml"
    assert str(file) in run(capsys, "map", str(file), "--vary", GAP, code=2)
