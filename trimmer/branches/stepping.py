"""Stepping along a branch: how long each step is, and why no further one is made."""

from collections.abc import Iterator
from dataclasses import dataclass, replace

import numpy as np

from trimmer.arrays import Reals, norm
from trimmer.branches.branch import NEUTRAL, BranchEnd
from trimmer.branches.corner import torn, turned
from trimmer.branches.null_vector import null_vector
from trimmer.branches.orbit import Place, Problem
from trimmer.branches.settings import FollowSettings
from trimmer.branches.step import BranchStep, Front, begun, step
from trimmer.one_orbit import SAME

FIRST = 1e-3  # Length of the first step
SMALLEST = 2e-12  # Length below which a step is not shortened any more
LARGEST_MOVE = 0.1  # Largest length of a step in all coordinates
BEND = 0.15  # Angle between the tangents before and after a step, rad, at which its length is right
LENGTHENED = 2.0  # Most by which a step is longer than the one before
AFTER_CORNER = 1e-3  # Length of the step after a corner
LEAST_SIZE = 1e-2  # Least scale of a state, relative to the largest that it had on the branch
NEAR = 0.1  # Distance of an orbit from the chord of two, as a share of it, within which a branch may pass it
AT_END = 1e-12  # Distance from an end of the interval, as a share of it, within which a value is that end


@dataclass(frozen=True)
class Interval:
    """The values over which a branch is followed."""

    start: float  # Where it begins
    stop: float  # The other end

    @property
    def span(self) -> float:
        """Length."""
        return abs(self.stop - self.start)

    def holds(self, value: float) -> bool:
        """Say whether a value lies inside, and not exactly at an end, such as a gap of 0."""
        return min(abs(value - self.start), abs(value - self.stop)) > AT_END * self.span

    @property
    def ends(self) -> tuple[float, float]:
        """Start and stop, relative to the length."""
        return self.start / self.span, self.stop / self.span


@dataclass(frozen=True)
class Limits:
    """The interval of a branch, and how it is followed."""

    interval: Interval  # The values
    settings: FollowSettings  # How it is followed
    smooth: bool = True  # Whether bifurcations are looked for too, and not only where phases change


def steps(front: Front, limits: Limits, count: int) -> Iterator[tuple[BranchStep, Problem] | BranchEnd]:
    """Yield one step after the other, with the problem in whose scale it was made, and why they end.

    What joins another branch ends with a step that says so. ``count`` orbits are known at the beginning.
    """
    first, length, largest = front, FIRST, np.zeros(front.problem.map.size)
    for taken in range(limits.settings.most_points - count):
        front, largest = _rescaled(front, largest)
        made, length = longest_step(front, length, limits)
        if made is None:
            yield _obstacle(front)
            return
        if made.front.place.passage.is_linear:
            yield replace(made, special=(), switches=()), front.problem
            yield BranchEnd.HOPF
            return
        yield made, front.problem
        if taken and _closed(first, front, made.front):
            yield BranchEnd.CLOSED
            return
        if made.ended is not None:
            yield made.ended
            return
        front = made.front


def _obstacle(front: Front) -> BranchEnd:
    """Say why no orbit was found beyond a front."""
    if front.place.passage.grazed:
        return BranchEnd.GRAZED
    if torn(front) is not None:
        return BranchEnd.TORN
    neutral = abs(front.place.multipliers - 1.0).min() < NEUTRAL
    return BranchEnd.NOT_ISOLATED if neutral else BranchEnd.STEP_TOO_SMALL


def _rescaled(front: Front, largest: Reals) -> tuple[Front, Reals]:
    """Return the front in the scale of its orbit, and the largest sizes so far."""
    front = _restarted(front)
    sizes = scales(front.place, largest)
    largest = np.maximum(largest, front.place.passage.sizes)
    problem = Problem(front.problem.map, front.problem.span, sizes)
    tangent = front.tangent.copy()
    tangent[:-1] *= front.problem.sizes / sizes
    before = None if front.before is None else problem.adopted(front.before)
    place = problem.adopted(front.place)
    return Front(problem, place, tangent / norm(tangent), front.turn, before), largest


def _restarted(front: Front) -> Front:
    """Return the front with an orbit that begins where the map says it should, as far as it is found."""
    scale = np.append(front.problem.sizes, front.problem.span)
    restart = front.place.passage.restart(front.tangent * scale)
    if restart is None:
        return front
    problem = replace(front.problem, map=restart.map)
    place = problem.place(problem.position(front.place.value, restart.state))
    if place is None:
        return front
    tangent = null_vector(place.slope)
    place = problem.correct(place.position, tangent, float(tangent @ place.position))
    ahead = None if place is None else place.tangent(tangent)
    if place is None or ahead is None:
        return front
    return begun(problem, place, ahead * np.sign(ahead @ (restart.tangent / scale)))


def longest_step(
    front: Front, length: float, limits: Limits, smallest: float = SMALLEST
) -> tuple[BranchStep | None, float]:
    """Take a step, shortened until it succeeds or turns a corner; also return the length of the next one."""
    length = min(length, LARGEST_MOVE, limits.settings.largest_step / max(abs(front.tangent[-1]), 1e-12))
    while length >= smallest:
        made = step(front, length, limits.interval.ends, smooth=limits.smooth)
        if made is not None:
            return made, length * float(np.clip(BEND / max(made.bend, 1e-9), 0.5, LENGTHENED))
        length *= 0.5
    return turned(front), AFTER_CORNER


def _closed(first: Front, before: Front, after: Front) -> bool:
    """Say whether the branch passes its first orbit between two fronts, in its first direction."""
    if first.place.signature not in (before.place.signature, after.place.signature):
        return False
    here, chord = first.place.position[-1], after.place.position - before.place.position
    ends, near = (before.place.position[-1], after.place.position[-1]), NEAR * norm(chord)
    if not min(ends) - near <= here <= max(ends) + near:
        return False
    phases = before.problem.map.phases(first.place.value, first.place.strobed)
    return any(_passed(before.problem.position(first.place.value, each), before, after) for each in phases)


def _passed(position: Reals, before: Front, after: Front) -> bool:
    """Say whether a branch passes the orbit at a position between two fronts."""
    chord = after.place.position - before.place.position
    share = float(chord @ (position - before.place.position)) / float(chord @ chord)
    if not 0.0 < share <= 1.0:
        return False
    guess = before.place.position + share * chord
    if norm(guess - position) > NEAR * norm(chord):
        return False
    normal = chord / norm(chord)
    found = before.problem.correct(guess, normal, float(normal @ position))
    return found is not None and bool(abs(found.position - position).max() < SAME)


def scales(place: Place, before: Reals | None) -> Reals:
    """Return the scale of the states near an orbit; an entry that never moves has the scale 1."""
    sizes = place.passage.sizes
    if before is not None:
        sizes = np.maximum(sizes, LEAST_SIZE * before)
    return np.where(sizes > 0.0, sizes, 1.0)
