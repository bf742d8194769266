"""Instants, and how far a motion has come."""

import numpy as np
import pytest

from tests.mechanisms.cases import trimmer
from trimmer.contact.flow import ExactFlow
from trimmer.mechanism.mechanism import Mechanism
from trimmer.mechanism.parts import Body, Friction, Link, Pin


def test_no_period_is_refused():
    flow = ExactFlow(trimmer(friction=0.0))
    with pytest.raises(ValueError, match="at least 1, not 0"):
        flow.strobe(flow.rest(), 0)


@pytest.mark.parametrize("periods", [0.3, 1.0, 2.5])
def test_a_motion_goes_on_where_it_ended(periods):
    flow = ExactFlow(trimmer())
    begun = flow.timed(flow.rest(), periods * flow.period)
    assert begun.end.periods == int(periods)
    assert begun.end.phase == pytest.approx((periods % 1) * flow.period, abs=1e-15)
    rest = flow.timed(begun.end, 0.4 * flow.period)
    whole = flow.timed(flow.rest(), (periods + 0.4) * flow.period)
    np.testing.assert_allclose(rest.end.state, whole.end.state, rtol=1e-9, atol=1e-12)


def test_a_belt_that_a_spring_leans_on_moves_on_over_periods():
    mechanism = Mechanism(
        bodies={"body": Body(1.0)},
        frequency=1.0,
        pins={"belt": Pin("ground", velocity=0.25)},
        links={"spring": Link(("belt", "body"), 40.0, 3.0)},
        frictions={"floor": Friction(("ground", "body"), 1.0)},
    )
    flow = ExactFlow(mechanism)
    strobe = flow.strobe(flow.rest(), 40)
    course = flow.timed(flow.rest(), 40.0)
    np.testing.assert_allclose(strobe.states[-1], course.end.state, rtol=1e-9)
    # In the end it slides with the belt, behind it by what its friction needs.
    assert strobe.states[-1, 1] == pytest.approx(0.25)
    assert strobe.states[-1, 0] == pytest.approx(0.25 * 40 - (1.0 / 40 + 0.0), abs=1e-9)
