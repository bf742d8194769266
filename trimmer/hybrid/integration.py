"""Integration from event to event over periods of one length, compiled."""

from __future__ import annotations

from collections.abc import Callable
from typing import NamedTuple

from trimmer.arrays import Integers, Reals
from trimmer.hybrid.clock import DUE, Clock
from trimmer.hybrid.compilation import compiled, inlined, kept, sources
from trimmer.hybrid.linear_combination import copy
from trimmer.hybrid.segment import OUT_OF_BOUNDS, OUT_OF_STEPS, follow, rounding
from trimmer.hybrid.sparse import Rows, hold
from trimmer.hybrid.step_event import NO_EVENT
from trimmer.hybrid.system import HOLD_BEGUN, NOTHING
from trimmer.hybrid.tables import Tables
from trimmer.hybrid.tabulated_change import change, is_tabulated
from trimmer.hybrid.ticking import due, struck, time_left
from trimmer.hybrid.work import Log, Work

REACHED_END, LOG_FULL, TO_DECIDE, CYCLING, DIVERGED, STEP_LIMIT, GOES_ON = range(7)
"""Why the integration stopped, or that it goes on."""
PERIOD_BEGUN = -2
"""In place of the event function that began a segment: a period."""
NOBODY = -2
"""In place of the part that had the last event; ``JOINTLY`` is another."""
LONGEST_CASCADE = 60
"""Events at one instant, after which the integration stops."""


class Task(NamedTuple):
    """What is to be integrated: periods of one length.

    Attributes:
        length: Length of a period, s.
        exact: Whether it is followed what times lose in rounding, for periods of many events.
        keeps: Whether the log goes on over periods; otherwise it begins again with each, and when it is full.
        forcing: Entries that force the states at the start of each period, (forcing,).
        states: State after each number of periods, (periods + 1, n); the first one is not written.
        counts: Events of each period by kind, (periods, kinds), which are added to.
        reached: Where the integration stopped, for who loses its answer in an interrupt: periods done, rows,
            mode, time in the period, s, and by how much the exact time is later, s, (5,).
    """

    length: float
    exact: bool
    keeps: bool
    forcing: Reals
    states: Reals
    counts: Integers
    reached: Reals


class Place(NamedTuple):
    """How far an integration has come.

    Attributes:
        done: Number of periods done.
        row: Number of rows in the log.
        mode: Number of the mode.
        time: Time in the period, s.
        steps_left: Number of steps that may still be taken.
        fired: The event function that has just fallen to zero, if what follows it is still to be done;
            ``OUT_OF_STEPS`` within a segment, ``DUE`` at an instant of the clock.
        jumped: Whether it was negative at once.
        ticks: Instants of the clock that the period has had.
    """

    done: int
    row: int
    mode: int
    time: float
    steps_left: int
    fired: int = NO_EVENT
    jumped: bool = False
    ticks: int = 0


_Reached = tuple[int, int, int, float, int, int, bool, int]
"""A ``Place`` without its name."""


@compiled
def _begin(log: Log, row: int, time: float, mode: int, state: Reals) -> None:
    """Begin a segment that no event begins."""
    log.start[row], log.mode[row] = time, mode
    log.part[row], log.kind[row] = -1, NOTHING
    log.function[row], log.touches[row] = PERIOD_BEGUN if time == 0.0 else NO_EVENT, 0
    copy(state, state.size, log.state[row])


@inlined
def _force(dense: Reals, rows: Rows | None, mode: int, forcing: Reals, state: Reals, room: Reals) -> None:
    """Begin a period: what forces the states is known exactly, and the state is made to fit what is held."""
    for i in range(forcing.size):
        state[state.size - forcing.size + i] = forcing[i]
    hold(dense, rows, mode, state, room)


@inlined
def _forget(elapsed: float, zeros: Integers) -> None:
    """Forget what was known to be zero once time has gone on."""
    if elapsed > 0.0:
        for part in range(zeros.shape[0]):
            for action in range(zeros.shape[1]):
                zeros[part, action] = 0


@inlined
def _reason(
    tables: Tables,
    rows: Rows | None,
    work: Work,
    mode: int,
    event: tuple[int, bool],
    cascade: int,
    full: bool,
) -> int:
    """Return why the integration is to stop before an event is heeded, ``GOES_ON`` if it is not."""
    (fired, jumped), reason = event, GOES_ON
    if fired == OUT_OF_STEPS:
        reason = STEP_LIMIT
    elif fired == OUT_OF_BOUNDS:
        reason = DIVERGED
    elif cascade > LONGEST_CASCADE:
        reason = CYCLING
    elif full or not is_tabulated(tables, rows, work, mode, fired, jumped):
        reason = TO_DECIDE
    return reason


@inlined
def _later(time: float, elapsed: float, late: float, exact: bool) -> tuple[float, float]:
    """Return a later time, and by how much the exact one is later than that, as far as it is followed."""
    longer = elapsed + late if exact else elapsed
    later = time + longer
    return later, rounding(time, longer, later) if exact else 0.0


@inlined
def _note(reached: Reals, done: int, row: int, mode: int, time: float, late: float) -> None:
    reached[0], reached[1], reached[2], reached[3], reached[4] = done, row, mode, time, late


def _entry(sources: bytes) -> Callable[..., tuple[int, _Reached]]:  # noqa: C901, PLR0915
    # One function and not two within each other: of those that are compiled into another each is copied.
    def entry(  # noqa: C901, PLR0915
        tables: Tables, rows: Rows | None, clock: Clock | None, work: Work, log: Log, place: Place, task: Task
    ) -> tuple[int, _Reached]:
        sources  # noqa: B018
        done, row, mode, time, steps_left, fired, jumped, ticks = place
        cascade, recent, begun, slack = 0, NOBODY, fired != NO_EVENT, 0.0
        late = task.reached[4]  # The exact time is by so much later than the rounded one.
        fired = NO_EVENT if fired == OUT_OF_STEPS else fired
        reason = LOG_FULL
        while begun or row + 1 < log.start.size:
            if not begun:
                if time == 0.0:
                    _force(tables.hold[mode], rows, mode, task.forcing, work.state, work.following)
                _begin(log, row, time, mode, work.state)
                row, cascade, recent, begun = row + 1, 0, NOBODY, True
            if fired == NO_EVENT:
                left = time_left(clock, ticks, slack, task.length, time, late)
                fired, jumped, elapsed, lost, steps, touches = follow(
                    tables, rows, work, mode, recent, left, steps_left
                )
                log.touches[row - 1] += touches
                before, steps_left = time, steps_left - steps
                time, late = _later(before, elapsed, lost + late, task.exact)
                cascade = 0 if time > before else cascade + 1
                _forget(elapsed, work.zeros)
                at = (fired, ticks, slack)
                fired, slack, time, late = due(tables, rows, clock, work, mode, at, (time, late))
                if slack > 0.0:
                    continue
            if fired == DUE and row < log.start.size:
                _begin(log, row, time, mode, work.state)
                row = struck(tables, clock, work, log, (row, ticks), task.keeps)
                ticks, fired, cascade, recent = ticks + 1, NO_EVENT, 0, NOBODY
                continue
            if fired == NO_EVENT:
                done, ticks = done + 1, 0
                copy(work.state, work.state.size - task.forcing.size, task.states[done])
                if done == task.counts.shape[0]:
                    reason = REACHED_END
                    break
                row, time, late, begun = row if task.keeps else 0, 0.0, 0.0, False
                reason = LOG_FULL
                continue
            full = row >= log.start.size
            reason = _reason(tables, rows, work, mode, (fired, jumped), cascade, full)
            if reason != GOES_ON:
                break
            log.start[row], recent = time, tables.owner[mode, fired]
            mode = change(tables, rows, work, log, row, mode, (fired, jumped), task.counts[done])
            row, fired = row + 1, NO_EVENT
            if row + 1 >= log.start.size and not task.keeps and log.kind[row - 1] != HOLD_BEGUN:
                _begin(log, 0, time, mode, work.state)
                row = 1
        _note(task.reached, done, row, mode, time, late)
        # A plain tuple: making a named one runs Python, in which an interrupt would find nobody to take it.
        return reason, (done, row, mode, time, steps_left, fired, jumped, ticks)

    return kept(entry)


_compiled_entry = _entry(sources())


def integrate(
    tables: Tables, clock: Clock | None, work: Work, log: Log, place: Place, task: Task
) -> tuple[int, Place]:
    """Integrate the motion over periods of one length, and log its segments.

    Args:
        tables: The modes.
        clock: What is due in each period at known times; None for nothing.
        work: The state and what is known to be zero, which become those at the end.
        log: Where segments are written.
        place: Where to begin.
        task: What to integrate.

    Returns:
        Why it stopped, and where. After ``TO_DECIDE`` it goes on from there once the tables say what follows
        the event and the log has room, or from a place without event once somebody else has done it.
    """
    reason, reached = _compiled_entry(tables, tables.rows, clock, work, log, place, task)
    return reason, Place(*reached)
