"""When a friction counts as at rest, and what a course keeps of its stretches."""

from __future__ import annotations

import math
from dataclasses import replace
from typing import Any

import numpy as np
import pytest

from trimmer.contact import advance as advance_module
from trimmer.contact import flow as flow_module
from trimmer.contact.advance import Ending, advance
from trimmer.contact.flow import ExactFlow
from trimmer.contact.statuses import BACKWARD, CONTACT_MADE, FORWARD, MINUS, PLUS, RELAXING, STICK
from trimmer.mechanism.mechanism import Mechanism
from trimmer.mechanism.parts import Body, ContactLaw, Force, Friction, Pin, Play, Stop

BETWEEN = ("ground", "body")


def on_a_table(phase: float) -> int:
    """A body at rest on a table that moves to and fro by 3 m at 2 Hz."""
    mechanism = Mechanism(
        {"body": Body(1.0)},
        frequency=2.0,
        pins={"table": Pin("ground", 3.0, phase)},
        frictions={"rub": Friction(("body", "table"), 1e9)},
    )
    return ExactFlow(mechanism).rest().statuses[0]


def test_a_wave_that_turns_back_is_at_rest() -> None:
    # The table's velocity is 6e-17 of its greatest one there, not zero.
    assert math.cos(math.pi / 2) > 0
    assert on_a_table(math.pi / 2) == on_a_table(-math.pi / 2) == STICK
    assert on_a_table(math.pi / 2 - 1e-13) == FORWARD
    assert on_a_table(math.pi / 2 + 1e-13) == BACKWARD


@pytest.mark.parametrize(
    ("first", "second", "status"),
    [
        (-0.3, -0.3, STICK),
        (0.3, 0.3, STICK),
        (-0.3, np.nextafter(-0.3, -1.0), STICK),
        (-0.3, np.nextafter(-0.3, 0.0), STICK),
        (-0.3, -0.3 + 1e-13, FORWARD),
        (-0.3, -0.3 - 1e-13, BACKWARD),
        (-1e-3, -1e-3 + 1e-14, FORWARD),
        (0.0, 0.0, STICK),
        (0.0, -1e-300, BACKWARD),
    ],
)
def test_bodies_whose_velocities_differ_by_rounding_are_at_rest(
    first: float, second: float, status: int
) -> None:
    bodies = {"one": Body(1.0), "two": Body(1.0)}
    flow = ExactFlow(Mechanism(bodies, frictions={"rub": Friction(("one", "two"), 1.0)}))
    instant = flow.rest({"one": (0.0, first), "two": (0.0, second)})
    assert instant.statuses == (status,)


def test_stretches_are_negligible_by_the_distance_of_each_contact() -> None:
    stops = {"near": Stop(BETWEEN, 1.0, 1.0, 9.0), "far": Stop(("body", "ground"), 1.0, 1.0, 9.0)}
    flow = ExactFlow(
        Mechanism({"body": Body(1.0)}, stops=stops, plays={"slot": Play(BETWEEN, 1.0, 1.0, 5.0)})
    )
    negligible = flow.rest({"body": (-0.75, 0.0)}).negligible
    assert negligible.tolist() == [0.75 * 2.0**-56] * 3


@pytest.mark.parametrize(("side", "status"), [(1, PLUS), (-1, MINUS)])
def test_a_spring_whose_end_is_just_at_the_wall_is_in_contact(side: int, status: int) -> None:
    slot = Play(BETWEEN, 40.0, 3.0, 0.5, ContactLaw.RELAXING)
    flow = ExactFlow(Mechanism({"body": Body(1.0)}, plays={"slot": slot}))
    place, stretch = 0.75 * side, 0.5 * side
    assert flow.at(np.array([place, 0.0, stretch])).statuses == (status,)
    assert flow.at(np.array([place, 0.0, stretch + 1e-15 * side])).statuses == (RELAXING,)
    # 40 N/m 0.5 m against 3 N s/m: the force is zero at -20/3 m/s, and a pull beyond.
    assert flow.at(np.array([place, -6.6 * side, stretch])).statuses == (status,)
    assert flow.at(np.array([place, -6.7 * side, stretch])).statuses == (RELAXING,)


def bouncing(**changes: Any) -> ExactFlow:
    """A body of 1 kg that bounces on springs of 100 N/m at +-0.5 m; it is driven by nothing, at 2 Hz."""
    mechanism = Mechanism(
        {"body": Body(1.0)},
        frequency=2.0,
        plays={"slot": Play(BETWEEN, 100.0, 0.0, 1.0)},
        forces={"nothing": Force("body", amplitude=1e-300)},
        start={"body": (0.0, 1.0)},
    )
    return ExactFlow(replace(mechanism, **changes))


def test_a_course_keeps_all_its_events_however_many(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(advance_module, "ROWS", 2)
    flow, alone = bouncing(frequency=0.1), bouncing(frequency=None, forces={})
    instant = flow.rest()
    made = [0.5 + place * (1.0 + math.pi / 10) for place in range(8)]
    courses = [flow.course(instant, 1), flow.timed(instant, 9.9), flow.timed(instant, 10.0)]
    for course in (*courses, alone.timed(alone.rest(), 10.0)):
        times = [time for time, _, kind in course.events if kind == CONTACT_MADE]
        assert times == pytest.approx(made, rel=1e-12)
    assert all(course.begin is instant for course in courses)


def test_several_periods_are_kept_in_one_log_that_grows(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(advance_module, "ROWS", 2)
    flow = bouncing(plays={}, start={"body": (0.1, 0.6)})
    stretch = advance(flow.modes, flow.rest(), 5, flow.period, True)
    assert stretch.ending is Ending.REACHED_END
    assert stretch.states[:, 0] == pytest.approx(0.1 + 0.3 * np.arange(6), rel=1e-14)
    assert stretch.log.state[:, 0] == pytest.approx(stretch.states[:-1, 0], rel=1e-14)


def test_a_strobe_keeps_no_log(monkeypatch: pytest.MonkeyPatch) -> None:
    rows = []

    def watched(*arguments: Any) -> Any:
        stretch = advance(*arguments)
        rows.append(len(stretch.log.start))
        return stretch

    monkeypatch.setattr(flow_module, "advance", watched)
    flow = bouncing()
    assert flow.strobe(flow.rest(), 100).counts.sum() > 70
    assert max(rows) < 10


def test_a_course_lasts_as_long_as_it_went_on_wherever_it_began() -> None:
    flow = bouncing()
    instant = replace(flow.rest(), phase=0.2, periods=3)
    course = flow.course(instant, 2)
    assert course.duration == pytest.approx(1.0, rel=1e-14)
    assert (course.end.periods, course.end.phase) == (5, pytest.approx(0.2))
    timed = flow.timed(instant, 3.6)
    assert timed.duration == 3.6
    assert (timed.end.periods, timed.end.phase) == (10, pytest.approx(0.3))
    alone = bouncing(frequency=None, forces={})
    later = alone.timed(alone.timed(alone.rest(), 0.3).end, 0.1).end
    assert (later.periods, later.phase) == (0, pytest.approx(0.4))
    for ended in (flow.timed(instant, 3.6, 1), alone.timed(later, 3.6, 1)):
        assert ended.ending is Ending.STEP_LIMIT
        # It has gone on by as much as the body has moved at 1 m/s.
        assert ended.duration == pytest.approx(ended.end.state[0] - ended.begin.state[0], rel=1e-12)


def test_whole_periods_end_with_the_last_of_them() -> None:
    flow = bouncing()
    course = flow.timed(flow.rest(), 1.5)
    assert (course.end.periods, course.end.phase) == (3, pytest.approx(0.0))
    assert course.log.start[-1] < 1.4
    assert flow.timed(flow.rest(), 3.7).end.periods == 7
