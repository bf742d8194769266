"""Integration from event to event, compiled: exact steps, the first event, resets.

A spring that relaxes behind
a slot is faster than all else, but it exerts no force. So the steps leave it out while it cannot bring
contact forward, and its stretch is known in closed form.
"""

from __future__ import annotations

import math
from collections.abc import Callable
from typing import NamedTuple

from trimmer.arrays import Integers, Reals
from trimmer.contact.compilation import sources
from trimmer.contact.statuses import (
    ARRIVED,
    AT_LIMIT,
    CONTACT_BROKEN,
    NOTHING,
    REVERSED,
    STICK_BEGUN,
)
from trimmer.contact.step_event import NO_EVENT, first_event
from trimmer.contact.tables import Tables
from trimmer.contact.work import Log, Work
from trimmer.motion.compilation import called, inlined, kept
from trimmer.motion.linear_combination import (
    combine,
    copy,
    evaluate_terms,
    within,
)
from trimmer.motion.taylor import LEVELS

REACHED_END, LOG_FULL, TO_DECIDE, CYCLING, DIVERGED, STEP_LIMIT = range(6)
"""Why the integration stopped."""
LONGEST_CASCADE = 60
"""Events at one instant, after which the integration stops."""
LARGEST = 1e150
"""Modulus of a state beyond which the motion is not followed."""
NEGLIGIBLE_STRETCH = 2.0**-56
"""Share of the gap and of the stretch at release below which the spring behind a slot counts as relaxed."""
AT_REST = 2.0**-44
"""Share of the moduli of its terms, and of its change over a step, below which a velocity is zero."""
NEAR = 2.0
"""Distance from contact, in stretches of a relaxing spring, within which it is not left out."""
OUT_OF_BOUNDS, OUT_OF_STEPS = -2, -3
"""In place of the number of an event function: why a segment ends without event."""


class Task(NamedTuple):
    """What is to be integrated: periods of one length.

    Attributes:
        length: Length of a period, s.
        keeps: Whether the log goes on over periods; otherwise it begins again with each, and when it is full.
        forcing: Entries that force the states at the start of each period, (forcing,).
        states: State after each number of periods, (periods + 1, n); the first one is not written.
        counts: Events of each period by kind, (periods, kinds), which are added to.
    """

    length: float
    keeps: bool
    forcing: Reals
    states: Reals
    counts: Integers


class Place(NamedTuple):
    """How far an integration has come.

    Attributes:
        done: Number of periods done.
        row: Number of rows in the log.
        mode: Number of the mode.
        time: Time in the period, s.
        steps_left: Number of steps that may still be taken.
        fired: The event function that has just fallen to zero, if what follows it is still to be done.
        jumped: Whether it was negative at once.
    """

    done: int
    row: int
    mode: int
    time: float
    steps_left: int
    fired: int = NO_EVENT
    jumped: bool = False


@inlined
def _step(tables: Tables, work: Work, mode: int, now: int, fraction: float) -> None:
    """Go on for a fraction of a step, a whole one if it is greater than 1."""
    state = work.state
    if fraction >= 1.0:
        copy(work.screened, state.size, state)
    elif fraction > 0.0:
        level = max(min(-math.frexp(fraction)[1] // 2, LEVELS - 1), 0)
        terms = tables.terms[now, level]
        combine(state, tables.series[now], terms * state.size, work.terms)
        evaluate_terms(work.terms, terms, fraction, state)
    if now != mode:
        duration = min(fraction, 1.0) * tables.step[now]
        for contact in range(work.margins.size):
            rate = tables.relaxation[mode, contact]
            if rate > 0.0:
                state[tables.relaxing_state[contact]] *= math.exp(-rate * duration)


@inlined
def _set_margins(tables: Tables, mode: int, work: Work) -> None:
    """Write by how much each relaxing spring could bring contact forward from now on, m."""
    for contact in range(work.margins.size):
        work.margins[contact] = 0.0
        if tables.relaxation[mode, contact] > 0.0:
            z = tables.relaxing_state[contact]
            if abs(work.state[z]) <= work.negligible[contact]:
                work.state[z] = 0.0
            work.margins[contact] = abs(work.state[z])


@inlined
def _is_near(tables: Tables, work: Work, mode: int) -> bool:
    """Return whether a relaxing spring is so close to contact that it is of no use to leave it out."""
    near = False
    for function in range(tables.function_count[mode]):
        owner = tables.owner[mode, function]
        if 0 <= owner < work.margins.size and tables.relaxation[mode, owner] > 0.0:
            distance = 0.0
            for i in range(work.state.size):
                distance += tables.taylor[mode, function, i, 0] * work.state[i]
            near |= distance <= NEAR * abs(work.state[tables.relaxing_state[owner]])
    return near


@inlined
def _follow(
    tables: Tables, work: Work, mode: int, recent: int, duration: float, most_steps: int
) -> tuple[int, bool, float, int]:
    """Follow one segment for a duration, s; ``work.state`` becomes the state at its end.

    Returns:
        The event function that ends it, or why there is none; whether it was negative at once; the time
        until then, s; the number of steps.
    """
    settled, elapsed, steps, fired, jumped = tables.settled[mode], 0.0, 0, NO_EVENT, False
    near = settled != mode and _is_near(tables, work, mode)
    while True:
        if steps >= most_steps or not within(work.state, LARGEST):
            fired = OUT_OF_STEPS if steps >= most_steps else OUT_OF_BOUNDS
            break
        steps += 1
        now, left = mode if near else settled, duration - elapsed
        if settled != mode:
            _set_margins(tables, mode, work)
        while True:
            fired, fraction, jumped, close = first_event(tables, work, mode, now, elapsed == 0.0, recent)
            if not close:
                break
            now = mode
        step = tables.step[now]
        if fired != NO_EVENT and fraction * step > left:
            fired = NO_EVENT
        if fired == NO_EVENT:
            fraction = min(left / step, 1.0)
        _step(tables, work, mode, now, fraction)
        near = near and _is_near(tables, work, mode)
        if fired == NO_EVENT and left <= step:
            elapsed = duration
            break
        elapsed += fraction * step
        if fired != NO_EVENT:
            break
    return fired, jumped, elapsed, steps


@inlined
def _begin(log: Log, row: int, time: float, mode: int, state: Reals) -> None:
    log.start[row], log.mode[row] = time, mode
    log.part[row], log.kind[row], log.function[row] = -1, NOTHING, -1
    copy(state, state.size, log.state[row])


@inlined
def _is_tabulated(tables: Tables, work: Work, mode: int, fired: int, jumped: bool) -> bool:
    """Return whether the tables say what follows an event, and no friction at rest has a say in it."""
    target, owner = tables.target[mode, fired, 1 if jumped else 0], tables.owner[mode, fired]
    action, found = tables.action[mode, fired], target >= 0
    if action == ARRIVED or (action == AT_LIMIT and jumped):
        for part in range(work.margins.size, work.known_zeros.size):
            if part != owner and work.known_zeros[part] > 0:
                found = False
        for function in range(tables.function_count[mode]):
            if function != fired and tables.action[mode, function] == ARRIVED:
                # Another friction that comes to rest at the same instant has a say as well.
                value, size = 0.0, 0.0
                for i in range(work.state.size):
                    value += tables.taylor[mode, function, i, 0] * work.state[i]
                    sizes = tables.sizes[mode, function, 0, i] + tables.sizes[mode, function, 1, i]
                    size += sizes * abs(work.state[i])
                if abs(value) <= AT_REST * size:
                    found = False
    return bool(found)


@inlined
def _counted_kind(
    tables: Tables, log: Log, row: int, mode: int, fired: int, jumped: bool, counts: Integers
) -> int:
    """Return what an event counts as; one that did not stick after all turns back, or goes on."""
    target, owner = tables.target[mode, fired, 1 if jumped else 0], tables.owner[mode, fired]
    kind = tables.kind[mode, fired, 1 if jumped else 0]
    last = row - 1
    while last > 0 and log.kind[last] == NOTHING and log.start[last] == log.start[row]:
        last -= 1
    begun = log.kind[last] == STICK_BEGUN and log.part[last] == owner
    if begun and jumped and tables.action[mode, fired] == AT_LIMIT and log.start[last] == log.start[row]:
        log.kind[last] = NOTHING
        counts[STICK_BEGUN] -= 1
        before = tables.statuses[log.mode[last - 1], owner]
        kind = NOTHING if before == tables.statuses[target, owner] else REVERSED
    return int(kind)


@inlined
def _change(
    tables: Tables, work: Work, log: Log, row: int, mode: int, event: tuple[int, bool], counts: Integers
) -> int:
    """Change the mode as the tables say, and log it in a row whose time is there; returns the new mode."""
    fired, jumped = event
    flavour = 1 if jumped else 0
    target, owner = tables.target[mode, fired, flavour], tables.owner[mode, fired]
    state, size = work.state, work.state.size
    kind = _counted_kind(tables, log, row, mode, fired, jumped, counts)
    log.mode[row], log.part[row], log.kind[row], log.function[row] = target, owner, kind, fired
    counts[kind] += 1
    combine(state, tables.hold[target], size, work.following)
    copy(work.following, size, state)
    copy(state, size, log.state[row])
    work.known_action[owner] = tables.known_action[mode, fired, flavour]
    work.known_zeros[owner] = tables.known_zeros[mode, fired, flavour]
    if kind == CONTACT_BROKEN and tables.relaxation[target, owner] > 0.0:
        stretch = abs(state[tables.relaxing_state[owner]])
        work.negligible[owner] = NEGLIGIBLE_STRETCH * (tables.gap[owner] + stretch)
    return int(target)


@inlined
def _force(tables: Tables, work: Work, mode: int, forcing: Reals) -> None:
    """Begin a period: what forces the states is known exactly, and the state is made to fit what is held."""
    state, size = work.state, work.state.size
    for i in range(forcing.size):
        state[size - forcing.size + i] = forcing[i]
    combine(state, tables.hold[mode], size, work.following)
    copy(work.following, size, state)


@inlined
def _forget(work: Work, elapsed: float) -> None:
    """Forget what was known to be zero once time has gone on."""
    if elapsed > 0.0:
        for part in range(work.known_zeros.size):
            work.known_zeros[part] = 0


@inlined
def _reason(fired: int) -> int:
    """Return why a segment was the last one, from its event function or what stands in its place."""
    reason = CYCLING
    if fired == NO_EVENT:
        reason = REACHED_END
    elif fired == OUT_OF_STEPS:
        reason = STEP_LIMIT
    elif fired == OUT_OF_BOUNDS:
        reason = DIVERGED
    return reason


@called
def _period(tables: Tables, work: Work, log: Log, place: Place, task: Task) -> tuple[int, Place]:
    """Integrate to the end of a period; ``REACHED_END`` is that of the period."""
    done, row, mode, time, steps_left, fired, jumped = place
    cascade, recent, reason = 0, -2, REACHED_END
    if fired == NO_EVENT:
        _begin(log, row, time, mode, work.state)
        row += 1
    while True:
        if fired == NO_EVENT:
            fired, jumped, elapsed, steps = _follow(
                tables, work, mode, recent, task.length - time, steps_left
            )
            time += elapsed
            steps_left -= steps
            cascade = 0 if elapsed > 0.0 else cascade + 1
            _forget(work, elapsed)
        if fired < 0 or cascade > LONGEST_CASCADE:
            reason = _reason(fired)
            break
        if not _is_tabulated(tables, work, mode, fired, jumped) or row >= log.start.size:
            reason = TO_DECIDE
            break
        log.start[row], recent = time, tables.owner[mode, fired]
        mode = _change(tables, work, log, row, mode, (fired, jumped), task.counts[done])
        row, fired = row + 1, NO_EVENT
        if row + 1 >= log.start.size and not task.keeps and log.kind[row - 1] != STICK_BEGUN:
            _begin(log, 0, time, mode, work.state)
            row = 1
    return reason, Place(done, row, mode, time, steps_left, fired, jumped)


def _entry(sources: bytes) -> Callable[..., tuple[int, Place]]:
    def entry(tables: Tables, work: Work, log: Log, place: Place, task: Task) -> tuple[int, Place]:
        sources  # noqa: B018
        reason = LOG_FULL
        while place.row + 1 < log.start.size:
            if place.time == 0.0 and place.fired == NO_EVENT:
                _force(tables, work, place.mode, task.forcing)
            reason, place = _period(tables, work, log, place, task)
            if reason != REACHED_END:
                break
            done, row, mode, time, steps_left, fired, jumped = place
            done += 1
            copy(work.state, work.state.size - task.forcing.size, task.states[done])
            if done == task.counts.shape[0]:
                place = Place(done, row, mode, time, steps_left, fired, jumped)
                break
            place = Place(done, row if task.keeps else 0, mode, 0.0, steps_left, NO_EVENT, False)
            reason = LOG_FULL
        return reason, place

    return kept(entry)


_compiled_entry = _entry(sources())


def integrate(tables: Tables, work: Work, log: Log, place: Place, task: Task) -> tuple[int, Place]:
    """Integrate the motion over periods of one length, and log its segments.

    Args:
        tables: The modes.
        work: The state and what is known to be zero, which become those at the end.
        log: Where segments are written.
        place: Where to begin.
        task: What to integrate.

    Returns:
        Why it stopped, and where. After ``TO_DECIDE`` it goes on from there once the tables say what follows
        the event and the log has room, or from a place without event once somebody else has done it.
    """
    reason, reached = _compiled_entry(tables, work, log, place, task)
    return reason, Place(*reached)
