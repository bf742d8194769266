"""The march from event to event, compiled: exact steps, the first event, resets."""

from __future__ import annotations

import numba
import numpy as np

from trimmer.motion.first_event import first_event
from trimmer.motion.linear_combination import combine, evaluate_terms
from trimmer.motion.tables import Log, Tables, Work

REACHED_END, FULL, UNKNOWN_MODE, CYCLING, EVENT_LIMIT = range(5)
"""Why the march stopped."""
LONGEST_CASCADE = 40
"""Events at one instant, after which the march gives up."""


@numba.njit(cache=True)
def march(tables: Tables, log: Log, first: int, end: float, most_stretches: int) -> tuple[int, int, float]:
    """Follow the motion from the stretch ``first`` of the log until a time, s.

    Returns:
        Reason to stop, number of the last stretch, and time reached, s. The march can go on from there, once
        the mode is tabulated or the log has more room.
    """
    work = _work(tables)
    stretch, cascade = first, 0
    while True:
        mode, begin = log.mode[stretch], log.start[stretch]
        if not tables.known[mode]:
            return UNKNOWN_MODE, stretch, begin
        work.state[:] = log.state[stretch]
        _know_zeros(tables, log, stretch, work)
        fired, time, jumped, touches = _follow(tables, work, mode, begin, end)
        log.touches[stretch] = touches
        if fired < 0:
            return REACHED_END, stretch, end
        if stretch + 1 >= most_stretches:
            return EVENT_LIMIT, stretch, time
        if stretch + 1 >= log.start.size:
            return FULL, stretch, begin
        cascade = cascade + 1 if time == begin else 0
        stretch += 1
        combine(work.state, tables.reset[mode, fired], log.state[stretch])
        log.start[stretch] = time
        log.mode[stretch] = tables.target[mode, fired, 1 if jumped else 0]
        log.guard[stretch] = fired
        log.jumped[stretch] = jumped
        if cascade > LONGEST_CASCADE:
            return CYCLING, stretch, time


@numba.njit(cache=True)
def _follow(tables: Tables, work: Work, mode: int, begin: float, end: float) -> tuple[int, float, bool, int]:
    """Follow one stretch; ``work.state`` becomes the state at its end.

    Returns:
        Guard that ends it (-1: the end of time), its time, whether it was negative at once, and touches.
    """
    count, step = tables.deflation.shape[1], tables.step[mode]
    steps, touches = 0, 0
    while True:
        left = (end - begin) / step - steps
        fired, fraction, jumped, near = first_event(tables, work, mode, steps == 0)
        touches += near
        if fired >= 0 and fraction <= left:
            if fraction > 0.0:
                combine(work.state, tables.series[mode], work.terms)
                evaluate_terms(work.terms, count, fraction, work.following)
                work.state[:] = work.following
            return fired, begin + (steps + fraction) * step, jumped, touches
        if left <= 1.0:
            return -1, end, False, touches
        combine(work.state, tables.whole[mode], work.following)
        work.state[:] = work.following
        steps += 1


@numba.njit(cache=True)
def _work(tables: Tables) -> Work:
    size, count = tables.whole.shape[1], tables.deflation.shape[1]
    guards = tables.guard_rows.shape[1]
    return Work(
        np.empty(size),
        np.empty(size),
        np.empty(size * count),
        np.empty(guards * count),
        np.empty(count),
        np.empty(count),
        np.zeros(guards, dtype=np.int64),
    )


@numba.njit(cache=True)
def _know_zeros(tables: Tables, log: Log, stretch: int, work: Work) -> None:
    """Write how many derivatives of each guard are known to vanish at the start of a stretch."""
    work.known_zeros[:] = 0
    guard = log.guard[stretch]
    if guard < 0:
        return
    mode, before = log.mode[stretch], log.mode[stretch - 1]
    flavour = 1 if log.jumped[stretch] else 0
    for each in range(tables.guard_count[mode]):
        if tables.component[mode, each] == tables.component[before, guard]:
            work.known_zeros[each] = tables.zeros[before, guard, flavour, tables.number[mode, each]]
