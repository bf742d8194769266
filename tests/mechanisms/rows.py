"""Quantities of a mechanism as rows: each is linear in the state and in a few functions of time.

Everything that the brute force speaks of (a distance, a velocity, a force) is ``row @ y`` with

    y = (displacements, velocities, z of each relaxing contact with damping, 1, t, sin and cos of each order).

The functions of time are carried along as entries of y, so a row may be differentiated: with y' = D y the
rate of ``row @ y`` is ``row @ D @ y``.
"""

import math
from dataclasses import dataclass, field
from functools import cached_property

import numpy as np

from tests.mechanisms.waves import constant, waves_in
from trimmer import ContactLaw, Force, Mechanism, Pin


@dataclass
class Rows:
    """The layout of y for one mechanism, and rows of its points."""

    mechanism: Mechanism
    bodies: tuple[str, ...] = field(init=False)
    relaxing: tuple[str, ...] = field(init=False)
    orders: tuple[int, ...] = field(init=False)

    def __post_init__(self):
        mechanism = self.mechanism
        self.bodies = tuple(mechanism.coordinates)
        contacts = {**mechanism.plays, **mechanism.stops}
        self.relaxing = tuple(
            name for name, part in contacts.items() if part.law is ContactLaw.RELAXING and part.damping > 0
        )
        parts = (*mechanism.pins.values(), *mechanism.forces.values())
        self.orders = tuple(sorted({order for part in parts for order, *_ in waves_in(self.mechanism, part)}))

    @cached_property
    def omega(self) -> float:
        """That of the drive, rad/s; 0 without a drive."""
        return 2 * math.pi * (self.mechanism.frequency or 0.0)

    @cached_property
    def state_size(self) -> int:
        return 2 * len(self.bodies) + len(self.relaxing)

    @cached_property
    def size(self) -> int:
        return self.state_size + 2 + 2 * len(self.orders)

    def unit(self, place: int) -> np.ndarray:
        row = np.zeros(self.size)
        row[place] = 1.0
        return row

    def constant(self, value: float) -> np.ndarray:
        return value * self.unit(self.state_size)

    def z(self, name: str) -> np.ndarray:
        return self.unit(2 * len(self.bodies) + self.relaxing.index(name))

    def sine(self, amplitude: float, order: int, phase: float) -> np.ndarray:
        """amplitude sin(order omega t + phase)."""
        row = np.zeros(self.size)
        if amplitude:
            place = self.state_size + 2 + 2 * self.orders.index(order)
            row[place : place + 2] = amplitude * math.cos(phase), amplitude * math.sin(phase)
        return row

    def waves(self, part: Pin | Force) -> np.ndarray:
        found = (self.sine(size, order, phase) for order, size, phase in waves_in(self.mechanism, part))
        return sum(found, np.zeros(self.size))

    def clock(self) -> np.ndarray:
        """D for the functions of time: their rates, the rest zero."""
        rates = np.zeros((self.size, self.size))
        first = self.state_size
        rates[first + 1, first] = 1.0
        for place, order in enumerate(self.orders):
            sine = first + 2 + 2 * place
            rates[sine, sine + 1], rates[sine + 1, sine] = order * self.omega, -order * self.omega
        return rates

    def functions_of_time(self, t: np.ndarray | float) -> np.ndarray:
        """(1, t, sin, cos, ...) at a time, or as columns at several."""
        if isinstance(t, float):
            angles = [order * self.omega * t for order in self.orders]
            return np.array([1.0, t, *(f(angle) for angle in angles for f in (math.sin, math.cos))])
        t = np.asarray(t, dtype=float)
        functions = np.ones((self.size - self.state_size, *t.shape))
        functions[1] = t
        for place, order in enumerate(self.orders):
            angle = order * self.omega * t
            functions[2 + 2 * place], functions[3 + 2 * place] = np.sin(angle), np.cos(angle)
        return functions

    def weights(self, end: str) -> np.ndarray:
        """What weighs the bodies in the displacement of an end, and shares a force on it among them."""
        if end in self.mechanism.pins:
            end = self.mechanism.pins[end].on
        if end in self.mechanism.points:
            weights = self.mechanism.points[end].weights
            return np.array([weights.get(body, 0.0) for body in self.bodies])
        structure, _, point = end.partition(".")
        if structure in self.mechanism.structures and (model := self.mechanism.structures[structure].modes):
            shape = dict(enumerate(model.shapes.get(point, ()), 1))
            ends = {f"{structure}.mode{number}": float(each) for number, each in shape.items()}
            return np.array([ends.get(body, float(body == end)) for body in self.bodies])
        return np.array([float(body == end) for body in self.bodies])

    def moved(self, end: str, first: int) -> np.ndarray:
        row = np.zeros(self.size)
        row[first : first + len(self.bodies)] = self.weights(end)
        return row

    def prescribed(self, end: str) -> np.ndarray:
        """Displacement of a pin relative to its carrier; zero for a body."""
        if end not in self.mechanism.pins:
            return np.zeros(self.size)
        pin = self.mechanism.pins[end]
        row = self.constant(constant(pin)) + self.waves(pin)
        row[self.state_size + 1] += pin.velocity
        return row

    def displacement(self, end: str) -> np.ndarray:
        return self.prescribed(end) + self.moved(end, 0)

    def velocity(self, end: str) -> np.ndarray:
        return self.prescribed(end) @ self.clock() + self.moved(end, len(self.bodies))

    def distance(self, between: tuple[str, str]) -> np.ndarray:
        start, end = between
        return self.displacement(end) - self.displacement(start)

    def rate(self, between: tuple[str, str]) -> np.ndarray:
        start, end = between
        return self.velocity(end) - self.velocity(start)

    def prescribed_acceleration(self, between: tuple[str, str]) -> np.ndarray:
        """That part of the relative acceleration that is a function of time."""
        start, end = between
        clock = self.clock()
        return (self.prescribed(end) - self.prescribed(start)) @ clock @ clock

    def direction(self, between: tuple[str, str]) -> np.ndarray:
        """Generalised force of a unit force on ``end`` and its opposite on ``start``."""
        start, end = between
        return self.weights(end) - self.weights(start)
