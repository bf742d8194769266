"""What follows an event, as far as the statuses decide it: their change, and what is zero at first."""

from __future__ import annotations

from typing import TYPE_CHECKING

from trimmer.contact.curves import beyond_knot
from trimmer.contact.statuses import (
    ABOVE_KNOT,
    BACKWARD,
    BELOW_KNOT,
    BROKEN,
    CONTACT_BROKEN,
    CONTACT_MADE,
    FORWARD,
    FREE,
    LEFT,
    MADE_MINUS,
    MADE_PLUS,
    MINUS,
    PLUS,
    PULLS,
    RELAXES,
    RELAXING,
    RELEASED_MINUS,
    RELEASED_PLUS,
    RETURNED,
    STICK,
)
from trimmer.hybrid.system import ARRIVED, AT_LIMIT, HOLD_BEGUN, HOLD_ENDED, JOINTLY, NOTHING, Transition

if TYPE_CHECKING:
    from trimmer.contact.machine import Machine
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
    if function.action not in (ARRIVED, AT_LIMIT):
        return _of_contact(machine, statuses, function, jumped)
    contacts = len(machine.stiffness)
    others = [
        part
        for part in range(contacts, contacts + len(machine.kinetic))
        if part != function.owner and statuses[part] == STICK
    ]
    if function.action == ARRIVED:
        return None if others else Transition(_with(statuses, function.owner, STICK), HOLD_BEGUN)
    if function.owner == JOINTLY:
        return None
    friction = function.owner - contacts
    drops = machine.static[friction] > machine.kinetic[friction]
    if others and (drops or jumped):
        return None
    direction = FORWARD if function.signs[friction] > 0 else BACKWARD
    zeros = 1 if drops or jumped else 2
    return Transition(_with(statuses, function.owner, direction), HOLD_ENDED, ((ARRIVED, zeros),))


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
        return Transition(after, CONTACT_MADE, ((BROKEN, 1),))
    if function.action == LEFT:
        return Transition(_with(statuses, contact, FREE), NOTHING, ((same_side, 1),))
    if pulls:
        return Transition(_with(statuses, contact, FREE), CONTACT_BROKEN, ((same_side, 1),))
    if machine.law[contact] == RELAXES:
        # The slot opens with no rate where the force has fallen to zero, but not where it is a pull at once.
        zeros = 1 if jumped else 2
        return Transition(_with(statuses, contact, RELAXING), CONTACT_BROKEN, ((same_side, zeros),))
    released = RELEASED_PLUS if status == PLUS else RELEASED_MINUS
    return Transition(_with(statuses, contact, released), CONTACT_BROKEN, ((RETURNED, 1),))
