"""The textbook loops: closed forms, counts of turns, and an exact simulation as the judge."""

import control
import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

from report.numbers.textbook_loops import (
    STARTS,
    backlash_history,
    backlash_loop,
    encirclements_of,
    graphical_intersections,
    growing_poles,
    relay_loop,
)
from trimmer.linear import encirclements, response_at


def test_the_relay_loop_has_the_limit_cycle_of_its_closed_form():
    """Gelb and Vander Velde's example: Im G = 0 at omega² = 2, where G = -1/6 and A = 4/(6 π)."""
    (cycle,) = relay_loop().limit_cycles()
    assert cycle.omega == pytest.approx(np.sqrt(2), rel=1e-12)
    assert cycle.amplitude == pytest.approx(2 / (3 * np.pi), rel=1e-12)
    assert cycle.stable


@pytest.mark.parametrize("point", [-3.0, -1.0, -0.5, 2.0])
@pytest.mark.parametrize("gain", [3.0, 7.0, 20.0])
def test_turns_are_those_that_roots_count(gain, point):
    plant = control.tf([gain], [1, 3, 3, 1])
    assert encirclements_of(plant, point) == encirclements(plant, point)


@given(ratio=st.floats(0.51, 200))
def test_an_encircled_operating_point_has_a_growing_pole(ratio):
    """The argument principle, for a complex N and a plant without unstable poles."""
    loop = backlash_loop()
    point = complex(loop.inverse_element(ratio))
    nearest = np.abs(response_at(loop.plant, np.geomspace(0.01, 100, 4000)) - point).min()
    if nearest > 1e-3 * abs(point):
        assert encirclements_of(loop.plant, point) == growing_poles(loop, ratio)


def test_drawn_curves_intersect_where_the_equations_are_solved():
    loop = backlash_loop()
    drawn = graphical_intersections(loop, np.geomspace(0.5, 3, 900), np.geomspace(0.55, 20, 900))
    solved = [(cycle.omega, cycle.amplitude) for cycle in loop.limit_cycles()]
    np.testing.assert_allclose(drawn, solved, rtol=2e-4)


def test_time_steps_agree_with_the_simulation_from_event_to_event():
    """The same starts in ``trimmer.simulate``, which is exact at its events."""
    from trimmer import ClosedLoop, simulate

    loop, history = backlash_loop(), backlash_history()
    first = loop.limit_cycles()[0]
    space = control.ss(loop.plant)
    drive = -1 / complex(response_at(loop.plant, first.omega))
    oscillation = np.linalg.solve(1j * first.omega * np.eye(3) - space.A, space.B * drive).real[:, 0]
    window = history.times[1] - history.times[0]
    for ratio, stepped in zip(STARTS, history.amplitudes.T, strict=True):
        start = ratio * first.amplitude
        motion = simulate(
            ClosedLoop(space, loop.element),
            window * len(stepped),
            initial_state=start * oscillation,
            element_output=start - 0.5,
        )
        instants = np.linspace(0, motion.duration, 200 * len(stepped), endpoint=False)
        exact = np.ptp(motion.element_input(instants).reshape(len(stepped), -1), axis=1) / 2
        np.testing.assert_allclose(stepped, exact, rtol=5e-3, atol=5e-3)
