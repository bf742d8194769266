"""How contacts of a machine that switches close: when, after how many touches, how hard, with which force."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from typing import TYPE_CHECKING

import numpy as np

from trimmer.motion.part import TOUCHING

if TYPE_CHECKING:
    from trimmer.motion.course import Course
    from trimmer.motion.flow import Flow


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


def closings(
    flow: Flow, course: Course, meetings: Mapping[str, Sequence[tuple[float, float]]]
) -> Mapping[str, Closing]:
    """Return how the contacts close whose sides meet in a motion, by their names.

    Args:
        flow: What moves.
        course: Its motion.
        meetings: By part, time, s, and speed, m/s, of each event at which its sides meet.
    """
    forces = flow.forces(course, np.array([course.duration]))
    found = {}
    for part, status in zip(flow.parts, course.end.statuses, strict=False):
        if part.touches and (met := meetings.get(part.name)):
            found[part.name] = Closing(
                met[0][0],
                len(met),
                met[-1][0] - met[0][0],
                max(speed for _, speed in met),
                status in part.statuses(*TOUCHING),
                float(forces[part.name][0]),
            )
    return found
