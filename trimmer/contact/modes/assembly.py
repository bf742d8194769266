"""The flow of a mode, the event functions that end it, and what it holds, from the statuses of all parts."""

from collections.abc import Iterator, Sequence
from dataclasses import dataclass, field
from typing import NamedTuple

import numpy as np

from trimmer.arrays import Places, Reals, identity
from trimmer.contact.machine.machine import Machine, relaxing_springs
from trimmer.contact.machine.statuses import (
    ALWAYS,
    BROKEN,
    FORWARD,
    FREE,
    LEFT,
    MADE_MINUS,
    MADE_PLUS,
    MINUS,
    PLUS,
    PULLS,
    RELAXING,
    RELEASED_MINUS,
    RELEASED_PLUS,
    RESTS,
    RETURNED,
    STICK,
)
from trimmer.contact.modes.control_limits import add_controls, functions_of_controls
from trimmer.contact.modes.curves import add_curves, functions_of_curves
from trimmer.hybrid.dry_friction import elementary_vectors, independent
from trimmer.hybrid.system import ARRIVED, AT_LIMIT, JOINTLY, NO_STATE, STRUCK, EventFunction, ModeEquations
from trimmer.kept_property import cached_property

PUSHING = (PLUS, MINUS, ALWAYS)  # Statuses of a contact that exerts a force
SIDES = {PLUS: 1, RELEASED_PLUS: 1, MINUS: -1, RELEASED_MINUS: -1}
"""Statuses of a contact on either side of the slot."""
MOST_KEPT = 250_000
"""Numbers of one kind that are kept of what holds: many parts make many sets, most of which hold once."""
ROUNDING = 16 * float(np.finfo(float).eps)
"""Rounding of a sum of products as a share of the moduli of its terms."""


class _Holding(NamedTuple):
    """What holds in a mode, whatever the status of all else: frictions that stick, and walls at rest."""

    tree: Places  # Numbers of the holds that hold the others too
    rates: Reals  # Their velocities as functionals, (t, N)
    push: Reals  # Accelerations by their forces, (t, n)
    inverse: Reals  # Of what one accelerates another, (t, t)
    shares: Reals  # Moduli of what makes velocities fit what is held, (n, N)
    fitted: Reals  # Velocities that fit it, (n, N)
    # Of each way in which it ends: part, directions, which sums of forces, and their limit, N
    limits: tuple[tuple[int, tuple[int, ...], Reals, float], ...]


@dataclass(frozen=True, eq=False)
class Assembler:
    """Makes the modes of a machine, and keeps what several of them share."""

    machine: Machine  # The mechanism
    period: float = 1.0  # That of the drive, s; 1 without one
    _of_contact: dict[tuple[int, int], tuple[EventFunction, ...]] = field(default_factory=dict, init=False)
    _holdings: dict[tuple[int, ...], _Holding] = field(default_factory=dict, init=False)

    @cached_property
    def _springs(self) -> list[tuple[int, int]]:
        return relaxing_springs(self.machine)

    @cached_property
    def _rates(self) -> dict[int, float]:
        return {contact: _rate(self.machine, contact) for contact, _ in self._springs}

    def mode(self, statuses: tuple[int, ...]) -> ModeEquations:
        """Return the equations of a mode, by the statuses of contacts, frictions, curves, controls, walls."""
        machine = self.machine
        contacts, velocities = len(machine.stiffness), machine.velocities
        flow = flow_without_stick(machine, statuses)
        hold = identity(len(flow)).copy()
        for contact, z in self._springs:
            if statuses[contact] in PUSHING:
                hold[z] = machine.contact_distance[contact]
                hold[z, -1] -= offset(machine, contact, statuses[contact])
            elif statuses[contact] == FREE:
                hold[z] = 0.0
        functions = [*functions_of_controls(machine, statuses), *self._of_contacts(statuses[:contacts])]
        rubbing, walls = machine.of_frictions(statuses), machine.of_walls(statuses)
        resting = [number for number, each in enumerate(walls) if each == RESTS]
        sticking = [number for number, each in enumerate(rubbing) if each == STICK]
        sticking += [len(rubbing) + number for number in resting]
        if sticking:
            holding = self._holding(tuple(sticking))
            forces = holding.inverse @ (holding.rates @ flow)
            flow[velocities] = _difference(
                flow[velocities], holding.push.T @ forces, holding.shares @ abs(flow)
            )
            hold[velocities] = holding.fitted
            functions += _of_stick(holding, sticking, forces)
        for friction, status in enumerate(rubbing):
            if status != STICK:
                direction = 1.0 if status == FORWARD else -1.0
                row = direction * machine.friction_rate[friction]
                functions.append(EventFunction(contacts + friction, ARRIVED, row))
        functions += functions_of_curves(machine, statuses)
        functions += functions_of_walls(machine, statuses, self.period)
        settled = (FREE if each == RELAXING else each for each in statuses[:contacts])
        return ModeEquations(
            statuses,
            flow,
            tuple(functions),
            hold @ at_walls(machine, np.array(resting)) if resting else hold,
            held=tuple(machine.holds[sticking].tolist()) if sticking else (),
            settled=(*settled, *statuses[contacts:]),
            decay=np.array(
                [self._rates[each] if statuses[each] == RELAXING else 0.0 for each in range(contacts)]
            ),
            decayed=tuple((z, self._rates[each]) for each, z in self._springs if statuses[each] == FREE),
        )

    def _of_contacts(self, statuses: tuple[int, ...]) -> Iterator[EventFunction]:
        for contact, status in enumerate(statuses):
            if (contact, status) not in self._of_contact:
                self._of_contact[contact, status] = tuple(_of_contact(self.machine, contact, status))
            yield from self._of_contact[contact, status]

    def _holding(self, sticking: tuple[int, ...]) -> _Holding:
        if sticking not in self._holdings:
            found = _holding(self.machine, np.array(sticking))
            if len(self._holdings) * found.shares.size > MOST_KEPT:
                self._holdings.clear()
            self._holdings[sticking] = found
        return self._holdings[sticking]


def _holding(machine: Machine, sticking: Places) -> _Holding:
    """Return what some holds do, by their numbers."""
    every, velocities = machine.hold_rate, machine.velocities
    tree = sticking[independent(every[sticking, velocities])]
    rates, push = every[tree], machine.hold_push[tree]
    inverse = np.asarray(np.linalg.inv(rates[:, velocities] @ push.T), dtype=np.float64)
    shares = abs(push.T) @ abs(inverse) @ abs(rates)
    fitted = _difference(np.eye(rates.shape[1])[velocities], push.T @ inverse @ rates, shares)
    return _Holding(tree, rates, push, inverse, shares, fitted, tuple(_limits(machine, sticking, tree)))


def _rate(machine: Machine, contact: int) -> float:
    """Return the rate at which the spring behind a slot relaxes, 1/s."""
    return float(machine.stiffness[contact] / machine.damping[contact])


def _difference(whole: Reals, part: Reals, moduli: Reals) -> Reals:
    """Return the whole without a part, exactly zero where rounding cannot tell: what sticks must not drift.

    Args:
        whole: Any entries.
        part: What is taken away.
        moduli: Sums of the moduli of the terms that the part is made of.
    """
    left = whole - part
    left[abs(left) <= ROUNDING * (abs(whole) + moduli)] = 0.0
    return left


def flow_without_stick(machine: Machine, statuses: tuple[int, ...], left_out: Places | None = None) -> Reals:
    """Return the flow of a mode without what sticks, and without some frictions, (N, N)."""
    flow = machine.base.copy()
    contacts, velocities = len(machine.stiffness), machine.velocities
    for contact, status in enumerate(statuses[:contacts]):
        z = machine.relaxing_state[contact]
        if status in PUSHING:
            force = force_of(machine, contact, status)
            flow[velocities] += machine.contact_push[contact][:, None] * force
            if z != NO_STATE:
                flow[z] = machine.contact_rate[contact]
        elif status == RELAXING:
            flow[z, z] = -_rate(machine, contact)
    for friction, status in enumerate(machine.of_frictions(statuses)):
        if status != STICK and (left_out is None or friction not in left_out):
            resisted = machine.kinetic[friction] * (1.0 if status == FORWARD else -1.0)
            flow[velocities, -1] -= resisted * machine.friction_push[friction]
    add_curves(machine, statuses, flow)
    add_controls(machine, statuses, flow)
    return flow


def offset(machine: Machine, contact: int, status: int) -> float:
    """Return the distance at which the spring behind a slot is relaxed, m."""
    side = SIDES.get(status, 0)
    return _edge(machine, contact, side) if side else 0.0


def _edge(machine: Machine, contact: int, side: int) -> float:
    """Return the distance at which contact begins on a side, m, infinite for none."""
    upper, lower = machine.offsets[contact]
    return float(upper if side == SIDES[PLUS] else lower)


def force_of(machine: Machine, contact: int, status: int) -> Reals:
    """Return k (s - offset) + c s', the force of a contact as a functional, (N,)."""
    force = machine.stiffness[contact] * machine.contact_distance[contact]
    force = force + machine.damping[contact] * machine.contact_rate[contact]
    force[-1] -= machine.stiffness[contact] * offset(machine, contact, status)
    return np.asarray(force)


def _of_contact(machine: Machine, contact: int, status: int) -> Iterator[EventFunction]:
    if status in (FREE, RELAXING):
        yield from _while_free(machine, contact, status)
    elif status in (PLUS, MINUS):
        side = SIDES[status]
        pulls = machine.law[contact] == PULLS
        row = _beyond(machine, contact, side) if pulls else side * force_of(machine, contact, status)
        yield EventFunction(contact, BROKEN, row)
    elif status in (RELEASED_PLUS, RELEASED_MINUS):
        side = SIDES[status]
        yield EventFunction(contact, RETURNED, -side * force_of(machine, contact, status))
        yield EventFunction(contact, LEFT, _beyond(machine, contact, side))


def _while_free(machine: Machine, contact: int, status: int) -> Iterator[EventFunction]:
    for side, action in ((1, MADE_PLUS), (-1, MADE_MINUS)):
        if np.isfinite(_edge(machine, contact, side)):
            row = -_beyond(machine, contact, side)
            if status == RELAXING:
                row[machine.relaxing_state[contact]] += side
            yield EventFunction(contact, action, row)


def _beyond(machine: Machine, contact: int, side: int) -> Reals:
    """Return how far the end is beyond the place where contact begins, as a functional."""
    row = side * machine.contact_distance[contact]
    row[-1] -= side * _edge(machine, contact, side)
    return np.asarray(row)


SCREEN = 1e-7
"""Share of the drive's period that is left of a chatter, below which impacts are decided one by one."""


def functions_of_walls(machine: Machine, statuses: tuple[int, ...], period: float) -> Iterator[EventFunction]:
    """Yield how far the ends of each wall are from its gap, unless they rest there."""
    for wall, status in enumerate(machine.of_walls(statuses)):
        if status != RESTS:
            rebound = max(machine.restitution[wall], np.finfo(float).tiny)
            # What is left of a chatter lasts 2 e v / (a (1 - e)) where it comes with the rate v.
            shortest = SCREEN * period * (1.0 - machine.restitution[wall]) / (2.0 * rebound)
            row = -machine.wall_distance[wall]
            yield EventFunction(machine.first_wall + wall, STRUCK, row, shortest=shortest)


def at_walls(machine: Machine, resting: Places) -> Reals:
    """Return the state with walls at rest exactly at their gaps, (N, N)."""
    return _without(
        machine.wall_distance[resting], machine.wall_push[resting], slice(machine.velocities.start)
    )


def stopped_at_walls(machine: Machine, walls: Places) -> Reals:
    """Return the state with the rates of walls set to zero by impulses of all of them together, (N, N)."""
    return _without(machine.wall_rate[walls], machine.wall_push[walls], machine.velocities)


def _without(rows: Reals, push: Reals, moved: slice) -> Reals:
    """Return the state of which some entries are moved along pushes until functionals are zero, (N, N)."""
    tree = independent(rows[:, moved])
    rows, push = rows[tree], push[tree]
    found = np.eye(rows.shape[1])
    found[moved] -= push.T @ np.linalg.inv(rows[:, moved] @ push.T) @ rows
    return found


def _limits(
    machine: Machine, sticking: Places, tree: Places
) -> Iterator[tuple[int, tuple[int, ...], Reals, float]]:
    """Yield the ways in which stick ends; rings share their forces in any admissible way."""
    vectors, rubbing = np.eye(len(sticking)), sticking < len(machine.kinetic)
    if len(tree) < len(sticking):
        vectors = elementary_vectors(machine.hold_rate[sticking, machine.velocities])
    holds, held, limits = machine.holds, len(machine.held), machine.held[sticking[rubbing]]
    for vector in vectors:
        limit = float(abs(vector[rubbing]) @ limits)
        involved = np.flatnonzero(vector)
        owner = int(holds[sticking[involved[0]]]) if len(involved) == 1 else JOINTLY
        for side in (1, -1):
            if (side * vector[~rubbing] > 0).any():
                continue  # A wall holds against this with any force.
            signs = np.zeros(held, dtype=np.int64)
            signs[sticking] = side * np.sign(vector)
            yield owner, tuple(signs.tolist()), -side * vector, limit


def _of_stick(holding: _Holding, sticking: Sequence[int], forces: Reals) -> Iterator[EventFunction]:
    """Yield how far what sticks is from its limits, by the forces of those that hold the others too."""
    every = forces
    if len(forces) < len(sticking):
        every = np.zeros((len(sticking), forces.shape[1]))
        every[np.searchsorted(sticking, holding.tree)] = forces
    for owner, signs, vector, limit in holding.limits:
        row = vector @ every
        row[-1] += limit
        yield EventFunction(owner, AT_LIMIT, row, signs)
