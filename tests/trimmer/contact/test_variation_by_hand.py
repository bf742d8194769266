"""The derivative of a motion by its start, against motions whose derivatives are known in closed form."""

from __future__ import annotations

import math
from dataclasses import replace

import numpy as np
import pytest
import scipy.linalg

from trimmer.contact.flow import ExactFlow
from trimmer.contact.statuses import CONTACT_MADE, FREE, PLUS, REVERSED, STICK_BEGUN
from trimmer.mechanism.mechanism import Mechanism
from trimmer.mechanism.parts import Body, ContactLaw, Force, Friction, Link, Pin, Stop

BETWEEN = ("ground", "body")


def test_a_wall_with_a_damper_turns_distances() -> None:
    # A body of 2 kg flies 0.5 m at 0.7 m/s; from then on 2 v' = -40 (q - 0.5) - 3 v.
    wall = Stop(BETWEEN, 40.0, 3.0, 0.5, ContactLaw.TRUNCATED)
    flow = ExactFlow(Mechanism({"body": Body(2.0)}, stops={"wall": wall}, start={"body": (0.0, 0.7)}))
    flight, contact = 0.5 / 0.7, 0.05
    course = flow.timed(flow.rest(), flight + contact)
    assert [kind for *_, kind in course.events] == [CONTACT_MADE]
    # The force jumps by -3 v, and a body that is ahead by d arrives earlier by d / v.
    jump = np.array([[1.0, 0.0], [-3.0 / 2.0, 1.0]])
    pressed = scipy.linalg.expm(np.array([[0.0, 1.0], [-20.0, -1.5]]) * contact)
    expected = pressed @ jump @ np.array([[1.0, flight], [0.0, 1.0]])
    np.testing.assert_allclose(course.monodromy, expected, rtol=1e-11)
    directions = np.array([[2.0, -1.0, 0.0], [0.5, 3.0, 7.0]])
    np.testing.assert_allclose(course.tangents(directions), expected @ directions, rtol=1e-11)


def test_a_body_that_comes_to_rest_forgets_its_speed() -> None:
    # It slides for v^2 m / (2 F) and stays there.
    friction = {"floor": Friction(BETWEEN, 0.3)}
    flow = ExactFlow(Mechanism({"body": Body(2.0)}, frictions=friction, start={"body": (0.1, 0.6)}))
    course = flow.timed(flow.rest(), 5.0)
    assert [(kind, part) for _, part, kind in course.events] == [(STICK_BEGUN, 0)]
    assert course.events[0][0] == pytest.approx(4.0, rel=1e-13)
    assert course.end.state == pytest.approx([0.1 + 1.2, 0.0], rel=1e-13, abs=1e-15)
    np.testing.assert_allclose(course.monodromy, [[1.0, 4.0], [0.0, 0.0]], rtol=1e-12, atol=1e-13)


def test_a_body_that_is_pushed_back() -> None:
    # It is slowed down at 2.5 m/s^2 and then accelerated at 1.5 m/s^2 the other way.
    speed, duration = 1.1, 0.9
    flow = ExactFlow(
        Mechanism(
            {"body": Body(1.0)},
            frictions={"floor": Friction(BETWEEN, 0.5)},
            forces={"push": Force("body", -2.0)},
            start={"body": (0.0, speed)},
        )
    )
    course = flow.timed(flow.rest(), duration)
    turn = speed / 2.5
    assert [kind for *_, kind in course.events] == [REVERSED]
    assert course.events[0][0] == pytest.approx(turn, rel=1e-13)
    back = duration - turn
    assert course.end.state == pytest.approx([speed**2 / 5 - 0.75 * back**2, -1.5 * back], rel=1e-12)
    expected = [[1.0, 2 * speed / 5 + 1.5 * back / 2.5], [0.0, 1.5 / 2.5]]
    np.testing.assert_allclose(course.monodromy, expected, rtol=1e-12, atol=1e-14)


def test_a_stretch_that_relaxes_in_flight_dies_out_by_itself() -> None:
    # The stop is 9 m away; its spring of 40 N/m relaxes at 40/3 per second.
    flow = ExactFlow(Mechanism({"body": Body(2.0)}, stops={"wall": Stop(BETWEEN, 40.0, 3.0, 9.0)}))
    for stretch in (0.0, 0.01):
        course = flow.timed(flow.at(np.array([0.0, 0.3, stretch])), 0.25)
        expected = [[1.0, 0.25, 0.0], [0.0, 1.0, 0.0], [0.0, 0.0, math.exp(-10 / 3)]]
        np.testing.assert_allclose(course.monodromy, expected, rtol=1e-12, atol=1e-15)
        assert course.end.state == pytest.approx([0.075, 0.3, stretch * math.exp(-10 / 3)], rel=1e-12)


def oscillator(**parts) -> ExactFlow:
    """2 kg on a spring of 8 N/m with a damper: q'' = -4 q - 0.3 q'."""
    links = {"spring": Link(BETWEEN, 8.0, 0.6), **parts.pop("links", {})}
    return ExactFlow(Mechanism({"body": Body(2.0)}, links=links, start={"body": (0.2, -0.1)}, **parts))


SWINGING = np.array([[0.0, 1.0], [-4.0, -0.3]])


@pytest.mark.parametrize("share", [0.97, 1.0, 6.96, 7.0, 7.04])
def test_over_many_steps_it_is_the_flow(share: float) -> None:
    flow = oscillator()
    duration = share * float(flow.modes.tables.step[flow.modes.number(flow.rest().statuses)])
    monodromy = flow.timed(flow.rest(), duration).monodromy
    np.testing.assert_allclose(monodromy, scipy.linalg.expm(SWINGING * duration), rtol=0, atol=1e-13)


def test_a_new_period_is_no_event() -> None:
    flow = oscillator(
        frequency=0.8, pins={"base": Pin("ground", 1.0)}, links={"drive": Link(("base", "body"), 1e-3)}
    )
    course = flow.course(flow.rest(), 3)
    assert course.log.start.tolist() == pytest.approx([0.0, 1.25, 2.5])
    expected = scipy.linalg.expm((SWINGING - [[0.0, 0.0], [5e-4, 0.0]]) * 3.75)
    np.testing.assert_allclose(course.monodromy, expected, rtol=1e-12)


def test_what_happens_at_the_start_turns_nothing() -> None:
    # It is said to be free 0.1 m behind a wall, so contact is made at once.
    wall = Stop(BETWEEN, 40.0, 3.0, 0.5, ContactLaw.TRUNCATED)
    flow = ExactFlow(Mechanism({"body": Body(2.0)}, stops={"wall": wall}, start={"body": (0.6, 0.7)}))
    course = flow.timed(replace(flow.rest(), statuses=(FREE,)), 0.02)
    assert course.log.start.tolist() == [0.0, 0.0]
    assert course.end.statuses == (PLUS,)
    expected = scipy.linalg.expm(np.array([[0.0, 1.0], [-20.0, -1.5]]) * 0.02)
    np.testing.assert_allclose(course.monodromy, expected, rtol=1e-13)


def test_two_walls_that_are_met_at_one_instant_turn_distances_once() -> None:
    first, second = (
        Stop(BETWEEN, stiffness, damping, 0.5, ContactLaw.TRUNCATED)
        for stiffness, damping in ((40.0, 3.0), (10.0, 0.5))
    )
    mechanism = Mechanism(
        {"body": Body(2.0)}, stops={"first": first, "second": second}, start={"body": (0.0, 0.7)}
    )
    flow = ExactFlow(mechanism)
    flight, contact = 0.5 / 0.7, 0.05
    course = flow.timed(flow.rest(), flight + contact)
    assert [(part, kind) for _, part, kind in course.events] == [(0, CONTACT_MADE), (1, CONTACT_MADE)]
    assert course.log.start[1] == course.log.start[2]
    pressed = scipy.linalg.expm(np.array([[0.0, 1.0], [-25.0, -1.75]]) * contact)
    expected = pressed @ [[1.0, 0.0], [-1.75, 1.0]] @ [[1.0, flight], [0.0, 1.0]]
    np.testing.assert_allclose(course.monodromy, expected, rtol=1e-11)


def test_contact_gives_a_relaxing_spring_its_length() -> None:
    # The first stop is far and has no state; the spring of the second one is the third state.
    stops = {
        "far": Stop(BETWEEN, 1.0, 1.0, 90.0, ContactLaw.TRUNCATED),
        "wall": Stop(BETWEEN, 40.0, 3.0, 0.5, ContactLaw.RELAXING),
    }
    flow = ExactFlow(Mechanism({"body": Body(2.0)}, stops=stops, start={"body": (0.0, 0.7)}))
    flight, contact = 0.5 / 0.7, 0.05
    course = flow.timed(flow.rest(), flight + contact)
    pressed = scipy.linalg.expm(np.array([[0.0, 1.0], [-20.0, -1.5]]) * contact)
    expected = np.zeros((3, 3))
    expected[:2, :2] = pressed @ [[1.0, 0.0], [-1.5, 1.0]] @ [[1.0, flight], [0.0, 1.0]]
    expected[2] = expected[0]
    np.testing.assert_allclose(course.monodromy, expected, rtol=1e-11, atol=1e-13)
    # From a start in contact it has the length at once; free and relaxed it keeps what it has.
    pressed_from = flow.timed(flow.rest({"body": (0.6, 0.0)}), contact).monodromy
    np.testing.assert_allclose(pressed_from[:2, :2], pressed, rtol=1e-12)
    np.testing.assert_allclose(pressed_from[2], pressed_from[0], rtol=1e-12)
    free = flow.timed(flow.rest(), 0.1).monodromy
    assert free[2].tolist() == pytest.approx([0.0, 0.0, math.exp(-4 / 3)], rel=1e-13)
