"""A mechanism or loop at rest: where all stands still, and what each part bears there."""

import math
from collections.abc import Mapping
from dataclasses import dataclass, replace
from functools import cached_property

import numpy as np

from trimmer.arrays import ROUNDING, Reals
from trimmer.hybrid.stretch import Ending, Instant
from trimmer.motion.course import Course
from trimmer.motion.flow import Flow
from trimmer.motion.measures import Measures

SAMPLES = 64  # Instants in the period of the fastest wave at which forces are taken
RESTING = 1e-9
"""Share of its size by which a state that is at rest changes at most in a period of the slowest mode."""


def stands(flow: Flow) -> bool:
    """Say whether nothing moves at all where all states rest: no wave of a drive, and no pin that goes on."""
    goes_on = any(pin.velocity for pin in getattr(flow.subject, "pins", {}).values())
    return not flow.modes.system.layout.orders and not goes_on


@dataclass(frozen=True, eq=False)
class Rest:
    """A mechanism or loop at rest.

    Attributes:
        flow: What rests.
        instant: Where it rests.
        family: Whether it is one of many places side by side, as where friction or a gap lets a body stay
            wherever it stopped: the digits then belong to the start.
        asymptotic: Whether it is the limit of slips that become smaller for ever, and is never reached.
    """

    flow: Flow
    instant: Instant
    family: bool
    asymptotic: bool = False

    @cached_property
    def course(self) -> Course:
        """The motion, in which nothing moves, over a drive period; over 1 s without a drive."""
        course = self.flow.timed(self.instant, self.flow.period or 1.0)
        if course.ending is Ending.REACHED_END or self.flow.period:
            return course
        # Friction bears just what it can, so that rounding says at each instant whether it holds.
        row = course.log.first(1)
        return replace(course, end=self.instant, ending=Ending.REACHED_END, duration=1.0, log=row)

    @cached_property
    def measures(self) -> Measures:
        """What outputs, bodies, contacts and frictions do there."""
        return Measures(self.course, self.flow, 1, 1, still=stands(self.flow))

    @property
    def positions(self) -> Mapping[str, float]:
        """Displacement of each body, m; of a loop what is read of it."""
        return self.flow.positions(self.course)

    @cached_property
    def forces(self) -> Mapping[str, float]:
        """Force of each link, play, stop and friction, N, positive where it pulls its ends together.

        Where a drive pushes what friction holds, forces change; they are means over its period then. Forces
        of frictions that hold the same bodies are shared as by ``MechanismMotion.friction_force``. Of a loop
        they are the outputs of its elements.
        """
        return {name: float(force.mean()) for name, force in self._over_a_period.items()}

    @cached_property
    def forces_change(self) -> bool:
        """Whether some force changes with the drive."""
        return any(np.ptp(force) > 1e-12 * abs(force).max() for force in self._over_a_period.values())

    @cached_property
    def _over_a_period(self) -> Mapping[str, Reals]:
        count = (
            SAMPLES * math.ceil(max(self.flow.modes.system.layout.orders, default=1))
            if self.flow.period and not stands(self.flow)
            else 1
        )
        return self.flow.forces(self.course, self.course.duration * np.arange(count) / count)


def at_rest(course: Course, unit: float) -> bool:
    """Return whether a motion has come to rest at its end.

    Args:
        course: The motion.
        unit: A time in which it would move, s.
    """
    layout = course.modes.system.layout
    states = np.vstack([course.log.state[:, : layout.state_count], course.end.state])
    sizes = layout.lengths * abs(states).max(axis=0)
    for kind in layout.kinds:
        sizes[kind] = sizes[kind].max(initial=0.0)
    flow = course.modes[course.modes.number(course.end.statuses)].flow
    extended = np.concatenate([course.end.state, layout.forcing_at(course.end.phase)])
    rounding = ROUNDING * (abs(flow) @ abs(extended))
    changes = abs(flow @ extended)
    rates = layout.lengths * np.where(changes > rounding, changes, 0.0)[: layout.state_count] * unit
    speeds = layout.lengths * abs(course.end.state) * unit
    for rate in layout.rates:
        displacement = layout.kinds[0]
        sizes[rate] = 2 * np.pi * sizes[displacement] / unit
        # A frame that moves along does not make what moves rest.
        rates[displacement] = np.maximum(rates[displacement], speeds[rate])
    return bool((rates <= RESTING * sizes).all())
