"""Frequency response from the exact coefficients in many digits."""

from collections.abc import Sequence
from fractions import Fraction

import mpmath

from report.numbers.linear_numbers import LinearNumbers

DIGITS = 40


def quotient(
    numerator: Sequence[Fraction], denominator: Sequence[Fraction], omega: float | mpmath.mpf
) -> mpmath.mpc:
    """Return the quotient of two polynomials in jω, ω in rad/s, to as many digits as mpmath is set to."""
    above, below = (
        mpmath.polyval([mpmath.mpf(c.numerator) / c.denominator for c in each], mpmath.mpc(0, omega))
        for each in (numerator, denominator)
    )
    return above / below


def response(numbers: LinearNumbers, omega: float | mpmath.mpf) -> mpmath.mpc:
    """Return G(jω) from the pin's displacement alone, with 40 digits."""
    with mpmath.workdps(DIGITS):
        return quotient(numbers.numerator, numbers.denominator, omega)


def gain(numbers: LinearNumbers, omega: float | mpmath.mpf) -> mpmath.mpf:
    """Return |G(jω)| from the pin's displacement alone, with 40 digits."""
    with mpmath.workdps(DIGITS):
        return abs(response(numbers, omega))


def gain_ratio(numbers: LinearNumbers, omega: float, harmonic: int) -> float:
    """Return how well a harmonic of ω (rad/s) passes over the fundamental."""
    return float(gain(numbers, harmonic * omega) / gain(numbers, omega))


def gain_crossing(numbers: LinearNumbers, level: float, near: float) -> float:
    """Return the frequency near a guess (rad/s) where |G| has a level, by the secant method."""
    with mpmath.workdps(DIGITS):
        root = mpmath.findroot(lambda omega: gain(numbers, omega) - level, (near, near * 1.0001))
        return float(root)


def peak(numbers: LinearNumbers, near: float) -> float:
    """Return the frequency near a guess (rad/s) where |G| is stationary, by a numeric derivative of it."""
    with mpmath.workdps(DIGITS):
        slope = mpmath.findroot(
            lambda omega: mpmath.diff(lambda each: gain(numbers, each), omega), (near, near * 1.0001)
        )
        return float(slope)


def eigenvalues(numbers: LinearNumbers) -> list[complex]:
    """Return the roots of the exact denominator, 1/s."""
    with mpmath.workdps(DIGITS):
        coefficients = [mpmath.mpf(c.numerator) / c.denominator for c in numbers.denominator]
        return [complex(root) for root in mpmath.polyroots(coefficients, maxsteps=200, extraprec=200)]
