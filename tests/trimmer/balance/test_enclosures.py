"""The bounds of 1/G themselves, by hand where G has one root, and where nothing finite is left."""

from __future__ import annotations

import math

import numpy as np
import pytest

from tests.trimmer.balance.loops import s
from trimmer.balance.inverse_response import ConstantResponse, InverseResponse
from trimmer.linear.zero_pole_gain import ZeroPoleGain


def response(G) -> InverseResponse:
    return InverseResponse.of(ZeroPoleGain.of(G))


def around(omega: float, half: float) -> tuple[np.ndarray, np.ndarray]:
    return np.array([math.log(omega) - half]), np.array([math.log(omega) + half])


def test_a_power_of_s_is_enclosed_exactly() -> None:
    # 1/G = s²/5: the modulus is omega²/5, and nothing bends in logarithms.
    bounds = response(5 / s**2).enclose(*around(3.0, 0.1))
    assert bounds.centre == pytest.approx([-9.0 / 5.0])
    assert bounds.slope == pytest.approx([-18.0 / 5.0])
    assert bounds.smallest == pytest.approx([9.0 / 5.0 * math.exp(-0.2)])
    assert bounds.largest == pytest.approx([9.0 / 5.0 * math.exp(0.2)])
    assert bounds.radius == pytest.approx([9.0 / 5.0 * (math.exp(0.2) - 1.0)])
    assert bounds.slope_radius == pytest.approx([0.1 * 9.0 / 5.0 * math.exp(0.2) * 4.0])


def test_taylors_theorem_with_one_pole() -> None:
    # 1/G = s + 7 at omega = 3: L = j3/(7 + j3); the second derivative is at most omega 7/(omega² + 49).
    half, top = 0.05, 3.0 * math.exp(0.05)
    bend = top * 7.0 / (top**2 + 49.0)
    rate = 3.0 / math.sqrt(58.0)
    spread = half * (rate + 0.5 * half * bend)
    bounds = response(1 / (s + 7)).enclose(*around(3.0, half))
    assert bounds.centre == pytest.approx([7 + 3j])
    assert bounds.slope == pytest.approx([3j])
    size = math.sqrt(58.0)
    assert bounds.radius == pytest.approx([size * math.expm1(spread)])
    assert bounds.smallest == pytest.approx([size * math.exp(-spread)])
    assert bounds.largest == pytest.approx([size * math.exp(spread)])
    expected = half * size * math.exp(spread) * ((rate + half * bend) ** 2 + bend)
    assert bounds.slope_radius == pytest.approx([expected])


@pytest.mark.parametrize(
    ("omega", "worst"), [(3.0, 3.0 * math.exp(0.2)), (7.5, 7.0), (40.0, 40.0 * math.exp(-0.2))]
)
def test_the_phase_of_one_pole_turns_by_no_more_than_its_bound(omega: float, worst: float) -> None:
    turning = response(1 / (s + 7)).turning(*around(omega, 0.2))
    rate = omega * 7.0 / (omega**2 + 49.0)  # of the phase, atan(omega/7)
    bend = worst * 7.0 / (worst**2 + 49.0)
    assert turning.direction == pytest.approx([(7 + 1j * omega) / abs(7 + 1j * omega)])
    assert turning.spread == pytest.approx([0.2 * (rate + 0.5 * 0.2 * bend)])
    assert turning.one_way.tolist() == [rate > 0.2 * bend]


def test_a_falling_phase_has_the_bounds_of_a_rising_one() -> None:
    rising, falling = (response(1 / (s + pole)).turning(*around(3.0, 0.2)) for pole in (7, -7))
    assert falling.spread == pytest.approx(rising.spread)
    assert falling.one_way.tolist() == rising.one_way.tolist() == [True]


def test_a_phase_that_stays_the_same_is_not_called_monotonic() -> None:
    turning = response(5 / s**2).turning(*around(3.0, 0.1))
    assert (turning.spread.tolist(), turning.one_way.tolist()) == ([0.0], [False])


@pytest.mark.parametrize(("low", "high", "worst"), [(1.0, 2.0, 2.0), (3.0, 9.0, 5.0), (8.0, 9.0, 8.0)])
def test_each_root_bends_by_its_own_distance(low: float, high: float, worst: float) -> None:
    # Poles at -3 ± 4j, of magnitude 5.
    found = response(25 / (s**2 + 6 * s + 25))._bend(np.log([low]), np.log([high]))
    squares = [(worst - height) ** 2 + 9.0 for height in (4.0, -4.0)]
    assert found == pytest.approx([5.0 * worst / squares[0] + 5.0 * worst / squares[1]])


def test_only_roots_on_the_axis_above_the_origin_need_distances() -> None:
    needed = [response(G)._reaches_zero_or_infinity for G in (1 / (s**2 + 4), 1 / (s**2 + s + 4), 1 / s)]
    assert needed == [True, False, False]


def test_the_phase_is_not_called_monotonic_where_it_turns() -> None:
    # The phase of (s + 1)/(s + 100) is largest in between, at omega = 10.
    turning = response((s + 100) / (s + 1)).turning(*around(10.0, 0.1))
    assert not turning.one_way[0]
    assert response(1 / (s * (s + 1))).turning(*around(0.5, 0.5)).one_way[0]


def test_sizes_at_a_root_on_the_axis_are_those_of_the_distances() -> None:
    # 1/G = (s² + 4)/(s + 5), from 1.9 to 2.3 rad/s: least 0, at most (2.3 - 2)(2.3 + 2) over |5 + 1.9j|.
    lower, upper = np.log([1.9]), np.log([2.3])
    bounds = response((s + 5) / (s**2 + 4)).enclose(lower, upper)
    assert bounds.smallest == pytest.approx([0.0], abs=1e-12)
    assert bounds.largest == pytest.approx([0.3 * 4.3 / math.hypot(5.0, 1.9)], rel=1e-12)
    assert bounds.radius[0] <= abs(bounds.centre[0]) + bounds.largest[0]
    inverted = response((s**2 + 4) / (s + 5) ** 3).enclose(lower, upper)
    assert inverted.smallest == pytest.approx([math.hypot(5.0, 1.9) ** 3 / (0.3 * 4.3)], rel=1e-12)
    assert np.isinf(inverted.largest[0])


def test_beside_a_root_on_the_axis_distances_are_those_to_the_nearer_end() -> None:
    lower, upper = np.log([2.5]), np.log([9.0])
    bounds = response(1 / (s**2 + 4)).enclose(lower, upper)
    assert bounds.smallest == pytest.approx([0.5 * 4.5], rel=1e-12)
    assert bounds.largest == pytest.approx([7.0 * 11.0], rel=1e-12)
    least, most = response((s + 5) / (s**2 + 4))._extremes(np.log([0.5]), np.log([1.0]))
    assert least == pytest.approx([1.0 * 2.5 / math.hypot(5.0, 1.0)], rel=1e-12)
    assert most == pytest.approx([1.5 * 3.0 / math.hypot(5.0, 0.5)], rel=1e-12)
    falling = response(-4 * (s + 5) / (s**2 + 4))._extremes(np.log([0.5]), np.log([1.0]))
    assert falling == (pytest.approx(least / 4.0), pytest.approx(most / 4.0))


def test_in_the_middle_of_a_root_there_is_no_bound_of_the_slope() -> None:
    bounds = response(1 / (s**2 + 4)).enclose(*around(2.0, 0.01))
    assert np.isinf(bounds.slope_radius[0])
    assert np.isfinite(bounds.largest[0])


def test_without_a_number_there_is_no_bound() -> None:
    # At the root itself the slope of ln(1/G) is none, and at e**800 rad/s not even omega is one.
    at_root = InverseResponse(1.0, np.array([1j, -1j]), np.empty(0, complex), 1.0).enclose(*around(1.0, 0.01))
    assert at_root.slope_radius.tolist() == [math.inf]
    assert np.isfinite(at_root.radius[0])
    beyond = response(1 / (s + 7)).enclose(np.array([799.0]), np.array([801.0]))
    assert beyond.radius.tolist() == beyond.largest.tolist() == beyond.slope_radius.tolist() == [math.inf]
    turning = response(1 / (s + 7)).turning(np.array([799.0]), np.array([801.0]))
    assert turning.spread.tolist() == [math.inf]


def test_a_constant_is_enclosed_in_itself() -> None:
    constant = ConstantResponse(3.0 - 4.0j)
    bounds = constant.enclose(np.array([1.0, 2.0]), np.array([2.0, 5.0]))
    assert bounds.centre.tolist() == [3 - 4j, 3 - 4j]
    for field in (bounds.slope, bounds.radius, bounds.slope_radius):
        assert field.tolist() == [0.0, 0.0]
    assert bounds.smallest.tolist() == bounds.largest.tolist() == [5.0, 5.0]
    assert bounds.slope.dtype == complex
    assert bounds.radius.dtype == bounds.slope_radius.dtype == float
    some = bounds.take(np.array([1]))
    assert [len(each) for each in vars(some).values()] == [1] * 6


def test_entries_are_taken_field_by_field() -> None:
    bounds = response(1 / (s + 7)).enclose(np.log([1.0, 2.0]), np.log([2.0, 5.0]))
    taken = bounds.take(np.array([1]))
    for name, values in vars(taken).items():
        assert values.tolist() == [getattr(bounds, name)[1]]


def test_the_reference_is_the_geometric_mean_of_roots() -> None:
    inverse = response(6 * (s + 2) / (s * (s + 4) * (s + 27)))
    assert inverse.reference == pytest.approx(6.0)
    assert np.sort(inverse.poles.real) == pytest.approx([-4.5, -4.0 / 6.0, 0.0])
    assert inverse.zeros == pytest.approx([-2.0 / 6.0])
    assert inverse.gain == pytest.approx(6.0**2 / 6.0)
    assert inverse.exponents.tolist() == [1.0, 1.0, 1.0, -1.0]
    assert (inverse.relative_degree, inverse.order_at_zero) == (2, 1)
    assert response(1 / s**2).reference == 1.0
    assert response(1 / ((s + 0.5) * (s + 0.02))).reference == pytest.approx(0.1)
    assert response((s + 2) / (s**2 * (s + 4))).order_at_zero == 2
    assert response(s / ((s + 1) * (s + 2))).order_at_zero == -1
    assert inverse.value(np.log([3.0])) == pytest.approx(
        [3j * (4 + 3j) * (27 + 3j) / (6 * (2 + 3j))], rel=1e-12
    )


def test_a_range_is_cut_close_beside_a_lightly_damped_root() -> None:
    # Roots -0.01 ± 2j: cut at 2 + 0.01 sinh(k 3/4), k = -4 ... 4, and in 16 equal parts.
    breaks = response(1 / (s**2 + 0.02 * s + 4.0001)).breaks(math.log(0.5), math.log(8.0))
    beside = np.log(2.0 + 0.01 * np.sinh(0.75 * np.arange(-4.0, 5.0)))
    even = np.linspace(math.log(0.5), math.log(8.0), 17)
    assert breaks == pytest.approx(np.sort(np.concatenate([beside, even])), abs=1e-10)


def test_a_heavily_damped_root_is_not_cut_below_the_range() -> None:
    # 1 + 5 sinh(k 3/4) is negative for k < 0, and beyond the range for k = 4.
    breaks = response(1 / (s**2 + 10 * s + 26)).breaks(math.log(0.1), math.log(30.0))
    beside = np.log(1.0 + 5.0 * np.sinh(0.75 * np.arange(0.0, 4.0)))
    even = np.linspace(math.log(0.1), math.log(30.0), 17)
    assert breaks == pytest.approx(np.sort(np.concatenate([beside, even])), abs=1e-10)


def test_a_root_that_does_not_turn_and_one_at_an_end_cut_no_range() -> None:
    even = np.linspace(-1.0, 0.0, 17)
    assert response(1 / ((s + 0.5) * (s + 0.6))).breaks(-1.0, 0.0) == pytest.approx(even)
    at_one = InverseResponse(1.0, np.array([1j, -1j]), np.empty(0, complex), 1.0)
    assert at_one.breaks(-1.0, 0.0) == pytest.approx(even)
    assert at_one.breaks(0.0, 1.0) == pytest.approx(even + 1.0)


def test_the_size_is_known_where_the_parts_overflow() -> None:
    # Products of complex numbers overflow to NaN before their modulus does.
    inverse = InverseResponse(1e10 + 0j, np.array([-1.0, -1.0 + 0j]), np.array([-2.0 + 0j]), 3.0)
    x = np.log([3e150])
    size = inverse._size(np.array([np.nan + 0j]), x)
    assert size == pytest.approx([1e10 * 1e150], rel=1e-9)
    lone = InverseResponse(-2.0, np.array([-3.0 + 4.0j]), np.empty(0, complex), 1.0)
    assert lone._size(np.array([np.nan + 0j]), np.zeros(1)) == pytest.approx([2.0 * math.hypot(3.0, 3.0)])
    both = inverse._size(np.array([3 + 4j, np.nan]), np.log([6.0, 12.0]))
    assert both == pytest.approx([5.0, 1e10 * 17.0 / math.sqrt(20.0)])
