"""Results of the stages of a build, kept for as long as nothing that they depend on has changed."""

import os
import time
from collections.abc import Callable, Iterator
from contextlib import suppress
from dataclasses import dataclass
from pathlib import Path
from typing import Any, TypeVar

from report.cache.data_format import DamagedError, from_bytes, to_bytes
from trimmer.command_line.parser import note
from trimmer.files import FileWriteError, write_atomically

Result = TypeVar("Result")
SUFFIX = ".data"
SUFFIXES = (SUFFIX, ".pickle")
"""Ends of kept files; those of earlier versions are never read, and go as the others do."""
DAY = 86400.0  # Seconds of a day


@dataclass(frozen=True)
class Bounds:
    """How much is kept."""

    days: float = 30.0  # Days after which goes what was not used
    size: int = 500_000_000  # Bytes beyond which goes what was not used for longest
    grace: float = 1.0  # Days for which all that was used stays, as another run may be at it


BOUNDS = Bounds()


@dataclass(frozen=True)
class StageStore:
    """A folder with one file per stage, each with the key under which its result was made."""

    folder: Path  # Where the files are

    def prepare(self) -> None:
        """Make the folder, so that it is told before any work if nothing can be kept.

        Raises:
            FileWriteError: if it cannot be made or written to.
        """
        try:
            self.folder.mkdir(parents=True, exist_ok=True)
        except OSError as error:
            raise FileWriteError(
                f"{self.folder} cannot be made: {error.strerror}; name another folder"
            ) from error
        if not os.access(self.folder, os.W_OK):
            raise FileWriteError(f"{self.folder} cannot be written to; name another folder")

    def load(self, stage: str, key: str) -> Any | None:
        """Return what was kept for a stage under a key, or None if there is nothing or it cannot be read.

        A file that is there and was damaged is told of.
        """
        try:
            under, _, content = self._file(stage).read_bytes().partition(b"\n")
        except OSError:
            return None
        if under != key.encode():
            return None
        try:
            result = from_bytes(content)
        except DamagedError:
            note(f"{self._file(stage)} is damaged; what it held is computed again")
            return None
        with suppress(OSError):  # another run may have put a newer one in its place, or the folder is locked
            os.utime(self._file(stage))
        return result

    def keep(self, stage: str, key: str, result: object) -> None:
        """Keep a result, which must not be None, in place of the last one.

        Raises:
            FileWriteError: if it cannot be written.
            TypeError: if a part of it is no data; see ``data_format``.
        """
        write_atomically(self._file(stage), key.encode() + b"\n" + to_bytes(result))

    def made(self, stage: str, key: str, make: Callable[[], Result]) -> Result:
        """Return what was kept under the key, or make it and keep it."""
        kept = self.load(stage, key)
        if kept is None:
            kept = make()
            self.keep(stage, key, kept)
        made: Result = kept
        return made

    def clear_old(self, bounds: Bounds = BOUNDS) -> None:
        """Delete what was not used for long, and the remains of killed runs; a file that cannot be stays."""
        now = time.time()
        kept = (path for suffix in SUFFIXES for path in self.folder.glob(f"*{suffix}"))
        used = sorted(_last_used(kept), reverse=True)
        total = 0
        for when, size, path in [*used, *_last_used(self.folder.glob(".*.part"))]:
            age = (now - when) / DAY
            total += size
            is_spare = path.suffix == ".part" or age > bounds.days or total > bounds.size
            if age > bounds.grace and is_spare:
                with suppress(OSError):
                    path.unlink()

    def _file(self, stage: str) -> Path:
        return self.folder / f"{stage}{SUFFIX}"


def _last_used(paths: Iterator[Path]) -> Iterator[tuple[float, int, Path]]:
    """Yield when each file was last used, its size in bytes, and its place; one that is gone is left out."""
    for path in paths:
        with suppress(OSError):
            status = path.stat()
            yield status.st_mtime, status.st_size, path
