"""Treatment of missing values: refused, interpolated, or taken as gaps."""

from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np

from trimmer.arrays import Places, Reals
from trimmer.choices import Choice
from trimmer.signals.text_file import SignalFileError

LARGEST_SHARE = 0.1  # Largest share of samples that may be interpolated


class MissingValues(Choice):
    """What is done about missing values.

    ``REFUSE``: they are an error. ``INTERPOLATE``: those at the beginning and the end are cut off, those
    between others are interpolated along a straight line. ``GAP``: the record has gaps there.
    """

    REFUSE = "refuse"
    INTERPOLATE = "interpolate"
    GAP = "gap"


@dataclass(frozen=True)
class Filled:
    """Samples without missing values, finite, and their places in the column, from 0, (m,)."""

    values: Reals
    places: Places
    interpolated: int = 0

    @property
    def has_gaps(self) -> bool:
        """Whether places are left out between others."""
        return int(self.places[-1] - self.places[0]) >= self.places.size


def fill(values: Reals, lines: Sequence[int], missing: MissingValues, place: str) -> Filled:
    """Cut off or interpolate the missing values (NaN) of a column, (n,), as far as that is allowed."""
    present = np.flatnonzero(~np.isnan(values))
    absent = np.flatnonzero(np.isnan(values))
    if present.size == 0:
        raise SignalFileError(f"{place}: every value of the column is missing")
    if absent.size == 0:
        return Filled(values, present)
    if missing is MissingValues.GAP:
        return Filled(values[present], present)
    problem = f"{place}, line {lines[int(absent[0])]}: {_count(absent.size)}"
    if missing is MissingValues.REFUSE:
        raise SignalFileError(
            f"{problem}; remove lines at the beginning or end, or have values between others interpolated "
            "(--missing interpolate) or taken as gaps (--missing gap)"
        )
    begin, end = int(present[0]), int(present[-1]) + 1
    inside = np.arange(begin, end)
    interpolated = inside.size - present.size
    if interpolated > LARGEST_SHARE * inside.size:
        raise SignalFileError(
            f"{problem}, more than {100 * LARGEST_SHARE:g} % of the samples, too many to interpolate"
        )
    return Filled(np.interp(inside, present, values[present]), inside, interpolated)


def _count(missing: int) -> str:
    return "a value is missing" if missing == 1 else f"the first of {missing} missing values"
