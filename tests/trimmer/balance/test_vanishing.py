"""Intervals next to a pole on the imaginary axis that hold no solution, with their parts by hand."""

from __future__ import annotations

import math

import numpy as np
import pytest

from tests.trimmer.balance.loops import s
from trimmer.balance.inverse_response import InverseResponse
from trimmer.balance.vanishing import EmptyInterval, _Neighbourhood, empty_intervals, poles_on_axis
from trimmer.elements.small_gains import SmallGains, real_small_gains, small_gains_of_backlash
from trimmer.linear.zero_pole_gain import ZeroPoleGain


def response(G) -> InverseResponse:
    return InverseResponse.of(ZeroPoleGain.of(G))


def test_places_are_those_where_poles_outnumber_zeros() -> None:
    # Over the reference, the geometric mean of the roots' sizes.
    def places(*poles: complex, zeros: tuple[complex, ...] = ()) -> list[float]:
        return poles_on_axis(InverseResponse(1.0, np.array(poles), np.array(zeros, complex), 3.0)).tolist()

    assert places(0.0, -1.0, 2j, -2j) == [0.0, 2.0]
    assert places(0.0, -1.0, 2j, -2j, zeros=(2j, -2j)) == [0.0]
    assert places(0.0, 0.0, -1.0, zeros=(0.0,)) == [0.0]
    assert places(0.0, 2j, -2j, zeros=(0.0,)) == [2.0]
    assert places(-1.0, -2.0) == []
    assert places(-1.0 + 2j, -1.0 - 2j, 3j, -3j) == [3.0]


def test_the_parts_of_a_neighbourhood_by_hand() -> None:
    # 1/G = 5 s (s + 2)/(s - 4j)..., at the pole of G at 3j: reference 10, scale of N 4, lag 0.2 s.
    inverse = InverseResponse(5.0, np.array([3j, -3j, -2.0]), np.array([-1.0 + 0j]), 10.0)
    small = SmallGains(direction=-1j, scale=4.0, lag=0.2, reach=0.3)
    for side in (1.0, -1.0):
        part = _Neighbourhood.of(inverse, small, 3.0, side)
        # -1/G = C d with C = -5 (j side) 6j (2 + 3j)/(1 + 3j).
        factor = -5.0 * 1j * side * 6j * (2 + 3j) / (1 + 3j)
        assert (part.place, part.side, part.order, part.largest) == (3.0, side, 1, 0.3)
        assert part.size == pytest.approx(abs(factor) / 4.0)
        assert part.heading == pytest.approx(np.angle(factor / -1j))
        assert part.lag == pytest.approx(2.0)
        # ln(1 + j d side/(3j - root)) for each other root, -1 for a zero.
        assert part.turns == pytest.approx(
            np.array([1j * side / 6j, 1j * side / (2 + 3j), -1j * side / (1 + 3j)])
        )
        assert part.small is small
        double = InverseResponse(5.0, np.array([3j, 3j, -3j, -3j, -2.0]), np.array([-1.0 + 0j]), 10.0)
        twice = _Neighbourhood.of(double, small, 3.0, side)
        factor = 5.0 * (6j) ** 2 * (2 + 3j) / (1 + 3j)  # of C d², where (j side)² = -1
        assert (twice.order, twice.size) == (2, pytest.approx(abs(factor) / 4.0))
        assert twice.heading == pytest.approx(np.angle(factor / -1j))


def test_bounds_of_the_size_hold_and_are_of_second_order() -> None:
    inverse = InverseResponse(5.0, np.array([3j, -3j, -2.0]), np.array([-1.0 + 0j]), 1.0)
    part = _Neighbourhood.of(inverse, SmallGains(-1j, 4.0, 0.2), 3.0, -1.0)
    distance = 0.1
    reach = distance * np.array([1 / 6.0, 1 / math.sqrt(13.0), 1 / math.sqrt(10.0)])
    remainder = float(sum(z**2 / (2 - 2 * z) for z in reach))
    growth, rest = part._growth(distance)
    assert rest == pytest.approx(remainder)
    assert growth == pytest.approx(float(reach.sum()) + remainder)
    assert part.least_at(distance) == pytest.approx(part.size * distance * math.exp(-growth))
    value = abs(inverse.value(np.log([2.9]))[0]) / 4.0
    assert part.least_at(distance) < value < part.least_at(distance) * math.exp(2.0 * growth)


def test_the_least_gain_of_a_load_that_coasts() -> None:
    def least(place: float, side: float, order: int, distance: float) -> float:
        part = _Neighbourhood(place, side, order, 1.0, 0.0, np.zeros(0, complex), 0.5, 0.003, small)
        return part._least_gain(distance)

    small = small_gains_of_backlash(0.5)
    # 0.3 gamma², gamma = 0.5 omega, at the nearest omega of the interval.
    assert least(0.0, 1.0, 2, 0.1) == pytest.approx(0.3 * 0.05**2)
    assert least(0.0, 1.0, 1, 0.1) == 0.0
    assert least(0.15, 1.0, 1, 0.1) == pytest.approx(0.3 * 0.075**2)
    assert least(0.05, 1.0, 1, 0.01) == pytest.approx(0.3 * 0.025**2)
    assert least(0.05, -1.0, 1, 0.01) == pytest.approx(0.3 * 0.02**2)
    assert least(9.0, 1.0, 1, 0.1) == 0.003


def neighbourhood(
    small: SmallGains,
    *,
    heading: float,
    order: int = 1,
    place: float = 0.0,
    turns: complex = 0.0,
    lag: float = 0.0,
) -> _Neighbourhood:
    return _Neighbourhood(place, 1.0, order, 1.0, heading, np.array([turns]), lag, small.reach, small)


@pytest.mark.parametrize(
    ("heading", "empty"), [(1.0, True), (-1.0, True), (0.01, False), (-0.001, True), (6.0, True)]
)
def test_phases_that_differ_exclude_each_other(heading: float, empty: bool) -> None:
    # N's phase is within 4 √0.001 = 0.13 ahead of its direction.
    part = neighbourhood(small_gains_of_backlash(0.0), heading=heading)
    assert part._is_empty(0.001) is empty


def test_a_size_counts_with_all_that_it_may_have_grown() -> None:
    """|1/G| is d exp(±g) at most, g = 3 d + 9 d²/(2 - 6 d) here; a load that coasts far has a larger N."""
    distance = 0.05
    growth = 0.15 + 0.0225 / 1.7
    base = distance * math.exp(growth)
    for reach, empty in ((1.001 * base, True), (0.999 * base, False), (base * math.exp(growth), True)):
        small = SmallGains(-1j, 1.0, 1e3, reach=reach)
        part = _Neighbourhood(1.0, 1.0, 1, 1.0, 0.0, np.array([3j]), 1e3, reach, small)
        assert part._least_gain(distance) == reach
        assert part._is_empty(distance) is empty


def test_what_is_just_equal_is_not_excluded() -> None:
    # |1/G| is the least |N|, 0.25; nor does the phase tell.
    small = SmallGains(-1j, 1.0, 1e3, reach=0.25)
    assert not neighbourhood(small, heading=0.0, order=2, lag=1e3)._is_empty(0.5)
    # N is ahead by 2 sqrt(0.25) = 1 at most, and behind by 0.25 at most.
    steep = SmallGains(-1j, 1.0, 0.0, steepest=2.0, gentlest=0.0, behind=1.0, reach=1.0)
    assert not neighbourhood(steep, heading=1.0)._is_empty(0.25)
    assert neighbourhood(steep, heading=1.0 + 1e-12)._is_empty(0.25)
    assert not neighbourhood(steep, heading=-0.25)._is_empty(0.25)
    assert neighbourhood(steep, heading=-0.25 - 1e-12)._is_empty(0.25)


def test_with_equal_limits_only_what_falls_behind_all_that_n_does_is_excluded() -> None:
    """At d = 0.01 -1/G is behind by 0.1 less a remainder of 0.0056, and N by ``behind`` times exp(g) d."""
    grown = 0.01 * math.exp(0.1 + 0.01 / 1.8)
    for behind, empty in ((0.094 / grown, True), (0.095 / grown, False)):
        small = SmallGains(-1j, 1.0, 0.0, steepest=50.0, gentlest=0.0, behind=behind, reach=1.0)
        assert neighbourhood(small, heading=0.0, turns=-10j)._is_empty(0.01) is empty
    # Ahead by as much, it is ahead of all N for a double pole only; or where N is never ahead.
    for order, steepest, empty in ((1, 0.1, False), (2, 0.1, True), (1, 0.0, True), (2, 50.0, False)):
        small = SmallGains(-1j, 1.0, 0.0, steepest=steepest, gentlest=0.0, behind=0.0, reach=1.0)
        assert neighbourhood(small, heading=0.0, order=order, turns=10j)._is_empty(0.01) is empty


def test_where_both_phases_stay_equal_a_gain_that_is_ahead_excludes() -> None:
    """Without other roots -1/G stays in its direction, where N never is; not so where it coasts."""
    for gentlest, lag, order, empty in ((0.7, 0.0, 3, True), (0.0, 0.0, 3, False), (0.7, 1e-3, 3, False)):
        small = SmallGains(-1j, 1.0, lag, gentlest=gentlest, reach=1.0)
        part = _Neighbourhood(0.0, 1.0, order, 1.0, 0.0, np.zeros(0, complex), lag, 1.0, small)
        assert part._is_empty(0.1) is empty


def test_what_lags_behind_counts_too() -> None:
    small = SmallGains(1.0, 1.0, 0.0, steepest=0.0, gentlest=0.0, behind=20.0, reach=1.0)
    # N's phase is within 20 times 0.01 = 0.2 behind its direction.
    assert not neighbourhood(small, heading=-0.19)._is_empty(0.01)
    assert neighbourhood(small, heading=-0.21)._is_empty(0.01)
    assert neighbourhood(small, heading=0.01)._is_empty(0.01)
    assert not neighbourhood(small, heading=2 * math.pi - 0.19)._is_empty(0.01)
    assert neighbourhood(small, heading=2 * math.pi - 0.21)._is_empty(0.01)


def test_a_phase_that_turns_towards_that_of_n_is_not_excluded() -> None:
    small = real_small_gains(1.0)
    # r = ln(1 + 3j d): 3 d ahead, with |r| - 3 d < 9 d²/(2 - 6 d).
    assert neighbourhood(small, heading=0.4, turns=3j)._is_empty(0.1)
    assert neighbourhood(small, heading=-0.4, turns=3j)._is_empty(0.1)
    assert not neighbourhood(small, heading=-0.34, turns=3j)._is_empty(0.1)
    assert neighbourhood(small, heading=0.4, turns=-3j)._is_empty(0.1)
    assert not neighbourhood(small, heading=0.34, turns=-3j)._is_empty(0.1)


def test_equal_limits_of_the_phases_are_told_apart_by_their_slopes() -> None:
    real = real_small_gains(1.0)
    assert neighbourhood(real, heading=0.0, turns=1j)._is_empty(0.1)
    assert neighbourhood(real, heading=0.0, turns=-1j)._is_empty(0.1)
    assert not neighbourhood(real, heading=0.0, turns=1.0)._is_empty(0.1)
    assert not neighbourhood(real, heading=0.0)._is_empty(0.1)
    play = small_gains_of_backlash(0.0)
    # N is ahead of its direction: by 0.7 √|N| or more, where -1/G stays in it or falls behind.
    assert neighbourhood(play, heading=0.0)._is_empty(0.001)
    assert neighbourhood(play, heading=0.0, turns=-1j)._is_empty(0.001)
    # Ahead by 0.001, N by 0.7 √0.001 = 0.022 or more.
    assert neighbourhood(play, heading=0.0, turns=1j)._is_empty(0.001)
    # Ahead by 0.03, N by no more than 4 √0.001 = 0.13.
    assert not neighbourhood(play, heading=0.0, turns=30j)._is_empty(0.001)
    # Ahead by 0.004, N by no more than 4 √(0.02²) = 0.08; the higher order is not decided by the phase.
    assert not neighbourhood(play, heading=0.0, turns=0.9j, order=3)._is_empty(0.1)


def test_beyond_what_is_known_of_n_nothing_is_excluded() -> None:
    play = small_gains_of_backlash(0.0)
    assert not neighbourhood(play, heading=1.0)._is_empty(0.0031)
    assert neighbourhood(play, heading=1.0)._is_empty(0.0029)


def test_a_smaller_response_than_n_is_excluded_by_its_size() -> None:
    # |1/G| = d³ at the origin, |N| at least 0.3 (0.5 d)².
    play = small_gains_of_backlash(0.5)
    assert neighbourhood(play, heading=0.01, order=3, lag=0.5)._is_empty(0.074)
    assert not neighbourhood(play, heading=0.01, order=3, lag=0.5)._is_empty(0.076)


def test_a_load_that_coasts_is_decided_at_the_origin_only() -> None:
    play = small_gains_of_backlash(0.5)
    # |N| of 25 gamma², gamma = lag d.
    assert neighbourhood(play, heading=0.0, lag=1.0)._is_decided(0.02, 0.0101)
    assert not neighbourhood(play, heading=0.0, lag=1.0)._is_decided(0.02, 0.0099)
    assert not neighbourhood(play, heading=0.0, lag=1.0, place=1.0)._is_decided(0.02, 0.0101)
    assert neighbourhood(play, heading=0.0, lag=0.0, place=1.0)._is_decided(0.02, 0.0)


def test_the_distance_is_the_largest_that_is_found_by_halving() -> None:
    play = small_gains_of_backlash(0.0)
    # |1/G| = 2 d² is within 0.003 up to √0.0015; the phase is a quarter turn ahead.
    part = _Neighbourhood(0.0, 1.0, 2, 2.0, 1.5, np.zeros(0, complex), 0.0, 0.003, play)
    assert part.empty_up_to() == pytest.approx(math.sqrt(0.0015), rel=1e-12)
    larger = _Neighbourhood(0.0, 1.0, 2, 5.0, 1.5, np.zeros(0, complex), 0.0, 0.003, play)
    assert larger.empty_up_to() == pytest.approx(math.sqrt(0.003 / 5.0), rel=1e-12)
    # Half of the distance of the nearest other root, or half of the place, if these are nearer.
    near = _Neighbourhood(0.0, 1.0, 2, 2.0, 1.5, np.array([40.0, 36.0 + 0j]), 0.0, 0.003, play)
    assert near.empty_up_to() == pytest.approx(0.5 / 40.0)
    low = _Neighbourhood(0.01, 1.0, 2, 2.0, 1.5, np.zeros(0, complex), 0.0, 0.003, play)
    assert low.empty_up_to() == pytest.approx(0.005)
    far = _Neighbourhood(0.0, 1.0, 1, 1.0, 1.5, np.zeros(0, complex), 0.0, math.inf, real_small_gains(1.0))
    assert far.empty_up_to() == 1.0


def test_no_distance_is_found_where_the_phases_agree() -> None:
    same = _Neighbourhood(0.0, 1.0, 1, 1.0, 0.0, np.zeros(0, complex), 0.0, math.inf, real_small_gains(1.0))
    assert same.empty_up_to() is None
    nothing = _Neighbourhood(0.0, 1.0, 1, math.inf, 1.0, np.zeros(0, complex), 0.0, 0.003, same.small)
    assert nothing.empty_up_to() is None


def test_an_integrator_has_an_interval_from_zero_on() -> None:
    # 1/G = s(s + 1)/K, play: -1/G goes along -j as N does, and falls behind while N is ahead.
    (interval,) = empty_intervals(response(2 / (s * (s + 1))), small_gains_of_backlash(0.0), 0.0)
    assert isinstance(interval, EmptyInterval)
    assert interval.lower == -math.inf
    omega = math.exp(interval.upper)
    # |1/G| is omega/2 to first order, and N's phase is known up to 0.003: so 0.006, or halved from there.
    halvings = math.log2(0.006 / omega)
    assert halvings == pytest.approx(round(halvings), abs=1e-9)
    assert 0 <= halvings < 6
    growth = omega + omega**2 / (2.0 - 2.0 * omega)
    assert interval.least == pytest.approx(0.5 * omega * math.exp(-growth), rel=1e-12)


def test_a_pole_above_zero_has_an_interval_on_either_side() -> None:
    below, above = empty_intervals(response(1 / (s**2 + 4)), small_gains_of_backlash(0.0), 1.0)
    assert below is not None
    assert above is not None
    assert below.upper == above.lower == pytest.approx(math.log(2.0))
    for interval, end in ((below, below.lower), (above, above.upper)):
        omega = math.exp(end)
        assert 1e-4 < abs(omega - 2.0) < 1e-2
        assert interval.least == pytest.approx(abs(4.0 - omega**2), rel=5e-3)
    assert below.lower < below.upper
    assert above.lower < above.upper


def test_a_side_without_a_proof_is_none() -> None:
    # -1/G = 4 - omega² is real and positive below the pole, as N is; above it they have opposite signs.
    below, above = empty_intervals(response(-1 / (s**2 + 4)), real_small_gains(1.0), 1.0)
    assert below is None
    assert above is not None
    below, above = empty_intervals(response(1 / (s**2 + 4)), real_small_gains(1.0), 1.0)
    assert below is not None
    assert above is None
