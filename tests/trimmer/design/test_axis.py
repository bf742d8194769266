"""Axes that follow a step, judged: a cascade on a mass in closed form, a motor with stiction that hunts."""

import math

import pytest

from tests.trimmer.servos import STICTION
from trimmer import MechanismError, MotionKind, SerialRunner
from trimmer.design import (
    DesignFile,
    DesignOutcome,
    DesignSettings,
    Measure,
    MeasureOfPart,
    NumberRole,
    Study,
)
from trimmer.design.specification.design_file import design_file_of_text
from trimmer.design.trials.trial import TrialWork, all_measures
from trimmer.uncertainty import SampleSettings, study_samples
from trimmer.uncertainty.sample_file import sample_file_of_text

AXIS = """
[bodies]
slide = { mass = "2 kg" }
[outputs]
x = { slide = 1 }
[controllers.axis]
kind = "cascade"
measure = "x"
reference = "path"
acts = ["ground", "slide"]
kp = 4.0
kv = 4.0
[references]
path = { step = "10 mm", at = "20 ms" }
"""
STEP, MASS, KP, KV = 0.01, 2.0, 4.0, 4.0
TINY = DesignSettings(cells=3, trials=3, machines=2, range_points=3)
HUNTING = 0.0025134134275286435  # Amplitude of the motor, rad: servo.json, hunting_one_mass_static_friction


def file(targets: str = "", *changes: tuple[str, str], text: str = AXIS) -> DesignFile:
    for old, new in changes:
        assert old in text
        text = text.replace(old, new)
    return design_file_of_text(text + (f"[targets]\n{targets}\n" if targets else ""), "mine.toml")


def study(of: DesignFile) -> Study:
    return Study(of, TINY, SerialRunner())


def overshoot(kp: float = KP, kv: float = KV) -> float:
    """In per cent, of m x'' = kv (kp (r - x) - x')."""
    damping = kv / (2 * math.sqrt(MASS * kv * kp))
    return 100 * math.exp(-math.pi * damping / math.sqrt(1 - damping**2))


@pytest.mark.parametrize("share", [0.5, 1.0])
def test_file_and_trial_have_the_closed_form(share: float) -> None:
    mechanism = file().mechanism.with_value("controllers.axis.kp", share * KP)
    asked = all_measures(mechanism, stepped=True)
    trial = TrialWork(file().mechanism, ("controllers.axis.kp",), asked, 0)((share * KP,))
    motion = Study(file("", ("kp = 4.0", f"kp = {share * KP}")), TINY, SerialRunner()).motions().first
    assert motion is not None
    assert (trial.kind, motion.kind) == (MotionKind.REST, MotionKind.REST)
    for value in (trial.value, motion.measure):
        assert value(Measure.OVERSHOOT, "axis") == pytest.approx(overshoot(share * KP), rel=1e-9)
        assert value(Measure.LARGEST_CONTROL, "axis") == pytest.approx(KV * share * KP * STEP, rel=1e-12)
        assert value(Measure.HUNTING, "axis") == 0.0
        assert value(Measure.FINAL_ERROR, "axis") <= 1e-9 * STEP
    for each in asked:
        assert trial.value(each.measure, "axis") == pytest.approx(
            motion.measure(each.measure, "axis"), rel=1e-9, abs=1e-12
        )


def test_what_hunts_is_judged_by_its_amplitude() -> None:
    of = file('hunting_at_most = "2 mrad"\nfinal_error_at_most = { axis = "0.1 mrad" }', text=STICTION)
    motions = study(of).motions()
    design = study(of).short()
    assert design.verdict.outcome is DesignOutcome.MISSED
    assert [each.met for each in design.verdict.judged] == [False, True]
    assert motions.first is not None
    assert motions.first.measure(Measure.HUNTING, "axis") == pytest.approx(HUNTING, rel=1e-9)
    asked = (MeasureOfPart(Measure.HUNTING, "axis"), MeasureOfPart(Measure.SETTLING_TIME, "axis"))
    trial = TrialWork(of.mechanism, (), asked, 0)(())
    assert trial.kind is MotionKind.PERIODIC
    # A trial takes the last stretch for the cycle, of which 0.56 of a distance is left after each period.
    assert trial.value(*vars(asked[0]).values()) == pytest.approx(HUNTING, rel=0.02)
    calm = file('hunting_at_most = "3 mrad"\nrise_time_at_most = "20 ms"', text=STICTION)
    assert study(calm).short().verdict.outcome is DesignOutcome.MET


def test_gains_are_found_that_meet_the_targets_and_drawn() -> None:
    """The overshoot depends on kv/kp: 10 % need a damping ratio of 0.591."""
    design = study(file('overshoot_at_most = "10 %"\ncontrol_at_most = "0.2 N"\nhunting_at_most = 0')).whole()
    assert design.verdict.outcome is DesignOutcome.MISSED
    assert [each.target.measure for each in design.verdict.judged if not each.met] == [Measure.OVERSHOOT]
    assert design.remedies is not None
    assert {each.split(".")[0] for each in design.remedies.tried} == {"controllers"}
    for remedy in design.remedies.found:
        gains = {each.place.rsplit(".")[-1]: each.after for each in remedy.changes}
        assert overshoot(**gains) < 10.0
        assert gains.get("kp", KP) * gains.get("kv", KV) * STEP < 0.2
    first = design.maps[0]
    assert (first.first.role, first.second.role) == (NumberRole.GAIN, NumberRole.GAIN)
    assert {cell.motions[0].kind for cell in first.result.cells} == {MotionKind.REST}
    assert Measure.OVERSHOOT in {each.measure for each in first.targets}
    assert design.sensitivities is not None
    (kp,) = [each for each in design.sensitivities.entries if each.place == "controllers.axis.kp"]
    slope = (math.log(overshoot(1.001 * KP)) - math.log(overshoot(0.999 * KP))) / 0.002
    assert kp.of(MeasureOfPart(Measure.OVERSHOOT, "axis")).value == pytest.approx(slope, rel=1e-5)


def test_a_range_without_targets_has_the_measures_of_the_step() -> None:
    """A mass of 3 kg overshoots as one of 2 kg with two thirds of kv."""
    ranges = study(file("", ('"2 kg"', '"2 kg..3 kg"'))).ranges()
    assert ranges is not None
    ends = overshoot(), overshoot(kv=KV * MASS / 3)
    assert ranges.extremes(MeasureOfPart(Measure.OVERSHOOT, "axis")) == pytest.approx(ends, rel=1e-9)


NO_STEP = (
    "no controller follows a step, so that there is none to measure; give one a reference, with "
    "path = { step = 0.01 } below [references]"
)
BESIDE = "is of what the machine settles to, while other targets are of a step; judge the two in a file each"


@pytest.mark.parametrize(
    ("targets", "changes", "told"),
    [
        ('rise_time_at_most = "5 mm"', [], "'mm' does not measure what s does; \"5 ms\" would do"),
        ("overshoot_at_most = -1", [], "targets.overshoot_at_most = -1: must be zero or greater, in %"),
        ('hunting_at_most = "1 deg"', [], "'deg' does not measure what m does; \"2.5 mm\" would do"),
        ("rise_time_at_most = { axes = 1 }", [], "controller that follows a step 'axes'; did you mean axis?"),
        ("rise_time_at_most = 1", [('step = "10 mm"', 'ramp = "1 mm/s"')], f"rise_time_at_most: {NO_STEP}"),
        ("rise_time_at_most = 1", [('step = "10 mm"', "step = 0")], f"targets.rise_time_at_most: {NO_STEP}"),
        ("rise_time_at_most = 1\nstroke_at_least = 0.01", [], f"targets.stroke_at_least: {BESIDE}"),
        ("rise_tme_at_most = 1", [], "unknown key; did you mean rise_time_at_most?"),
    ],
)  # fmt: skip
def test_targets_that_cannot_be_used_are_refused(
    targets: str, changes: list[tuple[str, str]], told: str
) -> None:
    with pytest.raises(MechanismError) as refused:
        file(targets, *changes)
    assert told in str(refused.value)


def test_units_of_targets_are_those_of_what_is_measured() -> None:
    targets = file('overshoot_at_most = "5 %"\ncontrol_at_most = "20 mN"\nfinal_error_at_most = 1e-5').targets
    assert [(each.bound, each.unit) for each in targets] == [(5.0, "%"), (0.02, "N"), (1e-5, "m")]


def test_samples_are_judged_by_the_step_that_targets_are_of() -> None:
    scatters = '[uncertainty]\n"controllers.axis.kp" = { uniform = [2.0, 8.0] }\n'
    mine = sample_file_of_text(f"{AXIS}[targets]\novershoot_at_most = 5\n{scatters}", "mine.toml")
    study = study_samples(mine, SampleSettings(count=8), indices=True, runner=SerialRunner())
    found = study.samples
    expected = [overshoot(trial.values[0]) for trial in found.trials]
    assert [trial.value(Measure.OVERSHOOT, "axis") for trial in found.trials] == pytest.approx(
        expected, rel=1e-9
    )
    assert found.met.tolist() == [each <= 5 for each in expected]
    assert found.kinds == {"rest": len(expected)}
    assert "through the step" in found.message
    wanted = "[targets]\nhunting_at_most = 0\n"
    scatters = '[uncertainty]\n"references.path.step" = { normal = "1 mrad" }\n'
    mine = sample_file_of_text(STICTION + wanted + scatters, "mine.toml")
    hunts = study_samples(mine, SampleSettings(count=2)).samples
    assert (hunts.kinds, hunts.met.any()) == ({"hunts evenly": 2}, False)
    names = [quantity.name for quantity in study.indices]
    assert names[0] == "whether it comes to rest" and "settling time of axis" in names
