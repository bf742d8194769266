"""The first zero of a polynomial and a known exponential on [0, 1]: the right one, or no answer."""

import math
from collections.abc import Callable

import mpmath
import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from trimmer.hybrid.compilation import kept, sources
from trimmer.hybrid.decaying_root import UNSURE, decaying_root
from trimmer.hybrid.first_root import NOWHERE
from trimmer.hybrid.taylor import DEGREE, bernstein_from_taylor

COUNT = DEGREE + 1
GRID = np.linspace(0.0, 1.0, 4_001)


def entry(sources: bytes) -> Callable[..., float]:
    def compiled_search(
        bernstein: np.ndarray, taylor: np.ndarray, stretch: float, decay: float, pieces: np.ndarray
    ) -> float:
        sources  # noqa: B018
        return decaying_root(bernstein, taylor, stretch, decay, pieces)

    return kept(compiled_search)


COMPILED_SEARCH = entry(sources())


def search(taylor: list[float], stretch: float, decay: float) -> float:
    """Return the first zero of a polynomial, given by its coefficients of s^k, and the exponential."""
    coefficients = np.zeros(COUNT)
    coefficients[: len(taylor)] = taylor
    bernstein = coefficients @ bernstein_from_taylor()[0]
    return COMPILED_SEARCH(bernstein, coefficients, stretch, decay, np.empty((3, COUNT + 2)))


def values(taylor: list[float], stretch: float, decay: float) -> np.ndarray:
    """Return the sum on a fine grid."""
    return np.polyval(taylor[::-1], GRID) + stretch * np.exp(-decay * GRID)


@settings(max_examples=70)
@given(
    st.floats(0.05, 2.0),
    st.lists(st.floats(-6.0, 6.0), min_size=1, max_size=5),
    st.floats(-1.0, 1.0),
    st.floats(0.0, 60.0),
)
def test_what_it_finds_is_the_first_zero(
    start: float, others: list[float], stretch: float, decay: float
) -> None:
    taylor = [start, *others]
    found, on_grid = search(taylor, stretch, decay), values(taylor, stretch, decay)
    size = 1e-12 * (sum(map(abs, taylor)) + abs(stretch))
    if found == UNSURE:
        return
    assert start > abs(stretch)
    before = (found if found < NOWHERE else 2.0) - 1e-9 > GRID
    assert on_grid[before].min(initial=1.0) > -size
    if found < NOWHERE:
        at = mpmath.polyval(taylor[::-1], mpmath.mpf(found)) + stretch * mpmath.exp(
            -decay * mpmath.mpf(found)
        )
        assert abs(at) <= size


@pytest.mark.parametrize("sign", [1, -1])
@pytest.mark.parametrize("decay", [5.0, 10.0, 22.0])
def test_a_flight_across_the_gap_is_decided_without_shorter_steps(sign: int, decay: float) -> None:
    # It begins half a gap from contact, moves away first, and lands in the same step.
    taylor, stretch = [0.5, 1.0, -2.5], sign * 0.1
    found = search(taylor, stretch, decay)
    with mpmath.workdps(30):
        expected = mpmath.findroot(
            lambda s: mpmath.polyval(taylor[::-1], s) + stretch * mpmath.exp(-decay * s), found
        )
    assert 0.5 < found < 1.0
    assert found == pytest.approx(float(expected), rel=4e-16)


@settings(max_examples=50)
@given(st.floats(0.2, 0.6), st.floats(0.01, 0.1), st.floats(0.05, 0.2), st.sampled_from([-1e-7, 1e-7]))
def test_of_several_falls_through_zero_the_first_one_counts(
    first: float, dip: float, gap: float, stretch: float
) -> None:
    # Rising at first, so that Newton's method from the start goes elsewhere.
    zeros = [first, first + dip, first + dip + gap, -0.1, -0.2]
    product = -np.poly(zeros)[::-1]
    found = search(list(product), stretch, 30.0)
    assert found in (pytest.approx(first, abs=1e-6), UNSURE)


def test_no_zero_is_no_zero_and_what_is_close_is_left_to_shorter_steps() -> None:
    assert search([1.0, 0.5, -0.9], 0.3, 10.0) == NOWHERE
    # Closer to contact at the start than the spring is stretched.
    assert search([0.1, 1.0, -3.0], 0.2, 10.0) == UNSURE
    # What is left of the stretch is more than what is left of the gap in the later half.
    assert search([2.5, -6.0, 4.0], -0.45, 0.3) == UNSURE
    # In the middle less of the gap is left than the spring is stretched at first, and the wall is met later.
    assert search([1.0, -1.9], 0.1, 30.0) == UNSURE
    # Hardly relaxing, it might meet the wall anywhere while that falls by less than the stretch.
    assert search([0.5, -0.3], -0.4, 0.1) == UNSURE


def test_the_spring_decides_when_the_gap_closes() -> None:
    # g = 1/2 - s; with the spring the zero is where s - 1/2 = z exp(-decay s), after 1/2 or before.
    for stretch in (0.05, -0.05):
        found = search([0.5, -1.0], stretch, 4.0)
        assert (found > 0.5) == (stretch > 0.0)
        assert found - 0.5 == pytest.approx(stretch * math.exp(-4.0 * found), rel=1e-13)


@pytest.mark.parametrize("stretch", [0.2, -0.2])
def test_the_slope_of_the_gap_is_compared_with_the_fastest_that_the_spring_can_relax(stretch: float) -> None:
    # g = 0.32 - s falls at 1, the spring at most at 0.2 decay: 0.98, and 1.02.
    found = search([0.32, -1.0], stretch, 4.9)
    with mpmath.workdps(30):
        expected = mpmath.findroot(lambda s: mpmath.mpf(0.32) - s + stretch * mpmath.exp(-4.9 * s), found)
    assert found == pytest.approx(float(expected), rel=1e-14, abs=0.0)
    assert search([0.32, -1.0], stretch, 5.1) == UNSURE
