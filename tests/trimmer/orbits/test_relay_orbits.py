"""Which elements have a half-period equation, its level, and the orbits that its zeros are."""

from __future__ import annotations

import math

import control
import numpy as np
import pytest
import scipy.linalg

from tests.trimmer.orbits.test_half_period import loop_with_unequal_switches
from trimmer import ClosedLoop, CoulombFriction, FrictionBacklash, Relay, Saturation, ViscousFriction
from trimmer.motion.relay_component import PLUS
from trimmer.motion.threshold_component import POSITIVE
from trimmer.orbits.half_period import interval_of
from trimmer.orbits.relay_orbits import _equation, _orbit, _plus, relay_orbits

PLANT = control.tf([1.0], [1.0, 3.0, 2.0, 0.0])
GAIN, RATE, LEVEL, HALF_WIDTH = 4.0, 0.7, 1.5, 0.9
FIRST_ORDER = control.ss([[-RATE]], [[GAIN]], [[0.5]], [[0.0]])
SWITCHING = ClosedLoop(FIRST_ORDER, Relay(LEVEL, HALF_WIDTH))
"""x' = -0.7 x + 4 u, of which half is the output."""
STATE = HALF_WIDTH / 0.5
"""Of the linear system where the relay switches."""
REST = GAIN * LEVEL / RATE
HALF = math.log((REST + STATE) / (REST - STATE)) / RATE


@pytest.mark.parametrize(
    ("element", "modes"),
    [
        (Relay(1.0), (PLUS,)),
        (Relay(1.0, 0.3), (POSITIVE,)),
        (CoulombFriction(1.0), (PLUS,)),
        (ViscousFriction(2.0) + Relay(1.0), (0, PLUS)),
        (CoulombFriction(1.0) + 3.0 * ViscousFriction(2.0), (PLUS, 0)),
        (Relay(1.0) + Relay(2.0), None),
        (Relay(1.0) + Relay(2.0, 0.3), None),
        (Relay(1.0, 0.3, 1.7), None),
        (Relay(1.0) + Saturation(1.0, 1.0), None),
        (FrictionBacklash(1.0), None),
        (ViscousFriction(1.0), None),
    ],
)
def test_one_relay_beside_what_is_linear_has_an_equation(element, modes: tuple[int, ...] | None) -> None:
    loop = ClosedLoop(PLANT, element)
    number = _plus(loop)
    assert (None if number is None else loop.modes.component_modes(number)) == modes
    assert (_equation(loop) is None) == (modes is None)
    assert (relay_orbits(loop, (1.0, 1.5)) is None) == (modes is None)


def test_the_equation_has_the_flow_of_the_positive_output_and_the_level_of_its_rise() -> None:
    equation = _equation(SWITCHING)
    np.testing.assert_allclose(equation.matrix, [[-RATE, GAIN * LEVEL], [0.0, 0.0]])
    # The input of the relay, less half of x, rises to its half width where the output becomes positive.
    np.testing.assert_allclose(equation.row, [-0.5])
    assert equation.level == pytest.approx(HALF_WIDTH)
    assert _equation(ClosedLoop(PLANT, Relay(1.0))).level == 0.0


def test_hysteresis_around_a_first_order_lag_has_one_orbit() -> None:
    with np.errstate(invalid="raise"):
        (orbit,), search = relay_orbits(SWITCHING, None)
    assert orbit.period == pytest.approx(2 * HALF, rel=1e-11)
    assert orbit.amplitude == pytest.approx(HALF_WIDTH, rel=1e-11)
    assert orbit.prediction is None
    assert orbit.residual < 1e-12
    assert search.half_periods == interval_of(_equation(SWITCHING))
    assert (search.zeros, search.undecided, search.grid) == (1, (), 0)
    # The motion begins in the middle of the positive output.
    middle = REST - (REST + STATE) * math.exp(-RATE * HALF / 2)
    assert orbit.motion.log.state[0].tolist() == [pytest.approx(middle, rel=1e-11), 0.0, 0.0, 1.0]
    assert orbit.switching_times == pytest.approx([HALF / 2, 3 * HALF / 2], rel=1e-11)
    nothing, search = relay_orbits(SWITCHING, (1.1 * HALF, 3 * HALF))
    assert (nothing, search.half_periods, search.zeros) == ([], (1.1 * HALF, 3 * HALF), 0)


def test_without_hysteresis_unequal_switches_are_looked_for_too() -> None:
    loop = ClosedLoop(PLANT, Relay(1.0))
    (orbit,), search = relay_orbits(loop, (0.5, 5.0))
    assert (search.half_periods, search.zeros, search.undecided, search.grid) == ((0.5, 5.0), 1, (), 48)
    half = orbit.period / 2
    assert half / 4 - math.tanh(half / 2) + math.tanh(half) / 4 == pytest.approx(0.0, abs=1e-10)


def test_a_state_that_does_not_return_is_no_orbit() -> None:
    start = np.array([-STATE])
    symmetric = _orbit(SWITCHING, HALF, None, start)
    assert symmetric.period == pytest.approx(2 * HALF, rel=1e-11)
    # As an orbit with two durations it is found to be symmetric.
    both = _orbit(SWITCHING, HALF, HALF, start)
    assert both.period == pytest.approx(2 * HALF, rel=1e-11)
    np.testing.assert_allclose(both.multipliers, symmetric.multipliers, atol=1e-9)
    assert _orbit(SWITCHING, 1.01 * HALF, None, start) is None
    assert _orbit(SWITCHING, HALF, 1.01 * HALF, start) is None
    near = _orbit(SWITCHING, (1 + 1e-4) * HALF, None, start)
    assert near.period == pytest.approx(2 * HALF, rel=1e-10)


def test_an_orbit_of_unequal_durations_has_both_as_its_period() -> None:
    """Of a plant whose row is chosen so that the relay switches after 2.3 and 1.1 s."""
    loop = ClosedLoop(loop_with_unequal_switches(0, 2.3, 1.1), Relay(1.0))
    orbits, search = relay_orbits(loop, None)
    (orbit,) = (each for each in orbits if abs(each.period - 3.4) < 1e-6)
    assert search.grid == 48
    flow = scipy.linalg.expm(loop.modes.mode(_plus(loop)).matrix * 2.3 / 2)
    begin = orbit.motion.log.state[0]
    assert orbit.switching_times[0] == pytest.approx(2.3 / 2, rel=1e-8)
    at_switch = (flow @ begin)[: loop.model.nstates]
    assert float(loop.model.C[0] @ at_switch) == pytest.approx(0.0, abs=1e-8)
