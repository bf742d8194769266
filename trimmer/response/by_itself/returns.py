"""How often a motion without a drive comes again to its most frequent event, and how distances grow then.

Without a drive nothing counts periods. So the mean time between two such events stands for one, and the
growth of a small distance is taken along the motion that is known, from amid one segment to amid another.
"""

from __future__ import annotations

from dataclasses import dataclass
from functools import cached_property

import numpy as np

from trimmer.arrays import Integers, Reals
from trimmer.hybrid.stretch import Ending
from trimmer.hybrid.variation import propagated
from trimmer.motion.course import Course
from trimmer.motion.flow import Flow
from trimmer.response.by_itself.arrival import what_happened
from trimmer.response.periodic.shooting import sizes_of
from trimmer.response.statistics.estimate import Estimate, mean_of

MEASURED = 512  # Returns over which the growth of distances is measured
TOGETHER = 4  # Returns between two measurements
TURNING = 16  # Measurements after which a distance points in the direction that grows most
LEAST = 64  # Returns with which it is measured at all
ERRORS = 3.0  # Standard errors by which the exponent of chaos is positive
GROWN = 1e3  # Growth of a distance, at least, in chaos
SMALLEST = 1e-16  # Growth of a distance below which it counts as lost
APART = 1e-9  # Distance of the neighbour at first, as a share of the sizes of the states
SEED = 3  # Of the direction of distances


@dataclass(frozen=True, eq=False)
class Returns:
    """The returns of a motion to its most frequent event."""

    flow: Flow  # What moves
    course: Course  # The motion
    rows: Integers  # Rows of the log at which the event happened, (count + 1,)

    @classmethod
    def of(cls, flow: Flow, course: Course) -> Returns:
        """Return the returns of a motion."""
        log = course.log
        happened = np.flatnonzero(what_happened(log) & np.append(np.diff(log.start) > 0, False))
        kinds = np.stack([log.mode[happened], log.part[happened], log.kind[happened]])
        if not len(happened):
            return cls(flow, course, happened)
        _, which, counts = np.unique(kinds, axis=1, return_inverse=True, return_counts=True)
        return cls(flow, course, happened[which.ravel() == np.argmax(counts)])

    @property
    def count(self) -> int:
        """How often it returned."""
        return max(len(self.rows) - 1, 0)

    @property
    def mean(self) -> float:
        """Mean time of a return, s."""
        times = self.course.log.start[self.rows]
        return float(times[-1] - times[0]) / self.count

    def seen(self, most: int) -> float:
        """Return how long the motion lasts, s, or so many of its returns if it has more."""
        return self.course.duration if self.count <= most else most * self.mean

    @cached_property
    def exponent(self) -> Estimate | None:
        """Largest Lyapunov exponent per s over the last returns; None if there are too few."""
        if self.count < LEAST:
            return None
        times = self._amid(self.rows[-1 - MEASURED :: TOGETHER])
        growth = _growth(self.flow, self.course, times)[TURNING if len(times) > 3 * TURNING else 0 :]
        found = mean_of(growth)
        unit = TOGETHER * self.mean
        return Estimate(found.value / unit, found.uncertainty / unit)

    @cached_property
    def chaotic(self) -> bool:
        """Whether distances grow as in chaos, and a neighbour leaves too; never of what only loses energy."""
        if self.exponent is None or self.flow.only_loses_energy:
            return False
        seen = min(self.count, MEASURED) * self.mean
        surely = self.exponent.value - ERRORS * self.exponent.uncertainty > 0
        return surely and self.exponent.value * seen > np.log(GROWN) and self._neighbour_leaves()

    def _amid(self, rows: Integers) -> Reals:
        """Return the middles of segments, s, where nothing happens."""
        start = self.course.log.start
        return np.asarray(0.5 * (start[rows] + start[rows + 1]))

    def _neighbour_leaves(self) -> bool:
        """Say whether a motion beside it is far from it, or meets other events, over the same returns."""
        (begin,) = self._amid(self.rows[-1 - MEASURED :][:1])
        log, sizes = self.course.log, sizes_of(self.course)
        instant = self.course.instant(float(begin))
        direction = np.random.default_rng(SEED).normal(size=self.flow.size)
        state = instant.state + APART * sizes * direction / np.linalg.norm(direction)
        beside = self.flow.timed(self.flow.at(state, like=instant), self.course.duration - begin)
        if beside.ending is not Ending.REACHED_END:
            return False
        ours, theirs = np.flatnonzero(what_happened(log) & (log.start > begin)), beside.log
        others = np.flatnonzero(what_happened(theirs))
        count = min(len(ours), len(others))
        ours, others = ours[:count], others[:count]
        alike = (log.part[ours] == theirs.part[others]) & (log.kind[ours] == theirs.kind[others])
        if not alike.all():
            return True
        apart = self.flow.reduced(log.state[ours][:, : len(sizes)] - theirs.state[others][:, : len(sizes)])
        return bool((abs(apart) / sizes).max(initial=0.0) > GROWN * APART)


def _growth(flow: Flow, course: Course, times: Reals) -> Reals:
    """Return the logarithms of the growth of a distance between times, s, at which nothing happens."""
    sizes, log = sizes_of(course), course.log
    distance = np.random.default_rng(SEED).normal(size=flow.size)
    rows, states = course.at(times)
    found = []
    for place in range(len(times) - 1):
        first, last = int(rows[place]), int(rows[place + 1]) + 1
        part = type(log)._make(each[first:last].copy() for each in log)
        part.start[0], part.state[0], part.function[0] = times[place], states[place], -1
        distance = flow.reduced(distance)
        moved = propagated(course.modes, part, float(times[place + 1]), (sizes * distance)[:, None])[:, 0]
        distance = moved / sizes
        size = max(float(np.linalg.norm(distance)), SMALLEST)
        found.append(np.log(size))
        distance = distance / size
    return np.array(found)
