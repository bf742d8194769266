from __future__ import annotations

import os
import subprocess
import sys
from argparse import ArgumentParser
from dataclasses import replace
from importlib.metadata import EntryPoint
from pathlib import Path

import pytest

import trimmer.command_line.main as command_line
from trimmer.command_line.command import Command
from trimmer.command_line.main import ENTRY_POINT_GROUP, main
from trimmer.errors import TrimmerError


def no_options(parser: ArgumentParser) -> None:
    pass


def fail(error: BaseException) -> Command:
    def run(arguments: object) -> int:
        raise error

    return Command("other", "a command of another package", no_options, run)


OTHER = Command("other", "a command of another package", no_options, lambda arguments: 7)
NO_COMMAND = "not a command"


@pytest.fixture
def entry(monkeypatch: pytest.MonkeyPatch):
    """Make another package's entry point the only one there is."""

    def install(target: str) -> None:
        point = EntryPoint("other", target, ENTRY_POINT_GROUP)
        monkeypatch.setattr(command_line, "entry_points", lambda group: [point])

    install(f"{__name__}:OTHER")
    monkeypatch.setitem(sys.modules, __name__, sys.modules.get(__name__, sys.modules["__main__"]))
    monkeypatch.setattr(sys.modules[__name__], "OTHER", OTHER, raising=False)
    monkeypatch.setattr(sys.modules[__name__], "NO_COMMAND", NO_COMMAND, raising=False)
    return install


def test_help_lists_the_commands_with_those_of_other_packages(entry, capsys) -> None:
    with pytest.raises(SystemExit) as stopped:
        main(["--help"])
    assert stopped.value.code == 0
    listed = capsys.readouterr().out
    for name in ("linear", "parameters", "derive", "other"):
        assert f"    {name}" in listed
    assert "a command of another package" in listed


def test_a_command_of_another_package_runs_and_gives_the_exit_code(entry) -> None:
    assert main(["other"]) == 7


@pytest.mark.parametrize(
    ("target", "message"),
    [
        ("no.such.module:COMMAND", "does not load: No module named 'no'"),
        (f"{__name__}:NO_COMMAND", "is not a Command"),
    ],
)
def test_a_broken_command_does_not_take_the_others_with_it(entry, capsys, target, message) -> None:
    entry(target)
    assert main(["parameters"]) == 0
    printed = capsys.readouterr()
    assert f"command 'other' ({target}) {message}" in printed.err
    assert "m1 = 0.035" in printed.out


@pytest.mark.parametrize(
    "arguments", [[], ["nonsense"], ["linear", "--nonsense"], ["linear", "--channels", "x"]]
)
def test_wrong_use_is_exit_code_2_with_the_usage(capsys, arguments: list[str]) -> None:
    with pytest.raises(SystemExit) as stopped:
        main(arguments)
    assert stopped.value.code == 2
    assert "usage: trimmer" in capsys.readouterr().err


def test_what_the_user_can_correct_is_reported_without_a_traceback(entry, capsys, monkeypatch) -> None:
    monkeypatch.setattr(sys.modules[__name__], "OTHER", fail(TrimmerError("do this instead")))
    assert main(["other"]) == 2
    assert capsys.readouterr().err == "trimmer: do this instead\n"


@pytest.mark.skipif(not Path("/dev/full").exists(), reason="needs /dev/full")
def test_a_full_disk_behind_standard_output_is_reported(project_folder: Path) -> None:
    code = "import sys; from trimmer.command_line.main import main; sys.exit(main(['parameters']))"
    with open("/dev/full", "wb") as full:
        done = subprocess.run(
            [sys.executable, "-c", code],
            stdout=full,
            stderr=subprocess.PIPE,
            text=True,
            cwd=project_folder,
            check=False,
        )
    expected = "trimmer: standard output: No space left on device; send the output elsewhere\n"
    assert (done.returncode, done.stderr) == (2, expected)


def test_an_error_of_the_program_is_not_hidden(entry, monkeypatch) -> None:
    monkeypatch.setattr(sys.modules[__name__], "OTHER", fail(ZeroDivisionError("a bug")))
    with pytest.raises(ZeroDivisionError):
        main(["other"])


def test_an_interrupt_is_exit_code_130(entry, monkeypatch) -> None:
    monkeypatch.setattr(sys.modules[__name__], "OTHER", fail(KeyboardInterrupt()))
    assert main(["other"]) == 130


def test_version(capsys) -> None:
    with pytest.raises(SystemExit) as stopped:
        main(["--version"])
    assert stopped.value.code == 0
    assert capsys.readouterr().out.startswith("trimmer ")


def test_a_reader_that_stops_early_is_no_error(project_folder: Path) -> None:
    code = "import sys; from trimmer.command_line.main import main; sys.exit(main(['parameters']))"
    read_end, write_end = os.pipe()
    os.close(read_end)
    with os.fdopen(write_end, "wb") as closed_pipe:
        done = subprocess.run(
            [sys.executable, "-c", code],
            stdout=closed_pipe,
            stderr=subprocess.PIPE,
            text=True,
            cwd=project_folder,
            env={**os.environ, "PYTHONUNBUFFERED": ""},
            check=False,
        )
    assert (done.returncode, done.stderr) == (0, "")


def test_a_command_cannot_be_changed() -> None:
    assert replace(OTHER, name="third").name == "third"
    with pytest.raises(AttributeError):
        OTHER.name = "third"  # type: ignore[misc]
