"""Response of linear systems: to a sine in time, at a point s, and a Laplace transform by quadrature."""

from __future__ import annotations

import mpmath
import numpy as np
import sympy

from derivations.symbols import t
from report.thesis import DRIVE_FREQUENCY, DRIVE_OMEGA
from trimmer import InputChannels, TrimmerParameters, linear_model, pin_model, time_response

SETTLING_TIME = 0.6
"""s."""
SAMPLES_PER_PERIOD = 400


def settled_gain(parameters: TrimmerParameters) -> complex:
    """Fit a sine to the last of many simulated periods at the drive; return output over input (m/m)."""
    system = pin_model(parameters, channels=InputChannels.DISPLACEMENT_ONLY)
    times = np.arange(0, SETTLING_TIME, 1 / (DRIVE_FREQUENCY * SAMPLES_PER_PERIOD))
    output = time_response(system, times, np.sin(DRIVE_OMEGA * times)).outputs[-SAMPLES_PER_PERIOD:]
    turning = np.exp(-1j * DRIVE_OMEGA * times[-SAMPLES_PER_PERIOD:])
    return complex(2j * np.mean(output * turning))


def matrix_formula(parameters: TrimmerParameters, point: complex) -> complex:
    """Return C (s I − A)⁻¹ B of the trimmer at s = ``point`` (1/s), from the pin's displacement (m/m)."""
    model = linear_model(parameters)[0, 0]
    return complex((model.C @ np.linalg.solve(point * np.eye(len(model.A)) - model.A, model.B))[0, 0])


def laplace_integral(function: sympy.Expr, place: float) -> float:
    """Return the integral of a function of t times exp(−s t) over t from 0 at s = ``place`` (1/s)."""
    integrand = sympy.lambdify(t, function * sympy.exp(-place * t), "mpmath")
    return float(mpmath.quad(integrand, [0, mpmath.inf]))
