"""The frame in which a motion is described: where nothing holds coordinates in place, it moves with them.

There may be directions along which all coordinates can be shifted without a change of any force: bodies that
are joined to each other, but not to the ground, or gears that roll on each other. A motion then repeats up to
such a shift. Each direction has a leader, a coordinate that the others do not move. In a frame that moves
along the directions as the leaders do, it repeats as any other motion does: there the leaders stand still.
Forces feel displacements only as sums that no such shift changes, and velocities stay those in the frame of
the ground, so that nothing else changes.

What leans on a pin with a velocity is carried along by it, if nothing else holds it: there the frame moves at
a velocity that is known beforehand.
"""

from __future__ import annotations

from collections.abc import Iterator, Mapping
from dataclasses import dataclass, replace

import numpy as np

from trimmer.arrays import Integers, Reals
from trimmer.mechanism import ContactLaw, Link, Mechanism, OutputKind, Play, RampReference, Stop, Wall
from trimmer.mechanism.coordinates import rows_of_structures, weights_of_ends
from trimmer.mechanism.elimination import solutions

SAME = 1e-12  # Difference of two velocities, as a share of the largest one, that is taken for rounding


@dataclass(frozen=True, eq=False)
class Frame:
    """How a frame moves at each of n coordinates."""

    leading: Integers  # Numbers of the leaders, one for each of s directions along which nothing holds, (s,)
    # Those directions, (n, s), for a shift of the leader by 1 and of the other leaders by 0
    directions: Reals
    # Constant velocity at each coordinate, m/s, (n,); of a frame that follows, beyond that along the
    # directions
    velocities: Reals
    follows: bool  # Whether the frame moves as the leaders do
    # Whether parts are stretched for ever, since pins move away from each other or from the ground
    pulled: bool

    def reduced(self, states: Reals) -> Reals:
        """Return states, (..., entries), shifted so that leaders are at 0."""
        if not len(self.leading):
            return states
        shifted = states.copy()
        shifted[..., : len(self.directions)] -= states[..., self.leading] @ self.directions.T
        return shifted

    def fixed(self) -> Frame:
        """Return the frame of the ground."""
        return replace(self, velocities=np.zeros_like(self.velocities), follows=False)

    def steady(self, mean: Reals) -> Frame:
        """Return the frame that moves evenly, at the mean velocities of the leaders, out of those of all."""
        led = self.directions @ mean[self.leading]
        return replace(self, velocities=self.velocities + led, follows=False)

    def is_alike(self, other: Frame) -> bool:
        """Say whether another frame moves alike."""
        pairs = (
            (self.leading, other.leading),
            (self.directions, other.directions),
            (self.velocities, other.velocities),
        )
        same = all(np.array_equal(here, there) for here, there in pairs)
        return same and (self.follows, self.pulled) == (other.follows, other.pulled)


def frame_of(mechanism: Mechanism, *, without_stops: bool = False) -> Frame:
    """Return the frame in which motions of a mechanism repeat, if they do.

    Args:
        mechanism: The mechanism.
        without_stops: Whether stops and walls are left out: they hold against one direction alone.
    """
    weights, pins = weights_of_ends(mechanism), mechanism.pins
    between = list(dict.fromkeys(_leaning(mechanism, without_stops)))
    drifts = {name: pins[name].velocity if name in pins else 0.0 for name in weights}
    shifts = [weights[end] - weights[start] for start, end in between]
    drifting = [drifts[start] - drifts[end] for start, end in between]
    strains, measured = list(_strains(mechanism)), list(_measured(mechanism, weights))
    found = solutions(
        np.array([*shifts, *strains, *(row for row, _ in measured)]).reshape(-1, len(mechanism.coordinates)),
        np.array([*drifting, *(0.0 for _ in strains), *(drift for _, drift in measured)]),
    )
    carried = found.particular if found.consistent else np.zeros_like(found.particular)
    return Frame(found.free, found.directions, carried, follows=True, pulled=not found.consistent)


def _leaning(mechanism: Mechanism, without_stops: bool) -> Iterator[tuple[str, str]]:
    """Yield the ends of all parts whose force depends on where these are."""
    parts: list[Link | Play | Stop | Wall] = [*mechanism.links.values(), *mechanism.plays.values()]
    if not without_stops:
        parts += [*mechanism.stops.values(), *mechanism.walls.values()]
    yield from (part.between for part in parts if leans(part))


def _strains(mechanism: Mechanism) -> Iterator[Reals]:
    """Yield what structures resist, as sums of all coordinates."""
    for structure, rows in rows_of_structures(mechanism):
        for strain in structure.strains:
            row = np.zeros(len(mechanism.coordinates))
            row[rows] = strain
            yield row


def _measured(mechanism: Mechanism, weights: Mapping[str, Reals]) -> Iterator[tuple[Reals, float]]:
    """Yield the displacements that controllers feel as sums of coordinates, and how fast these go on."""
    for controller in mechanism.controllers.values():
        for name in (controller.measure, controller.speed):
            output = mechanism.outputs.get(name) if name is not None else None
            if output is None or output.kind is not OutputKind.DISPLACEMENT:
                continue
            carried = {of: mechanism.pins[of].velocity for of in output.weights if of in mechanism.pins}
            drift = -sum(output.weights[of] * velocity for of, velocity in carried.items())
            reference = mechanism.references.get(controller.reference or "")
            if name == controller.measure and isinstance(reference, RampReference):
                drift += reference.ramp
            yield np.asarray(sum(each * weights[of] for of, each in output.weights.items())), drift


def leans(part: Link | Play | Stop | Wall) -> bool:
    """Say whether the force of a part depends on where its ends are, and not on their velocities alone."""
    if isinstance(part, Play) and part.gap == 0 and part.law is not ContactLaw.TRUNCATED:
        return part.stiffness > 0
    if isinstance(part, Wall):
        return True
    if isinstance(part, Link):
        return part.stiffness > 0 or len({force for _, force in part.curve or ()}) > 1
    return part.stiffness > 0 or part.damping > 0
