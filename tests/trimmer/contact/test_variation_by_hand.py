"""The derivative of a motion by its start, against motions whose derivatives are known in closed form."""

from __future__ import annotations

import math

import numpy as np
import pytest
import scipy.linalg

from trimmer.contact.flow import ExactFlow
from trimmer.contact.statuses import CONTACT_MADE, REVERSED, STICK_BEGUN
from trimmer.mechanism.mechanism import Mechanism
from trimmer.mechanism.parts import Body, ContactLaw, Force, Friction, Stop

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
