"""The parts of the search without bounds: cells, starts, edges, and what they leave out."""

from __future__ import annotations

import math
from dataclasses import dataclass
from types import SimpleNamespace

import numpy as np
import pytest

from tests.trimmer.balance.loops import THIRD_ORDER, s
from trimmer.balance import sampled
from trimmer.balance.cells import Cells
from trimmer.balance.element_curve import ElementCurve
from trimmer.balance.inverse_response import InverseResponse
from trimmer.balance.sampled import (
    _corners,
    _distinct,
    _first_cells,
    _Grid,
    _linear_part_may_vanish,
    _may_hold,
    _range_of_roots,
    _solutions,
    _starts,
    _with_edge,
    solve_sampled,
    unproven,
)
from trimmer.balance.search import Searched, SearchResult
from trimmer.elements.relay import Relay
from trimmer.linear.zero_pole_gain import ZeroPoleGain


def response(G) -> InverseResponse:
    return InverseResponse.of(ZeroPoleGain.of(G))


@dataclass(frozen=True)
class Ending:
    """N = u between two places, or where asked 2 u + 3j x; it does not exist beyond them."""

    lowest: float = 0.0
    highest: float = math.inf
    depends_on_x: bool = False

    def value(self, u: np.ndarray, x: np.ndarray) -> np.ndarray:
        value = 2.0 * u + 3j * x if self.depends_on_x else u.astype(complex)
        return np.where((u >= self.lowest) & (u <= self.highest), value, np.nan)


def grid(*cells: tuple[float, float, float, float]) -> _Grid:
    return _Grid(*np.array(cells, float).T)


def rows(cells: _Grid) -> set[tuple[float, ...]]:
    columns = (cells.v_lower, cells.v_upper, cells.x_lower, cells.x_upper)
    return set(zip(*(column.tolist() for column in columns), strict=True))


def test_a_cell_has_four_quarters() -> None:
    assert rows(grid((0.0, 2.0, 10.0, 14.0)).quarters()) == {
        (0.0, 1.0, 10.0, 12.0),
        (1.0, 2.0, 10.0, 12.0),
        (0.0, 1.0, 12.0, 14.0),
        (1.0, 2.0, 12.0, 14.0),
    }
    two = grid((0.0, 2.0, 10.0, 14.0), (1.0, 3.0, 5.0, 6.0))
    assert rows(two.take(np.array([False, True]))) == {(1.0, 3.0, 5.0, 6.0)}


def test_the_range_goes_three_decades_beyond_the_roots() -> None:
    inverse = InverseResponse(1.0 + 0j, np.array([0.0, -2.0, -5.0 + 0j]), np.array([-0.5 + 0j]), 10.0)
    assert np.exp(_range_of_roots(inverse)) == pytest.approx([5e-3, 5e4])
    none = InverseResponse(1.0 + 0j, np.zeros(2, complex), np.zeros(0, complex), 1.0)
    assert np.exp(_range_of_roots(none)) == pytest.approx([1e-3, 1e3])


@pytest.mark.parametrize("bound_to_x", [False, True])
def test_corners_are_those_of_the_cell_in_their_order(bound_to_x: bool) -> None:
    inverse = response(1 / (s + 7))
    cells = grid((0.0, 1.0, 2.0, 3.0), (1.0, 1.5, 2.0, 3.0))
    corners = _corners(inverse, Ending(depends_on_x=bound_to_x), cells)
    assert corners.shape == (4, 2)
    for place, (v_end, x) in enumerate([(0.0, 2.0), (1.0, 2.0), (0.0, 3.0), (1.0, 3.0)]):
        gain = 2.0 * math.exp(v_end) + 3j * x if bound_to_x else math.exp(v_end)
        assert corners[place, 0] == pytest.approx(gain + 7.0 + 1j * math.exp(x))
    assert corners[3, 1] - corners[2, 1] == pytest.approx((1 + bound_to_x) * (math.exp(1.5) - math.e))


def test_a_cell_may_hold_a_zero_within_a_widened_disk() -> None:
    square = np.array([-1 - 1j, 1 - 1j, -1 + 1j, 1 + 1j])
    reach = 1.5 * math.sqrt(2.0)
    shifts = np.array([0.0, 0.99 * reach, 1.01 * reach, np.nan])
    assert _may_hold(square[:, None] + shifts).tolist() == [True, True, False, False]
    assert _may_hold(square[:, None] - shifts).tolist() == [True, True, False, False]
    assert _may_hold(square[:, None] + 1j * shifts).tolist() == [True, True, False, False]
    # The farthest corner of all counts.
    narrow = np.array([-1.0, 1.0, -3j, 3j])[:, None]
    assert _may_hold(narrow + np.array([4.4, 4.6])).tolist() == [True, False]


def test_where_many_cells_are_left_the_linear_function_has_to_vanish_near() -> None:
    # F = p v + q x + shift with zero at v = -shift/p for q = 1j p: within 1.5 widths of the middle.
    p = 2.0 + 1.0j
    corners = np.array([0.0, p, 1j * p, p + 1j * p]) - 0.5 * (p + 1j * p)

    def vanishes(v: float, x: float) -> bool:
        moved = (corners + v * p + x * 1j * p)[:, None]
        return bool(_linear_part_may_vanish(moved, moved.mean(axis=0))[0])

    assert vanishes(0.0, 0.0)
    assert [vanishes(v, 0.0) for v in (1.49, -1.49, 1.51, -1.51)] == [True, True, False, False]
    assert [vanishes(0.0, x) for x in (1.49, -1.49, 1.51, -1.51)] == [True, True, False, False]
    assert not vanishes(1.0, 1.6)
    assert not vanishes(1.6, 1.0)
    # At the margin itself it is kept, whichever way round the derivatives lie.
    for q in (1j, -1j):
        square = np.array([0.0, 1.0, q, 1.0 + q]) - 0.5 * (1.0 + q)
        for shift, kept in ((1.5, True), (-1.5, True), (1.5j, True), (-1.5j, True), (1.6, False)):
            moved = (square + shift)[:, None]
            assert _linear_part_may_vanish(moved, moved.mean(axis=0)).tolist() == [kept]


def test_of_parallel_slopes_the_linear_function_tells_nothing() -> None:
    def kept(angle: float) -> bool:
        p, q = 1.0 + 0j, np.exp(1j * angle)
        corners = np.array([0.0, p, q, p + q])[:, None] + 100.0 * 1j
        return bool(_linear_part_may_vanish(corners, corners.mean(axis=0))[0])

    assert kept(math.asin(0.049))
    assert not kept(math.asin(0.051))


def test_only_many_cells_are_sieved_twice() -> None:
    # Beside a zero 1.9 widths away, in the disk but not near the linear function's.
    p = 1.0 + 0j
    corners = np.array([0.0, p, 1j * p, p + 1j * p]) - 0.5 * (p + 1j * p)
    far = corners + 1.02
    assert abs(far.mean()) < 1.5 * math.sqrt(0.5)
    far = np.array([0.0, p, 0.3j, p + 0.3j]) - 0.5 * (p + 0.3j) + 0.5j
    assert _may_hold(np.repeat(far[:, None], 1000, axis=1)).all()
    assert not _may_hold(np.repeat(far[:, None], 1001, axis=1)).any()


def test_places_are_added_towards_both_ends_of_n() -> None:
    v = np.linspace(-2.0, 2.0, 5)
    added = _with_edge(Ending(math.exp(-1.3), math.exp(0.7)), v)
    assert (np.diff(added) > 0).all()
    assert set(v) <= set(added)
    existing = added[(added >= -1.3) & (added <= 0.7)]
    assert existing[0] == pytest.approx(-1.3, abs=1e-11)
    assert existing[-1] == pytest.approx(0.7, abs=1e-11)
    # Towards the lower end from -1 on, and towards the upper from 0 on: each half as far as the last.
    for share in (0.5, 0.25, 2.0**-20):
        assert np.abs(added - (-1.3 + 0.3 * share)).min() < 1e-11
        assert np.abs(added - (0.7 - 0.7 * share)).min() < 1e-11
    assert _with_edge(Ending(), v).tolist() == v.tolist()
    shares = 0.5 ** np.arange(40.0)
    expected = np.concatenate([v, [-1.3, 0.7], -1.3 + 0.3 * shares, 0.7 - 0.7 * shares])
    assert np.abs(added[:, None] - expected).min(axis=1).max() < 1e-11
    assert np.abs(added[:, None] - expected).min(axis=0).max() < 1e-11
    # Downwards from a place that exists as upwards.
    (inside,) = set(_with_edge(Ending(math.exp(0.25)), np.array([0.0, 1.0]))[:2]) - {0.0}
    assert inside == pytest.approx(0.25, abs=1e-11)


def test_the_first_cells_hold_the_solution() -> None:
    # N = u = 6 where G = 1/(s(s+1)(s+2)) is -1/6.
    inverse = response(THIRD_ORDER)
    cells, examined = _first_cells(inverse, Ending(), (math.log(0.1), math.log(20.0)))
    v, x = math.log(6.0), 0.5 * math.log(2.0)
    held = (cells.v_lower <= v) & (v <= cells.v_upper) & (cells.x_lower <= x) & (x <= cells.x_upper)
    assert held.sum() == 1
    distinct = np.unique(
        np.concatenate(
            [np.linspace(math.log(0.1), math.log(20.0), 401), inverse.breaks(math.log(0.1), math.log(20.0))]
        )
    )
    assert examined == 400 * (distinct.size - 1)
    assert 0 < cells.v_lower.size < examined / 50
    assert cells.v_upper - cells.v_lower == pytest.approx(16.0 * math.log(10.0) / 400)


def test_a_grid_of_both_has_fewer_places() -> None:
    curve = Ending(depends_on_x=True)
    inverse = response(1 / (s + 7))
    _, examined = _first_cells(inverse, curve, (0.0, 3.0))
    assert examined == 64 * 48


def test_starts_are_where_f_is_least_among_neighbours() -> None:
    inverse = response(THIRD_ORDER)
    v, x = math.log(6.0), 0.5 * math.log(2.0)
    d = 0.01
    near = [(v + i * d - 0.4 * d, v + i * d + 0.6 * d, x - 0.5 * d, x + 0.5 * d) for i in (-1, 0, 1)]
    apart = [(v + 1.0, v + 1.0 + d, x, x + d)]
    u, at = _starts(inverse, Ending(), grid(*near, *apart))
    assert np.log(u) == pytest.approx([v + 0.1 * d, v + 1.0 + 0.5 * d])
    assert at == pytest.approx([x, x + 0.5 * d])
    above = [(v, v + d, x + i * d, x + (i + 1) * d) for i in (0, 1, 5)]
    u, at = _starts(inverse, Ending(), grid(*above))
    assert at == pytest.approx([x + 0.5 * d, x + 5.5 * d])
    u, _ = _starts(inverse, Ending(highest=1e-3), grid(*near))
    assert u.size == 0


def test_solutions_that_agree_in_both_are_one() -> None:
    u, x = np.array([1.0, 1.0 + 5e-6, 1.0, 1.0, 2.0]), np.array([3.0, 3.0, 3.0 + 5e-6, 3.0 + 2e-5, 3.0])
    kept_u, kept_x = _distinct(u, x)
    assert kept_u.tolist() == [1.0, 1.0, 2.0]
    assert kept_x.tolist() == [3.0, 3.0 + 2e-5, 3.0]
    assert _distinct(np.empty(0), np.empty(0))[0].size == 0
    assert _distinct(np.array([1.0, 2.0, 2.000002, 1.0]), np.zeros(4))[0].tolist() == [1.0, 2.0]


RANGE = (-1.0, 2.0)


def solved(
    monkeypatch: pytest.MonkeyPatch,
    u: list[float],
    x: list[float],
    steps: list[tuple[list[float], list[float]]],
    off: complex | list[complex] = 0.0,
) -> tuple[np.ndarray, np.ndarray]:
    """Go on from u and x by given steps, relative in u; N + 1/G is ``off`` times 1/G at the end."""
    left = [*steps]

    def step(
        inverse: object, curve: object, at_u: np.ndarray, at_x: np.ndarray
    ) -> tuple[np.ndarray, np.ndarray]:
        assert at_u.size > 0
        assert np.isfinite(at_u).all()
        assert np.isfinite(at_x).all()
        by_u, by_x = left.pop(0)
        return np.array(by_u) * at_u, np.array(by_x)

    one = response(1 / (s + 7))
    curve = SimpleNamespace(value=lambda at_u, at_x: one.value(at_x) * (np.asarray(off) - 1.0))
    monkeypatch.setattr(sampled, "_starts", lambda *given: (np.array(u), np.array(x)))
    monkeypatch.setattr(sampled, "newton_step", step)
    with np.errstate(all="ignore"):
        found = _solutions(one, curve, None, RANGE)
    assert left == []
    return found


def test_steps_are_shortened_to_half_and_end_when_they_are_small(monkeypatch: pytest.MonkeyPatch) -> None:
    """The larger of both counts, without its sign; what is no number does not move."""
    moves = [([2.0, -0.1, -2.0], [0.3, -0.8, 0.2]), ([1e-10, -1e-10, 0.3], [0.0, 1e-10, 0.0]), ([0.0], [0.0])]
    u, x = solved(monkeypatch, [1.0, 2.0, 3.0, math.nan, 5.0], [0.0, 0.0, 0.0, 0.0, math.inf], moves)
    assert u == pytest.approx([1.5, 2.0 * (1.0 - 0.0625), 1.5 * 1.3])
    assert x == pytest.approx([0.075, -0.5, 0.05])


def test_only_zeros_within_the_range_are_solutions(monkeypatch: pytest.MonkeyPatch) -> None:
    def kept(u: list[float], x: list[float], off: list[complex]) -> list[float]:
        return solved(monkeypatch, u, x, [([0.0] * len(u), [0.0] * len(u))], off)[0].tolist()

    assert kept([1.0, 2.0, 3.0], [0.0] * 3, [0.9e-7, 1.1e-7, 0.0]) == [1.0, 3.0]
    assert kept([1.0, 2.0, 3.0], [0.0] * 3, [-0.5, 0.5j, -0.5j]) == []
    assert kept([1.0, 2.0, 3.0, 4.0], [-1.0, -1.1, 2.0, 2.1], [0.0] * 4) == [1.0, 3.0]
    assert kept([0.99e-8, 1.01e-8, 0.99e8, 1.01e8], [0.0] * 4, [0.0] * 4) == [1.01e-8, 0.99e8]


def test_a_relay_without_its_bounds_is_solved_within_a_given_range_only() -> None:
    curve = ElementCurve(Relay(1.0))
    searched = solve_sampled(response(THIRD_ORDER), curve, (0.5, 5.0))
    assert searched.omegas == pytest.approx((0.5, 5.0))
    assert np.exp(searched.result.x) == pytest.approx([math.sqrt(2.0)])
    # 4/(π A) = 6.
    assert curve.amplitude(searched.result.u) == pytest.approx([2.0 / (3.0 * math.pi)])
    assert searched.result.examined > 400 * 400
    assert len(searched.result.undecided) == 0
    assert (searched.outside_excluded, searched.smallest_gain) == (False, 0.0)
    assert solve_sampled(response(THIRD_ORDER), curve, (2.0, 5.0)).result.u.size == 0


def test_too_many_cells_are_cut_no_further(monkeypatch: pytest.MonkeyPatch) -> None:
    curve, inverse = ElementCurve(Relay(1.0)), response(THIRD_ORDER)
    cells, first = _first_cells(inverse, curve, (math.log(0.5), math.log(5.0)))
    monkeypatch.setattr(sampled, "_MOST_CELLS", cells.v_lower.size - 1)
    assert solve_sampled(inverse, curve, (0.5, 5.0)).result.examined == first
    monkeypatch.setattr(sampled, "_MOST_CELLS", cells.v_lower.size)
    assert solve_sampled(inverse, curve, (0.5, 5.0)).result.examined >= first + 4 * cells.v_lower.size


def test_nothing_is_unproven_of_an_element_with_bounds() -> None:
    result = SearchResult(np.array([0.5]), np.array([0.0]), Cells.none(), 1)
    assert unproven(ElementCurve(Relay(1.0)), Searched("", result, (1.0, 2.0), False, 0.0)) == ()
