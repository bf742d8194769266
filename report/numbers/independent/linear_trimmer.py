"""The linear trimmer once more: from its state space, its coefficients, or by search over a grid."""

from __future__ import annotations

import math
from collections.abc import Sequence
from fractions import Fraction

import control
import numpy as np
from scipy.integrate import solve_ivp
from scipy.optimize import brentq

from report.thesis import DRIVE_AMPLITUDE, DRIVE_FREQUENCY, DRIVE_OMEGA, TURN
from trimmer import TrimmerParameters, filtering_ratio, linear_model
from trimmer.arrays import Complexes

ROUNDING = 1e-10
"""Singular value below which a matrix with entries of order one has no full rank."""
SEARCHED = np.linspace(10, 2000, 8000) * TURN
"""Angular frequencies, rad/s."""


def deviation_from_pin(parameters: TrimmerParameters) -> float:
    """Return the largest difference of output and pin in the first period from rest, m, by SciPy's DOP853."""
    model = linear_model(parameters)[0, 0]
    state, drive, output = np.asarray(model.A), np.asarray(model.B)[:, 0], np.asarray(model.C)[0]
    times = np.linspace(0, 1 / DRIVE_FREQUENCY, 1001)
    run = solve_ivp(
        lambda time, x: state @ x + drive * (DRIVE_AMPLITUDE * math.sin(DRIVE_OMEGA * time)),
        (0, times[-1]),
        np.zeros(drive.size),
        "DOP853",
        times,
        rtol=1e-9,
        atol=1e-12,
    )
    return float(np.abs(output @ run.y - DRIVE_AMPLITUDE * np.sin(DRIVE_OMEGA * times)).max())


def states_in_use(system: control.StateSpace) -> int:
    """Count the eigenvalues that the input reaches and the output shows (Popov, Belevitch, Hautus)."""
    scale = float(np.abs(system.poles()).max())
    states = np.repeat([1.0, scale], system.nstates // 2)
    a = system.A * states / states[:, None] / scale
    b, c = system.B / states[:, None] / scale, system.C * states
    shifted = [a - eigenvalue * np.eye(system.nstates) for eigenvalue in np.linalg.eigvals(a)]
    return sum(_full_rank(np.hstack([each, b])) and _full_rank(np.vstack([each, c])) for each in shifted)


def _full_rank(matrix: Complexes) -> bool:
    return float(np.linalg.svd(matrix, compute_uv=False).min()) > ROUNDING


def impulse_response_grows(system: control.TransferFunction) -> bool:
    """Return whether the response to an impulse is larger after two seconds than after one."""
    early, late = control.impulse_response(system, np.array([1.0, 2.0])).outputs
    return bool(abs(late) > abs(early))


def highest_unfiltered(system: control.TransferFunction, harmonics: range) -> float:
    """Return the highest frequency, Hz, at which some harmonic passes at least as well as the fundamental."""
    highest = 0.0
    for harmonic in harmonics:
        excess = filtering_ratio(system, SEARCHED, harmonic) - 1
        above = np.flatnonzero(excess >= 0)
        if above.size and above[-1] + 1 < SEARCHED.size:
            bracket = SEARCHED[above[-1]], SEARCHED[above[-1] + 1]
            root = brentq(lambda omega, n=harmonic: float(filtering_ratio(system, omega, n)) - 1, *bracket)
            highest = max(highest, root / TURN)
    return highest


def peaks_on_grid(numerator: Sequence[Fraction], denominator: Sequence[Fraction], above: float) -> int:
    """Count the maxima of the gain that exceed a level, on a grid of 0.5 rad/s from 100 to 10000 rad/s."""
    points = 1j * np.arange(100, 10000, 0.5)
    magnitude = np.abs(np.polyval(list(map(float, numerator)), points))
    magnitude /= np.abs(np.polyval(list(map(float, denominator)), points))
    inner = magnitude[1:-1]
    return int(np.sum((inner > magnitude[:-2]) & (inner > magnitude[2:]) & (inner > above)))


def gain_of_state_space(parameters: TrimmerParameters, omega: float) -> float:
    """Return |C (jω - A)⁻¹ B| from the pin's displacement at ω (rad/s), without a transfer function."""
    model = linear_model(parameters)[0, 0]
    resolvent = np.linalg.solve(1j * omega * np.eye(model.nstates) - model.A, model.B)
    return float(abs((model.C @ resolvent)[0, 0]))
