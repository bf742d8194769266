"""What the time was too short for is not told as a finding."""

from dataclasses import replace

import numpy as np
import pytest

from report.design.words.verdict import meets_at_its_point
from trimmer import MotionKind
from trimmer.branches import BranchEnd
from trimmer.design import (
    Measure,
    MeasureOfPart,
    NumberPath,
    NumberRole,
    PathSide,
    Remedy,
    Target,
    Trial,
    VariedNumber,
)
from trimmer.design.trials.remedies import Change
from trimmer.design.trials.surroundings import Around, Beside, Condition

SPEED = VariedNumber(NumberRole.SPEED, "frequency", "", "Hz", 20.0, 10.0, 30.0)
SIDE = PathSide(10.0, np.array([20.0]), np.array([True]), {}, (), BranchEnd.OUT_OF_TIME, "the time is over")
TORN = replace(SIDE, reason=BranchEnd.TORN)
LONGER = replace(SIDE, values=np.array([20.0, 19.0]), stable=np.array([True, True]))
TARGET = Target("stroke_at_least", Measure.STROKE, "stroke", 2e-3, "m")


@pytest.mark.parametrize(
    ("down", "up", "expected"),
    [(SIDE, SIDE, True), (SIDE, None, True), (SIDE, LONGER, False), (TORN, SIDE, False)],
)
def test_a_branch_of_one_orbit_has_hardly_begun(down: PathSide, up: PathSide | None, expected: bool) -> None:
    assert NumberPath(SPEED, 1, down, up).hardly_begun is expected


@pytest.mark.parametrize(
    ("stroke", "beside", "expected"), [(2.1e-3, False, True), (2.1e-3, True, False), (1.9e-3, False, False)]
)
def test_a_change_that_was_not_computed_beside_its_point_is_told_as_that(stroke, beside, expected) -> None:
    measures = ((MeasureOfPart(Measure.STROKE, "stroke"), stroke),)
    trial = Trial((3.0,), MotionKind.PERIODIC, 1, measures)
    around = Around((TARGET,), ((Condition(Beside.POINT), trial),))
    change = Change("bodies.motor.mass", "kg", 0.09, 0.27)
    assert meets_at_its_point(Remedy((change,), around, beside)) is expected
