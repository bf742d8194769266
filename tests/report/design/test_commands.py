"""`trimmer init`, `design` and `compare` as a new user tries them, and wrongly.

Touches inner parts: a look that is quick enough for a test has no door.
"""

import contextlib
import io
import multiprocessing
import re
import signal
from importlib.metadata import EntryPoint
from pathlib import Path

import pytest

from report.cache.stage_store import StageStore
from report.design.building import CACHE, keeper_of, looked_at
from trimmer import SerialRunner
from trimmer.command_line import main as command_line
from trimmer.command_line.main import main
from trimmer.design import DesignSettings, read_design_file, settings
from trimmer.examples import examples

TINY = DesignSettings(
    starts=1, cells=3, cell_periods=40, neighbours=3, grid=1,
    trials=2, most_points=8, range_points=3, most_periods=100,
)  # fmt: skip
SMALL = """
title = "Block on a floor"
frequency = "20 Hz"
[bodies]
block = { mass = 1.0 }
[pins]
pin = { on = "ground", amplitude = "1 mm" }
[plays]
fork = { between = ["pin", "block"], stiffness = 20e3, damping = 60.0, gap = "0.1 mm" }
[frictions]
floor = { between = ["ground", "block"], force = 2.0 }
[outputs]
stroke = { block = 1 }
"""


LOGGED = ["design", "block.toml", "--jobs", "1", "--format", "html", "--directory", "out"]


@pytest.fixture(autouse=True)
def commands(monkeypatch: pytest.MonkeyPatch) -> None:
    """The commands of this package, whatever is installed; and a look that is quick."""
    group = command_line.ENTRY_POINT_GROUP
    found = [
        EntryPoint(n, f"report.design.{m}:COMMAND", group)
        for n, m in (("compare", "compare_command"), ("design", "command"))
    ]
    monkeypatch.setattr(command_line, "entry_points", lambda group: found)
    monkeypatch.setattr(settings, "USUAL", TINY)


@pytest.fixture
def folder(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> Path:
    """The folder in which one works."""
    monkeypatch.chdir(tmp_path)
    (tmp_path / "block.toml").write_text(SMALL)
    return tmp_path


def test_a_file_to_start_from_is_written_once(folder: Path, capsys: pytest.CaptureFixture[str]) -> None:
    assert main(["init"]) == 0
    assert (folder / "trimmer.toml").read_text().startswith("# The hair trimmer")
    assert "trimmer design trimmer.toml" in capsys.readouterr().out
    assert main(["init"]) == 2
    assert "is there already" in capsys.readouterr().err
    for name in examples():
        assert main(["init", "--example", name, f"{name}.toml"]) == 0
        read_design_file(folder / f"{name}.toml")


@pytest.mark.slow
def test_a_design_is_written_whole_and_again_from_what_is_kept(folder: Path, capsys) -> None:
    assert main(["design", "block.toml", "--jobs", "1", "--directory", "out"]) == 0
    first = (folder / "out" / "block.html").read_text()
    assert (folder / "out" / "block.pdf").read_bytes().startswith(b"%PDF-")
    told = capsys.readouterr()
    assert "The file names no targets" in told.out
    assert "branch over the gap of fork" in told.err
    assert main(LOGGED) == 0
    assert (folder / "out" / "block.html").read_text() == first
    assert "branch over the gap of fork: kept" in capsys.readouterr().err
    left = {path.name for path in (folder / "out").iterdir()}
    assert left == {CACHE, "block.html", "block.log", "block.pdf"}


def test_a_comparison_says_what_changed(folder: Path, capsys: pytest.CaptureFixture[str]) -> None:
    (folder / "tight.toml").write_text(SMALL.replace("0.1 mm", "50 um"))
    assert main(["compare", "block.toml", "tight.toml", *LOGGED[2:]]) == 0
    page = (folder / "out" / "block-tight.html").read_text().replace("\N{NO-BREAK SPACE}", " ")
    for words in ("Gap of fork", "100 µm", "50 µm", "−50 %", "Impact speed in fork"):
        assert words in page
    assert "Neither file names targets" in capsys.readouterr().out


@pytest.mark.parametrize(
    ("arguments", "told"),
    [
        (["design", "none.toml"], "none.toml: no such file; 'trimmer init FILE' writes one to start from"),
        (["design", "block.toml", "--jobs", "0"], "--jobs 0"),
        (["design", "block.toml", "--format", "html", "--paper", "a4"], "--paper has no effect without pdf"),
        (["design", "block.toml", "--format", "pdf", "--open"], "--open shows the HTML"),
        (["design", "block.toml", "--set", "plays.fork.gab=1"], "no number at plays.fork.gab"),
        (["compare", "block.toml", "block.toml", "--set", "gap"], "sets nothing"),
        (["compare", "-", "-"], "both files are standard input"),
        (["init", "block.toml"], "block.toml is there already"),
    ],
)
def test_wrong_use_is_told_in_a_sentence(folder: Path, capsys, arguments: list[str], told: str) -> None:
    assert main(arguments) == 2
    assert told in capsys.readouterr().err


@pytest.mark.parametrize(
    ("time", "told"),
    [
        ("soon", "'soon' is no time: write 90s, 10min or none"),
        ("-1", "'-1' is no time"),
        ("180", "'180' is no time"),
        ("3 mm", "'3 mm' is no time"),
        ("-20 s", "'-20 s' is too short: allow at least 10s"),
        ("9.9s", "'9.9s' is too short"),
    ],
)
@pytest.mark.parametrize("files", [["design", "block.toml"], ["compare", "block.toml", "block.toml"]])
def test_a_time_that_is_none_is_refused(files: list[str], time: str, told: str, folder: Path, capsys) -> None:
    with pytest.raises(SystemExit):
        main([*files, "--budget", time])
    assert told in capsys.readouterr().err
    assert not (folder / "build").exists()


@pytest.mark.parametrize(
    ("there", "told"),
    [
        ("block.html", "is there already and is no HTML page"),
        ("block.log", "block.log is there already and is no log of a design"),
        ("", "out/block.html cannot be written: a file stands where its folder would be"),
    ],
)
def test_what_somebody_else_wrote_is_kept_and_told_before_any_work(folder, capsys, there, told) -> None:
    path = folder / "out" / there
    path.parent.mkdir(exist_ok=True)
    path.write_text("notes")
    assert main(LOGGED) == 2
    err = capsys.readouterr().err
    assert told in err and "motions from several starts" not in err
    assert path.read_text() == "notes" and not (folder / "out" / CACHE).exists()


@pytest.mark.slow
def test_a_log_says_what_was_done_and_what_time_was_left(folder: Path) -> None:
    assert main([*LOGGED, "--budget", "10min"]) == 0
    lines = (folder / "out" / "block.log").read_text().splitlines()
    assert lines[0].startswith("trimmer design: ")
    assert re.fullmatch(r"done \(\d:\d\d left\)", lines[-1])  # less than ten minutes, however slow it was
    assert any(re.fullmatch(r"branch over the gap of fork: .* \(\d+:\d\d left\)", line) for line in lines)


class Interrupting(io.StringIO):
    """Takes what is told, and interrupts as a user would once that holds some words."""

    def __init__(self, words: str) -> None:
        super().__init__()
        self.words = words

    def write(self, text: str) -> int:
        if self.words in text:
            signal.raise_signal(signal.SIGINT)
        return super().write(text)


@pytest.mark.slow
@pytest.mark.parametrize("words", ["motions of neighbours", "equations, pictures and pages"])
def test_an_interrupted_design_leaves_nothing_half_written_and_goes_on(words, folder, capsys) -> None:
    told = Interrupting(words)
    with contextlib.redirect_stderr(told):
        assert main(LOGGED) == 130
    assert "what is done is kept in out/.kept" in told.getvalue()
    assert {path.name for path in (folder / "out").iterdir()} == {CACHE, "block.log"}
    assert not list((folder / "out" / CACHE).glob("*.part"))
    assert main(LOGGED) == 0
    assert "motions from several starts: kept" in capsys.readouterr().err


def look(path: Path, folder: Path) -> None:
    """Look at a design, as one of two processes."""
    looked_at(read_design_file(path), TINY, SerialRunner(), StageStore(folder), lambda *_: None)


@pytest.mark.slow
def test_two_runs_in_one_folder_do_not_spoil_each_other(folder: Path) -> None:
    (folder / "other.toml").write_text(SMALL.replace("0.1 mm", "0.2 mm"))
    paths, kept = [folder / "block.toml", folder / "block.toml", folder / "other.toml"], folder / CACHE
    context = multiprocessing.get_context("fork")
    runs = [context.Process(target=look, args=(path, kept)) for path in paths]
    for run in runs:
        run.start()
    for run in runs:
        run.join(120)
    assert [run.exitcode for run in runs] == [0, 0, 0]
    for path in paths[1:]:
        file = read_design_file(path)
        together = looked_at(file, TINY, SerialRunner(), StageStore(kept), lambda *_: None)
        store = StageStore(folder / "alone" / path.stem)
        alone = looked_at(file, TINY, SerialRunner(), store, lambda *_: None)
        assert [each.result.cells for each in together.maps] == [each.result.cells for each in alone.maps]
        assert together.motion.outputs["stroke"].peak_to_peak == alone.motion.outputs["stroke"].peak_to_peak
        assert keeper_of(file, StageStore(kept)).depends == keeper_of(file, StageStore(folder)).depends


@pytest.mark.parametrize(
    ("old", "new", "told"),
    [
        ("mass = 1.0", 'mass = 1.0, symbol = "K"', "the derivation uses this symbol itself"),
        ("force = 2.0", 'force = 2.0, symbol = "k_1"', "the symbol k_1 is taken twice"),
    ],
)
def test_symbols_that_print_the_same_are_told_before_any_work(old, new, told, folder, capsys) -> None:
    text = SMALL.replace("stiffness = 20e3", 'stiffness = 20e3, symbol = "k_1"').replace(old, new)
    (folder / "block.toml").write_text(text)
    assert main(["design", "block.toml", "--directory", "out"]) == 2
    assert told in capsys.readouterr().err
    assert not (folder / "out").exists()
