"""Following the exact periodic motions of a mechanism or a loop over any of its numbers."""

from dataclasses import replace

import numpy as np
from numpy.typing import ArrayLike

from trimmer.arguments import real_array, whole_number
from trimmer.branches.branch import Branch, BranchEnd
from trimmer.branches.continuation import continuation
from trimmer.branches.endless_period import at_saddle, endless_period
from trimmer.branches.followed import FollowedBranch, FollowedOrbit
from trimmer.branches.period_maps.driven_map import DrivenMap
from trimmer.branches.period_maps.fitting import fitting
from trimmer.branches.period_maps.self_excited_map import SelfExcitedMap
from trimmer.branches.saddle import saddle_passed
from trimmer.branches.settings import DEFAULT, FollowSettings
from trimmer.branches.torn_out import torn_out
from trimmer.errors import LoopError, MechanismError, OrbitNotFoundError
from trimmer.loops.loops import Loop
from trimmer.mechanism.drives import RETURNS, told_of_drives
from trimmer.mechanism.mechanism import Mechanism
from trimmer.mechanism.place_text import parse_place
from trimmer.messages import listed
from trimmer.motion.flow import Flow
from trimmer.motion.subject import Subject
from trimmer.response.by_itself.orbit_by_itself import orbit_by_itself
from trimmer.response.exact_orbit import exact_orbit, require_repeating
from trimmer.response.flows import flow_of, known_flow_of, require_subject
from trimmer.response.periodic.orbit import NEUTRAL, Orbit
from trimmer.response.periodic.pace import pace_of, periods_of
from trimmer.response.respond import respond
from trimmer.response.settling.settling import orbit_from_rest
from trimmer.response.settling.solved import EVENLY
from trimmer.response.starts import instant_of


def follow(
    mechanism: Mechanism | Loop,
    place: str,
    start: float | str,
    stop: float | str,
    *,
    periods: int | None = None,
    state: ArrayLike | None = None,
    settings: FollowSettings = DEFAULT,
) -> FollowedBranch:
    """Follow a branch of exact periodic motions of a mechanism or a loop over one of its numbers.

    It begins with what the mechanism settles to from rest at ``start``, goes towards ``stop``, and ends on
    leaving the interval at either end. A motion that is its own mirror image half a period later is followed
    as such; of the two asymmetric branches that part from it, which are mirror images, one is followed. Where
    a branch of asymmetric motions joins the symmetric one, it goes on along that towards ``stop``, and the
    other side of the symmetric one is followed as a branch that parts.

    A mechanism without a frequency moves by itself, and so does a closed loop. Then the period is an unknown
    of each orbit; the multiplier that is 1, since the motion may be shifted in time, has no say in stability
    and special points. At rest nothing happens in a closed loop, so that its branch begins with the stable
    orbit of largest amplitude that ``periodic_orbits`` finds, or an unstable one if there is no other.

    Args:
        mechanism: The mechanism or loop.
        place: Dotted place of the number, such as ``frequency``, ``plays.bridge.gap`` or ``element.gap``.
        start: First value in SI units (Hz for a frequency), or text with its unit.
        stop: The other end of the interval.
        periods: Drive periods after which the motion repeats; by default those after which it does.
        state: State at the start of a drive period from which to begin instead, shape (n,); see
            ``FollowedBranch.state_names`` for its entries. Without a drive a state anywhere on the
            motion and its period, s, shape (n + 1,), as ``FollowedOrbit.state``.
        settings: How to follow it.

    Returns:
        The branch. If the mechanism does not settle, it has no points and a message that says so.

    Raises:
        MechanismError, LoopError: if there is no such number, or it cannot have these values.
        UnsupportedMotionError: if the mechanism never repeats, because a pin goes on for ever and pulls.
        WrongTypeError: if an argument has another type.
        ValueError: if start and stop are equal, a number is out of its range, or ``periods`` is given without
            a drive.

    Sources:
        Allgower and Georg, Introduction to Numerical Continuation Methods, 2003; Leine and Nijmeijer,
        Dynamics and Bifurcations of Non-Smooth Mechanical Systems, 2004.
    """
    require_subject(mechanism)
    if periods is not None:
        whole_number("periods", periods, 1)
    begin, end = _interval(mechanism, place, start, stop)
    at_start = mechanism.with_value(place, begin)
    scale = max(abs(begin), abs(end))
    if not known_flow_of(at_start).period:
        if periods is not None:
            raise ValueError(
                f"periods is {periods}, but the mechanism has no drive whose periods could count"
            )
        return _self_excited(SelfExcitedMap(at_start, place, scale), begin, end, state, settings)
    map = DrivenMap(at_start, place, scale, periods or 1)
    if state is None:
        orbit = _orbit_at_start(at_start, settings.most_periods, periods)
        if orbit is None:
            message = _unsettled(at_start, begin, settings.most_periods)
            return FollowedBranch(map, (), (), BranchEnd.NO_START, message)
        map, first = replace(map, periods=periods or orbit.periods), orbit.instant.state
    else:
        first = instant_of(known_flow_of(at_start), real_array("state", state)).state
    map = fitting(map, begin, first)
    branch = continuation(map, first, begin, end, settings)
    base = map
    while base.single is not None:
        base = base.single
    return _with_torn(_followed(branch, base))


def require_continuous(place: str) -> None:
    """Check that a number has values between any two of its values.

    Raises:
        MechanismError: if it is a whole number.
    """
    if place.endswith(".order"):
        raise MechanismError(f"{place}: orders are whole numbers, so that nothing lies between two of them")


def ends_of(mechanism: Subject, place: str, start: float | str, stop: float | str) -> tuple[float, float]:
    """Return both ends of an interval of a number, in SI units.

    Raises:
        MechanismError: if they are the same, or nothing is between them since it is a whole number.
    """
    begin, end = (mechanism.with_value(place, each).value(place) for each in (start, stop))
    if begin == end:
        told = f"{place}: the interval has no length, from {begin:.10g} to {end:.10g}"
        raise MechanismError(told, place=parse_place(place))
    require_continuous(place)
    return begin, end


def _interval(mechanism: Subject, place: str, start: float | str, stop: float | str) -> tuple[float, float]:
    """Return both ends of an interval of a number, in SI units, once they were checked."""
    begin, end = ends_of(mechanism, place, start, stop)
    if mechanism.frequency is None and parse_place(place) == ("frequency",):
        mechanism.value(place)
    flows = [flow_of(mechanism.with_value(place, each)) for each in (begin, end)]
    for flow in flows:
        require_repeating(flow)
    require_together(place, *flows)
    return begin, end


def require_together(place: str, first: Flow, last: Flow) -> None:
    """Check that the drives of a mechanism return together at all values of a number.

    Raises:
        MechanismError: if they do not, or at single values only.
    """
    layouts = [flow.modes.system.layout for flow in (first, last)]
    if not layouts[0].recurrence:
        raise MechanismError(f"nothing repeats that could be followed: {told_of_drives(RETURNS)}")
    if isinstance(first.subject, Mechanism) and layouts[0].drives != layouts[1].drives:
        raise MechanismError(
            f"{place}: the drives return together at single values only, with no branch between them"
        )


def _self_excited(
    map: SelfExcitedMap, begin: float, end: float, state: ArrayLike | None, settings: FollowSettings
) -> FollowedBranch:
    """Follow a mechanism that moves by itself, from what it settles to, or from a state and period."""
    flow = map.flow(begin)
    if state is None:
        try:
            orbit = orbit_by_itself(flow)
        except OrbitNotFoundError as error:
            message = f"at {begin:.10g} there is no motion to begin with: {error}"
            return FollowedBranch(map, (), (), BranchEnd.NO_START, message)
        first = np.append(orbit.instant.state, orbit.period)
    else:
        first = real_array("state", state)
        if first.shape != (map.size,):
            kind = LoopError if isinstance(map.subject, Loop) else MechanismError
            raise kind(
                f"the start has the shape {first.shape}, but without a drive it is {map.size - 1} states "
                f"and the period: {listed((*flow.names, 'period'))}"
            )
    passage = map.passage(begin, first)
    if passage.stands:
        message = f"at {begin:.10g} there is nothing to follow: {EVENLY}"
        return FollowedBranch(map, (), (), BranchEnd.NO_START, message)
    if abs(np.linalg.eigvals(passage.monodromy) - 1.0).min() <= NEUTRAL:
        reason = BranchEnd.NOT_ISOLATED
        return FollowedBranch(map, (), (), reason, f"{reason.value}, at {begin:.10g}")
    doubled: DrivenMap = map
    for _ in range(passage.halvings):
        doubled, first = doubled.doubled(), np.append(first[:-1], 0.5 * first[-1])
    return _with_torn(_with_end(_followed(continuation(doubled, first, begin, end, settings), map)))


def _with_end(branch: FollowedBranch) -> FollowedBranch:
    """Return a branch without a drive, with where its period grows without bound if it ends for that."""
    if branch.reason is not BranchEnd.STEP_TOO_SMALL:
        return branch
    values, periods = (
        np.array([getattr(each, name) for each in branch.points]) for name in ("value", "period")
    )
    last = branch.points[-1].passage
    saddle = saddle_passed(last.flow, last.course)
    found = endless_period(values, periods) if saddle is None else at_saddle(values, periods, saddle)
    if found is None:
        return branch
    return replace(branch, reason=BranchEnd.INFINITE_PERIOD, message=found.told, endless=found)


def _with_torn(branch: FollowedBranch) -> FollowedBranch:
    """Return a branch, and those that part from it, with where stick is torn out only just if they end so."""
    branch = replace(branch, branches=tuple(map(_with_torn, branch.branches)))
    torn = torn_out(branch.points) if branch.reason is BranchEnd.STEP_TOO_SMALL else None
    if torn is None:
        return branch
    return replace(branch, reason=BranchEnd.TORN, message=torn.told, special=(*branch.special, torn.special))


def _orbit_at_start(mechanism: Subject, most_periods: int, periods: int | None) -> Orbit | None:
    """Return what a mechanism settles to, or an orbit of a given number of periods, stable or not."""
    if periods is None:
        return orbit_from_rest(mechanism, most_periods)
    try:
        orbit = exact_orbit(mechanism, periods)
    except OrbitNotFoundError:
        return None
    return orbit if orbit.success else None


def _unsettled(subject: Mechanism | Loop, begin: float, most_periods: int) -> str:
    motion = respond(subject, most_periods=most_periods).motion
    cut_short = motion.orbit is None and motion.drive_periods < most_periods
    if cut_short or pace_of(subject) > 1:
        why = f"only what repeats is followed: {motion.message[0].lower()}{motion.message[1:]}"
        return f"at {begin:.10g} there is nothing to follow, since {why}"
    waited = periods_of(subject, most_periods)
    return (
        f"from rest at {begin:.10g} the motion has not settled within {waited}; begin at "
        "another value, give the number of periods after which it shall repeat, or wait longer"
    )


def _followed(branch: Branch, base: DrivenMap) -> FollowedBranch:
    """Return a branch, with the map of which all others are doubled."""
    map = base
    for _ in range(branch.doublings):
        map = map.doubled()
    whole = replace(map, mirrored=False)
    return FollowedBranch(
        map=whole,
        points=tuple(FollowedOrbit(point, whole) for point in branch.points),
        special=branch.special,
        reason=branch.reason,
        message=branch.message,
        branches=tuple(_followed(each, base) for each in branch.branches),
        parted=branch.parted,
    )
