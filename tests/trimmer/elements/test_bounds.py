"""Bounds of N are not far off, and sums, factors and frozen elements hand on what their parts say."""

import math

import numpy as np
import pytest

from trimmer import DeadZone, Preload, Relay, Saturation, StaticElement, ViscousBacklash, ViscousFriction
from trimmer.elements import CoulombFriction, Element, FrictionBacklash, InertiaBacklash, SumOfElements

BACKLASH = ViscousBacklash(4e-5, 2e-3)
LOOP, REST = Relay(3.0, hysteresis=1e-5), Relay(0.2, 1e-5, 4e-5)
U, OMEGAS = (0.3, 0.7), (200.0, 691.0)
STATIC: tuple[Element, ...] = (
    *(Saturation(4e-5, 691.0), DeadZone(4e-5, 691.0), Relay(3.0), CoulombFriction(0.5), Preload(3.0, 0.4)),
    *(FrictionBacklash(4e-5), InertiaBacklash(4e-5)),
)
RELAYS = (
    *(Relay(3.0, hysteresis=0.5, dead_zone=0.2), Relay(3.0, hysteresis=0.2, dead_zone=0.5)),
    *(Relay(3.0, hysteresis=0.35, dead_zone=0.35), Relay(3.0, hysteresis=0.0, dead_zone=0.7)),
)
"""All switch on at 0.7, and off elsewhere."""


@pytest.mark.parametrize("element", STATIC, ids=repr)
@pytest.mark.parametrize(("lower", "upper"), [(0.05, 0.1), (0.3, 0.5), (0.7, 0.72), (0.9, 0.99)])
def test_bounds_are_those_of_a_fine_grid_or_little_more(element: Element, lower: float, upper: float) -> None:
    u = np.linspace(lower, upper, 801)
    slopes = element.derivatives(element.amplitude_scale / u).by_u
    largest, spread = element.sensitivity((lower, upper)), element.variation((lower, upper))
    assert 1.0 - 1e-9 <= largest.by_u / abs(slopes).max() < 1.01
    turned = abs(slopes[:, None] - slopes).max()
    assert turned <= spread.by_u * (1.0 + 1e-9)
    assert spread.by_u <= 2.1 * turned + 1e-6 * abs(slopes).max()
    assert largest.by_log_omega == spread.by_log_omega == 0.0


@pytest.mark.parametrize("relay", RELAYS, ids=repr)
@pytest.mark.parametrize(("lower", "upper"), [(0.05, 0.1), (0.3, 0.5), (0.9, 0.99)])
def test_bounds_of_a_relay_with_thresholds_are_not_far_off(relay: Relay, lower: float, upper: float) -> None:
    """It turns on and off on circles of its own, whose parts may cancel in N but do not in its bounds."""
    amplitude = relay.amplitude_scale / np.linspace(lower, upper, 801)
    slopes, values = relay.derivatives(amplitude).by_u, relay.describing_function(amplitude)
    middle = relay.describing_function(2.0 * relay.amplitude_scale / (lower + upper))
    found = relay.sensitivity((lower, upper)).by_u, relay.reach((lower, upper))
    for bound, largest in zip(found, (abs(slopes).max(), abs(values - middle).max()), strict=True):
        assert 1.0 - 1e-9 <= bound / largest < 2.0
    spread = relay.variation((lower, upper)).by_u / abs(slopes[:, None] - slopes).max()
    assert 1.0 - 1e-9 <= spread < 9.0
    arrays = relay.sensitivity((np.array([[lower], [0.01]]), np.array([upper, 1.7]))).by_u
    assert arrays.shape == (2, 2) and arrays[0, 0] == found[0]
    assert arrays[0, 1] == relay.sensitivity((lower, 1.0)).by_u > 1e7


@pytest.mark.parametrize("relay", [each for each in RELAYS if each.dead_zone > each.hysteresis], ids=repr)
def test_of_a_relay_that_rests_nothing_changes(relay: Relay) -> None:
    beyond = (1.0, 1.7)
    assert relay.sensitivity(beyond).by_u == relay.variation(beyond).by_u == relay.reach(beyond) == 0.0


def test_beyond_the_threshold_only_a_relay_without_hysteresis_has_a_reach() -> None:
    for relay in RELAYS[:3]:
        reach = relay.reach((np.array([0.1, 0.5]), np.array([1.1, 0.6])))
        assert reach[0] == math.inf
        assert reach[1] < 10.0
    # The middle 0.9 has asin 0.9, from which asin 1 is as far as its cosine says.
    expected = 2.0 * (6.0 / (math.pi * 0.7)) * math.sqrt(1 - 0.9**2)
    assert RELAYS[3].reach((0.7, 1.1)) == pytest.approx(expected, rel=3e-9)


@pytest.mark.parametrize("gamma", [0.05, 0.4, 1.0, 5.0])
@pytest.mark.parametrize("share", [0.05, 0.3, 0.6, 0.95])
def test_bounds_of_play_by_frequency_are_not_far_off(gamma: float, share: float) -> None:
    element = ViscousBacklash(1.0, gamma)
    u = share * float(element.domain(1.0)) * np.array([1.0, 1.03])
    omegas = (1.0, 1.02)
    slopes = element.derivatives(1.0 / np.linspace(*u, 21)[:, None], np.geomspace(*omegas, 21))
    largest, spread = element.sensitivity(tuple(u), omegas), element.variation(tuple(u), omegas)
    for slope, bound, change, slack in zip(slopes, largest, spread, (1.01, 3.0), strict=True):
        assert 1.0 - 1e-9 <= bound / abs(slope).max() < slack
        turned = abs(slope.reshape(-1, 1) - slope.ravel()).max()
        assert 1.0 - 1e-9 <= change / turned < 12.0
    assert largest.by_u == pytest.approx(2.0 / math.pi)


@pytest.mark.parametrize("factor", [-3.0, 0.5])
def test_a_factor_multiplies_bounds_by_its_modulus(factor: float) -> None:
    scaled, size = BACKLASH * factor, abs(factor)
    for kind in ("sensitivity", "variation"):
        found, own = getattr(scaled, kind)(U, OMEGAS), getattr(BACKLASH, kind)(U, OMEGAS)
        assert (found.by_u, found.by_log_omega) == (size * own.by_u, size * own.by_log_omega)
    assert (factor * LOOP).reach(U) == size * LOOP.reach(U)
    assert (scaled.amplitude_scale, scaled.domain(691.0)) == (4e-5, BACKLASH.domain(691.0))
    assert (factor * LOOP).mean_gain(7e-5) == factor * LOOP.mean_gain(7e-5)
    assert ((factor * REST).constant_from, scaled.constant_from) == (1.0, math.inf)
    assert ((factor * REST).has_bounds, (factor * StaticElement(np.tanh)).has_bounds) == (True, False)
    assert scaled.waveform([0.3, 2.0], 9e-5, 691.0) == pytest.approx(
        factor * BACKLASH.waveform([0.3, 2.0], 9e-5, 691.0), rel=1e-15
    )


def test_a_frozen_element_has_the_bounds_at_its_frequency_in_any_shape() -> None:
    frozen, box = BACKLASH.at(691.0), (np.array([[0.3], [0.4]]), np.array([0.7, 0.8, 0.9]))
    for kind in ("sensitivity", "variation"):
        found, own = getattr(frozen, kind)(box), getattr(BACKLASH, kind)(box, (691.0, 691.0))
        np.testing.assert_array_equal(found.by_u, own.by_u)
        assert found.by_log_omega.tolist() == np.zeros((2, 3)).tolist()
        assert getattr(frozen, kind)(U, (1.0, np.ones(2))).by_u.shape == (2,)
    np.testing.assert_array_equal(LOOP.at(5.0).reach(box), LOOP.reach(box))
    assert (frozen.domain(), frozen.constant_from) == (BACKLASH.domain(691.0), math.inf)
    assert (frozen.has_bounds, StaticElement(np.tanh).at(5.0).has_bounds) == (True, False)


def test_limits_of_u_of_a_sum_are_those_of_its_terms() -> None:
    assert SumOfElements((Saturation(2e-5), REST)).constant_from == pytest.approx(1.0)
    assert SumOfElements((REST, Saturation(2e-5))).constant_from == pytest.approx(2.5)
    play, box = ViscousBacklash(1e-5, 2e-3), (0.0, 0.7)
    steep = 0.35 * play.sensitivity(box, OMEGAS).by_u
    assert (LOOP + play).reach(box, OMEGAS) == pytest.approx(LOOP.reach(box) + steep)
    assert SumOfElements((REST, Saturation(2e-5), Relay(1.0))).constant_from == math.inf
    # The relay wants A > 1e-5, the backlash A > 2e-5.
    assert (LOOP + FrictionBacklash(4e-5)).domain([1.0, 2.0]) == pytest.approx([0.5, 0.5])
    assert (FrictionBacklash(4e-5) + Relay(3.0, 3e-5)).domain() == pytest.approx(4.0 / 3.0)
    own = StaticElement(np.tanh)
    assert [total.has_bounds for total in (LOOP + REST, LOOP + own, own + LOOP)] == [True, False, False]


def test_viscous_friction_rises_with_omega() -> None:
    friction, omegas = ViscousFriction(0.2), (np.array([[3.0], [5.0]]), np.array([7.0, 11.0, 13.0]))
    sensitivity, variation = friction.sensitivity((0.1, 0.2), omegas), friction.variation((0.1, 0.2), omegas)
    np.testing.assert_allclose(sensitivity.by_log_omega, np.tile([1.4, 2.2, 2.6], (2, 1)), rtol=1e-15)
    np.testing.assert_allclose(variation.by_log_omega, [[0.8, 1.6, 2.0], [0.4, 1.2, 1.6]], rtol=1e-14)
    assert not sensitivity.by_u.any()
    assert (friction.domain(2.0), friction.describing_function(2.0, 691.0, 3)) == (math.inf, 0.0)


def test_an_element_without_bounds_says_so_in_the_shape_of_what_is_asked() -> None:
    element, u = StaticElement(np.tanh), (np.zeros((2, 1)), np.ones(3))
    for found in (element.sensitivity(u), element.variation(u)):
        assert [np.shape(each) for each in found] == [(2, 3), (2, 3)]
        assert all(np.isinf(each).all() for each in found)
    assert (element.has_bounds, element.depends_on_frequency, element.domain()) == (False, False, math.inf)


def test_a_load_passes_the_mean_and_friction_does_not() -> None:
    play, relay, amplitudes = ViscousBacklash(1.0, 0.2), Relay(1.0), np.array([1.3, 5.0])
    assert (FrictionBacklash(1.0).mean_gain(1.3), play.at(3.0).mean_gain(0.9)) == (1.0, 1.0)
    assert CoulombFriction(2.0).mean_gain(1.0) == 0.0
    assert play.mean_gain(amplitudes).tolist() == [1.0, 1.0]
    assert ViscousFriction(2.0).mean_gain(amplitudes).tolist() == [0.0, 0.0]
    together = (2.0 * play - 0.5 * relay + CoulombFriction(1.0)).mean_gain(amplitudes)
    np.testing.assert_allclose(together, 2.0 - 0.5 * relay.mean_gain(amplitudes), rtol=1e-15)


@pytest.mark.parametrize("threshold", [4e-5, 1.0])
def test_the_mean_passes_corners_for_the_share_of_the_time_between_them(threshold: float) -> None:
    for amplitude in threshold * np.array([0.75, 1.0, 1.25, 25.0]):
        share = 2.0 / math.pi * math.asin(min(1.0, threshold / amplitude))
        assert Saturation(threshold, 7.0).mean_gain(amplitude) == pytest.approx(7.0 * share, rel=1e-13)
        assert DeadZone(threshold, 7.0).mean_gain(amplitude) == pytest.approx(7.0 * (1 - share), abs=1e-12)
