"""The integration from event to event, in plain Python: a body that moves to and fro between two walls.

Its speed is one unit a step; at a wall it turns back. Modes 0 and 1 are its two directions.
"""

from __future__ import annotations

import numpy as np
import pytest

from tests.trimmer.contact.hand_made import STEP, log_of, tables_of, work_at
from tests.trimmer.uncompiled import uncompile
from trimmer.contact import integration, relaxing_root, segment, step_event, tabulated_change
from trimmer.contact.integration import (
    CYCLING,
    DIVERGED,
    LOG_FULL,
    LONGEST_CASCADE,
    REACHED_END,
    STEP_LIMIT,
    TO_DECIDE,
    Place,
    Task,
)
from trimmer.contact.statuses import BROKEN, KINDS, NOTHING, REVERSED, STICK_BEGUN
from trimmer.contact.step_event import NO_EVENT
from trimmer.contact.work import Log
from trimmer.motion import first_event as first_event_of_motion
from trimmer.motion.taylor import bernstein_from_taylor

WALL = 0.4


@pytest.fixture(autouse=True)
def plain(monkeypatch: pytest.MonkeyPatch) -> None:
    modules = (integration, segment, step_event, relaxing_root, tabulated_change, first_event_of_motion)
    uncompile(monkeypatch, *modules)


def between_walls(kind: int = REVERSED):
    """Return tables of x' = +-1 / STEP with events at x = +-WALL, each of a part of its own."""
    tables = tables_of([()], (0,), (BROKEN,))
    tables.owner[1], tables.target[0], tables.target[1] = 1, 1, 0
    tables.kind[:] = kind
    tables.known_action[:] = BROKEN
    for mode, sign in enumerate((1.0, -1.0)):
        tables.screen[mode, 2, 0] = sign
        tables.series[mode, 2, 3] = sign
        tables.taylor[mode, 0, 0, 0], tables.taylor[mode, 0, 2, :2] = -sign, (WALL, -1.0)
        tables.sizes[mode, 0, 0] = 1.0, 0.0, WALL
        tables.screen[mode, :, 3:] = tables.taylor[mode, 0] @ bernstein_from_taylor()[0]
    return tables


def run(tables, work, log, task, **place):
    given = Place(0, 0, 0, 0.0, 1000)._replace(**place)
    return integration.integrate(tables, work, log, given, task)


def task_of(periods: int, length: float, keeps: bool) -> Task:
    counts = np.zeros((periods, KINDS), dtype=np.int64)
    return Task(length, keeps, np.array([1.0]), np.full((periods + 1, 2), np.nan), counts)


def test_periods_follow_each_other_in_one_log() -> None:
    # It meets the walls after 0.4, 1.2 and 2.0 steps; a period lasts 1.5 steps.
    tables, log, task = between_walls(), log_of(9), task_of(2, 1.5 * STEP, True)
    work = work_at(tables, 0.0, 5.0, 1.0)
    reason, place = run(tables, work, log, task)
    assert reason == REACHED_END
    assert (place.done, place.row, place.mode) == (2, 6, 0)
    assert place.time == 1.5 * STEP
    assert place.fired == -1
    np.testing.assert_allclose(task.states[1:], [[-0.1, 5.0], [-0.2, 5.0]], rtol=1e-12)
    assert np.isnan(task.states[0]).all()
    assert task.counts[:, REVERSED].tolist() == [2, 2]
    assert task.counts.sum() == 4
    times = np.array([0.0, 0.4, 1.2, 0.0, 0.5, 1.3]) * STEP
    np.testing.assert_allclose(log.start[:6], times, rtol=1e-12)
    np.testing.assert_allclose(log.state[:6, 0], [0.0, 0.4, -0.4, -0.1, 0.4, -0.4], rtol=1e-12)
    assert log.mode[:6].tolist() == [0, 1, 0, 0, 1, 0]


def test_without_keeping_the_log_begins_again_with_each_period() -> None:
    tables, log, task = between_walls(), log_of(9), task_of(2, 1.5 * STEP, False)
    reason, place = run(tables, work_at(tables, 0.0, 5.0, 1.0), log, task)
    assert (reason, place.row) == (REACHED_END, 3)
    np.testing.assert_allclose(task.states[2], [-0.2, 5.0], rtol=1e-12)


@pytest.mark.parametrize("keeps", [True, False])
def test_a_log_that_is_full(keeps: bool) -> None:
    tables, log, task = between_walls(), log_of(3), task_of(1, 3.7 * STEP, keeps)
    reason, place = run(tables, work_at(tables, 0.0, 5.0, 1.0), log, task)
    if keeps:
        # The third event, after 2.0 steps, finds no row.
        assert (reason, place.row, place.fired, place.mode) == (TO_DECIDE, 3, 0, 0)
        assert place.time == pytest.approx(2.0 * STEP, rel=1e-12)
    else:
        assert (reason, place.row) == (REACHED_END, 1)
        assert log.kind[0] == NOTHING
    assert task.counts.sum() == (2 if keeps else 5)
    assert run(tables, work_at(tables, 0.0, 5.0, 1.0), log_of(1), task)[0] == LOG_FULL
    short = task_of(1, 0.1 * STEP, keeps)
    assert run(tables, work_at(tables, 0.0, 5.0, 1.0), log_of(2), short)[0] == REACHED_END


def test_a_log_that_is_not_kept_begins_again_with_the_last_event_that_had_room() -> None:
    # Events are after 0.4, 1.2, 2.0, 2.8 and 3.6 steps; the second and the fourth one take the last row.
    tables, log, task = between_walls(), log_of(4), task_of(1, 3.7 * STEP, False)
    reason, place = run(tables, work_at(tables, 0.0, 5.0, 1.0), log, task)
    assert (reason, place.row, place.mode) == (REACHED_END, 2, 1)
    np.testing.assert_allclose(log.start[:2], np.array([2.8, 3.6]) * STEP, rtol=1e-12)
    assert log.mode[:2].tolist() == [0, 1]
    assert log.part[:2].tolist() == [-1, 0]
    np.testing.assert_allclose(log.state[:2, 0], [-0.4, 0.4], rtol=1e-12)


def test_it_goes_on_with_an_event_that_was_to_be_decided() -> None:
    tables, log, task = between_walls(), log_of(9), task_of(1, 1.5 * STEP, True)
    tables.target[0] = -1
    work = work_at(tables, 0.0, 5.0, 1.0)
    reason, place = run(tables, work, log, task)
    assert (reason, place.row, place.fired, place.mode) == (TO_DECIDE, 1, 0, 0)
    assert place.steps_left == 999
    tables.target[0] = 1
    reason, place = integration.integrate(tables, work, log, place, task)
    assert (reason, place.row, place.done) == (REACHED_END, 3, 1)
    assert task.states[1, 0] == pytest.approx(-0.1, rel=1e-12)
    assert log.part[:3].tolist() == [-1, 0, 1]
    assert log.kind[:3].tolist() == [NOTHING, REVERSED, REVERSED]


def test_a_row_whose_stick_may_turn_out_to_be_none_is_not_thrown_away() -> None:
    tables, log, task = between_walls(STICK_BEGUN), log_of(3), task_of(1, 3.7 * STEP, False)
    reason, place = run(tables, work_at(tables, 0.0, 5.0, 1.0), log, task)
    assert (reason, place.row) == (TO_DECIDE, 3)


def test_what_forces_is_set_and_what_is_held_is_fitted_at_the_start_of_a_period_alone() -> None:
    tables, task = between_walls(), task_of(1, 0.1 * STEP, True)
    tables.hold[0, :, 1] = 0.0, 0.0, 3.0
    work, log = work_at(tables, 0.0, 5.0, 9.0), log_of(3)
    assert run(tables, work, log, task)[0] == REACHED_END
    assert log.state[0].tolist() == [0.0, 3.0, 1.0]
    work, log = work_at(tables, 0.0, 5.0, 1.0), log_of(3)
    assert run(tables, work, log, task, time=0.05 * STEP)[0] == REACHED_END
    assert log.state[0].tolist() == [0.0, 5.0, 1.0]
    assert work.state[0] == pytest.approx(0.05, rel=1e-12)


def test_it_says_when_it_diverges_or_has_no_steps_left() -> None:
    tables, task = between_walls(), task_of(1, 3.7 * STEP, True)
    reason, place = run(tables, work_at(tables, 0.0, 5.0, 1.0), log_of(9), task, steps_left=3)
    assert (reason, place.steps_left) == (STEP_LIMIT, 0)
    assert run(tables, work_at(tables, 0.0, 1e151, 1.0), log_of(9), task)[0] == DIVERGED


def test_events_without_end_at_one_instant_are_a_cascade() -> None:
    tables, task = between_walls(), task_of(1, 3.7 * STEP, True)
    for mode in range(2):
        tables.taylor[mode, 0], tables.sizes[mode, 0] = 0.0, 0.0
        tables.taylor[mode, 0, 2, 0], tables.sizes[mode, 0, 0, 2] = -1.0, 1.0
        tables.screen[mode, :, 3:] = tables.taylor[mode, 0] @ bernstein_from_taylor()[0]
    tables.known_zeros[:] = 0
    log = log_of(99)
    reason, place = run(tables, work_at(tables, 0.0, 5.0, 1.0), log, task)
    assert (reason, place.time) == (CYCLING, 0.0)
    assert place.row == LONGEST_CASCADE + 1


def test_events_that_time_lies_between_are_none() -> None:
    tables, task = between_walls(), task_of(1, 56.1 * STEP, True)
    reason, place = run(tables, work_at(tables, 0.0, 5.0, 1.0), log_of(99), task)
    assert (reason, place.row) == (REACHED_END, 1 + 70)
    # From the first wall on it turns back for ever.
    tables.taylor[1, 0], tables.sizes[1, 0] = 0.0, 0.0
    tables.taylor[1, 0, 2, 0], tables.sizes[1, 0, 0, 2] = -1.0, 1.0
    tables.screen[1, :, 3:] = tables.taylor[1, 0] @ bernstein_from_taylor()[0]
    tables.target[1], tables.known_zeros[:] = 1, 0
    reason, place = run(tables, work_at(tables, 0.0, 5.0, 1.0), log_of(99), task)
    assert (reason, place.row) == (CYCLING, 1 + 1 + LONGEST_CASCADE)
    assert place.time == pytest.approx(0.4 * STEP, rel=1e-14)


def test_what_is_known_to_vanish_is_forgotten_when_time_goes_on() -> None:
    tables = between_walls()
    tables.known_zeros[:] = 1
    work = work_at(tables, 0.0, 5.0, 1.0)
    work.known_zeros[:] = 3
    integration._forget(work, 0.0)
    assert work.known_zeros.tolist() == [3] * 4
    integration._forget(work, 1e-9)
    assert work.known_zeros.tolist() == [0] * 4
    run(tables, work, log_of(9), task_of(1, 1.5 * STEP, True))
    assert work.known_zeros.tolist() == [0] * 4
    assert work.known_action.tolist() == [BROKEN, BROKEN, -1, -1]


def test_the_row_that_no_event_begins_says_so() -> None:
    tables, task, log = between_walls(), task_of(1, 0.1 * STEP, True), log_of(3)
    for each in log:
        each[:] = 7
    work = work_at(tables, 0.0, 5.0, 1.0)
    assert run(tables, work, log, task, mode=1, time=0.05 * STEP)[0] == REACHED_END
    assert [each[0].tolist() for each in log] == [0.05 * STEP, 1, [0.0, 5.0, 1.0], -1, NOTHING, -1]
    place = Place(1, 2, 3, 4.0, 5)
    assert (place.fired, place.jumped) == (NO_EVENT, False)


def test_what_forces_comes_last_in_the_state() -> None:
    tables, log = between_walls(), log_of(3)
    task = task_of(1, 0.1 * STEP, True)._replace(forcing=np.array([5.5, 1.0]), states=np.zeros((2, 1)))
    assert run(tables, work_at(tables, 0.0, 9.0, 9.0), log, task)[0] == REACHED_END
    assert log.state[0].tolist() == [0.0, 5.5, 1.0]
    assert task.states[1].tolist() == pytest.approx([0.1])


def test_a_log_has_room_for_more_and_gives_its_first_rows() -> None:
    log = Log(*(np.full(shape, 7) for shape in ((2,), (2,), (2, 3), (2,), (2,), (2,))))
    assert [each.shape for each in log.doubled()] == [(4,), (4,), (4, 3), (4,), (4,), (4,)]
    assert log.doubled().start.tolist() == [7, 7, 0, 0]
    assert [each.shape for each in log.first(1)] == [(1,), (1,), (1, 3), (1,), (1,), (1,)]
    assert not np.shares_memory(log.first(1).state, log.state)
    empty = Log.empty(5, 3)
    assert [each.shape for each in empty] == [(5,), (5,), (5, 3), (5,), (5,), (5,)]
    assert all(not each.any() for each in empty)
