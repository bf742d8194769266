"""Whether a mechanism is its own mirror image half a drive period later."""

from __future__ import annotations

from trimmer.mechanism.mechanism import Mechanism


def is_mirror_symmetric(mechanism: Mechanism) -> bool:
    """Say whether with x(t) also -x(t + T/2) is a motion, T the period of the drive.

    Plays and frictions act on both sides alike; stops do not, nor do constant forces, offsets and velocities
    of pins, and even orders.
    """
    pins, forces = mechanism.pins.values(), mechanism.forces.values()
    shifted = any(pin.offset != 0.0 or pin.velocity != 0.0 for pin in pins)
    pushed = any(force.constant != 0.0 for force in forces)
    orders = [pin.order for pin in pins] + [force.order for force in forces]
    even = any(order % 2 == 0 for order in orders)
    return not (mechanism.stops or shifted or pushed or even)
