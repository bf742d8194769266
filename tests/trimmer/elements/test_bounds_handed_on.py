"""Bounds and gains of sums, factors, frozen elements and friction by hand, with scales other than 1."""

from __future__ import annotations

import math

import numpy as np
import pytest

from trimmer.elements.backlashes.backlash_bounds import ROUNDED_UP
from trimmer.elements.backlashes.backlash_motion import GAMMA_LIMITS
from trimmer.elements.backlashes.friction_backlash import FrictionBacklash
from trimmer.elements.backlashes.inertia_backlash import InertiaBacklash
from trimmer.elements.backlashes.viscous_backlash import ViscousBacklash
from trimmer.elements.coulomb_friction import CoulombFriction
from trimmer.elements.dead_zone import DeadZone
from trimmer.elements.own_element import StaticElement
from trimmer.elements.preload import Preload
from trimmer.elements.relay import Relay
from trimmer.elements.saturation import Saturation
from trimmer.elements.sum_of_elements import SumOfElements
from trimmer.elements.viscous_friction import ViscousFriction

BACKLASH = ViscousBacklash(4e-5, 2e-3)
LOOP = Relay(3.0, hysteresis=1e-5)
REST = Relay(0.2, 1e-5, 4e-5)
U, OMEGAS = (0.3, 0.7), (200.0, 691.0)
GRID = (np.array([[0.3], [0.4]]), np.array([0.7, 0.8, 0.9]))


def test_a_sum_takes_each_term_at_its_own_u() -> None:
    """u of the sum is 4e-5/A: that of the relay is a quarter of it, that of the saturation half of it."""
    saturation, friction = Saturation(2e-5, 5.0), ViscousFriction(7.0)
    total = BACKLASH + LOOP + saturation + friction
    narrow, half = (0.075, 0.175), (0.15, 0.35)
    for kind in ("sensitivity", "variation"):
        found = getattr(total, kind)(U, OMEGAS)
        parts = [
            (1.0, getattr(BACKLASH, kind)(U, OMEGAS)),
            (4.0, getattr(LOOP, kind)(narrow)),
            (2.0, getattr(saturation, kind)(half)),
            (4e-5, getattr(friction, kind)((0.0, 0.0), OMEGAS)),
        ]
        assert found.by_u == pytest.approx(sum(part.by_u / ratio for ratio, part in parts), rel=1e-12)
        assert found.by_log_omega == pytest.approx(sum(part.by_log_omega for _, part in parts), rel=1e-12)
    reach = (LOOP + saturation).reach(tuple(0.25 * each for each in U))
    # u is 1e-5/A here, and that of the saturation twice as large.
    steepest = saturation.sensitivity(half).by_u * 2.0 * 0.5 * 0.1
    assert reach == pytest.approx(LOOP.reach(narrow) + steepest, rel=1e-12)
    other = (saturation + LOOP).reach(half)
    assert other == pytest.approx(reach, rel=1e-12)
    assert (saturation + BACKLASH).reach(U, OMEGAS) is None
    assert (LOOP + saturation).reach(GRID, (1.0, np.ones(3))).shape == (2, 3)


def test_limits_of_u_of_a_sum_are_those_of_its_terms() -> None:
    assert SumOfElements((Saturation(2e-5), REST)).constant_from == pytest.approx(1.0)
    assert SumOfElements((REST, Saturation(2e-5))).constant_from == pytest.approx(2.5)
    assert SumOfElements((REST, Saturation(2e-5), Relay(1.0))).constant_from == math.inf
    # The relay wants A > 1e-5, the backlash A > 2e-5.
    total = LOOP + FrictionBacklash(4e-5)
    assert total.domain([1.0, 2.0]) == pytest.approx([0.5, 0.5])
    assert (FrictionBacklash(4e-5) + LOOP).domain() == pytest.approx(2.0)
    assert (FrictionBacklash(4e-5) + Relay(3.0, 3e-5)).domain() == pytest.approx(4.0 / 3.0)
    own = StaticElement(np.tanh)
    assert [total.has_bounds for total in (LOOP + REST, LOOP + own, own + LOOP)] == [True, False, False]
    only = SumOfElements((LOOP,))
    assert (only.domain(), only.constant_from, only.amplitude_scale) == (1.0, math.inf, 1e-5)


@pytest.mark.parametrize("factor", [-3.0, 0.5])
def test_a_factor_multiplies_bounds_by_its_modulus(factor: float) -> None:
    scaled, size = BACKLASH * factor, abs(factor)
    for kind in ("sensitivity", "variation"):
        found, own = getattr(scaled, kind)(U, OMEGAS), getattr(BACKLASH, kind)(U, OMEGAS)
        assert (found.by_u, found.by_log_omega) == (size * own.by_u, size * own.by_log_omega)
        assert own.by_u != own.by_log_omega
    assert (factor * LOOP).reach(U) == size * LOOP.reach(U)
    assert scaled.reach(U, OMEGAS) is None
    assert (scaled.amplitude_scale, scaled.domain(691.0)) == (4e-5, BACKLASH.domain(691.0))
    assert ((factor * REST).constant_from, scaled.constant_from) == (1.0, math.inf)
    assert ((factor * REST).has_bounds, (factor * StaticElement(np.tanh)).has_bounds) == (True, False)
    assert (factor * LOOP).mean_gain(7e-5) == factor * LOOP.mean_gain(7e-5)
    assert (factor * InertiaBacklash(1.0)).small_gains() is None
    assert (factor * LOOP).small_gains() == LOOP.small_gains().scaled(factor)
    assert scaled.waveform([0.3, 2.0], 9e-5, 691.0) == pytest.approx(
        factor * BACKLASH.waveform([0.3, 2.0], 9e-5, 691.0), rel=1e-15
    )


def test_a_frozen_element_has_the_bounds_at_its_frequency_in_any_shape() -> None:
    frozen, box = BACKLASH.at(691.0), (GRID[0], GRID[1])
    for kind in ("sensitivity", "variation"):
        found, own = getattr(frozen, kind)(box), getattr(BACKLASH, kind)(box, (691.0, 691.0))
        np.testing.assert_array_equal(found.by_u, own.by_u)
        assert found.by_log_omega.tolist() == np.zeros((2, 3)).tolist()
        assert getattr(frozen, kind)(U, (1.0, np.ones(2))).by_u.shape == (2,)
    assert frozen.domain([1.0, 2.0]).tolist() == [BACKLASH.domain(691.0)] * 2
    assert (frozen.constant_from, REST.at(5.0).constant_from) == (math.inf, 1.0)
    assert (frozen.has_bounds, StaticElement(np.tanh).at(5.0).has_bounds) == (True, False)
    np.testing.assert_array_equal(LOOP.at(5.0).reach(box), LOOP.reach(box))
    assert LOOP.at(5.0).reach((0.1, 0.2), (1.0, np.ones(2))).tolist() == [LOOP.reach((0.1, 0.2))] * 2
    assert frozen.reach(U) is None
    assert (InertiaBacklash(1.0).at(5.0).small_gains(), LOOP.at(5.0).small_gains()) == (
        None,
        LOOP.small_gains(),
    )
    expansion = frozen.expansion([9e-5, 1e-5], 3.0)
    np.testing.assert_array_equal(expansion.by_u, BACKLASH.expansion([9e-5, 1e-5], 691.0).by_u)
    assert expansion.by_log_omega[0] == 0


def test_viscous_friction_rises_with_omega() -> None:
    friction, omegas = ViscousFriction(0.2), (np.array([[3.0], [5.0]]), np.array([7.0, 11.0, 13.0]))
    sensitivity, variation = friction.sensitivity((0.1, 0.2), omegas), friction.variation((0.1, 0.2), omegas)
    np.testing.assert_allclose(sensitivity.by_log_omega, np.tile([1.4, 2.2, 2.6], (2, 1)), rtol=1e-15)
    np.testing.assert_allclose(variation.by_log_omega, [[0.8, 1.6, 2.0], [0.4, 1.2, 1.6]], rtol=1e-14)
    for found in (sensitivity.by_u, variation.by_u):
        assert found.tolist() == np.zeros((2, 3)).tolist()
    expansion = friction.expansion([2.0, 5.0], 691.0)
    assert expansion.value == pytest.approx([138.2j, 138.2j])
    assert expansion.by_log_omega.tolist() == expansion.value.tolist()
    assert expansion.by_u.tolist() == [0.0, 0.0]
    assert friction.describing_function([2.0, 5.0], 691.0, 3).tolist() == [0.0, 0.0]
    assert friction.waveform(0.3, 2e-3, 691.0) == pytest.approx(0.2 * 691.0 * 2e-3 * math.cos(0.3))
    assert (friction.amplitude_scale, friction.domain(2.0)) == (1.0, math.inf)


@pytest.mark.parametrize(
    ("element", "height", "lead"),
    [(CoulombFriction(0.5), 0.5, 1j), (Preload(3.0, 0.4), 3.0, 1.0), (Relay(7.0), 7.0, 1.0)],
)
def test_square_waves(element: CoulombFriction | Preload | Relay, height: float, lead: complex) -> None:
    gain = getattr(element, "slope", 0.0)
    for n in (1, 3, 5):
        expected = lead**n * 4.0 * height / (math.pi * n * 0.7) + (gain if n == 1 else 0.0)
        assert element.describing_function(0.7, harmonic=n) == pytest.approx(expected, rel=1e-14)
    expansion = element.expansion([0.7, 2.0])
    assert expansion.by_u == pytest.approx([4.0 / math.pi * lead] * 2)
    assert expansion.by_log_omega.tolist() == [0.0, 0.0]
    assert element.sensitivity((0.1, 0.2), (1.0, np.ones(2))).by_u.tolist() == [4.0 / math.pi] * 2
    assert element.sensitivity((0.1, 0.2)).by_log_omega == 0.0
    assert (element.amplitude_scale, element.height, element.constant_from) == (height, height, math.inf)
    assert not element.depends_on_frequency


def test_the_mean_passes_corners_for_the_share_of_the_time_between_them() -> None:
    for amplitude in (3e-5, 4e-5, 5e-5, 1e-3):
        share = 2.0 / math.pi * math.asin(min(1.0, 4e-5 / amplitude))
        assert Saturation(4e-5, 691.0).mean_gain(amplitude) == pytest.approx(691.0 * share, rel=1e-13)
        assert DeadZone(4e-5, 691.0).mean_gain(amplitude) == pytest.approx(691.0 * (1 - share), abs=1e-10)
    for kind in (Saturation, DeadZone):
        assert kind(4e-5, 691.0).small_gains().scale == 691.0
        assert kind(4e-5).slope == 1.0


def test_the_box_of_a_backlash_has_the_earliest_impact_at_the_highest_frequency() -> None:
    box = BACKLASH._box((2, 3), GRID, OMEGAS)
    u_lower, u_upper = (np.broadcast_to(each, (2, 3)).ravel() for each in GRID)
    for found, u, omega in ((box.earliest_impact, u_lower, 691.0), (box.latest_impact, u_upper, 200.0)):
        motion = BACKLASH._motion(4e-5 / u, np.full(6, omega))
        np.testing.assert_array_equal(found, motion.impact_phase)
    assert box.lowest_gamma.tolist() == [0.4] * 6
    assert box.highest_gamma == pytest.approx([1.382] * 6, rel=1e-15)
    found = BACKLASH.sensitivity(GRID, OMEGAS)
    assert found.by_u.tolist() == np.full((2, 3), 2.0 / math.pi).tolist()
    np.testing.assert_array_equal(found.by_log_omega.ravel(), box.slope_by_log_gamma())
    changes = BACKLASH.variation(GRID, OMEGAS)
    np.testing.assert_array_equal(changes.by_u.ravel(), box.change_of_slope_by_ratio())
    np.testing.assert_array_equal(changes.by_log_omega.ravel(), box.change_of_slope_by_log_gamma())


def test_backlashes_without_a_time_constant_have_no_slope_by_frequency() -> None:
    for element in (FrictionBacklash(4e-5), InertiaBacklash(4e-5)):
        bounds, changes = element.sensitivity(GRID), element.variation(GRID)
        assert bounds.by_u.tolist() == np.full((2, 3), 2.0 / math.pi).tolist()
        assert bounds.by_log_omega.tolist() == changes.by_log_omega.tolist() == np.zeros((2, 3)).tolist()
        assert element.mean_gain([1e-4, 2e-4]).tolist() == [1.0, 1.0]
        assert element.expansion(9e-5).by_log_omega == 0
    assert FrictionBacklash(4e-5).gamma(np.ones(2)).tolist() == [GAMMA_LIMITS[0]] * 2
    assert InertiaBacklash(4e-5).gamma(np.ones(2)).tolist() == [GAMMA_LIMITS[1]] * 2
    for time_constant, gamma in ((0.0, GAMMA_LIMITS[0]), (math.inf, GAMMA_LIMITS[1]), (2e-3, 1.382)):
        assert ViscousBacklash(4e-5, time_constant).gamma(np.array([691.0])) == pytest.approx(
            [gamma], rel=1e-6, abs=0.0
        )
    # θ_c = π/2 + acos(1 - u), and beyond u = 2 there is none.
    for lower, upper in ((0.5, 1.2), (1.5, 2.5), (1.5, 2.0)):
        turn = math.acos(1.0 - min(upper, 2.0)) - math.acos(1.0 - lower) + 1e-9
        exact = 2.0 / math.pi * 2.0 * math.sin(0.5 * turn)
        assert FrictionBacklash(4e-5).variation((lower, upper)).by_u == pytest.approx(
            ROUNDED_UP * exact, rel=1e-13
        )
    changes = FrictionBacklash(4e-5).variation((0.5, 1.2), (1.0, np.ones(2)))
    assert [each.shape for each in changes] == [(2,), (2,)]


def test_friction_backlash_has_its_parts_at_the_edge_of_the_domain() -> None:
    motion = FrictionBacklash(4e-5)._motion(np.array([2e-5, 2.5e-5, 4e-5, 1e-3]), np.ones(4))
    assert np.isnan(motion.flight).tolist() == [True, False, False, False]
    exact = [math.acos(1.0 - 4e-5 / amplitude) for amplitude in (2.5e-5, 4e-5, 1e-3)]
    assert motion.flight[1:] == pytest.approx(exact, rel=1e-12)
    assert motion.contact[1:] == pytest.approx([math.pi - each for each in exact], rel=1e-12)
    assert motion.impact[1:] == pytest.approx(np.sin(exact), rel=1e-12)
    assert motion.impact_phase[1:] == pytest.approx([0.5 * math.pi + each for each in exact], rel=1e-12)
