"""What an impact on a rigid wall makes of the state."""

from __future__ import annotations

from typing import TYPE_CHECKING

import numpy as np

from trimmer.contact.modes.control_limits import first_control

if TYPE_CHECKING:
    from trimmer.arrays import Reals
    from trimmer.contact.machine.machine import Machine

NEARLY = 2.0**-44  # Share of the moduli of its terms below which a distance or a rate is zero


def first_wall(machine: Machine) -> int:
    """Return the place of the status of the first wall: behind those of all others."""
    return first_control(machine) + len(machine.control_limit)


def impulse_of(machine: Machine, wall: int, restitution: float) -> Reals:
    """Return what an impact makes of the state, (N, N)."""
    bodies = machine.contact_push.shape[1]
    push, rate = machine.wall_push[wall], machine.wall_rate[wall]
    reset = np.eye(len(rate))
    reset[bodies : 2 * bodies] -= np.outer(
        push, (1.0 + restitution) / (rate[bodies : 2 * bodies] @ push) * rate
    )
    return reset


def at_gap(machine: Machine, wall: int, state: Reals) -> Reals:
    """Return a state with the ends of a wall no farther apart than its gap."""
    bodies, push = machine.contact_push.shape[1], machine.wall_push[wall]
    beyond = machine.wall_distance[wall] @ state
    if beyond <= NEARLY * (abs(machine.wall_distance[wall]) @ abs(state)):
        return state
    moved = state.copy()
    moved[:bodies] -= push * (beyond / (machine.wall_distance[wall, :bodies] @ push))
    return moved
