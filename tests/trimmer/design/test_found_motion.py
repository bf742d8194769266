"""What is kept of a motion, of one that repeats and of one that does not."""

import math
from dataclasses import replace
from types import SimpleNamespace
from typing import Any

import numpy as np
import pytest

from tests.trimmer.design.made import oscillator, oscillator_amplitude
from trimmer import Mechanism, MotionKind, forced_orbit
from trimmer.contact.flow import MechanismFlow
from trimmer.design import HandArm, Measure, hand_arm_weighting
from trimmer.design.analysis.found_motion import of_orbit, of_settled
from trimmer.design.analysis.hand_arm import hand_arm_of_orbit, hand_arm_of_samples
from trimmer.examples import example_text
from trimmer.hybrid.stretch import Ending
from trimmer.mechanism import Body, Force, Friction, Link, Output


def test_a_motion_that_does_not_repeat_is_measured_over_a_window() -> None:
    # One that does repeat, taken for one that does not, so that all measures are known.
    orbit = forced_orbit(oscillator())
    settled: Any = SimpleNamespace(
        kind=MotionKind.CHAOTIC,
        orbit=None,
        rest=None,
        window=SimpleNamespace(flow=orbit.flow, end=orbit.instant),
        starts=3,
        mirrored=True,
        drive_periods=77,
        neighbour_agrees=True,
        lyapunov=0.25,
    )
    found = of_settled(settled)
    assert found is not None
    assert (found.kind, found.period_count, found.period) == (MotionKind.CHAOTIC, None, None)
    assert (found.starts, found.mirrored, found.drive_periods) == (3, True, 77)
    assert (found.neighbour_agrees, found.lyapunov) == (True, 0.25)
    assert (found.measured_periods, found.events, found.neutral) == (96, 0.0, False)
    assert found.multipliers.shape == (0,)
    assert np.array_equal(found.state, orbit.instant.state)
    # Six of the 96 periods are shown.
    assert found.signals.times[[0, -1]] == pytest.approx([0.0, 6 / 20.0])
    assert found.outputs["block"].peak_to_peak == pytest.approx(2 * oscillator_amplitude(), rel=1e-9)
    assert found.outputs["block"].harmonics[0] == pytest.approx(oscillator_amplitude(), rel=1e-9)
    assert found.outputs["block"].period_count == 1
    felt = found.hand_arm["block"]
    assert (felt.lines, felt.highest) == (0, pytest.approx(128 * 20.0))
    assert math.isnan(felt.left_out)
    assert felt.weighted == pytest.approx(felt.rms * abs(hand_arm_weighting(20.0)), rel=1e-3)


def test_what_breaks_off_is_not_measured() -> None:
    nothing: Any = SimpleNamespace(orbit=None, rest=None, window=None)
    assert of_settled(nothing) is None
    ended = SimpleNamespace(ending=Ending.DIVERGED)
    flow = SimpleNamespace(period=1.0, course=lambda begin, periods: ended)
    broken: Any = SimpleNamespace(orbit=None, rest=None, window=SimpleNamespace(flow=flow, end=None))
    assert of_settled(broken) is None


def test_each_friction_has_the_times_at_which_it_sticks() -> None:
    usual = Mechanism.from_toml_text(example_text("thesis-play"))
    brake = {**usual.frictions, "brake": Friction(("ground", "housing"), 80.0)}
    found = of_orbit(forced_orbit(replace(usual, frictions=brake)))
    assert found.period is not None
    assert found.signals.sticking["brake"] == ((0.0, pytest.approx(found.period)),)
    sticking = sum(length for _, length in found.signals.sticking["blade"])
    assert sticking == pytest.approx(found.frictions["blade"].stick * found.period, abs=1e-12)
    assert found.frictions["brake"].stick == pytest.approx(1.0)
    assert found.measure(Measure.WEAR_POWER, "blade") == found.frictions["blade"].power > 0.0
    touching = sum(length for _, length in found.signals.touching["bridge"])
    assert touching == pytest.approx(found.contacts["bridge"].share * found.period, rel=1e-9)


def shaken() -> Mechanism:
    """Two bodies without springs, pushed by forces, so that their accelerations are known."""
    return Mechanism.from_toml_text("""
        frequency = 20.0
        [bodies]
        one = { mass = 0.5 }
        two = { mass = 2.0 }
        three = { mass = 1.0 }
        [links]
        slow = { between = ["ground", "one"], damping = 1e-9, stiffness = 1e-6 }
        slack = { between = ["ground", "two"], damping = 1e-9, stiffness = 1e-6 }
        still = { between = ["ground", "three"], damping = 1.0, stiffness = 1.0 }
        [forces]
        first = { on = "one", amplitude = 3.0 }
        third = { on = "one", amplitude = 4.0, order = 3 }
        other = { on = "two", amplitude = 6.0, order = 2, constant = 5.0 }
    """)


def orbit_of_shaken() -> Any:
    # From the velocities at which the displacements repeat: -F/(m w) cos at t = 0.
    flow = MechanismFlow(shaken())
    omega = 40 * np.pi
    start = {"one": (0.0, -26.0 / (3 * omega)), "two": (0.0, -1.5 / omega), "three": (0.0, 0.0)}
    return flow.course(flow.rest(start), 1)


def test_lines_are_weighted_one_by_one() -> None:
    omega = 40 * np.pi
    rms = {"one": math.sqrt((36 + 64) / 2), "two": math.sqrt(4.5), "three": 0.0}
    no_constant = orbit_of_shaken()
    found = hand_arm_of_orbit(no_constant, omega, rms)
    weights = {order: abs(hand_arm_weighting(20.0 * order)) for order in (1, 2, 3)}
    expected = math.sqrt((36 * weights[1] ** 2 + 64 * weights[3] ** 2) / 2)
    assert found["one"].weighted == pytest.approx(expected, rel=1e-6)
    assert found["one"].rms == rms["one"]
    assert (found["one"].lines, found["one"].highest) == (150, pytest.approx(3000.0))
    assert found["one"].left_out < 1e-4 * expected
    assert found["three"] == HandArm(0.0, 0.0, 0.0, found["one"].highest, 150)
    # What of a body's acceleration no line holds is taken for vibration just above the highest line.
    more = hand_arm_of_orbit(no_constant, omega, rms | {"one": 3e4})["one"]
    above = abs(hand_arm_weighting(3000.0)) * math.sqrt(3e4**2 - 50.0)
    assert more.left_out == pytest.approx(math.hypot(more.weighted, above) - more.weighted, rel=1e-4)
    assert found["three"].hours_to(2.5) == math.inf
    assert found["one"].hours_to(5.0) == pytest.approx(8 * 25 / expected**2, rel=1e-6)


def test_samples_are_weighted_without_their_mean() -> None:
    flow = MechanismFlow(shaken())
    made = flow.course(flow.rest(), 20)
    rms = {"one": 2.0, "two": 3.0, "three": 4.0}
    found = hand_arm_of_samples(made, rms, 64 * 20.0)
    first, second, third = abs(hand_arm_weighting([20.0, 40.0, 60.0]))
    assert found["one"].weighted == pytest.approx(math.hypot(6.0 * first, 8.0 * third) / 2**0.5, rel=1e-3)
    # The constant force is no vibration.
    assert found["two"].weighted == pytest.approx(3.0 * second / 2**0.5, rel=1e-3)
    assert (found["three"].weighted, found["three"].rms) == (0.0, 4.0)
    assert (found["one"].highest, found["one"].lines) == (640.0, 0)


def test_what_goes_backwards_is_told_beside_what_stays() -> None:
    machine = Mechanism(
        frequency=20.0,
        bodies={"sled": Body(1.0), "block": Body(0.5)},
        links={"oil": Link(("ground", "sled"), 0.0, 4.0), "spring": Link(("ground", "block"), 3e4, 2.0)},
        forces={"pull": Force("sled", constant=-2.0), "shake": Force("block", amplitude=1.0)},
        outputs={name: Output({name: 1}) for name in ("sled", "block")},
    )
    advances = of_orbit(forced_orbit(machine)).advances
    assert dict(advances) == {"sled": pytest.approx(-2.0 / 4.0 / 20.0)}


def test_impulses_of_a_wall_are_felt() -> None:
    """A ball that meets a table once a period gets g/f there: each line of its acceleration is 2 g."""
    orbit = forced_orbit(Mechanism.from_toml_text(example_text("bouncing-ball")))
    ball, gravity, frequency = of_orbit(orbit).hand_arm["ball"], 9.81, 1 / orbit.period
    weights = abs(hand_arm_weighting(frequency * np.arange(1, 40_000)))
    felt = gravity * np.sqrt(2.0 * np.cumsum(weights**2))
    assert ball.rms == pytest.approx(gravity, rel=1e-9)
    assert ball.amplitude == pytest.approx(np.full(ball.lines, 2 * gravity), rel=1e-6)
    assert ball.weighted == pytest.approx(felt[ball.lines - 1], rel=1e-9)
    assert felt[-1] - felt[ball.lines - 1] < ball.left_out < 2e-4 * felt[-1]
    shaken_more = hand_arm_of_orbit(orbit.course, 2 * np.pi * frequency, {"ball": 2 * gravity})["ball"]
    assert shaken_more.left_out > ball.left_out
    course = orbit.flow.course(orbit.instant, 20)
    before = np.sort(course.segment_ends[:-1, 1])[:20]  # each impact
    assert before == pytest.approx(np.full(20, -gravity / (2 * frequency)), rel=1e-9)
    more = hand_arm_of_samples(course, {"ball": gravity}, 256 * frequency)
    assert more["ball"].weighted == pytest.approx(felt[-1], rel=np.pi / 256)  # It meets it between samples.
