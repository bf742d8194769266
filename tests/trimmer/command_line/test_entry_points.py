"""Commands of other packages, which their entry points name; and how any command ends."""

import textwrap
from collections.abc import Callable
from pathlib import Path

import pytest

from trimmer.command_line.main import ENTRY_POINT_GROUP, installed_commands, main

MODULE = """
import sys, warnings
import numpy as np
from trimmer.command_line.command import Command
from trimmer.errors import TrimmerError
from trimmer.progress import is_silenced

def configure(parser):
    parser.add_argument("--how", default="well")
    QUIET

def odd():
    warnings.warn("careful")
    warnings.warn("plain", Warning)
    numbers = np.array([1e300, 0.0])
    numbers / numbers + numbers * numbers
    return 7

ENDS = {
    "well": lambda: 7 + is_silenced(),
    "wrong": lambda: _raise(TrimmerError("do this instead\\x1b[2J")),
    "bug": lambda: _raise(ZeroDivisionError("a bug")),
    "interrupted": lambda: _raise(KeyboardInterrupt()),
    "memory": lambda: _raise(MemoryError("Unable to allocate 3.5 TiB")),
    "no memory": lambda: _raise(MemoryError()),
    "disk": lambda: _raise(OSError(28, "No space left on device", "disk")),
    "temporary": lambda: _raise(FileNotFoundError(2, "No usable temporary directory")),
    "words": lambda: _raise(OSError("no folder for pictures")),
    "reader": lambda: _raise(BrokenPipeError()),
    "odd": odd,
}

def _raise(error):
    raise error

COMMAND = Command("other", "a command of another package", configure, lambda given: ENDS[given.how]())
NO_COMMAND = "not a command"
"""


@pytest.fixture
def install(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> Callable[..., None]:
    """Install a package with a command, as its folder on the path."""
    monkeypatch.syspath_prepend(tmp_path)

    def install(target: str, name: str, quiet: str = "pass") -> None:
        (tmp_path / f"{name}.py").write_text(textwrap.dedent(MODULE).replace("QUIET", quiet), "utf-8")
        information = tmp_path / f"{name}-1.0.dist-info"
        information.mkdir()
        (information / "METADATA").write_text(f"Metadata-Version: 2.1\nName: {name}\nVersion: 1.0\n")
        (information / "entry_points.txt").write_text(f"[{ENTRY_POINT_GROUP}]\nother = {target}\n")

    return install


def test_help_lists_them_with_our_own(install, capsys) -> None:
    install("listed_one:COMMAND", "listed_one")
    with pytest.raises(SystemExit) as stopped:
        main(["--help"])
    assert stopped.value.code == 0
    assert "    other" in (listed := capsys.readouterr().out) and "a command of another package" in listed
    assert installed_commands()[0].name == "linear"


@pytest.mark.parametrize(
    ("how", "code", "told"),
    [
        ("well", 7, ""),
        ("wrong", 2, "do this instead\\x1b[2J"),
        ("interrupted", 130, "interrupted before the result was complete"),
        ("memory", 2, "there is not enough memory for that (Unable to allocate 3.5 TiB); ask for less"),
        ("no memory", 2, "there is not enough memory for that (no more could be had); ask for less"),
        ("words", 2, "no folder for pictures"),
        ("disk", 2, "disk: No space left on device; send the output elsewhere"),
        ("temporary", 2, "No usable temporary directory; set TMPDIR to a folder that can be written to"),
        ("reader", 0, ""),
    ],
)
def test_how_a_command_ends(install, capsys, how: str, code: int, told: str) -> None:
    install("ending_one:COMMAND", "ending_one")
    assert main(["other", "--how", how]) == code
    assert capsys.readouterr() == ("", f"trimmer: {told}\n" if told else "")


def test_an_error_of_the_program_is_not_hidden(install) -> None:
    install("failing_one:COMMAND", "failing_one")
    with pytest.raises(ZeroDivisionError, match="a bug"):
        main(["other", "--how", "bug"])


def test_warnings_are_told_in_a_sentence_each(install, capsys) -> None:
    install("warning_one:COMMAND", "warning_one")
    assert main(["other", "--how", "odd"]) == 7
    own, plain, strange = capsys.readouterr().err.splitlines()
    assert (own, plain) == ("trimmer: warning: careful", "trimmer: warning: plain")
    assert strange.startswith("trimmer: warning: some numbers on the way became too large")
    assert main(["other", "--how", "odd", "--quiet"]) == 7
    assert capsys.readouterr() == ("", "")


def test_quiet_is_given_to_each_unless_it_has_one_of_its_own(install, capsys) -> None:
    install(
        "quiet_one:COMMAND", "quiet_one", "parser.add_argument('--quiet', action='store_true', help='own')"
    )
    assert [main(["other"]), main(["other", "--quiet"])] == [7, 8]


@pytest.mark.parametrize(
    ("target", "message"),
    [
        ("no.such.module:COMMAND", "does not load: No module named 'no'"),
        ("broken_one:NO_COMMAND", "is not a Command"),
    ],
)
def test_a_broken_one_does_not_take_the_others_with_it(install, capsys, target: str, message: str) -> None:
    install(target, "broken_one")
    with pytest.raises(SystemExit):
        main(["--help"])
    printed = capsys.readouterr()
    assert printed.err == f"trimmer: command 'other' ({target}) {message}\n"
    assert "    parameters" in printed.out
    assert main(["parameters"]) == 0
    assert capsys.readouterr().err == ""  # it is not even looked for
