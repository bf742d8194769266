"""The tables of a mode, in plain Python, against closed forms and SciPy."""

from __future__ import annotations

import math

import numpy as np
import pytest
import scipy.linalg

from tests.trimmer.uncompiled import uncompile
from trimmer.contact import series
from trimmer.contact.series import COUNT, STEP, ModeTables, tabulate
from trimmer.motion.taylor import (
    DEGREE,
    LEVELS,
    LONGEST_STEP,
    REMAINDER,
    StepSeries,
    bernstein_from_taylor,
    sufficient_terms,
)

STATES, ORDER = 2, 691.0
"""States of the flow below; angular frequency of its drive, rad/s."""


@pytest.fixture(autouse=True)
def plain(monkeypatch: pytest.MonkeyPatch) -> None:
    uncompile(monkeypatch, series)


def forced_oscillator(omega: float, drive: float) -> np.ndarray:
    """Return the flow of an undamped oscillator driven by a sine, a cosine and a constant."""
    flow = np.zeros((5, 5))
    flow[0, 1], flow[1, 0] = 1.0, -(omega**2)
    flow[1, 2], flow[1, 4] = 300.0, -7.0
    flow[2, 3], flow[3, 2] = drive, -drive
    return flow


def tabulated(flow: np.ndarray, rows: np.ndarray) -> tuple[float, ModeTables]:
    size, functions = len(flow), len(rows)
    target = ModeTables(
        np.full((size, size + functions * COUNT), np.nan),
        np.full((size, COUNT * size), np.nan),
        np.zeros(LEVELS, dtype=np.int64),
        np.full((functions, size, COUNT), np.nan),
        np.full((functions, COUNT, size), np.nan),
        bernstein_from_taylor(),
    )
    return tabulate(flow, STATES, rows, target), target


def test_the_step_is_as_long_as_the_fastest_of_states_and_drive_allows() -> None:
    # Balanced, the block of an oscillator is its frequency times a rotation, whose powers have norm one.
    rows = np.zeros((0, 5))
    assert tabulated(forced_oscillator(900.0, ORDER), rows)[0] == pytest.approx(STEP / 900, rel=1e-12)
    assert tabulated(forced_oscillator(200.0, ORDER), rows)[0] == pytest.approx(STEP / ORDER, rel=1e-12)
    assert tabulated(np.zeros((5, 5)), rows)[0] == pytest.approx(STEP * LONGEST_STEP, rel=1e-12)
    assert STEP**COUNT / math.factorial(COUNT) == pytest.approx(REMAINDER, rel=1e-9, abs=0.0)


def test_the_tables_are_those_of_the_exponential() -> None:
    flow, rows = forced_oscillator(900.0, ORDER), np.array([[1.0, -2.0, 0.5, 0.0, -4e-5], [0, 3.0, 0, 1, 2]])
    step, tables = tabulated(flow, rows)
    whole = scipy.linalg.expm(flow * step)
    np.testing.assert_allclose(tables.screen[:, :5].T, whole, rtol=1e-11, atol=1e-12)
    terms = [np.linalg.matrix_power(flow * step, k) / math.factorial(k) for k in range(COUNT)]
    for k in (0, 1, 2, DEGREE):
        part = tables.series[:, 5 * k : 5 * (k + 1)].T
        np.testing.assert_allclose(part, terms[k], rtol=1e-11, atol=1e-25)
    for number, row in enumerate(rows):
        np.testing.assert_allclose(
            tables.taylor[number], np.array([row @ term for term in terms]).T, rtol=1e-10, atol=1e-20
        )
        np.testing.assert_allclose(
            tables.sizes[number], np.array([abs(row) @ abs(term) for term in terms]), rtol=1e-10, atol=1e-20
        )
        bernstein = tables.screen[:, 5 + number * COUNT : 5 + (number + 1) * COUNT]
        np.testing.assert_allclose(bernstein[:, 0], row, rtol=1e-13, atol=1e-18)
        np.testing.assert_allclose(bernstein[:, -1], row @ whole, rtol=1e-10, atol=1e-11)
        # The first slope of Bernstein coefficients is that of the polynomial over its degree.
        slope = (bernstein[:, 1] - bernstein[:, 0]) * DEGREE
        np.testing.assert_allclose(slope, row @ flow * step, rtol=1e-10, atol=1e-12)


def test_the_number_of_terms_for_each_fraction() -> None:
    flow = forced_oscillator(900.0, ORDER)
    step, tables = tabulated(flow, np.zeros((0, 5)))
    terms = np.array([np.linalg.matrix_power(flow * step, k) / math.factorial(k) for k in range(COUNT)])
    # The other package counts the same terms; a difference of one is one of rounding.
    assert abs(tables.terms - sufficient_terms(StepSeries(step, terms))).max() <= 1
    assert tables.terms[0] >= COUNT - 2
    assert (np.diff(tables.terms) <= 0).all()


def test_terms_that_do_for_a_fraction() -> None:
    # exp(s h) of one state: 1 + x + x^2/2 + ... with x = h 4^-level, h = STEP.
    terms = (STEP ** np.arange(COUNT) / [float(math.factorial(k)) for k in range(COUNT)]).reshape(-1, 1, 1)
    for level in (0, 1, 3):
        x = STEP / 4**level
        powers = [x**k / math.factorial(k) for k in range(COUNT)]
        left = [sum(powers[k:]) for k in range(COUNT + 1)]
        expected = next(k for k, rest in enumerate(left) if rest <= REMAINDER * left[0])
        # The rest is the difference of two rounded sums, so one term more or less is the same.
        assert abs(series._sufficient(terms, level) - expected) <= 1
    # Of several entries the slowest counts; what ends ends exactly.
    ends = np.zeros((COUNT, 2, 2))
    ends[0], ends[1, 0, 1], ends[2, 1, 0] = 1.0, 0.5, 0.25
    assert series._sufficient(ends, 0) == 3
    ends[2] = 0.0
    assert series._sufficient(ends, 1) == 2
    ends[1] = 0.0
    assert series._sufficient(ends, 0) == 1
    assert series._sufficient(np.zeros((COUNT, 2, 2)), 0) == 1


def test_a_product_and_a_norm() -> None:
    left, right = np.array([[0.0, 2.0], [-3.0, 5.0]]), np.array([[7.0, 1.0], [4.0, -6.0]])
    result = np.full((2, 2), np.nan)
    series._multiply(left, right, 0.5, result)
    assert result.tolist() == [[4.0, -6.0], [-0.5, -16.5]]
    matrix = np.array([[1.0, -9.0, 50.0], [2.0, 3.0, 0.0], [60.0, -4.0, 0.5]])
    assert series._norm(matrix, 0, 2) == 12.0
    assert series._norm(matrix, 1, 3) == 7.0
    assert series._norm(matrix, 2, 2) == 0.0


def test_a_balanced_matrix_has_equal_sums_and_the_same_eigenvalues() -> None:
    matrix = np.array([[1.0, -1e6, 3.0], [2.0, -4.0, -5e-4], [-70.0, 8e3, 2.0]])
    balanced = matrix.copy()
    series._balance(balanced)
    off = abs(balanced - np.diag(np.diag(balanced)))
    np.testing.assert_allclose(off.sum(axis=0), off.sum(axis=1), rtol=1e-3)
    np.testing.assert_allclose(np.diag(balanced), np.diag(matrix), rtol=1e-12)
    np.testing.assert_allclose(
        np.sort_complex(np.linalg.eigvals(balanced)), np.sort_complex(np.linalg.eigvals(matrix)), rtol=1e-9
    )
    triangular = np.array([[1.0, 5.0], [0.0, 1.0]])
    series._balance(triangular)
    assert triangular.tolist() == [[1.0, 5.0], [0.0, 1.0]]


def test_the_growth_of_a_chain_is_the_root_of_the_norm_of_its_power() -> None:
    # [[1, 1], [0, 1]]^25 = [[1, 25], [0, 1]], whose largest column sum is 26.
    room = np.full((3, 2, 2), np.nan)
    assert series._growth(np.array([[1.0, 1.0], [0.0, 1.0]]), room) == pytest.approx(
        26 ** (1 / 25), rel=1e-13
    )
    # What is beyond the room's block does not count.
    larger = np.array([[-3.0, 0.0, 9.0], [0.0, 2.0, 9.0], [0.0, 0.0, 50.0]])
    assert series._growth(larger, room) == pytest.approx(3.0, rel=1e-13)
    assert series._growth(np.zeros((2, 2)), room) == 0.0
