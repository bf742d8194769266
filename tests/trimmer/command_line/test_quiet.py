"""``--quiet`` leaves nothing but errors on standard error; results and files are as without it."""

from __future__ import annotations

import io
import json
import subprocess
import sys
import time
import warnings
from argparse import ArgumentParser
from pathlib import Path

import pytest

import trimmer.command_line.main as command_line
from report.building.progress import Progress
from trimmer.command_line.command import Command
from trimmer.command_line.main import installed_commands, main
from trimmer.command_line.parser import note, tell
from trimmer.command_line.patience import patience
from trimmer.progress import is_silenced, progress_bar, silenced


class Terminal(io.StringIO):
    def isatty(self) -> bool:
        return True


@pytest.mark.parametrize("command", [command.name for command in installed_commands()])
def test_each_command_takes_it_and_says_what_it_does(capsys, command: str) -> None:
    with pytest.raises(SystemExit):
        main([command, "--help"])
    shown = " ".join(capsys.readouterr().out.split())
    assert "--quiet print nothing but errors on standard error" in shown
    assert "--json" in shown


def test_notes_and_progress_are_left_out_and_errors_are_not(capsys) -> None:
    with silenced():
        note("good to know")
        with patience(0.0):
            time.sleep(0.02)
        warnings.warn("doubtful", UserWarning, stacklevel=1)
        assert Progress().run("stage", [1, 2], str) == ("1", "2")
        tell("wrong")
    assert capsys.readouterr().err == "trimmer: wrong\n"
    assert not is_silenced()
    note("good to know")
    assert capsys.readouterr().err == "trimmer: good to know\n"


@pytest.mark.parametrize("quiet", [False, True])
def test_a_bar_shows_on_a_terminal_alone(monkeypatch, quiet: bool) -> None:
    terminal = Terminal()
    monkeypatch.setattr(sys, "stderr", terminal)
    monkeypatch.setattr("trimmer.progress.SILENCE", 0.0)
    if quiet:
        with silenced():
            assert list(progress_bar(range(3), "cells", mininterval=0.0)) == [0, 1, 2]
    else:
        assert list(progress_bar(range(3), "cells", mininterval=0.0)) == [0, 1, 2]
    assert ("cells" in terminal.getvalue()) is not quiet


def test_a_derivation_is_not_announced(capsys, tmp_path: Path, monkeypatch, project_folder: Path) -> None:
    monkeypatch.chdir(tmp_path)
    file = str(project_folder / "examples" / "thrown-body.toml")
    assert main(["derive", file]) == 0
    loud = capsys.readouterr()
    assert main(["derive", file, "--quiet"]) == 0
    quiet = capsys.readouterr()
    assert loud.err.startswith("trimmer: deriving ")
    assert (quiet.out, quiet.err) == (loud.out, "")


def test_a_note_on_the_samples_is_left_out(capsys, tmp_path: Path) -> None:
    coarse = [
        "simulate",
        "--drive",
        "110",
        "--amplitude",
        "1e-3",
        "--duration",
        "0.05",
        "--sample-rate",
        "150",
    ]
    coarse += ["--csv", str(tmp_path / "a.csv"), "--json"]
    assert main(coarse) == 0
    loud = capsys.readouterr()
    assert main([*coarse, "--quiet"]) == 0
    quiet = capsys.readouterr()
    assert "trimmer: note: " in loud.err
    assert quiet.err == ""
    assert json.loads(quiet.out) == json.loads(loud.out)


def test_an_error_is_told_nevertheless(capsys) -> None:
    assert main(["linear", "--output", "q9", "--quiet"]) == 2
    assert capsys.readouterr().err.startswith("trimmer: 'q9' is not a displacement")


def test_a_file_on_standard_output_is_alone(project_folder: Path) -> None:
    code = "import sys; from trimmer.command_line.main import main; sys.exit(main(sys.argv[1:]))"
    command = [sys.executable, "-c", code, "parameters", "--output", "/dev/stdout"]
    loud, quiet = (
        subprocess.run([*command, *more], capture_output=True, cwd=project_folder, check=True)
        for more in ([], ["--quiet"])
    )
    assert loud.stdout == quiet.stdout != b""
    assert (loud.stderr, quiet.stderr) == (b"wrote /dev/stdout\n", b"")


def test_a_command_of_another_package_may_have_its_own(capsys, monkeypatch) -> None:
    def configure(parser: ArgumentParser) -> None:
        parser.add_argument("--quiet", action="store_true", help="be still")

    other = Command("other", "another", configure, lambda arguments: 7 if is_silenced() else 0)
    monkeypatch.setattr(command_line, "installed_commands", lambda: [other])
    assert [main(["other"]), main(["other", "--quiet"])] == [0, 7]
