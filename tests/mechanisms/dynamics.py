"""The motion in one mode of a whole mechanism: rates of the state, guards, forces."""

import math
from dataclasses import dataclass, field
from functools import cached_property
from typing import NamedTuple

import numpy as np
from scipy.linalg import block_diag, eigh

from tests.mechanisms.parts import Contact, ContactMode, Curved, DryFriction, RigidWall
from tests.mechanisms.rows import Rows
from tests.mechanisms.sticking import Sticking, stick_together
from tests.mechanisms.waves import constant
from trimmer.mechanism import Link, Mechanism, Structure

ROUNDING = 1e-14


class Mode(NamedTuple):
    """Modes of all contacts, the sign of each friction's velocity, and the segment of each curve."""

    contacts: tuple[ContactMode, ...]
    frictions: tuple[int, ...]
    curves: tuple[int, ...] = ()


@dataclass(frozen=True)
class Dynamics:
    """y' = rates @ y in one mode."""

    rates: np.ndarray  # D, for all of y
    guards: np.ndarray  # What is not negative as long as the mode lasts, one row each
    friction_forces: np.ndarray  # Rows of the force on ``end`` of each friction
    sticking: Sticking | None  # The frictions that stick, None without any
    sticking_places: list[int]  # Their numbers


def matrices_of(structure: Structure) -> tuple[np.ndarray, np.ndarray, np.ndarray]:
    """Mass, damping and stiffness of a structure."""
    if structure.modes is not None:
        omega = 2 * math.pi * np.array(structure.modes.frequency)
        return np.eye(len(omega)), np.diag(2 * structure.modes.damping_ratio * omega), np.diag(omega**2)
    mass, stiffness = np.array(structure.mass), np.array(structure.stiffness)
    if structure.damping is not None or not structure.damping_ratio:
        given = structure.damping
        return mass, np.zeros_like(mass) if given is None else np.array(given), stiffness
    values, modes = eigh(stiffness, mass)
    twice = 2 * structure.damping_ratio * np.sqrt(np.where(values > 1e-9 * values.max(), values, 0.0))
    return mass, mass @ modes @ np.diag(twice) @ modes.T @ mass, stiffness


@dataclass
class System:
    """A mechanism, and its dynamics in each mode that was met."""

    mechanism: Mechanism
    rows: Rows = field(init=False)
    contacts: tuple[Contact, ...] = field(init=False)
    frictions: tuple[DryFriction, ...] = field(init=False)
    curves: tuple[Curved, ...] = field(init=False)
    walls: tuple[RigidWall, ...] = field(init=False)
    _known: dict[Mode, Dynamics] = field(default_factory=dict)

    def __post_init__(self):
        self.rows = Rows(self.mechanism)
        parts = {**self.mechanism.plays, **self.mechanism.stops}
        self.contacts = tuple(Contact(name, part, self.rows) for name, part in parts.items())
        self.frictions = tuple(
            DryFriction(name, part, self.rows) for name, part in self.mechanism.frictions.items()
        )

        parts = (*self.mechanism.links.values(), *self.mechanism.frictions.values())
        self.curves = tuple(Curved(part, self.rows) for part in parts if part.curve)
        self.walls = tuple(RigidWall(name, wall, self.rows) for name, wall in self.mechanism.walls.items())

    @cached_property
    def matrices(self) -> tuple[np.ndarray, np.ndarray, np.ndarray]:
        """Mass of all, damping and stiffness of structures, from the definition."""
        masses = [body.mass or body.inertia for body in self.mechanism.bodies.values()]
        bodies = (np.diag(masses), *(np.zeros((len(masses),) * 2) for _ in range(2)))
        parts = [matrices_of(structure) for structure in self.mechanism.structures.values()]
        return tuple(block_diag(*each) for each in zip(bodies, *parts, strict=True))

    @property
    def mass(self) -> np.ndarray:
        return self.matrices[0]

    @property
    def masses(self) -> np.ndarray:
        return self.mass.diagonal()

    @property
    def names(self) -> tuple[str, ...]:
        return tuple(part.name for part in (*self.contacts, *self.frictions))

    def dynamics(self, mode: Mode) -> Dynamics:
        if mode not in self._known:
            self._known[mode] = self._derived(mode)
        return self._known[mode]

    def _derived(self, mode: Mode) -> Dynamics:
        force = self._smooth_force()
        for contact, its in zip(self.contacts, mode.contacts, strict=True):
            self._pull(force, contact.part.between, contact.force(its))
        for curve, segment in zip(self.curves, mode.curves, strict=True):
            self._pull(force, curve.part.between, curve.tension(segment))
        rubbing = np.zeros((len(self.frictions), self.rows.size))
        sticking_places = [place for place, sign in enumerate(mode.frictions) if sign == 0]
        for place, (friction, sign) in enumerate(zip(self.frictions, mode.frictions, strict=True)):
            if sign:
                rubbing[place] = friction.sliding_force(sign)
                self._pull(force, friction.part.between, -rubbing[place])
        sticking = self._stick(sticking_places, force) if sticking_places else None
        if sticking is not None:
            rubbing[sticking_places] = sticking.forces
            force += sticking.directions.T @ sticking.forces
        return Dynamics(
            self._rates(mode, force), self._guards(mode, sticking), rubbing, sticking, sticking_places
        )

    def _pull(self, force: np.ndarray, between: tuple[str, str], tension: np.ndarray) -> None:
        """Add a force that pulls two ends together."""
        force -= np.outer(self.rows.direction(between), tension)

    def _smooth_force(self) -> np.ndarray:
        """Rows of the force on each body from links and prescribed forces."""
        force, count = np.zeros((len(self.rows.bodies), self.rows.size)), len(self.rows.bodies)
        _, damping, stiffness = self.matrices
        force[:, :count] -= stiffness
        force[:, count : 2 * count] -= damping
        for link in self.mechanism.links.values():
            stretch, rate = self.rows.distance(link.between), self.rows.rate(link.between)
            self._pull(force, link.between, link.stiffness * stretch + link.damping * rate)
        for given in self.mechanism.forces.values():
            row = self.rows.constant(constant(given)) + self.rows.waves(given)
            force += np.outer(self.rows.weights(given.on), row)
        return force

    def _stick(self, places: list[int], force: np.ndarray) -> Sticking:
        ends = [self.frictions[place].part.between for place in places]
        directions = np.array([self.rows.direction(between) for between in ends])
        prescribed = np.array([self.rows.prescribed_acceleration(between) for between in ends])
        return stick_together(directions, self.mass, force, prescribed)

    def _rates(self, mode: Mode, force: np.ndarray) -> np.ndarray:
        count = len(self.rows.bodies)
        rates = self.rows.clock()
        for body in range(count):
            rates[body] = self.rows.unit(count + body)
        rates[count : 2 * count] = np.linalg.solve(self.mass, force)
        with_state = [
            (part, its) for part, its in zip(self.contacts, mode.contacts, strict=True) if part.has_state
        ]
        for place, (contact, its) in enumerate(with_state):
            rates[2 * count + place] = contact.z_rate(its)
        return rates

    def _guards(self, mode: Mode, sticking: Sticking | None) -> np.ndarray:
        guards: list[np.ndarray] = []
        for contact, its in zip(self.contacts, mode.contacts, strict=True):
            guards += contact.guards(its)
        for curve, segment in zip(self.curves, mode.curves, strict=True):
            guards += curve.guards(segment)
        guards += [-wall.beyond for wall in self.walls]
        for friction, sign in zip(self.frictions, mode.frictions, strict=True):
            if sign:
                guards.append(sign * friction.velocity)
        if sticking is not None:
            limits = [
                f.part.static_force for f, s in zip(self.frictions, mode.frictions, strict=True) if not s
            ]
            for w in sticking.excesses():
                most, held = self.rows.constant(float(np.abs(w) @ limits)), w @ sticking.forces
                size = np.max(np.abs(np.array([most, held])) * self.usual)
                guards += [self._cleaned(most - held, size), self._cleaned(most + held, size)]
        return np.array(guards).reshape(-1, self.rows.size)

    def _cleaned(self, row: np.ndarray, size: float) -> np.ndarray:
        """Return a row without what is only rounding beside the terms that it came from."""
        return np.where(np.abs(row) * self.usual > ROUNDING * size, row, 0.0)

    @cached_property
    def usual(self) -> np.ndarray:
        """A rough size of each entry of y, for what is to count as zero."""
        length, omega = self._length(), self._omega()
        count = len(self.rows.bodies)
        speeds = [abs(v) for _, v in self.mechanism.start.values()]
        speed = max([length * omega, *speeds])
        size = np.ones(self.rows.size)
        size[:count] = size[2 * count : self.rows.state_size] = length
        size[count : 2 * count] = speed
        size[self.rows.state_size + 1] = 1 / omega
        return size

    @property
    def usual_rate(self) -> float:
        """A rough angular frequency, rad/s."""
        return self._omega()

    def _omega(self) -> float:
        if self.rows.omega:
            return self.rows.omega
        stiff = sum(link.stiffness for link in self.mechanism.links.values())
        stiff += sum(contact.part.stiffness for contact in self.contacts)
        return math.sqrt(stiff / float(np.sum(self.masses))) or 1.0

    def _length(self) -> float:
        omega = self._omega()
        lengths = [abs(contact.half_gap) for contact in self.contacts]
        lengths += [abs(wall.part.gap) for wall in self.walls]
        lengths += [abs(x) for curve in self.curves for x in curve.corners if isinstance(curve.part, Link)]
        for pin in self.mechanism.pins.values():
            lengths += [abs(pin.amplitude), abs(pin.offset), abs(pin.velocity) / omega]
        for q, v in self.mechanism.start.values():
            lengths += [abs(q), abs(v) / omega]
        heaviest = float(np.max(self.masses)) * omega**2
        for given in self.mechanism.forces.values():
            lengths += [(abs(given.constant) + abs(given.amplitude)) / heaviest]
        return max(lengths, default=1.0) or 1.0
