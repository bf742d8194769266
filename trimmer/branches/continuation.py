"""Pseudo-arc-length continuation of periodic orbits over one number."""

import math
from collections.abc import Iterator
from dataclasses import dataclass, field

import numpy as np

from trimmer.arguments import finite_number
from trimmer.arrays import Reals
from trimmer.branches.bifurcations import Bifurcation
from trimmer.branches.borders import grazing, special_points
from trimmer.branches.branch import NEUTRAL, Branch, BranchEnd, BranchPoint
from trimmer.branches.corner import torn
from trimmer.branches.joining import front_beyond, joint
from trimmer.branches.known import Known
from trimmer.branches.orbit import Problem
from trimmer.branches.period_maps.driven_map import DrivenMap
from trimmer.branches.settings import DEFAULT, FollowSettings
from trimmer.branches.special import SpecialPoint
from trimmer.branches.step import Front, begun
from trimmer.branches.stepping import Interval, Limits, scales, steps
from trimmer.branches.switching import parted_fronts
from trimmer.one_orbit import SAME
from trimmer.progress import progress_bar


@dataclass
class _Record:
    """What has been found of a branch so far."""

    points: list[BranchPoint] = field(default_factory=list)
    special: list[SpecialPoint] = field(default_factory=list)
    switches: list[tuple[Problem, Bifurcation]] = field(default_factory=list)


@dataclass(frozen=True)
class _Leg:
    """How the orbits of one map end: the last front, why, and the bifurcation at which they join others."""

    front: Front
    reason: BranchEnd
    joint: Bifurcation | None = None


def continuation(
    map: DrivenMap, state: Reals, start: float, stop: float, settings: FollowSettings = DEFAULT
) -> Branch:
    """Follow the branch of an orbit over an interval of values.

    The branch begins with the orbit at ``start`` and ends on leaving the interval at either end, on closing
    on itself, or where no orbit is found near the last one. Asymmetric orbits, given as those of a mirrored
    map that is doubled, go on along the symmetric ones where they join them; doubled orbits end where they
    join single ones, which are followed from there on both sides.

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
    branch = _followed(front, limits, settings.switches, None, Known(map.doublings))
    assert branch is not None
    return branch


def _interval(start: float, stop: float, bounds: tuple[float, float] | None) -> Interval:
    if start == stop:
        raise ValueError(f"start and stop are both {start!r}: give an interval")
    if bounds is None:
        return Interval(start, stop)
    lowest, highest = sorted(bounds)
    if not lowest <= start <= highest or lowest == highest:
        raise ValueError(f"bounds must be two numbers around start {start!r}, not {bounds!r}")
    return Interval(lowest, highest) if start < stop else Interval(highest, lowest)


def _first_front(map: DrivenMap, state: Reals, begin: float, interval: Interval) -> Front | BranchEnd | None:
    problem = Problem(map, interval.span, np.ones(len(state)))
    guess = problem.place(problem.position(begin, state))
    if guess is None:
        return None
    across = np.append(np.zeros(len(state)), 1.0)
    restart = guess.passage.restart(across)
    begins = [(map, state)] if restart is None else [(restart.map, restart.state), (map, state)]
    for map, state in begins:
        problem = Problem(map, interval.span, scales(guess, None))
        position = problem.position(begin, state)
        place = problem.correct(position, across, position[-1])
        if place is not None:
            break
    else:
        # Beside an orbit that is not single Newton's method finds one or none by chance.
        neutral = abs(guess.multipliers - 1.0).min() < NEUTRAL
        closed = Problem(begins[-1][0], interval.span, scales(guess, None)).adopted(guess).error < SAME
        return BranchEnd.NOT_ISOLATED if neutral and closed else None
    problem = Problem(map, interval.span, scales(place, None))
    place = problem.adopted(place)
    tangent = place.tangent((interval.stop - interval.start) * across)
    if tangent is None:
        return BranchEnd.NOT_ISOLATED
    return begun(problem, place, tangent)


def _followed(
    front: Front, limits: Limits, switches: int, parted: SpecialPoint | None, known: Known
) -> Branch | None:
    """Follow a branch and those that part from it; None if it is known already."""
    record, doublings = _Record([_branch_point(front)]), front.problem.map.doublings
    leg = _follow_leg(front, limits, record)
    last = record.points[-1]
    left = leg.reason in (BranchEnd.LEFT_AT_START, BranchEnd.LEFT_AT_STOP)
    if parted is not None and left and known.holds(leg.front.problem, last):
        return None
    first = None if limits.interval.holds(record.points[0].value) else record.points[0]
    known.add(doublings, first, last, leg.reason)
    meeting, behind = leg.joint, list[Front]()
    if meeting is not None and doublings <= known.lowest:
        known.lowest = doublings - 1
        record.special.append(meeting.point)
        leg, behind = _joined(leg, meeting, limits, record)
        known.add(leg.front.problem.map.doublings, None, record.points[-1], leg.reason)
    others: list[Branch | None] = []
    if switches:
        at = None if meeting is None else meeting.point
        others = [_followed(each, limits, switches - 1, at, known) for each in behind]
        others += _parted(record, limits, switches, known)
    return Branch(
        points=tuple(record.points),
        special=tuple(record.special),
        reason=leg.reason,
        message=_message(leg.reason, record),
        branches=tuple(each for each in others if each is not None),
        parted=parted,
        doublings=doublings,
    )


def _follow_leg(front: Front, limits: Limits, record: _Record) -> _Leg:
    """Follow the orbits of one map, and record what is found."""
    taken_steps = progress_bar(
        steps(front, limits, len(record.points)), "follow", quiet=limits.settings.quiet, unit=" orbits"
    )
    for taken in taken_steps:
        if isinstance(taken, BranchEnd):
            if taken is BranchEnd.GRAZED:
                record.special.append(grazing(front.place, record.points))
            if taken is BranchEnd.TORN and (border := torn(front)) is not None:
                record.special += special_points(border)
            return _Leg(front, taken)
        if limits.settings.deadline.passed:
            return _Leg(front, BranchEnd.OUT_OF_TIME)
        made, problem = taken
        if made.beyond is not None:
            return _Leg(made.front, BranchEnd.REJOINED, joint(made.front, made.beyond))
        front = made.front
        record.points.append(_branch_point(front))
        record.special += [each for each in made.special if limits.interval.holds(each.value)]
        record.switches += [(problem, each) for each in made.switches]
    return _Leg(front, BranchEnd.MOST_POINTS)


def _joined(leg: _Leg, bifurcation: Bifurcation, limits: Limits, record: _Record) -> tuple[_Leg, list[Front]]:
    """Go on where a branch joins another one that has not been followed.

    An asymmetric branch goes on along the symmetric one, towards the other end of the interval. A branch with
    half the period is another branch.

    Returns:
        The last leg, and where other branches begin.
    """
    ahead = math.copysign(1.0, limits.interval.stop - limits.interval.start)
    onward, back = (front_beyond(bifurcation, sign) for sign in (ahead, -ahead))
    others = [each for each in (onward, back) if each is not None]
    if not bifurcation.place.problem.map.mirrored or onward is None:
        return leg, others
    record.points.append(_branch_point(onward))
    return _follow_leg(onward, limits, record), others[1:]


def _parted(record: _Record, limits: Limits, switches: int, known: Known) -> Iterator[Branch | None]:
    """Follow the branches that part from one; what ends at another point of it does not begin there."""
    for problem, bifurcation in record.switches:
        if not known.is_joined(problem, bifurcation, limits.settings.largest_step):
            for front in parted_fronts(problem, bifurcation):
                yield _followed(front, limits, switches - 1, bifurcation.point, known)


def _branch_point(front: Front) -> BranchPoint:
    problem, place = front.problem, front.place
    multipliers, events = place.multipliers, place.passage.events
    if problem.map.mirrored:
        multipliers, events = multipliers**2, 2 * events
    return BranchPoint(
        value=place.value,
        state=place.strobed,
        multipliers=multipliers[np.argsort(-abs(multipliers), kind="stable")],
        signature=dict(place.signature),
        events=events,
    )


def _message(reason: BranchEnd, record: _Record) -> str:
    begun = "" if record.points[0].stable else "; the orbit it begins with is unstable"
    return f"{reason.value}, at {record.points[-1].value:.10g}{begun}"
