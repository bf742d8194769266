"""What is known of other branches while one is followed, so that none is followed twice."""

from dataclasses import dataclass, field

import numpy as np

from trimmer.branches.bifurcations import Bifurcation
from trimmer.branches.branch import BranchEnd, BranchPoint
from trimmer.branches.orbit import Problem
from trimmer.branches.period_maps.driven_map import DrivenMap
from trimmer.one_orbit import SAME, same_states

FARTHEST = 0.1  # Distance in all coordinates within which a branch that has joined another may have done so


@dataclass
class Known:
    """What is known of the branches so far."""

    lowest: int  # How often the passage was doubled at least on a branch that is followed
    # Orbits at the ends of the interval, with how often their passage was doubled
    ends: list[tuple[int, BranchPoint]] = field(default_factory=list)
    # The last orbits of branches that joined another, with the same
    rejoined: list[tuple[int, BranchPoint]] = field(default_factory=list)

    def is_joined(self, problem: Problem, bifurcation: Bifurcation, largest_step: float) -> bool:
        """Say whether a branch that has been followed ends at a bifurcation of another.

        Args:
            problem: The orbits of the other branch.
            bifurcation: The bifurcation on it.
            largest_step: Largest distance of the value, relative to the span.
        """
        doublings = problem.map.doublings + 1
        value = problem.value(bifurcation.place.position)
        for known, point in self.rejoined:
            if known != doublings or abs(value - point.value) > largest_step * problem.span:
                continue
            for phase in problem.map.phases(point.value, point.state):
                away = abs(problem.position(point.value, phase) - bifurcation.place.position)
                if away.max() <= FARTHEST:
                    return True
        return False

    def holds(self, problem: Problem, end: BranchPoint) -> bool:
        """Say whether a branch ends with an orbit at which another one that is known begins or ends.

        Only one branch passes a regular orbit, so that both are the same. So are mirror images, and orbits
        that are some drive periods apart.

        Args:
            problem: The orbits of the branch.
            end: Its last orbit.
        """
        images = [problem.position(end.value, state) for state in _images(problem.map, end)]
        known = [
            problem.position(point.value, state)
            for doublings, point in self.ends
            if doublings == problem.map.doublings and abs(point.value - end.value) <= SAME * problem.span
            for state in problem.map.phases(point.value, point.state)
        ]
        pairs = ((image[None], each[None]) for image in images for each in known)
        return any(same_states(*pair, np.full(pair[0].shape[1], SAME)) for pair in pairs)

    def add(self, doublings: int, first: BranchPoint | None, last: BranchPoint, reason: BranchEnd) -> None:
        """Add what was followed of a branch.

        Args:
            doublings: How often its passage was doubled.
            first: Its first orbit; None if that is not at an end of the interval.
            last: Its last orbit.
            reason: Why it ends.
        """
        if reason.is_success and first is not None:
            self.ends.append((doublings, first))
        if reason in (BranchEnd.LEFT_AT_START, BranchEnd.LEFT_AT_STOP):
            self.ends.append((doublings, last))
        if reason is BranchEnd.REJOINED:
            self.rejoined.append((doublings, last))


def _images(map: DrivenMap, point: BranchPoint) -> list[np.ndarray]:
    """Return the states that an orbit passes after each passage of the map that was not doubled."""
    single, count = map, 1
    while single.single is not None:
        single, count = single.single, 2 * count
    states = map.phases(point.value, point.state) or [point.state]
    while len(states) < count:
        states.append(single.passage(point.value, states[-1]).end)
    return states
