"""One step of the flow: exact to rounding, and its polynomials in both bases."""

from __future__ import annotations

import math

import mpmath
import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from trimmer.linear.model import pin_model
from trimmer.motion.taylor import (
    DEGREE,
    MOST_ZEROS,
    StepSeries,
    along,
    bernstein_from_taylor,
    step_series,
    sufficient_terms,
)
from trimmer.parameters import TrimmerParameters

FORCING = 1


def extended(matrix: np.ndarray) -> np.ndarray:
    """Append a state that is one and forces the first."""
    whole = np.zeros((len(matrix) + 1, len(matrix) + 1))
    whole[:-1, :-1] = matrix
    whole[0, -1] = 1.0
    return whole


def worst_error(series: StepSeries, matrix: np.ndarray, fraction: float) -> float:
    """Return the error of the series at a fraction of its step, relative to the moduli that it adds."""
    found = sum(term * fraction**k for k, term in enumerate(series.terms))
    moduli = sum(abs(term) * fraction**k for k, term in enumerate(series.terms))
    with mpmath.workdps(30):
        exact = mpmath.expm(mpmath.matrix(matrix.tolist()) * mpmath.mpf(series.step) * mpmath.mpf(fraction))
    expected = np.array(exact.tolist(), dtype=float)
    return float((abs(found - expected) / np.maximum(moduli, 1e-300)).max())


@pytest.mark.parametrize("fraction", [0.1, 1.0])
def test_a_step_of_the_trimmer_is_exact(fraction: float) -> None:
    matrix = extended(pin_model(TrimmerParameters.thesis()).A)
    series = step_series(matrix, FORCING)
    assert series.step > 1e-5
    assert worst_error(series, matrix, fraction) < 1e-14


@settings(max_examples=15)
@given(st.integers(0, 2**32 - 1), st.integers(1, 4), st.floats(-8, 8))
def test_a_step_of_any_matrix_is_exact(seed: int, size: int, exponent: float) -> None:
    matrix = extended(10**exponent * np.random.default_rng(seed).normal(size=(size, size)))
    assert worst_error(step_series(matrix, FORCING), matrix, 1.0) < 1e-13


def test_the_step_does_not_depend_on_the_size_of_what_forces() -> None:
    matrix = extended(np.array([[-1.0, 2.0], [-2.0, -1.0]]))
    forced = matrix.copy()
    forced[0, -1] = 1e9
    assert step_series(forced, FORCING).step == step_series(matrix, FORCING).step


def test_a_motion_that_hardly_changes_takes_long_steps() -> None:
    assert 1e6 <= step_series(np.zeros((3, 3)), FORCING).step < 1e8


def test_fewer_terms_do_for_a_small_fraction() -> None:
    series = step_series(extended(pin_model(TrimmerParameters.thesis()).A), FORCING)
    terms = sufficient_terms(series)
    assert (np.diff(terms) < 0).all()
    for level, count in enumerate(terms):
        fraction = 4.0**-level
        powers = fraction ** np.arange(DEGREE + 1)[:, None, None]
        whole, cut = (abs(series.terms[:n] * powers[:n]).sum(axis=0) for n in (DEGREE + 1, count))
        assert (whole - cut <= 2.0**-55 * whole).all()


def test_a_row_along_the_flow() -> None:
    matrix = np.array([[0.0, 1.0, 0.0], [-4.0, 0.0, 0.0], [0.0, 0.0, 0.0]])  # Cosine and sine of 2 t.
    series = step_series(matrix, FORCING)
    polynomial = np.array([1.0, 0.0, 1.0]) @ along(np.array([3.0, 0.0, 0.5]), series)
    for fraction in (0.2, 1.0):
        value = np.polynomial.polynomial.polyval(fraction, polynomial)
        assert value == pytest.approx(3.0 * math.cos(2.0 * series.step * fraction) + 0.5, rel=1e-14)


@pytest.mark.parametrize("zeros", range(MOST_ZEROS + 1))
def test_bernstein_coefficients_give_the_same_polynomial(zeros: int) -> None:
    degree = DEGREE - zeros
    taylor = np.random.default_rng(zeros).normal(size=degree + 1)
    bernstein = taylor @ bernstein_from_taylor()[zeros][: degree + 1, : degree + 1]
    for s in (0.0, 0.3, 1.0):
        basis = [math.comb(degree, i) * s**i * (1 - s) ** (degree - i) for i in range(degree + 1)]
        assert bernstein @ basis == pytest.approx(np.polynomial.polynomial.polyval(s, taylor), rel=1e-12)


STEP = (2.0**-56 * math.factorial(25)) ** (1 / 25)
"""Length of a step times the growth of its flow."""


@pytest.mark.parametrize(("omega", "drive"), [(1024.0, 691.0), (256.0, 691.0), (4.0, 0.0)])
def test_a_step_is_as_long_as_the_faster_of_states_and_drive_allows(omega: float, drive: float) -> None:
    # Balanced by powers of two, the oscillator is its frequency times a rotation, whose powers have norm one.
    matrix = np.zeros((5, 5))
    matrix[0, 1], matrix[1, 0] = 1.0, -(omega**2)
    matrix[2, 3], matrix[3, 2], matrix[1, 2:] = drive, -drive, (300.0, 0.0, -7.0)
    series = step_series(matrix, 3)
    assert series.step == pytest.approx(STEP / max(omega, drive), rel=1e-12)
    np.testing.assert_allclose(series.whole, series.terms.sum(axis=0), rtol=1e-12, atol=1e-12)
    for k in (0, 1, 2, DEGREE):
        expected = np.linalg.matrix_power(matrix * series.step, k) / math.factorial(k)
        np.testing.assert_allclose(series.terms[k], expected, rtol=1e-10, atol=1e-28)


def test_the_growth_of_a_chain_is_the_root_of_the_norm_of_its_power() -> None:
    # [[-2, 2], [0, -2]]^25 = -2^25 [[1, -25], [0, 1]], whose largest column sum is 26 2^25.
    chain = step_series(extended(np.array([[-2.0, 2.0], [0.0, -2.0]])), FORCING)
    assert chain.step == pytest.approx(STEP / (2 * 26 ** (1 / 25)), rel=1e-12)
    assert step_series(np.zeros((3, 3)), FORCING).step == pytest.approx(1e6 * STEP, rel=1e-12)
    # A decay alone is as fast as it is.
    assert step_series(extended(np.array([[-7.0]])), FORCING).step == pytest.approx(STEP / 7, rel=1e-12)
