"""Which mode goes on from an instant: all combinations that the state allows are tried.

A mode is possible if every guard of it is positive, or zero and about to grow: the first of its derivatives
in that mode that is not zero decides. No pivoting, and next to no memory: the state tells.
"""

import itertools
from dataclasses import dataclass

import numpy as np

from tests.mechanisms.dynamics import Dynamics, Mode, System
from tests.mechanisms.parts import FREE, Contact, ContactMode
from tests.mechanisms.sticking import at_limit_in_every_split

DERIVATIVES = 7
# What is left of terms that cancel may be this small beside them; less is rounding.
CANCELLING = 1e-5


class NoModeFoundError(Exception):
    """No combination of modes is consistent: the brute force does not know what happens."""


@dataclass(frozen=True)
class Decided:
    """The mode that goes on; ``others`` are further ones that are as good and move differently."""

    mode: Mode
    others: tuple[Mode, ...] = ()


@dataclass(frozen=True)
class Judge:
    """Decides for one system."""

    system: System
    near: float = 1e-11  # What counts as zero, relative to the terms that cancel
    derivative_near: float = 1e-9  # The same for derivatives and forces

    def size(self, rows: np.ndarray, y: np.ndarray) -> np.ndarray:
        """Size of the terms of one row or of several."""
        return np.abs(rows) @ np.maximum(np.abs(y), 0.1 * self.system.usual)

    def sign(self, row: np.ndarray, y: np.ndarray, near: float) -> int:
        value = float(row @ y)
        return 0 if abs(value) <= near * self.size(row, y) else (1 if value > 0 else -1)

    def first_sign(self, row: np.ndarray, rates: np.ndarray, y: np.ndarray) -> int:
        """Sign of a guard just after the instant, 0 if it stays zero."""
        rounding = 0.0
        for _ in range(DERIVATIVES):
            value = float(row @ y)
            if abs(value) > self.derivative_near * (self.size(row, y) + rounding):
                return 1 if value > 0 else -1
            rounding = CANCELLING * self.size(np.abs(row) @ np.abs(rates), y)
            row = row @ rates
        return 0

    def decide(self, y: np.ndarray, before: Mode | None = None) -> Decided:
        """Return the mode that goes on from y.

        Args:
            y: The state.
            before: The mode that led here. It matters only where static friction is above the kinetic one and
                the state alone leaves several modes: what sticks then rather goes on sticking.

        Raises:
            NoModeFoundError: if no combination is consistent.
        """
        found = self._consistent(y)
        if not found:
            raise NoModeFoundError(f"no mode goes on from {y}")
        if not any(part.part.static_force > part.part.kinetic_force for part in self.system.frictions):
            most = max(mode.frictions.count(0) for mode in found)
            return Decided(next(mode for mode in found if mode.frictions.count(0) == most))
        return self._chosen(found, before, y)

    def _chosen(self, found: list[Mode], before: Mode | None, y: np.ndarray) -> Decided:
        """Choose where static friction above the kinetic one leaves several."""
        stuck = [place for place, sign in enumerate(before.frictions) if sign == 0] if before else []

        def kept(mode: Mode) -> tuple[int, int]:
            return sum(mode.frictions[place] == 0 for place in stuck), mode.frictions.count(0)

        best = self._begun_at_limit(found, before, y) if stuck else found
        most = max(map(kept, best))
        first, *rest = (mode for mode in best if kept(mode) == most)
        return Decided(first, tuple(mode for mode in rest if self._moves_differently(first, mode, y)))

    def _moves_differently(self, first: Mode, second: Mode, y: np.ndarray) -> bool:
        count = len(self.system.masses)
        accelerations = (self.system.dynamics(mode).rates[count : 2 * count] for mode in (first, second))
        one, other = accelerations
        return any(self.sign(row, y, self.derivative_near) != 0 for row in one - other)

    def _begun_at_limit(self, found: list[Mode], before: Mode, y: np.ndarray) -> list[Mode]:
        """Only what is at its static limit in every admissible split may begin to slide, if possible."""
        held = self.system.dynamics(before)
        limits = np.array([self.system.frictions[place].part.static_force for place in held.sticking_places])
        forces = held.sticking.forces @ y
        places = at_limit_in_every_split(forces, held.sticking.null, limits, self.derivative_near)
        at_limit = {held.sticking_places[place] for place in places}
        begun = [{place for place in held.sticking_places if mode.frictions[place] != 0} for mode in found]
        only = [mode for mode, slides in zip(found, begun, strict=True) if slides <= at_limit]
        some = [mode for mode, slides in zip(found, begun, strict=True) if slides & at_limit]
        return only or some or found

    def _consistent(self, y: np.ndarray) -> list[Mode]:
        contacts = [self._contact_modes(contact, y) for contact in self.system.contacts]
        frictions = []
        for friction in self.system.frictions:
            sign = self.sign(friction.velocity, y, self.near)
            frictions.append((sign,) if sign else (0, 1, -1))
        curves = [
            [
                segment
                for segment in curve.modes()
                if all(self.sign(guard, y, self.near) >= 0 for guard in curve.guards(segment))
            ]
            for curve in self.system.curves
        ]
        combinations = (
            Mode(touching, sliding, segments)
            for touching in itertools.product(*contacts)
            for sliding in itertools.product(*frictions)
            for segments in itertools.product(*curves)
        )
        ordered = sorted(combinations, key=lambda mode: -mode.frictions.count(0))
        unique = all(part.part.static_force <= part.part.kinetic_force for part in self.system.frictions)
        found = []
        for mode in ordered:
            if self._goes_on(mode, y):
                found.append(mode)
                if unique:
                    break
        return found

    def _contact_modes(self, contact: Contact, y: np.ndarray) -> list[ContactMode]:
        """Modes that the state allows."""
        possible = []
        for mode in contact.modes():
            if mode.touching and contact.has_state:
                on_side = self.sign(contact.clearance(mode.side), y, self.near) <= 0
                if not on_side:
                    continue
            if all(self.sign(guard, y, self.near) >= 0 for guard in contact.guards(mode)):
                possible.append(mode)
        if contact.has_state and len(possible) > 1:
            return self._by_force(contact, possible, y)
        return possible

    def _by_force(self, contact: Contact, possible: list[ContactMode], y: np.ndarray) -> list[ContactMode]:
        """Where the slot's side touches, a force that is not zero decides."""
        for mode in possible:
            if mode.touching:
                pushes = self.sign(contact.guards(mode)[0], y, self.derivative_near)
                if pushes > 0:
                    return [mode]
        return possible

    def _goes_on(self, mode: Mode, y: np.ndarray) -> bool:
        dynamics = self.system.dynamics(mode)
        if not self._can_stick(dynamics, y):
            return False
        signs = [self.first_sign(guard, dynamics.rates, y) for guard in dynamics.guards]
        if any(sign < 0 for sign in signs):
            return False
        return self._slides(mode, dynamics, y)

    def _slides(self, mode: Mode, dynamics: Dynamics, y: np.ndarray) -> bool:
        """Whether what is said to slide does not stay at rest."""
        return all(
            self.first_sign(sign * friction.velocity, dynamics.rates, y) > 0
            for friction, sign in zip(self.system.frictions, mode.frictions, strict=True)
            if sign
        )

    def _can_stick(self, dynamics: Dynamics, y: np.ndarray) -> bool:
        """Whether prescribed motions let all these frictions stick at once."""
        if dynamics.sticking is None:
            return True
        return all(
            self.first_sign(row, dynamics.rates, y) == 0
            for row in dynamics.sticking.mismatch
            if np.max(np.abs(row)) > self.near * np.max(np.abs(dynamics.rates))
        )


__all__ = ["FREE", "Decided", "Judge", "NoModeFoundError"]
