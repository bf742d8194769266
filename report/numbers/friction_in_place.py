"""Harmonic balance with backlash at the pin and Coulomb friction between cutter and guard.

Both see the displacement y = q2 - q4 of the cutter relative to the guard. The backlash acts by the pin, with
response G to y; friction acts as a pair of forces on cutter and guard, with response H to y:
1 + N_r(A) G(jω) + N_f(A) H(jω) = 0 with N_f = j 4 F_c / (π A). No sum of the two in one place is needed.
"""

from __future__ import annotations

import math
from dataclasses import dataclass

import control
import numpy as np

from report.numbers.thesis import TURN
from trimmer import LimitCycle, TrimmerParameters, linear_model, pin_model
from trimmer.arrays import Complexes, Reals
from trimmer.elements.backlashes.friction_backlash import FrictionBacklash
from trimmer.linear import InputChannels
from trimmer.thesis import TrimmerBody

BACKLASH = FrictionBacklash(1.0)
POINTS = 49
FEW_POINTS = 13  # Enough for the largest force to 1e-6
ZOOMS = 4
HALVINGS = 50
BEYOND = 0.01
"""Share by which the search for a frequency reaches beyond those of the two limit cycles without friction."""


@dataclass(frozen=True)
class Balances:
    """Solutions in order: amplitude per gap, angular frequency (rad/s), force per gap (N/m)."""

    amplitude: Reals
    omega: Reals
    force_per_gap: Reals

    @property
    def frequency(self) -> Reals:
        """Frequencies of the solutions, Hz."""
        return self.omega / TURN


@dataclass(frozen=True)
class FrictionCycle:
    """A limit cycle, such as that with the largest force, where the stable and the unstable one become one.

    Amplitude in gaps, frequency in Hz, force over gap in N/m.
    """

    amplitude: float
    frequency: float
    force_per_gap: float


@dataclass(frozen=True)
class FrictionBranch:
    """All solutions of a loop as the force rises from zero to that of the merger.

    ``stable`` begins at the stable limit cycle without friction, ``unstable`` at the unstable one.
    """

    stable: Balances
    unstable: Balances
    merger: FrictionCycle

    def limit_cycles(self, force_per_gap: float) -> int:
        """Return how many limit cycles there are with a force per gap in N/m."""
        return 2 if force_per_gap < self.merger.force_per_gap else 0


def force_response(parameters: TrimmerParameters) -> control.StateSpace:
    """Build the response of q2 - q4, m, to a force on the cutter and its reaction on the guard, N."""
    model = linear_model(parameters)
    column = np.zeros((model.nstates, 1))
    column[len(TrimmerBody) + TrimmerBody.CUTTER.index] = 1 / parameters.m2
    column[len(TrimmerBody) + TrimmerBody.GUARD.index] = -1 / parameters.m4
    return control.ss(model.A, column, model.C, [[0.0]])


def friction_branch(
    parameters: TrimmerParameters, channels: InputChannels, unstable: LimitCycle, stable: LimitCycle
) -> FrictionBranch:
    """Follow the solutions between both limit cycles of a loop without friction, for a gap of one metre."""
    loop = _loop(parameters, channels, unstable, stable)
    first, last = 1 / stable.amplitude, 1 / unstable.amplitude
    ratio = _ratio_of_largest_force(loop, first, last)
    return FrictionBranch(
        stable=loop.balances(np.linspace(first, ratio, POINTS)),
        unstable=loop.balances(np.linspace(last, ratio, POINTS)),
        merger=_merger(loop, ratio),
    )


def largest_force(
    parameters: TrimmerParameters, channels: InputChannels, unstable: LimitCycle, stable: LimitCycle
) -> FrictionCycle:
    """Return where the two limit cycles of a loop become one; see ``friction_branch``."""
    loop = _loop(parameters, channels, unstable, stable)
    ratio = _ratio_of_largest_force(loop, 1 / stable.amplitude, 1 / unstable.amplitude, FEW_POINTS)
    return _merger(loop, ratio)


def _loop(
    parameters: TrimmerParameters, channels: InputChannels, unstable: LimitCycle, stable: LimitCycle
) -> _FrictionLoop:
    return _FrictionLoop(
        pin=_PartialFractions.of(pin_model(parameters, channels=channels)),
        force=_PartialFractions.of(force_response(parameters)),
        omegas=((1 - BEYOND) * unstable.omega, (1 + BEYOND) * stable.omega),
    )


def _merger(loop: _FrictionLoop, ratio: float) -> FrictionCycle:
    found = loop.balances(np.array([ratio]))
    return FrictionCycle(found.amplitude.item(), found.frequency.item(), found.force_per_gap.item())


@dataclass(frozen=True)
class _PartialFractions:
    """A strictly proper system with distinct poles, in the form that is quickest to evaluate many times."""

    poles: Complexes
    residues: Complexes

    @classmethod
    def of(cls, system: control.StateSpace) -> _PartialFractions:
        poles, modes = np.linalg.eig(system.A)
        return cls(poles, (system.C @ modes)[0] * np.linalg.solve(modes, system.B.astype(complex))[:, 0])

    def response(self, omegas: Reals) -> Complexes:
        """Return the response at each ω (rad/s)."""
        return np.asarray((self.residues / (1j * omegas[:, np.newaxis] - self.poles)).sum(axis=1))


@dataclass(frozen=True)
class _FrictionLoop:
    """Responses of y to pin and friction, and the angular frequencies between which solutions lie."""

    pin: _PartialFractions
    force: _PartialFractions
    omegas: tuple[float, float]

    def balances(self, ratios: Reals) -> Balances:
        """Return the solution for each ratio gap/amplitude, by bisection in the frequency.

        A force that closes the balance is complex in general; the frequency is the one where it is real.
        """
        low, high = (np.full(ratios.shape, omega) for omega in self.omegas)
        sign = np.sign(self._closing_force(ratios, low).imag)
        for _ in range(HALVINGS):
            middle = (low + high) / 2
            same = np.sign(self._closing_force(ratios, middle).imag) == sign
            low, high = np.where(same, middle, low), np.where(same, high, middle)
        return Balances(1 / ratios, low, self._closing_force(ratios, low).real)

    def _closing_force(self, ratios: Reals, omegas: Reals) -> Complexes:
        backlash = BACKLASH.describing_function(1 / ratios)
        loop = 1 + backlash * self.pin.response(omegas)
        return np.asarray(-loop / (4j / math.pi * ratios * self.force.response(omegas)))


def _ratio_of_largest_force(loop: _FrictionLoop, first: float, last: float, points: int = POINTS) -> float:
    """Return the ratio gap/amplitude at the largest force, by ever finer grids and a last parabola."""
    for _ in range(ZOOMS):
        grid = np.linspace(first, last, points)
        forces = loop.balances(grid).force_per_gap
        best = int(np.clip(forces.argmax(), 1, points - 2))
        first, last = grid[best - 1], grid[best + 1]
    before, at, after = forces[best - 1 : best + 2]
    step = grid[1] - grid[0]
    return float(grid[best] + step / 2 * (before - after) / (before - 2 * at + after))
