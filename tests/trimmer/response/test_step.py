"""How controlled machines follow a step: public digits, and what is refused."""

from dataclasses import asdict

import pytest

from tests.trimmer.servos import SAMPLED, SERVO, STICTION
from trimmer import Mechanism, MechanismError, MotionKind, respond
from trimmer.response import step_response

MOTOR = "motor = { inertia = 0.0002 }"
BEARING = '[frictions]\nbearing = { between = ["ground", "motor"], force = 0.05, static = 0.08 }'
WINDUP = (
    STICTION.replace(MOTOR, "motor = { inertia = 0.001 }")
    .replace(BEARING, '[links]\nbearing = { between = ["ground", "motor"], damping = 0.002 }')
    .replace("kp = 6.0\nki = 120.0", "kp = 1.0\nki = 8.0")
    .replace("1e-3\nlimit = 2.0", "2e-3\nlimit = 0.2")
    .replace("step = 0.5, at = 0.01", "step = 1.0, at = 0.0")
)
EXAMPLE = "[references] path = { step = 0.01 }"
WRITTEN = 'write reference = "path" into one of [controllers]'


def test_a_servo_with_backlash_follows_as_a_second_program_says() -> None:
    """servo.json, servo_pd_rest_motor_encoder: expm with Newton on the guards, and DOP853."""
    expected = {
        "rise_time": 0.02595193483943595,
        "overshoot": 0.0,
        "settling_time": 0.03934686419788285,
        "final_error": 0.005083840413415253,
        "largest_control": 2.0,
        "largest_demand": 48.0,
    }
    mechanism = Mechanism.from_toml_text(SERVO)
    found = step_response(mechanism, "path", duration=0.4)
    assert asdict(found.measures) == pytest.approx(expected, rel=1e-12, abs=2e-14)
    assert found.motion.final["load"] == pytest.approx((0.500061247866714, 0.0), rel=1e-12, abs=1e-12)
    assert (found.settles_to.kind, found.settles_to.motion.rest.family) == (MotionKind.REST, True)
    alone = step_response(mechanism, "path", controller="axis")
    assert asdict(alone.measures) == pytest.approx(expected, rel=1e-12, abs=2e-14)
    assert alone.motion.rest is not None


def test_the_integral_follows_the_limit_as_a_second_program_says() -> None:
    """servo.json, windup_back_calculation_default."""
    expected = {
        "rise_time": 0.09110191036850442,
        "overshoot": 10.060827350674684,
        "settling_time": 0.3566083256810007,
        "final_error": 0.0,
        "largest_control": 0.2,
        "largest_demand": 26.0,
    }
    found = step_response(Mechanism.from_toml_text(WINDUP), "path", duration=5.0)
    assert asdict(found.measures) == pytest.approx(expected, rel=1e-11, abs=1e-12)


def test_a_sampled_controller_follows_as_a_second_program_says() -> None:
    """servo.json, sampled_pid_linear_delay_half: exact discretisation in mpmath."""
    expected = {
        "rise_time": 0.016767285248646548,
        "overshoot": 32.05678031180228,
        "settling_time": 0.1601635701218646,
        "final_error": 0.0006630325616178157,
        "largest_control": 7.421666666666667,
        "largest_demand": 7.421666666666667,
    }
    found = step_response(Mechanism.from_toml_text(SAMPLED), "path", duration=0.4)
    assert asdict(found.measures) == pytest.approx(expected, rel=1e-12, abs=1e-12)
    slower = Mechanism.from_toml_text(SAMPLED.replace("kp = 1.5", "kp = 1.5\nlimit = 2.0"))
    limited = step_response(slower, "path", duration=0.4).measures
    assert (limited.largest_control, limited.largest_demand) == pytest.approx((2.0, 7.421666666666667))


@pytest.mark.parametrize("step", [0.003, 0.008, 0.07])
def test_what_creeps_up_to_its_reference_does_not_overshoot_by_rounding(step: float) -> None:
    """A valve under PI: all poles are real, and the residues keep the lift below the reference."""
    text = f"""
    [bodies]
    stem = {{ mass = 1.2 }}
    [links]
    spring = {{ between = ["ground", "stem"], stiffness = 15e3, damping = 900.0 }}
    [outputs]
    lift = {{ stem = 1 }}
    [controllers.positioner]
    kind = "pid"
    measure = "lift"
    reference = "path"
    acts = ["ground", "stem"]
    kp = 20e3
    ki = 60e3
    [references]
    path = {{ step = {step}, at = 0.05 }}
    """
    assert step_response(Mechanism.from_toml_text(text)).measures.overshoot == 0.0


def test_what_hunts_has_the_error_of_its_mean() -> None:
    """servo.json, hunting_one_mass_static_friction; by symmetry the mean is the reference."""
    found = step_response(Mechanism.from_toml_text(STICTION), "path")
    orbit = found.settles_to.motion.orbit
    assert orbit.period == pytest.approx(0.893388965805779, rel=1e-10)
    assert 0.5 * found.settles_to.motion.peak_to_peak["angle"] == pytest.approx(
        0.0025134134275286435, rel=1e-9
    )
    assert found.measures.final_error == pytest.approx(0.0, abs=1e-12)
    assert abs(found.motion.final["motor"][0] - 0.5) > 1e-4
    assert found.motion.duration == pytest.approx(0.01 + 20 * orbit.period, rel=1e-9)
    assert found.hunting.amplitude == pytest.approx(0.0025134134275286435, rel=1e-9)
    assert found.hunting.frequency == pytest.approx(1.1193332784204075, rel=1e-10)
    assert found.hunting.period == orbit.period
    assert (found.measures.largest_control, found.measures.largest_demand) == pytest.approx((2.0, 28.0))


def test_a_motion_that_rests_is_shown_until_little_moves() -> None:
    found = step_response(Mechanism.from_toml_text(SAMPLED), "path")
    assert (found.ending, found.hunting) == ("where it rests", None)
    still = found.motion.output("angle", [found.shown_until, found.motion.duration])
    assert abs(still - 0.5).max() < 0.002 * 0.5
    assert 0.2 < found.shown_until < 1.0 < found.motion.duration
    given = step_response(Mechanism.from_toml_text(SAMPLED), "path", duration=0.4)
    assert (given.ending, given.shown_until) == ("", 0.4)


def test_the_only_step_that_is_followed_is_taken() -> None:
    two = STICTION.replace("path = {", "back = { step = 1.0 }\npath = {")
    assert step_response(Mechanism.from_toml_text(two), duration=0.1).reference == "path"
    another = STICTION[STICTION.index("[controllers.axis]") : STICTION.index("[references]")]
    another = another.replace("axis", "other").replace("path", "back")
    with pytest.raises(MechanismError, match=r"^back and path are steps; choose one \(--reference back\)$"):
        step_response(Mechanism.from_toml_text(two.replace("[references]", another + "[references]")))


@pytest.mark.parametrize(
    ("changed", "asked", "message"),
    [
        ("", {"reference": "pth"}, "there is no reference 'pth'; did you mean path?"),
        ("step = 0.5, at = 0.01", {"reference": None}, f"nothing steps; {EXAMPLE} is one"),
        ("step = 0.5, at = 0.01", {}, f"references.path is a ramp and no step; {EXAMPLE} is one"),
        ("step = 0.5", {}, "references.path.step is 0, so that there is nothing to follow; give its size"),
        ("", {"controller": "axes"}, "no controller 'axes' follows 'path'; did you mean axis?"),
        ("", {"duration": 0.01}, "a motion of 0.01 s ends before 'path' steps; give more than 0.01 s"),
        ('reference = "path"', {}, f"no controller follows 'path'; {WRITTEN}"),
        ("[references]", {}, "axis and other follow 'path'; choose one (--controller)"),
    ],
)  # fmt: skip
def test_what_is_no_step_to_follow_is_refused(changed: str, asked: dict[str, object], message: str) -> None:
    another = STICTION[STICTION.index("[controllers.axis]") : STICTION.index("[references]")]
    to = {
        "step = 0.5, at = 0.01": "ramp = 0.5",
        "step = 0.5": "step = 0.0",
        "[references]": another.replace("axis", "other") + "[references]",
    }.get(changed, "")
    mechanism = Mechanism.from_toml_text(STICTION.replace(changed, to) if changed else STICTION)
    with pytest.raises(MechanismError) as refused:
        step_response(mechanism, **{"reference": "path", **asked})
    assert str(refused.value) == message


INDEXING = """\
[bodies]
motor = { inertia = 1.5e-4 }
table = { inertia = 0.12 }
[points]
out = { motor = 0.05 }
[plays]
gear = { between = ["out", "table"], stiffness = 4000.0, damping = 2.0, gap = "0.02 deg" }
[frictions]
bearing = { between = ["ground", "motor"], force = 0.02, static = 0.03 }
guide = { between = ["ground", "table"], force = 0.3, static = 0.45 }
[outputs]
angle = { table = 1 }
speed = { velocity = { motor = 0.05 } }
[controllers.axis]
kind = "cascade"
measure = "angle"
speed = "speed"
reference = "path"
acts = ["ground", "motor"]
kp = 54.0
kv = 1.0
ti = 20.0
limit = 2.0
[references]
path = { step = "30 deg" }
"""


def test_what_comes_to_its_hunting_slowly_ends_after_a_few_periods() -> None:
    """An integral of 20 s tears out after minutes; a disturbance halves in 46 of these periods."""
    response = step_response(Mechanism.from_toml_text(INDEXING))
    assert response.hunting is not None and response.hunting.period == pytest.approx(544.7, rel=1e-3)
    assert response.motion.duration == pytest.approx(5 * response.hunting.period, rel=1e-9)
    assert "5 times the period of what it settles to after the step" in response.ending


def test_what_flies_on_in_a_gap_under_samples_does_not_rest() -> None:
    """Each bounce leaves the load a share of its speed, so that it never stands still; the motor sticks."""
    text = """
        bodies = { a = { mass = 1.0 }, b = { mass = 0.8 } }
        plays = { p = { between = ["a", "b"], stiffness = 2500.0, damping = 16.0, gap = 0.04 } }
        frictions = { f = { between = ["ground", "a"], force = 6.0, static = 8.3 } }
        outputs = { y = { b = 1 } }
        references = { path = { step = 0.7 } }
        [controllers.k]
        kind = "cascade"
        measure = "y"
        acts = ["ground", "a"]
        reference = "path"
        kp = 2.3
        kv = 6.9
        sample = 3e-3
    """
    mechanism = Mechanism.from_toml_text(text)
    response = step_response(mechanism, settles_to=respond(mechanism, most_periods=20))
    assert response.ending != "where it rests"
    assert abs(response.motion.final["b"][1]) > 1e-6
