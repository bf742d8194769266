"""What is not certain is reported: tangency, a continuum, poles on the axis, the ends of the axis."""

from __future__ import annotations

import math

import mpmath
import pytest

from tests.trimmer.balance.loops import s
from trimmer.balance.solve import harmonic_balance, limit_cycles
from trimmer.elements.coulomb_friction import CoulombFriction
from trimmer.elements.friction_backlash import FrictionBacklash
from trimmer.elements.inertia_backlash import InertiaBacklash
from trimmer.elements.relay import Relay
from trimmer.elements.viscous_backlash import ViscousBacklash
from trimmer.errors import UndecidedWarning


def test_a_continuum_is_reported_and_not_enumerated() -> None:
    # G = 1/(s^2+1) is real at all frequencies and negative above 1.
    balance = harmonic_balance(1 / (s**2 + 1), Relay(1.0), omega_range=(0.1, 10.0))
    assert balance.limit_cycles == ()
    assert balance.certificate.winding_number is None
    lowest = min(region.omegas[0] for region in balance.certificate.undecided)
    highest = max(region.omegas[1] for region in balance.certificate.undecided)
    assert lowest == pytest.approx(1.0, rel=0.05)
    assert highest == pytest.approx(10.0, rel=1e-6)
    with pytest.warns(UndecidedWarning, match="touch or coincide"):
        limit_cycles(1 / (s**2 + 1), Relay(1.0), omega_range=(0.1, 10.0))


def test_a_continuum_at_all_frequencies_needs_no_range() -> None:
    with pytest.warns(UndecidedWarning, match="touch or coincide|are not excluded; give omega_range"):
        assert limit_cycles(1 / s**2, Relay(1.0)) == []


def tangency() -> tuple[float, float, float]:
    """K, omega and gap/A where the curves of K/(s(s+1)) and backlash touch, to 15 of 30 digits."""
    with mpmath.workdps(30):

        def gain(u):
            c = 1 - u
            real = (mpmath.pi / 2 + mpmath.asin(c) + c * mpmath.sqrt(1 - c**2)) / mpmath.pi
            return mpmath.mpc(real, -u * (2 - u) / mpmath.pi)

        def conditions(K, omega, u):
            inverse, slope = mpmath.mpc(-(omega**2), omega) / K, mpmath.mpc(-2 * omega, 1) / K
            excess, by_u = gain(u) + inverse, mpmath.diff(gain, u)
            return excess.real, excess.imag, (by_u * mpmath.conj(slope)).imag

        return tuple(map(float, mpmath.findroot(conditions, (3.417, 0.757, 1.55), tol=1e-20)))


def test_a_tangency_is_undecided_and_its_neighbours_are_none_or_two_that_are_flagged() -> None:
    K, omega, u = tangency()
    element = FrictionBacklash(1.0)
    below = harmonic_balance((1 - 1e-3) * K / (s * (s + 1)), element)
    assert below.limit_cycles == ()
    assert below.certificate.complete
    above = harmonic_balance((1 + 1e-3) * K / (s * (s + 1)), element)
    assert above.certificate.complete
    assert len(above.limit_cycles) == 2
    assert all(cycle.near_tangency for cycle in above.limit_cycles)
    assert sorted(cycle.index for cycle in above.limit_cycles) == [-1, 1]
    (region,) = harmonic_balance(K / (s * (s + 1)), element).certificate.undecided
    assert region.omegas[0] <= omega <= region.omegas[1]
    assert region.amplitudes[0] <= 1 / u <= region.amplitudes[1]
    assert region.omegas[1] / region.omegas[0] < 1.01
    with pytest.warns(UndecidedWarning, match="touch or coincide"):
        limit_cycles(K / (s * (s + 1)), element)


def test_a_hidden_undamped_mode_is_passed_over_or_undecided() -> None:
    third_order = 20 / (s + 1) ** 3
    hidden = third_order * (s**2 + 0.25) / (s**2 + 0.25)
    expected = limit_cycles(third_order, FrictionBacklash(1.0))
    balance = harmonic_balance(hidden, FrictionBacklash(1.0))
    assert [cycle.omega for cycle in balance.limit_cycles] == pytest.approx(
        [c.omega for c in expected], rel=1e-6
    )
    assert all(region.omegas[0] <= 0.5 <= region.omegas[1] for region in balance.certificate.undecided)


@pytest.mark.parametrize("element", [FrictionBacklash(1.0), ViscousBacklash(1.0, 0.5)])
def test_all_amplitudes_are_covered_unless_gain_is_unbounded_and_n_vanishes(element) -> None:
    assert harmonic_balance(10 / (s + 1) ** 3, element).certificate.smallest_gain == 0
    servo = harmonic_balance(10 / (s * (s + 1)), element).certificate
    assert 0 < servo.smallest_gain < 1e-5


@pytest.mark.parametrize("element", [InertiaBacklash(1.0), FrictionBacklash(1.0) + CoulombFriction(0.5)])
def test_an_n_that_does_not_vanish_leaves_nothing_out(element) -> None:
    assert harmonic_balance(10 / (s * (s + 1)), element).certificate.smallest_gain == 0


def test_a_limit_cycle_next_to_the_edge_of_the_dead_band_is_found() -> None:
    # At its resonance at 1 rad/s G is about -j 1e8, so -1/G is -j 1e-8 and gap/A is 2 - pi/2 * 1e-8.
    (cycle,) = limit_cycles(1e4 / (s**2 + 1e-4 * s + 1), FrictionBacklash(1.0), (0.99, 1.01))
    assert cycle.amplitude - 0.5 == pytest.approx(math.pi / 8 * 1e-8, rel=1e-3)
    assert cycle.omega == pytest.approx(1.0, rel=1e-6)


def test_zero_frequency_and_infinite_amplitude_are_undecided_if_the_static_gain_is_minus_one() -> None:
    (region,) = harmonic_balance(-1 / (s + 1) ** 2, FrictionBacklash(1.0)).certificate.undecided
    assert region.omegas[1] < 1e-5
    assert region.amplitudes[0] > 1e5
    for static_gain in (-0.999, -1.001):
        assert harmonic_balance(static_gain / (s + 1) ** 2, FrictionBacklash(1.0)).certificate.complete
