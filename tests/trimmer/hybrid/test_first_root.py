"""The first zero of a polynomial on [0, 1]: none missed, whatever the distance to the next."""

from collections.abc import Callable
from fractions import Fraction
from itertools import pairwise

import mpmath
import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from tests.quick import examples
from trimmer.hybrid.compilation import kept, sources
from trimmer.hybrid.first_root import DEEPEST, NOWHERE, first_root
from trimmer.hybrid.taylor import DEGREE, bernstein_from_taylor

COUNT = DEGREE + 1
ROUNDING = 1e-14


def entry(sources: bytes) -> Callable[..., tuple[float, float]]:
    def compiled_search(
        bernstein: np.ndarray, taylor: np.ndarray, rounding: float, pieces: np.ndarray
    ) -> tuple[float, float]:
        sources  # noqa: B018
        return first_root(bernstein, taylor, COUNT, rounding, pieces)

    return kept(compiled_search)


COMPILED_SEARCH = entry(sources())


def search(taylor: list[float]) -> tuple[float, float]:
    """Return first zero and touch of a polynomial that is given by its coefficients of s^k."""
    coefficients = np.zeros(COUNT)
    coefficients[: len(taylor)] = taylor
    bernstein = coefficients @ bernstein_from_taylor()[0]
    assert bernstein[0] > 0
    return COMPILED_SEARCH(bernstein, coefficients, ROUNDING, np.empty((DEEPEST + 3, COUNT + 2)))


def with_zeros(zeros: list[float]) -> list[float]:
    """Return the coefficients of the polynomial with these zeros that is positive at 0, rounded once."""
    product = [Fraction(1)]
    for zero in map(Fraction, zeros):
        product = [
            a * -zero + b for a, b in zip([*product, Fraction(0)], [Fraction(0), *product], strict=True)
        ]
    sign = 1 if product[0] > 0 else -1
    return [float(sign * each) for each in product]


@settings(max_examples=examples(12, 60))
@given(st.lists(st.floats(0.01, 3.0), min_size=1, max_size=5, unique=True))
def test_the_first_zero_is_found_to_its_conditioning(zeros: list[float]) -> None:
    zeros = sorted(zeros)
    if any(later - first < 0.02 for first, later in pairwise(zeros)):
        return
    found, _ = search(with_zeros(zeros))
    if zeros[0] > 1.0:
        assert found == NOWHERE
    else:
        assert found == pytest.approx(zeros[0], abs=1e-9)


@pytest.mark.parametrize("width", [1e-2, 1e-4, 1e-6])
@pytest.mark.parametrize("place", [0.01, 0.3, 0.9])
def test_a_short_excursion_is_not_stepped_over(width: float, place: float) -> None:
    """What a solver with a step of its own misses: below zero for a millionth of the step."""
    found, _ = search(with_zeros([place, place + width]))
    assert found == pytest.approx(place, abs=1e-15 / width)


def test_a_minimum_that_stays_above_zero_is_no_event() -> None:
    assert search([0.09 + 1e-9, -0.6, 1.0]) == (NOWHERE, NOWHERE)


@pytest.mark.parametrize("place", [0.123, 1 / 3, 0.7])
def test_a_minimum_that_rounding_hides_is_a_touch(place: float) -> None:
    root, touch = search([place**2 + 1e-15, -2 * place, 1.0])
    assert root == NOWHERE
    assert touch == pytest.approx(place, abs=1e-3)


@pytest.mark.parametrize("width", [0.5, 1e-3, 1e-6])
def test_a_crossing_is_no_touch(width: float) -> None:
    assert search(with_zeros([0.3, 0.3 + width]))[1] == NOWHERE


@pytest.mark.parametrize("seed", range(8))
def test_the_zero_is_as_exact_as_the_coefficients(seed: int) -> None:
    taylor = [1.0, -0.7, -1.9, *np.random.default_rng(seed).uniform(-0.4, 0.4, 3).tolist()]
    with mpmath.workdps(30):
        exact = min(
            root.real
            for root in mpmath.polyroots(taylor[::-1], maxsteps=200)
            if abs(root.imag) < 1e-20 and 0 < root.real < 1
        )
    assert search(taylor)[0] == pytest.approx(float(exact), rel=2.5e-16)
