"""What follows an event, as far as the statuses decide it: their change, and what is zero at first."""

from __future__ import annotations

from typing import TYPE_CHECKING

import numpy as np

from trimmer.contact.machine.statuses import (
    ABOVE_KNOT,
    ABOVE_LIMIT,
    BACKWARD,
    BELOW_KNOT,
    BELOW_LIMIT,
    BROKEN,
    CONTACT_BROKEN,
    CONTACT_MADE,
    FORWARD,
    FREE,
    IMPACT,
    LEFT,
    LOOSE,
    MADE_MINUS,
    MADE_PLUS,
    MINUS,
    PLUS,
    PULLS,
    RELAXES,
    RELAXING,
    RELEASED_MINUS,
    RELEASED_PLUS,
    RESTS,
    RETURNED,
    STICK,
)
from trimmer.contact.modes.control_limits import beyond_limit
from trimmer.contact.modes.curves import beyond_knot
from trimmer.contact.modes.impulses import impulse_of
from trimmer.hybrid.system import (
    ARRIVED,
    AT_LIMIT,
    HOLD_BEGUN,
    HOLD_ENDED,
    JOINTLY,
    NOTHING,
    STRUCK,
    Transition,
)

if TYPE_CHECKING:
    from trimmer.contact.machine.machine import Machine
    from trimmer.hybrid.system import EventFunction


def transition(
    machine: Machine, statuses: tuple[int, ...], function: EventFunction, jumped: bool
) -> Transition | None:
    """Return what follows where an event function of a mode falls to zero.

    Args:
        machine: The mechanism.
        statuses: Those of the mode.
        function: The event function.
        jumped: Whether it is negative at once, because a force has jumped.

    Returns:
        The change, or None where several frictions are at rest and decide it together.
    """
    if function.action in (ABOVE_KNOT, BELOW_KNOT):
        return beyond_knot(statuses, function)
    if function.action in (ABOVE_LIMIT, BELOW_LIMIT):
        return beyond_limit(statuses, function, jumped)
    if function.action == STRUCK:
        return _of_impact(machine, statuses, function, jumped)
    if function.action not in (ARRIVED, AT_LIMIT):
        return _of_contact(machine, statuses, function, jumped)
    contacts = len(machine.stiffness)
    others = function.owner != JOINTLY and has_a_say(machine, statuses, function.owner)
    if function.action == ARRIVED:
        return None if others else Transition(_with(statuses, function.owner, STICK), HOLD_BEGUN)
    if function.owner == JOINTLY:
        return None
    if function.owner >= machine.first_wall:
        if others and jumped:
            return None
        return Transition(_with(statuses, function.owner, LOOSE), HOLD_ENDED, ((STRUCK, 2 if jumped else 3),))
    friction = function.owner - contacts
    drops = machine.static[friction] > machine.kinetic[friction]
    if others and (drops or jumped):
        return None
    direction = FORWARD if function.signs[friction] > 0 else BACKWARD
    zeros = 1 if drops or jumped else 2
    return Transition(_with(statuses, function.owner, direction), HOLD_ENDED, ((ARRIVED, zeros),))


def has_a_say(machine: Machine, statuses: tuple[int, ...], part: int) -> bool:
    """Return whether the force of something else that holds accelerates the ends of a part at once.

    What holds elsewhere feels what the part does only by displacements and velocities, which do not jump.
    """
    held = [other for other in held_parts(machine, statuses) if other != part]
    if not held:
        return False
    holds = machine.holds
    rate = machine.hold_rate[np.searchsorted(holds, part), machine.velocities]
    return bool((machine.hold_push[np.searchsorted(holds, held)] @ rate != 0.0).any())


def held_parts(machine: Machine, statuses: tuple[int, ...]) -> list[int]:
    """Return the parts that hold two ends together: frictions that stick, walls at rest."""
    contacts = len(machine.stiffness)
    sticking = [contacts + k for k, each in enumerate(machine.of_frictions(statuses)) if each == STICK]
    walls = enumerate(machine.of_walls(statuses))
    return sticking + [machine.first_wall + k for k, each in walls if each == RESTS]


def _of_impact(
    machine: Machine, statuses: tuple[int, ...], function: EventFunction, jumped: bool
) -> Transition | None:
    """Return an impact that concerns neither friction nor another wall; None for any other."""
    wall = function.owner - machine.first_wall
    concerned = machine.hold_rate[:, machine.velocities] @ machine.wall_push[wall] != 0.0
    concerned[len(machine.kinetic) :] &= np.array(machine.of_walls(statuses), dtype=int) == RESTS
    if jumped or concerned.any():
        return None
    reset = impulse_of(machine, wall, machine.restitution[wall])
    return Transition(statuses, IMPACT, ((STRUCK, 1),), reset)


def _with(statuses: tuple[int, ...], part: int, status: int) -> tuple[int, ...]:
    return (*statuses[:part], status, *statuses[part + 1 :])


def _of_contact(
    machine: Machine, statuses: tuple[int, ...], function: EventFunction, jumped: bool
) -> Transition:
    contact = function.owner
    status, pulls = statuses[contact], machine.law[contact] == PULLS
    same_side = MADE_PLUS if status in (PLUS, RELEASED_PLUS) else MADE_MINUS
    if function.action in (MADE_PLUS, MADE_MINUS):
        after = _with(statuses, contact, PLUS if function.action == MADE_PLUS else MINUS)
        return Transition(after, CONTACT_MADE, ((BROKEN, 1 if pulls else 0),))
    if function.action == RETURNED:
        after = _with(statuses, contact, PLUS if status == RELEASED_PLUS else MINUS)
        return Transition(after, CONTACT_MADE, ((BROKEN, int(not jumped)),))
    if function.action == LEFT:
        return Transition(_with(statuses, contact, FREE), NOTHING, ((same_side, 1),))
    if pulls:
        return Transition(_with(statuses, contact, FREE), CONTACT_BROKEN, ((same_side, 1),))
    if machine.law[contact] == RELAXES:
        # The slot opens with no rate where the force has fallen to zero, but not where it is a pull at once.
        zeros = 1 if jumped else 2
        return Transition(_with(statuses, contact, RELAXING), CONTACT_BROKEN, ((same_side, zeros),))
    released = RELEASED_PLUS if status == PLUS else RELEASED_MINUS
    return Transition(_with(statuses, contact, released), CONTACT_BROKEN, ((RETURNED, int(not jumped)),))
