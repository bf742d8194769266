"""What takes long to make and is the same for all tests of a run, made by the first process that needs it."""

from __future__ import annotations

import fcntl
import hashlib
import io
import os
import pickle
import platform
import shutil
from collections.abc import Callable, Iterable
from dataclasses import dataclass
from functools import partial
from pathlib import Path
from typing import Any, TypeVar

import pytest
import sympy
from sympy.core.function import AppliedUndef

from report.cache.content_key import content_key
from report.folders import templates
from scripts.kernels.processor import CHOOSING, processor_flags

Made = TypeVar("Made")
MOST_KEPT = 4  # States of the sources whose things are kept


@dataclass(frozen=True)
class MadeOnce:
    """A folder that the processes of one run share; a run without workers shares nothing."""

    folder: Path | None  # Where things are kept for the other processes, None if there are none
    # Where things are kept for later runs too, until a source, a library or the processor changes
    lasting: Path | None

    @classmethod
    def of_this_run(cls, temporary: pytest.TempPathFactory, config: pytest.Config) -> MadeOnce:
        """Return the folder of this run, which no other run sees, and that of runs of the same sources."""
        if "PYTEST_XDIST_WORKER" not in os.environ:
            return cls(None, None)
        folder, cache = temporary.getbasetemp().parent, getattr(config, "cache", None)
        return cls(folder, _lasting(cache.mkdir("made_once")) if cache else folder)

    def of_sources(self, name: str, make: Callable[[], Made], *tests: str) -> Made:
        """Return what depends on nothing but sources, and files of tests: as ``get`` does, but lasting."""
        return MadeOnce(self.lasting, None).get(f"{name}-{_digest(map(Path, tests))[:16]}", make)

    def get(self, name: str, make: Callable[[], Made]) -> Made:
        """Return what another process has made under a name, or make it; who comes meanwhile waits."""
        if self.folder is None:
            return make()
        kept = self.folder / f"{name}.pickle"
        with (self.folder / f"{name}.lock").open("w") as lock:
            fcntl.flock(lock, fcntl.LOCK_EX)
            if not kept.exists():
                begun = kept.with_suffix(".begun")
                begun.write_bytes(_pickled(make()))
                begun.replace(kept)
        made: Made = pickle.loads(kept.read_bytes())
        return made


def _digest(files: Iterable[Path]) -> str:
    return hashlib.sha256(b"\0".join(each.read_bytes() for each in files)).hexdigest()


def _lasting(folder: Path) -> Path:
    """Return the folder of these sources, templates, libraries and kernels; those not used for longest go."""
    chosen = sorted(each for each in os.environ.items() if each[0].startswith(CHOOSING))
    rests_on = (
        content_key(),
        platform.platform(),
        sorted(processor_flags()),
        chosen,
        Path(__file__).read_text(),
        _digest(each for each in sorted(templates().rglob("*")) if each.is_file()),
    )
    mine = folder / hashlib.sha256(repr(rests_on).encode()).hexdigest()
    mine.mkdir(exist_ok=True)
    os.utime(mine)
    for old in sorted(folder.iterdir(), key=lambda each: each.stat().st_mtime)[:-MOST_KEPT]:
        shutil.rmtree(old, ignore_errors=True)
    return mine


class _AsItStands(pickle.Pickler):
    """Keeps the terms of a sum as they stand; SymPy's own pickling would evaluate and order them."""

    def reducer_override(self, value: object) -> Any:
        unevaluated = sympy.Add | sympy.Mul | sympy.Pow | sympy.Function | sympy.core.relational.Relational
        if isinstance(value, unevaluated) and not isinstance(value, AppliedUndef):
            return partial(type(value), evaluate=False), value.args
        return NotImplemented


def _pickled(made: object) -> bytes:
    _AsItStands(file := io.BytesIO()).dump(made)
    return file.getvalue()
