"""The frame in which a motion is described: where nothing holds bodies in place, it moves along with them.

Bodies that are joined by parts which feel where their ends are, and that no such part joins to the ground,
may be shifted together: no force changes. A motion then repeats up to such a shift. In a frame that moves as
one body of each such group, its leader, it repeats as any other motion does: there the leader stands still,
and the others are where they are beside it. Forces feel displacements only as differences within a group,
and velocities stay those in the frame of the ground, so that nothing else changes.

What leans on a pin with a velocity is carried along by it, if nothing else holds it: there the frame moves at
a velocity that is known beforehand.
"""

from __future__ import annotations

from collections import deque
from dataclasses import dataclass, replace
from functools import cached_property

import numpy as np

from trimmer.arrays import Integers, Reals
from trimmer.mechanism.mechanism import Mechanism
from trimmer.mechanism.parts import GROUND, ContactLaw, Link, Play, Stop

HELD = -1
"""In place of a leader: the ground holds a body in place."""
SAME = 1e-12
"""Difference of two velocities, as a share of the largest one, that is taken for rounding."""


@dataclass(frozen=True, eq=False)
class Frame:
    """How a frame moves at each of n bodies.

    Attributes:
        leaders: Number of the body with which each may be shifted, ``HELD`` where the ground holds it, (n,).
        velocities: Constant velocity at each body, m/s, (n,); of a frame that follows, beyond its leader's.
        follows: Whether the frame moves as the leaders do.
        pulled: Whether parts are stretched for ever, since pins move away from each other or from the ground.
    """

    leaders: Integers
    velocities: Reals
    follows: bool
    pulled: bool

    @cached_property
    def leading(self) -> Integers:
        """Numbers of the leaders, one for each direction in which bodies may be shifted."""
        return np.unique(self.leaders[self.leaders != HELD])

    def reduced(self, states: Reals) -> Reals:
        """Return states, (..., entries), shifted so that leaders are at 0."""
        if not len(self.leading):
            return states
        shifted = states.copy()
        shifted[..., : len(self.leaders)] -= np.where(
            self.leaders == HELD, 0.0, states[..., np.maximum(self.leaders, 0)]
        )
        return shifted

    def fixed(self) -> Frame:
        """Return the frame of the ground."""
        return replace(self, velocities=np.zeros_like(self.velocities), follows=False)

    def steady(self, mean: Reals) -> Frame:
        """Return the frame that moves evenly, at the mean velocities of the leaders, out of those of all."""
        led = np.where(self.leaders == HELD, 0.0, mean[np.maximum(self.leaders, 0)])
        return replace(self, velocities=self.velocities + led, follows=False)


def frame_of(mechanism: Mechanism, *, without_stops: bool = False) -> Frame:
    """Return the frame in which motions of a mechanism repeat, if they do.

    Args:
        mechanism: The mechanism.
        without_stops: Whether stops are left out: they hold against one direction alone.
    """
    names = mechanism.coordinates
    joints: dict[str, list[tuple[str, float]]] = {name: [] for name in (GROUND, *names)}
    stops = () if without_stops else mechanism.stops.values()
    for part in (*mechanism.links.values(), *mechanism.plays.values(), *stops):
        if leans(part):
            (start, ahead), (end, behind) = (_carried(mechanism, each) for each in part.between)
            joints[start].append((end, ahead - behind))
            joints[end].append((start, behind - ahead))
    velocities: dict[str, float] = {}
    leaders: dict[str, str] = {}
    for first in joints:
        if first in velocities:
            continue
        velocities[first], waiting = 0.0, deque([first])
        while waiting:
            body = waiting.popleft()
            leaders[body] = first
            for other, faster in joints[body]:
                if other not in velocities:
                    velocities[other] = velocities[body] + faster
                    waiting.append(other)
    allowed = SAME * max((abs(pin.velocity) for pin in mechanism.pins.values()), default=0.0)
    pulled = any(
        abs(velocities[body] + faster - velocities[other]) > allowed
        for body, others in joints.items()
        for other, faster in others
    )
    held = {GROUND: HELD, **{name: number for number, name in enumerate(names)}}
    return Frame(
        np.array([held[leaders[name]] for name in names], dtype=np.int64),
        np.array([0.0 if pulled else velocities[name] for name in names]),
        follows=True,
        pulled=pulled,
    )


def leans(part: Link | Play | Stop) -> bool:
    """Say whether the force of a part depends on where its ends are, and not on their velocities alone."""
    if isinstance(part, Play) and part.gap == 0 and part.law is not ContactLaw.TRUNCATED:
        return part.stiffness > 0
    if isinstance(part, Link):
        return part.stiffness > 0
    return part.stiffness > 0 or part.damping > 0


def _carried(mechanism: Mechanism, end: str) -> tuple[str, float]:
    """Return what carries an end, and how fast the end moves away from it, m/s."""
    if end in mechanism.pins:
        pin = mechanism.pins[end]
        return pin.on, pin.velocity
    return end, 0.0
