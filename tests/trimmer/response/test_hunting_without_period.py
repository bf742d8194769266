"""Controlled machines that slide to rest for ever, hunt without a period, or are not waited for so long.

Numbers of the first three are random draws, on which a fixed-step program of semi-implicit Euler, written
without this package, rests where is told, or hunts on.
"""

import json
from functools import cache

import numpy as np
import pytest

from tests.trimmer.servos import STICTION
from trimmer import Mechanism, MotionKind, SerialRunner, motion_map, respond, simulate
from trimmer.design import Measure, MeasureOfPart
from trimmer.design.trials.trial import TrialWork
from trimmer.examples import example_text
from trimmer.response.flows import flow_of
from trimmer.response.results.response import SettledMotion
from trimmer.response.results.response_json import motion_json, response_json

KP = "controllers.axis.kp"
SERVO = """
[bodies]
motor = {{ inertia = {motor} }}
load = {{ inertia = {load} }}
[plays]
gear = {{ between = ["motor", "load"], stiffness = {stiffness}, damping = {damping}, gap = {gap} }}
[frictions]
bearing = {{ between = ["ground", "motor"], force = {force}, static = {static} }}
[links]
guide = {{ between = ["ground", "load"], damping = {guide} }}
[outputs]
angle = {{ {measured} = 1 }}
speed = {{ velocity = {{ motor = 1 }} }}
torque = {{ control = "axis" }}
[controllers.axis]
kind = "cascade"
measure = "angle"
speed = "speed"
reference = "path"
acts = ["ground", "motor"]
{gains}
[references]
path = {{ step = {step}, at = 0.01 }}
"""
EXAMPLE = {
    "motor": 2e-4, "load": 5e-4, "stiffness": 80.0, "damping": 0.02, "gap": np.radians(0.02),
    "force": 5e-3, "static": 7.5e-3, "guide": 2e-3, "measured": "load",
    "gains": "kp = 52.0\nkv = 0.1\nti = 0.01\nlimit = 2.0", "step": np.radians(30.0),
}  # fmt: skip
"""examples/two-mass-servo.toml with a tenth of its gap and another gain."""
SLIDING = {
    "motor": 1.781658475276871e-4, "load": 2.852439206651769e-4, "stiffness": 8.312563663021002,
    "damping": 0.00899985144749412, "gap": 7.05816379146396e-4, "force": 0.04212440822290802,
    "static": 0.04212440822290802, "guide": 0.003606620886448464, "measured": "motor",
    "gains": "kp = 5.0393449832285\nkv = 0.03883337550838686\nti = 0.006394716248236446", "step": 0.5,
}  # fmt: skip
"""It slides to the reference ever slower, and friction bears at last just what the integral gives."""
SLOWER = SLIDING | {
    "motor": 2.02e-4, "load": 1.06e-4, "stiffness": 5.82, "damping": 0.0152, "gap": 1.25e-3,
    "force": 0.0361, "static": 0.0361, "guide": 5.36e-3, "gains": "kp = 5.24\nkv = 0.0104\nti = 6.47e-4",
}  # fmt: skip
"""Unlike that, its velocity is rounding before it counts as at rest: what comes is to be foreseen."""


def servo(**numbers: object) -> Mechanism:
    return Mechanism.from_toml_text(SERVO.format(**(EXAMPLE | numbers)))


@cache
def chaos() -> SettledMotion:
    return settled(servo())


def settled(mechanism: Mechanism, most_periods: int | None = None) -> SettledMotion:
    response = respond(mechanism, most_periods=most_periods)
    json.dumps(response_json(response))
    return response.motion


@pytest.mark.parametrize("numbers", [SLIDING, SLIDING | {"static": 1.5 * SLIDING["force"]}, SLOWER])
def test_what_slides_to_rest_ever_slower_rests_at_the_reference(numbers: dict[str, object]) -> None:
    motion = settled(servo(**numbers))
    assert motion.kind is MotionKind.REST and motion.rest is not None
    outputs, positions = motion.rest.measures.outputs, motion.rest.positions
    assert outputs["angle"].mean == pytest.approx(0.5, abs=1e-13)
    assert outputs["torque"].mean == pytest.approx(numbers["force"], rel=1e-9)
    assert positions["motor"] - positions["load"] == pytest.approx(numbers["gap"] / 2, rel=1e-9)


def test_a_rest_that_newton_finds_is_not_what_a_hunting_comes_to() -> None:
    """A stiction PID of two bodies, draw 8: it slips on, and Newton's method finds a rest near by."""
    text = """
    [bodies]
    motor = { inertia = 2.1231089280079342e-4 }
    load = { inertia = 1.3544452511374191e-3 }
    [plays.gear]
    between = ["motor", "load"]
    stiffness = 21.71227579167588
    damping = 0.009375107984535168
    gap = 1.5273111000938745e-3
    [frictions]
    bearing = { between = ["ground", "motor"], force = 0.04799365160983539, static = 0.06492462628955194 }
    seal = { between = ["ground", "load"], force = 0.0050990591820492944, static = 0.006628776936664083 }
    [links]
    guide = { between = ["ground", "load"], damping = 8.716098899146588e-4 }
    [outputs]
    angle = { load = 1 }
    [controllers.axis]
    kind = "pid"
    measure = "angle"
    reference = "path"
    acts = ["ground", "motor"]
    kp = 0.3937288150615522
    ki = 0.3093870218204383
    kd = 0.02721069467230878
    filter_time = 0.0010668802589755234
    [references]
    path = { step = 0.5, at = 0.01 }
    """
    motion = settled(Mechanism.from_toml_text(text), 1700)
    assert motion.kind is MotionKind.UNDECIDED
    assert motion.window is not None and motion.peak_to_peak["angle"] > 0.01
    assert "1700 periods of its slowest mode; 17000 of them would be followed" in motion.message


@pytest.mark.slow
def test_what_comes_to_a_cycle_slowly_is_told_to_and_not_to_grow() -> None:
    """A slip drops the control by kp times its size; the integral takes it to the other breakaway."""
    slow = STICTION.replace("ki = 120.0", "ki = 5.0")
    motion = settled(Mechanism.from_toml_text(slow), 100)
    assert "but so slowly that its end was not waited for" in motion.message
    assert motion.kind is MotionKind.PERIODIC and motion.orbit is not None and motion.orbit.stable
    slip = motion.peak_to_peak["angle"]
    assert motion.orbit.period == pytest.approx(2 * (2 * 0.08 - 6.0 * slip) / (5.0 * slip / 2), rel=5e-3)
    slower = settled(Mechanism.from_toml_text(slow.replace("5.0", "3.0")), 120)
    assert slower.kind is MotionKind.UNDECIDED


@pytest.mark.slow
def test_of_what_takes_too_many_steps_it_is_told_how_far_it_swings() -> None:
    slowest = settled(Mechanism.from_toml_text(STICTION.replace("ki = 120.0", "ki = 0.01")))
    assert "it came again 2 times; at its events it swings peak to peak: angle by 0.00503" in slowest.message
    swings = motion_json(slowest)["swings"]
    # A slip goes at most 2 (0.08 - 0.05) N m / kp far, without the damping of kd.
    assert swings["times"] == 2 and 0.0045 < swings["peak_to_peak"]["angle"] < 0.06 / 6.0
    assert swings["peak_to_peak"]["torque"] == pytest.approx(2 * 0.08, rel=1e-6)


def test_hunting_that_is_chaotic_tells_how_far_it_goes() -> None:
    """The exponent beside a second way: distances of two motions that are integrated apart."""
    mechanism, motion = servo(), chaos()
    assert motion.kind is MotionKind.CHAOTIC and motion.window is not None and motion.lyapunov is not None
    low, high = motion.lyapunov.interval
    flow, begins = flow_of(mechanism), motion.window.begin
    grown = []
    for place in range(40):
        begin = flow.timed(begins, 1.0 + 0.7 * place).end
        pair = begin, flow.at(begin.state * (1.0 + 1e-11), like=begin)
        apart = [np.subtract(*(flow.timed(each, time).end.state for each in pair)) for time in (1.0, 2.5)]
        grown.append(np.log(np.linalg.norm(apart[1]) / np.linalg.norm(apart[0])) / 1.5)
    error = 3.0 * np.std(grown) / np.sqrt(len(grown))
    assert low - error < np.mean(grown) < high + error
    later = simulate(mechanism, 300.0)
    swings = np.ptp(later.output("angle", np.linspace(200.0, 300.0, 100_001)))
    assert motion.peak_to_peak["angle"] == pytest.approx(swings, rel=0.2)
    assert motion.mean["angle"] == pytest.approx(EXAMPLE["step"], abs=1e-5)
    assert "largest Lyapunov exponent" in motion.message and "may still be a transient" in motion.message


def test_a_trial_of_a_design_measures_rest_and_chaos() -> None:
    stroke = MeasureOfPart(Measure.STROKE, "angle")
    rests, hunts = map(TrialWork(servo(), (KP,), (stroke,), 0), ((20.0,), (52.0,)))
    assert (rests.kind, hunts.kind) == (MotionKind.REST, MotionKind.CHAOTIC)
    assert rests.value(stroke.measure, "angle") == 0.0
    later = simulate(servo().with_value(KP, 52.0), 300.0)
    swings = np.ptp(later.output("angle", np.linspace(200.0, 300.0, 100_001)))
    assert hunts.value(stroke.measure, "angle") == pytest.approx(swings, rel=0.2)


@pytest.mark.parametrize(
    ("gap", "gain", "kind"),
    [(4 / 3, 40 / 3, MotionKind.REST), (2.0, 40.0, MotionKind.PERIODIC), (1 / 3, 40.0, MotionKind.CHAOTIC)],
)
def test_a_trial_of_an_axis_tells_what_respond_does(gap: float, gain: float, kind: MotionKind) -> None:
    """Sliding to rest ever slower took a gigabyte, and was told to hunt; chaos was told to hunt evenly."""
    servo = Mechanism.from_toml_text(example_text("two-mass-servo"))
    places, values = ("plays.gear.gap", KP), (gap * servo.plays["gear"].gap, gain)
    (trial,) = map(TrialWork(servo, places, (MeasureOfPart(Measure.HUNTING, "axis"),), 0), (values,))
    machine = servo.with_value(places[0], values[0]).with_value(KP, gain)
    assert trial.kind is kind is respond(machine).kind


def test_a_map_tells_the_chaos_of_a_cell_as_respond_does() -> None:
    places = {KP: [20.0, 52.0]}
    cells = motion_map(servo(), places, runner=SerialRunner()).cells
    (rests,), (hunts,) = (cell.motions for cell in cells)
    assert (rests.kind, hunts.kind) == (MotionKind.REST, MotionKind.CHAOTIC)
    alone = chaos()
    assert hunts.lyapunov is not None and alone.lyapunov is not None
    assert hunts.lyapunov == pytest.approx(alone.lyapunov.value, rel=0.5)
    assert hunts.measures.peak_to_peak["angle"] == pytest.approx(alone.peak_to_peak["angle"], rel=0.3)


def test_a_slow_mode_is_waited_for_as_long_as_is_said() -> None:
    few = settled(servo(), 2)
    assert few.kind is MotionKind.UNDECIDED
    assert "most_periods=20 (--periods 20)" in few.message


CREEPING = """
[bodies]
stage = { mass = 0.6668 }
slide = { mass = 1.5767 }
[links]
mount = { between = ["ground", "stage"], stiffness = 63.5, damping = 3.47 }
drag = { between = ["ground", "slide"], damping = 3.34 }
[plays]
joint = { between = ["stage", "slide"], stiffness = 696.6, gap = 0.003189509358403613 }
[frictions]
guide = { between = ["ground", "stage"], force = 0.644 }
[outputs]
stage = { stage = 1 }
slide = { slide = 1 }
[controllers.stage]
kind = "pid"
measure = "stage"
reference = "stage"
acts = ["ground", "stage"]
kp = 18.3
ki = 1.99
kd = 0.466
filter_time = 0.0088
[controllers.slide]
kind = "cascade"
measure = "slide"
reference = "slide"
acts = ["ground", "slide"]
kp = 2.52
kv = 3.42
[references]
stage = { step = 0.3 }
slide = { step = 0.117 }
"""


def test_rounding_of_large_forces_does_not_hide_a_rest() -> None:
    """The joint pushes with what the slide's controller asks for, and the integral bears the stage."""
    motion = settled(Mechanism.from_toml_text(CREEPING))
    stage, slide = (motion.rest.positions[name] for name in ("stage", "slide"))
    pushes = 696.6 * (stage - slide - 0.5 * 0.003189509358403613)
    assert stage == pytest.approx(0.3, rel=1e-9)
    assert pushes == pytest.approx(2.52 * 3.42 * (slide - 0.117), rel=1e-9)
