"""The modes of one contact and of one friction, with what must hold as long as a mode lasts.

A guard is a row that is not negative while the mode lasts.
"""

from dataclasses import dataclass
from typing import NamedTuple

import numpy as np

from tests.mechanisms.rows import Rows
from trimmer import ContactLaw, Friction, Link, Play, Stop
from trimmer.mechanism import Wall


class ContactMode(NamedTuple):
    """Which side of the slot, +1 or -1, and whether a force passes; the side 0 is free.

    A side without force is a truncated contact that would pull: lifted, though the gap is overcome.
    """

    side: int
    touching: bool


FREE = ContactMode(0, False)


@dataclass(frozen=True)
class Contact:
    """A play or a stop."""

    name: str
    part: Play | Stop
    rows: Rows

    @property
    def sides(self) -> tuple[int, ...]:
        return (1, -1) if isinstance(self.part, Play) else (1,)

    @property
    def half_gap(self) -> float:
        return self.part.gap / 2 if isinstance(self.part, Play) else self.part.gap

    @property
    def has_state(self) -> bool:
        return self.name in self.rows.relaxing

    @property
    def lifts(self) -> bool:
        return self.part.law is ContactLaw.TRUNCATED and self.part.damping > 0

    @property
    def is_link(self) -> bool:
        """Whether it is always in contact: a play without a gap, unless its law lifts it."""
        return isinstance(self.part, Play) and self.part.gap == 0 and not self.lifts

    def beyond(self, side: int) -> np.ndarray:
        """How far the gap is overcome on a side, positive when it is."""
        return side * self.rows.distance(self.part.between) - self.rows.constant(self.half_gap)

    def closed_force(self, side: int) -> np.ndarray:
        """T, were it in contact on a side."""
        rate = self.rows.rate(self.part.between)
        return self.part.stiffness * side * self.beyond(side) + self.part.damping * rate

    def force(self, mode: ContactMode) -> np.ndarray:
        return self.closed_force(mode.side) if mode.touching else np.zeros(self.rows.size)

    def clearance(self, side: int) -> np.ndarray:
        """How far the free contact is from touching on a side."""
        if not self.has_state:
            return -self.beyond(side)
        return side * self.rows.z(self.name) - self.beyond(side)

    def guards(self, mode: ContactMode) -> list[np.ndarray]:
        if mode == FREE:
            return [self.clearance(side) for side in self.sides]
        push = mode.side * self.closed_force(mode.side)
        if self.has_state:
            return [push]
        if not self.lifts:
            return [self.beyond(mode.side)]
        return [self.beyond(mode.side), push if mode.touching else -push]

    def modes(self) -> list[ContactMode]:
        """All modes, those without force first."""
        lifted = [ContactMode(side, False) for side in self.sides] if self.lifts else []
        return [FREE, *lifted, *(ContactMode(side, True) for side in self.sides)]

    def z_rate(self, mode: ContactMode) -> np.ndarray:
        if mode.touching:
            return self.rows.rate(self.part.between)
        return -self.part.stiffness / self.part.damping * self.rows.z(self.name)


@dataclass(frozen=True)
class DryFriction:
    """A friction; its mode is the sign of the velocity, 0 for stick."""

    name: str
    part: Friction
    rows: Rows

    @property
    def velocity(self) -> np.ndarray:
        return self.rows.rate(self.part.between)

    def sliding_force(self, sign: int) -> np.ndarray:
        """The force on ``end``."""
        return -self.rows.constant(sign * self.part.kinetic_force) - self.part.viscous * self.velocity


@dataclass(frozen=True)
class Curved:
    """What a curve adds to a link or a friction; its mode is the segment between two corners."""

    part: Link | Friction
    rows: Rows

    @property
    def over(self) -> np.ndarray:
        of = self.rows.distance if isinstance(self.part, Link) else self.rows.rate
        return of(self.part.between)

    @property
    def points(self) -> list[tuple[float, float]]:
        """Of a friction without its force at rest, for both directions and far beyond the last point."""
        if isinstance(self.part, Link):
            return list(self.part.curve)
        ahead = [(v, force - self.part.kinetic_force) for v, force in self.part.curve]
        ahead.append((ahead[-1][0] + 1.0, ahead[-1][1]))
        return [*((-v, -force) for v, force in ahead[:0:-1]), *ahead]

    @property
    def corners(self) -> list[float]:
        inner = self.points[1:-1]
        return [x for x, _ in inner if isinstance(self.part, Link) or x != 0.0]

    def modes(self) -> range:
        return range(len(self.corners) + 1)

    def guards(self, segment: int) -> list[np.ndarray]:
        below = [self.over - self.rows.constant(x) for x in self.corners[segment - 1 : segment] if segment]
        return below + [self.rows.constant(x) - self.over for x in self.corners[segment : segment + 1]]

    def tension(self, segment: int) -> np.ndarray:
        middle = (self.corners[segment - 1 : segment] if segment else []) + self.corners[
            segment : segment + 1
        ]
        at = sum(middle) / len(middle) if len(middle) == 2 else None
        pairs = list(zip(self.points[:-1], self.points[1:], strict=True))
        chosen = pairs[0] if segment == 0 else pairs[-1]
        if at is not None:
            chosen = next(pair for pair in pairs if pair[0][0] <= at <= pair[1][0])
        (x0, f0), (x1, f1) = chosen
        slope = (f1 - f0) / (x1 - x0)
        return slope * self.over + self.rows.constant(f0 - slope * x0)


@dataclass(frozen=True)
class RigidWall:
    """A rigid wall, as long as nothing rests on it."""

    name: str
    part: Wall
    rows: Rows

    @property
    def beyond(self) -> np.ndarray:
        """How far the ends are farther apart than the gap."""
        return self.rows.distance(self.part.between) - self.rows.constant(self.part.gap)

    @property
    def velocity(self) -> np.ndarray:
        return self.rows.rate(self.part.between)

    def struck(self, state: np.ndarray, y: np.ndarray, mass: np.ndarray) -> np.ndarray:
        """The state after an impact, by Newton's law."""
        direction, count = self.rows.direction(self.part.between), len(mass)
        changed = np.linalg.solve(mass, direction)
        impulse = (1 + self.part.restitution) * float(self.velocity @ y) / float(direction @ changed)
        after = state.copy()
        after[count : 2 * count] -= impulse * changed
        return after
