"""Sums of elements: with viscous friction, with Coulomb friction or a relay, and with both."""

import control
import mpmath
import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st
from scipy.optimize import brentq

from tests.trimmer.balance.loops import GAP, THESIS_LOOP, THIRD_ORDER, s
from tests.trimmer.trimmers import exact_response
from trimmer import (
    CoulombFriction,
    Relay,
    Saturation,
    ViscousBacklash,
    ViscousFriction,
    harmonic_balance,
    limit_cycles,
)
from trimmer.elements import Element, FrictionBacklash


@pytest.mark.parametrize(("force", "count"), [(0.0, 2), (1e-8, 2), (1e-6, 2), (3e-5, 0)])
def test_equivalent_nonlinearity_of_the_thesis_to_eleven_digits(force: float, count: int) -> None:
    """Backlash, without and with Coulomb friction (equation 5.14), against 40 digits from what is found."""
    element = FrictionBacklash(GAP) + CoulombFriction(force) if force else FrictionBacklash(GAP)
    found = limit_cycles(THESIS_LOOP, element)
    assert len(found) == count
    for cycle in found:
        with mpmath.workdps(40):

            def balance(u, omega):
                c = 1 - u
                real = (mpmath.pi / 2 + mpmath.asin(c) + c * mpmath.sqrt(1 - c**2)) / mpmath.pi
                imaginary = -u * (2 - u) / mpmath.pi + 4 * mpmath.mpf(force) * u / (mpmath.pi * GAP)
                excess = 1 + mpmath.mpc(real, imaginary) * exact_response(omega)
                return excess.real, excess.imag

            u, omega = mpmath.findroot(balance, (GAP / cycle.amplitude, cycle.omega), tol=1e-25)
            assert abs(cycle.omega / omega - 1) < 1e-11
            assert abs(cycle.amplitude * u / mpmath.mpf(GAP) - 1) < 1e-11


@pytest.mark.parametrize("backlash", [FrictionBacklash(1.0), ViscousBacklash(1.0, 0.3)])
def test_viscous_friction_is_damping_of_the_system(backlash: Element) -> None:
    """K/D with the feedback c s is K/(D + c K s)."""
    inside = limit_cycles(6 / (s**2 + s + 0.5) / (s + 1), backlash + ViscousFriction(0.05))
    denominator = np.polyadd(np.polymul([1, 1, 0.5], [1, 1]), [6 * 0.05, 0])
    outside = limit_cycles(control.tf([6], denominator), backlash)
    assert len(inside) == len(outside) > 0
    for one, other in zip(inside, outside, strict=True):
        assert one.omega == pytest.approx(other.omega, rel=1e-11)
        assert one.amplitude == pytest.approx(other.amplitude, rel=1e-11)
        assert (one.stable, one.index) == (other.stable, other.index)


def test_frozen_viscous_friction_is_a_constant() -> None:
    """At its own frequency the shortcut of the thesis gives the same limit cycle, elsewhere another one."""
    element = ViscousBacklash(1.0, 0.3) + ViscousFriction(0.05) + CoulombFriction(0.1)
    G = 20 / (s + 1) ** 3
    for cycle in limit_cycles(G, element):
        frozen = limit_cycles(G, element, frozen_omega=cycle.omega)
        nearest = min(frozen, key=lambda other: abs(other.omega - cycle.omega))
        assert nearest.omega == pytest.approx(cycle.omega, rel=1e-10)
        assert nearest.amplitude == pytest.approx(cycle.amplitude, rel=1e-10)
        moved = limit_cycles(G, element, frozen_omega=1.3 * cycle.omega)
        assert all(abs(other.omega / cycle.omega - 1) > 1e-4 for other in moved)


@given(
    st.floats(-6, 6).map(lambda exponent: 10**exponent), st.floats(-6, 6).map(lambda exponent: 10**exponent)
)
@settings(max_examples=6)
def test_limit_cycles_of_a_sum_scale_with_length_and_force(length: float, stiffness: float) -> None:
    def cycles(length: float, stiffness: float) -> list[tuple[float, float]]:
        backlash = stiffness * FrictionBacklash(length)
        element = backlash + CoulombFriction(0.1 * stiffness * length) + ViscousFriction(0.05 * stiffness)
        found = limit_cycles(20 / stiffness / (s + 1) ** 3, element)
        return [(cycle.amplitude / length, cycle.omega) for cycle in found]

    reference = cycles(1.0, 1.0)
    assert len(reference) == 1
    assert cycles(length, stiffness) == pytest.approx(np.array(reference), rel=1e-10)


@pytest.mark.parametrize("hysteresis", [0.0, 0.1])
def test_a_relay_that_does_not_switch_leaves_the_certificate(hysteresis: float) -> None:
    plain, beside = Saturation(0.15), Relay(0.1, dead_zone=2.3, hysteresis=hysteresis)
    alone, both = (harmonic_balance(40 / (s + 1) ** 3, each) for each in (plain, plain + beside))
    assert both.certificate.complete
    assert [(each.amplitude, each.omega) for each in both.limit_cycles] == [
        pytest.approx((each.amplitude, each.omega), rel=1e-12) for each in alone.limit_cycles
    ]


def test_it_does_not_matter_to_a_certificate_how_sums_are_nested() -> None:
    """The backlash wants so large an amplitude that the relay beside the saturation stays bounded."""
    relay, limit, play = Relay(0.1), Saturation(1.0), FrictionBacklash(gap=0.2)
    nested = (relay + limit) + play, relay + (limit + play)
    first, second = (harmonic_balance(40 / (s + 1) ** 3, each) for each in nested)
    assert first.certificate.complete
    assert second.certificate.complete
    assert [each.amplitude for each in first.limit_cycles] == pytest.approx(
        [each.amplitude for each in second.limit_cycles], rel=1e-12
    )


@pytest.mark.parametrize("level", [0.1, 1.0])
def test_a_relay_beside_what_saturates_is_searched_on_a_grid(level: float) -> None:
    """N grows without bound, and not like 1/A; 1/(s (s + 1) (s + 2)) is -1/6 at sqrt(2)."""
    found = harmonic_balance(30 * THIRD_ORDER, Relay(level) + Saturation(0.15) + Saturation(0.4))
    assert not found.certificate.complete
    (cycle,) = found.limit_cycles

    def gain(amplitude: float) -> float:
        ratios = np.array([0.15, 0.4]) / amplitude
        return (
            4 * level / amplitude + 2 * (np.arcsin(ratios) + ratios * np.sqrt(1 - ratios**2)).sum()
        ) / np.pi

    expected = brentq(lambda amplitude: gain(amplitude) - 0.2, 0.4, 100.0, xtol=1e-14)
    assert (cycle.amplitude, cycle.omega) == pytest.approx((expected, np.sqrt(2.0)), rel=1e-10)
