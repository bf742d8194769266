"""What differs between two mechanisms and their motions."""

from dataclasses import replace
from types import SimpleNamespace
from typing import Any

import pytest

from tests.trimmer.design.made import contact, motion, oscillator, output
from tests.trimmer.design.test_axis import AXIS, overshoot
from trimmer import ContactLaw, Link, Mechanism, SerialRunner, Stop
from trimmer.design import (
    ChangedNumber,
    FoundMotion,
    Measure,
    MeasureDifference,
    MeasureOfPart,
    Study,
    compared,
)
from trimmer.design.specification.design_file import design_file_of_text

STROKE = MeasureOfPart(Measure.STROKE, "block")


def design(mechanism: Mechanism, moving: FoundMotion | None) -> Any:
    file = SimpleNamespace(mechanism=mechanism, switched=False, stepped=False)
    return SimpleNamespace(file=file, motion=moving)


def moving(size: float, **changes: Any) -> FoundMotion:
    outputs = {"block": output(0.0, size), "double": output(0.0, 2 * size)}
    return motion(outputs=outputs, rms_acceleration={"block": 3.0}, contacts={}, frictions={}, **changes)


def test_a_change_is_relative_to_what_was_before() -> None:
    assert MeasureDifference(STROKE, 4.0, 5.0).change == pytest.approx(0.25)
    assert MeasureDifference(STROKE, 4.0, 3.0).change == pytest.approx(-0.25)
    for before, after in (
        (None, 1.0),
        (1.0, None),
        (0.0, 1.0),
        (1.0, float("inf")),
        (float("inf"), 1.0),
        (1.0, -float("inf")),
    ):
        assert MeasureDifference(STROKE, before, after).change is None
    assert MeasureDifference(STROKE, 4.0, 0.0).change == -1.0


@pytest.mark.parametrize(
    ("before", "after", "differ"),
    [(9e3, 9e3 * (1 + 5e-13), False), (9e3, 9e3 * (1 + 5e-12), True), (9e3, 0.0, True), (0.0, 1e-300, True)],
)
def test_numbers_differ_by_more_than_rounding(before: float, after: float, differ: bool) -> None:
    designs = [
        design(oscillator().with_value("links.spring.stiffness", each), None) for each in (before, after)
    ]
    for one, other in (designs, designs[::-1]):
        assert bool(compared(one, other).changes) is differ


def test_numbers_and_ends_that_differ_are_listed() -> None:
    before = oscillator()
    after = replace(
        before.with_value("links.spring.stiffness", 1e4),
        stops={"wall": Stop(("ground", "block"), 500.0, 0.0, 4e-5)},
    )
    found = compared(design(before, None), design(after, None))
    assert found.changes == (
        ChangedNumber("links.spring.stiffness", "N/m", 9e3, 1e4),
        ChangedNumber("stops.wall.stiffness", "N/m", None, 500.0),
        ChangedNumber("stops.wall.gap", "m", None, 4e-5),
    )
    assert found.others == ()
    back = compared(design(after, None), design(before, None)).changes
    assert (back[0].before, back[0].after) == (1e4, 9e3)
    assert [(each.before, each.after) for each in back[1:]] == [(500.0, None), (4e-5, None)]


def test_parts_whose_form_differs_are_listed_apart() -> None:
    before = replace(oscillator(), stops={"wall": Stop(("ground", "block"), 500.0, 1.0, 4e-5)})
    turned = replace(before, links={"spring": Link(("block", "ground"), 9e3, 4.0)})
    found = compared(design(before, None), design(turned, None))
    assert (found.changes, found.others) == ((), ("links.spring",))
    law = Stop(("ground", "block"), 500.0, 1.0, 4e-5, ContactLaw.TRUNCATED)
    assert compared(design(before, None), design(replace(before, stops={"wall": law}), None)).others == (
        "stops.wall",
    )


def test_a_frequency_that_only_one_has_is_a_change() -> None:
    driven = oscillator()
    free = replace(driven, frequency=None, forces={})
    changes = {each.place: each for each in compared(design(free, None), design(driven, None)).changes}
    assert changes["frequency"] == ChangedNumber("frequency", "Hz", None, 20.0)


def test_measures_stand_beside_each_other_as_far_as_there_are_any() -> None:
    first = oscillator()
    second = replace(first, stops={"wall": Stop(("ground", "block"), 500.0, 0.0, 4e-5)})
    hit = replace(moving(3e-3), contacts={"wall": contact(0.2)}, period_count=2)
    both = compared(design(first, moving(2e-3)), design(second, hit))
    found = {each.asked: (each.before, each.after) for each in both.differences}
    assert len(found) == len(both.differences) == 5
    assert found[STROKE] == (2e-3, 3e-3)
    assert found[MeasureOfPart(Measure.STROKE, "double")] == (4e-3, 6e-3)
    assert found[MeasureOfPart(Measure.RMS_ACCELERATION, "block")] == (3.0, 3.0)
    assert found[MeasureOfPart(Measure.IMPACT_SPEED, "wall")] == (None, 0.2)
    assert found[MeasureOfPart(Measure.PERIOD, "")] == (1.0, 2.0)
    none = compared(design(first, None), design(second, hit)).differences
    assert {(each.before, each.after is None) for each in none} == {(None, False)}


DROPPED = """
[bodies]
ball = { mass = 1 }
[walls]
floor = { between = ["ground", "ball"], gap = 0.01, restitution = 0.5 }
[forces]
weight = { on = "ball", constant = 9.81 }
"""
FALL = (2 * 0.01 / 9.81) ** 0.5


@pytest.mark.parametrize(
    ("text", "change", "asked", "values"),
    [
        (DROPPED, ("0.01", "0.04"), (Measure.CLOSING_TIME, "floor"), (FALL, 2 * FALL)),
        (AXIS, ("kp = 4.0", "kp = 2.0"), (Measure.OVERSHOOT, "axis"), (overshoot(4.0), overshoot(2.0))),
    ],
)
def test_what_switches_or_follows_a_step_is_compared_by_its_own_measures(
    text: str, change: tuple[str, str], asked: tuple[Measure, str], values: tuple[float, float]
) -> None:
    both = [design_file_of_text(each, "mine.toml") for each in (text, text.replace(*change))]
    differences = compared(*(Study(each, runner=SerialRunner()).short() for each in both)).differences
    (found,) = [each for each in differences if each.asked == MeasureOfPart(*asked)]
    assert (found.before, found.after) == pytest.approx(values, rel=1e-9)
    assert Measure.RMS_ACCELERATION not in {each.asked.measure for each in differences}
