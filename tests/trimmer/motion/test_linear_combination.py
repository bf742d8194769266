"""Sums of rows and values of polynomials, in plain Python, against NumPy; what is beyond a count stays."""

from __future__ import annotations

import numpy as np
import pytest

from trimmer.motion.linear_combination import (
    all_positive,
    any_below,
    combine,
    combine_moduli,
    combine_polynomials,
    combined_moduli,
    copy,
    evaluate_polynomial,
    evaluate_terms,
    within,
)
from trimmer.motion.taylor import DEGREE

COUNT = DEGREE + 1


def python(function):
    """Return the function that is compiled."""
    return function.py_func


@pytest.fixture
def random() -> np.random.Generator:
    return np.random.default_rng(691)


def test_the_first_values_are_copied() -> None:
    result = np.full(4, 9.0)
    python(copy)(np.array([3.0, -1.0, 5.0, 7.0]), 2, result)
    assert result.tolist() == [3.0, -1.0, 9.0, 9.0]


@pytest.mark.parametrize("weights", [1, 2, 4, 5, 6, 9, 12])
def test_any_number_of_rows_is_combined(weights: int, random: np.random.Generator) -> None:
    given, rows = random.normal(size=weights), random.normal(size=(weights, 7))
    result = np.full(7, 9.0)
    python(combine)(given, rows, 5, result)
    np.testing.assert_allclose(result[:5], (given @ rows)[:5], rtol=1e-12, atol=1e-14)
    assert result[5:].tolist() == [9.0, 9.0]


def test_polynomials_and_the_moduli_of_their_weights(random: np.random.Generator) -> None:
    weights, rows = np.array([-1.3, 0.4, -2.6]), random.uniform(0.1, 1.0, size=(3, COUNT))
    sums, moduli = np.full(COUNT, 9.0), np.full(COUNT, 9.0)
    python(combine_polynomials)(weights, rows, sums)
    python(combine_moduli)(weights, rows, moduli)
    np.testing.assert_allclose(sums, weights @ rows, rtol=1e-13, atol=1e-15)
    np.testing.assert_allclose(moduli, abs(weights) @ rows, rtol=1e-13)
    for place in (0, DEGREE):
        assert python(combined_moduli)(weights, rows[:, place]) == pytest.approx(moduli[place], rel=1e-14)


def test_a_state_from_its_terms(random: np.random.Generator) -> None:
    terms = random.normal(size=(4, 3))
    for count in (1, 2, 4):
        result = np.empty(3)
        python(evaluate_terms)(terms.ravel(), count, 0.3, result)
        np.testing.assert_allclose(result, 0.3 ** np.arange(count) @ terms[:count], rtol=1e-13)


def test_a_polynomial_at_points(random: np.random.Generator) -> None:
    coefficients, points = random.normal(size=COUNT), np.array([0.0, 0.3, -0.7, 1.0])
    values = np.empty(4)
    python(evaluate_polynomial)(coefficients, points, values)
    np.testing.assert_allclose(values, np.polynomial.polynomial.polyval(points, coefficients), rtol=1e-12)


def test_within_a_bound() -> None:
    assert python(within)(np.array([1.0, -2.0, 2.0]), 2.0)
    assert not python(within)(np.array([1.0, -2.1, 0.0]), 2.0)
    assert not python(within)(np.array([2.1, 1.0]), 2.0)
    assert not python(within)(np.array([0.0, np.nan]), 2.0)


def test_all_positive() -> None:
    assert python(all_positive)(np.array([1.0, 1e-300]))
    for value in (0.0, -1.0, np.nan):
        assert not python(all_positive)(np.array([1.0, value, 2.0]))


def test_any_below() -> None:
    values = np.array([3.0, 2.0, 1.0])
    assert python(any_below)(values, 3, 2.0)
    assert not python(any_below)(values, 2, 2.0)
    assert python(any_below)(values, 2, 2.5)
    assert not python(any_below)(values, 0, 9.0)
