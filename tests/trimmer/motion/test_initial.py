"""Where a motion starts: states, modes that fit them, and what decides where a switching function is zero."""

from __future__ import annotations

import math

import control
import numpy as np
import pytest

from tests.trimmer.motion.hand_made_loop import GAP, one_body, ring_of_bodies
from trimmer import ClosedLoop, FrictionBacklash, TrimmerLoop, TrimmerParameters
from trimmer.motion.backlash_component import FREE, LOWER, RESTING, UPPER, BacklashComponent
from trimmer.motion.initial import initial_segment, segment_from
from trimmer.motion.mode_tables import ModeTables
from trimmer.motion.relay_component import HELD, MINUS, PLUS, RelayComponent

DRIVEN = 3e-4 * math.sin(0.3)


def started(
    modes: ModeTables, x: float, v: float, output: float = 0.0
) -> tuple[tuple[int, ...], list[float]]:
    number, state = segment_from(modes, np.array([x, v]), output)
    return modes.component_modes(number), state.tolist()


def test_plant_load_and_drive() -> None:
    modes = ModeTables(one_body())
    found, state = started(modes, DRIVEN, 0.25, 1e-5)
    assert found == (RESTING, PLUS)
    assert state == [DRIVEN, 0.25, 1e-5, 0.0, 0.0, math.sin(0.3), math.cos(0.3), 1.0]
    # The pin is at the drive less x.
    found, state = started(modes, 0.0, -0.25)
    assert found == (UPPER, MINUS)
    assert state[2] == pytest.approx(DRIVEN - GAP / 2, rel=1e-13)
    found, state = started(modes, 2 * DRIVEN, 0.0)
    assert found == (LOWER, HELD)
    assert state[2] == pytest.approx(GAP / 2 - DRIVEN, rel=1e-13)


@pytest.mark.parametrize(
    ("x", "v"),
    [(0.1, -9.0), (-0.1, 9.0), (0.0, 9.0), (0.0, -9.0), (1e-16, -0.1), (-1e-16, 0.1), (0.0, 0.0)],
)
def test_a_relay_at_zero_starts_by_the_rate_of_its_input(x: float, v: float) -> None:
    def expected(value: float) -> int:
        return PLUS if value > 0 else MINUS if value < 0 else HELD

    system = one_body(BacklashComponent(GAP, 0.0), RelayComponent(0.7, False))
    assert started(ModeTables(system), x, v)[0][1] == expected(x or v)
    # On the rate of x + v / 100 its output acts at once.
    system.C[1] = 1.0, 0.01
    assert started(ModeTables(system), x, v)[0][1] == expected(x + 0.01 * v)


@pytest.mark.parametrize("side", [1.0, -1.0])
def test_rounding_has_no_sign(side: float) -> None:
    system = one_body(second=RelayComponent(0.7, False))
    system.C[1], system.B[:, 1] = (side, side), (-2.0 * side, 0.0)
    system.A[0] = 0.0, 3.0
    # The input is zero but for its last digit; its rate is what the output acts on, so that it is held.
    v = -0.3
    for x in (0.3, np.nextafter(0.3, 1.0), np.nextafter(0.3, 0.0)):
        assert started(ModeTables(system), x, v)[0][1] == HELD
    assert started(ModeTables(system), 0.3 + side * 1e-13, v)[0][1] == PLUS
    assert started(ModeTables(system), 0.3 - side * 1e-13, v)[0][1] == MINUS


@pytest.mark.parametrize("side", [1.0, -1.0])
def test_a_component_sees_the_outputs_of_those_before_it(side: float) -> None:
    # The input of the relay is y' with y'' = 5 u - x, where u is the load in contact with the pin at -x.
    system = one_body(BacklashComponent(0.5, 0.0), RelayComponent(0.7, False))
    system.A[1], system.C[1] = (-1.0, 0.0), (0.0, 1.0)
    system.B[1, 1] = 0.0
    modes, there = ModeTables(system), MINUS if side > 0 else PLUS
    # At rest at x = 1 in contact the rate is 5 (-1 + 0.25) - 1 on either side, in the gap -x alone.
    assert started(modes, side, 0.0)[0] == (LOWER if side > 0 else UPPER, there)
    # A load that stays at 0.2 beside x = 0.1 drives the other way.
    assert started(modes, 0.1 * side, 0.0, 0.1 * side)[0] == (FREE, PLUS if side > 0 else MINUS)


def test_relays_that_follow_from_held_ones_are_held() -> None:
    modes = ModeTables(ring_of_bodies())
    number, _ = segment_from(modes, np.array([0.0, 0, 0, 0.4, 0.4, 0.4]), 0.0)
    assert modes.component_modes(number) == (FREE, HELD, HELD, HELD, PLUS)
    number, _ = segment_from(modes, np.array([0.0, 0, 0, 0.4, 0.4, -0.5]), 0.0)
    assert modes.component_modes(number) == (FREE, HELD, PLUS, PLUS, MINUS)


def test_states_and_an_impulse_add() -> None:
    system = control.ss([[0.0, 1.0], [-4.0, -1.0]], [[0.5], [2.0]], [[1.0, 0.0]], 0)
    loop = ClosedLoop(system, FrictionBacklash(9.0))
    with pytest.raises(ValueError, match="initial_state must be finite"):
        initial_segment(loop, loop.modes, [0.1, math.inf], 0.0, 0.0)
    given = np.array([0.1, -0.2])
    number, state = initial_segment(loop, loop.modes, given, 0.3, 0.25)
    assert state[:3].tolist() == pytest.approx([0.1 + 0.15, -0.2 + 0.6, 0.25], rel=1e-14)
    assert given.tolist() == [0.1, -0.2]
    assert initial_segment(loop, loop.modes, None, 0.0, 0.0)[1].tolist() == [0.0, 0.0, 0.0, 0.0, 0.0, 1.0]
    assert loop.modes.component_modes(number) == (FREE,)
    trimmer = TrimmerLoop(TrimmerParameters.thesis(), FrictionBacklash(4e-5))
    state = initial_segment(trimmer, trimmer.modes, None, 1e-6, 0.0)[1]
    assert state[:8] == pytest.approx(1e-6 * trimmer.model.B[:, 0], rel=1e-14)
