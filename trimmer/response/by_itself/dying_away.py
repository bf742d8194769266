"""Rest that a motion comes to ever slower, without a last event: its velocity falls to zero, and not beyond.

A friction slides to where the integral of a controller leads, and both die away together. In numbers the
velocity becomes rounding at last, whose sign says stick or slip as it happens. So what comes is told from the
last segment while it is still large: if what ends its mode falls along the slowest real rate, and all else is
smaller, it never ends.
"""

import numpy as np

from trimmer.motion.course import Course
from trimmer.motion.flow import Flow
from trimmer.response.linear_motion import linear_motion
from trimmer.response.rest import Rest

SEGMENTS = 3  # Last segments of a motion that are looked at
SHARES = (0.5, 0.75)  # Shares of their durations at which they are
SLOW = 0.1  # Share of the swing of each state that it may move between these, where a segment may die away


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
        times = log.start[row] + lasted[row] * np.array(SHARES)
        reached = [course.instant(time) for time in times]
        if (np.ptp([each.state for each in reached], axis=0) > SLOW * swings).any():
            continue
        for each in reached:
            motion = linear_motion(flow, flow.at(each.state, course.end.phase, like=each))
            if motion is not None and motion.still and motion.dies_away:
                return Rest(flow, flow.at(motion.limit.state), motion.free)
    return None
