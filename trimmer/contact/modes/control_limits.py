"""What controllers do in a mode, and the events at their limits: sat(w) is w, or the limit of either side."""

from __future__ import annotations

from collections.abc import Iterator
from typing import TYPE_CHECKING

import numpy as np

from trimmer.arrays import Reals
from trimmer.contact.machine.statuses import ABOVE_LIMIT, AT_LOWER, AT_UPPER, BELOW_LIMIT, WITHIN
from trimmer.hybrid.system import NOTHING, EventFunction, Transition

if TYPE_CHECKING:
    from trimmer.contact.machine.machine import Machine

SIDES = {AT_UPPER: 1.0, AT_LOWER: -1.0}


def limited(machine: Machine, control: int, status: int) -> Reals:
    """Return sat(w) of a controller as a functional, N, (N,)."""
    if status == WITHIN:
        return np.asarray(machine.control_demand[control])
    row = np.zeros(machine.control_demand.shape[1])
    row[-1] = SIDES[status] * machine.control_limit[control]
    return row


def add_controls(machine: Machine, statuses: tuple[int, ...], flow: Reals) -> None:
    """Add what controllers do to a flow, (N, N)."""
    for control, status in enumerate(machine.of_controls(statuses)):
        row = limited(machine, control, status)
        flow += np.outer(machine.control_effect[control], row)
        if status != WITHIN:
            flow += np.outer(machine.control_tracking[control], row - machine.control_demand[control])


def functions_of_controls(machine: Machine, statuses: tuple[int, ...]) -> Iterator[EventFunction]:
    """Yield how far what each controller demands is from its limits.

    They come before all others of a mode: where a reference jumps, what acts is known before stick is
    decided.
    """
    for control, (status, limit) in enumerate(
        zip(machine.of_controls(statuses), machine.control_limit, strict=True)
    ):
        demand = machine.control_demand[control]
        if not np.isfinite(limit):
            continue
        for side, action, within in ((1.0, ABOVE_LIMIT, AT_LOWER), (-1.0, BELOW_LIMIT, AT_UPPER)):
            # Within both limits it may reach either; beyond one it may come back to that.
            if status in (WITHIN, within):
                row = -side * demand
                row[-1] += limit if status == WITHIN else -limit
                yield EventFunction(machine.first_control + control, action, row)


def beyond_limit(statuses: tuple[int, ...], function: EventFunction, jumped: bool) -> Transition:
    """Return what follows where a demand reaches a limit or comes back: it is there, if it did not jump."""
    control, rises = function.owner, function.action == ABOVE_LIMIT
    before = statuses[control]
    after = (AT_UPPER if rises else AT_LOWER) if before == WITHIN else WITHIN
    back = () if jumped else ((BELOW_LIMIT if rises else ABOVE_LIMIT, 1),)
    return Transition((*statuses[:control], after, *statuses[control + 1 :]), NOTHING, back)


def limits_at(machine: Machine, state: Reals) -> tuple[int, ...]:
    """Return the status of each controller at an extended state, (N,)."""
    if not len(machine.control_limit):
        return ()
    demands = machine.control_demand @ state
    return tuple(
        AT_UPPER if demand > limit else AT_LOWER if demand < -limit else WITHIN
        for demand, limit in zip(demands, machine.control_limit, strict=True)
    )
