"""A target is met up to its bound and not beyond it."""

import math

import pytest

from trimmer.design import Measure, Target


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
