"""An order that does not turn on rounding: numbers that agree are of one level, and others decide."""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np

from trimmer.arrays import Integers, Reals

CLOSE = 1e-9
"""Share of two neighbouring numbers by which those of one level may differ."""


def levels(values: Reals | Sequence[float], close: float = CLOSE) -> Integers:
    """Return levels, (n,), from 0 for the smallest on; neighbours that agree, relatively, have the same."""
    given = np.asarray(values, dtype=float)
    order = np.argsort(given, kind="stable")
    rising = given[order]
    apart = np.diff(rising) > close * np.maximum(abs(rising[1:]), abs(rising[:-1]))
    found = np.zeros(given.size, dtype=np.int64)
    found[order[1:]] = np.cumsum(apart)
    return found
