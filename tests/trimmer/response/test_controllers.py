"""What controlled machines settle to: rest, hunting, what follows a sine or a ramp, and slips without end."""

import control
import numpy as np
import pytest

from tests.trimmer.response.mechanisms import example
from trimmer import Mechanism, MotionKind, SerialRunner, follow, motion_map, respond, sample, simulate
from trimmer.errors import UnsupportedMotionError
from trimmer.uncertainty import SampleSettings, Scatter, Uncertainty, Uniform

ONE = """\
[bodies]
motor = {{ inertia = 0.0002 }}
[frictions]
bearing = {{ between = ["ground", "motor"], force = 0.05, static = {static} }}
[outputs]
angle = {{ motor = 1 }}
torque = {{ control = "axis" }}
[controllers.axis]
kind = "pid"
measure = "angle"
reference = "path"
acts = ["ground", "motor"]
kp = 6.0
ki = {ki}
kd = 0.05
filter_time = 1e-3
limit = {limit}
{more}
[references]
path = {path}
"""


def one(
    static: float = 0.08, ki: float = 120.0, limit: float = 2.0, path: str = "{ step = 0.5, at = 0.01 }",
    more: str = "",
) -> Mechanism:  # fmt: skip
    return Mechanism.from_toml_text(ONE.format(static=static, ki=ki, limit=limit, path=path, more=more))


def test_an_integral_hunts_with_stiction_as_found_elsewhere() -> None:
    # shared/cases/servo.json: Newton on the return map of another exact engine, and one period by DOP853.
    (motion,) = respond(one()).motions
    orbit = motion.orbit
    assert motion.kind is MotionKind.PERIODIC and orbit is not None and orbit.stable
    assert orbit.period == pytest.approx(0.893388965805779, rel=2e-12)
    angle, torque = (orbit.measures.outputs[name] for name in ("angle", "torque"))
    assert 0.5 * (angle.largest - angle.smallest) == pytest.approx(0.0025134134275286435, rel=2e-12)
    assert torque.largest == pytest.approx(0.08000547288165727, rel=1e-10)
    assert len(orbit.course.events) == 4
    assert sorted(abs(orbit.multipliers))[-2] == pytest.approx(0.5596135347, rel=1e-6)


TABLE = """\
[bodies]
motor = { inertia = "1.2 kg cm^2" }
table = { inertia = "0.06 kg m^2" }
[points]
output = { motor = 0.05 }
[plays.gear]
between = ["output", "table"]
stiffness = "9 kN m/rad"
damping = "6 N m s/rad"
gap = "0.06 deg"
[frictions]
seal = { between = ["ground", "motor"], force = "30 mN m", static = "40 mN m" }
bearing = { between = ["ground", "table"], force = "0.5 N m", static = "0.6 N m", viscous = "0.3 N m s/rad" }
[outputs]
angle = { table = 1 }
speed = { velocity = { motor = 0.05 } }
[controllers.axis]
kind = "cascade"
measure = "angle"
speed = "speed"
reference = "index"
acts = ["ground", "motor"]
kp = "50 1/s"
kv = "0.6 N m s/rad"
ti = "12 ms"
limit = "2.5 N m"
[references]
index = { step = "10 deg", at = "10 ms" }
"""


def test_a_table_hunts_with_a_long_period_of_many_events() -> None:
    """Of the recurrences that a motion passes, one event alone leads to the orbit."""
    table = Mechanism.from_toml_text(TABLE)
    (motion,) = respond(table).motions
    assert motion.orbit is not None and motion.orbit.stable
    period, events = motion.orbit.period, len(motion.orbit.course.events)
    assert period == pytest.approx(27.5, abs=0.1)  # another program, in steps of a microsecond
    times = np.array([event.time for event in simulate(table, 130.0).events])
    np.testing.assert_allclose(times[-events:] - times[-2 * events : -events], period, rtol=1e-6)


def test_a_step_or_a_profile_counts_with_its_last_value() -> None:
    (late,), (points,) = (
        respond(one(path=path)).motions
        for path in ("{ step = 0.5, at = 7.0 }", "{ profile = [[0, 0], [1, 3], [2, 0.5]] }")
    )
    assert late.orbit is not None and points.orbit is not None
    assert late.orbit.period == points.orbit.period


@pytest.mark.parametrize("ki", [20.0, 120.0, 400.0])
def test_slips_without_a_drop_become_smaller_for_ever(ki: float) -> None:
    (motion,) = respond(one(static=0.05, ki=ki)).motions
    assert motion.kind is MotionKind.REST and motion.rest is not None and motion.rest.asymptotic
    assert motion.rest.positions["motor"] == pytest.approx(0.5, abs=1e-13)
    assert "slips for ever, less each time" in motion.message
    # Far along the motion is on its way there, each slip being the same share of the one before.
    events = [each.time for each in simulate(one(static=0.05, ki=ki), 150.0).events]
    assert len(events) < 40


@pytest.mark.parametrize("ki", [20.0, 120.0])
def test_under_samples_it_slides_ever_more_slowly_instead(ki: float) -> None:
    (motion,) = respond(one(static=0.05, ki=ki, more="sample = 1e-3")).motions
    assert motion.rest is not None and motion.rest.asymptotic
    assert motion.rest.positions["motor"] == pytest.approx(0.5, abs=1e-12)
    assert "slides for ever, ever more slowly; where that leads to was seen within" in motion.message


def test_what_never_moves_rests_unless_its_integral_runs_on() -> None:
    (held,) = respond(one(limit=0.04)).motions
    assert held.rest is not None and held.rest.family and not held.rest.asymptotic
    assert held.rest.forces["axis"] == pytest.approx(0.04, abs=1e-15)
    (runs,) = respond(one(limit=0.04, more="tracking = inf")).motions
    assert runs.kind is MotionKind.DIVERGING and "integral of a controller runs on" in runs.message


@pytest.mark.parametrize("billionths", [0.0, 756.0, 1329.0, 1330.0])
def test_what_slides_into_its_rest_does_so_whichever_way_rounding_falls(billionths: float) -> None:
    """Its velocity dies away, and as rounding stood for a slip: at these gains here, at 20 elsewhere."""
    servo = example("two-mass-servo").with_value("controllers.axis.kp", 20.0 * (1.0 + 1e-9 * billionths))
    found = respond(servo).motions[0]
    assert found.kind is MotionKind.REST
    assert found.rest.positions["load"] == pytest.approx(np.deg2rad(30.0), rel=1e-12)


def test_a_sine_drives_and_a_linear_loop_answers_it_as_its_frequency_response_says() -> None:
    loop = one(path="{ sine = 0.3, frequency = 7.0, phase = 0.4 }", limit=1e9)
    linear = Mechanism(
        loop.bodies, forces={}, outputs=loop.outputs, controllers=loop.controllers, references=loop.references
    )
    (motion,) = respond(linear).motions
    s = 2j * np.pi * 7.0
    law = control.tf([0.05, 0], [1e-3, 1]) + 6.0 + control.tf([120.0], [1, 0])
    closed = complex((law * control.tf([1], [2e-4, 0, 0]))(s))
    expected = 0.3 * abs(closed / (1 + closed))
    assert motion.kind is MotionKind.PERIODIC and motion.orbit is not None
    assert motion.orbit.period == pytest.approx(1 / 7.0, rel=1e-15)
    assert motion.harmonics["angle"][0] == pytest.approx(expected, rel=1e-11)


def test_a_ramp_is_followed_in_slips_or_evenly() -> None:
    (slow,), (fast,) = (respond(one(path=f"{{ ramp = {rate} }}")).motions for rate in (0.005, 0.5))
    assert slow.orbit is not None and fast.orbit is not None
    assert slow.advance["angle"] == pytest.approx(0.005 * slow.orbit.period, rel=1e-9)
    assert len(slow.orbit.course.events) == 2
    assert fast.advance["angle"] == pytest.approx(0.5 * fast.orbit.period, rel=1e-12)
    spring = '[links]\nspring = {{ between = ["ground", "motor"], stiffness = 1.0 }}\n'
    held = ONE.replace("[outputs]", spring + "[outputs]")
    text = held.format(static=0.08, ki=120.0, limit=2.0, path="{ ramp = 0.5 }", more="")
    with pytest.raises(UnsupportedMotionError, match="reference: what is measured cannot go on"):
        respond(Mechanism.from_toml_text(text))


def test_a_map_over_gains_needs_no_drive_and_agrees_with_each_cell() -> None:
    places = {"controllers.axis.ki": [0.0, 60.0], "frictions.bearing.static": [0.05, 0.08]}
    result = motion_map(one(), places, starts=2, runner=SerialRunner())
    assert "for at most 1700 periods of its slowest mode" in result.searched
    cells = result.cells
    kinds = [motion.kind for cell in cells for motion in cell.motions]
    assert kinds == [MotionKind.REST, MotionKind.REST, MotionKind.REST, MotionKind.PERIODIC]
    (alone,) = respond(one(ki=60.0)).motions
    (hunting,) = cells[-1].motions
    assert hunting.measures.peak_to_peak["angle"] == pytest.approx(alone.peak_to_peak["angle"], rel=1e-10)


def test_hunting_is_followed_while_its_period_grows() -> None:
    branch = follow(one(), "controllers.axis.ki", 120.0, 25.0)
    last = branch.points[-1]
    assert last.value == 25.0 and last.stable
    (alone,) = respond(one(ki=25.0)).motions
    assert last.period == pytest.approx(alone.orbit.period, rel=1e-9)


def test_samples_of_what_hunts_need_no_drive() -> None:
    scatter = Scatter("controllers.axis.ki", "N m/rad/s", Uniform(100.0, 140.0))
    found = sample(one(), Uncertainty((scatter,)), SampleSettings(count=3), runner=SerialRunner())
    assert [trial.kind for trial in found.trials] == [MotionKind.PERIODIC] * 3
