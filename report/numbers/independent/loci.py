"""Loci of G and of describing functions on grids: crossings and solutions counted, angles by differences."""

from __future__ import annotations

import control
import numpy as np

from trimmer import response_at
from trimmer.balance.limit_cycle import LimitCycle
from trimmer.elements.element import Element
from trimmer.elements.friction_backlash import FrictionBacklash

GRID = np.geomspace(1, 1e6, 20_000)
FINE_GRID = np.geomspace(100, 1e5, 40_001)
PHASE_GRID = np.geomspace(1.0, 1e5, 20_001)
"""Angular frequencies, rad/s."""
STEP = 1e-6
"""Relative step of a difference."""


def crossings(system: control.TransferFunction) -> int:
    """Return how often a locus crosses the negative real axis."""
    response = response_at(system, GRID)
    return int((np.diff(np.sign(response.imag)).astype(bool) & (response.real[1:] < 0)).sum())


def solutions(system: control.TransferFunction, share: float) -> int:
    """Return the number of solutions of 1 + N G = 0 for backlash with a term j 4 share/(π A), A in gaps.

    At each frequency of a grid the real part of N, which rises with A, gives A; what is left of the imaginary
    part then changes its sign at a solution.
    """
    needed = -1 / np.asarray(response_at(system, FINE_GRID))
    amplitudes = 0.5 + np.geomspace(1e-9, 1e6, FINE_GRID.size)
    element = FrictionBacklash(1.0).describing_function(amplitudes)
    amplitude = np.interp(needed.real, element.real, amplitudes, left=np.nan, right=np.nan)
    imaginary = np.interp(needed.real, element.real, element.imag) + 4 * share / (np.pi * amplitude)
    left = imaginary - needed.imag
    return int((left[:-1] * left[1:] < 0).sum())


def phase_range(system: control.TransferFunction) -> tuple[float, float]:
    """Return the lowest and the highest phase of a locus, degrees."""
    phase = np.degrees(np.unwrap(np.angle(response_at(system, PHASE_GRID))))
    return float(phase.min()), float(phase.max())


def angle(system: control.TransferFunction, element: Element, cycle: LimitCycle) -> float:
    """Return the angle between N and -1/G at a limit cycle, rad, at most π/2."""
    around = np.array([1 - STEP, 1 + STEP])
    gains = element.describing_function(cycle.amplitude * around)
    inverse = -1 / response_at(system, cycle.omega * around)
    directions = [complex(np.diff(curve)[0]) for curve in (gains, inverse)]
    turned = abs(np.angle(directions[1] / directions[0]))
    return float(min(turned, np.pi - turned))
