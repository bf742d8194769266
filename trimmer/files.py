"""Reading files and standard input; writing files whole or not at all, and only over what may be replaced."""

from __future__ import annotations

import errno
import os
import re
import secrets
import shutil
import stat
import sys
from dataclasses import dataclass
from pathlib import Path

from trimmer.arguments import file_path, require_instance, truth_value
from trimmer.errors import TrimmerError

STANDARD_INPUT = Path("-")
"""Stands for standard input where a file is read."""


class FileWriteError(TrimmerError, OSError):
    """A file could not be written; the message says which one and why."""


@dataclass(frozen=True)
class FileKind:
    """A kind of file that is written.

    Attributes:
        name: What it is called in a message.
        begins: What its first bytes look like.
    """

    name: str
    begins: re.Pattern[bytes]


CSV = FileKind("CSV file of simulated signals", re.compile(rb"time \[s\],"))
WAV = FileKind("WAV file", re.compile(rb"RIFF....WAVE", flags=re.DOTALL))
PNG = FileKind("PNG picture", re.compile(rb"\x89PNG\r\n\x1a\n"))
SVG = FileKind("SVG picture", re.compile(rb"(?:<\?xml[^>]*>\s*)?<(?:!DOCTYPE )?svg\b"))
PDF = FileKind("PDF file", re.compile(rb"%PDF-"))
HTML = FileKind("HTML page", re.compile(rb"(?i)<!doctype html"))
JSON = FileKind("JSON file of claims", re.compile(rb'\{\s*"schema"'))
TOML = FileKind("parameter file", re.compile(rb"# Parameters of a hair trimmer"))
MODULE = FileKind("derived module", re.compile(rb'"""Linear trimmer in numbers\.'))
LATEX = FileKind(
    "derivation in LaTeX",
    re.compile(rb"\\documentclass.*\\title\{The trimmer: derivation\}", flags=re.DOTALL),
)
KINDS = (CSV, WAV, PNG, SVG, PDF, HTML, JSON, TOML, MODULE, LATEX)

_HEAD = 512
"""As many bytes as it takes to tell the kind of a file."""


def read_content(path: Path) -> bytes:
    """Read a file, or standard input if the path is ``STANDARD_INPUT``.

    Raises:
        OSError: if it cannot be read.
    """
    if path != STANDARD_INPUT:
        return path.read_bytes()
    if sys.stdin is None:
        raise OSError(errno.EBADF, "standard input is closed")
    return sys.stdin.buffer.read()


def write_atomically(path: Path | str, content: bytes | str, *, overwrite: bool = False) -> None:
    """Write a file so that a reader finds the old content or the new one, never a part of it.

    The content goes to a temporary file in the same folder, which then takes the place of ``path``. Parent
    folders are made. An existing file keeps its permissions; a symbolic link stays, its target is replaced.

    A file that is there is replaced if it is empty or of the same kind as the content (``KINDS``, told by the
    first bytes); content of no known kind replaces files of no known kind. A pipe, a terminal or another
    character device, and whatever standard output is, is written to as a stream, which is not atomic.

    Args:
        path: The file to write.
        content: Bytes as they are, or text, which is written as UTF-8 with the line ends it has.
        overwrite: Replace a file of any kind.

    Raises:
        WrongTypeError: if an argument is of another type.
        FileWriteError: if ``path`` is a folder, a disk or a socket, or a file of another kind, or its folder
            cannot be made or written to. What was at ``path`` before is untouched and no temporary file is
            left behind.
        BrokenPipeError: if ``path`` is standard output, and nobody reads it any more.
    """
    path, overwrite = file_path("path", path), truth_value("overwrite", overwrite)
    require_instance("content", content, (str, bytes, bytearray, memoryview), "text or bytes")
    data = content.encode("utf-8") if isinstance(content, str) else bytes(content)
    if is_standard_output(path):
        _write_to_standard_output(data)
        return
    if not overwrite:
        check_replaceable(path, _kind(data))
    try:
        if is_stream(path):
            with path.open("wb") as stream:
                stream.write(data)
        else:
            target = _target(path)
            target.parent.mkdir(parents=True, exist_ok=True)
            _replace(target, data)
    except OSError as error:
        if isinstance(error, FileWriteError):
            raise
        raise FileWriteError(f"{path} cannot be written: {error.strerror or error}") from error


def check_replaceable(path: Path, kind: FileKind | None) -> None:
    """Check that a file of a kind (None: of no known kind) may take the place of what is there, if anything.

    Raises:
        FileWriteError: if what is there is neither empty, nor of this kind, nor a stream.
    """
    try:
        if is_stream(path) or is_standard_output(path) or not (target := _target(path)).exists():
            return
        with target.open("rb") as file:
            head = file.read(_HEAD)
    except OSError as error:
        if isinstance(error, FileWriteError):
            raise
        raise FileWriteError(f"{path} cannot be replaced: {error.strerror or error}") from error
    if head and _kind(head) is not kind:
        what = f"is no {kind.name}" if kind else "is a file of another kind"
        raise FileWriteError(
            f"{path} is there already and {what}: name another file, or replace it nevertheless (--overwrite)"
        )


def is_stream(path: Path) -> bool:
    """Say whether a path is a pipe, a terminal or another character device."""
    status = _status(path)
    return status is not None and (stat.S_ISFIFO(status.st_mode) or stat.S_ISCHR(status.st_mode))


def is_standard_output(path: Path) -> bool:
    """Say whether a path is where standard output goes, such as ``/dev/stdout``."""
    status = _status(path)
    if status is None or sys.stdout is None:
        return False
    try:
        return os.path.samestat(status, os.fstat(sys.stdout.fileno()))
    except (OSError, ValueError):  # what stands in for standard output is no file of the system
        return False


def _status(path: Path) -> os.stat_result | None:
    try:
        return os.stat(path)
    except OSError:
        return None


def _kind(head: bytes) -> FileKind | None:
    return next((kind for kind in KINDS if kind.begins.match(head[:_HEAD])), None)


def _write_to_standard_output(data: bytes) -> None:
    try:
        sys.stdout.flush()
        with open(sys.stdout.fileno(), "wb", closefd=False) as stream:
            stream.write(data)
    except BrokenPipeError:
        raise
    except OSError as error:
        raise FileWriteError(f"standard output cannot be written: {error.strerror or error}") from error


def _target(path: Path) -> Path:
    """Follow symbolic links to the file that is to be replaced, or to the place of a new one."""
    target = Path(os.path.realpath(path))
    if target.is_dir():
        raise FileWriteError(f"{path} is a folder: name a file in it to write to")
    if target.exists() and not target.is_file():
        raise FileWriteError(f"{path} is neither a file nor a stream: name a file to write to")
    return target


def _replace(target: Path, data: bytes) -> None:
    temporary = target.with_name(f".{secrets.token_hex(8)}.part")
    try:
        with temporary.open("xb") as stream:
            stream.write(data)
        if target.exists():
            shutil.copymode(target, temporary)
        os.replace(temporary, target)
    finally:
        temporary.unlink(missing_ok=True)
