"""Several frictions at rest at one instant: which stick, and which begin to slide where.

The relative accelerations follow from a linear complementarity problem,
``trimmer.hybrid.dry_friction``. A friction whose static force is greater than its kinetic one
resists with the latter once it breaks away; then all are decided again.
"""

import numpy as np

from trimmer.arrays import Places, Reals
from trimmer.contact.machine.machine import Machine
from trimmer.contact.machine.statuses import BACKWARD, FORWARD, LOOSE, RESTS, STICK
from trimmer.contact.modes.assembly import flow_without_stick
from trimmer.hybrid.dry_friction import complementary_forces
from trimmer.hybrid.system import ARRIVED, JointEvent

NOISE = 2.0**-49  # Rounding of an acceleration as a share of the moduli of its terms


def after_event(
    machine: Machine, statuses: tuple[int, ...], state: Reals, event: JointEvent
) -> tuple[tuple[int, ...], int]:
    """Return what frictions at rest do after a velocity has come to zero, or a limit of stick is reached.

    Args:
        machine: The mechanism.
        statuses: Of all parts before.
        state: The extended state, (N,).
        event: What fell to zero; what is at rest are frictions, and walls that are reached.

    Returns:
        The statuses of all parts, and how many derivatives of the velocities vanish that begin.

    Raises:
        ArithmeticError: see ``decide``.
    """
    function, jumped, parts, held = event
    at_rest = np.flatnonzero(np.isin(machine.holds, parts))
    if function.action == ARRIVED or jumped:
        after = decide(machine, statuses, state, at_rest, held=held)
        if function.action == ARRIVED or after != statuses:
            return after, 1
    sliding = [hold for hold, sign in enumerate(function.signs) if sign]
    rubbing = [hold for hold in sliding if hold < len(machine.kinetic)]
    drops = bool((machine.static[rubbing] > machine.kinetic[rubbing]).any())
    if drops:
        after = decide(machine, statuses, state, at_rest, np.array(sliding, dtype=np.intp), held)
        if after != statuses:
            return after, 1
    # Without a drop accelerations begin at zero; and where the drop is rounding, the limit decides.
    decided, holds = list(statuses), machine.holds
    for hold in sliding:
        decided[holds[hold]] = _going(machine, hold, function.signs[hold])
    return tuple(decided), 1 if drops else 2


def decide(
    machine: Machine,
    statuses: tuple[int, ...],
    state: Reals,
    at_rest: Places,
    broken: Places | None = None,
    held: tuple[int, ...] = (),
) -> tuple[int, ...]:
    """Return the statuses of all parts once the frictions at rest have stuck or begun to slide.

    What breaks away resists with its kinetic force from then on, and all is decided again: it may stick after
    all, where others that broke away with it push it back. So it ends, and all forces fit what moves. What
    stuck before goes on sticking if it can.

    Args:
        machine: The mechanism.
        statuses: Of all parts; those of the frictions at rest do not count.
        state: The extended state, (N,).
        at_rest: Numbers of the holds whose velocity is zero, those that hold among them.
        broken: Those of them that are beyond their static force; none if not given.
        held: Numbers of the parts that were held before the instant.

    Raises:
        ArithmeticError: if rounding keeps the problem from being solved.
    """
    decided, limits, holds = list(statuses), machine.held, machine.holds
    kinetic = np.concatenate([machine.kinetic, np.full(len(machine.restitution), np.inf)])
    if broken is not None:
        limits[broken] = kinetic[broken]
    stuck = np.isin(holds, list(held))
    while True:
        accelerations = _accelerations(machine, statuses, state, at_rest, limits[at_rest])
        breaking = at_rest[(accelerations != 0) & (limits[at_rest] > kinetic[at_rest])]
        if not len(breaking):
            break
        # What turns back never had its static force, with which it would tear off what sticks.
        turning = breaking[~stuck[breaking]]
        breaking = turning if len(turning) else breaking
        limits[breaking] = kinetic[breaking]
    for hold, acceleration in zip(at_rest.tolist(), accelerations.tolist(), strict=True):
        decided[holds[hold]] = _going(machine, hold, acceleration)
    return tuple(decided)


def _going(machine: Machine, hold: int, direction: float) -> int:
    """Return the status of a friction or a wall whose end begins to go in a direction; 0 for none."""
    if hold >= len(machine.kinetic):
        return RESTS if direction == 0 else LOOSE
    return STICK if direction == 0 else FORWARD if direction > 0 else BACKWARD


def _accelerations(
    machine: Machine, statuses: tuple[int, ...], state: Reals, at_rest: Places, limits: Reals
) -> Reals:
    """Return the relative accelerations of holds at rest, zero where they hold within their limits."""
    flow = flow_without_stick(machine, statuses, at_rest)
    rates, push = machine.hold_rate[at_rest], machine.hold_push[at_rest]
    lowest = np.where(at_rest < len(machine.kinetic), -limits, 0.0)  # Walls only push.
    noise = NOISE * (abs(rates) @ (abs(flow) @ abs(state)))
    influence = rates[:, machine.velocities] @ push.T
    _, accelerations = complementary_forces(influence, rates @ (flow @ state), lowest, limits, noise)
    return accelerations
