"""Newton's method for a motion that closes after some drive periods: the exact orbit near a state."""

from __future__ import annotations

from dataclasses import dataclass
from typing import TYPE_CHECKING

import numpy as np

from trimmer.contact.advance import Ending

if TYPE_CHECKING:
    from trimmer.arrays import Complexes, Reals
    from trimmer.contact.advance import Instant
    from trimmer.contact.flow import Course, ExactFlow

ITERATIONS = 8
"""Newton's method needs three or four from where a motion nearly closes."""
CLOSED = 1e-11
"""Miss of the return, relative to the sizes of the states, that is rounding."""
ALIKE = 1e-7
"""Difference of two states, relative to their sizes, below which they are the same."""
FARTHEST = 0.1
"""Change of the state, relative to the sizes, that still leaves it near where it was."""


@dataclass(frozen=True, eq=False)
class Orbit:
    """A motion that closes.

    Attributes:
        period_count: Drive periods after which it closes, and not before.
        begin: Its instant at the start of a drive period.
        course: The motion over its period.
        states: At the start of each of its drive periods, (period_count, n).
        multipliers: Floquet multipliers, (n,).
    """

    period_count: int
    begin: Instant
    course: Course
    states: Reals
    multipliers: Complexes

    @property
    def largest(self) -> float:
        """Largest modulus of the multipliers."""
        return float(abs(self.multipliers).max())


def closed_near(
    flow: ExactFlow, instant: Instant, periods: int, sizes: Reals, farthest: float = FARTHEST
) -> Orbit | None:
    """Return the orbit near an instant that closes after some drive periods; None if there is none.

    Args:
        flow: The exact motion of the mechanism.
        instant: At the start of a drive period.
        periods: Number of drive periods.
        sizes: Sizes of the states, (n,).
        farthest: Largest change of the state, relative to the sizes.
    """
    first, best = instant.state, np.inf
    for _ in range(ITERATIONS):
        course = flow.course(instant, periods)
        if course.ending is not Ending.REACHED_END:
            return None
        miss = course.end.state - instant.state
        size = float((abs(miss) / sizes).max())
        monodromy = course.monodromy
        if size < CLOSED or (size >= 0.5 * best and size < 1e2 * CLOSED):
            return _orbit(flow, instant, periods, course, monodromy, sizes)
        best = min(best, size)
        try:
            step = np.linalg.solve(np.eye(len(miss)) - monodromy, miss)
        except np.linalg.LinAlgError:
            return None
        state = instant.state + step
        if not (abs(state - first) <= farthest * sizes).all():
            return None
        instant = flow.at(state, like=course.end)
    return None


def _orbit(
    flow: ExactFlow, begin: Instant, periods: int, course: Course, monodromy: Reals, sizes: Reals
) -> Orbit:
    """Return the orbit with the least number of drive periods that it closes after."""
    states = flow.strobe(begin, periods).states
    for fewer in range(1, periods):
        if periods % fewer == 0 and (abs(states[fewer] - states[0]) <= ALIKE * sizes).all():
            course = flow.course(begin, fewer)
            return Orbit(fewer, begin, course, states[:fewer], _multipliers(course.monodromy))
    return Orbit(periods, begin, course, states[:periods], _multipliers(monodromy))


def _multipliers(monodromy: Reals) -> Complexes:
    return np.asarray(np.linalg.eigvals(monodromy).astype(np.complex128))
