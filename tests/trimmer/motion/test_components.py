"""Switched components one by one: laws, event functions, transitions and starts, written out by hand."""

from __future__ import annotations

import math
import sys

import numpy as np
import pytest

from trimmer.elements.backlashes.friction_backlash import FrictionBacklash
from trimmer.elements.backlashes.inertia_backlash import InertiaBacklash
from trimmer.elements.backlashes.viscous_backlash import ViscousBacklash
from trimmer.elements.coulomb_friction import CoulombFriction
from trimmer.elements.dead_zone import DeadZone
from trimmer.elements.preload import Preload
from trimmer.elements.relay import Relay
from trimmer.elements.saturation import Saturation
from trimmer.elements.viscous_friction import ViscousFriction
from trimmer.motion.backlash_component import FREE, LOWER, RESTING, SETTLED, UPPER, BacklashComponent
from trimmer.motion.components_of_elements import RigidComponent, ViscousComponent, components_of
from trimmer.motion.corner_component import ABOVE, BELOW, BETWEEN, CornerComponent
from trimmer.motion.implicit_outputs import least_outputs, without_rounding
from trimmer.motion.relay_component import RelayComponent
from trimmer.motion.switched_component import EventKind, Explicit, RateProportional, Signals
from trimmer.motion.threshold_component import NEGATIVE, POSITIVE, SILENT, ThresholdComponent

GAP, TAU = 4e-5, 0.02
UNIT = np.eye(8)
SIGNALS = Signals(UNIT[0], UNIT[1], UNIT[2], UNIT[3], (UNIT[4], UNIT[5], UNIT[6]), UNIT[7])
"""Input, its rate and curvature, output, three states and one are entries of the state."""


def row(**entries: float) -> list[float]:
    names = ("input", "rate", "curvature", "output", "z0", "z1", "z2", "one")
    return [entries.get(name, 0.0) for name in names]


def told(function) -> list[tuple[EventKind, int, list[list[float]], tuple[int, ...]]]:
    return [
        (each.kind, each.target, [reset.tolist() for reset in each.resets], each.zeros)
        for each in (function.reached, function.jumped)
    ]


@pytest.mark.parametrize(("tau", "states", "even"), [(0.0, 1, 0), (math.inf, 2, 0), (TAU, 3, 1), (3.0, 3, 1)])
def test_states_of_a_load_behind_a_gap(tau: float, states: int, even: int) -> None:
    backlash = BacklashComponent(GAP, tau)
    assert (backlash.state_count, backlash.even_states, backlash.slows_down) == (states, even, bool(even))
    rates = np.zeros((states, states))
    if states > 1:
        rates[0, 1] = 1.0
    if states > 2:
        rates[1, 1] = rates[2, 2] = -1 / tau
    assert backlash.state_rates(FREE).tolist() == rates.tolist()
    assert not backlash.state_rates(UPPER).any()
    assert backlash.output_law(FREE) == Explicit(0.0, (1.0,) + (0.0,) * (states - 1), 0.0)
    assert backlash.output_law(RESTING) == backlash.output_law(FREE)
    assert backlash.output_law(UPPER) == Explicit(1.0, (0.0,) * states, -GAP / 2)
    assert backlash.output_law(LOWER) == Explicit(1.0, (0.0,) * states, GAP / 2)
    assert [backlash.mirrored(each) for each in (FREE, UPPER, LOWER, RESTING)] == [
        FREE,
        LOWER,
        UPPER,
        RESTING,
    ]


@pytest.mark.parametrize(
    ("tau", "force"),
    [
        (0.0, row(rate=1.0)),
        (TAU, row(rate=1.0, curvature=TAU)),
        (1.0, row(rate=1.0, curvature=1.0)),
        (4.0, row(rate=0.25, curvature=1.0)),
        (math.inf, row(curvature=1.0)),
    ],
)
def test_a_contact_ends_where_the_pin_would_have_to_pull(tau: float, force: list[float]) -> None:
    backlash = BacklashComponent(GAP, tau)
    assert backlash.switching_function(SIGNALS).tolist() == force
    resets = [row(output=1.0), row(rate=1.0), row(one=1.0)][: backlash.state_count]
    reached, jumped = (3, 2) if tau else (2, 1)
    for mode, side in ((UPPER, 1.0), (LOWER, -1.0)):
        (function,) = backlash.event_functions(mode, SIGNALS, True)
        assert function.row.tolist() == (side * np.array(force)).tolist()
        assert told(function) == [
            (EventKind.SEPARATION, FREE, resets, (zeros, 0) if mode == UPPER else (0, zeros))
            for zeros in (reached, jumped)
        ]


@pytest.mark.parametrize("tau", [0.0, TAU, math.inf])
def test_a_load_in_the_gap_meets_the_pin_or_comes_to_rest(tau: float) -> None:
    backlash = BacklashComponent(GAP, tau)
    stop = [row(z0=1.0), row(), row()] if tau == TAU else []
    for mode in (FREE, RESTING):
        upper, lower, *rest = backlash.event_functions(mode, SIGNALS, False)
        assert upper.row.tolist() == row(input=-1.0, output=1.0, one=GAP / 2)
        assert lower.row.tolist() == row(input=1.0, output=-1.0, one=GAP / 2)
        assert told(upper) == [(EventKind.IMPACT, UPPER, stop, (0,))] * 2
        assert told(lower) == [(EventKind.IMPACT, LOWER, stop, (0,))] * 2
        assert upper.continuous == lower.continuous == 1
        assert len(rest) == (tau == TAU and mode == FREE)
        for function in rest:
            assert function.row.tolist() == row(z2=1.0, one=-SETTLED)
            resets = [row(z0=1.0, z1=TAU), row(), row()]
            assert told(function) == [(EventKind.REST, RESTING, resets, (0, 0))] * 2


@pytest.mark.parametrize("tau", [0.0, TAU, math.inf])
def test_where_a_load_starts(tau: float) -> None:
    backlash = BacklashComponent(GAP, tau)

    def start(given: float, output: float) -> tuple[int, float]:
        mode, states = backlash.initial(given, 0.0, output)
        assert len(states) == backlash.state_count
        assert not states[1:].any()
        return mode, states[0]

    inside = RESTING if tau == TAU else FREE
    assert start(0.0, 1e-5) == (inside, 1e-5)
    assert start(GAP / 2, 0.0) == (inside, 0.0)
    assert start(-GAP / 2, 0.0) == (inside, 0.0)
    assert start(3e-5, 0.0) == (UPPER, pytest.approx(1e-5))
    assert start(-3e-5, 0.0) == (LOWER, pytest.approx(-1e-5))


def test_corners() -> None:
    saturation, dead_zone = CornerComponent(0.3, 7.0, 0.0), CornerComponent(0.3, 0.0, 7.0)
    assert (saturation.name, dead_zone.name) == ("saturation", "dead zone")
    assert saturation.output_law(BETWEEN) == Explicit(7.0, (), 0.0)
    assert saturation.output_law(ABOVE) == Explicit(0.0, (), pytest.approx(2.1))
    assert saturation.output_law(BELOW) == Explicit(0.0, (), pytest.approx(-2.1))
    assert dead_zone.output_law(ABOVE) == Explicit(7.0, (), pytest.approx(-2.1))
    assert [saturation.mirrored(each) for each in (BETWEEN, ABOVE, BELOW)] == [BETWEEN, BELOW, ABOVE]
    upper, lower = saturation.event_functions(BETWEEN, SIGNALS, False)
    assert (upper.row.tolist(), lower.row.tolist()) == (row(input=-1.0, one=0.3), row(input=1.0, one=0.3))
    assert told(upper) == [(EventKind.CORNER, ABOVE, [], (1,)), (EventKind.CORNER, ABOVE, [], (0,))]
    assert told(lower) == [(EventKind.CORNER, BELOW, [], (1,)), (EventKind.CORNER, BELOW, [], (0,))]
    for mode, side, known in ((ABOVE, 1.0, (1, 0)), (BELOW, -1.0, (0, 1))):
        (back,) = saturation.event_functions(mode, SIGNALS, False)
        assert back.row.tolist() == row(input=side, one=-0.3)
        assert told(back) == [(EventKind.CORNER, BETWEEN, [], known), (EventKind.CORNER, BETWEEN, [], (0, 0))]
        assert back.continuous == 1
    starts = {0.3: BETWEEN, -0.3: BETWEEN, 0.31: ABOVE, -0.31: BELOW}
    assert {value: saturation.initial(value, 0.0, 0.0)[0] for value in starts} == starts


def test_thresholds_with_dead_zone_and_hysteresis() -> None:
    relay = ThresholdComponent(2.0, 0.3, 0.1)
    assert (relay.slides, relay.has_dead_zone, relay.output_jumps) == (False, True, True)
    assert [relay.output_law(each).constant for each in (SILENT, POSITIVE, NEGATIVE)] == [0.0, 2.0, -2.0]
    assert [relay.mirrored(each) for each in (SILENT, POSITIVE, NEGATIVE)] == [SILENT, NEGATIVE, POSITIVE]
    up, down = relay.event_functions(SILENT, SIGNALS, False)
    assert (up.row.tolist(), down.row.tolist()) == (row(input=-1.0, one=0.3), row(input=1.0, one=0.3))
    assert [told(each)[0][1] for each in (up, down)] == [POSITIVE, NEGATIVE]
    for mode, side in ((POSITIVE, 1.0), (NEGATIVE, -1.0)):
        (off,) = relay.event_functions(mode, SIGNALS, False)
        assert off.row.tolist() == row(input=side, one=-0.1)
        assert told(off) == [(EventKind.SWITCH, SILENT, [], (0, 0))] * 2
        assert off.continuous == 1


def test_thresholds_without_hysteresis_know_the_way_back() -> None:
    relay = ThresholdComponent(2.0, 0.3, 0.3)
    assert relay.slides
    for each in relay.event_functions(SILENT, SIGNALS, False):
        assert [zeros for *_, zeros in told(each)] == [(1,), (0,)]
    for mode, known in ((POSITIVE, (1, 0)), (NEGATIVE, (0, 1))):
        (off,) = relay.event_functions(mode, SIGNALS, False)
        assert [zeros for *_, zeros in told(off)] == [known, (0, 0)]


def test_thresholds_without_dead_zone_change_sign_at_once() -> None:
    relay = ThresholdComponent(2.0, 0.3, -0.3)
    assert not relay.has_dead_zone
    (off,), (on,) = (relay.event_functions(mode, SIGNALS, False) for mode in (POSITIVE, NEGATIVE))
    assert (off.row.tolist(), told(off)[0][1]) == (row(input=1.0, one=0.3), NEGATIVE)
    assert (on.row.tolist(), told(on)[0][1]) == (row(input=-1.0, one=0.3), POSITIVE)


@pytest.mark.parametrize(
    ("off", "given", "switching", "output", "mode"),
    [
        (0.1, 0.2, 0.2, 0.0, SILENT),
        (0.1, 0.2, 0.2, 1.0, POSITIVE),
        (0.1, 0.2, 0.2, -1.0, SILENT),
        (0.1, -0.2, -0.2, -1.0, NEGATIVE),
        (0.1, 0.1, 0.1, 1.0, SILENT),
        (0.1, 0.3, 0.3, 0.0, POSITIVE),
        (0.1, -0.3, -0.3, 0.0, NEGATIVE),
        (0.3, 0.3, 0.3, 0.0, POSITIVE),
        (0.3, -0.3, -0.3, 0.0, NEGATIVE),
        (-0.3, 0.0, 0.0, 0.0, POSITIVE),
        (-0.3, 0.0, -1.0, 0.0, NEGATIVE),
        (-0.3, 0.0, 1.0, -1.0, NEGATIVE),
        (-0.3, 0.4, 0.4, -1.0, POSITIVE),
        (-0.3, -0.4, -0.4, 1.0, NEGATIVE),
    ],
)
def test_what_a_relay_starts_with(
    off: float, given: float, switching: float, output: float, mode: int
) -> None:
    assert ThresholdComponent(2.0, 0.3, off).initial(given, switching, output)[0] == mode


def test_components_of_elements() -> None:
    assert components_of(FrictionBacklash(GAP)) == [(BacklashComponent(GAP, 0.0), 1.0)]
    assert components_of(InertiaBacklash(GAP)) == [(BacklashComponent(GAP, math.inf), 1.0)]
    assert components_of(ViscousBacklash(GAP, TAU)) == [(BacklashComponent(GAP, TAU), 1.0)]
    tiny = 0.5 / sys.float_info.max
    assert components_of(ViscousBacklash(GAP, tiny)) == [(BacklashComponent(GAP, 0.0), 1.0)]
    assert components_of(Saturation(0.3, 7.0)) == [(CornerComponent(0.3, 7.0, 0.0), 1.0)]
    assert components_of(DeadZone(0.3, 7.0)) == [(CornerComponent(0.3, 0.0, 7.0), 1.0)]
    assert components_of(CoulombFriction(0.5)) == [(RelayComponent(0.5, True), 1.0)]
    assert components_of(ViscousFriction(0.4)) == [(ViscousComponent(0.4), 1.0)]
    assert components_of(Relay(2.0)) == [(RelayComponent(2.0, False), 1.0)]
    preload = Preload(2.0, 3.0)
    assert components_of(preload) == [
        (RigidComponent(), preload.slope),
        (RelayComponent(preload.level, False), 1.0),
    ]
    together = 3.0 * (2.0 * CoulombFriction(0.5) + ViscousFriction(0.4))
    factors = [factor for _, factor in components_of(together)]
    assert factors == [6.0, 3.0]
    assert RigidComponent().output_law(0) == Explicit(1.0, (), 0.0)
    assert ViscousComponent(0.4).output_law(0) == RateProportional(0.4)
    assert ViscousComponent(0.4).output_jumps
    rigid = RigidComponent()
    assert (rigid.state_count, rigid.output_jumps, rigid.continuous_rates, rigid.even_states) == (
        0,
        False,
        0,
        0,
    )
    assert (rigid.mirrored(3), rigid.mode_names) == (3, ("always",))
    assert rigid.event_functions(0, SIGNALS, False) == ()
    assert rigid.switching_function(SIGNALS) is SIGNALS.input
    assert rigid.initial(1.0, 1.0, 1.0)[0] == 0


def test_outputs_that_follow_from_conditions() -> None:
    left, right = np.array([[2.0, 1.0], [0.0, 4e-5]]), np.array([[3.0, 5.0], [8e-5, -4e-5]])
    np.testing.assert_allclose(least_outputs(left, right, "a"), [[0.5, 3.0], [2.0, -1.0]], rtol=1e-13)
    # Where two conditions are the same, both outputs are as small as can be.
    twice = np.array([[1.0, 1.0], [2.0, 2.0]])
    found = least_outputs(twice, np.array([[3.0], [6.0]]), "a")
    np.testing.assert_allclose(found, [[1.5], [1.5]], rtol=1e-13)
    # What is rounding of large terms is zero.
    small = np.array([[1e-17, 1.0]])
    assert least_outputs(np.eye(1), small, "a", np.ones((1, 2))).tolist() == [[0.0, 1.0]]
    assert least_outputs(np.eye(1), small, "a").tolist() == small.tolist()
    assert without_rounding(np.array([-1e-17, -1.0, 0.0]), np.ones(3)).tolist() == [0.0, -1.0, 0.0]
