"""Values of a signal at events and where it turns, of motions that are known on paper."""

from __future__ import annotations

import math

import numpy as np
import pytest

from trimmer.contact.flow import ExactFlow
from trimmer.mechanism import Body, Force, Link, Mechanism
from trimmer.response.extremes import extremes, turning_values
from trimmer.response.motion_signals import acceleration, steady

OMEGA, PLACE, VELOCITY = 5.0, 0.3, 2.0
FORCES = {"none": Force("one", constant=0.0), "as little": Force("two", constant=0.0)}
AMPLITUDE = math.hypot(PLACE, VELOCITY / OMEGA)


def row_of(flow: ExactFlow, state: int) -> np.ndarray:
    return np.eye(flow.modes.layout.size)[state]


def test_a_signal_that_never_turns_has_its_extremes_at_the_ends() -> None:
    flow = ExactFlow(Mechanism({"one": Body(2.0), "two": Body(3.0)}, forces=FORCES))
    course = flow.timed(flow.rest({"one": (0.3, 2.0), "two": (0.5, -4.0)}), 1.7)
    for body, expected in ((0, [0.3, 3.7]), (1, [0.5, -6.3])):
        values = turning_values(course, steady(row_of(flow, body)))
        assert values == pytest.approx(expected, rel=1e-12)
        assert extremes(course, steady(row_of(flow, body))) == pytest.approx(sorted(expected))


def test_a_swing_has_its_amplitude_where_it_turns() -> None:
    flow = ExactFlow(Mechanism({"body": Body(2.0)}, links={"spring": Link(("ground", "body"), 50.0)}))
    course = flow.timed(flow.rest({"body": (PLACE, VELOCITY)}), 2.0)
    phase, end = math.atan2(VELOCITY, PLACE * OMEGA), OMEGA * 2.0
    last = PLACE * math.cos(end) + VELOCITY / OMEGA * math.sin(end)
    # It turns at (phase + n pi) / omega; up to 10 rad that is four times, the first at the top.
    turns = [AMPLITUDE * (-1) ** n for n in range(4) if phase + n * math.pi < end]
    assert turning_values(course, steady(row_of(flow, 0))) == pytest.approx([PLACE, last, *turns], rel=1e-11)
    low, high = extremes(course, acceleration(flow.modes, 0))
    assert (low, high) == pytest.approx((-(OMEGA**2) * AMPLITUDE, OMEGA**2 * AMPLITUDE), rel=1e-11)
