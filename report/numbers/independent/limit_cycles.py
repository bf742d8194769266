"""Limit cycles once more: Newton's method on the closed forms of the listings, and the loop with friction.

Newton's method uses the polynomials of G and the closed form of the element, and nothing of the solver.
"""

import math
from collections.abc import Callable, Sequence
from fractions import Fraction

import mpmath
import numpy as np

from report.numbers.friction_in_place import FrictionCycle, force_response
from report.numbers.independent.exact_response import quotient
from report.numbers.linear_numbers import LinearNumbers
from report.numbers.thesis import LISTING_DENOMINATOR, LISTING_NUMERATOR, TURN
from trimmer import FrictionBacklash, LimitCycle, response_at

DIGITS = 30
LISTING = tuple(tuple(map(Fraction, each)) for each in (LISTING_NUMERATOR, LISTING_DENOMINATOR))
"""G with the coefficients of Listing A.9."""


def _newton(
    polynomials: Sequence[Sequence[Fraction]],
    element: Callable[[mpmath.mpf], mpmath.mpc],
    start: float | mpmath.mpf,
    omega: float,
) -> tuple[mpmath.mpf, float]:
    """Solve 1 + N(x) G(jω) = 0 near x = ``start`` and ω (rad/s), in 30 digits."""
    above, below = polynomials

    def residual(x: mpmath.mpf, scaled: mpmath.mpf) -> tuple[mpmath.mpf, mpmath.mpf]:
        loop = 1 + element(x) * quotient(above, below, scaled * omega)
        return loop.real, loop.imag

    with mpmath.workdps(DIGITS):
        x, scaled = mpmath.findroot(residual, (start, 1))
        return x, float(scaled * omega)


def _friction(ratio: mpmath.mpf) -> mpmath.mpc:
    """Return N of Listing A.3 for an amplitude over the gap."""
    c = 1 - 1 / ratio
    real = (mpmath.pi / 2 + mpmath.asin(c) + c * mpmath.sqrt(1 - c**2)) / mpmath.pi
    return mpmath.mpc(real, -(1 - c**2) / mpmath.pi)


def friction_exactly(numbers: LinearNumbers, near: LimitCycle) -> tuple[float, float]:
    """Return A/gap and ω (rad/s) of friction-controlled backlash with the exact coefficients."""
    polynomials = numbers.numerator, numbers.denominator
    ratio, omega = _newton(polynomials, _friction, near.amplitude, near.omega)
    return float(ratio), omega


def friction_as_listed(near: LimitCycle) -> tuple[float, float]:
    """Return A/gap and ω (rad/s) of friction-controlled backlash with the coefficients of Listing A.9."""
    ratio, omega = _newton(LISTING, _friction, near.amplitude, near.omega)
    return float(ratio), omega


def equivalent_as_listed(near: LimitCycle, force: float, gap: float, drive: float) -> tuple[float, float]:
    """Return A (m) and ω (rad/s) by Listing A.6, with the drive's frequency (rad/s), and Listing A.9."""

    def element(scaled: mpmath.mpf) -> mpmath.mpc:
        amplitude = scaled * near.amplitude
        return _friction(amplitude / gap) - mpmath.mpc(0, 4 * force / (mpmath.pi * amplitude * drive))

    scaled, omega = _newton(LISTING, element, 1, near.omega)
    return float(scaled * near.amplitude), omega


def inertia_exactly(numbers: LinearNumbers, near: LimitCycle) -> tuple[float, float]:
    """Return A/gap and ω (rad/s) of inertia-controlled backlash, by Newton's method in the contact angle."""

    def element(angle: mpmath.mpf) -> mpmath.mpc:
        sine, cosine = mpmath.sin(angle), mpmath.cos(angle)
        real = mpmath.pi + 2 * sine - angle - sine * cosine
        return mpmath.mpc(real, -((1 - cosine) ** 2)) / mpmath.pi

    with mpmath.workdps(DIGITS):
        start = mpmath.findroot(lambda angle: angle - mpmath.sin(angle) - 1 / near.amplitude, 1.5)
        polynomials = numbers.numerator, numbers.denominator
        angle, omega = _newton(polynomials, element, start, near.omega)
        return float(1 / (angle - mpmath.sin(angle))), omega


def loop_at_merger(numbers: LinearNumbers, merger: FrictionCycle) -> complex:
    """Return the loop at the solution with the largest force, by the equations of motion at its frequency."""
    model, omega = force_response(numbers.parameters), TURN * merger.frequency
    by_force = complex(
        (model.C @ np.linalg.solve(1j * omega * np.eye(model.nstates) - model.A, model.B)).item()
    )
    by_pin = complex(response_at(numbers.displacement_only, omega))
    backlash = complex(FrictionBacklash(1.0).describing_function(merger.amplitude))
    return backlash * by_pin + 4j * merger.force_per_gap / (math.pi * merger.amplitude) * by_force
