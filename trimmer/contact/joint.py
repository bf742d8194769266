"""Several frictions at rest at one instant: which stick, and which begin to slide where.

The relative accelerations follow from a linear complementarity problem,
``trimmer.motion.frictions.dry_friction``. A friction whose static force is greater than its kinetic one
slides against the latter once it slides; then the others are decided again.
"""

from __future__ import annotations

from typing import TYPE_CHECKING

import numpy as np

from trimmer.contact.assembly import flow_without_stick
from trimmer.contact.statuses import ARRIVED, BACKWARD, FORWARD, STICK
from trimmer.motion.frictions.dry_friction import complementary_forces

if TYPE_CHECKING:
    from trimmer.arrays import Places, Reals
    from trimmer.contact.assembly import EventFunction
    from trimmer.contact.machine import Machine

NOISE = 2.0**-49
"""Rounding of an acceleration as a share of the moduli of its terms."""


def after_event(
    machine: Machine,
    statuses: tuple[int, ...],
    state: Reals,
    function: EventFunction,
    jumped: bool,
    at_rest: Places,
) -> tuple[tuple[int, ...], int]:
    """Return what frictions at rest do after a velocity has come to zero, or a limit of stick is reached.

    Args:
        machine: The mechanism.
        statuses: Of all parts before.
        state: The extended state, (N,).
        function: The event function that fell to zero.
        jumped: Whether it was negative at once.
        at_rest: Numbers of the frictions whose velocity is zero.

    Returns:
        The statuses of all parts, and how many derivatives of the velocities vanish that begin.

    Raises:
        ArithmeticError: see ``decide``.
    """
    if function.action == ARRIVED or jumped:
        after = decide(machine, statuses, state, at_rest)
        if function.action == ARRIVED or after != statuses:
            return after, 1
    contacts, decided = len(machine.stiffness), list(statuses)
    sliding = [friction for friction, sign in enumerate(function.signs) if sign]
    for friction in sliding:
        decided[contacts + friction] = FORWARD if function.signs[friction] > 0 else BACKWARD
    if not (machine.static[sliding] > machine.kinetic[sliding]).any():
        return tuple(decided), 2
    return decide(machine, tuple(decided), state, np.setdiff1d(at_rest, sliding)), 1


def decide(machine: Machine, statuses: tuple[int, ...], state: Reals, at_rest: Places) -> tuple[int, ...]:
    """Return the statuses of all parts once the frictions at rest have stuck or begun to slide.

    Args:
        machine: The mechanism.
        statuses: Of all parts; those of the frictions at rest do not count.
        state: The extended state, (N,).
        at_rest: Numbers of the frictions whose velocity is zero, those that stick among them.

    Raises:
        ArithmeticError: if rounding keeps the problem from being solved.
    """
    contacts, decided = len(machine.stiffness), list(statuses)
    left = at_rest
    while len(left):
        directions = _accelerations(machine, tuple(decided), state, left)
        for friction, acceleration in zip(left, directions, strict=True):
            status = STICK if acceleration == 0 else FORWARD if acceleration > 0 else BACKWARD
            decided[contacts + friction] = status
        drops = machine.static[left] > machine.kinetic[left]
        if not (drops & (directions != 0)).any():
            break
        left = left[~(drops & (directions != 0))]
    return tuple(decided)


def _accelerations(machine: Machine, statuses: tuple[int, ...], state: Reals, left: Places) -> Reals:
    """Return the relative accelerations of frictions at rest, zero where they stick."""
    bodies = machine.contact_push.shape[1]
    contacts = len(machine.stiffness)
    sliding = tuple(FORWARD if each == STICK else each for each in statuses[contacts:])
    flow = flow_without_stick(machine, statuses[:contacts] + sliding, left)
    rates, push = machine.friction_rate[left], machine.friction_push[left]
    noise = NOISE * (abs(rates) @ (abs(flow) @ abs(state)))
    limits = machine.static[left]
    _, accelerations = complementary_forces(
        rates[:, bodies : 2 * bodies] @ push.T, rates @ (flow @ state), -limits, limits, noise
    )
    return accelerations
