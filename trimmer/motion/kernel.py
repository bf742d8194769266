"""Integration from event to event, compiled: exact steps, the first event, resets."""

from __future__ import annotations

import math
from collections.abc import Callable

import numpy as np

from trimmer.arrays import Integers
from trimmer.hybrid.compilation import compiled, inlined, kept, sources
from trimmer.hybrid.first_root import DEEPEST
from trimmer.hybrid.linear_combination import combine, copy, evaluate_terms, within
from trimmer.hybrid.taylor import DEGREE, LEVELS
from trimmer.motion.first_event import first_event
from trimmer.motion.tables import TOGETHER, Limits, Log, Pause, Tables, Work

REACHED_END, FULL, UNKNOWN_MODE, CYCLING, EVENT_LIMIT, DIVERGED, STEP_LIMIT = range(7)
"""Reasons why the integration stopped."""
NO_EVENT = -1
"""In place of the number of an event function: a segment ended without one, because the motion did."""
TOO_LARGE = -2
"""In place of the number of an event function: the state has grown beyond ``LARGEST``."""
TOO_MANY_STEPS = -3
"""In place of the number of an event function: there are no steps left."""
LONGEST_CASCADE = 40
"""Events at one instant, after which the integration stops."""
AN_INSTANT = 2.0**-51
"""Share of the time by which two events at the same instant may differ, by rounding."""
LARGEST = 1e150
"""Modulus of a state beyond which the motion is not followed; the square of it is still a number."""
MOST_STEPS = 50_000_000
"""Steps of one integration if no number is given: about a minute."""
LARGEST_COUNT = 2**62
"""Upper limit of a number of events or steps, which must fit into 64 bits in the compiled code."""


def _entry(sources: bytes) -> Callable[..., tuple[int, int, float]]:
    def entry(
        tables: Tables,
        work: Work,
        log: Log,
        first: int,
        end: float,
        limits: Limits,
        pause: Pause,
    ) -> tuple[int, int, float]:
        sources  # noqa: B018
        return _integrate(tables, work, log, first, end, limits, pause)

    return kept(entry)


@inlined
def _integrate(
    tables: Tables, work: Work, log: Log, first: int, end: float, limits: Limits, pause: Pause
) -> tuple[int, int, float]:
    segment, cascade, steps_left = first, 0, limits.steps
    late = 0.0  # The exact time is by so much later than the rounded time in the log.
    done = 0
    while True:
        mode, begin = log.mode[segment], log.start[segment]
        if pause.valid[0]:
            done, late = pause.steps[0], pause.late[0]
        if not tables.known[mode]:
            _leave(pause, segment, 0, late, begin)
            return UNKNOWN_MODE, segment, begin
        copy(log.state[segment], work.state.size, work.state)
        recent = _know_zeros(tables, log, segment, work)
        touched = _taken_up(pause, log, segment, work)
        fired, steps, fraction, jumped, touches = _follow(
            tables, work, mode, recent, (end - begin) - late, done, done + steps_left
        )
        log.touches[segment] = touched + touches
        elapsed = late + (steps + fraction) * tables.step[mode]
        time = begin + elapsed
        if fired == NO_EVENT:
            return REACHED_END, segment, end
        if fired == TOO_MANY_STEPS:
            _leave(pause, segment, steps, late, time)
            copy(work.state, work.state.size, pause.state)
        if fired < 0:
            return (DIVERGED if fired == TOO_LARGE else STEP_LIMIT), segment, time
        if segment + 1 >= limits.segments:
            return EVENT_LIMIT, segment, time
        if segment + 1 >= log.start.size:
            _leave(pause, segment, 0, late, begin)
            return FULL, segment, begin
        cascade = cascade + 1 if time == begin else 0
        late = _rounding(begin, elapsed, time)
        steps_left -= steps - done
        done = 0
        segment += 1
        combine(work.state, tables.reset[mode, fired], work.state.size, log.state[segment])
        log.start[segment] = time
        log.mode[segment] = tables.target[mode, fired, 1 if jumped else 0]
        log.event_function[segment] = fired
        log.jumped[segment] = jumped
        if cascade > limits.cascade:
            return CYCLING, segment, time


@inlined
def _leave(pause: Pause, segment: int, steps: int, late: float, reached: float) -> None:
    """Write where the integration is to go on."""
    pause.segment[0], pause.steps[0], pause.valid[0] = segment, steps, True
    pause.late[0], pause.reached[0] = late, reached


@inlined
def _taken_up(pause: Pause, log: Log, segment: int, work: Work) -> int:
    """Go on from a pause, if there is one; return how many touches the segment had before it."""
    touches = 0
    if pause.valid[0] and pause.steps[0] > 0:
        touches = log.touches[segment]
        copy(pause.state, work.state.size, work.state)
    pause.valid[0] = False
    return touches


@compiled
def _rounding(first: float, second: float, total: float) -> float:
    """Return by how much a sum of two numbers is greater than what it was rounded to (Knuth's TwoSum)."""
    added = total - first
    return (first - (total - added)) + (second - added)


@inlined
def _follow(
    tables: Tables, work: Work, mode: int, recent: int, duration: float, done: int, most_steps: int
) -> tuple[int, int, float, bool, int]:
    """Follow one segment for a duration, s; ``work.state`` becomes the state at its end.

    ``recent`` is the component whose transition began it, ``done`` the number of steps that ``work.state`` is
    ahead of its start.

    Returns:
        The event function that ends it (or why there is none), whole steps until then, fraction of a step
        after them, whether it was negative at once, and how many times one touched zero without crossing.
    """
    state, touch, step = work.state, work.touch, tables.step[mode]
    steps, touches = done, 0
    while True:
        if not within(state, LARGEST):
            return TOO_LARGE, max(steps - 1, 0), 0.0, False, touches
        left = duration / step - steps
        fired, fraction, jumped = first_event(tables, work, mode, steps == 0, recent)
        if steps >= most_steps and left > 1.0 and (fired < 0 or fraction > left):
            return TOO_MANY_STEPS, steps, 0.0, False, touches
        for event_function in range(tables.event_count[mode]):
            touches += touch[event_function] < min(fraction, left)
        if fired >= 0 and fraction <= left:
            if fraction > 0.0:
                level = max(min(-math.frexp(fraction)[1] // 2, LEVELS - 1), 0)
                terms = tables.terms[mode, level]
                combine(state, tables.series[mode], terms * state.size, work.terms)
                evaluate_terms(work.terms, terms, fraction, state)
            return fired, steps, fraction, jumped, touches
        if left <= 1.0:
            return NO_EVENT, steps, left, False, touches
        combine(state, tables.whole[mode], state.size, work.following)
        copy(work.following, state.size, state)
        steps += 1


def _work(tables: Tables) -> Work:
    size, count = tables.whole.shape[1], DEGREE + 1
    event_functions = tables.event_rows.shape[1]
    return Work(
        np.empty(size),
        np.empty(size),
        np.empty(size * count),
        np.empty(count),
        np.empty(count),
        np.empty(count),
        np.empty((DEEPEST + 3, count + 2)),
        np.empty(event_functions, dtype=np.int64),
        np.empty(event_functions),
    )


@inlined
def _know_zeros(tables: Tables, log: Log, segment: int, work: Work) -> int:
    """Write how many derivatives of each event function are known to vanish at the start of a segment.

    What the last transition of a component makes zero is so until time goes on, as far as it does not jump
    with the outputs of others that have their transitions at the same instant. Where the modes of relays were
    decided together, the switching functions of those are zero that were held before.

    Returns:
        Number of the component of the last transition, -1 for none.
    """
    unknown, recent = -1, -1
    mode, event, known = log.mode[segment], segment, work.known_zeros
    owners, numbers, continuous = tables.component[mode], tables.number[mode], tables.continuous[mode]
    for each in range(known.size):
        known[each] = unknown
    while log.event_function[event] != NO_EVENT and segment - event < LONGEST_CASCADE:
        before, event_function = log.mode[event - 1], log.event_function[event]
        if event_function == TOGETHER:
            _know_held(tables, mode, before, known, unknown)
        else:
            zeros = tables.zeros[before, event_function, 1 if log.jumped[event] else 0]
            owner = tables.component[before, event_function]
            if event == segment:
                recent = owner
            for each in range(tables.event_count[mode]):
                if owners[each] == owner and known[each] == unknown:
                    found = zeros[numbers[each]]
                    known[each] = found if event == segment else min(found, continuous[each])
        if log.start[event] - log.start[event - 1] > AN_INSTANT * log.start[event]:
            break
        event -= 1
    for each in range(known.size):
        known[each] = max(known[each], 0)
    return recent


@inlined
def _know_held(tables: Tables, mode: int, before: int, known: Integers, unknown: int) -> None:
    """Write the known zeros after relays were decided together: one for each that was held before."""
    for each in range(tables.event_count[mode]):
        relay = tables.relay[mode, each]
        if known[each] == unknown and relay >= 0 and tables.held[before, relay]:
            known[each] = 1


_compiled_march = _entry(sources("motion"))


def integrate(
    tables: Tables, log: Log, first: int, end: float, limits: Limits, pause: Pause
) -> tuple[int, int, float]:
    """Integrate the motion from the segment ``first`` of the log until a time, s.

    Args:
        tables: The modes.
        log: Segments; those up to ``first`` are read, the others written.
        first: Number of the segment to begin with.
        end: Time at which to stop, s.
        limits: Where to stop before.
        pause: Where the integration stopped after the largest number of steps, to go on from there, or a new
            one; it is written.

    Returns:
        Reason to stop, number of the last segment, and time reached, s. The integration can go on from there,
        once the mode is tabulated, the log has more room, or steps are left.
    """
    # Of one type each, since the function is compiled for every combination of types.
    given = Limits(
        min(int(limits.segments), LARGEST_COUNT),
        min(int(limits.steps), LARGEST_COUNT),
        min(int(limits.cascade), LONGEST_CASCADE),
    )
    return _compiled_march(tables, _work(tables), log, int(first), float(end), given, pause)
