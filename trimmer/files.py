"""Atomic writes of files: whole or not at all."""

from __future__ import annotations

import os
import secrets
import shutil
from pathlib import Path

from trimmer.errors import TrimmerError


class FileWriteError(TrimmerError, OSError):
    """A file could not be written; the message says which one and why."""


def write_atomically(path: Path, content: bytes | str) -> None:
    """Write a file in one atomic step, so that a reader finds the old content or the new one, never a part.

    The content goes to a temporary file in the same folder, which then takes the place of ``path``. Parent
    folders are made. An existing file keeps its permissions; a symbolic link stays, its target is replaced.

    Args:
        path: The file to write.
        content: Bytes as they are, or text, which is written as UTF-8 with the line ends it has.

    Raises:
        FileWriteError: if ``path`` is a folder, or its folder cannot be made or written to. What was at
            ``path`` before is untouched and no temporary file is left behind.
    """
    data = content.encode("utf-8") if isinstance(content, str) else content
    target = Path(os.path.realpath(path))
    if target.is_dir():
        raise FileWriteError(f"{path} is a folder: name a file in it to write to")
    try:
        target.parent.mkdir(parents=True, exist_ok=True)
        _replace(target, data)
    except OSError as error:
        raise FileWriteError(f"{path} cannot be written: {error.strerror or error}") from error


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
