"""Small distances from a motion, carried along its segments and over its events: compiled.

An instant at which event functions of several parts fall to zero, or several events reset the state, is left
to ``trimmer.hybrid.variation``.
"""

from __future__ import annotations

import math
from collections.abc import Callable
from typing import NamedTuple

import numpy as np

from trimmer.arrays import Integers, Reals
from trimmer.hybrid.clock import TICKED, Clock, carry, instant_of
from trimmer.hybrid.compilation import compiled, inlined, kept, merged, sources
from trimmer.hybrid.linear_combination import combine, copy, evaluate_terms, multiply
from trimmer.hybrid.system import STRUCK
from trimmer.hybrid.tables import NO_RESET, Tables
from trimmer.hybrid.tabulated_change import is_at_zero
from trimmer.hybrid.taylor import DEGREE, LEVELS
from trimmer.hybrid.work import Log

MANY_STEPS = 32
"""Whole steps from which on those of a large system are multiplied with each other, two by two."""
LARGE = 24
"""States of such a system."""
SEVERAL = -2
"""In place of the number of a reset: more than one event at an instant resets the state."""


class Room(NamedTuple):
    """Room for what is carried.

    Attributes:
        distances: Distances, (n, columns).
        flow: A flow over a fraction of a step, transposed, (n, N).
        power, other: A power of that of a step, and room for the next one, (n, n); empty in small systems.
        here, there: States before and after an event, (N,).
        before, after: Their rates, (N,).
        terms: Terms of a series, ((K + 1) N,).
    """

    distances: Reals
    flow: Reals
    power: Reals
    other: Reals
    here: Reals
    there: Reals
    before: Reals
    after: Reals
    terms: Reals


def room_for(states: int, columns: int, size: int) -> Room:
    """Return room for distances of so many states, in an extended state of some size."""
    here, there, before, after = np.empty((4, size))
    terms, square = np.empty((DEGREE + 1) * size), (states if states >= LARGE else 0,) * 2
    distances, flow = np.empty((states, columns)), np.empty((states, size))
    powers = np.empty(square), np.empty(square)
    return Room(distances, flow, *powers, here, there, before, after, terms)


@compiled
def _multiply_state(flow: Reals, state: Reals, result: Reals) -> None:
    """Write the rates of a state, (N,)."""
    for i in range(state.size):
        total = 0.0
        for j in range(state.size):
            total += flow[i, j] * state[j]
        result[i] = total


@compiled
def _multiply(transposed: Reals, distances: Reals, result: Reals) -> None:
    """Write a matrix that is given transposed times distances (n, columns)."""
    count, columns = distances.shape
    for i in range(count):
        for c in range(columns):
            result[i, c] = 0.0
    for j in range(count):
        for i in range(count):
            weight = transposed[j, i]
            if weight != 0.0:
                for c in range(columns):
                    result[i, c] += weight * distances[j, c]


@merged
def _fit(tables: Tables, mode: int, distances: Reals, room: Reals) -> None:
    """Make distances fit what a mode holds; a state that has decayed may have begun elsewhere."""
    count, columns = distances.shape
    _multiply(tables.hold[mode], distances, room)
    for part in range(tables.decaying_state.size):
        if tables.decayed[mode, part] > 0.0:
            place = tables.decaying_state[part]
            for c in range(columns):
                room[place, c] = distances[place, c]
    for i in range(count):
        for c in range(columns):
            distances[i, c] = room[i, c]


@compiled
def parted(step: float, terms: Integers, duration: float) -> tuple[int, float, int]:
    """Return how many whole steps come first in a duration, s, the fraction of one beyond, and its terms."""
    steps = max(math.ceil(duration / step) - 1, 0)
    fraction = duration / step - steps
    level = max(min(-math.frexp(fraction)[1] // 2, LEVELS - 1), 0) if fraction > 0.0 else LEVELS - 1
    return steps, fraction, terms[level]


@compiled
def fly(screen: Reals, series: Reals, parts: tuple[int, float, int], vector: Reals, room: Reals) -> None:
    """Multiply a vector, (N,), by the flow of a mode over some parts of a duration; states that decay stay.

    Args:
        screen: Table of a whole step of the mode.
        series: That of its series.
        parts: Steps, a fraction of one, and terms that do for it.
        vector: The vector.
        room: Room for the terms.
    """
    steps, fraction, terms = parts
    size = vector.size
    for _ in range(steps):
        combine(vector, screen, size, room)
        copy(room, size, vector)
    combine(vector, series, terms * size, room)
    evaluate_terms(room, terms, fraction, vector)


@compiled
def _copy(source: Reals, result: Reals) -> None:
    """Copy as much of a matrix as fits."""
    for i in range(result.shape[0]):
        for j in range(result.shape[1]):
            result[i, j] = source[i, j]


@compiled
def _by_powers(screen: Reals, steps: int, distances: Reals, room: Room) -> int:
    """Multiply distances by the flow of whole steps, in powers of two; return how many steps are left."""
    if len(distances) < LARGE or steps < MANY_STEPS:
        return steps
    _copy(screen, room.power)
    while True:
        if steps % 2:
            _multiply(room.power, distances, room.distances)
            _copy(room.distances, distances)
        steps //= 2
        if steps == 0:
            break
        multiply(room.power, room.power, 1.0, room.other)
        _copy(room.other, room.power)
    return 0


@inlined
def _go_on(tables: Tables, mode: int, duration: float, distances: Reals, room: Room) -> None:
    """Multiply distances by the flow of a mode over a duration, s.

    States that decay by themselves, or have done so, are left out of the flow.
    """
    count, columns = distances.shape
    now, other = tables.settled[mode], room.distances
    steps, fraction, terms = parted(tables.step[now], tables.terms[now], duration)
    for j in range(count):
        evaluate_terms(tables.series[now, j], terms, fraction, room.flow[j])
    steps = _by_powers(tables.screen[now], steps, distances, room)
    for k in range(steps + 1):
        _multiply(tables.screen[now] if k < steps else room.flow, distances, other)
        _copy(other, distances)
    for part in range(tables.decaying_state.size):
        rate = tables.decayed[now, part]
        if rate > 0.0:
            for c in range(columns):
                distances[tables.decaying_state[part], c] *= math.exp(-rate * duration)


@compiled
def _falls_with(tables: Tables, mode: int, fired: int, state: Reals, rates: Reals) -> bool:
    """Return whether an event function of another part falls to zero at the same instant."""
    for function in range(tables.function_count[mode]):
        if tables.owner[mode, function] != tables.owner[mode, fired]:
            falls = falling(tables.taylor[mode, function], rates) < 0.0
            if falls and is_at_zero(tables, None, mode, function, state, rates):
                return True
    return False


@merged
def met(  # noqa: PLR0913
    tables: Tables, resets: Reals | None, log: Log, row: int, last: int, fired: int, reset: int, room: Room
) -> bool:
    """Write the states and rates before and after an event; return False if it is not the only one.

    Args:
        tables: The modes.
        resets: Their resets; None if there are none, which the compiler sees.
        log: The segments of the motion.
        row: The first row at its instant.
        last: The last one.
        fired: The event function of the mode before.
        reset: Number of the reset of the state, ``NO_RESET`` for none.
        room: Where states and rates are written: of those afterwards, what they are more than before.
    """
    before, after = log.mode[row - 1], log.mode[last]
    size = room.here.size
    copy(log.state[row], size, room.here)
    _multiply_state(tables.flow[before], room.here, room.before)
    if tables.owner[before, fired] >= 0 and _falls_with(tables, before, fired, room.here, room.before):
        return False
    copy(log.state[last], size, room.there)
    _multiply_state(tables.flow[after], room.there, room.after)
    for i in range(size):
        room.after[i] -= room.before[i]
    if resets is not None:  # noqa: SIM102 - by itself, so that it is not compiled where nothing resets.
        if reset != NO_RESET:
            now, duration = tables.settled[before], log.start[row] - log.start[row - 1]
            copy(log.state[row - 1], size, room.here)
            parts = parted(tables.step[now], tables.terms[now], duration)
            fly(tables.screen[now], tables.series[now], parts, room.here, room.terms)
            _multiply_state(tables.flow[before], room.here, room.before)
            combine(room.here, resets[reset], size, room.there)
            _multiply_state(tables.flow[after], room.there, room.after)
            combine(room.before, resets[reset], size, room.terms)
            for i in range(size):
                room.after[i] -= room.terms[i]
    return True


@compiled
def falling(taylor: Reals, vector: Reals) -> float:
    """Return an event function, whose coefficients are given, (N, K + 1), of a vector, (N,)."""
    total = 0.0
    for i in range(vector.size):
        total += taylor[i, 0] * vector[i]
    return total


@merged
def _jump(resets: Reals | None, taylor: Reals, reset: int, distances: Reals, room: Room) -> None:
    """Multiply distances by the jump of an event; before a reset they decide how much later it comes."""
    count, columns = distances.shape
    slope, other = falling(taylor, room.before), room.distances
    for i in range(count):
        for c in range(columns):
            other[i, c] = distances[i, c]
    if resets is not None:  # noqa: SIM102 - by itself, so that it is not compiled where nothing resets.
        if reset != NO_RESET:
            _multiply(resets[reset], distances, other)
    for c in range(columns):
        earlier = 0.0
        if slope != 0.0:
            for i in range(count):
                earlier += taylor[i, 0] * distances[i, c]
            earlier /= slope
        for i in range(count):
            distances[i, c] = other[i, c] + room.after[i] * earlier


@inlined
def reset_at(tables: Tables, log: Log, first: int, last: int) -> int:
    """Return the number of the reset at an instant, ``NO_RESET`` for none, ``SEVERAL`` if a later one has."""
    found, others = NO_RESET, False
    for row in range(first, last + 1):
        mode, fired = log.mode[row - 1], log.function[row]
        if fired >= 0:
            reset = max(tables.reset[mode, fired, 0], tables.reset[mode, fired, 1])
            if reset != NO_RESET:
                found = SEVERAL if others else reset
            others = True
    return int(found)


@inlined
def is_decided(tables: Tables, log: Log, first: int, last: int, reset: int) -> bool:
    """Return whether a reset at an instant was decided, and is not that of the tables."""
    found = False
    for row in range(first, last + 1):
        fired = log.function[row]
        if fired >= 0 and tables.action[log.mode[row - 1], fired] == STRUCK:
            found |= reset == NO_RESET or last > first
    return found


@merged
def _sampled(
    tables: Tables, clock: Clock | None, log: Log, rows: tuple[int, int], distances: Reals, room: Room
) -> None:
    """Do with distances what the clock does: neighbours meet it, and what follows, at the same time."""
    row, last = rows
    if clock is not None:
        carry(clock, TICKED - log.function[row], log.mode[row], distances, room.distances)
        _fit(tables, log.mode[last], distances, room.distances)


def _entry(sources: bytes) -> Callable[..., int]:
    def entry(  # noqa: PLR0913
        tables: Tables,
        resets: Reals | None,
        clock: Clock | None,
        log: Log,
        end: float,
        row: int,
        distances: Reals,
        room: Room,
    ) -> int:
        sources  # noqa: B018
        rows = log.start.size
        jumped = row > 0  # What begins in a later row has jumped there already.
        if row == 0:
            _fit(tables, log.mode[0], distances, room.distances)
        while row < rows:
            following, fired = instant_of(log.start, log.function, row)
            last = following - 1  # Of the segments at one instant, the last one is that which goes on.
            if fired <= TICKED:
                _sampled(tables, clock, log, (row, last), distances, room)
            if row > 0 and fired >= 0 and not jumped:
                reset = NO_RESET
                if resets is not None:
                    reset = reset_at(tables, log, row, last)
                if is_decided(tables, log, row, last, reset):
                    break
                if reset == SEVERAL or not met(tables, resets, log, row, last, fired, reset, room):
                    break
                _jump(resets, tables.taylor[log.mode[row - 1], fired], reset, distances, room)
                _fit(tables, log.mode[last], distances, room.distances)
            until = log.start[following] if following < rows else end
            _go_on(tables, log.mode[last], until - log.start[last], distances, room)
            row, jumped = following, False
        return row

    return kept(entry)


_compiled_entry = _entry(sources())


def propagate(
    tables: Tables, clock: Clock | None, log: Log, end: float, row: int, distances: Reals, room: Room
) -> int:
    """Carry distances (n, columns), in place, to the end of a motion, or to what is not decided here.

    Args:
        tables: The modes.
        clock: What samplers do; None for nothing.
        log: The segments of the motion.
        end: Time at which it ends, s.
        row: The first row; at a later one than the first, the distances have jumped already.
        distances: The distances there.
        room: Room for more.

    Returns:
        The row of the first segment at an instant at which several parts change; the number of rows at the
        end.
    """
    resets = tables.resets if len(tables.resets) else None
    return int(_compiled_entry(tables, resets, clock, log, end, row, distances, room))
