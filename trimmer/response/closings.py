"""How contacts of a machine that switches close: when, after how many touches, how hard, with which force."""

from __future__ import annotations

from collections.abc import Iterable, Mapping
from dataclasses import dataclass
from typing import TYPE_CHECKING

import numpy as np

from trimmer.motion.part import TOUCHING

if TYPE_CHECKING:
    from trimmer.motion.course import Course
    from trimmer.motion.flow import Flow
    from trimmer.response.motion import MechanismEvent

TOUCHES = frozenset(("contact-made", "impact"))
"""Words of the events at which the sides of a contact meet."""


@dataclass(frozen=True)
class Closing:
    """How a contact closes in a motion.

    Attributes:
        closing_time: When its sides first meet, s.
        touches: How often they meet.
        bounce_time: From the first to the last time, s; 0 if they meet once.
        impact_speed: Largest speed at which they meet, m/s.
        closed: Whether they touch at the end.
        force: At the end, N, positive where it pulls the ends together: the closing force.
    """

    closing_time: float
    touches: int
    bounce_time: float
    impact_speed: float
    closed: bool
    force: float


def closings(flow: Flow, course: Course, events: Iterable[MechanismEvent]) -> Mapping[str, Closing]:
    """Return how the contacts close whose sides meet in a motion, by their names."""
    events = tuple(events)
    forces = flow.forces(course, np.array([course.duration]))
    found = {}
    for part, status in zip(flow.parts, course.end.statuses, strict=False):
        met = [each for each in events if each.part == part.name and each.kind.word in TOUCHES]
        if met and part.touches:
            found[part.name] = Closing(
                met[0].time,
                len(met),
                met[-1].time - met[0].time,
                max(each.speed for each in met),
                status in part.statuses(*TOUCHING),
                float(forces[part.name][0]),
            )
    return found
