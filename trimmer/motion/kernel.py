"""The march from event to event, compiled: exact steps, the first event, resets."""

from __future__ import annotations

import math
from collections.abc import Callable

import numpy as np

from trimmer.motion.compiled import compiled, inlined, kept, sources
from trimmer.motion.first_event import first_event
from trimmer.motion.first_root import DEEPEST
from trimmer.motion.linear_combination import combine, copy, evaluate_terms, within
from trimmer.motion.tables import Log, Tables, Work
from trimmer.motion.taylor import DEGREE, LEVELS

REACHED_END, FULL, UNKNOWN_MODE, CYCLING, EVENT_LIMIT, DIVERGED, STEP_LIMIT = range(7)
"""Why the march stopped."""
NO_EVENT, TOO_LARGE, TOO_MANY_STEPS = -1, -2, -3
"""Instead of a guard: why a stretch ended without event."""
LONGEST_CASCADE = 40
"""Events at one instant, after which the march gives up."""
LARGEST = 1e150
"""Modulus of a state beyond which the motion is not followed; the square of it is still a number."""
MOST_STEPS = 50_000_000
"""Steps of one march: about a minute."""


def _entry(sources: bytes) -> Callable[[Tables, Log, int, float, int], tuple[int, int, float]]:
    def march(
        tables: Tables, log: Log, first: int, end: float, most_stretches: int
    ) -> tuple[int, int, float]:
        """Follow the motion from the stretch ``first`` of the log until a time, s.

        Returns:
            Reason to stop, number of the last stretch, and time reached, s. The march can go on from there,
            once the mode is tabulated or the log has more room.
        """
        sources  # noqa: B018
        return _march(tables, log, first, end, most_stretches)

    return kept(march)


@inlined
def _march(tables: Tables, log: Log, first: int, end: float, most_stretches: int) -> tuple[int, int, float]:
    work = _work(tables)
    stretch, cascade, steps_left = first, 0, MOST_STEPS
    late = 0.0  # The exact time is by so much later than the rounded time in the log.
    while True:
        mode, begin = log.mode[stretch], log.start[stretch]
        if not tables.known[mode]:
            return UNKNOWN_MODE, stretch, begin
        copy(log.state[stretch], work.state.size, work.state)
        _know_zeros(tables, log, stretch, work)
        fired, steps, fraction, jumped = _follow(tables, work, mode, (end - begin) - late, steps_left)
        elapsed = late + (steps + fraction) * tables.step[mode]
        time = begin + elapsed
        log.touches[stretch] = work.touches[0]
        if fired == NO_EVENT:
            return REACHED_END, stretch, end
        if fired < 0:
            return (DIVERGED if fired == TOO_LARGE else STEP_LIMIT), stretch, time
        if stretch + 1 >= most_stretches:
            return EVENT_LIMIT, stretch, time
        if stretch + 1 >= log.start.size:
            return FULL, stretch, begin
        cascade = cascade + 1 if time == begin else 0
        late = elapsed - (time - begin)
        steps_left -= steps
        stretch += 1
        combine(work.state, tables.reset[mode, fired], work.state.size, log.state[stretch])
        log.start[stretch] = time
        log.mode[stretch] = tables.target[mode, fired, 1 if jumped else 0]
        log.guard[stretch] = fired
        log.jumped[stretch] = jumped
        if cascade > LONGEST_CASCADE:
            return CYCLING, stretch, time


@inlined
def _follow(
    tables: Tables, work: Work, mode: int, duration: float, most_steps: int
) -> tuple[int, int, float, bool]:
    """Follow one stretch for a duration, s; ``work.state`` becomes the state at its end.

    Returns:
        Guard that ends it (or why there is none), whole steps until then, fraction of a step after them, and
        whether the guard was negative at once.
    """
    size, step = work.state.size, tables.step[mode]
    steps = 0
    work.touches[0] = 0
    while True:
        if not within(work.state, LARGEST):
            return TOO_LARGE, max(steps - 1, 0), 0.0, False
        left = duration / step - steps
        fired, fraction, jumped = first_event(tables, work, mode, steps == 0)
        for guard in range(tables.guard_count[mode]):
            work.touches[0] += work.touch[guard] < min(fraction, left)
        if fired >= 0 and fraction <= left:
            if fraction > 0.0:
                terms = tables.terms[mode, min(-math.frexp(fraction)[1] // 2, LEVELS - 1)]
                combine(work.state, tables.series[mode], terms * size, work.terms)
                evaluate_terms(work.terms, terms, fraction, work.state)
            return fired, steps, fraction, jumped
        if left <= 1.0:
            return NO_EVENT, steps, left, False
        if steps >= most_steps:
            return TOO_MANY_STEPS, steps, 0.0, False
        combine(work.state, tables.whole[mode], size, work.following)
        copy(work.following, size, work.state)
        steps += 1


@compiled
def _work(tables: Tables) -> Work:
    size, count = tables.whole.shape[1], DEGREE + 1
    guards = tables.guard_rows.shape[1]
    return Work(
        np.empty(size),
        np.empty(size),
        np.empty(size * count),
        np.empty(count),
        np.empty(count),
        np.empty(count),
        np.empty(count),
        np.empty((DEEPEST + 3, count + 2)),
        np.zeros(guards, dtype=np.int64),
        np.empty(guards),
        np.zeros(1, dtype=np.int64),
    )


@inlined
def _know_zeros(tables: Tables, log: Log, stretch: int, work: Work) -> None:
    """Write how many derivatives of each guard are known to vanish at the start of a stretch."""
    guard = log.guard[stretch]
    for each in range(work.known_zeros.size):
        work.known_zeros[each] = 0
    if guard < 0:
        return
    mode, before = log.mode[stretch], log.mode[stretch - 1]
    flavour = 1 if log.jumped[stretch] else 0
    for each in range(tables.guard_count[mode]):
        if tables.component[mode, each] == tables.component[before, guard]:
            work.known_zeros[each] = tables.zeros[before, guard, flavour, tables.number[mode, each]]


march = _entry(sources())
