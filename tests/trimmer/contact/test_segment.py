"""One segment of a motion, in plain Python: oscillators whose events are known in closed form."""

from __future__ import annotations

import math

import numpy as np
import pytest

from tests.trimmer.contact.hand_made import STEP, tables_of, work_at
from tests.trimmer.uncompiled import uncompile
from trimmer.contact import relaxing_root, segment, step_event
from trimmer.contact.segment import LARGEST, OUT_OF_BOUNDS, OUT_OF_STEPS
from trimmer.contact.statuses import ARRIVED, MADE_MINUS, MADE_PLUS
from trimmer.contact.step_event import COUNT, NO_EVENT
from trimmer.motion import first_event as first_event_of_motion
from trimmer.motion.taylor import LEVELS, bernstein_from_taylor

OMEGA = 6.0
"""Of the oscillator, rad/s: 1.5 rad a step."""


@pytest.fixture(autouse=True)
def plain(monkeypatch: pytest.MonkeyPatch) -> None:
    uncompile(monkeypatch, segment, step_event, relaxing_root, first_event_of_motion)


def rotating():
    """Return tables of x' = omega y, y' = -omega x with the event functions x + 1/2 and 9 - y."""
    tables = tables_of([(), ()], (2, 3), (ARRIVED, ARRIVED))
    matrix = np.zeros((3, 3))
    matrix[0, 1], matrix[1, 0] = OMEGA * STEP, -OMEGA * STEP
    terms = [np.linalg.matrix_power(matrix, k) / math.factorial(k) for k in range(COUNT)]
    rows = np.array([[1.0, 0.0, 0.5], [0.0, -1.0, 9.0]])
    for mode in range(2):
        tables.screen[mode, :, :3] = sum(terms).T
        for k, term in enumerate(terms):
            tables.series[mode, :, 3 * k : 3 * k + 3] = term.T
            tables.taylor[mode, :, :, k] = rows @ term
            tables.sizes[mode, :, k] = abs(rows) @ abs(term)
        for number in range(2):
            columns = slice(3 + number * COUNT, 3 + (number + 1) * COUNT)
            tables.screen[mode, :, columns] = tables.taylor[mode, number] @ bernstein_from_taylor()[0]
    return tables


def test_it_ends_where_the_function_falls_to_zero() -> None:
    tables = rotating()
    work = work_at(tables, 0.0, 1.0, 1.0)  # x = sin(omega t) = -1/2 after 7/6 pi: three steps.
    fired, jumped, elapsed, steps = segment.follow(tables, work, 0, -2, 9.0, 100)
    assert (fired, jumped, steps) == (0, False, 3)
    assert elapsed == pytest.approx(7 / 6 * math.pi / OMEGA, rel=1e-14)
    np.testing.assert_allclose(work.state, [-0.5, -math.sqrt(0.75), 1.0], rtol=1e-13)


@pytest.mark.parametrize(("duration", "number"), [(0.1, 1), (STEP, 1), (0.6, 3), (2 * STEP, 2)])
def test_it_ends_after_its_duration(duration: float, number: int) -> None:
    tables = rotating()
    work = work_at(tables, 0.0, 1.0, 1.0)
    assert segment.follow(tables, work, 0, -2, duration, 100) == (NO_EVENT, False, duration, number)
    expected = [math.sin(OMEGA * duration), math.cos(OMEGA * duration), 1.0]
    np.testing.assert_allclose(work.state, expected, rtol=1e-13, atol=1e-14)


def test_an_event_beyond_the_duration_within_the_step_is_none() -> None:
    tables = rotating()
    instant = 7 / 6 * math.pi / OMEGA
    for share, event in ((0.999, NO_EVENT), (1.001, 0)):
        work = work_at(tables, 0.0, 1.0, 1.0)
        assert segment.follow(tables, work, 0, -2, share * instant, 100)[0] == event


def test_what_is_negative_at_once_takes_no_time() -> None:
    tables = rotating()
    work = work_at(tables, -2.0, 1.0, 1.0)
    assert segment.follow(tables, work, 0, -2, 9.0, 100) == (0, True, 0.0, 1)
    assert work.state.tolist() == [-2.0, 1.0, 1.0]


def test_steps_and_sizes_are_limited() -> None:
    tables = rotating()
    for most, expected in ((2, OUT_OF_STEPS), (3, 0), (0, OUT_OF_STEPS)):
        work = work_at(tables, 0.0, 1.0, 1.0)
        fired, _, elapsed, steps = segment.follow(tables, work, 0, -2, 9.0, most)
        assert (fired, steps) == (expected, most)
        assert most == 3 or elapsed == most * STEP
    for value in (-1.1 * LARGEST, math.nan):
        work = work_at(tables, 0.0, value, 1.0)
        assert segment.follow(tables, work, 0, -2, 9.0, 5) == (OUT_OF_BOUNDS, False, 0.0, 0)
    work = work_at(tables, 0.0, value, 1.0)
    assert segment.follow(tables, work, 0, -2, 9.0, 0)[0] == OUT_OF_STEPS


@pytest.mark.parametrize("fraction", [0.9, 0.5, 0.3, 0.25, 0.1, 0.01, 1e-5])
def test_the_level_of_a_fraction_suffices_and_its_terms_alone_are_used(fraction: float) -> None:
    tables = rotating()
    tables.terms[0] = np.arange(3, 3 + LEVELS)[::-1]
    work = work_at(tables, 0.0, 1.0, 1.0)
    segment._step(tables, work, 0, 0, fraction)
    level = next(level for level in reversed(range(LEVELS)) if fraction < 4.0**-level or level == 0)
    x, terms = OMEGA * STEP * fraction, 3 + LEVELS - 1 - level
    sine = sum((-1) ** (k // 2) * x**k / math.factorial(k) for k in range(1, terms, 2))
    assert work.state[0] == pytest.approx(sine, rel=1e-13)


@pytest.mark.parametrize(("fraction", "moved"), [(0.0, False), (1.0, True), (2.0, True)])
def test_a_whole_step_is_what_the_screen_gave(fraction: float, moved: bool) -> None:
    tables = rotating()
    work = work_at(tables, 0.0, 1.0, 1.0)
    work.screened[:3] = 7.0, 8.0, 9.0
    segment._step(tables, work, 0, 0, fraction)
    assert work.state.tolist() == ([7.0, 8.0, 9.0] if moved else [0.0, 1.0, 1.0])


def relaxing(polynomial, stretch: float, rate: float):
    """Return tables of a mode that relaxes to mode 1, with one contact that a spring brings forward."""
    tables = tables_of([(0.2, 1.0), polynomial], (0, 1), (MADE_MINUS, MADE_PLUS))
    tables.relaxing_state[1], tables.relaxation[0, 1], tables.settled[0] = 1, rate, 1
    decay = (-rate * STEP) ** np.arange(COUNT) / [float(math.factorial(k)) for k in range(COUNT)]
    tables.taylor[0, 1, 1], tables.sizes[0, 1, :, 1] = decay, abs(decay)
    tables.screen[0, :, 3 + COUNT :] = tables.taylor[0, 1] @ bernstein_from_taylor()[0]
    tables.screen[0, 1, 1] = math.exp(-rate * STEP)
    tables.series[0, 1, 1::3] = decay
    return tables, work_at(tables, 0.0, stretch, 1.0)


def test_a_spring_that_is_left_out_relaxes_in_closed_form() -> None:
    for fraction, rate in ((0.25, 16.0), (3.0, 0.5)):
        tables, work = relaxing((0.5,), 0.05, rate)
        work.screened[:3] = 0.0, 0.05, 1.0
        segment._step(tables, work, 0, 1, fraction)
        assert work.state[1] == pytest.approx(0.05 * math.exp(-rate * STEP * min(fraction, 1.0)), rel=1e-14)
    tables, work = relaxing((0.5,), 0.05, 16.0)
    segment._step(tables, work, 1, 1, 0.25)
    assert work.state[1] == 0.05


@pytest.mark.parametrize("stretch", [3e-6, -3e-6])
def test_margins_are_the_stretches_that_count(stretch: float) -> None:
    tables, work = relaxing((0.5,), stretch, 0.5)
    work.margins[:] = 7.0
    segment._set_margins(tables, 0, work)
    assert work.margins.tolist() == [0.0, 3e-6]
    work.negligible[1] = 3e-6
    segment._set_margins(tables, 0, work)
    assert (work.margins.tolist(), work.state[1]) == ([0.0, 0.0], 0.0)
    work.state[1], work.margins[:] = stretch, 7.0
    segment._set_margins(tables, 1, work)
    assert (work.margins.tolist(), work.state[1]) == ([0.0, 0.0], stretch)


@pytest.mark.parametrize(
    ("gap", "stretch", "near"), [(0.2, 0.1, False), (0.1, 0.1, True), (0.35, -0.1, False)]
)
def test_near_is_within_two_stretches_of_contact(gap: float, stretch: float, near: bool) -> None:
    tables, work = relaxing((gap, -1.0), stretch, 0.5)
    assert segment._is_near(tables, work, 0) == near
    assert not segment._is_near(tables, work, 1)
    # Contacts whose springs do not relax, and frictions, do not count.
    tables.relaxation[0] = tables.relaxation[0, ::-1]
    tables.owner[0, 0] = 2
    tables.taylor[0, 0] = 0.0
    assert not segment._is_near(tables, work, 0)
    tables.owner[0, 0], tables.relaxing_state[0] = 0, 1
    assert segment._is_near(tables, work, 0)


def test_an_event_at_the_very_end_is_one() -> None:
    tables = tables_of([(0.5, -1.0)], (2,), (ARRIVED,))
    for duration, fired in ((0.5 * STEP, 0), (np.nextafter(0.5 * STEP, 0.0), NO_EVENT)):
        found = segment.follow(tables, work_at(tables, 0.0, 0.0, 1.0), 0, -2, duration, 100)
        assert found == (fired, False, duration, 1)


@pytest.mark.parametrize(("gap", "stretch"), [(0.5, -0.05), (0.5, 0.05), (0.12, -0.1), (1.7, -0.05)])
def test_contact_is_made_where_gap_and_spring_say(gap: float, stretch: float) -> None:
    # The distance falls by one a step in both cases, and does not change with the state.
    tables, work = relaxing((gap, -1.0), stretch, 16.0)
    fired, jumped, elapsed, _ = segment.follow(tables, work, 0, -2, STEP * min(1.0, gap + 0.2), 100)
    if gap > 1:
        assert (fired, elapsed) == (NO_EVENT, STEP)
    else:
        assert (fired, jumped) == (1, False)
        spring = stretch * math.exp(-16 * elapsed)
        assert gap - elapsed / STEP + spring == pytest.approx(0.0, abs=1e-14)
        assert work.state[1] == pytest.approx(spring, rel=1e-12)


def test_a_spring_that_has_left_the_neighbourhood_of_contact_is_left_out_from_then_on() -> None:
    # Stretched by 0.1 it is less than two stretches away from contact, one short step later it is not.
    tables, work = relaxing((0.25,), -0.1, 16.0)
    tables.step[0] = STEP / 8
    assert segment._is_near(tables, work, 0)
    fired, _, elapsed, steps = segment.follow(tables, work, 0, -2, 2.125 * STEP, 100)
    assert (fired, elapsed, steps) == (NO_EVENT, 2.125 * STEP, 3)


def test_a_spring_that_may_decide_is_taken_in_although_it_was_not_near() -> None:
    # The gap closes by less than the spring can relax in the same time: the step is done with the spring.
    tables, work = relaxing((0.15, -0.28), 0.1, 12.0)
    assert not segment._is_near(tables, work, 0)
    fired, jumped, elapsed, steps = segment.follow(tables, work, 0, -2, STEP, 100)
    assert (fired, jumped, steps) == (1, False, 1)
    fraction = elapsed / STEP
    assert 0.15 - 0.28 * fraction + 0.1 * math.exp(-3 * fraction) == pytest.approx(0.0, abs=1e-13)
    assert work.state[1] == pytest.approx(0.1 * math.exp(-3 * fraction), rel=1e-12)
