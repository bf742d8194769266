"""An order that does not turn on rounding: numbers that agree are of one level, and others decide."""

from collections.abc import Sequence

import numpy as np

from trimmer.arrays import Integers, Reals

CLOSE = 1e-9  # Share of two neighbouring numbers by which those of one level may differ


MOST_TURNS = 64  # Periods after which all that turns must have returned; else nothing repeats with it
OF_A_TURN = 1e-9  # Share of a turn by which a phase may miss its return


def common_return(ratios: Sequence[float]) -> tuple[int, tuple[int, ...]] | None:
    """Return after how many periods turns at ratios of their frequency are whole; None if never."""
    for periods in range(1, MOST_TURNS + 1):
        turns = tuple(round(periods * ratio) for ratio in ratios)
        if all(turns) and all(
            abs(periods * ratio - turn) <= OF_A_TURN for ratio, turn in zip(ratios, turns, strict=True)
        ):
            return periods, turns
    return None


def levels(values: Reals | Sequence[float]) -> Integers:
    """Return levels, (n,), from 0 for the smallest on; neighbours that agree, relatively, have the same."""
    given = np.asarray(values, dtype=float)
    order = np.argsort(given, kind="stable")
    rising = given[order]
    apart = np.diff(rising) > CLOSE * np.maximum(abs(rising[1:]), abs(rising[:-1]))
    found = np.zeros(given.size, dtype=np.int64)
    found[order[1:]] = np.cumsum(apart)
    return found
