import math

import mpmath
import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

from tests.quick import quick
from tests.trimmer.elements.oracle import DIGITS, ExactBacklash, largest_ratio
from trimmer import FrictionBacklash, InertiaBacklash, ViscousBacklash
from trimmer.elements.backlashes.backlash import Backlash

HARMONICS = (1, 3, 7)
GAMMAS = (0.0, 1e-8, 1e-3, 0.3, 1.0, 3.0, 1e3, 1e8, math.inf)
ratios = st.floats(1e-6, 1.0 - 1e-6)
gammas = st.floats(-4, 4).map(lambda exponent: 10**exponent)


def element_with(gamma: float) -> Backlash:
    """Backlash with a gap of 1 that has this gamma at an omega of 1."""
    if gamma == 0:
        return FrictionBacklash(1.0)
    return InertiaBacklash(1.0) if gamma == math.inf else ViscousBacklash(1.0, gamma)


def amplitudes_over_the_domain(gamma: float) -> list[float]:
    """Amplitudes from just above the edge to far above the gap."""
    with mpmath.workdps(DIGITS):
        above_the_edge = [
            float((1 + mpmath.mpf(part)) / largest_ratio(mpmath.mpf(gamma))) for part in (1e-9, 1e-4, 0.1)
        ]
    return [*above_the_edge, 2.5, 1e3, 1e12]


@pytest.mark.parametrize("gamma", quick(GAMMAS, 3))
def test_every_harmonic_is_that_of_the_waveform_over_the_whole_domain(gamma: float) -> None:
    element = element_with(gamma)
    for amplitude in amplitudes_over_the_domain(gamma):
        exact = ExactBacklash.of(amplitude, gamma)
        for harmonic in HARMONICS:
            value = complex(element.describing_function(amplitude, 1.0, harmonic))
            reference = exact.describing_function(harmonic)
            assert abs(mpmath.mpc(value) - reference) <= 1e-13 * abs(reference), (amplitude, harmonic)


@pytest.mark.parametrize("gamma", [0.0, 1e-3, 0.3, 3.0, math.inf])
def test_the_imaginary_part_keeps_its_digits_where_it_is_tiny(gamma: float) -> None:
    for amplitude in (1e3, 1e6, 1e12):
        value = element_with(gamma).describing_function(amplitude, 1.0)
        reference = ExactBacklash.of(amplitude, gamma).describing_function(1)
        assert abs(value.imag - reference.imag) <= 1e-12 * abs(reference.imag)


@pytest.mark.parametrize("gamma", GAMMAS)
def test_even_harmonics_are_zero_inside_the_domain_only(gamma: float) -> None:
    element = element_with(gamma)
    for harmonic in (2, 4, 10):
        assert element.describing_function(0.7, 1.0, harmonic) == 0
        assert np.isnan(element.describing_function(0.3, 1.0, harmonic))


@pytest.mark.parametrize("gamma", GAMMAS)
def test_the_domain_ends_where_the_flight_takes_half_a_period(gamma: float) -> None:
    element = element_with(gamma)
    edge = element.domain(1.0)
    assert edge == pytest.approx(float(largest_ratio(mpmath.mpf(gamma))), rel=1e-15)
    inside, outside = element.describing_function([1 / edge * (1 + 1e-14), 1 / edge * (1 - 1e-14)], 1.0)
    assert not np.isnan(inside)
    assert np.isnan(outside)


def test_the_viscous_case_tends_to_friction_with_gamma_squared_and_to_inertia_with_its_reciprocal() -> None:
    amplitude = np.array([0.6, 1.0, 3.0])
    for limit, exponents, order in ((FrictionBacklash(1.0), (-3, -4), 2), (InertiaBacklash(1.0), (3, 4), 1)):
        coarse, fine = (
            abs(
                ViscousBacklash(1.0, 10.0**exponent).describing_function(amplitude, 1.0)
                - limit.describing_function(amplitude)
            )
            for exponent in exponents
        )
        assert np.log10(coarse / fine) == pytest.approx(order, abs=0.01)


def test_time_constants_of_zero_and_infinity_are_the_limits() -> None:
    amplitude = np.geomspace(0.51, 1e6, 50)
    for harmonic in (1, 3):
        resting = ViscousBacklash(1.0, 0.0).describing_function(amplitude, 5.0, harmonic)
        assert resting == pytest.approx(
            FrictionBacklash(1.0).describing_function(amplitude, harmonic=harmonic), rel=1e-13
        )
        flying = ViscousBacklash(1.0, math.inf).describing_function(amplitude, 5.0, harmonic)
        assert np.array_equal(flying, InertiaBacklash(1.0).describing_function(amplitude, harmonic=harmonic))


@given(ratios, gammas, st.sampled_from([1, 3, 5]), st.floats(-6, 6))
def test_only_the_ratio_of_gap_and_amplitude_counts(
    part: float, gamma: float, harmonic: int, exponent: float
) -> None:
    amplitude = 1 / (part * float(ViscousBacklash(1.0, gamma).domain(1.0)))
    scale = 10.0**exponent
    value = ViscousBacklash(1.0, gamma).describing_function(amplitude, 1.0, harmonic)
    scaled = ViscousBacklash(scale, gamma / 7).describing_function(scale * amplitude, 7.0, harmonic)
    assert abs(scaled - value) <= 1e-12 * max(abs(value), 1e-3)


def test_every_starting_value_leads_to_the_solution() -> None:
    """The phase of the impact, from dN/du = (2/π) exp(-jθ), fits the contact equation everywhere."""
    gamma = np.geomspace(1e-10, 1e10, 201)[:, None]
    part = np.r_[np.geomspace(1e-9, 0.5, 200), 1 - np.geomspace(0.5, 1e-6, 200)]
    element = ViscousBacklash(1.0, 1.0)
    ratio = part * element.domain(gamma)
    impact = np.angle(element.derivatives(1 / ratio, gamma).by_u.conj()) % (2 * np.pi)
    separation = np.arctan(1 / gamma)
    flight = -np.cos(separation) * gamma * np.expm1((separation - impact) / gamma)
    distance = np.sin(separation) + flight - np.sin(impact) - ratio
    assert np.abs(distance).max() < 4e-15


def test_shapes_broadcast_and_blocks_do_not_show() -> None:
    element = ViscousBacklash(1.0, 0.01)
    amplitude, omega = np.geomspace(0.6, 50, 300)[:, None], np.geomspace(1, 1e4, 70)
    grid = element.describing_function(amplitude, omega)
    assert grid.shape == (300, 70)
    assert grid[7, 9] == element.describing_function(amplitude[7, 0], omega[9])
    assert grid[299, 69] == element.describing_function(amplitude[299, 0], omega[69])
    assert np.ndim(element.describing_function(1.0, 1.0)) == 0
    assert element.describing_function([], 1.0).shape == (0,)


def test_an_infinite_amplitude_gives_the_limit() -> None:
    for gamma in GAMMAS:
        assert element_with(gamma).describing_function(math.inf, 1.0) == pytest.approx(1.0, abs=1e-15)
        assert element_with(gamma).describing_function(math.inf, 1.0, 3) == pytest.approx(0.0, abs=1e-15)


@pytest.mark.parametrize("time_constant", [0.0, 1e-140, 1e-60, 1e-30, 1e-3, 1.0, 1e30, 1e100, np.inf])
def test_the_gap_does_not_count_at_infinite_amplitude(time_constant: float) -> None:
    element = ViscousBacklash(1.0, time_constant)
    expansion = element.expansion([np.inf, 1e300, 1e200], 1.0)
    assert expansion.value == pytest.approx(np.ones(3), abs=1e-15)
    separation = np.arctan2(1.0, time_constant)
    assert expansion.by_u == pytest.approx(np.full(3, 2 / np.pi * np.exp(-1j * separation)), abs=1e-15)
    assert expansion.by_log_omega == pytest.approx(np.zeros(3), abs=1e-15)
