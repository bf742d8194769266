"""The compiled integration of loops, in plain Python, on tables made by hand."""

from __future__ import annotations

import math

import numpy as np
import pytest

from tests.trimmer.motion.hand_made_tables import COUNT, STEP, between_walls, constant, log_of
from tests.trimmer.uncompiled import uncompile
from trimmer.motion import first_event as first_event_module
from trimmer.motion import kernel, sampling
from trimmer.motion.kernel import (
    AN_INSTANT,
    CYCLING,
    DIVERGED,
    EVENT_LIMIT,
    FULL,
    LARGEST,
    REACHED_END,
    STEP_LIMIT,
    UNKNOWN_MODE,
)
from trimmer.motion.sampling import sample
from trimmer.motion.tables import TOGETHER, Limits, Log, Tables, new_pause
from trimmer.motion.taylor import bernstein_from_taylor

MANY = Limits(1000, 1000, 40)


@pytest.fixture(autouse=True)
def plain(monkeypatch: pytest.MonkeyPatch) -> None:
    uncompile(monkeypatch, kernel, first_event_module, sampling)


def march(tables: Tables, log: Log, end: float, limits: Limits = MANY, pause=None):
    return kernel.integrate(tables, log, 0, end, limits, new_pause(tables) if pause is None else pause)


def test_it_goes_from_wall_to_wall() -> None:
    log = log_of(9)
    assert march(between_walls(), log, 3.0 * STEP) == (REACHED_END, 4, 3.0 * STEP)
    np.testing.assert_allclose(log.start[:5], np.array([0.0, 0.4, 1.2, 2.0, 2.8]) * STEP, rtol=1e-14)
    assert log.mode[:5].tolist() == [0, 1, 0, 1, 0]
    np.testing.assert_allclose(log.state[:5, 0], [0.0, 0.4, -0.4, 0.4, -0.4], rtol=1e-13)
    assert log.event_function[:5].tolist() == [-1, 0, 0, 0, 0]
    assert not log.jumped.any()
    assert not log.touches.any()


def test_it_stops_before_each_limit_and_goes_on() -> None:
    tables = between_walls()
    for limits, expected in (
        (Limits(3, 1000, 40), (EVENT_LIMIT, 2, 2.0)),
        (Limits(4, 1000, 40), (EVENT_LIMIT, 3, 2.8)),
    ):
        reason, segment, time = march(tables, log_of(9), 3.0 * STEP, limits)
        assert (reason, segment, time) == (*expected[:2], pytest.approx(expected[2] * STEP))
    pause = new_pause(tables)
    reason, segment, time = march(tables, log_of(3), 3.0 * STEP, MANY, pause)
    assert (reason, segment) == (FULL, 2)
    assert time == pytest.approx(1.2 * STEP, rel=1e-14)
    assert (pause.valid[0], pause.segment[0], pause.steps[0]) == (True, 2, 0)
    assert pause.reached[0] == time
    tables.known[1] = False
    reason, segment, time = march(tables, log_of(9), 3.0 * STEP)
    assert (reason, segment, time) == (UNKNOWN_MODE, 1, pytest.approx(0.4 * STEP))


def test_steps_are_counted_over_segments_and_a_pause_is_taken_up() -> None:
    tables, log, pause = between_walls(), log_of(9), None
    tables.taylor[:, 0, 1, 0] = 2.4
    tables.sizes[:, 0, 1, 0] = 2.4
    tables.bernstein[:] = tables.taylor @ bernstein_from_taylor()[0]
    pause = new_pause(tables)  # The walls are at 2.4 steps now: met after 2.4 and 7.2 steps.
    reason, segment, time = march(tables, log, 9.0 * STEP, Limits(99, 4, 40), pause)
    assert (reason, segment) == (STEP_LIMIT, 1)
    assert time == pytest.approx(4.4 * STEP, rel=1e-14)
    assert (pause.valid[0], pause.segment[0], pause.steps[0]) == (True, 1, 2)
    assert pause.state.tolist() == pytest.approx([0.4, 1.0])
    found = kernel.integrate(tables, log, 1, 9.0 * STEP, Limits(99, 1000, 40), pause)
    assert found == (REACHED_END, 2, 9.0 * STEP)
    assert log.start[2] == pytest.approx(7.2 * STEP, rel=1e-14)
    assert log.state[2, 0] == pytest.approx(-2.4, rel=1e-13)
    assert not pause.valid[0]


@pytest.mark.parametrize(
    ("fraction", "level"),
    [(0.9, 0), (0.25, 0), (0.24, 1), (0.0625, 1), (0.06, 2), (0.004, 3), (1e-3, 4), (1e-9, 5)],
)
def test_an_event_takes_the_terms_of_its_fraction(fraction: float, level: int) -> None:
    tables = constant((fraction, -1.0))
    tables.series[0, 1, 0::2] = [1.0 / math.factorial(k) * (k > 0) for k in range(COUNT)]
    tables.terms[:] = 8, 7, 6, 5, 4, 3
    log = log_of(9)
    march(tables, log, 1.5 * STEP, Limits(2, 9, 40))
    assert log.start[1] == pytest.approx(fraction * STEP, rel=1e-14)
    terms = [fraction**k / math.factorial(k) for k in range(1, 8 - level)]
    assert log.state[1, 0] == pytest.approx(sum(terms), rel=1e-14)


def test_an_event_that_is_rounded_to_the_end_of_its_step_takes_all_terms(
    monkeypatch: pytest.MonkeyPatch,
) -> None:
    tables = constant((9.0,))
    tables.series[0, 1, 0::2] = [1.0 / math.factorial(k) for k in range(COUNT)]
    tables.terms[:] = 8, 7, 6, 5, 4, 3
    monkeypatch.setattr(kernel, "first_event", lambda *_: (0, 1.0, False))
    log = log_of(9)
    march(tables, log, 9.0 * STEP, Limits(2, 9, 40))
    assert log.start[1] == STEP
    assert log.state[1, 0] == pytest.approx(sum(1 / math.factorial(k) for k in range(8)), rel=1e-14)


def test_what_is_left_of_rounding_is_taken_along() -> None:
    # The first wall is met after 0.4 steps, the end is as far from there as one step of a second mode.
    tables, pause = between_walls(), new_pause(between_walls())
    tables.known[1] = False
    log = log_of(3)
    reason, segment, time = march(tables, log, 3.0 * STEP, MANY, pause)
    assert (reason, segment, pause.steps[0], pause.valid[0]) == (UNKNOWN_MODE, 1, 0, True)
    assert pause.late[0] == kernel._rounding(0.0, 0.4 * STEP, time)
    assert pause.reached[0] == time == log.start[1]
    pause.late[0] = 0.125 * STEP
    tables.known[1] = True
    # What is late is over already: the wall on the other side is met earlier by as much.
    found = kernel.integrate(tables, log, 1, 0.75 * STEP, MANY, pause)
    assert found == (REACHED_END, 1, 0.75 * STEP)
    log.touches[1], pause.valid[0], pause.steps[0], pause.late[0] = 5, True, 0, 0.0
    pause.state[:] = 7.0
    kernel.integrate(tables, log, 1, 0.75 * STEP, MANY, pause)
    assert log.touches[1] == 0


def test_touches_are_counted_with_those_before_a_pause() -> None:
    # It comes to zero, to rounding, after a third of a step without crossing, in each step anew.
    tables, log = constant((1 / 9 + 1e-16, -2 / 3, 1.0)), log_of(3)
    assert march(tables, log, 0.3 * STEP)[0] == REACHED_END
    assert log.touches[0] == 0
    assert march(tables, log, 2.9 * STEP)[0] == REACHED_END
    assert log.touches[0] == 3
    pause = new_pause(tables)
    assert march(tables, log, 2.9 * STEP, Limits(9, 1, 40), pause)[0] == STEP_LIMIT
    assert (log.touches[0], pause.steps[0]) == (1, 1)
    assert march(tables, log, 2.9 * STEP, MANY, pause)[0] == REACHED_END
    assert log.touches[0] == 3


def test_what_jumps_goes_on_in_another_mode() -> None:
    tables = constant((-1.0,))
    tables.target[0, 0] = 0, 1
    tables.bernstein[1] = tables.taylor[1] = tables.sizes[1] = 0.0
    tables.event_count[1] = 0
    log = log_of(9)
    assert march(tables, log, STEP) == (REACHED_END, 1, STEP)
    assert log.mode[:2].tolist() == [0, 1]
    assert log.jumped[:2].tolist() == [False, True]
    # Half a step later it falls to zero without a jump.
    tables = constant((0.5, -1.0))
    tables.target[0, 0] = 1, 0
    tables.event_count[1] = 0
    log = log_of(9)
    assert march(tables, log, STEP) == (REACHED_END, 1, STEP)
    assert log.mode[:2].tolist() == [0, 1]


def test_the_last_step_before_the_end_needs_no_room() -> None:
    for end, reason in ((1.0, REACHED_END), (1.1, STEP_LIMIT)):
        tables = constant((9.0,))
        assert march(tables, log_of(9), end * STEP, Limits(99, 0, 40))[0] == reason


def test_it_diverges() -> None:
    for value in (1.1 * LARGEST, -1.1 * LARGEST, math.nan):
        assert march(between_walls(), log_of(9, value, 1.0), 1.0) == (DIVERGED, 0, 0.0)
    assert march(constant((9.0,)), log_of(9, LARGEST, 1.0), 1.0)[0] == REACHED_END


def test_events_without_end_at_one_instant() -> None:
    tables = constant((-1.0,))
    reason, segment, time = march(tables, log_of(99), 1.0, Limits(99, 1000, 7))
    assert (reason, segment, time) == (CYCLING, 8, 0.0)
    assert march(tables, log_of(99), 1.0, Limits(99, 1000, 77))[1] == kernel.LONGEST_CASCADE + 1


def test_the_rounding_of_a_sum() -> None:
    total = 1.0 + 2.0**-60
    assert kernel._rounding(1.0, 2.0**-60, total) == 2.0**-60
    assert kernel._rounding(2.0**-60, 1.0, total) == 2.0**-60
    assert kernel._rounding(0.1, 0.2, 0.1 + 0.2) == pytest.approx(-(2.0**-55), rel=1e-9, abs=0.0)


def known(tables: Tables, log: Log, segment: int) -> tuple[int, list[int]]:
    work = kernel._work(tables)
    recent = kernel._know_zeros(tables, log, segment, work)
    return recent, work.known_zeros.tolist()


def two_components() -> Tables:
    """Two components with two and one event functions."""
    tables = constant((1.0,), (1.0,), (1.0,))
    tables.component[:] = 0, 0, 1
    tables.number[:] = 0, 1, 0
    tables.zeros[0, 0, 0], tables.zeros[0, 0, 1] = (1, 3), (0, 2)
    tables.zeros[0, 2, 0] = 2, -1
    return tables


def test_what_is_zero_after_an_event() -> None:
    tables, log = two_components(), log_of(5)
    assert known(tables, log, 0) == (-1, [0, 0, 0])
    log.start[1:] = 0.5, 0.7, 0.7, 0.9
    log.event_function[1:] = 0, 2, 0, 2
    assert known(tables, log, 1) == (0, [1, 3, 0])
    log.jumped[1] = True
    assert known(tables, log, 1) == (0, [0, 2, 0])
    assert known(tables, log, 2) == (1, [0, 0, 2])
    # Two at one instant: the earlier one counts as far as no output jumps.
    assert known(tables, log, 3) == (0, [1, 3, 2])
    tables.continuous[0, 2] = 1
    assert known(tables, log, 3) == (0, [1, 3, 1])
    # Two transitions of one component: the last one tells.
    log.event_function[2], log.jumped[3] = 0, True
    assert known(tables, log, 3) == (0, [0, 2, 0])
    log.start[3] = 0.7 * (1 + 1.9 * AN_INSTANT)
    log.event_function[2] = 2
    assert known(tables, log, 3) == (0, [0, 2, 0])


def test_relays_that_were_decided_together() -> None:
    tables, log = two_components(), log_of(3)
    tables.relay[0] = -1, 1, 0
    log.event_function[1:] = 0, TOGETHER
    log.start[1:] = 0.5, 0.5
    log.mode[:] = 0, 1, 0
    tables.held[1, :2] = False, True
    assert known(tables, log, 2) == (-1, [1, 1, 0])
    tables.held[1, :2] = True, False
    assert known(tables, log, 2) == (-1, [1, 3, 1])
    log.start[2] = 0.6
    assert known(tables, log, 2) == (-1, [0, 0, 1])


def test_values_along_a_motion() -> None:
    tables, log = between_walls(), log_of(9)
    march(tables, log, 3.0 * STEP)
    log = Log(*(each[:5] for each in log))
    tables.step[1] *= 2
    # Rows x + 3 and 5 in either mode; times in the second mode are half as fast then.
    functionals = np.zeros((2, 2, 2 * COUNT))
    for mode, sign in enumerate((1.0, -1.0)):
        functionals[mode, 0, 0], functionals[mode, 1, :2], functionals[mode, 1, COUNT] = 1.0, (3.0, sign), 5.0
    log.start[2:] += 0.8 * STEP
    times = np.array([0.0, 0.2, 0.4, 0.6, 1.9, 2.0, 2.1, 9.5]) * STEP
    values = np.full((2, len(times)), np.nan)
    sample(tables, log, np.array([0, 1]), functionals, times, values)
    x = [0.0, 0.2, 0.4, 0.3, -0.35, -0.4, -0.3, -0.4 + 9.5 - 3.6]
    np.testing.assert_allclose(values[0], 3.0 + np.array(x), rtol=1e-12)
    assert values[1].tolist() == [5.0] * len(times)
