"""Where a motion begins: the statuses of all parts in a state and beside an instant, and what is refused."""

from __future__ import annotations

import numpy as np

from trimmer.arrays import Reals
from trimmer.contact.machine.machine import Machine
from trimmer.contact.machine.statuses import (
    ALWAYS,
    BACKWARD,
    FORWARD,
    FREE,
    LOOSE,
    MINUS,
    PLUS,
    RELAXES,
    RELAXING,
    RELEASED_MINUS,
    RELEASED_PLUS,
    STICK,
    TRUNCATES,
)
from trimmer.contact.modes.assembly import force_of
from trimmer.contact.modes.control_limits import limits_at
from trimmer.contact.modes.curves import segments_at
from trimmer.contact.modes.impulses import NEARLY, at_gap
from trimmer.contact.modes.joint import decide
from trimmer.contact.modes.system import MechanismSystem
from trimmer.contact.modes.transitions import held_parts
from trimmer.errors import MechanismError
from trimmer.hybrid.stretch import Instant
from trimmer.hybrid.system import ARRIVED, NO_STATE
from trimmer.hybrid.tables import Modes
from trimmer.hybrid.tabulated_change import AT_REST
from trimmer.mechanism.kinds import kind_of_part
from trimmer.mechanism.mechanism import Mechanism
from trimmer.mechanism.place_text import place_text
from trimmer.sides import DIFFERENT


def instant_at(
    modes: Modes[MechanismSystem], state: Reals, phase: float, stretched: bool, like: Instant | None
) -> Instant:
    """Return the instant at which a mechanism is in a given state, (n,); see ``MechanismFlow.at``."""
    machine, layout = modes.system.machine, modes.system.layout
    periods = like.periods if like is not None and layout.drifts else 0
    extended = np.concatenate([state, layout.forcing_at(phase, periods * layout.period)])
    for wall in range(len(machine.restitution)):
        extended = at_gap(machine, wall, extended)
    if like is not None:
        state = modes.held(modes.number(like.statuses), extended)[: layout.state_count]
        return Instant(state, like.statuses, periods, phase, like.zeros, like.negligible)
    contacts = [_contact(machine, contact, extended, stretched) for contact in range(len(machine.stiffness))]
    negligible = 2.0**-56 * abs(machine.contact_distance @ extended)
    speeds = machine.friction_rate @ extended
    # A wave that turns back is at rest, although the cosine of its phase is rounding.
    largest = abs(extended)
    largest[layout.state_count :] = 1.0
    sizes = abs(machine.friction_rate) @ largest
    slow = abs(speeds) <= AT_REST * sizes
    frictions = [
        STICK if rest else FORWARD if v > 0 else BACKWARD for v, rest in zip(speeds, slow, strict=True)
    ]
    walls, resting = (LOOSE for _ in machine.restitution), np.zeros(0, dtype=bool)
    if len(machine.restitution):
        distances, rates = machine.wall_distance @ extended, machine.wall_rate @ extended
        reached = abs(distances) <= NEARLY * (abs(machine.wall_distance) @ largest)
        resting = reached & (abs(rates) <= AT_REST * (abs(machine.wall_rate) @ largest))
    limits = limits_at(machine, extended)
    statuses = (*contacts, *frictions, *segments_at(machine, extended), *limits, *walls)
    at_rest = [place for place, each in enumerate((*slow, *resting)) if each]
    zeros = np.zeros((len(statuses), modes.system.action_count), dtype=np.int64)
    if at_rest:
        statuses = decide(machine, statuses, extended, np.array(at_rest))
        held = held_parts(machine, statuses)
        begun = [part for part in machine.holds[at_rest].tolist() if part not in held]
        zeros[begun, ARRIVED] = 1
    return Instant(extended[: layout.state_count], statuses, 0, phase, zeros, negligible)


def _contact(machine: Machine, contact: int, extended: Reals, stretched: bool) -> int:
    """Return the status of a contact, and set the stretch of its spring if that is not given."""
    z = int(machine.relaxing_state[contact])
    relaxes = z != NO_STATE
    distance = float(machine.contact_distance[contact] @ extended)
    upper, lower = machine.offsets[contact].tolist()
    if machine.always[contact]:
        if relaxes:
            extended[z] = distance
        return ALWAYS
    nearest = distance - min(max(distance, lower), upper)
    if relaxes and not stretched:
        extended[z] = nearest
    held = relaxes and stretched and extended[z] != 0
    reach = distance - extended[z] if held else distance
    # Behind a spring the distance at which contact begins is known to its rounding.
    near = AT_REST * (abs(distance) + abs(extended[z])) if held else 0.0
    side = PLUS if reach >= upper - near else MINUS if reach <= lower + near else FREE
    if side == FREE:
        return RELAXING if held else FREE
    force = force_of(machine, contact, side) @ extended
    force = force if side == PLUS else -force
    if machine.law[contact] == RELAXES:
        return side if force >= 0 else RELAXING
    if machine.law[contact] == TRUNCATES and force < 0:
        return RELEASED_PLUS if side == PLUS else RELEASED_MINUS
    return side


def set_free(modes: Modes[MechanismSystem], begin: Instant, change: Reals) -> tuple[int, ...]:
    """Return the statuses at an instant, with what a change of the state, (n,), sets free."""
    machine, free = modes.system.machine, list(begin.statuses)
    rates = machine.friction_rate[:, : len(change)]
    speeds, contacts = rates @ change, len(machine.stiffness)
    moves = abs(speeds) > DIFFERENT * (abs(rates) @ abs(change))
    for friction in np.flatnonzero(moves).tolist():
        drops = machine.static[friction] > machine.kinetic[friction]
        if begin.statuses[contacts + friction] == STICK and not drops:
            free[contacts + friction] = FORWARD if speeds[friction] > 0 else BACKWARD
    ahead, behind = (_beside(modes, begin, each) for each in (change, -change))
    # What is alike to both sides is far from its edge, and goes on as it is.
    for place in (place for place in ahead if ahead[place] != behind[place]):
        free[place] = ahead[place]
    return tuple(free)


def _beside(modes: Modes[MechanismSystem], begin: Instant, change: Reals) -> dict[int, int]:
    """Return statuses of contacts, curves and limits, by their place, beside an instant."""
    machine, layout = modes.system.machine, modes.system.layout
    forcing = layout.forcing_at(begin.phase, begin.periods * layout.period if layout.drifts else 0.0)
    hold = modes[modes.number(begin.statuses)].hold
    extended = hold @ np.concatenate([begin.state + change, forcing])
    contacts, later = len(machine.stiffness), len(machine.stiffness) + len(machine.friction_rate)
    touched = {each: _contact(machine, each, extended.copy(), True) for each in range(contacts)}
    others = *segments_at(machine, extended), *limits_at(machine, extended)
    return touched | dict(enumerate(others, later))


def require_within_walls(mechanism: Mechanism, system: MechanismSystem, state: Reals) -> None:
    """Check that walls let a mechanism start from a state, (n,), at t = 0.

    Raises:
        MechanismError: naming the body whose start puts ends most beyond a wall, or else the wall's gap.
    """
    layout = system.layout
    extended = np.concatenate([state, layout.forcing_at(0.0)])
    for name, row in zip(layout.walls, system.machine.wall_distance, strict=True):
        beyond = float(row @ extended)
        if beyond > NEARLY * float(abs(row) @ abs(extended)):
            shares = row[: len(layout.coordinates)] * extended[: len(layout.coordinates)]
            most = int(np.argmax(shares))
            body = layout.coordinates[most] if shares[most] > 0 else None
            place = ("walls", name, "gap") if body is None else ("start", body)
            raise MechanismError(_told(mechanism, name, beyond, body), place=place)


def _told(mechanism: Mechanism, name: str, beyond: float, body: str | None) -> str:
    wall, gap = mechanism.walls[name], place_text(("walls", name, "gap"))
    place, advice = gap, "give another gap, or a body a [start] within it"
    if body is not None:
        place, advice = place_text(("start", body)), f"begin elsewhere, or give {gap} more"
    start, end = wall.between
    unit = kind_of_part(mechanism.kinds, "walls", name, wall).unit("m")
    return (
        f"{place}: at the start {end!r} is {beyond:.6g} {unit} too far from {start!r} "
        f"for the wall {name!r}; {advice}"
    )
