"""Periodic motions of a mechanism that moves by itself: the period is unknown.

The motion is followed until an event comes again in nearly the same state; from there Newton's method solves
for state and period. The motion begins in the middle of a segment, where nothing happens.
"""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass, replace

import numpy as np

from trimmer.arrays import Reals
from trimmer.errors import DivergingMotionError, OrbitNotFoundError
from trimmer.hybrid.advance import Ending, Instant
from trimmer.motion.course import Course
from trimmer.motion.flow import Flow
from trimmer.motion.time_scale import time_scale
from trimmer.one_orbit import SAME
from trimmer.response.arrival import has_arrived, what_happened
from trimmer.response.asymptotic import asymptotic_rest, runs_on
from trimmer.response.dying_away import rest_dying_away
from trimmer.response.growth import grew, state_sizes
from trimmer.response.linear_motion import grows_for_ever, linear_motion
from trimmer.response.orbit import Orbit, orbit_of
from trimmer.response.response import MotionKind
from trimmer.response.rest import Rest
from trimmer.response.returns import Returns
from trimmer.response.shooting import CLOSED, Patience, Return, Shot, sizes_of, solve
from trimmer.response.solved import Solved, solved

STRETCHES = (20, 80, 320, 1280)
"""Lengths of the motion that is searched for a recurrence, in periods of the slowest mode."""
FURTHER = (5120, 20480)
"""Those that follow where little has happened until then, if no number of periods is given."""
LITTLE = 2000
"""Events that are little for so long a time."""
CLOSELY = 1e-7
"""Distance of two states as a share of their sizes at which a recurrence comes before chaos is asked for."""
SURELY = 1000
"""Returns of one stretch from which chaos is told; else it is to be seen in two stretches."""
NEAR = 0.1
"""Distance of two states as a share of their sizes at which Newton's method is tried."""
RESTING = 1e-9
"""Share of its size by which a state that is at rest changes at most in a period of the slowest mode."""
CLOSE = 10.0
"""Factor of the least distance up to which states count as one: what has settled comes back closest."""
MOST_ROWS = 1500
"""Segments of all recurrences that are tried in a stretch: Newton's method follows each many times."""
MOST_TRIED = 6
"""Recurrences that are tried in each stretch, nearest in time first."""
FROM_NEARBY = Patience(iterations=20, halvings=4, followed=2)
"""How long an orbit is looked for from a recurrence: a chaotic motion has many near which there is none."""


@dataclass(frozen=True, eq=False)
class SelfExcited:
    """What a motion without a drive comes to; nothing where it was not seen.

    Attributes:
        waited: How long it was followed, s.
        orbit: The orbit that it settles to.
        rest: Where it rests.
        solved: What it comes to, if no event comes any more.
        passed: An unstable orbit that it passes.
        unit: Period of the slowest mode, s, in which ``most_periods`` counts.
        returns: The last stretch that was followed, where nothing repeats.
    """

    waited: float
    orbit: Orbit | None = None
    rest: Rest | None = None
    solved: Solved | None = None
    passed: Orbit | None = None
    unit: float = 0.0
    returns: Returns | None = None


def self_excited_orbit(flow: Flow, instant: Instant) -> Orbit:
    """Find a periodic motion without a drive, from what a start settles to.

    An unstable one that the motion passes will do where it settles to none.

    Args:
        flow: The motion of the mechanism.
        instant: The start.

    Raises:
        OrbitNotFoundError: if nothing repeats in the time that was waited; the message says what was seen.
    """
    found = self_excited(flow, instant)
    orbit = found.orbit or found.passed
    if orbit is None and found.returns is not None and found.returns.chaotic:
        orbit = next(iter(_recurring(flow, found.returns.course)), None)
    if orbit is not None:
        return orbit
    if found.rest is not None:
        within = found.waited + (found.solved.decay if found.solved else 0.0)
        raise OrbitNotFoundError(f"it comes to rest within {within:.6g} s, and nothing sets it in motion")
    if found.solved is not None:
        raise OrbitNotFoundError("it runs on a torus for ever; another start may repeat")
    raise OrbitNotFoundError(f"nothing repeats within {found.waited:.6g} s; another start may settle")


def orbit_by_itself(flow: Flow) -> Orbit:
    """Find a periodic motion without a drive, of what moves from rest; of a loop one that was searched for.

    At rest nothing happens in a closed loop. So it is the stable orbit of largest amplitude there that
    ``periodic_orbits`` finds, or the largest unstable one if there is no other. Of a trimmer with frictions
    between its bodies it is what that orbit without them leads to.

    Raises:
        OrbitNotFoundError: if there is none.
    """
    from trimmer.loops.feedback import Feedback
    from trimmer.loops.loops import ClosedLoop
    from trimmer.loops.trimmer_loop import TrimmerLoop

    loop = flow.subject
    begins = isinstance(loop, Feedback) and bool(loop.start)
    if begins or not isinstance(loop, ClosedLoop | Feedback | TrimmerLoop):
        return self_excited_orbit(flow, flow.rest())
    from trimmer.orbits.periodic_orbits import periodic_orbits

    rubs = isinstance(loop, TrimmerLoop) and bool(loop.frictions)
    found = periodic_orbits(replace(loop, frictions=()) if isinstance(loop, TrimmerLoop) else loop)
    if not found:
        raise OrbitNotFoundError(f"the loop has no orbit to begin with: {found.message}")
    first = next((orbit for orbit in found if orbit.stable), found[0])
    if rubs:
        return self_excited_orbit(flow, flow.at(np.ascontiguousarray(first.motion.log.state[0][: flow.size])))
    state = np.ascontiguousarray(first.motion.log.state[0][: flow.size])
    statuses = first.motion.loop.modes[int(first.motion.log.mode[0])].statuses
    begin = replace(flow.at(state), statuses=statuses)
    shot = solve(Return(flow, 0), flow.at(state, like=begin), first.period)
    if shot is None or shot.miss > CLOSED:
        raise OrbitNotFoundError("the orbit of the loop cannot be followed")
    return orbit_of(flow, _once(flow, shot), 0)


def self_excited(flow: Flow, instant: Instant, most_periods: int | None = None) -> SelfExcited:
    """Return what a motion without a drive comes to.

    Args:
        flow: What moves.
        instant: The start.
        most_periods: Periods of the slowest mode to wait; as many as ``STRETCHES``, and ``FURTHER`` where
            little happens, if not given.

    Raises:
        OrbitNotFoundError: if it cannot be followed, or grows.
    """
    unit, waited, known = time_scale(flow, instant), 0.0, list[Orbit]()
    reached, returns, happened = list[tuple[float, Reals]](), list[Returns](), 0
    for stretch in _stretches(most_periods):
        if stretch in FURTHER and most_periods is None and happened > LITTLE:
            break
        found = _without_events(flow, instant, waited)
        if found is not None:
            return found
        course = _followed(flow, instant, stretch * unit, waited)
        waited += course.duration
        rest = _rest_after(flow, course, unit)
        if rest is not None:
            return SelfExcited(waited, rest=rest)
        if course.ending is not Ending.REACHED_END:
            raise OrbitNotFoundError(f"the motion cannot be followed: {course.ending.value}")
        happened += len(course.events)
        reached.append((waited, state_sizes(flow, flow.reduced(_at_events(flow, course)))))
        returns.append(Returns.of(flow, course))
        orbit = _settled_to(flow, returns[-1], known)
        if orbit is not None:
            return SelfExcited(waited, orbit)
        if _is_chaotic(returns):
            break
        instant = replace(course.end, phase=0.0)
    unstable = next((each for each in known if not each.stable and not each.neutral), None)
    if unstable is None and not returns[-1].chaotic and grew(reached):
        raise DivergingMotionError(
            f"it diverges: until {waited:.6g} s it grew in proportion to the time, and nothing held it"
        )
    return SelfExcited(waited, passed=unstable, unit=unit, returns=returns[-1])


def _without_events(flow: Flow, instant: Instant, waited: float) -> SelfExcited | None:
    """Return what a motion comes to in which no event comes any more; None if one may.

    Raises:
        DivergingMotionError: if it grows for ever.
    """
    at_last = solved(flow, instant)
    if at_last is not None:
        return SelfExcited(waited, _repeating(at_last), at_last.rest, at_last)
    if grows_for_ever(flow, instant):
        raise DivergingMotionError(
            "it diverges: a constant force meets what nothing holds or damps, and no event comes any "
            "more, so that it grows for ever"
        )
    return None


def _followed(flow: Flow, instant: Instant, duration: float, waited: float) -> Course:
    """Return the motion over a duration, s.

    Raises:
        DivergingMotionError: if it grows beyond all bounds.
    """
    course = flow.timed(instant, duration)
    if course.ending is Ending.DIVERGED:
        within = waited + course.duration
        raise DivergingMotionError(f"it diverges: within {within:.6g} s {course.ending.value}")
    return course


def _is_chaotic(returns: list[Returns]) -> bool:
    """Say whether a motion is chaotic over a long stretch, or over two."""
    last = returns[-1]
    return last.chaotic and (last.count >= SURELY or (len(returns) > 1 and returns[-2].chaotic))


def _stretches(most_periods: int | None) -> Iterator[int]:
    """Yield the lengths that are followed one after the other, in periods of the slowest mode."""
    left = sum((*STRETCHES, *FURTHER)) if most_periods is None else most_periods
    for stretch in (*STRETCHES, *FURTHER, left):
        if left > 0:
            yield min(stretch, left)
        left -= stretch


def _settled_to(flow: Flow, returns: Returns, known: list[Orbit]) -> Orbit | None:
    """Return the orbit that a motion has come to; those that are found on the way become known.

    Chaos comes near to itself too, and mostly in vain; so it is asked for first unless that was very near.
    """
    course = returns.course
    near = _recurrences(course, sizes_of(course))
    if near and (min(apart for *_, apart in near) <= CLOSELY or not returns.chaotic):
        known += _recurring(flow, course)
    return next((each for each in reversed(known) if has_arrived(each, course)), None)


def _at_events(flow: Flow, course: Course) -> Reals:
    """Return the states of a motion where something happens, and at its end, (rows, n)."""
    return np.vstack([course.log.state[1:, : flow.size], course.end.state])


def _rest_after(flow: Flow, course: Course, unit: float) -> Rest | None:
    """Return the rest that a motion has come to, or to which its slips lead; None if there is none.

    Raises:
        DivergingMotionError: if all stands still, but for an integral that cannot change it.
    """
    fading = rest_dying_away(flow, course)
    # Where friction bears just what it can, rounding makes it slip and stick without end.
    if fading is not None or course.ending not in (Ending.REACHED_END, Ending.CHATTERING):
        return fading
    if runs_on(flow, course.end):
        raise DivergingMotionError(
            "it diverges: an integral of a controller runs on for ever, and what it could move sticks"
        )
    limit = asymptotic_rest(flow, course, unit)
    return _rest(flow, course.end) if limit is None and at_rest(course, unit) else limit


def _repeating(found: Solved) -> Orbit | None:
    return found.orbit if found.kind is MotionKind.PERIODIC else None


def _rest(flow: Flow, instant: Instant) -> Rest:
    """Return the rest that a motion has come to; in closed form where that is known."""
    motion = linear_motion(flow, instant)
    if motion is None:
        return Rest(flow, instant, family=False)
    return Rest(flow, motion.limit, motion.free)


def at_rest(course: Course, unit: float) -> bool:
    """Return whether a motion has come to rest at its end.

    Args:
        course: The motion.
        unit: A time in which it would move, s.
    """
    layout = course.modes.system.layout
    states = np.vstack([course.log.state[:, : layout.state_count], course.end.state])
    sizes = layout.lengths * abs(states).max(axis=0)
    for kind in layout.kinds:
        sizes[kind] = sizes[kind].max(initial=0.0)
    flow = course.modes[course.modes.number(course.end.statuses)].flow
    extended = np.concatenate([course.end.state, layout.forcing_at(course.end.phase)])
    rates = layout.lengths * abs((flow @ extended)[: layout.state_count]) * unit
    speeds = layout.lengths * abs(course.end.state) * unit
    for rate in layout.rates:
        displacement = layout.kinds[0]
        sizes[rate] = 2 * np.pi * sizes[displacement] / unit
        # A frame that moves along does not make what moves rest.
        rates[displacement] = np.maximum(rates[displacement], speeds[rate])
    return bool((rates <= RESTING * sizes).all())


def _recurring(flow: Flow, course: Course) -> list[Orbit]:
    """Return the orbits that recurrences of a motion lead to, up to the first that is stable."""
    sizes = sizes_of(course)
    found: list[Orbit] = []
    for first, last, _ in _recurrences(course, sizes):
        log = course.log
        begin = log.start[first]
        middle = begin + 0.5 * (log.start[first + 1] - begin)
        state = course.states(np.array([middle]))[0, : flow.size]
        statuses = course.modes[int(log.mode[first])].statuses
        quiet = replace(
            course.end,
            statuses=statuses,
            zeros=np.zeros_like(course.end.zeros),
        )
        duration = float(log.start[last] - begin)
        shot = solve(Return(flow, 0), flow.at(state, like=quiet), duration, FROM_NEARBY)
        if shot is not None and shot.miss <= CLOSED and not _stands_still(shot, sizes):
            found.append(orbit_of(flow, _once(flow, shot), 0))
            if found[-1].stable:
                break
    return found


def _stands_still(shot: Shot, sizes: Reals) -> bool:
    """Say whether a motion is a rest that Newton's method came to, beside the sizes of what it began with."""
    states = np.vstack([shot.course.log.state[:, : len(sizes)], shot.course.nodes.states[:, : len(sizes)]])
    return bool((np.ptp(states, axis=0) <= RESTING * sizes).all()) or at_rest(shot.course, shot.duration)


def _once(flow: Flow, shot: Shot) -> Shot:
    """Return a motion that repeats over its smallest period."""
    course = shot.course
    for count in range(len(course.events), 1, -1):
        if len(course.events) % count:
            continue
        (state,) = course.states(np.array([course.duration / count]))
        if (abs(state[: flow.size] - course.begin.state) > SAME * shot.sizes).any():
            continue
        shorter = solve(Return(flow, 0), course.begin, course.duration / count)
        if shorter is not None and shorter.miss <= CLOSED and not at_rest(shorter.course, shorter.duration):
            return shorter
    return shot


def _recurrences(course: Course, sizes: Reals) -> list[tuple[int, int, float]]:
    """Return pairs of rows at which an event left nearly the same state, and how near, late ones first."""
    log, count, happened = course.log, len(sizes), what_happened(course.log)
    left = MOST_ROWS
    alike = happened & np.append(np.diff(log.start) > 0, False)
    found = []
    for last in np.flatnonzero(alike)[::-1]:
        before = slice(max(last - left, 0), last)
        same = alike[before] & (log.mode[before] == log.mode[last]) & (log.part[before] == log.part[last])
        earlier = before.start + np.flatnonzero(same & (log.kind[before] == log.kind[last]))
        apart = abs((log.state[earlier, :count] - log.state[last, :count]) / sizes).max(axis=1, initial=0.0)
        near = earlier[apart < min(NEAR, CLOSE * apart.min(initial=np.inf) + SAME)]
        if len(near):
            found.append((int(near[-1]), int(last), float(apart.min())))
            left -= int(last - near[-1])
        if len(found) == MOST_TRIED or left <= 0:
            break
    return found
