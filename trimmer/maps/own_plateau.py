"""One plateau of a sweep of what moves by itself: what it comes to at one value, measured over its period."""

from dataclasses import replace

import numpy as np

from trimmer.errors import DivergingMotionError
from trimmer.hybrid.stretch import Ending, Instant
from trimmer.maps.plateau import Plateau
from trimmer.motion.course import Course
from trimmer.motion.flow import Flow
from trimmer.motion.measures import Measures
from trimmer.motion.time_scale import time_scale
from trimmer.response.by_itself.self_excited import self_excited
from trimmer.response.results.response import MotionKind

FOLLOWED = 200  # Periods of the slowest mode over which is measured what never repeats


def dwell_by_itself(flow: Flow, begin: Instant, periods: int | None) -> tuple[Plateau, Instant]:
    """Go on without a drive; returns what it comes to, measured, and where the motion ends.

    What comes to rest or repeats is measured there, exactly; anything else over the last stretch that was
    followed, which is at least half of the time.

    Args:
        flow: What moves.
        begin: Where it begins.
        periods: Periods of the slowest mode to wait, at most; as many as ``respond`` waits, if not given.
    """
    try:
        found = self_excited(flow, begin, periods)
    except DivergingMotionError:
        return Plateau(MotionKind.DIVERGING, None, 0, {}, {}, 0.0, Ending.DIVERGED), begin
    rest, orbit = found.rest or (found.solved.rest if found.solved is not None else None), found.orbit
    if rest is not None:
        return _plateau(MotionKind.REST, None, rest.flow, rest.course, rest.measures), rest.instant
    if orbit is not None:
        plateau = _plateau(MotionKind.PERIODIC, 1, orbit.flow, orbit.course, orbit.measures)
        return replace(plateau, period=orbit.period), _amid(orbit.course)
    if found.returns is None:  # No event comes any more, and yet it never repeats.
        kind, course = MotionKind.TORUS, flow.timed(begin, FOLLOWED * time_scale(flow, begin))
    else:
        kind = MotionKind.CHAOTIC if found.returns.chaotic else MotionKind.UNDECIDED
        course = found.returns.course
    seen, travelling = flow.travelling(course)
    plateau = _plateau(kind, None, seen, travelling, Measures(travelling, seen, 1, 1))
    outputs = {name: replace(each, amplitudes=each.amplitudes[:0]) for name, each in plateau.outputs.items()}
    return replace(plateau, outputs=outputs), replace(course.end, phase=0.0)


def _amid(course: Course) -> Instant:
    """Return an instant at which as much moves as ever, far from events.

    What sticks to a pin would slip there once the pin has another speed.
    """
    moving = np.array([(course.modes[mode].flow != 0).any(axis=1).sum() for mode in course.met[0].tolist()])
    lasts = np.diff(np.append(course.log.start, course.duration))
    row = np.lexsort((lasts, moving[course.met[1]]))[-1]
    return course.instant(float(course.log.start[row] + 0.5 * lasts[row]))


def _plateau(kind: MotionKind, count: int | None, flow: Flow, course: Course, measures: Measures) -> Plateau:
    speed = float(flow.impact_speeds(course).max(initial=0.0))
    return Plateau(kind, count, 1, measures.outputs, {}, speed, Ending.REACHED_END)
