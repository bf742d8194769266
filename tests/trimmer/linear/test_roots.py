"""Zeros, poles, their slopes, and frequencies at which nothing but a boundary is met."""

from __future__ import annotations

import math

import control
import numpy as np
import pytest

from trimmer.linear import crossings, extrema, modes
from trimmer.linear.frequency_response import UnsupportedSystemError
from trimmer.linear.modes import Mode
from trimmer.linear.time_response import SteadyState, TimeResponse
from trimmer.linear.zero_pole_gain import ZeroPoleGain

TWO_ROOTS = ZeroPoleGain(-3.0, (-2.0 + 0j,), (-1.0 + 5j, -1.0 - 5j, 4.0 + 0j))


def test_gain_phase_and_slopes_of_a_few_roots() -> None:
    omega, step = 3.0, 1e-4
    value = -3.0 * (3j + 2) / ((3j + 1 - 5j) * (3j + 1 + 5j) * (3j - 4))
    assert TWO_ROOTS.log_gain(omega) == pytest.approx(math.log(abs(value)), rel=1e-13)
    assert np.exp(1j * TWO_ROOTS.phase(omega)) == pytest.approx(value / abs(value), rel=1e-13)
    slope = (TWO_ROOTS.log_gain(omega + step) - TWO_ROOTS.log_gain(omega - step)) / (2 * step)
    assert TWO_ROOTS.log_gain_slope_terms(omega).sum() == pytest.approx(slope, rel=1e-7)
    turn = (TWO_ROOTS.phase(omega + step) - TWO_ROOTS.phase(omega - step)) / (2 * step)
    assert TWO_ROOTS.phase_slope_terms(omega).sum() == pytest.approx(turn, rel=1e-7)
    assert TWO_ROOTS.relative_degree == 2
    assert repr(TWO_ROOTS) == "<ZeroPoleGain: gain -3, 1 zero and 3 poles>"
    assert TWO_ROOTS.exponents.tolist() == [1.0, -1.0, -1.0, -1.0]
    # G(0) = -3 * 2 / (26 * -4).
    assert TWO_ROOTS.static_gain == pytest.approx(6 / 104)


def test_phases_of_roots_on_either_side_and_of_a_negative_gain() -> None:
    # The arrow from 2 to j points up and to the left, the one from -2 to the right.
    half = math.atan(0.5)
    assert float(ZeroPoleGain(1.0, (2.0 + 0j,), ()).phase(1.0)) == pytest.approx(math.pi - half)
    assert float(ZeroPoleGain(1.0, (-2.0 + 0j,), ()).phase(1.0)) == pytest.approx(half)
    assert float(ZeroPoleGain(-1.0, (), (2.0 + 0j,)).phase(1.0)) == pytest.approx(half)
    assert float(ZeroPoleGain(0.1, (-2.0 + 0j,), ()).phase(1.0)) == pytest.approx(half)
    assert ZeroPoleGain(1.0, (3j,), ()).phase([1.0, 4.0]).tolist() == [-math.pi / 2, math.pi / 2]


def test_a_slow_pole_is_no_rounding() -> None:
    assert ZeroPoleGain.of(control.tf([1.0], [1.0, 1e-20])).poles == (
        pytest.approx(-1e-20, rel=1e-6, abs=0.0),
    )


def test_a_markov_parameter_that_is_rounding_is_none() -> None:
    """0.1 + 0.2 - 0.3 is 6e-17 in doubles; the next one is -0.1 - 0.4 + 0.9."""
    found = ZeroPoleGain.of(control.ss(np.diag([-1.0, -2.0, -3.0]), [[0.1], [0.2], [-0.3]], [[1.0] * 3], 0.0))
    assert found.gain == pytest.approx(0.4, rel=1e-12)
    # 0.1 (s + 2)(s + 3) + 0.2 (s + 1)(s + 3) - 0.3 (s + 1)(s + 2) = 0.4 s + 0.6.
    assert found.zeros == (pytest.approx(-1.5),)
    assert ZeroPoleGain.of(control.ss([[-1.0]], [[1.0]], [[3.0]], -2.0)).gain == -2.0


def test_coefficients_that_are_no_numbers_are_named() -> None:
    for system, name in (
        (control.TransferFunction([1.0, math.inf], [1.0, 2.0]), "numerator"),
        (control.TransferFunction([1.0], [1.0, math.nan]), "denominator"),
        (control.ss([[-1.0]], [[math.nan]], [[1.0]], 0.0), "B"),
    ):
        with pytest.raises(UnsupportedSystemError, match=f"^{name} of the system holds"):
            ZeroPoleGain.of(system)


def test_a_root_at_the_frequency_itself_has_no_slope() -> None:
    on_axis = ZeroPoleGain(2.0, (3j, -3j), (-1.0 + 0j,))
    assert on_axis.log_gain_slope_terms(3.0)[0] == 0.0
    assert on_axis.log_gain(3.0) == -math.inf
    jump = on_axis.phase(np.array([2.9, 3.1]))
    assert jump[1] - jump[0] == pytest.approx(math.pi, abs=0.1)


def test_static_gains_with_roots_at_the_origin() -> None:
    assert ZeroPoleGain(2.0, (0j,), (-1.0 + 0j,)).static_gain == 0.0
    assert ZeroPoleGain(2.0, (), (0j,)).static_gain == math.inf
    assert ZeroPoleGain(2.0, (0j, -3.0 + 0j), (0j, -4.0 + 0j)).static_gain == pytest.approx(1.5)


def test_roots_are_ordered_by_size_and_rounding_is_no_real_part() -> None:
    found = ZeroPoleGain.of(control.tf([1.0], np.poly([-7.0, -3.0, -2 + 5j, -2 - 5j]).real))
    assert [round(abs(pole), 9) for pole in found.poles] == [
        3.0,
        round(math.sqrt(29), 9),
        round(math.sqrt(29), 9),
        7.0,
    ]
    assert found.poles[1].imag < 0 < found.poles[2].imag
    undamped = ZeroPoleGain.of(control.ss([[0.0, 1.0], [-9.0, 0.0]], [[0.0], [1.0]], [[1.0, 0.0]], 0.0))
    assert [pole.real for pole in undamped.poles] == [0.0, 0.0]
    assert (undamped.gain, undamped.zeros) == (pytest.approx(1.0), ())


def test_a_state_space_keeps_gain_and_zeros() -> None:
    # y = 4 x1 + 2 x1' of x1'' + 3 x1' + 25 x1 = u: 2 (s + 2) / (s^2 + 3 s + 25).
    system = control.ss([[0.0, 1.0], [-25.0, -3.0]], [[0.0], [1.0]], [[4.0, 2.0]], 0.0)
    found = ZeroPoleGain.of(system)
    assert found.gain == pytest.approx(2.0, rel=1e-13)
    assert found.zeros == (pytest.approx(-2.0),)
    direct = ZeroPoleGain.of(control.ss([[-1.0]], [[1.0]], [[3.0]], 2.0))
    assert (direct.gain, direct.zeros) == (2.0, (pytest.approx(-2.5),))


@pytest.mark.parametrize("fast", [1e-8, 1.0, 1e9])
def test_a_zero_of_a_chain_has_its_digits_in_any_unit_of_time(fast: float) -> None:
    """Three sections, of which one has the zero 16 in that unit; five of the output's rates do not see it."""
    lags = [np.array([1.0, 0.005, 2e-3]), np.array([1.0, 1.25, 0.35]), np.array([1.0, 0.56, -0.115])]
    tops = [[1.0, -16.0 * fast], [1.0], [1.0]]
    system = control.ss([], [], [], [[1.0]])
    for top, lag in zip(tops, lags, strict=True):
        system = control.ss(control.tf(top, lag * fast ** np.arange(3))) * system
    found = ZeroPoleGain.of(system)
    assert found.zeros == (pytest.approx(16.0 * fast, rel=1e-10),)
    assert found.gain == pytest.approx(1.0)
    poles = np.sort_complex(fast * np.concatenate([np.roots(lag) for lag in lags]))
    assert np.sort_complex(np.array(found.poles)) == pytest.approx(poles, rel=1e-9, abs=1e-12 * fast)


def test_the_range_of_roots() -> None:
    assert crossings._root_range(TWO_ROOTS, 10.0) == pytest.approx((0.2, 10 * math.sqrt(26)))
    assert crossings._root_range(ZeroPoleGain(1.0, (), (0j,)), 10.0) == (0.1, 10.0)


def test_a_crossing_at_a_break_itself_is_found_once() -> None:
    found = crossings._crossings_of_zero(lambda omega: omega - 2.0, [1.0, 2.0, 3.0])
    assert list(found) == [2.0]
    assert list(crossings._crossings_of_zero(lambda omega: omega - 1.0, [1.0, 2.0])) == []
    assert list(crossings._crossings_of_zero(lambda omega: 2.5 - omega, [1.0, 2.0, 3.0])) == [2.5]
    assert list(crossings._crossings_of_zero(lambda omega: 9.0 - omega, [1.0, 2.0, 3.0])) == []


@pytest.mark.parametrize(("gain", "level"), [(1e-20, 1.0), (1e20, 1.0), (5.0, 1e-15)])
def test_ends_of_the_plot_are_followed_as_far_as_it_takes(gain: float, level: float) -> None:
    # gain / s meets the level at gain / level.
    assert crossings.gain_crossings(control.tf([gain], [1.0, 0.0]), level) == (
        pytest.approx(gain / level, rel=1e-12, abs=0.0),
    )
    assert crossings.gain_crossings(control.tf([gain, 0.0], [1.0]), level) == (
        pytest.approx(level / gain, rel=1e-12, abs=0.0),
    )


@pytest.mark.parametrize("reach", [1e-6, 1e6])
def test_a_crossing_at_the_end_of_the_range_is_found(reach: float) -> None:
    """Without roots beside the origin the range goes from 1e-6 to 1e6 rad/s: crossings at its very ends."""
    assert crossings.gain_crossings(control.tf([reach], [1.0, 0.0])) == (pytest.approx(reach, rel=1e-14),)
    assert crossings.gain_crossings(control.tf([1.0, 0.0], [reach])) == (pytest.approx(reach, rel=1e-14),)


@pytest.mark.parametrize("order", [1, -1, 2, -3])
def test_straight_ends_are_followed_until_a_fold_beyond_the_level(order: int) -> None:
    """|G| = (crossing / omega)**order is 1 at the crossing; a range that holds it already stays."""
    roots = (0j,) * abs(order)
    for crossing in (1e-20, 1e-3, 1e20):
        gain = crossing ** float(order)
        system = ZeroPoleGain(gain, *((), roots) if order > 0 else (roots, ()))
        found = crossings._gain_ends(system, lambda omega, system=system: float(system.log_gain(omega)))
        expected = (min(1e-6, crossing / math.e), max(1e6, crossing * math.e))
        assert found == pytest.approx(expected, rel=1e-10, abs=0.0)
    level = ZeroPoleGain(5.0, (-1.0 + 0j,), (-2.0 + 0j,))
    for excess in (3.0, 0.0, -3.0):
        assert crossings._gain_ends(level, lambda omega, excess=excess: excess) == (1e-6, 2e6)


def test_curves_are_parted_at_their_ends_extrema_and_roots_above_the_origin() -> None:
    system = ZeroPoleGain(1.0, (0j, 3j, -3j), (-1.0 + 2j, -1.0 - 2j, 0.5j, -0.5j))
    assert crossings._breaks(system, (0.1, 90.0), iter([7.0, 3.0])) == [0.1, 0.5, 3.0, 7.0, 90.0]


def test_half_turns_are_told_in_the_order_in_which_they_are_passed() -> None:
    """The phase of 1/(s + 1)**9 falls through -pi to -4 pi; that of its inverse rises through them."""
    poles = (-1.0 + 0j,) * 9
    omegas = [math.tan(k * math.pi / 9.0) for k in (1, 2, 3, 4)]
    falling = list(crossings._half_turns(ZeroPoleGain(1.0, (), poles), 0.01, 100.0))
    assert [k for _, k in falling] == [-1, -2, -3, -4]
    rising = list(crossings._half_turns(ZeroPoleGain(1.0, poles, ()), 0.01, 100.0))
    assert [k for _, k in rising] == [1, 2, 3, 4]
    for found in (falling, rising):
        assert [omega for omega, _ in found] == pytest.approx(omegas, rel=1e-12)


def test_jumps_at_roots_on_the_axis_are_no_half_turns() -> None:
    """Above 3j the phase of (s² + 9)/(s + 1)**3 is less by -pi than below; it passes no half turn between."""
    system = ZeroPoleGain(1.0, (3j, -3j), (-1.0 + 0j,) * 3)
    below, above = (list(crossings._half_turns(system, *ends)) for ends in ((0.1, 3.0), (3.0, 50.0)))
    assert below == [(pytest.approx(math.tan(math.pi / 3.0)), -1)]
    assert above == []


def test_zeros_of_a_sum_of_fractions() -> None:
    # 2 / (s - 1) + 3 / (s - 4) = (5 s - 11) / ...
    found = extrema._zeros_of_fractions(np.array([1.0 + 0j, 4.0]), np.array([2.0, 3.0]))
    assert found[abs(found) < 1e6] == pytest.approx(2.2)
    assert extrema._zeros_of_fractions(np.zeros(2, dtype=complex), np.ones(2)).size == 0


def test_places_of_a_resonance_and_its_antiresonance() -> None:
    # An undamped zero at 7 and a pole pair of damping ratio 0.1 at 10 rad/s.
    system = ZeroPoleGain.of(control.tf([1.0, 0.0, 49.0], [1.0, 2.0, 100.0]))
    (low, falls), (high, rises) = extrema.stationary_gains(system)
    assert (low, falls, rises) == (pytest.approx(7.0, rel=1e-14), False, True)
    grid = np.linspace(9, 13, 400_001)
    assert high == pytest.approx(grid[np.argmax(system.log_gain(grid))], abs=1e-4)


def test_the_only_peak_of_two_poles_is_where_the_closed_form_says() -> None:
    # |1/((s + 1.4)² + 2.25)| is largest at sqrt(1.5² - 1.4²), between no two of its roots' numbers.
    assert list(extrema.stationary_gains(ZeroPoleGain(1.0, (), (-1.4 + 1.5j, -1.4 - 1.5j)))) == [
        (pytest.approx(math.sqrt(0.29), rel=1e-13), True)
    ]


def test_a_root_on_the_axis_is_an_extremum_to_the_last_digit() -> None:
    found = list(extrema.stationary_gains(ZeroPoleGain(1.0, (0.3j, -0.3j), (-1.0 + 0j, 0.7j, -0.7j, 0j))))
    assert found == [(0.3, False), (0.7, True)]


def test_all_extrema_of_the_phase_are_found() -> None:
    # The lead (s + 1)/(s + 100) is largest at 10 rad/s.
    assert list(extrema.stationary_phases(ZeroPoleGain(1.0, (-1.0 + 0j,), (-100.0 + 0j,)))) == [
        pytest.approx(10.0, rel=1e-13)
    ]
    # Four of them, counted on a grid of the slope.
    zeros = (-0.9 + 3.3j, -0.9 - 3.3j, -1.7 + 4.3j, -1.7 - 4.3j)
    system = ZeroPoleGain(1.0, zeros, (-1.2 + 4.1j, -1.2 - 4.1j, -2.0 + 2.8j, -2.0 - 2.8j))
    grid = np.linspace(0.5, 12.0, 2000)
    slopes = np.array([system.phase_slope_terms(omega).sum() for omega in grid])
    places = np.flatnonzero(np.diff(np.sign(slopes)))
    assert len(places) == 4
    assert list(extrema.stationary_phases(system)) == pytest.approx(grid[places], abs=0.01)


def test_numbers_of_a_mode() -> None:
    mode = Mode(-3.0 + 4.0j, (1, 0, 0, 0))
    assert (mode.omega_natural, mode.omega_damped, mode.damping_ratio) == (5.0, 4.0, 0.6)
    assert mode.frequency == pytest.approx(4.0 / (2 * math.pi))
    shape = modes._complex_shape(np.array([1.0, -2j, 0.5, 1j]))
    assert shape == (0.5j, 1.0, 0.25j, -0.5)


def test_a_response_names_its_signals() -> None:
    time = np.array([0.0, 0.5, 1.0])
    one = TimeResponse(time, time + 1, time[None] + 2, time + 3)
    assert list(one.named) == ["input", "output"]
    assert one.named["input"][0] == 3.0
    assert one.named["output"][0] == 1.0
    several = TimeResponse(
        time, np.stack([time, time + 1]), np.stack([time, -time]), np.stack([time, time + 5])
    )
    assert list(several.named) == ["input 1", "input 2", "output 1", "output 2"]
    assert several.named["input 2"].tolist() == [5.0, 5.5, 6.0]
    columns = several._table().columns
    assert [column.name for column in columns][-2:] == ["state 1", "state 2"]
    assert "3 samples from 0 to 1 s" in repr(one)
    steady = SteadyState(2.0, 3.0, 0.5)
    assert steady.at([0.0, 1.0]).tolist() == pytest.approx([3 * math.sin(0.5), 3 * math.sin(2.5)])
