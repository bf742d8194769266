"""Zeros and poles of systems, and frequencies at boundaries of what is searched."""

import math

import control
import numpy as np
import pytest

from trimmer.linear import (
    UnsupportedSystemError,
    ZeroPoleGain,
    antiresonances,
    gain_crossings,
    real_axis_crossings,
    resonance_peaks,
)


def test_a_slow_pole_is_no_rounding() -> None:
    (pole,) = ZeroPoleGain.of(control.tf([1.0], [1.0, 1e-20])).poles
    assert pole == pytest.approx(-1e-20, rel=1e-6, abs=0.0)


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


def test_roots_are_ordered_by_size_and_rounding_is_no_real_part() -> None:
    found = ZeroPoleGain.of(control.tf([1.0], np.poly([-7.0, -3.0, -2 + 5j, -2 - 5j]).real))
    assert np.abs(found.poles) == pytest.approx([3.0, math.sqrt(29), math.sqrt(29), 7.0], rel=1e-9)
    assert found.poles[1].imag < 0 < found.poles[2].imag
    undamped = ZeroPoleGain.of(control.ss([[0.0, 1.0], [-9.0, 0.0]], [[0.0], [1.0]], [[1.0, 0.0]], 0.0))
    assert [pole.real for pole in undamped.poles] == [0.0, 0.0]
    assert (undamped.gain, undamped.zeros) == (pytest.approx(1.0), ())


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


@pytest.mark.parametrize(("gain", "level"), [(1e-20, 1.0), (1e20, 1.0), (5.0, 1e-15)])
def test_ends_of_the_plot_are_followed_as_far_as_it_takes(gain: float, level: float) -> None:
    # gain / s meets the level at gain / level.
    falling, rising = control.tf([gain], [1.0, 0.0]), control.tf([gain, 0.0], [1.0])
    for system, expected in ((falling, gain / level), (rising, level / gain)):
        assert gain_crossings(system, level) == (pytest.approx(expected, rel=1e-12, abs=0.0),)


@pytest.mark.parametrize("reach", [1e-6, 1e6])
def test_a_crossing_at_the_end_of_the_range_is_found(reach: float) -> None:
    """Without roots beside the origin the range goes from 1e-6 to 1e6 rad/s: crossings at its very ends."""
    assert gain_crossings(control.tf([reach], [1.0, 0.0])) == (pytest.approx(reach, rel=1e-14),)
    assert gain_crossings(control.tf([1.0, 0.0], [reach])) == (pytest.approx(reach, rel=1e-14),)


def test_half_turns_are_told_in_the_order_in_which_they_are_passed() -> None:
    """The phase of 1/(s + 1)**9 falls through -pi to -4 pi; that of its inverse rises through them."""
    poles = np.poly([-1.0] * 9)
    omegas = [math.tan(k * math.pi / 9.0) for k in (1, 2, 3, 4)]
    for system, power in ((control.tf([1.0], poles), 1), (control.tf(poles, [1.0]), -1)):
        found = real_axis_crossings(system)
        values = [(-1) ** k * math.cos(k * math.pi / 9.0) ** (9 * power) for k in (1, 2, 3, 4)]
        # Nine poles that are one are known to a ninth root of rounding.
        assert [each.omega for each in found] == pytest.approx(omegas, rel=1e-2)
        assert [each.value for each in found] == pytest.approx(values, rel=1e-2)


def test_roots_on_the_axis_and_extrema_between_them_to_the_last_digit() -> None:
    # |1/((s + 1.4)² + 2.25)| is largest at sqrt(1.5² - 1.4²), between no two of its roots' numbers.
    (peak,) = resonance_peaks(control.tf([1.0], [1.0, 2.8, 1.4**2 + 2.25]))
    assert peak.omega == pytest.approx(math.sqrt(0.29), rel=1e-12)
    system = control.tf([1.0, 0.0, 0.09], np.polymul([1.0, 0.0, 0.49], [1.0, 1.0, 0.0]))
    assert [each.omega for each in antiresonances(system)] == [pytest.approx(0.3, rel=1e-15)]
    assert [each.omega for each in resonance_peaks(system)] == [pytest.approx(0.7, rel=1e-15)]
