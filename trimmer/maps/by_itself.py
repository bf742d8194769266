"""What a cell without a drive settles to: a controlled machine that rests, hunts or grows."""

from __future__ import annotations

from dataclasses import replace
from typing import TYPE_CHECKING

import numpy as np

from trimmer.errors import DivergingMotionError
from trimmer.hybrid.system import NOTHING
from trimmer.maps.measures import Measures, chosen, of_orbit
from trimmer.response.response import MotionKind
from trimmer.response.self_excited import self_excited

if TYPE_CHECKING:
    from trimmer.arrays import Reals
    from trimmer.hybrid.advance import Instant
    from trimmer.motion.course import Course
    from trimmer.motion.flow import Flow
    from trimmer.response.orbit import Orbit


def came_to(flow: Flow, start: Instant) -> tuple[MotionKind, Course | None, Orbit | None, bool]:
    """Return what a start without a drive settles to: kind, motion, orbit, and whether others are beside it.

    Raises:
        OrbitNotFoundError: if it cannot be followed.
    """
    try:
        found = self_excited(flow, start)
    except DivergingMotionError:
        return MotionKind.DIVERGING, None, None, False
    rest = found.rest or (found.solved.rest if found.solved is not None else None)
    if rest is not None:
        return MotionKind.REST, rest.course, None, rest.family
    if found.orbit is not None:
        return MotionKind.PERIODIC, found.orbit.course, found.orbit, found.orbit.neutral
    return MotionKind.UNDECIDED, None, None, False


def measured(flow: Flow, course: Course, keys: tuple[str, ...]) -> Measures:
    """Return the measures of a motion over one period of its own, with further ones."""
    found = of_orbit(flow, course, 1)
    return replace(found, chosen=chosen(flow, course, 1, 1, keys)) if keys else found


def begins_alike(flow: Flow, course: Course) -> Reals:
    """Return a state of an orbit that does not depend on where it was begun, (n,)."""
    log = course.log
    states = log.state[log.kind != NOTHING] if (log.kind != NOTHING).any() else log.state
    states = flow.reduced(states[:, : flow.size])
    sizes = abs(states).max(axis=0)
    weights = np.sqrt(2.0 + np.arange(flow.size)) / np.where(sizes > 0, sizes, 1.0)
    return np.asarray(states[np.argmin(states @ weights)])
