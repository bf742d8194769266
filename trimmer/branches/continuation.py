"""Pseudo-arc-length continuation of periodic orbits over one number."""

from __future__ import annotations

import math
from collections.abc import Iterator
from dataclasses import dataclass, field, replace

import numpy as np
from tqdm import tqdm

from trimmer.arguments import finite_number
from trimmer.arrays import Complexes, Reals
from trimmer.branches.bifurcations import Bifurcation
from trimmer.branches.branch import NEUTRAL, Branch, BranchEnd, BranchPoint
from trimmer.branches.corner import is_torn, turned
from trimmer.branches.orbit import Place, Problem
from trimmer.branches.period_map import PeriodMap
from trimmer.branches.settings import DEFAULT, FollowSettings
from trimmer.branches.special import SpecialPoint
from trimmer.branches.step import Front, Step, begun, step
from trimmer.branches.switching import parted_fronts

FIRST = 1e-3
"""Length of the first step."""
SMALLEST = 2e-12
"""Length below which a step is not shortened any more."""
LARGEST_MOVE = 0.1
"""Largest length of a step in all coordinates."""
BEND = 0.15
"""Angle between the tangents before and after a step, rad, at which its length is right."""
LENGTHENED = 2.0
"""Most by which a step is longer than the one before."""
AFTER_CORNER = 1e-3
"""Length of the step after a corner."""
LEAST_SIZE = 1e-2
"""Least scale of a state, relative to the largest that it had on the branch."""
AT_END = 1e-12
"""Distance from an end of the interval, as a share of it, within which a value is that end."""
SILENCE = 2.0
"""Time before a progress bar shows, s."""
SAME = 1e-6
"""Distance within which two orbits are the same."""


@dataclass(frozen=True)
class Interval:
    """The values over which a branch is followed.

    Attributes:
        start: Where it begins.
        stop: The other end.
    """

    start: float
    stop: float

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


@dataclass
class _Record:
    """What has been found of a branch so far."""

    points: list[BranchPoint] = field(default_factory=list)
    special: list[SpecialPoint] = field(default_factory=list)
    switches: list[tuple[Problem, Bifurcation]] = field(default_factory=list)


def continuation(
    map: PeriodMap, state: Reals, start: float, stop: float, settings: FollowSettings = DEFAULT
) -> Branch:
    """Follow the branch of an orbit over an interval of values.

    The branch begins with the orbit at ``start`` and ends on leaving the interval at either end, on closing
    on itself, or where no orbit is found near the last one.

    Args:
        map: The map of a period.
        state: Guess of the state at the beginning of the period, shape (n,).
        start: First value.
        stop: Other end of the interval; with bounds of their own, on which side of ``start`` to begin.
        settings: How to follow it.

    Raises:
        WrongTypeError: if start or stop is no number.
        ValueError: if start and stop are equal or not finite, or bounds are not around start.
    """
    begin = finite_number("start", start)
    limits = Limits(_interval(begin, finite_number("stop", stop), settings.bounds), settings)
    front = _first_front(map, np.asarray(state, dtype=float), begin, limits.interval)
    if isinstance(front, BranchEnd):
        return Branch((), (), front, f"{front.value}, at {begin:.10g}")
    if front is None:
        message = f"Newton's method finds no orbit at {begin:.10g} near the state that was given"
        return Branch((), (), BranchEnd.NO_START, message)
    return _followed(front, limits, settings.switches, None)


def _interval(start: float, stop: float, bounds: tuple[float, float] | None) -> Interval:
    if start == stop:
        raise ValueError(f"start and stop are both {start!r}: give an interval")
    if bounds is None:
        return Interval(start, stop)
    lowest, highest = sorted(bounds)
    if not lowest <= start <= highest or lowest == highest:
        raise ValueError(f"bounds must be two numbers around start {start!r}, not {bounds!r}")
    return Interval(lowest, highest) if start < stop else Interval(highest, lowest)


@dataclass(frozen=True)
class Limits:
    """How far and how a branch is followed."""

    interval: Interval
    settings: FollowSettings


def _first_front(map: PeriodMap, state: Reals, begin: float, interval: Interval) -> Front | BranchEnd | None:
    problem = Problem(map, interval.span, np.ones(len(state)))
    guess = problem.place(problem.position(begin, state))
    if guess is None:
        return None
    problem = Problem(map, interval.span, sizes_of(guess, None))
    across = np.append(np.zeros(len(state)), 1.0)
    position = problem.position(begin, state)
    place = problem.correct(position, across, position[-1])
    if place is None:
        return None
    problem = Problem(map, interval.span, sizes_of(place, None))
    place = problem.adopted(place)
    tangent = place.tangent(math.copysign(1.0, interval.stop - interval.start) * across)
    if tangent is None:
        return BranchEnd.NOT_ISOLATED
    return begun(problem, place, tangent)


def sizes_of(place: Place, before: Reals | None) -> Reals:
    """Return the scale of the states near an orbit; an entry that never moves has the scale 1."""
    sizes = abs(place.passage.sizes)
    if before is not None:
        sizes = np.maximum(sizes, LEAST_SIZE * before)
    return np.where(sizes > 0.0, sizes, 1.0)


def _followed(front: Front, limits: Limits, switches: int, parted: SpecialPoint | None) -> Branch:
    record = _Record([_branch_point(front)])
    reason = BranchEnd.MOST_POINTS
    steps = tqdm(
        _steps(front, limits),
        desc="follow",
        unit=" orbits",
        delay=SILENCE,
        leave=False,
        disable=True if limits.settings.quiet else None,
    )
    for taken in steps:
        if isinstance(taken, BranchEnd):
            reason = taken
            break
        made, problem = taken
        record.points.append(_branch_point(made.front))
        record.special += [each for each in made.special if limits.interval.holds(each.value)]
        record.switches += [(problem, each) for each in made.switches]
    branches = tuple(_parted(record, limits, switches)) if switches else ()
    return Branch(
        points=tuple(record.points),
        special=tuple(record.special),
        reason=reason,
        message=_message(reason, record),
        branches=branches,
        parted=parted,
        doublings=front.problem.map.doublings,
    )


def _parted(record: _Record, limits: Limits, switches: int) -> Iterator[Branch]:
    """Follow the branches that part from one; what ends at another point of it does not begin there."""
    rejoined: list[BranchPoint] = []
    for problem, bifurcation in record.switches:
        if any(_begins_at(problem, bifurcation, point, limits) for point in rejoined):
            continue
        for front in parted_fronts(problem, bifurcation):
            branch = _followed(front, limits, switches - 1, bifurcation.point)
            rejoined += [branch.points[-1]] if branch.reason is BranchEnd.REJOINED else []
            yield branch


def _begins_at(problem: Problem, bifurcation: Bifurcation, point: BranchPoint, limits: Limits) -> bool:
    away = abs(problem.position(point.value, point.state) - bifurcation.place.position)
    return bool(away[-1] <= limits.settings.largest_step and away.max() <= LARGEST_MOVE)


def _steps(front: Front, limits: Limits) -> Iterator[tuple[Step, Problem] | BranchEnd]:
    """Yield one step after the other, with the problem in whose scale it was made, and why they end."""
    first, length, largest = front, FIRST, np.zeros(front.problem.map.size)
    for count in range(1, limits.settings.most_points):
        front, largest = _rescaled(front, largest)
        made, length = longest_step(front, length, limits)
        if made is None:
            yield _obstacle(front)
            return
        if made.ended is BranchEnd.REJOINED:
            yield made.ended
            return
        yield made, front.problem
        if count > 2 and _closed(first, front, made.front):
            yield BranchEnd.CLOSED
            return
        if made.ended is not None:
            yield made.ended
            return
        front = made.front


def _obstacle(front: Front) -> BranchEnd:
    """Say why no orbit was found beyond a front."""
    if is_torn(front):
        return BranchEnd.TORN
    neutral = abs(front.place.multipliers - 1.0).min() < NEUTRAL
    return BranchEnd.NOT_ISOLATED if neutral else BranchEnd.STEP_TOO_SMALL


def _rescaled(front: Front, largest: Reals) -> tuple[Front, Reals]:
    """Return the front in the scale of its orbit, and the largest sizes so far."""
    sizes = sizes_of(front.place, largest)
    largest = np.maximum(largest, abs(front.place.passage.sizes))
    problem = replace(front.problem, sizes=sizes)
    tangent = front.tangent.copy()
    tangent[:-1] *= front.problem.sizes / sizes
    before = None if front.before is None else problem.adopted(front.before)
    place = problem.adopted(front.place)
    return Front(problem, place, tangent / np.linalg.norm(tangent), front.turn, before), largest


def longest_step(
    front: Front, length: float, limits: Limits, smallest: float = SMALLEST
) -> tuple[Step | None, float]:
    """Take a step, shortened until it succeeds or turns a corner; also return the length of the next one."""
    length = min(length, LARGEST_MOVE, limits.settings.largest_step / max(abs(front.tangent[-1]), 1e-12))
    while length >= smallest:
        made = step(front, length, *limits.interval.ends)
        if made is not None:
            return made, length * float(np.clip(BEND / max(made.bend, 1e-9), 0.5, LENGTHENED))
        length *= 0.5
    return turned(front), AFTER_CORNER


def _closed(first: Front, before: Front, after: Front) -> bool:
    """Say whether the branch passes its first orbit between two fronts, in its first direction."""
    place = before.problem.adopted(first.place)
    chord = after.place.position - before.place.position
    share = float(chord @ (place.position - before.place.position)) / float(chord @ chord)
    if not 0.0 < share <= 1.0 or place.signature not in (before.place.signature, after.place.signature):
        return False
    away = float(np.linalg.norm(before.place.position + share * chord - place.position))
    if away > 0.1 * float(np.linalg.norm(chord)):
        return False
    normal = chord / np.linalg.norm(chord)
    found = before.problem.correct(
        before.place.position + share * chord, normal, float(normal @ place.position)
    )
    return found is not None and bool(abs(found.position - place.position).max() < SAME)


def _branch_point(front: Front) -> BranchPoint:
    problem, place = front.problem, front.place
    multipliers, events = place.multipliers, place.passage.events
    if problem.map.mirrored:
        multipliers, events = multipliers**2, 2 * events
    tangent = front.tangent * np.append(problem.sizes, problem.span)
    return BranchPoint(
        value=problem.value(place.position),
        state=problem.state(place.position),
        multipliers=_by_modulus(multipliers),
        tangent=tangent,
        signature=dict(place.signature),
        events=events,
    )


def _by_modulus(multipliers: Complexes) -> Complexes:
    return multipliers[np.argsort(-abs(multipliers), kind="stable")]


def _message(reason: BranchEnd, record: _Record) -> str:
    begun = "" if record.points[0].stable else "; the orbit it begins with is unstable"
    return f"{reason.value}, at {record.points[-1].value:.10g}{begun}"
