"""Devices, closed streams and standard output, with stand-ins for those that a test cannot have."""

from __future__ import annotations

import errno
import io
import os
import sys
from pathlib import Path
from types import SimpleNamespace as Made

import pytest

from trimmer import files
from trimmer.files import CSV, SVG, FileWriteError, check_replaceable, write_atomically


def test_standard_input_is_read_unless_it_is_closed(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(sys, "stdin", Made(buffer=io.BytesIO(b"content")))
    assert files.read_content(Path("-")) == b"content"
    monkeypatch.setattr(sys, "stdin", None)
    with pytest.raises(OSError, match="standard input is closed") as error:
        files.read_content(Path("-"))
    assert error.value.errno == errno.EBADF


def test_a_device_is_read_up_to_a_limit(monkeypatch: pytest.MonkeyPatch, tmp_path: Path) -> None:
    monkeypatch.setattr(files, "MOST_OF_A_DEVICE", 8)
    long = io.BytesIO(b"123456789")
    assert files._read(long) == b"123456789"  # no device
    monkeypatch.setattr(files, "_is_device", lambda file: True)
    assert files._read(io.BytesIO(b"1234567")) == b"1234567"
    with pytest.raises(OSError, match="name a file") as error:
        files._read(io.BytesIO(b"12345678"))
    assert error.value.errno == errno.EFBIG


def test_what_is_a_device_and_a_stream(tmp_path: Path) -> None:
    path = tmp_path / "a"
    path.write_text("x")
    with path.open("rb") as plain, Path(os.devnull).open("rb") as device:
        assert [files._is_device(each) for each in (plain, device, io.BytesIO())] == [False, True, False]
    assert [files.is_stream(each) for each in (path, tmp_path / "none", tmp_path)] == [False, False, False]
    assert files.is_stream(Path(os.devnull))


class Output:
    """Stands for standard output that goes to a file."""

    def __init__(self, path: Path) -> None:
        self.file, self.flushed = path.open("wb"), 0

    def fileno(self) -> int:
        return self.file.fileno()

    def flush(self) -> None:
        self.flushed += 1


def test_standard_output_is_told_by_where_it_goes(monkeypatch: pytest.MonkeyPatch, tmp_path: Path) -> None:
    path, other = tmp_path / "a", tmp_path / "b"
    other.write_text("kept")
    output = Output(path)
    monkeypatch.setattr(sys, "stdout", output)
    assert [files.is_standard_output(each) for each in (path, other, tmp_path / "none")] == [
        True,
        False,
        False,
    ]
    check_replaceable(path, CSV)
    write_atomically(path, "ω")
    assert (path.read_text("utf-8"), output.flushed) == ("ω", 1)
    output.fileno()  # it stays open
    monkeypatch.setattr(sys, "stdout", io.StringIO())
    assert not files.is_standard_output(path)
    monkeypatch.setattr(sys, "stdout", None)
    assert not files.is_standard_output(path)
    output.file.close()


@pytest.mark.parametrize(
    ("error", "kind", "told"),
    [
        (BrokenPipeError("gone"), BrokenPipeError, "gone"),
        (OSError(errno.ENOSPC, "No space"), FileWriteError, "standard output cannot be written: No space"),
    ],
)
def test_what_standard_output_does_not_take_is_told(
    monkeypatch: pytest.MonkeyPatch, error: OSError, kind: type[OSError], told: str
) -> None:
    def fail() -> None:
        raise error

    monkeypatch.setattr(sys, "stdout", Made(flush=fail))
    with pytest.raises(kind, match=told):
        files._write_to_standard_output(b"x")


def test_what_cannot_be_looked_at_or_written_is_told(monkeypatch: pytest.MonkeyPatch, tmp_path: Path) -> None:
    path = tmp_path / "a.svg"
    path.write_text("notes")
    with pytest.raises(FileWriteError, match=r"a\.svg is there already and is no SVG picture: name another"):
        check_replaceable(path, SVG)
    check_replaceable(path, None)
    path.write_text("<svg")
    with pytest.raises(FileWriteError, match=r"a\.svg is there already and is a file of another kind"):
        check_replaceable(path, None)
    check_replaceable(tmp_path / "none", SVG)
    with pytest.raises(FileWriteError, match="is a folder: name a file in it"):
        check_replaceable(tmp_path, SVG)
    with pytest.raises(FileWriteError, match="cannot be written: a file stands where its folder would be"):
        write_atomically(path / "b" / "c", "x")

    def fail(*_: object) -> None:
        raise PermissionError(errno.EACCES, "Permission denied")

    monkeypatch.setattr(files, "_target", fail)
    with pytest.raises(
        FileWriteError, match=r"a\.svg cannot be replaced: Permission denied; name another file"
    ):
        check_replaceable(path, SVG)
    with pytest.raises(
        FileWriteError, match=r"a\.svg cannot be written: Permission denied; name another place"
    ):
        write_atomically(path, "x", overwrite=True)


def test_kinds_are_told_by_the_first_bytes() -> None:
    assert files._kind(b"time [s],x") is CSV
    assert files._kind(b" time [s],x") is None
    head = b"\\documentclass" + 480 * b" " + b"\\title{The trimmer: derivation}"
    assert files._kind(head) is None  # too far from the beginning
    assert files._kind(head.replace(200 * b" ", b"", 1)) is files.LATEX
