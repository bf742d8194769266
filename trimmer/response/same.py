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
    return orbit.periods == other.periods and _visited(orbit, other.strobed)


def twins(orbit: MechanismOrbit, other: MechanismOrbit) -> bool:
    """Return whether an orbit is the mirror image of another one, half a drive period later."""
    if orbit.periods != other.periods or not is_symmetric(orbit.mechanism):
        return False
    return _visited(orbit, mirrored(other))


def keeps_symmetry(orbit: MechanismOrbit) -> bool | None:
    """Return whether an orbit is its own mirror image; None if the mechanism has none."""
    return twins(orbit, orbit) if orbit.periods and is_symmetric(orbit.mechanism) else None


def mirrored(orbit: MechanismOrbit) -> Reals:
    """Return the strobed states of the mirror image of an orbit, (periods, n)."""
    times = orbit.flow.period * (0.5 + np.arange(orbit.periods, dtype=np.float64))
    return -orbit.course.states(times)[:, : orbit.flow.size]


def is_symmetric(mechanism: Mechanism) -> bool:
    """Return whether with each motion its mirror image, half a drive period later, is a motion too."""
    moving: list[Pin | Force] = [*mechanism.pins.values(), *mechanism.forces.values()]
    odd = all(part.order % 2 == 1 for part in moving)
    centred = all(pin.offset == 0 and pin.velocity == 0 for pin in mechanism.pins.values())
    pushed = any(force.constant != 0 for force in mechanism.forces.values())
    return bool(mechanism.frequency) and odd and centred and not pushed and not mechanism.stops


def _visited(orbit: MechanismOrbit, states: Reals) -> bool:
    apart = abs((states[:, None] - orbit.strobed[None]) / orbit.sizes).max(axis=2)
    shifts = [np.roll(apart, shift, axis=1).diagonal() for shift in range(len(states))]
    return any((each < SAME).all() for each in shifts)
