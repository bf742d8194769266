"""Listing A.6 by its own formulas, and the loop with friction in its own place by matrices."""

from __future__ import annotations

import math

import control
import mpmath
import numpy as np
from scipy.optimize import brentq

from report.numbers.equivalent_nonlinearity import FORCE, GAP
from report.numbers.friction_in_place import Merger, force_response
from report.numbers.limit_cycle_numbers import DIGITS
from report.numbers.linear_numbers import LinearNumbers
from report.thesis import LISTING_DENOMINATOR, LISTING_NUMERATOR, TURN
from trimmer import FrictionBacklash, LimitCycle, response_at


def listing_function(amplitude: float, omega: float) -> complex:
    """Return N for the gap and the force of figure 5.23, an amplitude in m and ω in rad/s."""
    c = 1 - GAP / amplitude
    real = (math.pi / 2 + math.asin(c) + c * math.sqrt(1 - c**2)) / math.pi
    return complex(real, -(1 - c**2) / math.pi - 4 * FORCE / (math.pi * amplitude * omega))


def listing_by_newton(near: LimitCycle, force: float, gap: float, omega: float) -> tuple[float, float]:
    """Return A (m) and ω (rad/s) from the formulas of Listing A.6 and the coefficients of Listing A.9."""
    with mpmath.workdps(DIGITS):
        above, below = (
            [mpmath.mpf(c) for c in coefficients] for coefficients in (LISTING_NUMERATOR, LISTING_DENOMINATOR)
        )

        def residual(scaled: mpmath.mpf, turning: mpmath.mpf) -> tuple[mpmath.mpf, mpmath.mpf]:
            amplitude = scaled * near.amplitude
            c = 1 - gap / amplitude
            real = (mpmath.pi / 2 + mpmath.asin(c) + c * mpmath.sqrt(1 - c**2)) / mpmath.pi
            imaginary = -(1 - c**2) / mpmath.pi - 4 * force / (mpmath.pi * amplitude * omega)
            point = mpmath.mpc(0, turning * near.omega)
            linear = mpmath.polyval(above, point) / mpmath.polyval(below, point)
            loop = 1 + mpmath.mpc(real, imaginary) * linear
            return loop.real, loop.imag

        scaled, turning = mpmath.findroot(residual, (1, 1))
        return float(scaled * near.amplitude), float(turning * near.omega)


def frequency_of_strong_friction(system: control.TransferFunction, near: float) -> float:
    """Return the frequency (Hz) near another to which the listing's loop tends with a growing force.

    There the real part of 1/G is -1, in which the force takes no part.
    """

    def real_part(frequency: float) -> float:
        return (1 / complex(response_at(system, TURN * frequency))).real + 1

    return float(brentq(real_part, near - 1, near + 1))


def loop_at_merger(numbers: LinearNumbers, merger: Merger) -> complex:
    """Return the loop at the solution with the largest force, by the equations of motion at its frequency."""
    model, omega = force_response(numbers.parameters), TURN * merger.frequency
    by_force = complex(
        (model.C @ np.linalg.solve(1j * omega * np.eye(model.nstates) - model.A, model.B)).item()
    )
    by_pin = complex(response_at(numbers.displacement_only, omega))
    backlash = complex(FrictionBacklash(1.0).describing_function(merger.amplitude))
    return backlash * by_pin + 4j * merger.force_per_gap / (math.pi * merger.amplitude) * by_force
