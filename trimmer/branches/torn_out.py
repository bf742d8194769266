"""Where stick is torn out only just: an end of a branch that Newton's method comes near to, and not to.

As the force that holds touches its static limit ever more flatly, the rate at which it does falls in
proportion to the distance to the end, and the largest multiplier grows without bound. Beyond the end it does
not reach the limit at all: the stick goes on, and the motion jumps. So the end is extrapolated from rates.
"""

from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np

from trimmer.branches.endless_period import at_zero
from trimmer.branches.followed import FollowedOrbit
from trimmer.branches.special import SpecialKind, SpecialPoint
from trimmer.hybrid.system import HOLD_ENDED
from trimmer.hybrid.variation import jumps

RISEN = (0.0, 1.5, 3.0, 6.0)
"""Factors by which the rates of earlier orbits are larger than the first, from which it is extrapolated."""
MOST = 1e6  # Largest multiplier of such an orbit: what is rounded is magnified by it
SURE = 0.1  # Largest difference of extrapolations as a share of the distance over which they go


@dataclass(frozen=True)
class TornOut:
    """Where the static force of a friction is only just reached.

    Attributes:
        part: Name of the friction.
        value: Value of the number that is varied.
        uncertainty: By how much extrapolations from different orbits differ.
        last: The last orbit before it.
    """

    part: str
    value: float
    uncertainty: float
    last: FollowedOrbit

    @property
    def special(self) -> SpecialPoint:
        """The last orbit before it as a special point."""
        note = f"no orbit lies beyond {self.value:.9g}"
        return SpecialPoint(SpecialKind.STICK, self.last.value, self.last.state, (self.part,), note)

    @property
    def told(self) -> str:
        """It in words."""
        return (
            f"{self.part} is torn out of stick only just, and beyond not at all: the motion jumps. The "
            f"rate at which its force reaches the limit falls to zero at {self.value:.9g} +- "
            f"{self.uncertainty:.1g}, to which it was extrapolated"
        )


def torn_out(points: Sequence[FollowedOrbit]) -> TornOut | None:
    """Return where stick is torn out only just beyond the last orbits; None if it is not, or not surely.

    Args:
        points: The orbits, in the order of the branch.
    """
    last = points[-1]
    for part in _rates(last):
        passed: list[tuple[float, float]] = []
        for each in reversed(points):
            if each.point.signature != last.point.signature or len(passed) == len(RISEN):
                break
            rate = 0.0 if each.largest_multiplier > MOST else _rates(each).get(part, 0.0)
            if rate > 0.0 and rate >= RISEN[len(passed)] * (passed[0][1] if passed else 0.0):
                passed.append((each.value, rate))
        if len(passed) < len(RISEN):
            continue
        values, rates = np.array(passed).T
        ends = [at_zero(rates[some], values[some]) for some in (slice(4), slice(3), slice(1, 4))]
        end, spread = ends[0], float(np.ptp(ends))
        ahead = (end - values[0]) * np.sign(values[0] - values[1])
        if 0.0 < spread <= SURE * ahead:
            return TornOut(part, end, spread, last)
    return None


def _rates(orbit: FollowedOrbit) -> dict[str, float]:
    """Return the least rate at which each friction is torn out of stick during an orbit."""
    course, found = orbit.passage.course, dict[str, float]()
    names = [each.name for each in orbit.passage.flow.parts]
    for row in np.flatnonzero(course.log.kind == HOLD_ENDED).tolist():
        for jump in jumps(course.modes, course.log, row, row):
            if jump.function.owner >= 0:
                name = names[jump.function.owner]
                found[name] = min(found.get(name, np.inf), -jump.slope)
    return found
