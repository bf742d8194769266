"""Rest that a motion comes to ever slower, without a last event: its velocity falls to zero, and not beyond.

A friction slides to where the integral of a controller leads, and both die away together. In numbers the
velocity becomes rounding at last, whose sign says stick or slip as it happens. So what comes is told from the
last segments while it is still large, some times of decay after they began: if what ends the mode falls along
the slowest real rate, and all else is smaller, it never ends.
"""

from collections.abc import Iterator

import numpy as np

from trimmer.motion.course import Course
from trimmer.motion.flow import Flow
from trimmer.response.without_events.linear_motion import LinearMotion, linear_motion
from trimmer.response.without_events.rest import Rest

SEGMENTS = 3  # Last segments of a motion that are looked at
SHARES = (0.5, 0.75)  # Shares of their durations at which they are
SLOW = 0.1  # Share of the swing of each state that it may move between these, where a segment may die away
DECAYS = (2.0, 4.0, 8.0, 16.0)  # Times of the slowest decay after which a longer segment is looked at too


def rest_dying_away(flow: Flow, course: Course) -> Rest | None:
    """Return the rest to which one of the last segments of a motion leads for ever; None if none does.

    Args:
        flow: What moves.
        course: Its motion, without a drive.
    """
    log = course.log
    lasted = np.diff(np.append(log.start, course.duration))
    swings = np.ptp(log.state[:, : flow.size], axis=0)
    for row in np.flatnonzero(lasted > 0)[: -1 - SEGMENTS : -1]:
        early, late = (float(log.start[row] + share * lasted[row]) for share in SHARES)
        states = [course.instant(time).state for time in (early, late)]
        if (abs(states[1] - states[0]) > SLOW * swings).any():
            continue
        for motion in _seen(flow, course, float(log.start[row]), early, late):
            if motion.still and motion.dies_away:
                return Rest(flow, flow.at(motion.limit.state), motion.free)
    return None


def _seen(flow: Flow, course: Course, start: float, early: float, late: float) -> Iterator[LinearMotion]:
    """Yield a segment's motion as if no event came, from two times, s, on, and from times of decay."""
    first = _from(flow, course, early)
    if first is None:
        return
    yield first
    for time in (late, *(start + decays / first.slowest for decays in DECAYS)):
        motion = _from(flow, course, time) if time <= late else None
        if motion is not None:
            yield motion


def _from(flow: Flow, course: Course, time: float) -> LinearMotion | None:
    """Return the motion from a time on, s, as if no event came; None if it grows, or is not told by that."""
    here = course.instant(time)
    return linear_motion(flow, flow.at(here.state, course.end.phase, like=here))
