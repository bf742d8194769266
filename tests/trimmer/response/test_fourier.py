"""Fourier sums of polynomials over steps, slow and fast, held against integrals by parts."""

from __future__ import annotations

from types import SimpleNamespace

import numpy as np
import pytest
from numpy.polynomial import Polynomial

from trimmer.contact.nodes import NODES
from trimmer.response.fourier import _projected, fourier

EDGES = np.array([0.0, 0.7, 1.0, 2.5])
"""Of the steps of a motion."""


def motion() -> SimpleNamespace:
    points, weights = np.polynomial.legendre.leggauss(NODES)
    halves = 0.5 * np.diff(EDGES)[:, None]
    times = EDGES[:-1, None] + halves * (1 + points)
    return SimpleNamespace(
        nodes=SimpleNamespace(times=times.ravel(), weights=(halves * weights).ravel()), duration=EDGES[-1]
    )


def by_parts(signal: Polynomial, omega: float) -> complex:
    """Integral of a polynomial times exp(-i omega t) over the motion."""
    total, sign, each = 0j, 1.0, signal
    for power in range(signal.degree() + 1):
        ends = each(EDGES[-1]) * np.exp(-1j * omega * EDGES[-1]) - each(0.0)
        total += sign * ends / (-1j * omega) ** (power + 1)
        sign, each = -sign, each.deriv()
    return total


@pytest.mark.parametrize("omega", [0.9, 7.0, 200.0])
def test_sums_of_polynomials_are_exact_at_any_frequency(omega: float) -> None:
    signals = [Polynomial([2.0, -1.0, 0.5, 3.0]), Polynomial([0.3, 0.0, -4.0])]
    course = motion()
    values = np.column_stack([signal(course.nodes.times) for signal in signals])
    found = fourier(course, values, omega, 6)
    assert found.shape == (6, 2)
    expected = [[2.0 / 2.5 * by_parts(each, n * omega) for each in signals] for n in range(1, 7)]
    np.testing.assert_allclose(found, expected, rtol=1e-9, atol=1e-12)


def test_a_wave_is_replaced_by_what_has_the_same_integrals() -> None:
    points, weights = np.polynomial.legendre.leggauss(NODES)
    fine, fine_weights = np.polynomial.legendre.leggauss(400)
    for angle, found in zip((3.5, 40.0), _projected(np.array([3.5, 40.0])), strict=True):
        for degree in (0, 1, 4):
            exact = fine_weights @ (fine**degree * np.exp(-1j * angle * fine))
            assert weights @ (points**degree * found) == pytest.approx(exact, abs=1e-12)
