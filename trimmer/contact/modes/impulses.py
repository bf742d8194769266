"""What an impact on a rigid wall makes of the state."""

from __future__ import annotations

from typing import TYPE_CHECKING

import numpy as np

if TYPE_CHECKING:
    from trimmer.arrays import Reals
    from trimmer.contact.machine.machine import Machine

NEARLY = 2.0**-44  # Share of the moduli of its terms below which a distance or a rate is zero


def impulse_of(machine: Machine, wall: int, restitution: float) -> Reals:
    """Return what an impact makes of the state, (N, N)."""
    push, rate, velocities = machine.wall_push[wall], machine.wall_rate[wall], machine.velocities
    reset = np.eye(len(rate))
    reset[velocities] -= np.outer(push, (1.0 + restitution) / (rate[velocities] @ push) * rate)
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
