"""Orbits of a motion without a drive, from where it nearly comes again to a state: the period is unknown.

From such a recurrence Newton's method solves for state and period. The orbit begins in the middle of a
segment, where nothing happens.
"""

import numpy as np

from trimmer.arrays import Reals
from trimmer.motion.course import Course
from trimmer.motion.flow import Flow
from trimmer.one_orbit import SAME
from trimmer.response.by_itself.arrival import what_happened
from trimmer.response.periodic.orbit import Orbit, orbit_of
from trimmer.response.periodic.shooting import Patience, Return, Shot, returned, sizes_of
from trimmer.response.without_events.rest import RESTING, at_rest

NEAR = 0.1  # Distance of two states as a share of their sizes at which Newton's method is tried
CLOSE = 10.0
"""Factor of the least distance up to which states count as one: what has settled comes back closest."""
MOST_ROWS = 1500
"""Segments of all recurrences that are tried in a stretch: Newton's method follows each many times."""
MOST_TRIED = 6  # Recurrences that are tried in each stretch, nearest in time first
FROM_NEARBY = Patience(iterations=20, halvings=4, followed=2)
"""How long an orbit is looked for from a recurrence: a chaotic motion has many near which there is none."""


def recurring(flow: Flow, course: Course) -> list[Orbit]:
    """Return the orbits that recurrences of a motion lead to, up to the first that is stable."""
    sizes = sizes_of(course)
    found: list[Orbit] = []
    for first, last, _ in recurrences(course):
        start = course.log.start
        begin = start[first]
        amid = course.instant(float(begin + 0.5 * (start[first + 1] - begin)))
        duration = float(start[last] - begin)
        shot = returned(Return(flow, 0), flow.at(amid.state, like=amid), duration, FROM_NEARBY)
        if shot is not None and not _stands_still(shot, sizes):
            found.append(orbit_of(flow, once(flow, shot), 0))
            if found[-1].stable:
                break
    return found


def _stands_still(shot: Shot, sizes: Reals) -> bool:
    """Say whether a motion is a rest that Newton's method came to, beside the sizes of what it began with."""
    states = np.vstack([shot.course.log.state[:, : len(sizes)], shot.course.nodes.states[:, : len(sizes)]])
    return bool((np.ptp(states, axis=0) <= RESTING * sizes).all()) or at_rest(shot.course, shot.duration)


def once(flow: Flow, shot: Shot) -> Shot:
    """Return a motion that repeats over its smallest period."""
    course = shot.course
    for count in range(len(course.events), 1, -1):
        if len(course.events) % count:
            continue
        (state,) = course.states(np.array([course.duration / count]))
        apart = abs(state[: flow.size] - course.begin.state) > SAME * shot.sizes
        if apart.any() or not shot.goes_on_alike(course.duration / count):
            continue
        shorter = returned(Return(flow, 0), course.begin, course.duration / count)
        if shorter is not None and not at_rest(shorter.course, shorter.duration):
            return shorter
    return shot


def recurrences(course: Course) -> list[tuple[int, int, float]]:
    """Return pairs of rows at which an event left nearly the same state, and how near, late ones first."""
    log, sizes, happened = course.log, sizes_of(course), what_happened(course.log)
    count, left = len(sizes), MOST_ROWS
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
