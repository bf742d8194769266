from __future__ import annotations

import math

import control
import mpmath
import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from tests.trimmer.balance.loops import (
    FRICTION,
    GAP,
    LOOP_WITH_BOTH_CHANNELS,
    THESIS_LOOP,
    THIRD_ORDER,
    s,
    solutions_on_grid,
)
from tests.trimmer.trimmers import exact_response
from trimmer import CoulombFriction, FrictionBacklash, InertiaBacklash, Relay, ViscousBacklash
from trimmer.balance import harmonic_balance, limit_cycles


@pytest.mark.parametrize("guess", [(1.897, 3478.0), (0.1203, 4609.0)])
def test_limit_cycles_of_the_thesis_loop_to_eleven_digits(guess) -> None:
    """Against 40 digits: friction-controlled backlash in closed form, G from the balance of forces."""
    with mpmath.workdps(40):

        def balance(u, omega):
            c = 1 - u
            real = (mpmath.pi / 2 + mpmath.asin(c) + c * mpmath.sqrt(1 - c**2)) / mpmath.pi
            excess = 1 + mpmath.mpc(real, -u * (2 - u) / mpmath.pi) * exact_response(omega)
            return excess.real, excess.imag

        u, omega = mpmath.findroot(balance, guess, tol=1e-25)
        found = min(limit_cycles(THESIS_LOOP, FRICTION), key=lambda cycle: abs(cycle.omega - guess[1]))
        assert abs(found.omega / omega - 1) < 1e-11
        assert abs(found.amplitude * u / mpmath.mpf(GAP) - 1) < 1e-11


@pytest.mark.parametrize("G", [THESIS_LOOP, LOOP_WITH_BOTH_CHANNELS])
def test_the_trimmer_has_one_unstable_and_one_stable_limit_cycle_and_no_other(G) -> None:
    balance = harmonic_balance(G, FRICTION)
    assert [cycle.stable for cycle in balance.limit_cycles] == [False, True]
    assert all(cycle.residual < 1e-12 and not cycle.near_tangency for cycle in balance.limit_cycles)
    assert balance.certificate.complete
    assert balance.certificate.outside_excluded


@pytest.mark.parametrize(
    ("G", "omega", "amplitude"),
    [
        # By hand: K/(s(s+1)(s+2)) is -K/6 at sqrt(2), so A = 4 M K/(6 pi).
        (THIRD_ORDER, math.sqrt(2), 4 / (6 * math.pi)),
        # K/(s+1)^3 crosses the axis at sqrt(3) with -K/8.
        (10 / (s + 1) ** 3, math.sqrt(3), 4 * 10 / (8 * math.pi)),
    ],
)
def test_relay_with_a_third_order_plant(G, omega: float, amplitude: float) -> None:
    (cycle,) = limit_cycles(G, Relay(2.0))
    assert cycle.omega == pytest.approx(omega, rel=1e-12)
    assert cycle.amplitude == pytest.approx(2 * amplitude, rel=1e-12)
    assert cycle.stable


def test_coulomb_friction_is_where_j_g_is_negative() -> None:
    # N = 4j F/(pi A). With G = s/(s+1)^4, jG = -omega/(1 + j omega)^4 is negative at no omega > 0.
    assert limit_cycles(s / (s + 1) ** 4, CoulombFriction(1.0)) == ()
    # With G = -1/(s+1)^2, jG = -j/(1 + j omega)^2 is -1/2 at omega = 1.
    (cycle,) = limit_cycles(-1 / (s + 1) ** 2, CoulombFriction(1.0))
    assert cycle.omega == pytest.approx(1.0, rel=1e-12)
    assert cycle.amplitude == pytest.approx(4 / (2 * math.pi), rel=1e-12)


def test_python_control_finds_the_same_as_far_as_its_grid_allows() -> None:
    peer = control.friction_backlash_nonlinearity(GAP)
    response = control.describing_function_response(
        THESIS_LOOP, peer, np.geomspace(0.51 * GAP, 50 * GAP, 200), np.geomspace(1e3, 1e4, 500), refine=False
    )
    found = limit_cycles(THESIS_LOOP, FRICTION)
    assert len(response.intersections) == len(found)
    for cycle, (amplitude, omega) in zip(
        found, sorted(response.intersections, key=lambda p: p[1]), strict=True
    ):
        assert cycle.omega == pytest.approx(omega, rel=1e-2)
        assert cycle.amplitude == pytest.approx(amplitude, rel=1e-2)


@given(st.floats(-9, 9).map(lambda exponent: 10**exponent))
@settings(max_examples=10)
def test_amplitude_scales_with_the_gap_and_frequency_stays(gap: float) -> None:
    found = limit_cycles(THESIS_LOOP, FrictionBacklash(gap))
    reference = limit_cycles(THESIS_LOOP, FRICTION)
    assert [cycle.omega for cycle in found] == pytest.approx([cycle.omega for cycle in reference], rel=1e-12)
    scaled = [cycle.amplitude * gap / GAP for cycle in reference]
    assert [cycle.amplitude for cycle in found] == pytest.approx(scaled, rel=1e-12)


def test_frozen_omega_is_where_both_agree_only_at_its_own_frequency() -> None:
    element = ViscousBacklash(GAP, 1e-3)
    own = limit_cycles(THESIS_LOOP, element)[-1]
    frozen = limit_cycles(THESIS_LOOP, element, frozen_omega=own.omega)
    nearest = min(frozen, key=lambda cycle: abs(cycle.omega - own.omega))
    assert nearest.omega == pytest.approx(own.omega, rel=1e-11)
    elsewhere = limit_cycles(THESIS_LOOP, element, frozen_omega=0.3 * own.omega)
    assert all(abs(cycle.omega / own.omega - 1) > 1e-5 for cycle in elsewhere)


def test_one_stable_branch_runs_from_friction_to_inertia() -> None:
    time_constants = (0.0, *np.geomspace(1e-6, 1e-1, 16), math.inf)
    balances = [harmonic_balance(THESIS_LOOP, ViscousBacklash(GAP, each)) for each in time_constants]
    assert all(balance.certificate.complete for balance in balances)
    stable = [[cycle for cycle in balance.limit_cycles if cycle.stable] for balance in balances]
    assert {len(found) for found in stable} == {1}
    omegas = np.array([found[0].omega for found in stable])
    assert np.all(np.diff(omegas) > 0)
    assert omegas[0] == pytest.approx(limit_cycles(THESIS_LOOP, FRICTION)[-1].omega, rel=1e-12)
    assert omegas[-1] == pytest.approx(limit_cycles(THESIS_LOOP, InertiaBacklash(GAP))[-1].omega, rel=1e-12)


def test_the_unstable_branch_of_friction_ends_at_the_edge_of_the_domain() -> None:
    """Followed over M/D it comes ever nearer to the smallest amplitude that the backlash allows."""
    margins = []
    for time_constant in (1e-6, 3e-5, 5e-5, 7e-5, 8e-5):
        element = ViscousBacklash(GAP, time_constant)
        first = limit_cycles(THESIS_LOOP, element)[0]
        margins.append(first.amplitude * float(element.domain(first.omega)) / GAP - 1)
    assert np.all(np.diff(margins) < 0)
    assert 0 < margins[-1] < 0.02
    (only,) = limit_cycles(THESIS_LOOP, ViscousBacklash(GAP, 1e-4))
    assert only.stable


def test_a_range_hides_what_is_outside() -> None:
    (cycle,) = limit_cycles(THESIS_LOOP, FRICTION, omega_range=(4000, 6000))
    assert cycle.stable
    assert not harmonic_balance(THESIS_LOOP, FRICTION, (4000, 6000)).certificate.outside_excluded


def test_no_intersection_is_an_empty_list() -> None:
    assert limit_cycles(1 / (s + 1), FrictionBacklash(1.0)) == ()
    assert limit_cycles(1 / (s + 1) ** 2, Relay(1.0)) == ()


def test_an_unstable_plant_is_accepted() -> None:
    # Denominator s^3 + 5 s^2 + 3 s - 9: real at omega^2 = 3, where G = -5/24. By Routh's criterion the linear
    # loop is stable for 9/5 < N < 24/5, and N falls with amplitude, so the limit cycle at N = 24/5 is stable.
    (cycle,) = limit_cycles(5 / ((s - 1) * (s + 3) ** 2), Relay(1.0))
    assert cycle.omega == pytest.approx(math.sqrt(3), rel=1e-12)
    assert cycle.amplitude == pytest.approx(4 * 5 / (24 * math.pi), rel=1e-12)
    assert cycle.stable


@pytest.mark.parametrize("element", [FrictionBacklash(1.0), InertiaBacklash(1.0), ViscousBacklash(1.0, 2.0)])
@pytest.mark.parametrize("sign", [-1, 1])
def test_no_range_is_needed_where_the_gain_does_not_fall(element, sign: int) -> None:
    """|G| tends to 2 and stays above 1/max|N|, which excludes nothing by size."""
    G = sign * control.tf([2, 1.5], [1, 1])
    balance = harmonic_balance(G, element)
    assert balance.certificate.complete and balance.certificate.outside_excluded
    count, _ = solutions_on_grid(G, element, (1e-4, 1e4))
    assert len(balance.limit_cycles) == count
