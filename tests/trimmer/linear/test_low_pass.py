import math

import control
import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from tests.trimmer.trimmers import exact_response, stable_systems
from trimmer.linear import (
    UnsupportedSystemError,
    asymptotic_roll_off,
    bandwidth,
    bandwidth_crossings,
    filtering_ratio,
    local_slope,
)
from trimmer.thesis import InputChannels, TrimmerParameters, pin_model

THESIS = TrimmerParameters.thesis()
AS_IN_THE_THESIS = pin_model(THESIS, channels=InputChannels.DISPLACEMENT_ONLY)


def test_bandwidth_of_the_thesis_trimmer_is_the_lowest_of_three_crossings() -> None:
    lowest, _, _ = bandwidth_crossings(AS_IN_THE_THESIS)
    assert lowest == bandwidth(AS_IN_THE_THESIS)
    assert lowest == pytest.approx(float(control.bandwidth(AS_IN_THE_THESIS)), rel=1e-9)


def test_bandwidth_of_a_first_order_system() -> None:
    system = control.tf([1], [1, 1])
    assert bandwidth(system) == pytest.approx(math.sqrt(10**0.3 - 1), rel=1e-12)
    assert bandwidth(system, dbdrop=-20) == pytest.approx(math.sqrt(99), rel=1e-12)
    assert bandwidth(-system) == bandwidth(system)


def test_bandwidth_is_infinite_where_the_gain_never_drops() -> None:
    assert bandwidth(control.tf([2, 1], [1, 1])) == math.inf
    assert bandwidth_crossings(control.tf([2, 1], [1, 1])) == ()


@pytest.mark.parametrize("system", [control.tf([1], [1, 0]), control.tf([1, 0], [1, 1])])
def test_bandwidth_needs_a_gain_at_zero_frequency(system: control.TransferFunction) -> None:
    with pytest.raises(UnsupportedSystemError, match=r"gain at zero frequency is (inf|0) "):
        bandwidth(system)


@pytest.mark.parametrize("dbdrop", [0.0, 3.0, math.nan, -math.inf])
def test_the_drop_must_be_negative(dbdrop: float) -> None:
    with pytest.raises(ValueError, match="dbdrop must be"):
        bandwidth(AS_IN_THE_THESIS, dbdrop)


def test_roll_off_of_the_trimmer_with_one_and_with_both_channels() -> None:
    assert asymptotic_roll_off(AS_IN_THE_THESIS) == -40.0
    assert asymptotic_roll_off(pin_model(THESIS)) == -20.0


@settings(max_examples=10)
@given(stable_systems(), st.floats(-2, 2))
def test_the_local_slope_is_that_of_the_bode_plot(system: control.TransferFunction, exponent: float) -> None:
    decades = np.array([exponent - 1e-7, exponent + 1e-7])
    before, after = 20 * np.log10(np.abs(system(1j * 10**decades)))
    (slope,) = local_slope(system, [10**exponent])
    assert slope == pytest.approx((after - before) / 2e-7, rel=1e-2, abs=1e-2)


def test_local_slopes_have_the_shape_of_the_frequencies() -> None:
    assert local_slope(AS_IN_THE_THESIS, [[1e4, 1e5, 1e6]]).shape == (1, 3)
    assert local_slope(AS_IN_THE_THESIS, 1e4).shape == ()


def test_filtering_ratio_of_the_thesis_trimmer_is_that_of_the_force_balance() -> None:
    omega = 200 * np.pi
    for harmonic in (2, 3, 5):
        exact = abs(exact_response(harmonic * omega)) / abs(exact_response(omega))
        assert filtering_ratio(AS_IN_THE_THESIS, omega, harmonic) == pytest.approx(float(exact), rel=1e-11)
    assert filtering_ratio(AS_IN_THE_THESIS, [omega, 2 * omega], 3).shape == (2,)


@pytest.mark.parametrize("harmonic", [1, 0, -2])
def test_the_fundamental_is_no_harmonic_to_filter(harmonic: int) -> None:
    with pytest.raises(ValueError, match="start at 2"):
        filtering_ratio(AS_IN_THE_THESIS, 1.0, harmonic)
