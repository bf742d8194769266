"""The winding number: equal to the sum of indices, and different when a solution is missing."""

from dataclasses import replace

from hypothesis import given, settings
from hypothesis import strategies as st

from tests.trimmer.balance.loops import FRICTION, THESIS_LOOP, THIRD_ORDER
from tests.trimmer.trimmers import stable_systems
from trimmer import CoulombFriction, FrictionBacklash, InertiaBacklash, ViscousBacklash, harmonic_balance
from trimmer.balance.loop import loop_equation
from trimmer.balance.winding_number import winding_number
from trimmer.elements import Element, Relay, ViscousFriction

ELEMENTS = (
    FrictionBacklash(1.0),
    InertiaBacklash(1.0),
    ViscousBacklash(1.0, 0.0),
    ViscousBacklash(1.0, 0.7),
    Relay(1.0),
    CoulombFriction(1.0) + ViscousFriction(0.1),
    FrictionBacklash(1.0) + CoulombFriction(0.3) + ViscousFriction(0.1),
)


@given(stable_systems(), st.sampled_from(ELEMENTS))
@settings(max_examples=40)
def test_it_is_the_sum_of_the_indices(G, element: Element) -> None:
    balance = harmonic_balance(G, element)
    if balance.certificate.complete:
        assert balance.confirmed


def test_a_missing_limit_cycle_is_noticed() -> None:
    balance = harmonic_balance(THESIS_LOOP, FRICTION)
    for left in balance.limit_cycles:
        assert replace(balance, limit_cycles=(left,)).confirmed is False
        assert not replace(balance, limit_cycles=(left,)).success
    assert balance.success
    assert "no other is in the range" in balance.message


def test_it_counts_what_is_in_the_range_only() -> None:
    loop = loop_equation(THESIS_LOOP, FRICTION)
    unstable, stable = harmonic_balance(THESIS_LOOP, FRICTION).limit_cycles
    between = (unstable.omega * stable.omega) ** 0.5
    assert winding_number(loop, (1e3, between)) == -1
    assert winding_number(loop, (between, 1e4)) == 1
    assert winding_number(loop, (1e3, 1e4)) == 0
    assert winding_number(loop, (100.0, 1e3)) == 0


def test_it_is_none_where_a_solution_lies_on_the_border() -> None:
    (cycle,) = harmonic_balance(THIRD_ORDER, Relay(1.0)).limit_cycles
    assert winding_number(loop_equation(THIRD_ORDER, Relay(1.0)), (cycle.omega, 10.0)) is None
