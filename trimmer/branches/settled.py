"""Where a branch begins: what the mechanism settles to from rest, as the start of Newton's method."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

from trimmer.arrays import Reals
from trimmer.contact.advance import Ending
from trimmer.contact.flow import ExactFlow
from trimmer.mechanism.mechanism import Mechanism

BATCH = 100
"""Drive periods after which it is looked whether the motion repeats."""
MOST_PERIOD_COUNT = 24
"""Largest number of drive periods after which a motion is taken to repeat."""
SETTLED = 1e-8
"""Difference of repeating states, relative to their sizes, at which the motion has settled."""
SAME = 1e-4
"""The same within which states are taken as those of one motion that settles."""
NEARLY = 1e-2
"""The same for a motion that is still settling, from which Newton's method may go on."""


@dataclass(frozen=True, eq=False)
class Settled:
    """A motion that repeats, or nearly so.

    Attributes:
        state: State at the start of a drive period, shape (n,).
        periods: Drive periods after which it repeats.
        miss: Difference of the states then, relative to their sizes.
        waited: Drive periods from rest until then.
    """

    state: Reals
    periods: int
    miss: float
    waited: int


def settled(mechanism: Mechanism, most_periods: int, periods: int | None = None) -> Settled | None:
    """Follow the motion from rest until it repeats.

    Args:
        mechanism: The mechanism; it has a frequency.
        most_periods: Drive periods after which not to wait any more.
        periods: Drive periods after which it shall repeat; None for whatever it does.

    Returns:
        The motion that repeats best so far; None if none nearly repeats, or the motion cannot be followed.
    """
    flow = ExactFlow(mechanism)
    instant, waited = flow.rest(), 0
    best = None
    while waited < most_periods:
        strobe = flow.strobe(instant, BATCH)
        if strobe.ending is not Ending.REACHED_END:
            return None
        instant, waited = strobe.end, waited + BATCH
        best = _repeated(strobe.states, periods, waited)
        if best.miss <= SETTLED:
            break
    return best if best is not None and best.miss <= (NEARLY if periods is None else np.inf) else None


def _repeated(states: Reals, periods: int | None, waited: int) -> Settled:
    """Return the motion at the end of a sequence with the least number of periods that will do."""
    sizes = abs(states).max(axis=0)
    sizes = np.where(sizes > 0.0, sizes, 1.0)
    if periods is not None:
        misses = abs((states[periods:] - states[:-periods]) / sizes).max(axis=1)
        at = int(np.argmin(misses))
        return Settled(states[periods + at], periods, float(misses[at]), waited)
    misses = {
        count: float(abs((states[-1] - states[-1 - count]) / sizes).max())
        for count in range(1, MOST_PERIOD_COUNT + 1)
    }
    least = min(misses.values())
    # A motion that still settles may come closer to itself after several of its periods.
    count = next(count for count, miss in misses.items() if miss <= max(SAME, least))
    return Settled(states[-1], count, least, waited)
