"""Types of arrays by their entries; the docstring of a field or an argument gives shape and unit.

``Flags`` are truth values, ``Places`` indices of entries of another array.
"""

import math
from collections.abc import Sequence
from dataclasses import fields
from functools import cache
from typing import Any, Self

import numpy as np
from numpy.typing import NDArray

Reals = NDArray[np.float64]
Complexes = NDArray[np.complex128]
Flags = NDArray[np.bool_]
Places = NDArray[np.intp]
Integers = NDArray[np.int64]

ROUNDING = 64 * float(np.finfo(float).eps)  # Rounding of a sum as a share of the moduli of its terms


@cache
def identity(count: int) -> Reals:
    """Return the identity matrix, (n, n), which is kept, and not to be written."""
    found = np.eye(count)
    found.setflags(write=False)
    return found


def norm(vector: Reals) -> float:
    """Return the Euclidean length of a vector, (n,): for a short one sooner than ``numpy.linalg.norm``."""
    return math.sqrt(vector @ vector)


class ArrayRecord:
    """A dataclass whose fields are arrays, or such records, that hold an entry each for the same things."""

    __slots__ = ()

    def __getitem__(self, which: Any) -> Self:
        """Return the things at an index of NumPy, such as flags, places, or a tuple of slices."""
        return type(self)(*(getattr(self, each.name)[which] for each in fields(self)))  # type: ignore[arg-type]

    def __len__(self) -> int:
        return len(getattr(self, fields(self)[0].name))  # type: ignore[arg-type]

    @classmethod
    def joined(cls, groups: Sequence[Self]) -> Self:
        """Return the things of several groups, at least one, as one group."""
        columns = ([getattr(group, each.name) for group in groups] for each in fields(cls))  # type: ignore[arg-type]
        return cls(*map(_joined, columns))


def _joined(parts: list[Any]) -> Any:
    first = parts[0]
    return type(first).joined(parts) if isinstance(first, ArrayRecord) else np.concatenate(parts)
