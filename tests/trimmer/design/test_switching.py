"""Machines that switch: judged from start to rest, against closed forms of a body that bounces on a wall."""

import math

import pytest

from trimmer import MechanismError, MotionKind, SerialRunner, simulate
from trimmer.design import DesignFile, DesignOutcome, DesignSettings, Measure, MeasureOfPart, Study, Sureness
from trimmer.design.specification.design_file import design_file_of_text
from trimmer.design.trials.trial import TrialWork, all_measures

MACHINE = """
[bodies]
blade = { mass = "20 g" }
[forces]
coil = { on = "blade", profile = [["2 ms", "4 N"], [1, "4 N"]] }
[walls]
seat = { between = ["ground", "blade"], gap = "1 mm", restitution = 0.5 }
[outputs]
travel = { blade = 1 }
"""
FORCE, MASS, GAP, RESTITUTION, BEGIN = 4.0, 0.02, 1e-3, 0.5, 2e-3
SHOWN = 1.15  # Up to which multiple of the last time at which something happens the motion is shown
TINY = DesignSettings(cells=3, trials=4, machines=2, range_points=3, grid=2)


def file(targets: str = "", *changes: tuple[str, str]) -> DesignFile:
    text = MACHINE + (f"[targets]\n{targets}\n" if targets else "")
    for old, new in changes:
        assert old in text
        text = text.replace(old, new)
    return design_file_of_text(text, "mine.toml")


def study(of: DesignFile) -> Study:
    return Study(of, TINY, SerialRunner())


def closed_form(gap: float = GAP) -> tuple[float, float, float]:
    """Time of the first impact, s, its speed, m/s, and how long it bounces, s."""
    speed = math.sqrt(2 * FORCE / MASS * gap)
    bounces = 2 * speed * RESTITUTION / (FORCE / MASS * (1 - RESTITUTION))
    return BEGIN + speed * MASS / FORCE, speed, bounces


def test_what_is_measured_is_the_closed_form() -> None:
    motions = study(file()).motions()
    motion, (closing, speed, bounces) = motions.first, closed_form()
    assert motion is not None
    assert motion.switched is not None
    assert motion.kind is MotionKind.REST
    found = [motion.measure(each, "seat") for each in (Measure.CLOSING_TIME, Measure.IMPACT_SPEED)]
    assert found == pytest.approx([closing, speed], rel=1e-9)
    assert motion.signals.times[-1] == pytest.approx(SHOWN * 1.0)  # after the last point of its force
    # The chatter is completed once less than 1e-9 s of it is left.
    assert motion.measure(Measure.BOUNCE_TIME, "seat") == pytest.approx(bounces, rel=0, abs=2e-9)
    assert motion.measure(Measure.STROKE, "travel") == pytest.approx(GAP, rel=1e-9)
    assert motion.switched.forces == pytest.approx({"seat": FORCE}, rel=1e-9)
    assert motion.switched.positions == pytest.approx({"blade": GAP}, rel=1e-9)
    assert not motion.rms_acceleration


def test_trials_measure_what_the_motion_does() -> None:
    machine = file().mechanism
    asked = all_measures(machine)
    assert {each.measure for each in asked} == {
        Measure.STROKE,
        Measure.IMPACT_SPEED,
        Measure.CLOSING_TIME,
        Measure.BOUNCE_TIME,
    }
    trial = TrialWork(machine, ("walls.seat.gap",), asked, 0)((4 * GAP,))
    closing, speed, bounces = closed_form(4 * GAP)
    assert trial.kind is MotionKind.REST
    assert trial.value(Measure.CLOSING_TIME, "seat") == pytest.approx(closing, rel=1e-9)
    assert trial.value(Measure.IMPACT_SPEED, "seat") == pytest.approx(speed, rel=1e-9)
    assert trial.value(Measure.BOUNCE_TIME, "seat") == pytest.approx(bounces, rel=0, abs=2e-9)
    asked = (MeasureOfPart(Measure.BOUNCE_TIME, "seat"), MeasureOfPart(Measure.IMPACT_SPEED, "seat"))
    never = TrialWork(file("", ("4 N", "-4 N")).mechanism, (), asked, 0)(())
    assert [size for _, size in never.measures] == [math.inf, 0.0]


def test_a_missed_bound_is_mended_with_what_holds_when_computed_again() -> None:
    closing, _, bounces = closed_form()
    bounds = f"closing_time_at_most = {1.3 * closing}\nbounce_time_at_most = {0.7 * bounces}"
    design = study(file(bounds)).whole()
    assert design.verdict.outcome is DesignOutcome.MISSED
    assert design.verdict.sureness is Sureness.SURE
    assert [each.met for each in design.verdict.judged] == [True, False]
    assert design.remedies is not None
    best, machine = design.remedies.found[0], design.file.mechanism
    for change in best.changes:
        machine = machine.with_value(change.place, change.after)
    found = simulate(machine, 0.1).closings["seat"]
    margins = 1 - found.closing_time / (1.3 * closing), 1 - found.bounce_time / (0.7 * bounces)
    assert best.margin == pytest.approx(min(margins), rel=1e-6)
    assert best.margin > 0
    assert best.meeting is None
    assert [[each.key for each in drawn.targets] for drawn in design.maps]
    for drawn in design.maps:
        for target in drawn.targets:
            assert drawn.result.chosen[f"closings.seat.{target.measure.key}"].shape == drawn.result.shape
    assert design.sensitivities is not None
    by_gap = next(each for each in design.sensitivities.entries if each.place == "walls.seat.gap")
    elasticity = by_gap.of(MeasureOfPart(Measure.BOUNCE_TIME, "seat"))
    assert elasticity is not None
    assert elasticity.value == pytest.approx(0.5, abs=1e-4)


def test_a_contact_that_does_not_close_misses_its_bounds() -> None:
    bounds = "closing_time_at_most = 1.0\nbounce_time_at_most = 1.0\nimpact_speed_at_most = 1.0"
    short = study(file(bounds, ("4 N", "-4 N"))).short()
    assert [(each.value, each.met) for each in short.verdict.judged] == [
        (math.inf, False),
        (math.inf, False),
        (0.0, True),
    ]


def test_without_a_drive_what_falls_is_followed_until_it_rests() -> None:
    text = MACHINE.replace('profile = [["2 ms", "4 N"], [1, "4 N"]]', "constant = 4.0")
    motion = study(design_file_of_text(text, "mine.toml")).motions().first
    assert motion is not None
    assert motion.measure(Measure.CLOSING_TIME, "seat") == pytest.approx(closed_form()[0] - BEGIN, rel=1e-9)


DRIVEN = ("[bodies]", "frequency = 50.0\n[bodies]")
SHAKEN = ("profile = [[", "amplitude = 1.0 } #")
PROFILE = "a force follows a profile, with which nothing repeats"


@pytest.mark.parametrize(
    ("targets", "changes", "told"),
    [
        ('bounce_time_at_most = { seet = "1 ms" }', (), "no play, stop or wall 'seet'; did you mean seat?"),
        ('closing_time_at_most = "1 mm"', (), '"5 ms" would do'),
        ('closing_time_at_most = "-1 ms"', (), "must be zero or greater"),
        ("rms_acceleration_at_most = 3.0", (), PROFILE),
        ("only_drive_period = true", (DRIVEN,), PROFILE),
        ("bounce_time_at_most = 1.0", (DRIVEN, SHAKEN), "driven and its contacts close again and again"),
    ],
)
def test_what_cannot_be_judged_is_refused(
    targets: str, changes: tuple[tuple[str, str], ...], told: str
) -> None:
    with pytest.raises(MechanismError, match=r"^mine\.toml: ") as error:
        file(targets, *changes)
    assert told in str(error.value)


def test_what_a_drive_keeps_moving_is_followed_for_twenty_of_its_periods() -> None:
    """A tug of 0.5 Hz takes the blade off its seat again and again; its force follows a profile until 1 s."""
    tugged = ("[walls]", 'tug = { on = "blade", amplitude = "6 N" }\n[walls]')
    motion = study(file("", ("[bodies]", "frequency = 0.5\n[bodies]"), tugged)).motions().first
    assert motion is not None
    assert motion.signals.times[-1] == pytest.approx(1.0 + 20 * 2.0)
