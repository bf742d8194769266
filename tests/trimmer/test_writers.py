"""Nothing that writes files, from Python or the command line, replaces a file of the user by default."""

import inspect
import math
import re
import time
from collections.abc import Callable
from pathlib import Path

import numpy as np
import pytest

from tests.public_names import public_names
from tests.trimmer.maps.machines import linear_oscillator
from trimmer import SerialRunner, Signal, TrimmerError, motion_map, sample, write_signal
from trimmer.command_line.main import main
from trimmer.files import write_atomically
from trimmer.signals import write_wav
from trimmer.uncertainty import Keeping, SampleSettings, read_sample_file

EXAMPLES = Path(__file__).parents[2] / "examples"
TWIN, SCATTER = str(EXAMPLES / "thesis-play.toml"), str(EXAMPLES / "scatter.toml")
NOTES = "my notes, which nobody wrote twice\n"
SIGNAL = Signal(np.sin(np.arange(100.0)), 1000.0, "x", "m")


def write_map(path: Path, **how: bool) -> None:
    motion_map(linear_oscillator(), {"frequency": [1.0]}, runner=SerialRunner(), file=path, **how)


def write_samples(path: Path, *, overwrite: bool = Keeping().overwrite) -> None:
    settings, file = SampleSettings(2, most_periods=2), read_sample_file(Path(SCATTER))
    keeping = Keeping(path, overwrite=overwrite)
    sample(file.subject, file.uncertainty, settings, runner=SerialRunner(), keeping=keeping)


WRITERS: dict[str, Callable[..., None]] = {
    "write_atomically": lambda path, **how: write_atomically(path, b"RIFF\x24\x00\x00\x00WAVEfmt ", **how),
    "write_signal": lambda path, **how: write_signal(path, SIGNAL, **how),
    "write_wav": lambda path, **how: write_wav(path, SIGNAL.values, 1000.0, **how),
    "motion_map": write_map,
    "samples": write_samples,
}


def test_every_public_writer_is_among_them() -> None:
    functions = {
        name
        for name, each in public_names().items()
        if inspect.isfunction(each) and "overwrite" in _arguments(each)
    }
    assert functions == WRITERS.keys() - {"samples"}


def _arguments(function: Callable[..., object]) -> list[str]:
    return list(inspect.signature(function).parameters)


@pytest.mark.parametrize("name", WRITERS)
def test_a_function_replaces_a_file_only_if_it_is_told_to(tmp_path: Path, name: str) -> None:
    path = tmp_path / "mine.wav"
    path.write_text(NOTES, "utf-8")
    with pytest.raises(TrimmerError, match=r"mine\.wav is there already"):
        WRITERS[name](path)
    assert path.read_text("utf-8") == NOTES
    WRITERS[name](path, overwrite=True)
    assert path.read_bytes() != NOTES.encode()


PLAY = "--element friction --gap 4e-5"
LINE = "--vary frequency=100:110:40"
COMMANDS = {
    "linear": "linear",
    "limit-cycles": f"limit-cycles {PLAY}",
    "identify": "identify --gap 4e-5 --frequency 740",
    "orbits": f"orbits {PLAY}",
    "simulate": "simulate --drive 110 --amplitude 1e-3 --duration 2000",
    "spectrum": "spectrum record.csv --drive 110 --as velocity",
    "overlay": f"overlay record.csv --against {TWIN}",
    "respond": f"respond {TWIN} --starts 500",
    "follow": f"follow {TWIN} --vary frequency --from 100 --to 200",
    "map": f"map {TWIN} {LINE} --vary plays.bridge.gap=0:1e-4:40",
    "step": f"step {EXAMPLES / 'stiction-pid.toml'} --reference path",
    "sweep": f"sweep {TWIN} --vary frequency --from 100 --to 200",
    "sample": f"sample {SCATTER}",
    "fit": f"fit {TWIN} record.csv",
    "init": "init",
    "parameters": "parameters",
    "derive": f"derive {TWIN}",
    "design": f"design {TWIN}",
    "compare": f"compare {TWIN} {SCATTER}",
    "judge": f"judge {EXAMPLES / 'judged-paper'}",
    "report": "report",
}
"""Of each command that writes files a use that works for long, if it is not refused at once."""
WRITTEN = {
    "--plot": (
        *("linear", "limit-cycles", "identify", "orbits", "simulate", "spectrum", "overlay", "respond"),
        *("follow", "map", "sweep", "sample", "fit", "step"),
    ),
    "--csv": ("simulate", "spectrum"),
    "--wav": ("simulate", "spectrum"),
    "--output": ("map", "sample", "fit", "parameters"),
    "--module": ("derive",),
    "--latex": ("derive",),
    "": ("init",),
}
"""Options that name what is written, with the commands that have them."""
IN_FOLDER = {
    "design": ["thesis-play.html", "thesis-play.pdf"],
    "compare": ["thesis-play-scatter.html"],
    "judge": ["report.html", "cards.pdf"],
    "report": ["report.html", "report.pdf", "cards.pdf", "claims.json", "errata.csv"],
}
"""What is written into the folder that is named."""
NAMES = {"--wav": "mine.wav", "--plot": "mine.svg"}
PLACES = [
    *((command, option, NAMES.get(option, "mine")) for option, each in WRITTEN.items() for command in each),
    *((command, "--directory", name) for command, names in IN_FOLDER.items() for name in names),
]


@pytest.fixture
def folder(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> Path:
    monkeypatch.chdir(tmp_path)
    times = np.arange(1000) / 2000.0
    lines = (f"{at:.6f},{1e-3 * math.sin(math.tau * 110 * at):.9f}\n" for at in times)
    Path("record.csv").write_text(f"time [s],x [m]\n{''.join(lines)}", "utf-8")
    return tmp_path


def refused(capsys: pytest.CaptureFixture[str], command: str, option: str, value: str) -> str:
    """Run a command that must be refused before its work, and return what it tells."""
    begun = time.process_time()
    words = [each for each in (*COMMANDS[command].split(), option, value) if each]
    assert main(words) == 2
    assert time.process_time() - begun < 4.0  # its work would take longer
    told = capsys.readouterr()
    assert told.out == ""
    assert told.err.count("\n") == 1
    return told.err


def helped(capsys: pytest.CaptureFixture[str], *words: str) -> str:
    with pytest.raises(SystemExit):
        main([*words, "--help"])
    return capsys.readouterr().out


def test_every_option_that_writes_is_among_them(capsys: pytest.CaptureFixture[str]) -> None:
    """Each command that asks for ``--overwrite`` says in its help what it writes."""
    commands = re.findall(r"^    ([a-z-]+)(?: |$)", helped(capsys), re.MULTILINE)
    assert set(COMMANDS) <= set(commands)
    found = set()
    for command in commands:
        told = helped(capsys, command)
        options = re.findall(r"^  (--[a-z]+) (?:FILE|DIR)", told, re.MULTILINE)
        found |= {(command, each) for each in options if each in WRITTEN or each == "--directory"}
    assert found == {(command, option) for command, option, _ in PLACES if option}


@pytest.mark.parametrize(("command", "option", "name"), PLACES)
def test_a_command_replaces_no_file_of_another_kind(folder, capsys, command, option, name) -> None:
    (folder / name).write_text(NOTES, "utf-8")
    told = refused(capsys, command, option, "." if option == "--directory" else name)
    assert f"{name} is there already" in told
    assert (folder / name).read_text("utf-8") == NOTES


@pytest.mark.parametrize(("command", "option", "name"), PLACES)
def test_what_cannot_be_written_is_told_before_the_work(folder, capsys, command, option, name) -> None:
    (folder / "taken").write_text(NOTES, "utf-8")
    told = refused(capsys, command, option, "taken" if option == "--directory" else f"taken/{name}")
    assert "a file stands where its folder would be" in told
    assert sorted(each.name for each in folder.iterdir()) == ["record.csv", "taken"]
