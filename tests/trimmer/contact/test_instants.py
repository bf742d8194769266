"""Instants from given states, and how a motion is put together from its stretches."""

from __future__ import annotations

import math
from dataclasses import replace

import numpy as np
import pytest

from tests.mechanisms.cases import trimmer
from trimmer.contact import advance as advance_module
from trimmer.contact.advance import Ending, advance
from trimmer.contact.flow import ExactFlow
from trimmer.contact.statuses import (
    ALWAYS,
    ARRIVED,
    BACKWARD,
    CONTACT_MADE,
    FORWARD,
    FREE,
    MINUS,
    NOTHING,
    PLUS,
    RELAXING,
    RELEASED_MINUS,
    RELEASED_PLUS,
    STICK,
)
from trimmer.mechanism.mechanism import Mechanism
from trimmer.mechanism.parts import Body, ContactLaw, Force, Friction, Link, Pin, Play, Stop

BETWEEN = ("ground", "body")


def slot(law: ContactLaw, gap: float = 0.06, damping: float = 3.0) -> ExactFlow:
    """A body of 1 kg between walls at +-3 cm."""
    return ExactFlow(Mechanism({"body": Body(1.0)}, plays={"slot": Play(BETWEEN, 40.0, damping, gap, law)}))


@pytest.mark.parametrize("side", [1, -1])
def test_the_status_of_a_contact_follows_from_its_state(side: int) -> None:
    def status(law: ContactLaw, place: float, speed: float) -> int:
        return slot(law).rest({"body": (side * place, side * speed)}).statuses[0]

    touching, released = (PLUS, RELEASED_PLUS) if side > 0 else (MINUS, RELEASED_MINUS)
    for law in ContactLaw:
        assert status(law, 0.02, 9.0) == FREE
        assert status(law, 0.04, 0.1) == touching
        assert status(law, 0.03, 0.1) == touching
    # 40 N/m 1 cm is less than what the damper pulls with at -1 m/s.
    assert status(ContactLaw.PULLING, 0.04, -1.0) == touching
    assert status(ContactLaw.TRUNCATED, 0.04, -1.0) == released
    assert status(ContactLaw.RELAXING, 0.04, -1.0) == RELAXING
    assert status(ContactLaw.RELAXING, 0.03, 0.0) == touching
    assert status(ContactLaw.TRUNCATED, 0.03, 0.0) == touching


def test_springs_are_as_short_as_can_be_or_as_given() -> None:
    flow = slot(ContactLaw.RELAXING)
    for place, nearest in ((0.05, 0.02), (-0.05, -0.02), (0.01, 0.0)):
        assert flow.rest({"body": (place, 0.0)}).state.tolist() == pytest.approx([place, 0.0, nearest])
        given = flow.at(np.array([place, 0.0, 0.0]))
        assert given.state.tolist() == [place, 0.0, 0.0]

    def status(place: float, stretch: float, speed: float = 0.0) -> int:
        return flow.at(np.array([place, speed, stretch])).statuses[0]

    assert status(0.05, 0.02) == PLUS
    assert status(-0.05, -0.02) == MINUS
    assert status(0.01, 0.005) == RELAXING  # The end of the spring is inside the slot.
    # Its end is at the wall: the damper pushes with 3 N, and the spring would pull with 0.8 N.
    assert status(0.01, -0.025, 1.0) == PLUS
    assert status(-0.01, 0.025, -1.0) == MINUS
    assert status(0.01, -0.025) == RELAXING
    assert status(0.01, 0.0) == FREE
    tight = slot(ContactLaw.RELAXING, 0.0).at(np.array([0.05, 0.0, 0.0]))
    assert (tight.statuses, tight.state.tolist()) == ((ALWAYS,), [0.05, 0.0, 0.05])
    assert slot(ContactLaw.PULLING, 0.0).at(np.array([0.05, 0.0])).statuses == (ALWAYS,)


def test_an_instant_takes_a_start_from_the_mechanism_and_from_the_caller() -> None:
    mechanism = Mechanism(
        {"one": Body(1.0), "two": Body(2.0)},
        links={"spring": Link(("one", "two"), 1.0)},
        stops={"soft": Stop(("two", "one"), 1.0, 1.0, 9.0)},
        start={"one": (0.1, 0.2), "two": (0.3, 0.4)},
    )
    flow = ExactFlow(mechanism)
    assert flow.rest().state.tolist() == [0.1, 0.3, 0.2, 0.4, 0.0]
    assert flow.rest({"two": (5.0, 6.0)}).state.tolist() == [0.1, 5.0, 0.2, 6.0, 0.0]
    assert flow.names == ("one", "two", "one'", "two'", "soft")
    assert (flow.size, flow.period) == (5, 0.0)
    # Stretches count as zero below a share of the distance, here 4.9 m.
    assert flow.rest({"two": (5.0, 6.0)}).negligible == pytest.approx([2.0**-56 * 4.9], rel=1e-14, abs=0)
    assert flow.at(flow.rest().state, 0.7).phase == 0.7


def frictions(force: float, speed: float = 0.0) -> ExactFlow:
    return ExactFlow(
        Mechanism(
            {"body": Body(1.0), "other": Body(1.0)},
            stops={"far": Stop(("ground", "other"), 1.0, 0.0, 9.0)},
            frictions={"table": Friction(("ground", "other"), 1.0), "floor": Friction(BETWEEN, 1.0, 1.5)},
            forces={"push": Force("body", force)},
            start={"body": (0.0, speed), "other": (0.0, -0.3)},
        )
    )


@pytest.mark.parametrize(
    ("force", "speed", "status", "known"),
    [
        (0.5, 0.0, STICK, 0),
        (2.0, 0.0, FORWARD, 1),
        (-2.0, 0.0, BACKWARD, 1),
        (0.0, 0.2, FORWARD, 0),
        (0.0, -0.2, BACKWARD, 0),
    ],
)
def test_a_friction_at_rest_sticks_or_begins_to_slide(
    force: float, speed: float, status: int, known: int
) -> None:
    instant = frictions(force, speed).rest()
    assert instant.statuses == (FREE, BACKWARD, status)
    assert instant.known_zeros.tolist() == [0, 0, known]
    assert instant.known_action.tolist() == [-1, -1, ARRIVED if known else -1]
    assert (instant.periods, instant.phase) == (0, 0.0)


def test_a_neighbouring_motion_is_held_by_what_holds_in_this_one() -> None:
    flow = frictions(0.5)
    like = replace(flow.rest(), periods=7)
    found = flow.at(np.array([0.1, 0.2, 0.3, 0.4]), 0.25, like=like)
    assert found.state.tolist() == pytest.approx([0.1, 0.2, 0.0, 0.4])
    assert (found.statuses, found.periods, found.phase) == (like.statuses, 0, 0.25)


def bouncing(length: float = 1.0) -> ExactFlow:
    """A body of 1 kg that bounces on springs of 100 N/m at +-length / 2; it is driven by nothing, at 2 Hz."""
    return ExactFlow(
        Mechanism(
            {"body": Body(1.0)},
            frequency=2.0,
            plays={"slot": Play(BETWEEN, 100.0, 0.0, length)},
            forces={"nothing": Force("body", amplitude=1e-300)},
            start={"body": (0.0, 1.0)},
        )
    )


def test_events_of_a_course_and_its_duration() -> None:
    # It meets a wall every half second of flight and a contact of pi / 10 s.
    flow = bouncing()
    flight, contact = 1.0, math.pi / 10
    made = [0.5 + place * (flight + contact) for place in range(3)]
    for course in (flow.timed(flow.rest(), 3.7), flow.course(flow.rest(), 7)):
        times = [time for time, _, kind in course.events if kind == CONTACT_MADE]
        assert times == pytest.approx([each for each in made if each < course.duration], rel=1e-12)
        assert all(part == 0 for _, part, _ in course.events)
        assert NOTHING not in [kind for *_, kind in course.events]
        assert course.ending is Ending.REACHED_END
    assert course.duration == pytest.approx(3.5, rel=1e-14)
    assert course.end.periods == 7
    assert course.states(np.array([0.25]))[0, :2] == pytest.approx([0.25, 1.0], rel=1e-13)
    assert flow.timed(flow.rest(), 0.2).duration == 0.2
    assert flow.timed(flow.rest(), 1.5).duration == 1.5


def test_a_motion_that_takes_too_many_steps_ends_where_they_end() -> None:
    flow = bouncing()
    whole = flow.timed(flow.rest(), 2.2)
    for course in (flow.timed(flow.rest(), 2.2, 1), flow.course(flow.rest(), 5, 1)):
        assert course.ending is Ending.STEP_LIMIT
        assert 0.0 < course.duration < 0.5
        np.testing.assert_allclose(
            course.end.state, whole.states(np.array([course.duration]))[0, :2], rtol=1e-12
        )
    strobe = flow.strobe(flow.rest(), 5, 1)
    assert strobe.ending is Ending.STEP_LIMIT
    assert len(strobe.states) == 1
    assert len(strobe.counts) == 1


def test_without_a_drive_there_are_no_periods() -> None:
    mechanism = bouncing().mechanism
    flow = ExactFlow(replace(mechanism, frequency=None, forces={}))
    course = flow.timed(flow.rest(), 3.7)
    assert (course.end.periods, course.end.phase, course.duration) == (0, pytest.approx(3.7), 3.7)
    assert course.end.state == pytest.approx(bouncing().timed(bouncing().rest(), 3.7).end.state, rel=1e-11)


def test_a_ramp_goes_on_over_the_periods_of_a_strobe_until_it_ends() -> None:
    mechanism = Mechanism(
        {"body": Body(1.0)},
        frequency=2.0,
        pins={"belt": Pin("ground", velocity=0.25)},
        links={"spring": Link(("belt", "body"), 1.0, 2.0)},
    )
    flow = ExactFlow(mechanism)
    strobe = flow.strobe(flow.rest(), 3)
    # x'' + 2 x' + x = t / 4 + 1 / 2 from rest.
    times = np.arange(4) / 2
    np.testing.assert_allclose(
        strobe.states[:, 0], 0.25 * (times - times * np.exp(-times)), rtol=1e-12, atol=1e-16
    )
    assert strobe.counts.shape == (3, 6)
    assert strobe.end.periods == 3
    limited = flow.strobe(flow.rest(), 3, 0)
    assert limited.ending is Ending.STEP_LIMIT
    assert limited.counts.shape == (1, 6)
    with pytest.raises(ValueError, match="at least 1, not 0"):
        flow.strobe(flow.rest(), 0)


@pytest.mark.parametrize("keeps", [True, False])
def test_a_log_grows_as_it_must(keeps: bool, monkeypatch: pytest.MonkeyPatch) -> None:
    def run(rows: int):
        monkeypatch.setattr(advance_module, "ROWS", rows)
        flow = ExactFlow(trimmer())
        return advance(flow.modes, flow.rest(), 3, flow.period, keeps)

    small, large = run(2), run(500)
    np.testing.assert_allclose(small.states, large.states, rtol=1e-10, atol=1e-13)
    assert small.counts.tolist() == large.counts.tolist()
    assert small.counts.sum() > 8
    if keeps:
        assert small.log.kind.tolist() == large.log.kind.tolist()
        assert small.log.function.tolist() == large.log.function.tolist()


def test_a_part_of_a_period_may_reach_the_next_one() -> None:
    flow = bouncing()
    start = replace(flow.rest(), phase=0.4)
    stretch = advance(flow.modes, start, 1, 0.25, True)
    assert (stretch.end.periods, stretch.end.phase) == (1, pytest.approx(0.15))
    start = replace(flow.rest(), phase=0.1, periods=3)
    stretch = advance(flow.modes, start, 1, 0.25, True)
    assert (stretch.end.periods, stretch.end.phase) == (3, pytest.approx(0.35))
    stretch = advance(flow.modes, start, 2, flow.period, True)
    assert (stretch.end.periods, stretch.end.phase) == (5, pytest.approx(0.1))
    stretch = advance(flow.modes, start, 2, flow.period, True, 1)
    assert stretch.end.periods == 3
    assert 0.1 < stretch.end.phase < 0.5
