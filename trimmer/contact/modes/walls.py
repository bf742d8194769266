"""Rigid walls: impacts by Newton's law of restitution, rest that only pushes, completed chatter.

Where the gap of a wall is reached with the rate v > 0, an impulse of (1 + e) v / (w M⁻¹ wᵀ) on both ends
makes the rate -e v. At rest it is a hold as stick is, with a force that is bounded on one side by zero: see
``trimmer.contact.modes.joint``. Several walls that are reached at one instant act one after the other.
"""

from collections.abc import Iterator
from dataclasses import dataclass

import numpy as np

from trimmer.arrays import Places, Reals
from trimmer.contact.machine.machine import Machine
from trimmer.contact.machine.statuses import (
    BACKWARD,
    COMPLETED,
    FORWARD,
    IMPACT,
    LOOSE,
    RESTS,
    STICK,
    TOGETHER,
)
from trimmer.contact.modes.assembly import Assembler, stopped_at_walls
from trimmer.contact.modes.control_limits import limits_at
from trimmer.contact.modes.curves import segments_at
from trimmer.contact.modes.impulses import NEARLY, at_gap, impulse_of
from trimmer.contact.modes.joint import decide
from trimmer.hybrid.dry_friction import complementary_forces
from trimmer.hybrid.system import ARRIVED, STRUCK, Decision, Impulse

MOST_PASSES = 60  # Rounds of impacts at one instant, after which walls act together, without rebound
SHORTEST = 1e-9  # Share of the drive's period, or of 1 s, below which what is left of a chatter is completed


def strike(
    machine: Machine, statuses: tuple[int, ...], state: Reals, wall: int, period: float, held: tuple[int, ...]
) -> Decision:
    """Return what an impact on a wall does, and all that follows from it at the same instant.

    Args:
        machine: The mechanism.
        statuses: Of all parts before.
        state: The extended state, (N,).
        wall: The wall that is reached.
        period: That of the drive, s; 1 without one.
        held: Numbers of the parts that were held before the instant.

    Raises:
        ArithmeticError: if rounding keeps it from being decided.
    """
    state = at_gap(machine, wall, state)
    return _Strike(machine, statuses, state, wall, period, held, abs(state)).decision()


@dataclass(frozen=True, eq=False)
class _Strike:
    """An instant at which a wall is reached."""

    # machine, statuses, state, wall, period, held: See ``strike``
    machine: Machine
    statuses: tuple[int, ...]
    state: Reals
    wall: int
    period: float
    held: tuple[int, ...]
    largest: Reals  # Moduli of the entries of the state, the largest of the instant, (N,)

    def decision(self) -> Decision:
        touching, state, impulses = self.touching(), self.state, list[Impulse]()
        completed: set[int] = set()
        while True:
            acted = list(self.in_turn(touching, completed, state))
            impulses += acted
            state = impulses[-1].state if impulses else state
            statuses, at_rest = self.decided(touching, state)
            # The wall that is reached may be left at once with a rate that is rounding.
            met = {self.wall, *(each.part - self.first for each in acted)} - completed
            ending = sorted(wall for wall in met if self.has_chattered(wall, statuses, state))
            if not ending:
                break
            for wall in ending:
                completed.add(wall)
                state = self.seen(stopped_at_walls(self.machine, np.array(sorted(completed))) @ state)
                if self.machine.restitution[wall] > 0.0:
                    impulses.append(Impulse(self.first + wall, COMPLETED, state))
        if not impulses and self.rebounds and statuses[self.first + self.wall] == RESTS:
            # The bounces have become lower than can be told.
            impulses = [Impulse(self.first + self.wall, COMPLETED, state)]
        return Decision(statuses, 1, state, tuple(impulses), self.known(touching, at_rest, statuses))

    @property
    def rebounds(self) -> bool:
        return bool(self.machine.restitution[self.wall] > 0.0)

    @property
    def first(self) -> int:
        """Number of the first wall among all parts."""
        return self.machine.first_wall

    def seen(self, state: Reals) -> Reals:
        """Return a state that is reached at the instant, once its size is known."""
        np.maximum(self.largest, abs(state), out=self.largest)
        return state

    def size(self, row: Reals) -> float:
        """Return the sum of the moduli of what a functional of the state is made of."""
        return float(abs(row) @ self.largest)

    def rate(self, wall: int, state: Reals) -> float:
        """Return how fast the ends of a wall part, zero where rounding cannot tell."""
        row = self.machine.wall_rate[wall]
        rate = float(row @ state)
        return 0.0 if abs(rate) <= NEARLY * self.size(row) else rate

    def touching(self) -> list[int]:
        """Return the walls that are reached, in the order of the file."""
        machine, found = self.machine, []
        for wall, (row, rate) in enumerate(zip(machine.wall_distance, machine.wall_rate, strict=True)):
            near = self.size(row) + self.period * self.size(rate)
            is_near = abs(row @ self.state) <= NEARLY * near
            if wall == self.wall or self.statuses[self.first + wall] == RESTS or is_near:
                found.append(wall)
        return found

    def in_turn(self, touching: list[int], completed: set[int], state: Reals) -> Iterator[Impulse]:
        """Yield the impacts of the walls that close, one after the other, and at last all together."""
        for _ in range(MOST_PASSES):
            acted = False
            for wall in touching:
                if self.rate(wall, state) > 0.0:
                    restitution = 0.0 if wall in completed else self.machine.restitution[wall]
                    state = self.seen(impulse_of(self.machine, wall, restitution) @ state)
                    acted = True
                    yield Impulse(self.first + wall, IMPACT, state)
            if not acted:
                return
        velocities = self.machine.velocities
        rates, push = self.machine.wall_rate[touching], self.machine.wall_push[touching]
        influence, infinite = rates[:, velocities] @ push.T, np.full(len(touching), np.inf)
        forces, _ = complementary_forces(influence, rates @ state, np.zeros(len(touching)), infinite)
        for wall, force in zip(touching, forces, strict=True):
            if force > 0.0:
                state = state.copy()
                state[velocities] -= self.machine.wall_push[wall] * force
                self.seen(state)
                yield Impulse(self.first + wall, TOGETHER, state)

    def decided(self, touching: list[int], state: Reals) -> tuple[tuple[int, ...], Places]:
        """Return the statuses after the last impulse, and the holds, by number, whose velocity is zero."""
        machine, contacts, frictions = self.machine, len(self.machine.stiffness), len(self.machine.kinetic)
        statuses = list(self.statuses)
        resting = [frictions + wall for wall in touching if self.rate(wall, state) == 0.0]
        statuses[self.first :] = [LOOSE] * len(machine.restitution)
        for friction, row in enumerate(machine.friction_rate):
            speed = float(row @ state)
            rests = abs(speed) <= NEARLY * self.size(row)
            statuses[contacts + friction] = STICK if rests else FORWARD if speed > 0 else BACKWARD
        sliding = np.flatnonzero(np.array(statuses[contacts : contacts + frictions], dtype=int) == STICK)
        for curve, segment in enumerate(segments_at(machine, state)):
            if machine.curve_by_speed[curve]:
                statuses[machine.first_curve + curve] = segment
        first = machine.first_control
        statuses[first : self.first] = limits_at(machine, state)
        at_rest = np.array([*sliding.tolist(), *resting], dtype=np.intp)
        if not len(at_rest):
            return tuple(statuses), at_rest
        return decide(machine, tuple(statuses), state, at_rest, held=self.held), at_rest

    def has_chattered(self, wall: int, statuses: tuple[int, ...], state: Reals) -> bool:
        """Say whether what is left of the bounces on a wall is too short to matter."""
        leaving = -self.rate(wall, state)
        if leaving <= 0.0:
            return False
        closing = float(self.machine.wall_rate[wall] @ (Assembler(self.machine).mode(statuses).flow @ state))
        left = 1.0 - self.machine.restitution[wall]
        return bool(2.0 * leaving < SHORTEST * self.period * closing * left)

    def known(
        self, touching: list[int], at_rest: Places, statuses: tuple[int, ...]
    ) -> tuple[tuple[int, int, int], ...]:
        """Return what is zero at first: parts, actions, and numbers of derivatives."""
        contacts, frictions = len(self.machine.stiffness), len(self.machine.kinetic)
        resting = {hold - frictions for hold in at_rest.tolist() if hold >= frictions}
        known = [(contacts + hold, ARRIVED, 1) for hold in at_rest.tolist() if hold < frictions]
        known = [each for each in known if statuses[each[0]] != STICK]
        for wall in touching:
            part = self.first + wall
            if statuses[part] == LOOSE:
                known.append((part, STRUCK, 2 if wall in resting else 1))
                known += [(part, ARRIVED, 1)] if wall in resting else []
        return tuple(known)
