"""Whether two orbits are one, shifted by whole drive periods, or mirrored twins."""

from __future__ import annotations

from typing import TYPE_CHECKING

import numpy as np

if TYPE_CHECKING:
    from trimmer.arrays import Reals
    from trimmer.mechanism.mechanism import Mechanism
    from trimmer.mechanism.parts import Force, Pin
    from trimmer.response.orbit import MechanismOrbit

SAME = 1e-6
"""Distance of states, as a share of their sizes, below which two orbits are one."""


def same_orbit(orbit: MechanismOrbit, other: MechanismOrbit) -> bool:
    """Return whether one orbit is the other, shifted by whole drive periods."""
    return orbit.periods == other.periods and same_states(orbit.strobed, other.strobed, SAME * orbit.sizes)


def twins(orbit: MechanismOrbit, other: MechanismOrbit) -> bool:
    """Return whether an orbit is the mirror image of another one, half a drive period later."""
    if orbit.periods != other.periods or not is_mirror_symmetric(orbit.mechanism):
        return False
    return same_states(orbit.strobed, mirrored(other), SAME * orbit.sizes)


def keeps_symmetry(orbit: MechanismOrbit) -> bool | None:
    """Return whether an orbit is its own mirror image; None if the mechanism has none."""
    return twins(orbit, orbit) if orbit.periods and is_mirror_symmetric(orbit.mechanism) else None


def mirrored(orbit: MechanismOrbit) -> Reals:
    """Return the strobed states of the mirror image of an orbit, (periods, n)."""
    times = orbit.flow.period * (0.5 + np.arange(orbit.periods, dtype=np.float64))
    return -orbit.course.states(times)[:, : orbit.flow.size]


def is_mirror_symmetric(mechanism: Mechanism) -> bool:
    """Say whether with x(t) also -x(t + T/2) is a motion, T the period of the drive.

    Plays and frictions act on both sides alike; stops do not, nor do constant forces, offsets and velocities
    of pins, and even orders.
    """
    moving: list[Pin | Force] = [*mechanism.pins.values(), *mechanism.forces.values()]
    odd = all(part.order % 2 == 1 for part in moving)
    centred = all(pin.offset == 0 and pin.velocity == 0 for pin in mechanism.pins.values())
    pushed = any(force.constant != 0 for force in mechanism.forces.values())
    return bool(mechanism.frequency) and odd and centred and not pushed and not mechanism.stops


def same_states(ours: Reals, theirs: Reals, allowed: Reals) -> bool:
    """Return whether the states of two orbits agree, wherever in their period they begin.

    Args:
        ours: States at the start of each drive period, (k, n).
        theirs: Those of the other orbit.
        allowed: Difference that is allowed of each state, (n,).
    """
    if ours.shape != theirs.shape:
        return False
    return any(
        bool((abs(np.roll(ours, turns, axis=0) - theirs) <= allowed).all()) for turns in range(len(ours))
    )
