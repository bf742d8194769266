"""Where the search of a bounded N begins and ends: breaks, what is next to poles, and small gains."""

from __future__ import annotations

import math
from types import SimpleNamespace

import numpy as np
import pytest

from tests.trimmer.balance.test_gain_disks import Sloping
from trimmer.balance import bounded
from trimmer.balance.bounded import _cut, _next_to_poles, _rough_gain, _smallest_gain, solve_bounded
from trimmer.balance.cells import Cells
from trimmer.balance.element_curve import ElementCurve
from trimmer.balance.inverse_response import InverseResponse
from trimmer.balance.search import Problem, SearchResult
from trimmer.balance.vanishing import EmptyInterval
from trimmer.elements.backlashes.friction_backlash import FrictionBacklash

PLAY = ElementCurve(FrictionBacklash(4e-5))
NO_ZEROS = np.empty(0, complex)


class Unknown(Sloping):
    """An element of which nothing is known where N is small."""

    def small_gains(self) -> None:
        return None


def inverse(*poles: complex, gain: float = 1.0, reference: float = 1.0) -> InverseResponse:
    return InverseResponse(gain, np.array(poles, complex), NO_ZEROS, reference)


def test_all_frequencies_are_cut_into_blocks_each_twice_as_wide_as_the_one_before(
    monkeypatch: pytest.MonkeyPatch,
) -> None:
    asked: list[Problem] = []

    def nothing_found(problem: Problem) -> SearchResult:
        asked.append(problem)
        return SearchResult(np.empty(0), np.empty(0), Cells.none(), 5)

    monkeypatch.setattr(bounded, "find_all", nothing_found)
    response = inverse(-1.0, -1.0, reference=math.e)
    searched = solve_bounded(response, PLAY, None)
    beyond = [1.0, 3.0, 7.0, 15.0, 31.0, 63.0, 127.0]
    # The root is at x = 1; blocks begin two beside it.
    expected = [*(-1.0 - each for each in beyond[::-1]), *np.linspace(-1.0, 3.0, 17)]
    expected += [3.0 + each for each in beyond]
    assert asked[0].table.x_breaks == pytest.approx(expected)
    assert (asked[0].smallest_gain, asked[0].empty) == (0.0, ())
    assert (searched.result.examined, searched.outside_excluded, searched.smallest_gain) == (5, True, 0.0)
    assert searched.omegas == pytest.approx((math.exp(-1.0), math.exp(3.0)))
    searched = solve_bounded(response, PLAY, (0.5, 8.0))
    assert asked[1].table.x_breaks == pytest.approx(np.linspace(math.log(0.5), math.log(8.0), 17))
    assert (searched.omegas, searched.outside_excluded) == ((0.5, 8.0), False)
    # A pole on the axis without a damped neighbour: the interval beside it is cut out.
    solve_bounded(inverse(2j, -2j), PLAY, (0.5, 8.0))
    ends = [end for each in asked[2].empty for end in (each.lower, each.upper)]
    assert len(ends) == 4
    assert set(ends) <= {*asked[2].table.x_breaks}
    assert asked[2].smallest_gain == 0.0


def test_poles_count_from_the_first_break_to_the_last() -> None:
    response = inverse(2j, -2j, reference=0.5)  # at 1 rad/s, x = 0

    def found(lower: float, upper: float) -> int:
        return len(_next_to_poles(response, PLAY, np.array([lower, upper])))

    assert [found(0.0, 1.0), found(-1.0, 0.0), found(1e-9, 1.0), found(-1.0, -1e-9)] == [2, 2, 0, 0]


def test_a_pole_at_the_origin_counts_where_the_inverse_is_small_beside_n() -> None:
    # |1/G| = 5 omega at the lowest frequency, against a ten-thousandth of |N|, at most 0.5 + 1.
    curve = ElementCurve(Unknown(edge=0.5, depends_on_frequency=False))
    largest = _rough_gain(curve, np.array([0.0, 1.0]))
    assert largest == pytest.approx(0.5 + 1.0)
    for share, count in ((0.99, 1), (1.01, 0)):
        breaks = np.log([share * 1e-4 * largest / 5.0, 1.0])
        assert _next_to_poles(inverse(0.0, gain=5.0), curve, breaks) == [None] * count
    poles = inverse(0.0, 1j, -1j, 2j, -2j, gain=1e-9)
    assert _next_to_poles(poles, curve, np.array([-1.0, 1.0])) == [None] * 3


@pytest.mark.parametrize(("power", "expected"), [(1.0, 6.0 + 4.0 * math.exp(2.0) + 15.0),
                                                 (-1.0, 3.0 + 4.0 * math.e + 15.0)])  # fmt: skip
def test_the_rough_bound_is_that_of_one_box_over_all(power: float, expected: float) -> None:
    """N = 2 u + 3j x up to u = exp(power x): at the far corner 3 |x|, and twice 4 u/2 + 5 x/2 beside it."""
    assert _rough_gain(ElementCurve(Sloping(power)), np.array([-1.0, 0.5, 2.0])) == pytest.approx(expected)


def test_a_cut_begins_beyond_the_last_interval_at_the_origin_and_repeats_no_break() -> None:
    breaks = np.array([0.0, 1.0, 2.0, 3.0])
    low, higher = EmptyInterval(-math.inf, 0.5, 0.1), EmptyInterval(-math.inf, 1.5, 0.1)
    assert _cut(breaks, (low, higher)).tolist() == [1.5, 2.0, 3.0]
    assert _cut(breaks, (higher, low)).tolist() == [1.5, 2.0, 3.0]
    assert _cut(breaks, (EmptyInterval(0.0, 3.0, 0.1),)).tolist() == [0.0, 1.0, 2.0, 3.0]
    assert _cut(breaks, (EmptyInterval(2.5, 4.0, 0.1),)).tolist() == [0.0, 1.0, 2.0, 2.5, 3.0]


def test_gains_are_left_out_relative_to_the_largest() -> None:
    def left_out(*least: float | None, smallest: float = 0.0) -> float:
        table = SimpleNamespace(largest_gain=4.0, smallest_gain=smallest)
        beside = [None if each is None else EmptyInterval(0.0, 1.0, each) for each in least]
        return _smallest_gain(beside, table)

    assert left_out(1.0, 4.1e-13) == 0.0
    assert left_out(1.0, 4e-13) == 0.0
    assert left_out(1.0, 3.9e-13) == 4e-13
    assert left_out(1.0, None) == 4e-10
    assert left_out(None, smallest=4e-10) == 0.0
    assert left_out(None, smallest=3.9e-10) == 4e-10
