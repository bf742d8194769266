"""Which harmonics are balanced for a start, and what is made of them, with a solver that is given."""

from __future__ import annotations

import math
from types import SimpleNamespace

import control
import numpy as np
import pytest

from trimmer import (
    ClosedLoop,
    CoulombFriction,
    FrictionBacklash,
    Relay,
    Saturation,
    ViscousBacklash,
    ViscousFriction,
)
from trimmer.errors import OrbitNotFoundError, UnsupportedMotionError
from trimmer.motion.backlash_component import FREE
from trimmer.motion.components_of_elements import components_of
from trimmer.motion.corner_component import ABOVE, BELOW, BETWEEN
from trimmer.motion.relay_component import MINUS, PLUS
from trimmer.motion.threshold_component import NEGATIVE, POSITIVE, SILENT
from trimmer.orbits import balanced_start
from trimmer.orbits.balanced_start import _highest, _on, _quiet_phases, _start, balanced_starts
from trimmer.orbits.multi_harmonic_balance import BalancedHarmonics
from trimmer.orbits.steady_response import flight_of, steady_response
from trimmer.orbits.trigonometric import OddPolynomial

PLANT = control.ss([[0.0, 1.0], [-40.0, -1.2]], [[0.3], [2.0]], [[1.0, 0.1]], [[0.0]])
LOOP = ClosedLoop(PLANT, ViscousBacklash(1.2, 0.1))


def solved(order: int, harmonics: list, omega: float = 7.0) -> BalancedHarmonics:
    return BalancedHarmonics(order, 3.3, omega, np.array(harmonics, dtype=complex), 0.0)


def give(monkeypatch: pytest.MonkeyPatch, found: list) -> list:
    """Let the solver give solutions until one fails; return what it is asked for."""
    asked: list = []

    def solutions(*arguments):
        asked.append(arguments)
        for each in found:
            if each is None:
                raise OrbitNotFoundError("none")
            yield each

    monkeypatch.setattr(balanced_start, "solutions", solutions)
    return asked


def test_the_last_solution_counts_if_it_has_more_than_one_harmonic(monkeypatch: pytest.MonkeyPatch) -> None:
    one, three, five = solved(1, [3.0]), solved(3, [3.0, 0.2]), solved(5, [3.0, 0.2, 0.1j])
    asked = give(monkeypatch, [one, three, five, None])
    assert _highest(LOOP, 2.5, 8.0) is five
    ((system, element, guess, orders),) = asked
    assert (system, element, guess) == (LOOP.system, LOOP.element, (2.5, 8.0))
    assert list(orders) == [1, 3, 5, 7, 9, 11, 13, 15]
    give(monkeypatch, [one, three])
    assert _highest(LOOP, 2.5, 8.0) is three
    for found in ([one, None], [None], [one], []):
        give(monkeypatch, found)
        assert _highest(LOOP, 2.5, 8.0) is None
        assert list(balanced_starts(LOOP, 2.5, 8.0)) == []


def test_starts_are_on_the_balanced_motion(monkeypatch: pytest.MonkeyPatch) -> None:
    give(monkeypatch, [solved(3, [3.0, 0.2 - 0.1j])])
    starts = list(balanced_starts(LOOP, 2.5, 8.0))
    # The output of the element has harmonics up to the 63rd, whatever its input has.
    given = OddPolynomial(np.array([3.0, 0.2 - 0.1j, *[0.0] * 30]))
    output = steady_response(LOOP.element, given, 7.0)
    assert [omega for _, omega in starts] == [7.0, 7.0]
    middles = _quiet_phases(LOOP, given, 7.0)
    for (start, _), phase in zip(starts, middles, strict=True):
        expected = _start(LOOP, given, output, 7.0, phase)
        assert start.mode == expected.mode
        np.testing.assert_allclose(start.state, expected.state, rtol=1e-12)
        np.testing.assert_allclose(start.sizes, expected.sizes, rtol=1e-12)


def test_without_a_steady_output_there_is_no_start(monkeypatch: pytest.MonkeyPatch) -> None:
    give(monkeypatch, [solved(3, [0.1, 0.2])])  # The input stays within the gap.
    assert list(balanced_starts(LOOP, 2.5, 8.0)) == []


def test_states_of_several_components_have_their_own_places() -> None:
    element = FrictionBacklash(0.8) + 2.0 * ViscousBacklash(1.2, 0.1) + 0.5 * Relay(1.0)
    loop = ClosedLoop(control.ss(control.tf([1.0], [1.0, 2.0, 5.0, 1.0])), element)
    given = OddPolynomial(np.array([3.0, 0.2j]))
    start = _start(loop, given, steady_response(element, given, 7.0), 7.0, 2.3)
    components, layout = loop.modes.system.components, loop.modes.layout
    modes = []
    for first, component in zip(layout.first_states, components, strict=True):
        mode, states = _on(component, given, 7.0, 2.3)
        modes.append(mode)
        assert len(states) == component.state_count
        assert start.state[first : first + component.state_count].tolist() == states.tolist()
    assert loop.modes.component_modes(start.mode) == tuple(modes)
    held, flying = layout.first_states[:2]
    largest = given.largest()
    assert start.sizes[held] == largest
    assert start.sizes[flying : flying + 3].tolist() == [largest, 7.0 * largest, 1.0]


def test_the_share_of_velocity_that_is_left_follows_from_the_time_constant() -> None:
    (component,) = LOOP.modes.system.components
    given = OddPolynomial(np.array([3.0 + 0j]))
    flight = flight_of(component, given, 7.0)
    mode, (place, velocity, share) = _on(component, given, 7.0, flight.leave + 0.2)
    assert mode == FREE
    assert share == pytest.approx(math.exp(-0.2 / 0.7), rel=1e-12)
    assert place == pytest.approx(float(flight.position(np.array(flight.leave + 0.2))), rel=1e-12)
    assert velocity == pytest.approx(7.0 * float(given(flight.leave, 1)) * share, rel=1e-7)


def test_an_element_without_motion_has_no_steady_response(monkeypatch: pytest.MonkeyPatch) -> None:

    monkeypatch.setattr(
        "trimmer.orbits.steady_response.components_of", lambda element: [(SimpleNamespace(), 1.0)]
    )
    with pytest.raises(UnsupportedMotionError, match="has no steady response to a periodic input"):
        steady_response(Relay(1.0), OddPolynomial(np.array([1.0 + 0j])), 1.0)


def test_a_relay_is_positive_where_its_input_or_the_rate_of_that_is() -> None:
    given = OddPolynomial(np.array([2.0, 0.0]))
    for element, modes in ((Relay(1.0), [PLUS, PLUS, MINUS]), (CoulombFriction(1.0), [PLUS, MINUS, PLUS])):
        ((component, _),) = components_of(element)
        found = [_on(component, given, 7.0, phase) for phase in (0.2, 3.0, 6.0)]
        assert [mode for mode, _ in found] == modes
        assert all(states.size == 0 for _, states in found)
    ((relay, _),) = components_of(Relay(1.0))
    assert _on(relay, given, 7.0, 0.0)[0] == MINUS


@pytest.mark.parametrize(
    ("element", "modes"),
    [
        (Saturation(1.0, 3.0), [BETWEEN, ABOVE, BELOW]),
        (Relay(1.0, 0.3, 0.9), [SILENT, POSITIVE, NEGATIVE]),
        (ViscousFriction(2.0), [0, 0, 0]),
    ],
)
def test_what_has_no_states_of_its_own_has_a_mode_alone(element, modes: list[int]) -> None:
    ((component, _),) = components_of(element)
    given = OddPolynomial(np.array([2.0, 0.0]))
    found = [_on(component, given, 7.0, phase) for phase in (0.2, math.pi / 2, -math.pi / 2)]
    assert [mode for mode, _ in found] == modes
    assert all(states.size == 0 for _, states in found)
