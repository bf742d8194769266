"""Where stick is torn out only just: an end of a branch that Newton's method comes near to, and not to.

As the force that holds touches its static limit ever more flatly, the rate at which it does falls in
proportion to the distance to the end, and the largest multiplier grows without bound. Beyond the end it does
not reach the limit at all: the stick goes on, and the motion jumps. So the end is extrapolated from rates.
"""

from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np

from trimmer.branches.followed import FollowedOrbit
from trimmer.branches.special import SpecialKind, SpecialPoint
from trimmer.hybrid.system import HOLD_ENDED
from trimmer.hybrid.variation import jumps

FALLEN = (2.0, 4.0)
"""Factors by which a rate has fallen since the orbits from which it is extrapolated, at least."""
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
    for part, rate in _rates(last).items():
        passed = [(last.value, rate)]
        for each in reversed(points[:-1]):
            if each.point.signature != last.point.signature or len(passed) > len(FALLEN):
                break
            value, before = each.value, _rates(each).get(part, 0.0)
            if before >= FALLEN[len(passed) - 1] * rate:
                passed.append((value, before))
        if len(passed) <= len(FALLEN):
            continue
        end, other = (_zero(passed[0], each) for each in passed[1:])
        ahead = (end - last.value) * np.sign(last.value - passed[1][0])
        if 0.0 < abs(end - other) <= SURE * ahead:
            return TornOut(part, end, abs(end - other), last)
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


def _zero(last: tuple[float, float], before: tuple[float, float]) -> float:
    """Return the value at which a line through two values with their rates is zero."""
    (value, rate), (earlier, larger) = last, before
    return value + rate * (value - earlier) / (larger - rate)
