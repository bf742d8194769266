"""What outputs, bodies, contacts and frictions do over a motion: integrals and extremes exact to rounding."""

from __future__ import annotations

from dataclasses import dataclass
from functools import cached_property
from typing import TYPE_CHECKING

import numpy as np

from trimmer.contact.assembly import PUSHING
from trimmer.contact.statuses import CONTACT_MADE, STICK
from trimmer.hybrid.system import NOTHING
from trimmer.response.extremes import extremes
from trimmer.response.fourier import fourier
from trimmer.response.motion_signals import (
    acceleration,
    along,
    contact_force,
    durations,
    output_rows,
    output_speeds,
    steady,
    while_status,
)

if TYPE_CHECKING:
    from collections.abc import Mapping

    from trimmer.arrays import Complexes, Reals
    from trimmer.contact.flow import Course, ExactFlow

HARMONICS = 20
"""Number of harmonics of the drive that are given."""


@dataclass(frozen=True, eq=False)
class OutputMeasures:
    """What an output does, m.

    Attributes:
        smallest, largest: Its extremes.
        mean: Mean over the motion.
        rms: Root of the mean square about the mean.
        amplitudes: Complex amplitudes at p/k of the drive, p = 1, 2, ...: real part of c exp(i p w t / k).
        period_count: k.
        advance: Shift over the motion, m, which was taken off evenly before all this was measured.
    """

    smallest: float
    largest: float
    mean: float
    rms: float
    amplitudes: Complexes
    period_count: int
    advance: float = 0.0

    @property
    def peak_to_peak(self) -> float:
        """Largest less smallest."""
        return self.largest - self.smallest

    @property
    def harmonics(self) -> Reals:
        """Amplitudes a_n of a_n cos(n w t + phase) at the multiples of the drive, n = 1, 2, ..."""
        return np.abs(self.amplitudes[self.period_count - 1 :: self.period_count])

    @property
    def phases(self) -> Reals:
        """Their phases, rad."""
        return np.angle(self.amplitudes[self.period_count - 1 :: self.period_count])

    @property
    def subharmonics(self) -> Reals:
        """Amplitudes at 1/k ... (k-1)/k of the drive."""
        return np.abs(self.amplitudes[: self.period_count - 1])

    @property
    def lines(self) -> list[tuple[int, int, float]]:
        """p, k and amplitude of all lines at p/k of the drive."""
        sizes = np.abs(self.amplitudes).tolist()
        return [(place + 1, self.period_count, size) for place, size in enumerate(sizes)]


@dataclass(frozen=True)
class ContactMeasures:
    """What a play or a stop does.

    Attributes:
        impacts: Number of contacts made per drive period, the mean.
        impact_speeds: Relative speed just before each contact of the motion, m/s, in their order.
        largest_force: Largest modulus of its force, N.
        share: Share of the time in contact.
    """

    impacts: float
    impact_speeds: tuple[float, ...]
    largest_force: float
    share: float

    @property
    def impact_speed(self) -> float:
        """The largest of the speeds, m/s; 0 without impact."""
        return max(self.impact_speeds, default=0.0)


@dataclass(frozen=True)
class FrictionMeasures:
    """What a dry friction does.

    Attributes:
        work: Lost to it per drive period, the mean, J; without its viscous part.
        power: Mean power lost to it, W: what wears it.
        stick: Share of the time in stick.
    """

    work: float
    power: float
    stick: float


@dataclass(frozen=True, eq=False)
class Measures:
    """Measures of a motion, each computed when it is asked for.

    Attributes:
        course: The motion, over whole drive periods, or without a drive over one period of its own.
        flow: The motion of the mechanism.
        period_count: Number k of drive periods after which it returns; 1 for a window of one that does not.
        periods: Number of drive periods it spans.
    """

    course: Course
    flow: ExactFlow
    period_count: int
    periods: int

    @cached_property
    def outputs(self) -> Mapping[str, OutputMeasures]:
        """Of each output."""
        rows = output_rows(self.flow.mechanism, self.course.modes.system.layout)
        if not rows:
            return {}
        nodes, duration = self.course.nodes, self.course.duration
        signals = nodes.states @ np.array(list(rows.values())).T
        means = nodes.weights @ signals / duration
        apart = signals - means
        rms = np.sqrt(nodes.weights @ apart**2 / duration)
        count = self.period_count
        speeds = output_speeds(self.flow.mechanism, self.course.modes.system.layout)
        omega = 2 * np.pi * self.periods / (duration * count)
        amplitudes = fourier(self.course, apart, omega, HARMONICS * count)
        return {
            name: OutputMeasures(
                *extremes(self.course, steady(row)),
                float(means[place]),
                float(rms[place]),
                amplitudes[:, place],
                count,
                speeds[name] * duration,
            )
            for place, (name, row) in enumerate(rows.items())
        }

    @cached_property
    def peak_to_peak(self) -> Mapping[str, float]:
        """Of each output, m, without the rest of its measures."""
        rows = output_rows(self.flow.mechanism, self.course.modes.system.layout)
        ranges = {name: extremes(self.course, steady(row)) for name, row in rows.items()}
        return {name: largest - smallest for name, (smallest, largest) in ranges.items()}

    @cached_property
    def rms_acceleration(self) -> Mapping[str, float]:
        """Of each body, m/s²; the acceleration jumps where the force of a contact or a friction does."""
        return {
            name: float(np.sqrt(self._integral(self._at_nodes(body) ** 2) / self.course.duration))
            for body, name in enumerate(self.course.modes.system.layout.bodies)
        }

    def _at_nodes(self, body: int) -> Reals:
        nodes = self.course.nodes
        return along(self.course, acceleration(self.course.modes, body), nodes.rows, nodes.states)

    def _integral(self, values: Reals) -> float:
        return float(self.course.nodes.weights @ values)

    @cached_property
    def contacts(self) -> Mapping[str, ContactMeasures]:
        """Of each play and stop that exerts a force."""
        layout = self.course.modes.system.layout
        return {name: self._contact(part) for part, name in enumerate(layout.contacts)}

    def _contact(self, part: int) -> ContactMeasures:
        course, modes = self.course, self.course.modes
        made = (course.log.part == part) & (course.log.kind == CONTACT_MADE)
        speeds = abs(course.log.state[made] @ modes.system.machine.contact_rate[part])
        touching = while_status(course, part, PUSHING)
        largest = max(abs(each) for each in extremes(course, contact_force(modes, part)))
        return ContactMeasures(
            len(speeds) / self.periods,
            tuple(speeds.tolist()),
            largest,
            float(durations(course)[touching].sum() / course.duration),
        )

    @cached_property
    def frictions(self) -> Mapping[str, FrictionMeasures]:
        """Of each friction that exerts a force."""
        layout = self.course.modes.system.layout
        return {name: self._friction(number) for number, name in enumerate(layout.frictions)}

    def _friction(self, number: int) -> FrictionMeasures:
        course, machine = self.course, self.course.modes.system.machine
        sticking = while_status(course, len(machine.stiffness) + number, (STICK,))
        nodes = course.nodes
        speeds = abs(nodes.states @ machine.friction_rate[number])
        lost = float(machine.kinetic[number]) * self._integral(np.where(sticking[nodes.rows], 0.0, speeds))
        stick = float(durations(course)[sticking].sum() / course.duration)
        return FrictionMeasures(lost / self.periods, lost / course.duration, stick)

    @property
    def events_per_period(self) -> float:
        """Number of events per drive period, the mean."""
        return int((self.course.log.kind != NOTHING).sum()) / self.periods
