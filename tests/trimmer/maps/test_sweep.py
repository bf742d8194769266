"""Run-up and coast-down: closed forms, folds that are known, one motion that goes on, and refusals."""

import math
from dataclasses import replace

import control
import numpy as np
import pytest

from tests.trimmer.response.mechanisms import example
from trimmer import (
    Body,
    Drive,
    Feedback,
    MotionKind,
    Output,
    Saturation,
    Stop,
    TrimmerError,
    respond,
    simulate,
)
from trimmer.maps import sweep
from trimmer.mechanism import Force, Link, Mechanism, Wall

LINEAR = Mechanism(
    frequency=3.0,
    bodies={"mass": Body(mass=2.0)},
    links={"spring": Link(("ground", "mass"), stiffness=800.0, damping=8.0)},
    stops={"far": Stop(("ground", "mass"), stiffness=1e4, damping=0.0, gap=10.0)},
    forces={"drive": Force("mass", amplitude=5.0)},
    outputs={"x": Output({"mass": 1.0})},
)


def test_a_linear_machine_follows_its_frequency_response() -> None:
    swept = sweep(LINEAR, "frequency", 2.0, "4 Hz", steps=4, periods=80, back=True)
    assert swept.success
    assert swept.unit == "Hz"
    assert [point.value for point in swept.points] == [2.0, 2.5, 3.0, 3.5, 4.0, 3.5, 3.0, 2.5, 2.0]
    for point in swept.points:
        omega = 2 * math.pi * point.value
        amplitude = 5.0 / abs(800.0 - 2.0 * omega**2 + 8.0j * omega)
        (found,) = point.motion.outputs.values()
        assert (point.motion.kind.word, point.motion.periods) == ("periodic", 1)
        assert found.peak_to_peak == pytest.approx(2 * amplitude, rel=1e-7)
        assert found.rms == pytest.approx(amplitude / math.sqrt(2), rel=1e-7)
        assert found.lines[0][:2] == (1, 1)
        assert found.lines[0][2] == pytest.approx(amplitude, rel=1e-7)
        beside = 0.5 * amplitude  # with a Hann window
        assert point.motion.spectra["x"][31:34] == pytest.approx([beside, amplitude, beside], rel=1e-4)
    assert (swept.jumps, swept.hysteresis) == ((), ())


def test_the_way_up_and_the_way_back_jump_at_the_folds_of_the_branch() -> None:
    """A published example of pyHarm: folds at 8.566393659 and 6.9976281194 rad/s, digits of mechanism.md."""
    swept = sweep(example("oscillator-stop"), "frequency", 1.0, 1.4, steps=8, periods=100, back=True)
    up, down = swept.jumps
    assert up.before < 8.566393659 / (2 * math.pi) < up.after
    assert down.after < 6.9976281194 / (2 * math.pi) < down.before
    assert up.change < 0 < down.change
    assert (swept.points[up.point].value, swept.points[down.point].back) == (1.4, True)
    (differ,) = swept.hysteresis
    assert (differ.lowest, differ.highest) == (pytest.approx(1.15), pytest.approx(1.35))


@pytest.mark.parametrize(("periods", "hum"), [(6, 3.0), (5, 4.5)])
def test_what_is_varied_without_effect_leaves_one_motion(periods: int, hum: float) -> None:
    """With 4.5 Hz beside 3 Hz all phases return after two periods, so that 5 of them are taken as 6."""
    forces = {**LINEAR.forces, "hum": Force("mass", amplitude=3.0, drive="hum")}
    machine = replace(LINEAR, forces=forces, drives={"hum": hum})
    swept = sweep(machine, "stops.far.stiffness", 1e4, 2e4, steps=1, periods=periods)
    motion = simulate(machine, 12 / 3.0)
    assert swept.periods == 6
    for number, point in enumerate(swept.points):
        times = np.linspace((6 * number + 6 - point.motion.measured) / 3.0, (6 * number + 6) / 3.0, 20_001)
        (found,) = point.motion.outputs.values()
        assert found.peak_to_peak == pytest.approx(np.ptp(motion.output("x", times)), rel=1e-6)
        mean = np.trapezoid(motion.output("x", times), times) / (times[-1] - times[0])
        assert found.mean == pytest.approx(mean, rel=1e-5, abs=1e-9)


def test_what_is_carried_along_is_measured_without_its_advance() -> None:
    place = "forces.exciter.amplitude"
    swept = sweep(example("conveyor"), place, 200.0, 210.0, steps=1, periods=400)
    settled = respond(example("conveyor").with_value(place, 210.0)).motion
    last = swept.points[-1].motion
    assert last.kind is settled.kind
    for name, found in last.outputs.items():
        assert found.advance == pytest.approx(settled.advance[name], rel=1e-6, abs=1e-12)
        assert found.peak_to_peak == pytest.approx(settled.peak_to_peak[name], rel=1e-3)
    # What is left of the start adds up in what advances, and is neither stroke nor jump.
    brief = sweep(example("conveyor"), place, 200.0, 210.0, steps=2, periods=80, back=True)
    assert brief.points[0].motion.kind is MotionKind.UNDECIDED
    assert (brief.jumps, brief.hysteresis) == ((), ())
    assert brief.points[2].peak_to_peak("part") == pytest.approx(settled.peak_to_peak["part"], rel=1e-3)


def test_a_ball_rests_on_its_wall_and_then_leaves_it() -> None:
    """The weight no longer holds it once the force exceeds it: m g = 0.2 N."""
    ball = Mechanism(
        {"ball": Body(mass=0.02)},
        20.0,
        walls={"floor": Wall(("ball", "ground"), restitution=0.5)},
        forces={"weight": Force("ball", constant=-0.2), "shaker": Force("ball", amplitude=0.1)},
        outputs={"x": Output({"ball": 1.0})},
    )
    swept = sweep(ball, "forces.shaker.amplitude", 0.1, 0.25, steps=3, periods=40)
    kinds = [point.motion.kind.word for point in swept.points]
    assert kinds[:2] == ["rest", "rest"]
    assert kinds[-1] != "rest"
    assert swept.points[-1].peak_to_peak("x") > 0 == swept.points[0].peak_to_peak("x")


def test_what_moves_by_itself_has_its_size_and_frequency_both_ways() -> None:
    """Stick ends 1/2 beyond where kinetic friction holds the block; it then swings with 1 rad/s."""
    swept = sweep(example("block-on-belt"), "pins.belt.velocity", 0.1, 0.4, steps=3, back=True)
    for point in swept.points:
        assert point.peak_to_peak("block") == pytest.approx(2 * math.hypot(0.5, point.value), rel=1e-9)
        period = 2 * (math.pi - math.atan(0.5 / point.value)) + 1 / point.value
        assert point.motion.period == pytest.approx(period, rel=1e-9)
    assert (swept.jumps, swept.hysteresis) == ((), ())


def test_what_escapes_grows_without_bound_and_ends_the_sweep() -> None:
    """Of x' = 5 x - 10 sat x + a sin t nothing holds what is beyond 2; two solutions part as it grows."""
    names = {"states": ["x"], "inputs": ["y", "w"], "outputs": ["y"]}
    plant = control.ss([[5.0]], [[-10.0, 1.0]], [[1.0]], [[0.0, 0.0]], **names)
    loop = Feedback(plant, {"y": Saturation(1.0)}, {"w": Drive(0.1, frequency=1.0)})
    swept = sweep(loop, "drives.w.amplitude", 0.1, 80.1, steps=2, periods=40, back=True)
    kinds = [point.motion.kind.word for point in swept.points]
    assert kinds == ["periodic", "diverging", "diverging"]
    assert not swept.success and "ends at drives.w.amplitude = 80.1, because it grew" in swept.message
    assert math.isnan(swept.points[-1].peak_to_peak("y"))


REFUSED = {
    "one value": ("oscillator-stop", "frequency", 1.0, "1 Hz", {}, "no length"),
    "a start": ("oscillator-stop", "start.mass", 1.0, 2.0, {}, "begins once"),
    "whole numbers": ("oscillator-stop", "forces.drive.order", 1, 3, {}, "whole numbers"),
    "one period": ("oscillator-stop", "frequency", 1, 2, {"periods": 1}, "periods must be .* 2 on, not 1"),
}


@pytest.mark.parametrize("case", REFUSED)
def test_what_cannot_be_varied_is_refused(case: str) -> None:
    name, place, start, stop, settings, sentence = REFUSED[case]
    with pytest.raises((TrimmerError, ValueError), match=sentence):
        sweep(example(name), place, start, stop, **settings)
