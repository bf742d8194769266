"""The linear trimmer once more: from its state space, its coefficients, or by search over a grid."""

import math
from collections.abc import Sequence
from fractions import Fraction

import control
import numpy as np
from scipy.integrate import solve_ivp
from scipy.optimize import brentq

from report.numbers.thesis import DRIVE_AMPLITUDE, DRIVE_FREQUENCY, DRIVE_OMEGA, TURN
from trimmer import TrimmerParameters, linear_model, pin_model
from trimmer.arrays import Complexes, Reals
from trimmer.linear import InputChannels, filtering_ratio, time_response

ROUNDING = 1e-10  # Singular value below which a matrix with entries of order one has no full rank
SEARCHED = np.linspace(10, 2000, 8000) * TURN
"""Angular frequencies at which the filtering of harmonics is searched, rad/s."""
SETTLING_TIME, SAMPLES_PER_PERIOD = 0.6, 400
"""Length of a simulation that a sine is fitted to, s, and samples of a period of the drive."""


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


def settled_gain(parameters: TrimmerParameters) -> complex:
    """Fit a sine to the last of many simulated periods at the drive; return output over input (m/m)."""
    system = pin_model(parameters, channels=InputChannels.DISPLACEMENT_ONLY)
    times = np.arange(0, SETTLING_TIME, 1 / (DRIVE_FREQUENCY * SAMPLES_PER_PERIOD))
    output = time_response(system, times, np.sin(DRIVE_OMEGA * times)).outputs[-SAMPLES_PER_PERIOD:]
    turning = np.exp(-1j * DRIVE_OMEGA * times[-SAMPLES_PER_PERIOD:])
    return complex(2j * np.mean(output * turning))


def matrix_formula(parameters: TrimmerParameters, point: complex) -> complex:
    """Return C (s I − A)⁻¹ B at s = ``point`` (1/s), from the pin's displacement alone (m/m)."""
    model = linear_model(parameters)[0, 0]
    return complex((model.C @ np.linalg.solve(point * np.eye(len(model.A)) - model.A, model.B))[0, 0])


def antiresonances(system: control.TransferFunction) -> Reals:
    """Return the imaginary parts of the zeros, rising, rad/s."""
    zeros = np.roots(system.num[0][0])
    return np.sort(zeros.imag[zeros.imag > 0])


def antiresonances_without_damping(parameters: TrimmerParameters, weights: Reals) -> Reals:
    """Return where an output of the undamped system stays zero, rad/s; ``weights`` are those of q1 to q4.

    There (K - ω² M) q = F p with w·q = 0: a bordered matrix without inverse.
    """
    model = linear_model(parameters)
    flow, force = np.asarray(model.A)[4:, :4], np.asarray(model.B)[4:, :1]
    omegas = np.linspace(100.0, 9000.0, 20_000)
    bordered = np.zeros((omegas.size, 5, 5))
    bordered[:, :4, :4] = -flow - omegas[:, None, None] ** 2 * np.eye(4)
    bordered[:, :4, 4:], bordered[:, 4, :4] = force, weights
    values = np.linalg.det(bordered)
    places = np.flatnonzero(np.diff(np.sign(values)))
    share = values[places] / (values[places] - values[places + 1])
    return omegas[places] + share * (omegas[places + 1] - omegas[places])
