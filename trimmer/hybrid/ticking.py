"""Instants of the clock in the integration: when one is due, and what it does, compiled.

Without a clock, which the compiler sees, there is nothing of it.
"""

from __future__ import annotations

from trimmer.arrays import Reals
from trimmer.hybrid.clock import DUE, TICKED, Clock, tick
from trimmer.hybrid.compilation import compiled, inlined
from trimmer.hybrid.linear_combination import copy
from trimmer.hybrid.sparse import Rows
from trimmer.hybrid.step_event import NO_EVENT
from trimmer.hybrid.tables import Tables
from trimmer.hybrid.work import Log, Work


@compiled
def time_left(
    clock: Clock | None, ticks: int, slack: float, length: float, time: float, late: float
) -> float:
    """Return how long it is until the next instant of the clock, or the end of the period, s."""
    left = (length - time) - late
    if clock is not None:  # noqa: SIM102 - by itself, so that it is not compiled without a clock.
        if ticks < clock.times.size:
            left = max(min(left, (clock.times[ticks] + slack - time) - late), 0.0)
    return left


@compiled
def _is_close(clock: Clock, mode: int, functions: int, taylor: Reals, step: float, state: Reals) -> bool:
    """Return whether an event that comes first may be so close behind that it belongs to the instant.

    Args:
        clock: The clock.
        mode: The mode.
        functions: Number of its event functions.
        taylor: Coefficients of s^k of the event functions of all modes, (modes, functions, N, K + 1).
        step: The step that these are of, s.
        state: Extended state, (N,).
    """
    found, share = False, clock.slack / step
    for function in range(functions):
        if clock.first[mode, function]:
            value = 0.0
            for i in range(state.size):
                value += (taylor[mode, function, i, 0] + share * taylor[mode, function, i, 1]) * state[i]
            found |= value < 0.0
    return found


@inlined
def due(
    tables: Tables,
    rows: Rows | None,
    clock: Clock | None,
    work: Work,
    mode: int,
    at: tuple[int, int, float],
    times: tuple[float, float],
) -> tuple[int, float, float, float]:
    """Return what has happened at the end of a segment, ``DUE`` for an instant of the clock, and when.

    Args:
        tables: The modes.
        rows: Their rows, None if their tables are there.
        clock: The clock.
        work: The state.
        mode: The mode.
        at: What ended the segment, the instants that the period has had, and how much longer than until the
            next one the segment was followed, s.
        times: The time, s, and by how much the exact one is later.

    Returns:
        That; how much longer than until the next instant the segment is to be followed first, s; and the
        times, which are those of the instant to the last digit.
    """
    fired, ticks, slack = at
    longer, (time, late) = 0.0, times
    if clock is not None:  # noqa: SIM102
        if fired == NO_EVENT and ticks < clock.times.size:
            fired = DUE
            if rows is None and slack == 0.0:
                count, step = tables.function_count[mode], tables.step[mode]
                if _is_close(clock, mode, count, tables.taylor, step, work.state):
                    fired, longer = NO_EVENT, clock.slack
            if fired == DUE and abs(clock.times[ticks] - time) < 0.5 * clock.slack:
                time, late = clock.times[ticks], 0.0
    return fired, longer, time, late


@compiled
def struck(
    tables: Tables, clock: Clock | None, work: Work, log: Log, at: tuple[int, int], keeps: bool
) -> int:
    """Do what is due in a row of the log that has begun; returns the next row.

    Args:
        tables: The modes.
        clock: The clock.
        work: The state, and what is known to be zero, of which is forgotten what jumps.
        log: The log.
        at: The row, and the instants that the period has had.
        keeps: Whether the log is kept; otherwise it begins again where it is full.
    """
    row, ticks = at
    if clock is not None:
        mode, state, owner = log.mode[row], work.state, tables.owner
        log.function[row] = TICKED - tick(clock, ticks, mode, state, work.following)
        copy(state, state.size, log.state[row])
        for function in range(tables.function_count[mode]):
            part, action = owner[mode, function], tables.action[mode, function]
            if part >= 0:
                known = work.zeros[part, action]
                work.zeros[part, action] = min(known, clock.continuous[mode, function])
        if row + 1 >= log.start.size and not keeps:
            log.start[0], log.mode[0], log.part[0] = log.start[row], mode, -1
            log.kind[0], log.function[0], log.touches[0] = 0, NO_EVENT, 0
            copy(state, state.size, log.state[0])
            row = 0
    return row + 1
