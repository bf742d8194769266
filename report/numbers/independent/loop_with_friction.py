"""Limit cycles of the thesis's loop with friction by linear algebra, with SciPy's matrix exponential.

The pin turns round where y' = 0. There friction-controlled backlash lets go, and friction changes its sign.
So in half a period from turn to turn friction is one constant force; the bridge first rests, for the gap that
the pin crosses, and is then carried along. For given lengths of both phases the state at the turn and the
force follow from linear equations: the state changes its sign in half a period, and y' = 0. That the first
phase ends with the gap gives its length. The gap is the unit of length.
"""

from __future__ import annotations

from collections.abc import Iterable
from dataclasses import dataclass
from typing import Final

import numpy as np
from scipy.linalg import expm
from scipy.optimize import brentq, minimize_scalar

from report.numbers.friction_in_place import FrictionCycle, force_response
from trimmer import TrimmerParameters, pin_model
from trimmer.arrays import Reals
from trimmer.linear import InputChannels

RESTS: Final = np.linspace(0.02, 0.98, 49)
"""Shares of half a period: between two of them the bridge rests for as long as the pin takes for the gap."""
ACCURACY: Final = 1e-6  # Of the frequency with the largest force, Hz; the force is flat there


def largest_friction(parameters: TrimmerParameters, lowest: float, highest: float) -> FrictionCycle:
    """Return the limit cycle with the largest friction, of those with frequencies in a range, Hz."""
    loop = _HalfPeriods.of(parameters)
    found = minimize_scalar(
        lambda frequency: -loop.cycle(frequency).force_per_gap,
        bounds=(lowest, highest),
        method="bounded",
        options={"xatol": ACCURACY},
    )
    return loop.cycle(float(found.x))


def cycles_at(parameters: TrimmerParameters, frequencies: Iterable[float]) -> list[FrictionCycle]:
    """Return the limit cycles of given frequencies, Hz.

    A negative force pushes along, as too much compensation does.
    """
    loop = _HalfPeriods.of(parameters)
    return [loop.cycle(frequency) for frequency in frequencies]


@dataclass(frozen=True, eq=False)
class _HalfPeriods:
    """x' = A x + B u + F f, y = C x; the friction f acts on the cutter and the other way on the guard."""

    A: Reals
    B: Reals
    C: Reals
    F: Reals

    @classmethod
    def of(cls, parameters: TrimmerParameters) -> _HalfPeriods:
        system = pin_model(parameters, channels=InputChannels.DISPLACEMENT_ONLY)
        return cls(system.A, system.B[:, 0], system.C[0], force_response(parameters).B[:, 0])

    def cycle(self, frequency: float) -> FrictionCycle:
        """Return the limit cycle of a frequency, Hz."""
        half = 0.5 / frequency
        beyond = [self._from_turn(half, share)[2] > 0 for share in RESTS]
        after = int(np.flatnonzero(np.diff(np.array(beyond, dtype=int)) > 0)[0])
        ends = RESTS[after : after + 2]
        share = brentq(lambda share: self._from_turn(half, share)[2], *ends, xtol=1e-15)
        amplitude, force, _ = self._from_turn(half, share)
        return FrictionCycle(amplitude, frequency, force)

    def _from_turn(self, half: float, share: float) -> tuple[float, float, float]:
        """Return amplitude, friction, and by how much more than the gap the pin moves while the bridge rests.

        Given are half a period, s, and its share in which the bridge rests.
        """
        size, inputs = len(self.A), np.column_stack([self.B, self.F])
        rest, resting = _after(self.A, inputs, share * half)
        carry, carried = _after(self.A - np.outer(self.B, self.C), inputs, (1 - share) * half)
        # At the turn y = -a is least, and the bridge rests at a - 1/2. As y' > 0, f is minus the force.
        at_meeting = rest - np.outer(resting[:, 0], self.C)
        matrix, right = np.zeros((size + 1, size + 1)), np.zeros(size + 1)
        matrix[:size, :size] = carry @ at_meeting + np.eye(size)
        matrix[:size, size] = -(carry @ resting[:, 1] + carried[:, 1])
        right[:size] = (carry @ resting[:, 0] - carried[:, 0]) / 2
        matrix[size, :size] = self.C @ self.A
        *turn, force = np.linalg.solve(matrix, right)
        meets = at_meeting @ turn - resting[:, 0] / 2 - resting[:, 1] * force
        return float(-self.C @ turn), float(force), float(self.C @ (meets - turn)) - 1.0


def _after(matrix: Reals, inputs: Reals, time: float) -> tuple[Reals, Reals]:
    """Return what a state and constant inputs contribute to the state after a time."""
    size, count = inputs.shape
    whole = np.zeros((size + count, size + count))
    whole[:size] = np.hstack([matrix, inputs])
    found = np.asarray(expm(whole * time))
    return found[:size, :size], found[:size, size:]
