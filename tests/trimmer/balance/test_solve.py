import math

import control
import numpy as np
import pytest

from tests.trimmer.balance.loops import FRICTION, GAP, LOOP_WITH_BOTH_CHANNELS, THESIS_LOOP, THIRD_ORDER, s
from trimmer import CoulombFriction, FrictionBacklash, InertiaBacklash, Relay, ViscousBacklash
from trimmer.balance import harmonic_balance, limit_cycles
from trimmer.elements import Element, ViscousFriction

BY_HAND = [
    # 1/(s(s+1)(s+2)) is -1/6 at sqrt(2), 1/(s+1)^3 is -1/8 at sqrt(3), and A = 4 M |G|/pi.
    (THIRD_ORDER, Relay(2.0), math.sqrt(2), 8 / (6 * math.pi), True),
    (10 / (s + 1) ** 3, Relay(2.0), math.sqrt(3), 80 / (8 * math.pi), True),
    # s^3 + 5 s^2 + 3 s - 9: real at omega^2 = 3, where G = -5/24. By Routh's criterion the linear loop is
    # stable for 9/5 < N < 24/5, and N falls with amplitude, so the limit cycle at N = 24/5 is stable.
    (5 / ((s - 1) * (s + 3) ** 2), Relay(1.0), math.sqrt(3), 20 / (24 * math.pi), True),
    # G is -1/16 at sqrt(3) rad/s, beyond its poles at +-j.
    (-1 / ((s**2 + 1) * (s + 1) ** 3), Relay(1.0), math.sqrt(3), 1 / (4 * math.pi), False),
    # N = 4j F/(pi A), and jG = -j/(1 + j omega)^2 is -1/2 at omega = 1; damping of 0.4 takes its part.
    (-1 / (s + 1) ** 2, CoulombFriction(1.0), 1.0, 2 / math.pi, True),
    (-1 / (s + 1) ** 2, ViscousFriction(0.4) + CoulombFriction(3.0), 1.0, 12 / (1.6 * math.pi), True),
    # s^3 + 3 s^2 + (2 + c) s + k has roots on the axis for k = 3 (2 + c), at omega^2 = 2 + c.
    *(
        (THIRD_ORDER, Relay(0.7) + ViscousFriction(c), math.sqrt(2 + c), 2.8 / (3 * math.pi * (2 + c)), True)
        for c in (1e-9, 0.3, 70.0)
    ),
]


@pytest.mark.parametrize(("G", "element", "omega", "amplitude", "stable"), BY_HAND)
def test_a_limit_cycle_by_hand(G, element: Element, omega: float, amplitude: float, stable: bool) -> None:
    balance = harmonic_balance(G, element)
    (cycle,) = balance.limit_cycles
    assert (cycle.omega, cycle.amplitude) == pytest.approx((omega, amplitude), rel=1e-12)
    assert (cycle.stable, balance.certificate.complete) == (stable, True)
    assert cycle.residual < 1e-12


@pytest.mark.parametrize(
    ("G", "element"),
    [
        (1 / (s + 1), FrictionBacklash(1.0)),
        (1 / (s + 1) ** 2, Relay(1.0)),
        # jG = -omega/(1 + j omega)^4 is negative at no omega > 0.
        (s / (s + 1) ** 4, CoulombFriction(1.0)),
        (-1 / (s + 1) ** 2, ViscousFriction(2.1) + CoulombFriction(3.0)),
    ],
)
def test_no_intersection_is_an_empty_list(G, element: Element) -> None:
    assert limit_cycles(G, element) == ()


@pytest.mark.parametrize("G", [THESIS_LOOP, LOOP_WITH_BOTH_CHANNELS])
def test_the_trimmer_has_one_unstable_and_one_stable_limit_cycle_and_no_other(G) -> None:
    balance = harmonic_balance(G, FRICTION)
    assert [cycle.stable for cycle in balance.limit_cycles] == [False, True]
    assert all(cycle.residual < 1e-12 and not cycle.near_tangency for cycle in balance.limit_cycles)
    assert balance.certificate.complete and balance.confirmed
    assert balance.certificate.outside_excluded


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


@pytest.mark.parametrize("element", [FrictionBacklash(1.0), InertiaBacklash(1.0), ViscousBacklash(1.0, 2.0)])
@pytest.mark.parametrize("sign", [-1, 1])
def test_no_range_is_needed_where_the_gain_does_not_fall(element, sign: int) -> None:
    """|G| tends to 2 and stays above 1/max|N|, which excludes nothing by size."""
    G = sign * control.tf([2, 1.5], [1, 1])
    balance = harmonic_balance(G, element)
    assert balance.certificate.complete and balance.certificate.outside_excluded
    assert balance.confirmed
