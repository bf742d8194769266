"""A mechanism at rest: where all bodies stand still, and what each part bears there."""

from __future__ import annotations

from dataclasses import dataclass
from functools import cached_property
from typing import TYPE_CHECKING

import numpy as np

from trimmer.contact.layout import Rows
from trimmer.response.measures import Measures
from trimmer.response.motion import MechanismMotion

if TYPE_CHECKING:
    from collections.abc import Mapping

    from trimmer.arrays import Reals
    from trimmer.contact.flow import Course, ExactFlow
    from trimmer.hybrid.advance import Instant

SAMPLES = 64
"""Instants in the period of the fastest wave at which forces are taken."""


@dataclass(frozen=True, eq=False)
class Rest:
    """A mechanism at rest.

    Attributes:
        flow: The motion of the mechanism.
        instant: Where it rests.
        family: Whether it is one of many places side by side, as where friction or a gap lets a body stay
            wherever it stopped: the digits then belong to the start.
    """

    flow: ExactFlow
    instant: Instant
    family: bool

    @cached_property
    def course(self) -> Course:
        """The motion, in which nothing moves, over a drive period; over 1 s without a drive."""
        return self.flow.timed(self.instant, self.flow.period or 1.0)

    @cached_property
    def measures(self) -> Measures:
        """What outputs, bodies, contacts and frictions do there."""
        return Measures(self.course, self.flow, 1, 1)

    @property
    def positions(self) -> Mapping[str, float]:
        """Displacement of each body, m."""
        bodies = self.flow.modes.system.layout.bodies
        return dict(zip(bodies, self.instant.state[: len(bodies)].tolist(), strict=True))

    @cached_property
    def forces(self) -> Mapping[str, float]:
        """Force of each link, play, stop and friction, N, positive where it pulls its ends together.

        Where a drive pushes what friction holds, forces change; they are means over its period then. Forces
        of frictions that hold the same bodies are shared as by ``MechanismMotion.friction_force``.
        """
        return {name: float(force.mean()) for name, force in self._over_a_period.items()}

    @cached_property
    def forces_change(self) -> bool:
        """Whether some force changes with the drive."""
        return any(np.ptp(force) > 1e-12 * abs(force).max() for force in self._over_a_period.values())

    @cached_property
    def _over_a_period(self) -> Mapping[str, Reals]:
        layout, mechanism = self.flow.modes.system.layout, self.flow.mechanism
        count = SAMPLES * max(layout.orders, default=1) if self.flow.period else 1
        times = self.course.duration * np.arange(count) / count
        motion, states = MechanismMotion(self.flow, self.course), self.course.states(times)
        rows = Rows(mechanism, layout)
        forces = {}
        for name, link in mechanism.links.items():
            forces[name] = _between(rows, link.between, link.stiffness, link.damping, states)
        for name in (*mechanism.plays, *mechanism.stops):
            touches = name in layout.contacts
            forces[name] = motion.contact_force(name, times) if touches else np.zeros(count)
        for name, friction in mechanism.frictions.items():
            forces[name] = _between(rows, friction.between, 0.0, friction.viscous, states)
            if name in layout.frictions:
                forces[name] = forces[name] + motion.friction_force(name, times)
        return forces


def _between(rows: Rows, ends: tuple[str, str], stiffness: float, damping: float, states: Reals) -> Reals:
    """Return the force of a spring and a damper between two ends at extended states, N, (count,)."""
    start, end = ends
    stretch = rows.displacement(end) - rows.displacement(start)
    rate = rows.velocity(end) - rows.velocity(start)
    return np.asarray(states @ (stiffness * stretch + damping * rate))
