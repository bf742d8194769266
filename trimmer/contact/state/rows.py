"""The ends of a mechanism as functionals of its extended state, and what forces on them do."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass, field

import numpy as np

from trimmer.arrays import Reals
from trimmer.contact.state.layout import MechanismLayout
from trimmer.contact.state.profiles import Profile
from trimmer.contact.state.references import profile_of
from trimmer.kept_property import cached_property
from trimmer.mechanism.controls.references import RampReference, SineReference, StepReference
from trimmer.mechanism.coordinates import Inertia, inertia_of, weights_of_ends
from trimmer.mechanism.drives import waves_in, waves_of_sine
from trimmer.mechanism.mechanism import Mechanism
from trimmer.mechanism.parts import Force, Link
from trimmer.mechanism.waves import mean_of


@dataclass(frozen=True, eq=False)
class EndRows:
    """Displacements and velocities of ends as functionals of the extended state, and what forces on them do.

    Nothing else turns the name of an end into rows; what kinds of ends there are,
    ``trimmer.mechanism.coordinates`` alone knows, apart from the share of a pin that is prescribed.
    """

    mechanism: Mechanism
    layout: MechanismLayout
    _velocities: dict[str, Reals] = field(default_factory=dict, init=False)

    @cached_property
    def _weights(self) -> Mapping[str, Reals]:
        return weights_of_ends(self.mechanism)

    @cached_property
    def _inertia(self) -> Inertia:
        return inertia_of(self.mechanism)

    def weights(self, end: str) -> Reals:
        """Return what weighs the coordinates in the displacement of an end, (n,)."""
        return self._weights[end]

    def displacement(self, end: str) -> Reals:
        """Return the displacement of an end, (N,), as the layout has it."""
        row: Reals = self.layout.end_rows[self.layout.ends.index(end)]
        return row

    def displacements(self) -> Reals:
        """Return the displacements of all ends, (ends, N), for a layout that has none yet."""
        found = np.array([self._displacement(name) for name in self.layout.ends])
        found.setflags(write=False)
        return found

    def _displacement(self, end: str) -> Reals:
        row, weights = np.zeros(self.layout.size), self.weights(end)
        row[: len(weights)] = weights
        if self.layout.ramp:
            row[-2] += weights @ self.layout.frame.velocities
        if end in self.mechanism.pins:
            pin = self.mechanism.pins[end]
            row[-1] += mean_of(pin)
            if self.layout.ramp:
                row[-2] += pin.velocity
            for wave in waves_in(self.mechanism, pin):
                self._add_wave(row, *wave)
        return row

    def velocity(self, end: str) -> Reals:
        """Return the velocity of an end, (N,), which is kept."""
        if end not in self._velocities:
            self._velocities[end] = self._velocity(end)
            self._velocities[end].setflags(write=False)
        return self._velocities[end]

    def _velocity(self, end: str) -> Reals:
        row, weights = np.zeros(self.layout.size), self.weights(end)
        row[len(weights) : 2 * len(weights)] = weights
        if end in self.mechanism.pins:
            pin = self.mechanism.pins[end]
            row[-1] += pin.velocity
            for order, amplitude, phase in waves_in(self.mechanism, pin):
                rate = order * self.layout.omega * amplitude
                self._add_wave(row, order, rate, phase + np.pi / 2)
        return row

    def distance(self, between: tuple[str, str]) -> Reals:
        """Return how far the end of a part is beyond its start, (N,)."""
        start, end = between
        return self.displacement(end) - self.displacement(start)

    def speed(self, between: tuple[str, str]) -> Reals:
        """Return the rate of that, (N,)."""
        start, end = between
        return self.velocity(end) - self.velocity(start)

    def tension(self, part: Link) -> Reals:
        """Return the force of a link without its curve, N, positive where it pulls ends together, (N,)."""
        stretch, rate = self.distance(part.between), self.speed(part.between)
        return np.asarray(part.stiffness * stretch + part.damping * rate)

    def _add_wave(self, row: Reals, order: float, amplitude: float, phase: float) -> None:
        """Add amplitude sin(order w t + phase)."""
        sine = self.layout.sine(order)
        row[sine] += amplitude * np.cos(phase)
        row[sine + 1] += amplitude * np.sin(phase)

    def given(self, force: Force) -> Reals:
        """Return a given force, N, (N,)."""
        row = np.zeros(self.layout.size)
        row[-1] += mean_of(force)
        for wave in waves_in(self.mechanism, force):
            self._add_wave(row, *wave)
        if force.profile:
            row[self.layout.profile(Profile(force.profile))] += 1.0
        return row

    def reference(self, name: str | None) -> tuple[Reals, Reals]:
        """Return the value of a reference and its rate, (N,) each; 0 without one."""
        row, rate = np.zeros(self.layout.size), np.zeros(self.layout.size)
        reference = self.mechanism.references[name] if name is not None else None
        profile = None if reference is None else profile_of(reference, self.layout.frame)
        if profile is not None:
            place = self.layout.profile(profile)
            row[place] = rate[place + 1] = 1.0
        elif isinstance(reference, SineReference):
            for order, amplitude, phase in waves_of_sine(self.mechanism, str(name)):
                self._add_wave(row, order, amplitude, phase)
                self._add_wave(rate, order, order * self.layout.omega * amplitude, phase + np.pi / 2)
        elif isinstance(reference, RampReference):
            row[-1], rate[-1] = -reference.ramp * reference.at, reference.ramp
            if self.layout.ramp:
                row[-2] = reference.ramp
        elif isinstance(reference, StepReference):
            row[-1] = reference.step
        return row, rate

    def held(self, name: str) -> Reals:
        """Return what a sampled controller acts with, N or N m, (N,)."""
        row = np.zeros(self.layout.size)
        row[self.layout.held[name].acting] = 1.0
        return row

    def push(self, start: str, end: str) -> Reals:
        """Return the accelerations by 1 N that pushes the end, and its opposite on the start, (n,)."""
        return self.accelerations(self.weights(end) - self.weights(start))

    def accelerations(self, forces: Reals) -> Reals:
        """Return the accelerations by forces on the coordinates, (n,) or (n, columns) each."""
        return self._inertia.accelerations(forces)
