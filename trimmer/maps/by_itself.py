"""What a cell without a drive settles to: a machine that rests, moves by itself or grows."""

import warnings
from dataclasses import dataclass, replace

import numpy as np

from trimmer.arrays import Reals
from trimmer.errors import DivergingMotionError, OrbitNotFoundWarning
from trimmer.hybrid.stretch import Ending, Instant
from trimmer.hybrid.system import NOTHING
from trimmer.maps.measures import CellMeasures, chosen, of_orbit, of_window
from trimmer.motion.course import Course
from trimmer.motion.flow import Flow
from trimmer.motion.time_scale import time_scale
from trimmer.response.by_itself.orbit_by_itself import as_orbit, orbits_of_loop, state_on
from trimmer.response.by_itself.self_excited import STRETCHES, self_excited
from trimmer.response.periodic.orbit import Orbit
from trimmer.response.results.response import MotionKind

RETURNS = 128  # Returns, at most, over which a motion is measured that does not repeat


@dataclass(frozen=True, eq=False)
class CameTo:
    """What a start without a drive settles to."""

    kind: MotionKind  # What it is
    # The motion over a period, or some returns of what does not repeat; None if it grows
    course: Course | None = None
    returns: int = 1  # Number of these returns; 1 for a period
    orbit: Orbit | None = None  # The orbit, if it repeats
    neutral: bool = False  # Whether others are beside it
    lyapunov: float | None = None  # Largest Lyapunov exponent, 1/s, of what does not repeat


def came_to(flow: Flow, start: Instant, most_periods: int = sum(STRETCHES)) -> CameTo:
    """Return what a start without a drive settles to.

    Args:
        flow: What moves.
        start: Where it begins.
        most_periods: Periods of the slowest mode to wait.

    Raises:
        OrbitNotFoundError: if it cannot be followed.
    """
    try:
        found = self_excited(flow, start, most_periods)
    except DivergingMotionError:
        return CameTo(MotionKind.DIVERGING)
    rest = found.rest or (found.solved.rest if found.solved is not None else None)
    if rest is not None:
        return CameTo(MotionKind.REST, rest.course, neutral=rest.family)
    if found.orbit is not None:
        return CameTo(MotionKind.PERIODIC, found.orbit.course, orbit=found.orbit, neutral=found.orbit.neutral)
    returns = found.returns
    if returns is None or not returns.count:
        return CameTo(MotionKind.UNDECIDED)
    course = flow.timed(returns.course.begin, returns.seen(RETURNS))
    kind = MotionKind.CHAOTIC if returns.chaotic else MotionKind.UNDECIDED
    return CameTo(
        kind,
        course,
        min(returns.count, RETURNS),
        lyapunov=returns.exponent.value if returns.exponent else None,
    )


def came_to_in_loop(flow: Flow) -> tuple[CameTo, ...]:
    """Return all stable orbits that are found of a loop at rest, the largest first; else how motions end.

    With frictions beside it they are what these orbits lead to. It rests, or grows, if all simulations of the
    search ended so, and is undecided if they differ, or there were none beside an unstable orbit.

    Raises:
        OrbitNotFoundError: if an orbit that was found cannot be followed.
    """
    with warnings.catch_warnings():
        warnings.simplefilter("ignore", OrbitNotFoundWarning)  # A simulation looks for what is near no guess.
        found = orbits_of_loop(flow.subject)
    stable = [each for each in found if each.stable]
    if stable and getattr(flow.subject, "frictions", None):
        return tuple(came_to(flow, flow.at(state_on(flow, each))) for each in stable)
    orbits = [as_orbit(flow, each) for each in stable]
    if orbits:
        return tuple(
            CameTo(MotionKind.PERIODIC, each.course, orbit=each, neutral=each.neutral) for each in orbits
        )
    ends = found.search.simulations
    if ends is not None and ends.at_rest == ends.starts:
        return (CameTo(MotionKind.REST, flow.timed(flow.rest(), time_scale(flow, flow.rest()))),)
    grows = ends is not None and ends.diverged == ends.starts
    return (CameTo(MotionKind.DIVERGING if grows else MotionKind.UNDECIDED),)


def measured(flow: Flow, found: CameTo, keys: tuple[str, ...]) -> CellMeasures | None:
    """Return the measures of a motion over one period of its own, or over returns, with further ones."""
    if found.course is None or found.course.ending is not Ending.REACHED_END:
        return None
    course, count, rests = found.course, found.returns, found.kind is MotionKind.REST
    own = of_orbit(flow, course, 1, rests=rests) if count == 1 else of_window(flow, course, count)
    return replace(own, chosen=chosen(flow, course, 1, count, keys, rests=rests)) if keys else own


def begins_alike(flow: Flow, course: Course) -> Reals:
    """Return a state of an orbit that does not depend on where it was begun, (n,)."""
    log = course.log
    states = log.state[log.kind != NOTHING] if (log.kind != NOTHING).any() else log.state
    states = flow.reduced(states[:, : flow.size])
    sizes = abs(states).max(axis=0)
    weights = np.sqrt(2.0 + np.arange(flow.size)) / np.where(sizes > 0, sizes, 1.0)
    return np.asarray(states[np.argmin(states @ weights)])
