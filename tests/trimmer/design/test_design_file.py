"""Files of designs: targets, the held body, and what nobody knows; what is wrong is named with its line."""

import math
from pathlib import Path

import pytest

from trimmer import Mechanism, MechanismError
from trimmer.design import DesignFile, Measure, read_design_file
from trimmer.design.specification.design_file import design_file_of_text
from trimmer.examples import example_text

TEXT = """
frequency = 110.0
held = "motor"

[bodies]
motor = { mass = "35 g" }
cutter = { mass = "3 g" }

[pins]
pin = { on = "motor", amplitude = "1.5 mm" }

[links]
mount = { between = ["ground", "motor"], stiffness = 200e3, damping = 3.5 }

[plays]
bridge = { between = ["cutter", "pin"], stiffness = 30e3, damping = 0.4, gap = "40 um" }

[frictions]
blade = { between = ["ground", "cutter"], force = 0.5 }

[outputs]
stroke = { cutter = 1 }

[targets]
stroke_at_least = { stroke = "2.5 mm" }
rms_acceleration_at_most = "90 m/s²"
impact_speed_at_most = 0.2
only_drive_period = true
"""


def read(old: str = "", new: str = "") -> DesignFile:
    """Read the text with one piece of it changed."""
    assert old in TEXT
    return design_file_of_text(TEXT.replace(old, new), "mine.toml")


def test_a_number_alone_bounds_every_part() -> None:
    file = read()
    assert file.held == "motor"
    assert [(each.measure, each.part, each.bound) for each in file.targets] == [
        (Measure.STROKE, "stroke", 2.5e-3),
        (Measure.RMS_ACCELERATION, "motor", 90.0),
        (Measure.RMS_ACCELERATION, "cutter", 90.0),
        (Measure.IMPACT_SPEED, "bridge", 0.2),
        (Measure.PERIOD, "", 1.0),
    ]


def test_other_commands_pass_over_targets() -> None:
    assert Mechanism.from_toml_text(TEXT).value("plays.bridge.gap") == 40e-6


@pytest.mark.parametrize(
    ("written", "lowest", "highest"),
    [("20 um..60 um", 20e-6, 60e-6), ("20..60 um", 20e-6, 60e-6), ("0.01 mm .. 60 um", 10e-6, 60e-6)],
)
def test_a_range_is_carried_with_its_middle(written: str, lowest: float, highest: float) -> None:
    file = read('gap = "40 um"', f'gap = "{written}"')
    (found,) = file.ranges
    assert (found.place, found.assumed) == ("plays.bridge.gap", False)
    assert (found.lowest, found.highest) == pytest.approx((lowest, highest))
    assert file.mechanism.value("plays.bridge.gap") == pytest.approx((lowest + highest) / 2)


GAP = 'gap = "40 um"'


@pytest.mark.parametrize(
    ("old", "new", "told"),
    [
        ('"35 g"', '"unknown"', "line 6: bodies.motor.mass = 'unknown': nothing in the file says"),
        (GAP, 'gap = "60 um..20 um"', "line 16: plays.bridge.gap = '60 um..20 um': has no length"),
        (GAP, 'gap = "1 N..2 N"', "'N' does not measure what m does"),
        (GAP, 'gap = "-1 um..2 um"', "has an end that must be zero or greater"),
        ('"motor"\n', '"moter"\n', "line 3: held = 'moter': names the body that a hand holds; did you"),
        ("stroke_at", "strokes_at", "line 25: targets.strokes_at_least: unknown key; did you mean"),
        ("{ stroke = ", "{ strok = ", "line 25: targets.stroke_at_least.strok = '2.5 mm': there"),
        ('"90 m/s²"', '"90 m/s"', "line 26: targets.rms_acceleration_at_most = '90 m/s'"),
        ("= 0.2", "= -0.2", "line 27: targets.impact_speed_at_most = -0.2: must be zero or greater"),
        ("= true", '= "yes"', "line 28: targets.only_drive_period = 'yes': write true or false"),
    ],
)
def test_what_is_wrong_is_named_with_line_key_and_value(old: str, new: str, told: str) -> None:
    with pytest.raises(MechanismError) as error:
        read(old, new)
    assert str(error.value).startswith("mine.toml: ")
    assert told in str(error.value)


def test_targets_on_what_is_not_there_are_refused() -> None:
    text = example_text("den-hartog") + "\n[targets]\nimpact_speed_at_most = 1.0\n"
    with pytest.raises(MechanismError, match="no play, stop or wall that this could bound"):
        design_file_of_text(text, "mine.toml")
    text = example_text("block-on-belt") + "\n[targets]\nonly_drive_period = true\n"
    with pytest.raises(MechanismError, match="no drive, so there is no period to keep"):
        design_file_of_text(text, "mine.toml")


def test_other_commands_tell_what_to_do_about_a_range() -> None:
    text = TEXT.replace('gap = "40 um"', 'gap = "unknown"').replace("force = 0.5", 'force = "0.1..0.9 N"')
    with pytest.raises(MechanismError) as error:
        Mechanism.from_toml_text(text, "mine.toml")
    assert (
        "line 16: plays.bridge.gap = 'unknown': nobody knows this value, which 'trimmer design' and"
        in str(error.value)
    )
    assert "--set 'plays.bridge.gap=VALUE'" in str(error.value)
    assert "line 19: frictions.blade.force = '0.1..0.9 N': this is a range" in str(error.value)


def test_the_line_of_a_place_is_its_own_or_that_of_what_holds_it() -> None:
    file = read('gap = "40 um"', 'gap = "20 um..60 um"')
    assert (file.name, file.ranges[0].middle) == ("mine.toml", pytest.approx(40e-6))
    assert file.line(("plays", "bridge", "gap")) == file.line(("plays", "bridge")) == 16
    assert file.line(("plays", "bridge", "law")) == 16
    assert file.line(("plays", "other", "gap")) == 15
    assert file.line(("frequency",)) == 2
    assert file.line(("stops", "wall")) == 0
    assert file.line(()) == 0


def test_a_file_is_read_with_its_name(tmp_path: Path) -> None:
    path = tmp_path / "mine.toml"
    path.write_text(TEXT, "utf-8")
    file = read_design_file(path)
    assert (file.name, file.mechanism.value("plays.bridge.gap")) == (str(path), 40e-6)
    assert (file.line(("held",)), file.line(("plays", "bridge", "gap"))) == (3, 16)


def test_what_is_unknown_is_assumed_from_the_middle_of_what_is_open() -> None:
    text = TEXT.replace('mass = "3 g"', 'mass = "2 g..4 g"').replace("force = 0.5", 'force = "unknown"')
    mass, force = design_file_of_text(text, "mine.toml").ranges
    assert (mass.lowest, mass.highest, mass.assumed) == (2e-3, 4e-3, False)
    assert force.highest == pytest.approx(3e-3 * (2 * math.pi * 110) ** 2 * 1.5e-3)


def test_a_range_that_cannot_be_read_is_the_only_problem() -> None:
    with pytest.raises(MechanismError) as error:
        read('mass = "35 g"', 'mass = "1 N..2 N"')
    assert "nothing in the file says" not in str(error.value)
    assert "'N' does not measure what kg does" in str(error.value)


def test_numbers_that_are_set_stand_in_place_of_those_of_the_file(tmp_path: Path) -> None:
    path = tmp_path / "mine.toml"
    path.write_text(TEXT.replace('"40 um"', '"20 um..60 um"'), encoding="utf-8")
    left_open, known = read_design_file(path), read_design_file(path, [("plays.bridge.gap", "30 um")])
    assert [each.place for each in left_open.ranges] == ["plays.bridge.gap"]
    assert (known.ranges, known.mechanism.value("plays.bridge.gap")) == ((), 30e-6)
    assert known.name == f"{path}, plays.bridge.gap=30 um"
    assert known.digest == left_open.digest
    with pytest.raises(MechanismError, match="damping or gap"):
        read_design_file(path, [("plays.bridge.gab", 1.0)])
