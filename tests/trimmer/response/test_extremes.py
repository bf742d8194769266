"""Values of a signal at events and where it turns, of motions that are known on paper."""

from __future__ import annotations

import math
from types import SimpleNamespace

import numpy as np
import pytest
from numpy.polynomial import Polynomial

from trimmer.contact.flow import ExactFlow
from trimmer.mechanism import Body, Force, Link, Mechanism
from trimmer.response import extremes as module
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


def test_both_ends_of_each_segment_count_and_nothing_between_them(monkeypatch: pytest.MonkeyPatch) -> None:
    """Segments 1, 3 and 4 of the log last; the last has no node between its ends."""
    rows, values = np.array([1, 1, 1, 3, 3, 3, 3, 4, 4]), np.array([3.0, 9, 5, -7, -9, 8, 2, 6, 7])
    monkeypatch.setattr(module, "_points", lambda course: (np.arange(9.0), rows, values[:, None]))
    monkeypatch.setattr(module, "rate", lambda modes, signal: "rate")
    seen: list = []

    def along(course, signal, rows, states):
        seen.append((signal, rows.tolist()))
        return np.ones(len(rows)) if signal == "rate" else states[:, 0]

    monkeypatch.setattr(module, "along", along)
    found = turning_values(SimpleNamespace(modes=None), "signal")
    assert sorted(found.tolist()) == [-7.0, 2.0, 3.0, 5.0, 6.0, 7.0]
    assert seen[0] == ("rate", rows.tolist())
    assert sorted(seen[1][1]) == [1, 1, 3, 3, 4, 4]


def powers(times: np.ndarray) -> np.ndarray:
    return np.asarray(times)[:, None] ** np.arange(7)


@pytest.mark.parametrize(
    ("roots", "low", "high", "error"),
    [
        ([1.0], 0.3, 1.9, 1e-14),
        ([1.0, 3.0], 0.3, 2.9, 1e-14),
        ([-1.0, 1.0, 1.4], -0.9, 1.2, 1e-14),
        ([0.1, 1.0, 9.0], 0.11, 4.0, 1e-5),
        ([1.0, 1.0, 1.0], 0.0, 2.0, 1e-14),
        ([1.0, 1.0, 1.0], 0.0, 1.5, 1e-2),
    ],
)
def test_a_turn_is_found_between_unlike_slopes(
    monkeypatch: pytest.MonkeyPatch, roots: list, low: float, high: float, error: float
) -> None:
    """The rate of the signal has these roots, of which one, at 1, is between the times."""
    rate = Polynomial.fromroots(roots)
    signal = rate.integ() + 0.3

    def row(polynomial: Polynomial) -> np.ndarray:
        return np.pad(polynomial.coef, (0, 7 - len(polynomial.coef)))

    monkeypatch.setattr(module, "rate", lambda modes, given: given.deriv())
    monkeypatch.setattr(module, "row_of_each", lambda course, given: np.array([row(given) * 0, row(given)]))
    bracket = tuple(np.array([each]) for each in (low, high, rate(low), rate(high)))
    course = SimpleNamespace(modes=None, states=powers)
    (found,) = module._between(course, signal, np.array([1]), bracket)
    assert found == pytest.approx(signal(1.0), abs=error)
    assert bracket[0] == low
    assert bracket[1] == high
