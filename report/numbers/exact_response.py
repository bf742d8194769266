"""Frequency response from the exact coefficients in many digits: the second way for claims of chapter 5."""

from __future__ import annotations

import mpmath

from report.numbers.linear_numbers import LinearNumbers

DIGITS = 40


def response(numbers: LinearNumbers, omega: float | mpmath.mpf) -> mpmath.mpc:
    """Return G(jω) from the pin's displacement alone, with 40 digits."""
    with mpmath.workdps(DIGITS):
        numerator, denominator = (
            mpmath.polyval(
                [mpmath.mpf(c.numerator) / c.denominator for c in coefficients], mpmath.mpc(0, omega)
            )
            for coefficients in (numbers.numerator, numbers.denominator)
        )
        return numerator / denominator


def gain(numbers: LinearNumbers, omega: float | mpmath.mpf) -> mpmath.mpf:
    """Return |G(jω)| from the pin's displacement alone, with 40 digits."""
    with mpmath.workdps(DIGITS):
        return abs(response(numbers, omega))


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
    """Return the roots of the exact denominator."""
    with mpmath.workdps(DIGITS):
        coefficients = [mpmath.mpf(c.numerator) / c.denominator for c in numbers.denominator]
        return [complex(root) for root in mpmath.polyroots(coefficients, maxsteps=200, extraprec=200)]
