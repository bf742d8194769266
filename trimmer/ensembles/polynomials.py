"""Many polynomials at once: values with derivatives, and all roots by the method of Aberth.

A polynomial is a row of coefficients, the highest power first; the last axis is that of the coefficients.
"""

from typing import NamedTuple

import numpy as np

from trimmer.arrays import Complexes, Flags, Reals

MOST_STEPS = 60  # Steps from starting values that are nowhere near; near ones need five or six
NEAR = 1e-12
"""Last step, as a share of a root's modulus, below which it is found: the next one would be its cube."""


class Roots(NamedTuple):
    """Roots of each polynomial, (n, degree), and whether all of them were found, (n,)."""

    values: Complexes
    found: Flags


def on_axis(coefficients: Reals, omegas: Reals) -> Complexes:
    """Evaluate real polynomials, (n, degree + 1), at s = j omega, (n, points), by real arithmetic alone."""
    squares = -(omegas**2)
    even = _in_squares(coefficients[:, ::-1][:, ::2], squares)
    odd = _in_squares(coefficients[:, ::-1][:, 1::2], squares)
    values = np.empty(omegas.shape, dtype=complex)
    values.real = even
    values.imag = odd * omegas
    return values


def _in_squares(rising: Reals, squares: Reals) -> Reals:
    """Evaluate polynomials with coefficients of rising powers, by Horner's scheme."""
    value = np.repeat(rising[:, -1:], squares.shape[1], axis=1)
    for power in range(rising.shape[1] - 2, -1, -1):
        value *= squares
        value += rising[:, power : power + 1]
    return value


def value_and_slope(coefficients: Reals | Complexes, s: Complexes) -> tuple[Complexes, Complexes]:
    """Evaluate polynomials, shape (n, degree + 1), and their derivatives at s, shape (n, ...)."""
    wide = coefficients.reshape(*coefficients.shape, *(1,) * (s.ndim - 1))
    value = np.broadcast_to(wide[:, 0], s.shape).astype(complex)
    slope = np.zeros_like(value)
    for power in range(1, coefficients.shape[1]):
        slope = slope * s + value
        value = value * s + wide[:, power]
    return value, slope


def roots(coefficients: Reals | Complexes, near: Complexes) -> Roots:
    """Find all roots of polynomials, (n, degree + 1), from different values near them, (n, degree).

    Those that were not found after ``MOST_STEPS`` are said to be so. Source: Aberth, Math. Comp. 27
    (1973), 339-344.
    """
    values = near.astype(complex)
    found = np.zeros(values.shape[0], dtype=bool)
    left = np.arange(values.shape[0])
    for _ in range(MOST_STEPS):
        z = values[left]
        step = _step(coefficients[left], z)
        values[left] = z - step
        done = (np.abs(step) <= NEAR * np.abs(z)).all(axis=1)
        found[left[done]] = True
        left = left[~done]
        if not left.size:
            break
    return Roots(values, found & np.isfinite(values).all(axis=1))


def _step(coefficients: Reals | Complexes, z: Complexes) -> Complexes:
    """Newton's step, with the other roots divided out."""
    value, slope = value_and_slope(coefficients, z)
    apart = z[:, :, None] - z[:, None, :]
    at = np.arange(z.shape[1])
    apart[:, at, at] = np.inf
    with np.errstate(all="ignore"):
        repelled = (1.0 / apart).sum(axis=2)
        step = value / (slope - value * repelled)
    return np.where(value == 0, 0.0, step)
