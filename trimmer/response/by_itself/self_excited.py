"""What a mechanism that moves by itself comes to: it is followed, ever longer, until that is known."""

from collections.abc import Iterator
from dataclasses import dataclass, replace

import numpy as np

from trimmer.arrays import Reals
from trimmer.errors import DivergingMotionError, OrbitNotFoundError
from trimmer.hybrid.stretch import Ending, Instant
from trimmer.motion.course import Course
from trimmer.motion.flow import Flow
from trimmer.motion.time_scale import time_scale
from trimmer.response.by_itself.arrival import approaches, has_arrived
from trimmer.response.by_itself.asymptotic import asymptotic_rest, runs_on
from trimmer.response.by_itself.dying_away import rest_dying_away
from trimmer.response.by_itself.recurrences import recurrences, recurring
from trimmer.response.by_itself.returns import Returns
from trimmer.response.by_itself.slowing_down import slowing_down
from trimmer.response.periodic.orbit import Orbit
from trimmer.response.results.response import MotionKind, SlowingDown
from trimmer.response.settling.solved import Solved, solved
from trimmer.response.statistics.growth import grew, nears_event, state_sizes
from trimmer.response.without_events.linear_motion import grows_for_ever, linear_motion
from trimmer.response.without_events.rest import Rest, at_rest

STRETCHES = (20, 80, 320, 1280)
"""Lengths of the motion that is searched for a recurrence, in periods of the slowest mode."""
FURTHER = (5120, 20480)
"""Those that follow where little has happened until then, if no number of periods is given."""
LITTLE = 2000  # Events that are little for so long a time
CLOSELY = 1e-7
"""Distance of two states as a share of their sizes at which a recurrence comes before chaos is asked for."""
SURELY = 1000  # Returns of one stretch from which chaos is told; else it is to be seen in two stretches


@dataclass(frozen=True, eq=False)
class SelfExcited:
    """What a motion without a drive comes to; nothing where it was not seen."""

    waited: float  # How long it was followed, s
    orbit: Orbit | None = None  # The orbit that it settles to
    rest: Rest | None = None  # Where it rests
    solved: Solved | None = None  # What it comes to, if no event comes any more
    passed: Orbit | None = None  # An unstable orbit that it passes
    unit: float = 0.0  # Period of the slowest mode, s, in which ``most_periods`` counts
    returns: Returns | None = None  # The last stretch that was followed, where nothing repeats
    # Whether the orbit was not reached, but came nearer in each period as its multiplier says
    slowly: bool = False
    slowing: SlowingDown | None = None  # How it slows down for ever

    @property
    def cut_short(self) -> bool:
        """Whether it took more steps than are followed."""
        return self.returns is not None and self.returns.course.ending is Ending.STEP_LIMIT


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
        if course.ending not in (Ending.REACHED_END, Ending.STEP_LIMIT):
            raise OrbitNotFoundError(f"the motion cannot be followed: {course.ending.value}")
        happened += len(course.events)
        states = np.vstack([course.log.state[1:, : flow.size], course.end.state])
        reached.append((waited, state_sizes(flow, flow.reduced(states))))
        returns.append(Returns.of(flow, course))
        orbit = _settled_to(flow, returns[-1], known)
        if orbit is not None:
            return SelfExcited(waited, orbit)
        if _is_chaotic(returns) or course.ending is Ending.STEP_LIMIT:
            break
        instant = replace(course.end, phase=0.0)
    slow = next((each for each in known if approaches(each, returns[-1].course)), None)
    if slow is not None:
        return SelfExcited(waited, slow, slowly=True)
    unstable = next((each for each in known if not each.stable and not each.neutral), None)
    last = returns[-1].course
    calm = not last.events
    drifts = calm and nears_event(flow, last.begin, last.end)
    # What nears no event any more has left an orbit that it passed, and what was before, behind.
    if (calm or unstable is None) and not returns[-1].chaotic and not drifts and grew(reached, calm):
        raise DivergingMotionError(
            f"it diverges: until {waited:.6g} s it grew in proportion to the time or faster, and nothing "
            "held it"
        )
    slowing = slowing_down([each.course for each in returns])
    return SelfExcited(waited, passed=unstable, unit=unit, returns=returns[-1], slowing=slowing)


def _without_events(flow: Flow, instant: Instant, waited: float) -> SelfExcited | None:
    """Return what a motion comes to in which no event comes any more; None if one may.

    Raises:
        DivergingMotionError: if it grows for ever.
    """
    at_last = solved(flow, instant)
    if at_last is not None:
        repeats = at_last.kind is MotionKind.PERIODIC
        return SelfExcited(waited, at_last.orbit if repeats else None, at_last.rest, at_last)
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
    near = recurrences(course)
    if near and (min(apart for *_, apart in near) <= CLOSELY or not returns.chaotic):
        known += recurring(flow, course)
    return next((each for each in reversed(known) if has_arrived(each, course)), None)


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


def _rest(flow: Flow, instant: Instant) -> Rest:
    """Return the rest that a motion has come to; in closed form where that is known."""
    motion = linear_motion(flow, instant)
    if motion is None:
        return Rest(flow, instant, family=False)
    return Rest(flow, motion.limit, motion.free)
