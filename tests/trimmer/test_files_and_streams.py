"""Devices, closed streams and standard output, in a process of its own as a user's is."""

from __future__ import annotations

import os
import subprocess
import sys
from pathlib import Path

import pytest

from trimmer.files import CSV, SVG, FileWriteError, check_replaceable, write_atomically

PARAMETERS = "import sys; from trimmer.command_line.main import main; sys.exit(main(sys.argv[1:]))"


def run(folder: Path, words: str, redirected: str) -> subprocess.CompletedProcess[str]:
    command = f'{sys.executable} -c "{PARAMETERS}" {words} {redirected}'
    return subprocess.run(command, shell=True, capture_output=True, text=True, cwd=folder, check=False)


@pytest.mark.parametrize(
    ("words", "redirected", "told"),
    [
        ("linear --parameters -", "<&-", "-: cannot be read: standard input is closed"),
        ("parameters --output /dev/stdout", ">/dev/full", "standard output cannot be written: No space left"),
    ],
)
@pytest.mark.skipif(not Path("/dev/full").exists(), reason="needs the devices of Linux")
def test_streams_that_give_or_take_nothing_are_told(project_folder: Path, words, redirected, told) -> None:
    done = run(project_folder, words, redirected)
    assert done.returncode == 2
    assert told in done.stderr
    assert "Traceback" not in done.stderr


def test_standard_output_that_goes_to_a_file_is_not_replaced(tmp_path: Path) -> None:
    """What was written before stays, although the file is named again."""
    done = run(tmp_path, "parameters --output mine.toml", ">mine.toml")
    assert done.returncode == 0
    assert (tmp_path / "mine.toml").read_text("utf-8").startswith("# Parameters of a hair trimmer")


def test_what_cannot_be_looked_at_or_written_is_told(tmp_path: Path) -> None:
    path = tmp_path / "a.svg"
    path.write_text("notes")
    with pytest.raises(FileWriteError, match=r"a\.svg is there already and is no SVG picture: name another"):
        check_replaceable(path, SVG)
    check_replaceable(path, None)
    path.write_text("<svg")
    with pytest.raises(FileWriteError, match=r"a\.svg is there already and is a file of another kind"):
        check_replaceable(path, None)
    check_replaceable(tmp_path / "none", SVG)
    check_replaceable(Path(os.devnull), CSV)
    with pytest.raises(FileWriteError, match="is a folder: name a file in it"):
        check_replaceable(tmp_path, SVG)
    with pytest.raises(FileWriteError, match="cannot be written: a file stands where its folder would be"):
        write_atomically(path / "b" / "c", "x")


def test_a_file_whose_kind_shows_too_late_is_not_replaced(tmp_path: Path) -> None:
    path, title = tmp_path / "a.tex", b"\\title{The trimmer: derivation}"
    for spaces, replaced in ((480, False), (280, True)):
        path.write_bytes(b"\\documentclass" + spaces * b" " + title)
        if replaced:
            write_atomically(path, b"\\documentclass" + title)
        else:
            with pytest.raises(FileWriteError, match="is there already"):
                write_atomically(path, b"\\documentclass" + title)
