"""The compiled integration of loops, in plain Python, on tables made by hand.

A body moves to and fro between two walls by one unit a step. Modes 0 and 1 are its two directions.
"""

from __future__ import annotations

import math

import numpy as np
import pytest

from tests.trimmer.uncompiled import uncompile
from trimmer.motion import first_event as first_event_module
from trimmer.motion import kernel, sampling
from trimmer.motion.first_event import DEEPEST, NOWHERE, ROUNDING
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
from trimmer.motion.taylor import DEGREE, LEVELS, bernstein_from_taylor

COUNT, STEP, WALL = DEGREE + 1, 0.25, 0.4
MANY = Limits(1000, 1000, 40)


@pytest.fixture(autouse=True)
def plain(monkeypatch: pytest.MonkeyPatch) -> None:
    uncompile(monkeypatch, kernel, first_event_module, sampling)


def tables_of(*rows: np.ndarray) -> Tables:
    """Return tables of two modes at rest with event functions, (n, coefficients of s^k) each, n = 2."""
    functions = len(rows)
    taylor = np.zeros((2, functions, 2, COUNT))
    for number, row in enumerate(rows):
        taylor[:, number, :, : np.shape(row)[1]] = row
    series = np.zeros((2, 2, COUNT * 2))
    series[:, :, :2] = np.eye(2)
    one = np.ones((2, functions), dtype=np.int64)
    return Tables(
        known=np.ones(2, dtype=np.bool_),
        step=np.full(2, STEP),
        whole=np.stack([np.eye(2)] * 2),
        series=series,
        terms=np.full((2, LEVELS), COUNT),
        bernstein=taylor @ bernstein_from_taylor()[0],
        taylor=taylor,
        sizes=abs(taylor),
        event_rows=taylor[..., 0],
        event_count=functions * np.ones(2, dtype=np.int64),
        component=np.tile(np.arange(functions), (2, 1)),
        number=0 * one,
        relay=-1 * one,
        held=np.zeros((2, functions), dtype=np.bool_),
        target=np.zeros((2, functions, 2), dtype=np.int64),
        zeros=-np.ones((2, functions, 2, 2), dtype=np.int64),
        continuous=9 * one,
        reset=np.tile(np.eye(2), (2, functions, 1, 1)),
        bernstein_from_taylor=bernstein_from_taylor(),
    )


def constant(*polynomials: tuple[float, ...]) -> Tables:
    """Return tables whose event functions do not depend on the state, whose second entry is one."""
    return tables_of(*(np.array([np.zeros(len(each)), each]) for each in polynomials))


def between_walls() -> Tables:
    tables = constant((WALL, -1.0))
    tables.target[0], tables.target[1] = 1, 0
    for mode, sign in enumerate((1.0, -1.0)):
        tables.whole[mode, 1, 0] = tables.series[mode, 1, 2] = sign
        tables.taylor[mode, 0, 0, 0] = -sign
        tables.sizes[mode, 0, 0, 0] = 1.0
        tables.bernstein[mode] = tables.taylor[mode] @ bernstein_from_taylor()[0]
    return tables


def log_of(rows: int, *state: float) -> Log:
    log = Log(
        np.zeros(rows),
        np.zeros(rows, dtype=np.int64),
        np.zeros((rows, 2)),
        np.full(rows, -1),
        np.zeros(rows, dtype=np.bool_),
        np.zeros(rows, dtype=np.int64),
    )
    log.state[0] = state or (0.0, 1.0)
    return log


def first(tables: Tables, *known: int, at_start: bool = True, recent: int = -1, x: float = 0.0):
    work = kernel._work(tables)
    work.state[:] = x, 1.0
    work.known_zeros[: len(known)] = known
    return (*first_event_module.first_event(tables, work, 0, at_start, recent), work.touch.tolist())


def test_the_first_event_and_what_touches_before_it() -> None:
    tables = constant((0.9, -1.0), (0.3, -1.0), (0.2, 1.0))
    fired, fraction, jumped, touch = first(tables)
    assert (fired, jumped, touch) == (1, False, [NOWHERE] * 3)
    assert fraction == pytest.approx(0.3, rel=1e-14)
    touching = constant((0.09 + 1e-16, -0.6, 1.0), (0.2, 1.0))
    fired, fraction, _, touch = first(touching)
    assert (fired, fraction) == (-1, NOWHERE)
    assert touch == [pytest.approx(0.3, abs=1e-3), NOWHERE]
    # Further away than rounding of the value: 64 * 2^-53 of 0.09.
    assert first(constant((0.09 + 2e-15, -0.6, 1.0)))[3] == [NOWHERE]


@pytest.mark.parametrize("at_start", [True, False])
def test_what_is_negative_at_once(at_start: bool) -> None:
    tables = constant((-0.1, 1.0), (-0.2,), (-0.3,))
    assert first(tables, at_start=at_start)[:3] == (0, 0.0, at_start)
    assert first(tables, at_start=at_start, recent=2)[:3] == (2, 0.0, at_start)
    # What is known to vanish counts at the start alone.
    found = first(constant((-0.1, 1.0)), 1, at_start=at_start)
    assert found[0] == (-1 if at_start else 0)


def test_what_falls_from_a_known_zero_or_stays_there() -> None:
    assert first(constant((0.0, -0.5, 1.0)), 1)[:3] == (0, 0.0, False)
    # What is known outweighs a value that is positive all over the step.
    assert first(constant((0.1, -0.05)), 1)[:3] == (0, 0.0, False)
    fired, fraction, jumped, _ = first(constant((1e-18, 0.5, -1.0)), 1)
    assert (fired, jumped, fraction) == (0, False, pytest.approx(0.5, rel=1e-14))
    staying = constant((-1e-17, 1e-17))
    staying.sizes[:, 0, 1, 0] = 1.0
    assert first(staying)[0] == -1
    assert first(constant((0.0,)))[0] == -1


def test_leading_zeros() -> None:
    sizes = np.full(COUNT, 4.0)
    sizes[1] = 20.0
    small = 3.9 * ROUNDING

    def zeros(known: int, *leading: float) -> tuple[int, list[float]]:
        taylor = np.ones(COUNT)
        taylor[: len(leading)] = leading
        return first_event_module._leading_zeros(taylor, sizes, known), taylor[: len(leading)].tolist()

    assert zeros(0, small, 1.0) == (1, [0.0, 1.0])
    assert zeros(0, -1.1 * small) == (0, [-1.1 * small])
    assert zeros(0, -small, 4.9 * small, 1.1 * small) == (2, [0.0, 0.0, 1.1 * small])
    assert zeros(2, 0.5, 0.5, 0.5) == (2, [0.0, 0.0, 0.5])
    assert zeros(0, *[0.0] * COUNT)[0] == COUNT


def test_halves_of_a_polynomial() -> None:
    # s^2 on [0, 1] is 0, 0, 1; on the halves it is 0, 0, 1/4 and 1/4, 1/2, 1.
    left, right = np.full(4, 9.0), np.full(4, 9.0)
    first_event_module.halve(np.array([0.0, 0.0, 1.0, 7.0]), 3, left, right)
    assert left.tolist() == [0.0, 0.0, 0.25, 9.0]
    assert right.tolist() == [0.25, 0.5, 1.0, 9.0]


@pytest.mark.parametrize("zero", [0.31, 0.4999, 0.5, 0.74])
def test_a_zero_is_polished_within_its_interval(zero: float) -> None:
    # (zero - s) (1 + s^2) on [0.3, 0.75]; a first guess of no use does not matter.
    taylor = np.array([zero, -1.0, zero, -1.0])
    values = np.array([zero - 0.3, 0.1, -0.1, zero - 0.75])
    for bernstein in (values, np.array([1.0, 1.0, 1.0, 1.0]), np.array([1e9, -1e-9, -1.0, -1.0])):
        found = first_event_module.polished(bernstein, taylor, 4, 0.3, 0.45)
        assert found == pytest.approx(zero, rel=4e-16)


def test_the_guess_of_a_straight_line_is_its_zero() -> None:
    # Bernstein coefficients of 2 - 5 s of degree 4 on [0, 1]: their polygon is the line.
    taylor, bernstein = np.array([2.0, -5.0, 0.0, 0.0, 0.0]), np.array([2.0, 0.75, -0.5, -1.75, -3.0])
    assert first_event_module.polished(bernstein, taylor, 5, 0.0, 1.0) == pytest.approx(0.4, rel=1e-16)
    # With a polynomial that is zero everywhere the guess itself comes back.
    assert first_event_module.polished(bernstein, 0 * taylor, 5, 0.0, 1.0) == pytest.approx(0.4, rel=1e-15)
    assert first_event_module.polished(bernstein, 0 * taylor, 5, 0.3, 0.2) == pytest.approx(0.38, rel=1e-15)


def test_touches_count_before_the_zero_alone() -> None:
    def search(polynomial: np.ndarray) -> tuple[float, float]:
        taylor = np.zeros(COUNT)
        taylor[: len(polynomial)] = polynomial
        bernstein = taylor @ bernstein_from_taylor()[0]
        return first_event_module.first_root(
            bernstein, taylor, COUNT, 1e-13, np.empty((DEEPEST + 3, COUNT + 2))
        )

    # ((s - 3/10)^2 + 1e-15) (3/4 - s) touches at 3/10 and falls at 3/4.
    touching = np.polymul([1.0, -0.6, 0.09 + 1e-15], [-1.0, 0.75])[::-1]
    root, touch = search(touching)
    assert root == pytest.approx(0.75, rel=1e-12)
    assert touch == pytest.approx(0.3, abs=2e-3)
    late = np.polymul([1.0, -1.4, 0.49 + 1e-15], [-1.0, 0.25])[::-1]
    assert search(late) == (pytest.approx(0.25, rel=1e-12), NOWHERE)
    assert search(np.array([0.0, 0.0, 1.0]) + 1e-20)[0] == NOWHERE


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
    assert kernel._rounding(0.1, 0.2, 0.1 + 0.2) == pytest.approx(-(2.0**-55), rel=1e-9)


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
