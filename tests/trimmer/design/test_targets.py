"""A target is met up to its bound and not beyond it."""

from __future__ import annotations

import math
import re

import pytest

from tests.trimmer.design.made import oscillator
from trimmer.design.targets import Measure, Target, targets_of
from trimmer.examples import example_text
from trimmer.mechanism.mechanism import Mechanism
from trimmer.mechanism.problems import Problem

TWIN = Mechanism.from_toml_text(example_text("thesis-play"))


@pytest.mark.parametrize("measure", list(Measure))
def test_a_bound_parts_what_will_do_from_what_will_not(measure: Measure) -> None:
    target = Target("key", measure, "part", 2.0)
    beyond = math.nextafter(2.0, 0.0 if target.at_least else 3.0)
    within = math.nextafter(2.0, 3.0 if target.at_least else 0.0)
    assert target.met_by(2.0)
    assert target.met_by(within)
    assert not target.met_by(beyond)
    assert not target.met_by(math.nan)
    assert target.at_least is (measure is Measure.STROKE)


def read(content: object, mechanism: Mechanism = TWIN) -> tuple[tuple[Target, ...], list[Problem]]:
    problems: list[Problem] = []
    return targets_of(content, mechanism, problems), problems  # type: ignore[arg-type]


def test_a_bound_holds_for_all_parts_or_for_those_that_are_named() -> None:
    found, problems = read({"impact_speed_at_most": "0.2 m/s", "only_drive_period": True})
    assert found == (
        Target("impact_speed_at_most", Measure.IMPACT_SPEED, "bridge", 0.2),
        Target("only_drive_period", Measure.PERIOD, "", 1.0),
    )
    assert not problems
    names = list(TWIN.bodies)
    found, _ = read({"rms_acceleration_at_most": {names[1]: 3.0, names[0]: 2.0}})
    assert [(each.measure, each.part, each.bound) for each in found] == [
        (Measure.RMS_ACCELERATION, names[1], 3.0),
        (Measure.RMS_ACCELERATION, names[0], 2.0),
    ]
    found, _ = read({"rms_acceleration_at_most": 0})
    assert [each.part for each in found] == names
    assert read({"only_drive_period": False}) == ((), [])


@pytest.mark.parametrize(
    ("content", "place", "told"),
    [
        (3, (), "is a section"),
        ({"strokes_at_least": 1}, ("strokes_at_least",), "unknown key; did you mean stroke_at_least?"),
        ({"xyz": 1}, ("xyz",), r"unknown key; \[targets\] may hold "),
        ({"stroke_at_least": -1.0}, ("stroke_at_least",), "must be zero or greater"),
        ({"stroke_at_least": "1 N"}, ("stroke_at_least",), '"2.5 mm" would do'),
        ({"stroke_at_least": {"xyz": 1}}, ("stroke_at_least", "xyz"), "there is no output 'xyz'; there is"),
        (
            {"rms_acceleration_at_most": {"xyz": 1}},
            ("rms_acceleration_at_most", "xyz"),
            "there is no body 'xyz'; there are",
        ),
        ({"only_drive_period": "yes"}, ("only_drive_period",), "write true or false"),
    ],
)
def test_what_no_target_can_be_is_one_problem(content: object, place: tuple[str, ...], told: str) -> None:
    found, (problem,) = read(content)
    assert found == ()
    assert problem.place == ("targets", *place)
    assert re.search(told, problem.reason)


def test_what_the_mechanism_does_not_have_is_not_bounded() -> None:
    found, (problem,) = read({"impact_speed_at_most": 1.0, "stroke_at_least": {"block": 2.0}}, oscillator())
    assert problem.reason.startswith("the mechanism has no play or stop")
    assert [(each.measure, each.part, each.bound) for each in found] == [(Measure.STROKE, "block", 2.0)]
    free = Mechanism.from_toml_text(example_text("block-on-belt"))
    assert read({"only_drive_period": False}, free) == ((), [])
    (problem,) = read({"only_drive_period": True}, free)[1]
    assert problem.reason.startswith("the mechanism has no drive")
