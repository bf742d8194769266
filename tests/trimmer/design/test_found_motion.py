"""What is kept of a motion, of one that repeats and of one that does not."""

from __future__ import annotations

import math
from dataclasses import replace
from types import SimpleNamespace
from typing import Any

import numpy as np
import pytest

from tests.trimmer.design.made import (
    contact,
    friction,
    motion,
    oscillator,
    oscillator_amplitude,
    output,
)
from trimmer import Mechanism, MotionKind, forced_orbit, respond
from trimmer.contact.advance import Ending
from trimmer.contact.flow import ExactFlow
from trimmer.design import found_motion
from trimmer.design import hand_arm as module
from trimmer.design.found_motion import _spans, of_orbit, of_settled
from trimmer.design.hand_arm import HandArm, hand_arm_of_orbit, hand_arm_of_samples, hand_arm_weighting
from trimmer.design.targets import Measure, Target
from trimmer.examples import example_text
from trimmer.mechanism import Friction


def test_each_measure_is_that_of_its_part() -> None:
    found = motion(
        outputs={"a": output(-1.0, 1.0), "b": output(-1.0, 2.0)},
        rms_acceleration={"a": 1.0, "b": 4.0},
        contacts={"a": contact(5.0), "b": contact(6.0)},
        frictions={"a": friction(7.0), "b": friction(8.0)},
        period_count=3,
    )
    wanted = {
        Measure.STROKE: 3.0,
        Measure.RMS_ACCELERATION: 4.0,
        Measure.IMPACT_SPEED: 6.0,
        Measure.WEAR_POWER: 8.0,
        Measure.PERIOD: 3.0,
    }
    for measure, value in wanted.items():
        assert found.measure(measure, "b") == value
        assert found.value(Target("key", measure, "b", 1.0)) == value
    assert found.measure(Measure.IMPACT_SPEED, "none") == 0.0
    assert found.measure(Measure.WEAR_POWER, "none") == 0.0
    assert found.impact_speed == 6.0
    assert motion(contacts={}).impact_speed == 0.0
    assert motion(period_count=None).measure(Measure.PERIOD, "") == math.inf
    assert found.meets((Target("k", Measure.STROKE, "b", 3.0),))
    assert not found.meets((Target("k", Measure.STROKE, "b", 3.0), Target("k", Measure.PERIOD, "", 1.0)))
    assert found.repeats
    assert not motion(kind=MotionKind.TORUS).repeats


def course(starts: list[float], duration: float) -> Any:
    return SimpleNamespace(log=SimpleNamespace(start=np.array(starts)), duration=duration)


def test_times_that_touch_are_one() -> None:
    made = course([0.0, 1.0, 2.5, 2.5, 3.0, 4.0, 6.0], 7.0)
    on = np.array([True, True, True, False, True, False, True])
    # The third and fourth row have no length or are off: 2.5 to 3 is a pause.
    assert _spans(made, on, 7.0) == ((0.0, 2.5), (3.0, 1.0), (6.0, 1.0))
    assert _spans(made, ~on, 7.0) == ((2.5, 0.5), (4.0, 2.0))
    assert _spans(made, on, 3.5) == ((0.0, 2.5), (3.0, 0.5))
    assert _spans(made, on, 3.0) == ((0.0, 2.5),)
    assert _spans(made, np.zeros(7, bool), 7.0) == ()
    assert _spans(made, np.ones(7, bool), 7.0) == ((0.0, 7.0),)
    later = np.array([True, False, True, True, True, True, False])
    assert _spans(course([0.0, 1.0, 2.0, 3.0, 4.0, 5.0, 6.0], 7.0), later, 7.0) == ((0.0, 1.0), (2.0, 4.0))
    three = np.array([False, True, True, False, False, False, True])
    assert _spans(made, three, 7.0) == ((1.0, 1.5), (6.0, 1.0))


def test_an_orbit_alone_has_no_starts() -> None:
    orbit = forced_orbit(oscillator())
    found = of_orbit(orbit)
    assert (found.kind, found.period_count, found.period) == (MotionKind.PERIODIC, 1, pytest.approx(0.05))
    assert (found.starts, found.drive_periods, found.mirrored) == (0, 0, False)
    assert (found.neighbour_agrees, found.lyapunov, found.neutral) == (None, None, False)
    assert found.outputs["double"].peak_to_peak == pytest.approx(4 * oscillator_amplitude(), rel=1e-9)
    acceleration = (2 * np.pi * 20) ** 2 * oscillator_amplitude() / math.sqrt(2)
    assert found.rms_acceleration["block"] == pytest.approx(acceleration, rel=1e-9)
    assert abs(found.multipliers) == pytest.approx([math.exp(-4.0 * 0.05)] * 2, rel=1e-6)
    assert (found.measured_periods, found.events) == (1, 0.0)
    assert found.signals.times[[0, -1]] == pytest.approx([0.0, 0.05])
    assert np.array_equal(found.state, orbit.instant.state)


def test_a_settled_orbit_tells_what_led_to_it() -> None:
    settled = respond(oscillator(), starts=2).motion
    found = of_settled(settled)
    assert found is not None
    assert (found.starts, found.drive_periods) == (2, settled.drive_periods)
    assert found.drive_periods > 0
    assert (found.neighbour_agrees, found.mirrored) == (settled.neighbour_agrees, settled.mirrored)
    assert settled.lyapunov is not None
    assert found.lyapunov is not None
    assert found.lyapunov.value == settled.lyapunov.value == pytest.approx(-4.0 * 0.05, rel=1e-6)


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


def test_what_moves_by_itself_is_measured_over_one_period(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(found_motion, "_made", lambda *given: given)
    for periods, measured in ((0, 1), (1, 1), (3, 3)):
        orbit: Any = SimpleNamespace(flow="flow", course="course", periods=periods)
        assert of_orbit(orbit) == ("flow", "course", None, orbit, measured)


def test_what_a_hand_feels_has_the_frequency_of_the_motion(monkeypatch: pytest.MonkeyPatch) -> None:
    for name in ("hand_arm_of_orbit", "hand_arm_of_samples"):
        monkeypatch.setattr(found_motion, name, lambda *given: given)
    made, rms = course([0.0], 0.25), {"a": 2.0}
    assert found_motion._hand_arm(made, "orbit", rms, 3) == (made, pytest.approx(8 * np.pi), rms)
    assert found_motion._hand_arm(made, None, rms, 3) == (made, rms, 256 * 12.0)


def test_what_breaks_off_is_not_measured() -> None:
    nothing: Any = SimpleNamespace(orbit=None, rest=None, window=None)
    assert of_settled(nothing) is None
    flow = SimpleNamespace(course=lambda begin, periods: SimpleNamespace(ending=Ending.DIVERGED))
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
    flow = ExactFlow(shaken())
    omega = 40 * np.pi
    start = {
        "one": (0.0, -(6.0 / omega + 8.0 / (3 * omega))),
        "two": (0.0, -3.0 / (2 * omega)),
        "three": (0.0, 0.0),
    }
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
    assert found["three"].hours_to(2.5) == math.inf
    assert found["one"].hours_to(5.0) == pytest.approx(8 * 25 / expected**2, rel=1e-6)


def test_what_lies_above_the_highest_line_is_bounded(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(module, "HIGHEST", 25.0)
    found = hand_arm_of_orbit(orbit_of_shaken(), 40 * np.pi, {"one": math.sqrt(50), "two": 3.0, "three": 0.0})
    weighted = 6 * abs(hand_arm_weighting(20.0)) / math.sqrt(2)
    assert (found["one"].lines, found["one"].highest) == (2, pytest.approx(40.0))
    assert found["one"].weighted == pytest.approx(weighted, rel=1e-6)
    # The third harmonic is left out; from 40 Hz on the weighting falls.
    beyond = abs(hand_arm_weighting(40.0)) ** 2 * 32
    assert found["one"].left_out == pytest.approx(math.sqrt(weighted**2 + beyond) - weighted, rel=1e-5)


def test_the_largest_weighting_beyond_a_frequency() -> None:
    dense = abs(hand_arm_weighting(np.linspace(1.0, 100.0, 100_001)))
    assert module._largest_beyond(2.0) == pytest.approx(dense.max(), rel=1e-4)
    assert module._largest_beyond(30.0) == pytest.approx(abs(hand_arm_weighting(30.0)), rel=1e-12)
    assert module._largest_beyond(500.0) == pytest.approx(abs(hand_arm_weighting(500.0)), rel=1e-12)


def test_samples_are_weighted_without_their_mean() -> None:
    flow = ExactFlow(shaken())
    begin = flow.rest()
    made = flow.course(begin, 20)
    rms = {"one": 2.0, "two": 3.0, "three": 4.0}
    found = hand_arm_of_samples(made, rms, 64 * 20.0)
    assert found["one"].weighted == pytest.approx(
        2.0
        * math.sqrt(0.36 * abs(hand_arm_weighting(20.0)) ** 2 + 0.64 * abs(hand_arm_weighting(60.0)) ** 2),
        rel=1e-3,
    )
    # The constant force is no vibration.
    assert found["two"].weighted == pytest.approx(3.0 * abs(hand_arm_weighting(40.0)), rel=1e-3)
    assert (found["three"].weighted, found["three"].rms) == (0.0, 4.0)
    assert (found["one"].highest, found["one"].lines) == (640.0, 0)
