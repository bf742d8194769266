"""Names and places in the extended state of a mechanism.

It holds displacements q and velocities v of the coordinates, the springs z of relaxing contacts, sine and
cosine of each order of the drive, each profile and its rate, the time if a pin that something leans on moves
on for ever, and one.
Displacements are those in a frame, which may move.
"""

from __future__ import annotations

import math
from collections.abc import Mapping
from dataclasses import dataclass, fields

import numpy as np

from trimmer.arrays import Complexes, Places, Reals
from trimmer.contact.controllers.held import Held
from trimmer.contact.state.frame import Frame
from trimmer.contact.state.profiles import SOON, Profile
from trimmer.kept_property import cached_property
from trimmer.mechanism.drives import Drives

SMALLEST_SHARE = 1e-4
"""Share of the largest displacement, velocity or stretch below which none is measured by itself."""
STILL = 1e-1  # Share of a displacement, or of its rate at the frequency of the motion, that counts as rest


@dataclass(frozen=True, eq=False)
class MechanismLayout:
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
        return slice(0, len(self.coordinates)), *self.rates

    @property
    def rates(self) -> tuple[slice, ...]:
        """Those kinds that are rates of others."""
        count = len(self.coordinates)
        return (slice(count, 2 * count),)

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
        longest = max(sizes[displacements].max(), STILL * sizes[velocities].max() / rate)
        fastest = max(sizes[velocities].max(), STILL * longest * rate)
        scale = np.full(len(sizes), longest)
        scale[velocities] = fastest
        sizes = np.maximum(sizes, SMALLEST_SHARE * scale)
        if self.held:
            held = abs(states[:, self.holding]).max(axis=0)  # In units of their own.
            sizes[self.holding] = np.maximum(held, SMALLEST_SHARE * held.max(initial=0.0))
        sizes[sizes == 0.0] = 1.0
        return sizes / self.lengths

    def is_alike(self, other: MechanismLayout) -> bool:
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
        waved = time if self.recurrence == 1 else before + time
        values = [wave(order * self.omega * waved) for order in self.orders for wave in (math.sin, math.cos)]
        for profile in self.profiles:
            values += profile.along(before + time)
        return np.array([*values, before + time, 1.0] if self.ramp else [*values, 1.0])
