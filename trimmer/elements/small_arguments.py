"""Differences that lose all digits for small arguments when they are evaluated as written.

Arguments are arrays of any shape, which the result has too; none has a unit.
"""

from math import factorial

import numpy as np

from trimmer.arrays import Reals

SMALL = 0.25
"""Below it the series are used: the first term they leave out is less than 1e-17 of their first one."""
SINE = [(-1.0) ** k / factorial(2 * k + 3) for k in range(6)]
COSINE = [(-1.0) ** k / factorial(2 * k + 4) for k in range(6)]
HYPERBOLIC_SINE = [1.0 / factorial(2 * k + 3) for k in range(6)]
SPHERICAL = [(-1.0) ** k * (2 * k + 2) / factorial(2 * k + 3) for k in range(13)]
SPHERICAL_SMALL = 2.0
"""Below it the series of sin x - x cos x is used; the first term it leaves out is less than 1e-19."""
DECAY = [(-1.0) ** k / factorial(k + 2) for k in range(12)]
DECAY_INTEGRAL = [(-1.0) ** k / factorial(k + 3) for k in range(12)]


def argument_less_sine(x: Reals) -> Reals:
    """Evaluate x - sin x for x >= 0, by its series where x is small."""
    value = np.asarray(x - np.sin(x))
    small = x < SMALL
    if small.any():
        value[small] = x[small] ** 3 * sine_remainder(x[small])
    return value


def sine_less_cosine_part(x: Reals) -> Reals:
    """Evaluate sin x - x cos x for x >= 0, by its series x³/3 - x⁵/30 + ... up to x = 2."""
    value = np.asarray(np.sin(x) - x * np.cos(x))
    small = x < SPHERICAL_SMALL
    if small.any():
        value[small] = x[small] ** 3 * _series(x[small] ** 2, SPHERICAL)
    return value


def damped_excess_of_sinh(x: Reals) -> Reals:
    """Evaluate 2 exp(-x) (sinh x - x) for x >= 0; it rises from 0 to 1."""
    small = np.minimum(x, SMALL)
    decay = np.exp(-x)
    series = 2.0 * decay * small**3 * _series(small**2, HYPERBOLIC_SINE)
    # Beyond x = 750 the last term is zero, and inf * 0 must not make it NaN.
    return np.where(x < SMALL, series, -np.expm1(-2.0 * x) - 2.0 * np.minimum(x, 750.0) * decay)


def sine_remainder(x: Reals) -> Reals:
    """Evaluate (x - sin x) / x³ for 0 <= x <= SMALL."""
    return _series(x**2, SINE)


def cosine_remainder(x: Reals) -> Reals:
    """Evaluate (cos x - 1 + x²/2) / x⁴ for 0 <= x <= SMALL."""
    return _series(x**2, COSINE)


def decay_remainder(x: Reals) -> Reals:
    """Evaluate (exp(-x) - 1 + x) / x² for 0 <= x <= SMALL."""
    return _series(x, DECAY)


def decay_integral_remainder(x: Reals) -> Reals:
    """Evaluate (1 - exp(-x) - x + x²/2) / x³ for 0 <= x <= SMALL."""
    return _series(x, DECAY_INTEGRAL)


def _series(x: Reals, coefficients: list[float]) -> Reals:
    value = np.full_like(x, coefficients[-1])
    for coefficient in reversed(coefficients[:-1]):
        value *= x
        value += coefficient
    return value
