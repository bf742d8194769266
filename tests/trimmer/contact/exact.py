"""The exact engine's motion in the words of the brute force."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

from tests.mechanisms.brute_force import Event, EventKind
from trimmer.contact.flow import Course, ExactFlow
from trimmer.contact.statuses import CONTACT_BROKEN, CONTACT_MADE, REVERSED, STICK_BEGUN, STICK_ENDED
from trimmer.mechanism.mechanism import Mechanism

KINDS = {
    CONTACT_MADE: EventKind.CONTACT_MADE,
    CONTACT_BROKEN: EventKind.CONTACT_BROKEN,
    REVERSED: EventKind.SLIDING_REVERSED,
    STICK_BEGUN: EventKind.STICK_BEGUN,
    STICK_ENDED: EventKind.STICK_ENDED,
}


@dataclass(frozen=True)
class ExactMotion:
    """A motion from the mechanism's own start."""

    flow: ExactFlow
    course: Course

    @property
    def events(self) -> list[Event]:
        layout = self.flow.modes.layout
        names = (*layout.contacts, *layout.frictions)
        return [Event(time, names[part], KINDS[kind]) for time, part, kind in self.course.events]

    def states(self, times: np.ndarray) -> np.ndarray:
        """Displacements, velocities and z, one row per time."""
        return self.course.states(np.asarray(times, dtype=float))[:, : self.flow.size]


def exact_motion(mechanism: Mechanism, duration: float) -> ExactMotion:
    """Return the motion over a duration, s."""
    flow = ExactFlow(mechanism)
    return ExactMotion(flow, flow.timed(flow.rest(), duration))
