import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from trimmer import CoulombFriction, DeadZone, FrictionBacklash, InertiaBacklash, Preload, ViscousBacklash
from trimmer.elements import Element, Relay, Saturation, ViscousFriction

ELEMENTS: tuple[Element, ...] = (
    FrictionBacklash(2.0),
    InertiaBacklash(2.0),
    ViscousBacklash(2.0, 0.3),
    Relay(3.0),
    CoulombFriction(0.5),
    ViscousFriction(0.2),
    ViscousBacklash(2.0, 0.3) + 2.0 * CoulombFriction(0.5) - ViscousFriction(0.2),
    ViscousBacklash(2.0, 0.3).at(4.0),
    Saturation(2.0, 0.7),
    DeadZone(2.0, 0.7),
    Preload(3.0, 0.4),
    Relay(3.0, hysteresis=2.0),
    Relay(3.0, dead_zone=2.0),
    Relay(3.0, hysteresis=0.5, dead_zone=1.5),
    Relay(3.0, hysteresis=1.5, dead_zone=0.5),
    Saturation(2.0) - 0.3 * Relay(1.0, hysteresis=0.5, dead_zone=0.5),
)
widths = st.floats(-3, 0.5).map(lambda exponent: 10**exponent)


@pytest.mark.parametrize("element", ELEMENTS, ids=repr)
@pytest.mark.parametrize("omega", [0.01, 1.0, 3.4, 200.0])
@pytest.mark.parametrize("u", [0.05, 0.93, 1.9])
def test_derivatives_are_those_of_difference_quotients(element: Element, omega: float, u: float) -> None:
    def value(u: float, omega: float) -> complex:
        return complex(element.describing_function(element.amplitude_scale / u, omega))

    step = 1e-4 * u
    slopes = element.derivatives(element.amplitude_scale / u, omega)
    by_u = (value(u + step, omega) - value(u - step, omega)) / (2 * step)
    assert slopes.by_u == pytest.approx(by_u, rel=2e-6, abs=1e-8, nan_ok=True)
    if np.isnan(by_u):
        assert u > 1.0  # outside the domain
        return
    by_log = (value(u, omega * np.exp(1e-4)) - value(u, omega * np.exp(-1e-4))) / 2e-4
    assert slopes.by_log_omega == pytest.approx(by_log, rel=2e-6, abs=1e-9)


@pytest.mark.parametrize("element", ELEMENTS, ids=repr)
def test_an_expansion_is_value_and_derivatives(element: Element) -> None:
    amplitude, omega = np.array([[0.3, 1.2, 5.0, np.nan]]), np.array([[0.5], [8.0]])
    expansion = element.expansion(amplitude, omega)
    assert np.array_equal(expansion.value, element.describing_function(amplitude, omega), equal_nan=True)
    for own, derivative in zip(expansion[1:], element.derivatives(amplitude, omega), strict=True):
        assert np.array_equal(own, derivative, equal_nan=True)
        assert own.shape == (2, 4)


@pytest.mark.parametrize(
    "element", [each for each in ELEMENTS if each.reach((0.1, 0.2)) is not None], ids=repr
)
@settings(max_examples=20)
@given(start=st.floats(0.0, 1.0), share=st.floats(0.0, 1.0), seed=st.integers(0, 2**32 - 1))
def test_no_value_is_farther_from_the_middle_than_the_reach(
    element: Element, start: float, share: float, seed: int
) -> None:
    end = start + share * (1.0 - start)
    u = np.r_[0.5 * (start + end), start, np.random.default_rng(seed).uniform(start, end, 100), end]
    # Amplitudes are rounded: u = 1 may become more, and 0 has none.
    middle, *values = element.describing_function(element.amplitude_scale / np.clip(u, 1e-300, 1.0 - 1e-15))
    reach = element.reach((start, end))
    known = np.array(values)[~np.isnan(values)]
    if not np.isnan(middle) and known.size:
        assert np.abs(known - middle).max() <= reach + 1e-13


@pytest.mark.parametrize(
    "element", [each for each in ELEMENTS if each.reach((0.1, 0.2)) is not None], ids=repr
)
def test_a_reach_shrinks_with_the_box_even_next_to_the_threshold(element: Element) -> None:
    wide, narrow = element.reach((1.0 - 1e-2, 1.0)), element.reach((1.0 - 1e-6, 1.0))
    assert wide < np.inf
    assert narrow < 0.02 * wide


def test_derivatives_are_missing_outside_the_domain() -> None:
    slopes = ViscousBacklash(2.0, 0.3).derivatives([0.5, 2.0, np.nan], 1.0)
    for slope in slopes:
        assert np.isnan(slope).tolist() == [True, False, True]


def test_the_slope_of_backlash_over_gap_by_amplitude_has_one_modulus() -> None:
    amplitude = 1 / np.linspace(0.01, 1.99, 50)
    for element in (FrictionBacklash(1.0), InertiaBacklash(1.0), ViscousBacklash(1.0, 0.4)):
        assert np.abs(element.derivatives(amplitude, 2.0).by_u) == pytest.approx(2 / np.pi, rel=1e-14)


@pytest.mark.parametrize("element", ELEMENTS, ids=repr)
@settings(max_examples=20)
@given(
    start=st.floats(0.0, 3.0),
    u_width=widths,
    exponent=st.floats(-3, 3),
    log_width=widths,
    seed=st.integers(0, 2**32 - 1),
)
def test_no_derivative_on_a_box_exceeds_its_bounds(
    element: Element, start: float, u_width: float, exponent: float, log_width: float, seed: int
) -> None:
    u_range = (start, start + u_width)
    omega_range = (10**exponent, 10**exponent * np.exp(log_width))
    random = np.random.default_rng(seed)
    u = np.r_[u_range, random.uniform(*u_range, 60)] + 1e-12
    omega = np.r_[omega_range, np.exp(random.uniform(*np.log(omega_range), 60))]
    slopes = element.derivatives(element.amplitude_scale / u, omega)
    largest, spread = element.sensitivity(u_range, omega_range), element.variation(u_range, omega_range)
    for slope, bound, change in zip(slopes, largest, spread, strict=True):
        inside = slope[~np.isnan(slope)]
        if inside.size:
            slack = 1e-9 * (1 + bound)
            assert np.abs(inside).max() <= bound + slack
            assert np.abs(inside[:, None] - inside).max() <= change + slack


def test_bounds_shrink_with_the_box() -> None:
    """Bounds that stay wide would hold, but a solver could not prove anything with them."""
    element = ViscousBacklash(1.0, 1.0)
    for u, omega in ((0.2, 0.3), (1.0, 1.0), (1.8, 20.0)):
        slope = element.derivatives(1 / u, omega)
        bound = element.sensitivity((u, u + 1e-3), (omega, 1.001 * omega))
        assert bound.by_log_omega < 1.5 * abs(slope.by_log_omega)
        wide, narrow = (element.variation((u, u + h), (omega, (1 + h) * omega)) for h in (1e-2, 1e-4))
        assert narrow.by_u < 0.02 * wide.by_u
        assert narrow.by_log_omega < 0.02 * wide.by_log_omega


def test_boxes_come_in_arrays() -> None:
    element = ViscousBacklash(1.0, 1.0)
    lower = np.array([[0.1], [0.5]])
    omega = np.array([1.0, 2.0, 3.0])
    for bounds in (
        element.sensitivity((lower, 1.0), (omega, 4.0)),
        element.variation((lower, 1.0), (omega, 4.0)),
    ):
        assert bounds.by_log_omega.shape == (2, 3)
        assert bounds.by_u.shape == (2, 3)
    single = element.sensitivity((0.5, 1.0), (2.0, 4.0))
    assert single.by_log_omega == element.sensitivity((lower, 1.0), (omega, 4.0)).by_log_omega[1, 1]


def test_domains() -> None:
    assert FrictionBacklash(3.0).domain() == 2.0
    assert InertiaBacklash(3.0).domain() == pytest.approx(np.pi, rel=1e-15)
    assert Relay(3.0).domain([1.0, 2.0]).tolist() == [np.inf, np.inf]
    # u of the sum is that of its first term: 6/A < 2 for the second means 3/A < 1.
    assert (Relay(3.0) + FrictionBacklash(6.0)).domain() == 1.0
    assert FrictionBacklash(3.0).at(1.0).domain() == 2.0
