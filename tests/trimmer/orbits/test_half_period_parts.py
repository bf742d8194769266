"""The half-period equation in its parts: intervals, tanh of a matrix, pieces, unequal switches."""

from __future__ import annotations

import math
from itertools import pairwise
from types import SimpleNamespace

import numpy as np
import pytest
import scipy.linalg
from numpy.polynomial import chebyshev

from trimmer.orbits import half_period, unequal_switches
from trimmer.orbits.half_period import (
    POINTS,
    TO_COEFFICIENTS,
    HalfPeriodEquation,
    Piece,
    _first_pieces,
    _joined,
    _on_piece,
    _tanh,
    _without_repetition,
    interval_of,
    zeros,
)
from trimmer.orbits.unequal_switches import _alike, _cells, _pair, _solved, _switching


def equation_of(A: list, b: list, row: list, level: float = 0.0) -> HalfPeriodEquation:
    matrix = np.zeros((len(b) + 1, len(b) + 1))
    matrix[:-1, :-1], matrix[:-1, -1] = A, b
    return HalfPeriodEquation(matrix, np.array(row, dtype=float), level)


OMEGA = 691.0
INTERVALS = {
    "poles -2 and -50, zero -26": (([[-2, 0], [0, -50]], [1, 1], [1, 1]), (0.01 / 50, 40 / 2)),
    "an undamped mode": (([[0, 1], [-(OMEGA**2), 0]], [0, 1], [1, 0]), (0.01 / OMEGA, 50 * np.pi / OMEGA)),
    "a lightly damped mode": (
        ([[0, 1], [-400.25, -1]], [0, 1], [1, 0]),
        (0.01 / math.sqrt(400.25), 50 * np.pi / math.sqrt(400.25)),
    ),
    "an undamped mode beside a fast pole": (
        ([[0, 3, 0], [-3, 0, 0], [0, 0, -20]], [0, 1, 1], [1, 0, 1]),
        (0.01 / 20, 50 * np.pi / 3),
    ),
    "a zero at -500": (([[-1, 0], [0, -2]], [1, 1], [499, -498]), (0.01 / 500, 40.0)),
    "a zero at -5000, too far": (([[-1, 0], [0, -2]], [1, 1], [4999, -4998]), (0.01 / 2, 40.0)),
    "an integrator beside a pole": (([[0, 0], [0, -4]], [1, 1], [1, 0]), (0.01 / 4, 10.0)),
    "two integrators and a zero at -3": (([[0, 1], [0, 0]], [0, 1], [3, 1]), (0.01 / 3, 40 / 3)),
    "an integrator alone": (([[0]], [1], [1]), (0.01, 1000.0)),
}


@pytest.mark.parametrize("name", INTERVALS)
def test_the_interval_spans_the_time_constants(name: str) -> None:
    system, interval = INTERVALS[name]
    assert interval_of(equation_of(*system)) == pytest.approx(interval, rel=1e-9)


def test_tanh_of_matrices_is_that_of_scipy() -> None:
    matrices = np.array([[[0.1, -0.2], [0.05, 0.15]], [[0.0, 0.0], [0.0, 0.0]]])
    np.testing.assert_allclose(_tanh(matrices)[0], scipy.linalg.tanhm(matrices[0]), rtol=1e-13)
    assert not _tanh(matrices[1:]).any()
    large = np.array([[[3.0, -20.0, 1.0], [7.0, 0.5, 0.0], [2.0, -1.0, -9.0]]])
    np.testing.assert_allclose(_tanh(large)[0], scipy.linalg.tanhm(large[0]), rtol=1e-10)
    for x in (0.24, 0.25, 1.7, 300.0, -0.26, -300.0):
        assert _tanh(np.array([[[x]]]))[0, 0, 0] == pytest.approx(math.tanh(x), rel=4e-15)


def test_the_state_of_a_stiff_oscillator_returns_with_its_signs_changed() -> None:
    equation = equation_of([[0, 1], [-(OMEGA**2), -10]], [3.0, 1e4], [1.0, 0.002])
    for half, state in zip((1e-3, 4e-3), equation.states(np.array([1e-3, 4e-3])), strict=True):
        later = scipy.linalg.expm(equation.matrix * half) @ np.append(state, 1.0)
        np.testing.assert_allclose(later[:2], -state, rtol=1e-10)


def test_a_level_moves_the_zero() -> None:
    """x' = 1 - x begins at -tanh(T/2)."""
    found = zeros(equation_of([[-1]], [1], [-1], 0.5), (0.1, 10.0))
    assert found.halves == pytest.approx([2 * math.atanh(0.5)], rel=1e-12)
    assert found.undecided == ()
    assert zeros(equation_of([[-1]], [1], [-1], 1.5), (0.1, 10.0)).halves == ()


def test_where_the_left_side_is_zero_everywhere_nothing_is_decided() -> None:
    found = zeros(equation_of([[-1]], [1], [0]), (0.1, 10.0))
    assert found.halves == ()
    ((begin, end),) = found.undecided
    assert (begin, end) == pytest.approx((0.1, 10.0))


def test_what_is_left_after_many_pieces_is_undecided(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(half_period, "MOST_PIECES", 2)
    found = zeros(equation_of([[-1]], [1], [-1], 0.5), (0.1, 10.0))
    assert found.halves == ()
    ((begin, end),) = found.undecided  # Of twelve pieces two were examined.
    assert (begin, end) == pytest.approx((0.1 * 100 ** (2 / 12), 10.0))


@pytest.mark.parametrize("place", [120.0, 0.0021])
def test_a_piece_is_halved_until_it_is_narrow(monkeypatch: pytest.MonkeyPatch, place: float) -> None:
    def on_piece(equation, begin, end):
        return Piece.UNRESOLVED if begin <= place < end else [begin]

    monkeypatch.setattr(half_period, "_on_piece", on_piece)
    found = zeros(equation_of([[-1]], [1], [0]), (0.7 * place, 1.3 * place))
    ((begin, end),) = found.undecided
    assert begin <= place < end
    assert 0.49e-5 * place < end - begin <= 1e-5 * end
    assert found.halves[0] == pytest.approx(0.7 * place)
    assert list(found.halves) == sorted(found.halves)


def test_pieces_cover_the_interval_in_a_fixed_ratio() -> None:
    pieces = _first_pieces((2.0, 2.0 * 1.4**3))
    ends = [2.0, 2.8, 3.92, 5.488]
    expected = list(pairwise(ends))[::-1]
    assert [each for piece in pieces for each in piece] == pytest.approx(
        [each for piece in expected for each in piece]
    )
    assert _first_pieces((2.0, 2.2)) == [pytest.approx((2.0, 2.2))]


def test_a_zero_of_two_pieces_counts_once_and_touching_intervals_are_one() -> None:
    rising = [0.01, 100.0, 100.0 + 5e-8, 100.0 + 2e-7, 100.1]
    assert _without_repetition(rising) == (0.01, 100.0, 100.0 + 2e-7, 100.1)
    assert _without_repetition([]) == ()
    assert _joined([(1.0, 2.0), (2.0, 3.0), (3.0 + 1e-9, 4.0), (5.0, 6.0)]) == (
        (1.0, 3.0),
        (3.0 + 1e-9, 4.0),
        (5.0, 6.0),
    )


UNEQUAL = equation_of([[0, 1, 0], [-400, -8, 0], [3, 0, -30]], [0.5, 100.0, 2.0], [1.0, 0.02, -0.3])


def test_unequal_durations_lead_back_to_the_state_they_began_with() -> None:
    pair = _pair(UNEQUAL, np.array([0.23, 0.11]))
    assert pair[:2] == (0.23, 0.11)
    state = np.append(pair[2], 1.0)
    middle = scipy.linalg.expm(UNEQUAL.matrix * 0.23) @ state
    end = scipy.linalg.expm(UNEQUAL.matrix * 0.11) @ np.append(-middle[:-1], 1.0)
    np.testing.assert_allclose(-end[:-1], pair[2], rtol=1e-10)
    # The mirror image of the orbit with the shorter duration first begins where this one does.
    swapped = _pair(UNEQUAL, np.array([0.11, 0.23]))
    assert swapped[:2] == (0.23, 0.11)
    np.testing.assert_allclose(swapped[2], pair[2], rtol=1e-10)
    long, short = (UNEQUAL.tangents(np.array([each])) for each in (0.23, 0.11))
    shares = [float(UNEQUAL.row @ x) / float(abs(UNEQUAL.row) @ abs(x)) for x in (pair[2], middle[:-1])]
    np.testing.assert_allclose(_switching(UNEQUAL, long, short)[0], shares, rtol=1e-9)


def test_pairs_are_alike_if_both_durations_are() -> None:
    state = np.zeros(1)
    assert _alike((2.0, 1.0, state), (2.0 + 1e-8, 1.0, state))
    assert not _alike((2.0, 1.0, state), (2.0, 1.0 + 1e-6, state))
    assert not _alike((2.0, 1.0, state), (2.0 + 1e-6, 1.0, state))


def test_cells_are_those_where_both_functions_change_their_signs() -> None:
    values = np.full((4, 4, 2), np.nan)
    for i in range(4):
        for j in range(i + 1):
            values[i, j] = i - 1.5, j - 0.5
    assert _cells(values) == [(1, 0)]
    values[..., 1] = i + 7.0
    assert _cells(values) == []
    values[..., 1] = 0.0  # A zero at a corner is a change of sign.
    assert _cells(values) == [(1, 0), (1, 1)]


EQUATION = SimpleNamespace(tangents=lambda durations: durations)
STARTS = np.array([[0.0, 0.0]])


def solved(monkeypatch: pytest.MonkeyPatch, functions, starts=STARTS) -> list:
    """Logarithms at zeros of functions of logarithms."""

    def switching(equation, long, short):
        return np.stack(functions(np.log(long), np.log(short)), axis=-1)

    monkeypatch.setattr(unequal_switches, "_switching", switching)
    return _solved(EQUATION, np.asarray(starts)).tolist()


def test_a_common_zero_is_found_from_each_start(monkeypatch: pytest.MonkeyPatch) -> None:
    def functions(u, v):
        return np.sin(u - 0.5) + 0.2 * (v + 0.2), np.exp(v + 0.2) - 1.0 + 0.1 * (u - 0.5)

    starts = [[0.0, 0.0], [0.9, -0.6], [0.5, -0.2]]
    assert solved(monkeypatch, functions, starts) == [pytest.approx([0.5, -0.2], abs=1e-9)] * 3


@pytest.mark.parametrize("zero", [(0.5, -0.2), (-0.2, 0.5), (0.6, 0.6 - 2e-4), (0.9, -0.95)])
def test_either_duration_may_be_the_longer_one(monkeypatch: pytest.MonkeyPatch, zero: tuple) -> None:
    found = solved(monkeypatch, lambda u, v: (u - zero[0], v - zero[1]))
    assert found == [pytest.approx(zero, abs=1e-9)]


@pytest.mark.parametrize("zero", [(0.6, 0.6 - 5e-5), (0.6, 0.6), (1.1, 0.5), (0.5, -1.1)])
def test_equal_durations_and_far_ones_are_left_out(monkeypatch: pytest.MonkeyPatch, zero: tuple) -> None:
    assert solved(monkeypatch, lambda u, v: (u - zero[0], v - zero[1])) == []


def test_a_zero_of_one_function_alone_is_none(monkeypatch: pytest.MonkeyPatch) -> None:
    assert solved(monkeypatch, lambda u, v: (u - 0.5, v * v + 0.1)) == []
    assert solved(monkeypatch, lambda u, v: (u * u + 0.1, v - 0.5)) == []
    assert solved(monkeypatch, lambda u, v: (u - 0.5, np.full_like(v, np.nan))) == []


def test_slopes_that_are_singular_leave_the_values_as_steps(monkeypatch: pytest.MonkeyPatch) -> None:
    """Both functions depend on the sum alone, which is zero at the start."""
    start = [[0.3, -0.3]]
    assert solved(monkeypatch, lambda u, v: (u + v, u + v), start) == [pytest.approx([0.3, -0.3])]
    # No step is longer than 0.3: eight of them lead no farther than the farthest.
    assert solved(monkeypatch, lambda u, v: (u + v - 9.0, u + v - 9.0), start) == []


def on_piece(values, level: float = 0.0, others=None) -> list[float] | Piece:
    """Zeros from 3 to 7 of a function of x = (T - 5)/2, as the only state of an equation, or less another."""

    def states(halves: np.ndarray) -> np.ndarray:
        x = (halves - 5.0) / 2.0
        return np.column_stack(
            [values(x) + (0.0 if others is None else others), np.full(len(x), others or 0.0)]
        )

    return _on_piece(SimpleNamespace(states=states, row=np.array([1.0, -1.0]), level=level), 3.0, 7.0)


def test_values_in_chebyshev_points_give_coefficients() -> None:
    given = np.random.default_rng(1).normal(size=32)
    np.testing.assert_allclose(TO_COEFFICIENTS @ chebyshev.chebval(POINTS, given), given, atol=1e-12)


def test_zeros_on_a_piece_are_roots_of_its_polynomial() -> None:
    assert on_piece(lambda x: 2.0 + 2.1 * x) == pytest.approx([5 - 2 * 2 / 2.1], rel=1e-13)
    assert on_piece(lambda x: -2.0 - 2.1 * x) == pytest.approx([5 - 2 * 2 / 2.1], rel=1e-13)
    assert on_piece(lambda x: x, level=0.25) == pytest.approx([5.5], rel=1e-13)
    assert on_piece(lambda x: 0.5 + chebyshev.Chebyshev([0, 0, 1])(x)) == pytest.approx([4.0, 6.0], rel=1e-12)
    found = on_piece(lambda x: (x + 0.5) * (x - 0.2) * (x - 0.9))
    assert sorted(found) == pytest.approx([4.0, 5.4, 6.8], rel=1e-12)
    # A little beyond the ends counts; a pair that is nearly real counts as two that have merged.
    for end in (1.0, -1.0):
        found = on_piece(lambda x, end=end: (x - 0.1) * (x - end * (1 + 5e-6)))
        assert sorted(found) == pytest.approx(sorted([5.2, 5.0 + 2 * end * (1 + 5e-6)]), rel=1e-12)
    assert on_piece(lambda x: (x - 0.1) * (x - 1 - 2e-5)) == pytest.approx([5.2], rel=1e-12)
    assert on_piece(lambda x: (x - 0.3) ** 2 + 2.5e-11) == pytest.approx([5.6, 5.6], abs=1e-4)
    assert on_piece(lambda x: (x - 0.3) ** 2 + 1e-8) == []


def test_where_the_mean_outweighs_the_rest_no_roots_are_computed(monkeypatch: pytest.MonkeyPatch) -> None:
    asked: list = []
    monkeypatch.setattr(chebyshev, "chebroots", lambda given: asked.append(len(given)) or np.array([]))
    for sign in (1.0, -1.0):
        assert on_piece(lambda x, sign=sign: sign * (2.0 - 1.9 * x)) == []
        assert on_piece(lambda x, sign=sign: sign * (2.0 - x) + 0.9 * (2 * x * x - 1)) == []
    assert asked == []
    on_piece(lambda x: 2.0 - 1.2 * x + 0.9 * (2 * x * x - 1))
    assert len(asked) == 1


def test_a_piece_is_halved_where_its_last_coefficients_count() -> None:
    def with_wave(order: int, size: float):
        return lambda x: x + size * np.cos(order * np.arccos(x))

    for order in (28, 29, 31):
        assert on_piece(with_wave(order, 2e-11)) is Piece.UNRESOLVED
        assert on_piece(with_wave(order, -2e-11)) is Piece.UNRESOLVED
        assert on_piece(with_wave(order, 5e-12)) == pytest.approx([5.0], abs=1e-10)
    assert on_piece(with_wave(27, 1e-3)) == pytest.approx([5.0], abs=1e-10)
    assert on_piece(lambda x: np.where(x > 0.9, np.nan, x)) is Piece.UNRESOLVED


def test_what_is_rounding_everywhere_is_undecided() -> None:
    assert on_piece(lambda x: 1e-7 * x, others=1e6) is Piece.UNDECIDED
    assert on_piece(lambda x: 1e-4 * x, others=1e6) == pytest.approx([5.0], abs=1e-4)
    assert on_piece(lambda x: 0.0 * x) is Piece.UNDECIDED
    assert on_piece(lambda x: 3.0 + 1e-12 * x, level=3.0) is Piece.UNDECIDED

    def singular(halves: np.ndarray) -> np.ndarray:
        raise np.linalg.LinAlgError

    equation = SimpleNamespace(states=singular, row=np.ones(1), level=0.0)
    assert _on_piece(equation, 3.0, 7.0) is Piece.UNRESOLVED


def test_newtons_method_begins_in_the_middle_of_each_cell(monkeypatch: pytest.MonkeyPatch) -> None:
    begun: list = []
    durations = np.geomspace(0.01, 2.0, 48)
    monkeypatch.setattr(unequal_switches, "_cells", lambda values: [(20, 7), (47 - 1, 0)])
    monkeypatch.setattr(
        unequal_switches, "_solved", lambda equation, starts: begun.extend(starts.tolist()) or []
    )
    assert unequal_switches.unequal_switches(UNEQUAL, (0.01, 2.0)) == []
    places = [(20, 7), (46, 0)]
    middles = np.sqrt(durations[:-1] * durations[1:])
    np.testing.assert_allclose(np.exp(begun), [[middles[i], middles[j]] for i, j in places])
    monkeypatch.setattr(unequal_switches, "_cells", lambda values: [])
    assert unequal_switches.unequal_switches(UNEQUAL, (0.01, 2.0)) == []
    assert len(begun) == 2


def test_where_there_is_no_value_shorter_durations_are_tried(monkeypatch: pytest.MonkeyPatch) -> None:
    def functions(u, v):
        return np.where(u > -0.2, np.nan, u + 0.5), v - 0.2

    assert solved(monkeypatch, functions) == [pytest.approx([-0.5, 0.2], abs=1e-9)]
