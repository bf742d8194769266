"""What takes long to make and is the same for all tests of a run, made by the first process that needs it."""

from __future__ import annotations

import fcntl
import io
import os
import pickle
from collections.abc import Callable
from dataclasses import dataclass
from functools import partial
from pathlib import Path
from typing import Any, TypeVar

import pytest
import sympy
from sympy.core.function import AppliedUndef

Made = TypeVar("Made")


@dataclass(frozen=True)
class MadeOnce:
    """A folder that the processes of one run share; a run without workers shares nothing.

    Attributes:
        folder: Where things are kept for the other processes, None if there are none.
    """

    folder: Path | None

    @classmethod
    def of_this_run(cls, temporary: pytest.TempPathFactory) -> MadeOnce:
        """Return the folder of this run, which no other run sees."""
        alone = "PYTEST_XDIST_WORKER" not in os.environ
        return cls(None if alone else temporary.getbasetemp().parent)

    def get(self, name: str, make: Callable[[], Made]) -> Made:
        """Return what another process has made under a name, or make it; who comes meanwhile waits."""
        if self.folder is None:
            return make()
        kept = self.folder / f"{name}.pickle"
        with (self.folder / f"{name}.lock").open("w") as lock:
            fcntl.flock(lock, fcntl.LOCK_EX)
            if not kept.exists():
                kept.write_bytes(_pickled(make()))
        made: Made = pickle.loads(kept.read_bytes())
        return made


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
