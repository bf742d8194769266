"""The bounds of 1/G, and 1/G with a linear gain added, against values of G itself."""

import control
import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

from tests.trimmer.balance.loops import THESIS_LOOP, THIRD_ORDER, s
from tests.trimmer.trimmers import stable_systems
from trimmer.balance.inverse_response import InverseResponse
from trimmer.balance.linear_part import LinearGain, with_feedback
from trimmer.balance.stability import closed_loop_poles
from trimmer.linear import ZeroPoleGain

SYSTEMS = (
    THESIS_LOOP,
    THIRD_ORDER,
    1 / s,
    (s + 2) / (s + 1),
    (s**2 + 3) * (s + 5) / (s + 1) ** 3,
    1 / ((s - 1) * (s**2 + 4)),
)


def inverse_response(G) -> InverseResponse:
    return InverseResponse.of(ZeroPoleGain.of(G))


@given(stable_systems(), st.floats(-4, 4), st.floats(-4, 2.5), st.integers(0, 2**32 - 1))
def test_no_value_on_an_interval_exceeds_the_bounds(G, start: float, exponent: float, seed: int) -> None:
    response = inverse_response(G)
    lower, upper = np.array([start]), np.array([start + 10**exponent])
    bounds = response.enclose(lower, upper)
    x = np.random.default_rng(seed).uniform(lower, upper, 200)
    value, slope = response.value_and_slope(np.r_[x, lower, upper])
    slack = 1 + 1e-9
    assert np.all(np.abs(value - bounds.centre) <= bounds.radius * slack + 1e-9 * np.abs(bounds.centre))
    assert np.all(np.abs(value) * slack >= bounds.smallest)
    assert np.all(np.abs(value) <= bounds.largest * slack)
    change = np.abs(slope - bounds.slope)
    assert np.all(change <= bounds.slope_radius * slack + 1e-9 * np.abs(value).max())


@pytest.mark.parametrize(("G", "place"), [(1 / (s**2 + 4), "pole"), ((s**2 + 4) / (s + 1) ** 3, "zero")])
def test_bounds_hold_at_a_root_on_the_axis(G, place: str) -> None:
    response = inverse_response(G)
    lower, upper = np.array([np.log(2.0) - 1e-4]), np.array([np.log(2.0) + 2e-4])
    bounds = response.enclose(lower, upper)
    value = response.value(np.linspace(lower[0], upper[0], 1001))
    assert np.all(np.abs(value) <= bounds.largest * (1 + 1e-9))
    assert np.all(np.abs(value) * (1 + 1e-9) >= bounds.smallest)
    assert np.all(np.abs(value - bounds.centre) <= bounds.radius * (1 + 1e-9))
    assert (bounds.largest[0] < 2e-3) if place == "pole" else (bounds.smallest[0] > 2e3)


def test_bounds_shrink_with_the_interval() -> None:
    """Bounds that stay wide would hold, but the search could not prove anything with them."""
    response = inverse_response(THESIS_LOOP)
    middle = np.log([1000.0, 3470.0, 7000.0])
    for half in (1e-3, 1e-4):
        bounds = response.enclose(middle - half, middle + half)
        assert np.all(bounds.radius < 1.5 * half * np.abs(bounds.slope))
        assert np.all(bounds.largest / bounds.smallest < 1 + 4 * half * np.abs(bounds.slope / bounds.centre))


@pytest.mark.parametrize("G", SYSTEMS, ids=str)
@pytest.mark.parametrize("feedback", [LinearGain(0.3), LinearGain(damping=1.7), LinearGain(0.2 - 0.7j, -0.3)])
def test_a_linear_gain_is_added_to_the_last_digits(G, feedback: LinearGain) -> None:
    response = inverse_response(G)
    omega = np.geomspace(0.03, 30, 41) * response.reference
    scaled = LinearGain(feedback.constant, feedback.damping / response.reference)
    expected = response.value(np.log(omega)) + scaled.value(omega)
    size = np.abs(response.value(np.log(omega))) + np.abs(scaled.value(omega))
    total = with_feedback(response, scaled)
    assert np.abs(total.value(np.log(omega)) - expected) == pytest.approx(0.0, abs=2e-12 * size.max())
    assert np.all(np.abs(total.value(np.log(omega)) - expected) <= 2e-12 * size)


@pytest.mark.parametrize("G", SYSTEMS, ids=str)
@pytest.mark.parametrize("gain", [0.4, 2.0])
def test_poles_of_the_loop_are_those_of_python_control(G, gain: float) -> None:
    response = inverse_response(G)
    (poles,) = closed_loop_poles(response, np.array([gain + 0j])) * response.reference
    expected = np.sort_complex(control.feedback(control.ss(G), gain).poles())
    assert np.abs(poles[:, None] - expected).min(axis=0) == pytest.approx(
        0, abs=1e-8 * np.abs(expected).max()
    )


def test_poles_of_the_loop_with_a_complex_gain_solve_its_equation() -> None:
    response = inverse_response(THESIS_LOOP)
    gains = np.array([0.4 - 0.3j, 0.9 + 0.1j])
    for gain, poles in zip(gains, closed_loop_poles(response, gains), strict=True):
        pole = (poles[:, None] - response.poles).prod(axis=1) * response.gain
        zero = (poles[:, None] - response.zeros).prod(axis=1)
        assert np.all(np.abs(pole + gain * zero) <= 1e-10 * (np.abs(pole) + np.abs(zero)))
