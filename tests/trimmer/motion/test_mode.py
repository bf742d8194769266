"""The modes of interconnections made by hand: flows, signals, and what ends a hold of several."""

from __future__ import annotations

import numpy as np
import pytest

from tests.trimmer.motion.hand_made_loop import GAP, LEVEL, TAU, one_body, ring_of_bodies
from trimmer.motion.backlash_component import FREE, UPPER
from trimmer.motion.components_of_elements import ViscousComponent
from trimmer.motion.frictions.coupled_relays import CoupledRelays
from trimmer.motion.interconnection import Interconnection
from trimmer.motion.mode import SwitchedMode, assemble
from trimmer.motion.relay_component import HELD, MINUS, PLUS
from trimmer.motion.switched_component import EventKind

X, V, LOAD, SPEED, SHARE, SINE, COSINE, ONE = np.eye(8)
PIN = 3e-4 * SINE - X


def mode_of(system: Interconnection, *modes: int) -> SwitchedMode:
    return assemble(system, modes, CoupledRelays.of(system))


def rows_of(*rows: np.ndarray) -> list[object]:
    return [pytest.approx(row, rel=1e-13, abs=1e-18) for row in rows]


def test_the_flow_of_a_sliding_body_with_a_load_in_the_gap() -> None:
    mode = mode_of(one_body(), FREE, PLUS)
    force = -9.0 * X - 0.2 * V + 5.0 * LOAD - 2.0 * LEVEL * ONE
    drive = 691.0 * COSINE, -691.0 * SINE, 0.0 * ONE
    assert mode.matrix.tolist() == rows_of(V, force, SPEED, -SPEED / TAU, -SHARE / TAU, *drive)
    load, friction = mode.signals
    assert [load.input.tolist(), load.input_rate.tolist()] == rows_of(PIN, 0.2073 * COSINE - V)
    assert load.input_curvature == pytest.approx(-0.2073 * 691.0 * SINE - force, rel=1e-13)
    assert [load.output.tolist(), friction.output.tolist()] == rows_of(LOAD, LEVEL * ONE)
    assert [each.tolist() for each in load.states] == rows_of(LOAD, SPEED, SHARE)
    assert friction.states == ()
    assert [friction.input.tolist(), friction.input_rate.tolist()] == rows_of(X, V)
    assert friction.one.tolist() == load.one.tolist() == ONE.tolist()


def test_the_flow_in_contact_and_in_stick() -> None:
    mode = mode_of(one_body(), UPPER, MINUS)
    pushed = -9.0 * X - 0.2 * V + 5.0 * (PIN - GAP / 2 * ONE)
    assert mode.matrix[1] == pytest.approx(pushed + 2.0 * LEVEL * ONE, rel=1e-13)
    assert not mode.matrix[2:5].any()
    held = mode_of(one_body(), UPPER, HELD)
    assert held.matrix[0].tolist() == V.tolist()
    assert held.matrix[1].tolist() == [0.0] * 8
    assert held.signals[1].output == pytest.approx(0.5 * pushed, rel=1e-13, abs=1e-18)
    # The pin still moves by the drive, at rest otherwise.
    assert held.signals[0].input_rate == pytest.approx(0.2073 * COSINE - V, rel=1e-13)


def test_a_force_in_proportion_to_a_rate() -> None:
    mode = mode_of(one_body(second=ViscousComponent(0.4)), FREE, 0)
    assert mode.matrix[1] == pytest.approx(-9.0 * X - (0.2 + 0.8) * V + 5.0 * LOAD, rel=1e-13)
    assert mode.signals[1].output == pytest.approx(0.4 * V, rel=1e-13)
    assert mode.signals[0].output.tolist() == LOAD.tolist()


def test_where_an_output_works_on_nothing_sliding_reverses_at_once() -> None:
    system = one_body()
    (*_, friction) = mode_of(system, FREE, PLUS).event_functions
    assert (friction.owner, friction.reached[0].transition.kind) == (1, EventKind.STICK)
    for works in (0.0, 2.0):
        system.B[1, 1] = works
        (*_, friction) = mode_of(system, FREE, PLUS).event_functions
        assert friction.reached[0].transition.kind is EventKind.SWITCH


@pytest.mark.parametrize(
    ("row", "modes", "rests"),
    [
        ([1.0, -1.0, 0.0], (HELD, PLUS, PLUS, PLUS), True),
        ([-0.3, 0.3, 0.0], (HELD, PLUS, PLUS, PLUS), True),
        ([1.0, -2.0, 0.0], (HELD, PLUS, PLUS, PLUS), False),
        ([-1.0, 2.0, 0.0], (HELD, PLUS, PLUS, PLUS), False),
        ([0.0, 0.0, -0.3], (PLUS, PLUS, PLUS, HELD), True),
        ([0.2, -0.5, 0.3], (HELD, HELD, HELD, PLUS), True),
        ([0.2, -0.5, 0.4], (HELD, HELD, HELD, PLUS), False),
        ([0.2, -0.5, 0.4], (HELD, HELD, HELD, HELD), True),
        ([0.0, 0.0, 1.0], (PLUS, PLUS, PLUS, PLUS), False),
    ],
)
def test_a_pin_that_held_bodies_carry_is_at_rest(
    row: list[float], modes: tuple[int, ...], rests: bool
) -> None:
    system = ring_of_bodies()
    system.C[0, :3] = row
    pin = mode_of(system, FREE, *modes).signals[0]
    rates = [0.0] * 3 if rests else row
    assert pin.input_rate.tolist() == [0.0, 0.0, 0.0, *rates, 0.0, 0.0, 0.0, 0.0]
    assert pin.input.tolist() == [*row, *[0.0] * 7]
    assert rests <= (not pin.input_curvature.any())


def test_what_ends_the_hold_of_a_ring() -> None:
    mode = mode_of(ring_of_bodies(), FREE, HELD, HELD, HELD, PLUS)
    # The load pushes 0.5 kg with half its place; all three have one acceleration against 0.9 N.
    load = 3.0
    force = 0.5 * load
    acceleration = (force - 0.9) / 6.5
    state = np.array([0.1, 0.2, 0.3, 0.4, 0.4, 0.4, load, 0.6, 0.8, 1.0])
    np.testing.assert_allclose(mode.matrix @ state, [*[0.4] * 3, *[acceleration] * 3, 0, 0, 0, 0], atol=1e-14)
    first, second, third = force - 0.5 * acceleration, 2.0 * acceleration, 4.0 * acceleration + 0.9
    facets = [each for each in mode.event_functions if each.number == 3]
    assert [each.owner for each in facets] == [1] * 6
    assert [each.continuous for each in facets] == [0] * 6
    left = [0.8 - second, 0.8 + second, 1.0 - first, 1.0 + first, 1.2 - third, 1.2 + third]
    assert [each.row @ state for each in facets] == pytest.approx(left, rel=1e-12)
    expected = [{1: PLUS, 2: MINUS}, {1: PLUS, 3: PLUS}, {2: PLUS, 3: PLUS}]
    opposite = {PLUS: MINUS, MINUS: PLUS}
    for place, each in enumerate(facets):
        targets = {change.component: change.transition.target for change in each.reached}
        wanted = expected[place // 2]
        assert targets == (wanted if place % 2 == 0 else {k: opposite[v] for k, v in wanted.items()})
        assert {change.component: change.transition.target for change in each.jumped} == targets
        assert {change.transition.zeros for change in each.reached} == {(2,)}
        assert {change.transition.zeros for change in each.jumped} == {(1,)}
    # The others keep their own functions: both sides of the gap, and the friction on the ground.
    others = [(each.owner, each.number) for each in mode.event_functions if each.number < 3]
    assert others == [(0, 0), (0, 1), (4, 0)]


def test_what_is_just_at_its_limit_is_zero_there() -> None:
    # With 0.9 N on the last one and 0.9 N on the first one nothing is accelerated.
    system = ring_of_bodies()
    mode = mode_of(system, FREE, HELD, HELD, HELD, HELD)
    assert not mode.matrix[3:6].any()
    facets = [each for each in mode.event_functions if each.number == 3]
    for each in facets:
        assert set(np.flatnonzero(each.row)) <= {6, 9}
    (ground,) = [each for each in mode.event_functions if (each.owner, each.number) == (4, 0)]
    assert set(np.flatnonzero(ground.row)) == {6, 9}
    assert ground.row[[6, 9]] == pytest.approx([-0.5, 0.9], rel=1e-13)
