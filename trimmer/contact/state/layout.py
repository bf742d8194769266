"""Names and places in the extended state of a mechanism, and its ends as functionals of it.

It holds displacements q and velocities v of the coordinates, the springs z of relaxing contacts, sine and
cosine of each order of the drive, each profile and its rate, the time if a pin that something leans on moves
on for ever, and one.
Displacements are those in a frame, which may move.
"""

from __future__ import annotations

from collections.abc import Iterator, Mapping
from dataclasses import dataclass, fields, replace
from functools import cached_property

import numpy as np

from trimmer.arrays import Complexes, Places, Reals
from trimmer.contact.controllers.held import Held, held_by
from trimmer.contact.controllers.laws import laws_of
from trimmer.contact.state.frame import SAME, Frame, frame_of, leans
from trimmer.contact.state.profiles import SOON, Profile
from trimmer.contact.state.references import profile_of, references_in
from trimmer.mechanism.controls.references import RampReference, SineReference, StepReference
from trimmer.mechanism.coordinates import Inertia, inertia_of, radius_of, shaken_ends, weights_of_ends
from trimmer.mechanism.drives import Drives, drive_frequency, drives_of, sines_in, waves_in, waves_of_sine
from trimmer.mechanism.kinds import Kind, kind_of_part
from trimmer.mechanism.mechanism import Mechanism
from trimmer.mechanism.parts import ContactLaw, Force, Pin, Play, Stop
from trimmer.mechanism.waves import mean_of

SMALLEST_SHARE = 1e-4
"""Share of the largest displacement, velocity or stretch below which none is measured by itself."""
STILL = 1e-1  # Share of a displacement, or of its rate at the frequency of the motion, that counts as rest


@dataclass(frozen=True, eq=False)
class Layout:
    """Names and places in the extended state."""

    coordinates: tuple[str, ...]  # Names of the coordinates
    contacts: tuple[str, ...]  # Names of plays and stops that exert a force
    frictions: tuple[str, ...]  # Names of the frictions that exert a force
    curves: tuple[tuple[str, str], ...]  # Section and name of the parts with a curve
    walls: tuple[str, ...]  # Names of the walls
    relaxing: tuple[str, ...]  # Names of those contacts whose z is a state
    controllers: tuple[str, ...]  # Names of the continuous controllers
    # Name of the controller and of the state, of each state of controllers
    controls: tuple[tuple[str, str], ...]
    held: Mapping[str, Held]  # What each sampled controller holds, by name
    # Multiples of the drive's frequency that occur; not whole where other drives give them
    orders: tuple[float, ...]
    drives: Drives  # What drives it beside that
    # Profiles of forces and references that occur; entries are the value of each and its rate
    profiles: tuple[Profile, ...]
    ramp: bool  # Whether the time is an entry
    omega: float  # Angular frequency of the drive, rad/s; 0 without one
    ends: tuple[str, ...]  # Names of the ends
    # Displacements of the ends as functionals, (ends, N), without the share of a ramp that nothing leans on
    end_rows: Reals
    # Those ends whose accelerations are told: the coordinates, and in place of modes their points
    shaken: tuple[str, ...]
    frame: Frame  # That in which displacements are
    # By name, how fast each end moves on beyond what its functional says, m/s: with the frame, or as a pin
    # that nothing leans on
    speeds: Mapping[str, float]
    # By which states are multiplied to be compared with others, (n,): 1, and of what turns a length, m
    lengths: Reals

    @cached_property
    def state_count(self) -> int:
        """Number of states: displacements, velocities, relaxing springs, those of controllers."""
        return max((each.end for each in self.held.values()), default=self.first_control + len(self.controls))

    @property
    def holding(self) -> slice:
        """The states that sampled controllers hold."""
        return slice(self.first_control + len(self.controls), self.state_count)

    @cached_property
    def first_control(self) -> int:
        """Place of the first state of a controller."""
        return 2 * len(self.coordinates) + len(self.relaxing)

    @cached_property
    def size(self) -> int:
        """Number of entries of the extended state."""
        return self.state_count + 2 * len(self.orders) + 2 * len(self.profiles) + int(self.ramp) + 1

    @cached_property
    def period(self) -> float:
        """Period of the drive, s; 0 without one."""
        return 2 * np.pi / self.omega if self.omega else 0.0

    @cached_property
    def forcing(self) -> int:
        """Number of entries that force the states and are not forced by them."""
        return self.size - self.state_count

    @cached_property
    def kinds(self) -> tuple[slice, ...]:
        """The states of one kind each: displacements, velocities."""
        count = len(self.coordinates)
        return slice(0, count), slice(count, 2 * count)

    @property
    def rates(self) -> tuple[slice, ...]:
        """Those kinds that are rates of others."""
        return self.kinds[1:]

    @property
    def measured_between(self) -> bool:
        """What is small at all events is small."""
        return False

    @property
    def independent(self) -> Places:
        """Each state may be disturbed by itself."""
        return np.arange(self.state_count)

    @property
    def travels(self) -> bool:
        """Whether the frame moves."""
        return self.frame.follows or bool(self.frame.velocities.any())

    @property
    def drifts(self) -> bool:
        """Whether each period is forced in a way of its own."""
        return self.ramp or bool(self.profiles) or self.recurrence != 1

    @property
    def recurrence(self) -> int:
        """Periods after which all drives return together; 0 if they do not."""
        return self.drives.periods

    def clock(self, periods: int, phase: float) -> float:
        """Return the time that waves count, s, at a phase, s, after some periods."""
        return phase if self.recurrence == 1 else periods * self.period + phase

    @cached_property
    def breaks(self) -> tuple[float, ...]:
        """Times of all points of profiles, s, rising."""
        return tuple(sorted({time for profile in self.profiles for time in profile.times}))

    def changes_after(self, time: float) -> bool:
        """Say whether something else than waves forces the states differently after a time, s."""
        slopes = any(profile.slope for profile in self.profiles)
        return self.ramp or slopes or any(each > time + SOON * abs(self.breaks[-1]) for each in self.breaks)

    @cached_property
    def steady(self) -> Reals:
        """The entries that force the states without waves, once nothing else changes, (forcing,)."""
        values = np.zeros(self.forcing)
        values[-1] = 1.0
        for profile in self.profiles:
            values[self.profile(profile) - self.state_count] = profile.points[-1][1]
        return values

    def profile(self, profile: Profile) -> int:
        """Return the place of the value of a profile; its rate follows."""
        return self.state_count + 2 * len(self.orders) + 2 * self.profiles.index(profile)

    @cached_property
    def phasors(self) -> Complexes:
        """The entries that force the states as real parts of these times exp(i order omega t)."""
        found = np.zeros((len(self.orders), self.forcing), dtype=complex)
        for place in range(len(self.orders)):
            found[place, 2 * place : 2 * place + 2] = -1j, 1.0
        return found

    def weights(self, end: str) -> Reals:
        """Return what weighs the coordinates in the displacement of an end, (coordinates,)."""
        weights: Reals = self.end_rows[self.ends.index(end), : len(self.coordinates)]
        return weights

    def felt(self, distances: Reals) -> Reals:
        """Return distances, (n, columns), without shifts of what leaders lead, where the frame follows."""
        return self.frame.reduced(distances.T).T if self.frame.follows else distances

    def sizes(self, states: Reals, duration: float) -> Reals:
        """Return the scale of each state over a motion, (n,).

        Where bodies may be shifted without a change of any force, it is that beside their leader. What is
        much smaller than the others of its kind is measured by a share of theirs, and what does not move at
        all by 1.

        Args:
            states: At instants of the motion, (instants, n).
            duration: s.
        """
        sizes: Reals = self.lengths * abs(self.frame.reduced(states)).max(axis=0)
        displacements, velocities = self.kinds
        rate = 2 * np.pi / duration
        longest = max(
            sizes[displacements].max(initial=0.0), STILL * sizes[velocities].max(initial=0.0) / rate
        )
        fastest = max(sizes[velocities].max(initial=0.0), STILL * longest * rate)
        scale = np.full(len(sizes), longest)
        scale[velocities] = fastest
        sizes = np.maximum(sizes, SMALLEST_SHARE * scale)
        held = abs(states[:, self.holding]).max(axis=0)  # In units of their own.
        sizes[self.holding] = np.maximum(held, SMALLEST_SHARE * held.max(initial=0.0))
        sizes[sizes == 0.0] = 1.0
        return sizes / self.lengths

    def is_alike(self, other: Layout) -> bool:
        """Say whether another mechanism has the same states, in the same frame, with the same drive."""
        here, there = (
            {**vars(each), "frame": None, "end_rows": None, "lengths": None} for each in (self, other)
        )
        names = [each.name for each in fields(self)]
        return (
            all(here[name] == there[name] for name in names)
            and np.array_equal(self.end_rows, other.end_rows)
            and self.frame.is_alike(other.frame)
        )

    def sine(self, order: float) -> int:
        """Return the place of the sine of an order; its cosine follows."""
        return self.state_count + 2 * self.orders.index(order)

    def forcing_at(self, time: float, before: float = 0.0) -> Reals:
        """Return the entries that force the states, (forcing,).

        Args:
            time: s.
            before: Whole drive periods that were before, s, which do not count for waves of the drive alone.
        """
        values = np.ones(self.forcing)
        for place, order in enumerate(self.orders):
            angle = order * self.omega * (time if self.recurrence == 1 else before + time)
            values[2 * place : 2 * place + 2] = np.sin(angle), np.cos(angle)
        for profile in self.profiles:
            place = self.profile(profile) - self.state_count
            values[place : place + 2] = profile.along(before + time)
        if self.ramp:
            values[-2] = before + time
        return values


def layout_of(
    mechanism: Mechanism,
    contacts: Mapping[str, Play | Stop],
    frictions: tuple[str, ...],
    frame: Frame | None = None,
) -> Layout:
    """Return the layout of a mechanism with some contacts and frictions that exert forces.

    Args:
        mechanism: The mechanism.
        contacts: Its plays and stops that exert forces.
        frictions: Names of its frictions that do.
        frame: In which displacements are; that of the ground if not given.
    """
    frame = frame_of(mechanism).fixed() if frame is None else frame
    omega = 2 * np.pi * (drive_frequency(mechanism) or 0.0)
    moved: list[Pin | Force] = [*mechanism.pins.values(), *mechanism.forces.values()]
    waves = [wave for part in moved for wave in waves_in(mechanism, part)]
    waves += [wave for name in sines_in(mechanism) for wave in waves_of_sine(mechanism, name)]
    orders = sorted({wave.order for wave in waves})
    speeds = {name: float(each @ frame.velocities) for name, each in weights_of_ends(mechanism).items()}
    for name, pin in mechanism.pins.items():
        speeds[name] += pin.velocity
    ramp = any(
        abs(speeds[part.between[1]] - speeds[part.between[0]]) > SAME * max(map(abs, speeds.values()))
        for part in (*mechanism.links.values(), *contacts.values(), *mechanism.walls.values())
        if leans(part)
    )
    relaxing = tuple(
        name for name, part in contacts.items() if part.law is ContactLaw.RELAXING and part.damping > 0
    )
    laws = laws_of(mechanism)
    layout = Layout(
        mechanism.coordinates,
        tuple(contacts),
        frictions,
        curves_of(mechanism),
        tuple(mechanism.walls),
        relaxing,
        tuple(laws),
        tuple((name, state) for name, law in laws.items() for state in law.names),
        {},
        tuple(orders),
        drives_of(mechanism),
        tuple(dict.fromkeys(_profiles(mechanism, frame))),
        ramp,
        omega,
        tuple(speeds),
        np.array([]),
        shaken_ends(mechanism),
        frame,
        dict.fromkeys(speeds, 0.0) if ramp else speeds,
        np.array([]),
    )
    layout = replace(layout, held=held_by(mechanism.controllers, layout.state_count))
    layout = replace(layout, lengths=_lengths(mechanism, contacts, layout))
    rows = Rows(mechanism, layout)
    return replace(layout, end_rows=np.array([rows.displacement(name) for name in layout.ends]))


def curves_of(mechanism: Mechanism) -> tuple[tuple[str, str], ...]:
    """Return section and name of the parts of a mechanism that have a curve."""
    found = ((section, getattr(mechanism, section)) for section in ("links", "frictions"))
    return tuple((section, name) for section, parts in found for name, part in parts.items() if part.curve)


def _profiles(mechanism: Mechanism, frame: Frame) -> Iterator[Profile]:
    """Yield what forces the states by times."""
    yield from (Profile(force.profile) for force in mechanism.forces.values() if force.profile)
    yield from (found for each in references_in(mechanism) if (found := profile_of(each, frame)) is not None)


def _lengths(mechanism: Mechanism, contacts: Mapping[str, Play | Stop], layout: Layout) -> Reals:
    radius, kinds = radius_of(mechanism), mechanism.kinds
    of = {kind: radius if kind is Kind.ROTATION else 1.0 for kind in Kind}
    coordinates = [of[kinds[name]] for name in mechanism.coordinates]
    springs = [of[kind_of_part(kinds, "plays", name, contacts[name])] for name in layout.relaxing]
    return np.array(
        [
            *coordinates,
            *coordinates,
            *springs,
            *(1.0 for _ in range(layout.first_control, layout.state_count)),
        ]
    )


@dataclass(frozen=True, eq=False)
class Rows:
    """Displacements and velocities of ends as functionals of the extended state, and what forces on them do.

    Nothing else turns the name of an end into rows; what kinds of ends there are,
    ``trimmer.mechanism.coordinates`` alone knows, apart from the share of a pin that is prescribed.
    """

    mechanism: Mechanism
    layout: Layout

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
        """Return the displacement of an end, (N,)."""
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
        """Return the velocity of an end, (N,)."""
        row, weights = np.zeros(self.layout.size), self.weights(end)
        row[len(weights) : 2 * len(weights)] = weights
        if end in self.mechanism.pins:
            pin = self.mechanism.pins[end]
            row[-1] += pin.velocity
            for order, amplitude, phase in waves_in(self.mechanism, pin):
                rate = order * self.layout.omega * amplitude
                self._add_wave(row, order, rate, phase + np.pi / 2)
        return row

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
