"""Results of the stages of a build, kept for as long as nothing that they depend on has changed."""

from __future__ import annotations

import io
import os
import pickle
import time
from collections.abc import Callable, Iterator
from contextlib import suppress
from dataclasses import dataclass
from pathlib import Path
from typing import Any, TypeVar

from trimmer import write_atomically
from trimmer.files import FileWriteError

Result = TypeVar("Result")
UNREADABLE = (OSError, pickle.UnpicklingError, EOFError, AttributeError, ImportError, ValueError, TypeError)
"""What reading a file of another version, or half a file, can raise."""
DAY = 86400.0
"""Seconds of a day."""


@dataclass(frozen=True)
class Bounds:
    """How much is kept.

    Attributes:
        days: Days after which goes what was not used.
        size: Bytes beyond which goes what was not used for longest.
        grace: Days for which all that was used stays, as another run may be at it.
    """

    days: float = 30.0
    size: int = 500_000_000
    grace: float = 1.0


BOUNDS = Bounds()


@dataclass(frozen=True)
class StageStore:
    """A folder with one file per stage, each with the key under which its result was made.

    Attributes:
        folder: Where the files are.
    """

    folder: Path

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
        """Return what was kept for a stage under a key, or None if there is nothing or it cannot be read."""
        try:
            kept, result = pickle.loads(self._file(stage).read_bytes())
        except UNREADABLE:
            return None
        if kept != key:
            return None
        with suppress(OSError):  # another run may have put a newer one in its place, or the folder is locked
            os.utime(self._file(stage))
        return result

    def keep(self, stage: str, key: str, result: object) -> None:
        """Keep a result, which must not be None, in place of the last one.

        Raises:
            FileWriteError: if it cannot be written.
        """
        content = io.BytesIO()
        _Pickler(content, protocol=pickle.HIGHEST_PROTOCOL).dump((key, result))
        write_atomically(self._file(stage), content.getvalue())

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
        used = sorted(_last_used(self.folder.glob("*.pickle")), reverse=True)
        total = 0
        for when, size, path in [*used, *_last_used(self.folder.glob(".*.part"))]:
            age = (now - when) / DAY
            total += size
            is_spare = path.suffix == ".part" or age > bounds.days or total > bounds.size
            if age > bounds.grace and is_spare:
                with suppress(OSError):
                    path.unlink()

    def _file(self, stage: str) -> Path:
        return self.folder / f"{stage}.pickle"


def _last_used(paths: Iterator[Path]) -> Iterator[tuple[float, int, Path]]:
    """Yield when each file was last used, its size in bytes, and its place; one that is gone is left out."""
    for path in paths:
        with suppress(OSError):
            status = path.stat()
            yield status.st_mtime, status.st_size, path


class _Pickler(pickle.Pickler):
    """Pickles two things that Python does not keep as they are.

    A state-space model of python-control holds a function that cannot be pickled. A sum or product of SymPy
    that stands in an order of its own would be put in SymPy's when it is read again.
    """

    def reducer_override(self, value: Any) -> Any:
        import control  # Whatever is kept was computed with these two, so they are loaded already.
        import sympy

        if isinstance(value, sympy.Add | sympy.Mul):
            return _in_order, (type(value), value.args)
        if not isinstance(value, control.StateSpace):
            return NotImplemented
        matrices = (value.A, value.B, value.C, value.D)
        labels = (value.name, value.state_labels, value.input_labels, value.output_labels)
        return _state_space, (*matrices, value.dt, *labels)


def _in_order(kind: Any, terms: tuple[Any, ...]) -> Any:
    """Build a sum or product again, with its terms in the order in which they stood."""
    return kind(*terms, evaluate=False)


def _state_space(A: Any, B: Any, C: Any, D: Any, dt: Any, name: str, *labels: list[str]) -> Any:
    """Build a state-space model again."""
    import control

    states, inputs, outputs = labels
    return control.StateSpace(A, B, C, D, dt, name=name, states=states, inputs=inputs, outputs=outputs)
