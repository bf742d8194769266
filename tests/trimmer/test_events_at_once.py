"""Events at one instant: multipliers of loops and derivatives along branches, asked from outside."""

from dataclasses import replace

import numpy as np
import pytest

from trimmer import Drive, forced_orbit, simulate
from trimmer.elements import CoulombFriction
from trimmer.thesis import BodyFriction, TrimmerLoop, TrimmerParameters

HALVES = TrimmerParameters(
    **{"m1": 1.0, "m2": 1.0, "m3": 1.0, "m4": 1.0},
    **{"k1": 0.0, "k2": 4.0, "k3": 3.0, "k4": 5.0, "k5": 0.0},
    **{"c1": 0.0, "c2": 0.4, "c3": 0.7, "c4": 0.9},
)
"""Motor and cutter are mirror images: between them is the bridge alone, with the drive in it."""


def loop(omega: float, **limits: float) -> TrimmerLoop:
    laws = {name.replace("_", "-"): CoulombFriction(limit) for name, limit in limits.items()}
    frictions = tuple(BodyFriction(name, law) for name, law in laws.items())
    return TrimmerLoop(HALVES, None, Drive(1.0, omega=omega), frictions=frictions)


def differences(of: TrimmerLoop, period: float, state: np.ndarray, step: float) -> np.ndarray:
    """Return the derivative of the state after a period by that before it, by differences to one side."""
    ends = [
        simulate(of, period, initial_state=each).state(period)
        for each in (state, *(state + step * np.eye(len(state))))
    ]
    return (np.array(ends[1:]) - ends[0]).T / step


def hold_against_differences(of: TrimmerLoop) -> None:
    orbit = forced_orbit(of)
    state = orbit.motion.state(0.0)
    forwards, backwards = (differences(of, orbit.period, state, step) for step in (1e-7, -1e-7))
    np.testing.assert_allclose(forwards, backwards, atol=1e-5)
    expected = np.poly(0.5 * (forwards + backwards))
    np.testing.assert_allclose(np.poly(orbit.multipliers), expected, atol=1e-6)
    assert not orbit.one_sided


@pytest.mark.parametrize(
    ("omega", "limit"),
    [
        pytest.param(2.0, 0.5, id="both turn round"),
        pytest.param(3.0, 0.5, id="faster"),
        pytest.param(1.0, 0.2, id="slower"),
        pytest.param(3.0, 2.0, id="both stick and slip"),
    ],
)
def test_two_frictions_that_switch_at_once_have_the_multipliers_of_differences(omega, limit) -> None:
    hold_against_differences(loop(omega, q1=limit, q2=limit))


def test_a_machine_without_springs_to_the_ground_is_left_where_the_drive_took_it() -> None:
    """It could stand anywhere; with the drive's stroke of 1 it is never far from rest."""
    for omega in (2.0, 3.0, 4.0, 5.0):
        orbit = forced_orbit(loop(omega, q1=0.5, q2=0.5))
        assert abs(orbit.motion.state(0.0)).max() < 3.0


def test_of_three_frictions_a_neighbour_meets_that_between_both_bodies_between_the_others() -> None:
    three = loop(1.535376374837822, q1=0.27648545, q2=0.27648545, q1_q2=1.09358154)
    halves = loop(1.535376374837822, q1=0.13824272, q2=0.13824272).frictions
    hold_against_differences(replace(three, frictions=three.frictions + halves))


def test_three_frictions_at_once_make_multipliers_one_sided_and_it_is_said() -> None:
    three = loop(2.0, q1=0.3, q2=0.3, q1_q2=0.2)
    orbit = forced_orbit(three)
    state = orbit.motion.state(0.0)
    forwards, backwards = (differences(three, orbit.period, state, step) for step in (1e-7, -1e-7))
    assert abs(forwards - backwards).max() > 1e-3
    assert orbit.one_sided
    assert "one side only" in orbit.message
    alone = forced_orbit(loop(2.0, q1=0.3, q2=0.4))
    assert not alone.one_sided
    assert "one side" not in alone.message
