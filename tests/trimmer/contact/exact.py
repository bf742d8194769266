"""Exact motions in the words of the brute force."""

from dataclasses import dataclass

import numpy as np

from tests.mechanisms.brute_force import Event, EventKind
from trimmer import Mechanism, MechanismMotion, simulate


@dataclass(frozen=True)
class ExactMotion:
    """A motion as ``simulate`` gives it."""

    motion: MechanismMotion

    @property
    def events(self) -> list[Event]:
        known = {each.value for each in EventKind}  # What rests on a wall is not there.
        found = (each for each in self.motion.events if each.kind.value in known)
        return [Event(each.time, each.part, EventKind(each.kind.value)) for each in found]

    def states(self, times: np.ndarray) -> np.ndarray:
        """Displacements, velocities and z, one row per time."""
        return self.motion.states(times).T


def exact_motion(mechanism: Mechanism, duration: float, state: np.ndarray | None = None) -> ExactMotion:
    """Return the motion over a duration, s, from the mechanism's own start or a state."""
    motion = simulate(mechanism, duration, state=state)
    assert motion.success
    return ExactMotion(motion)


def derivative(mechanism: Mechanism, duration: float, state: np.ndarray | None = None) -> np.ndarray:
    """Return the derivative of the state after a duration, s, by that at the start."""
    return simulate(mechanism, duration, state=state).course.monodromy
