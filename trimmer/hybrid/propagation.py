"""Small distances from a motion, carried along its segments and over its events: compiled.

An instant at which event functions of several parts fall to zero, or an event resets the state, is left to
``trimmer.hybrid.variation``.
"""

from __future__ import annotations

import math
from collections.abc import Callable
from typing import NamedTuple

from trimmer.arrays import Reals
from trimmer.hybrid.compilation import compiled, kept, sources
from trimmer.hybrid.linear_combination import combined_moduli
from trimmer.hybrid.tables import NO_RESET, Tables
from trimmer.hybrid.tabulated_change import AT_REST
from trimmer.hybrid.taylor import LEVELS
from trimmer.hybrid.work import Log


class Room(NamedTuple):
    """Room for distances, (n, columns), a flow, (n, n), and the rates before and after an event, (N,)."""

    distances: Reals
    flow: Reals
    before: Reals
    after: Reals


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


@compiled
def _flow_of(series: Reals, terms: int, fraction: float, count: int, result: Reals) -> None:
    """Write the flow over a fraction of a step, transposed, for the first ``count`` states."""
    size = len(series)
    for j in range(count):
        for i in range(count):
            result[j, i] = series[j, (terms - 1) * size + i]
        for k in range(terms - 2, -1, -1):
            for i in range(count):
                result[j, i] = result[j, i] * fraction + series[j, k * size + i]


@compiled
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
def _go_on(tables: Tables, mode: int, duration: float, distances: Reals, room: Room) -> None:
    """Multiply distances by the flow of a mode over a duration, s.

    States that decay by themselves, or have done so, are left out of the flow.
    """
    count, columns = distances.shape
    now, other = tables.settled[mode], room.distances
    step = tables.step[now]
    steps = max(math.ceil(duration / step) - 1, 0)
    fraction = duration / step - steps
    level = max(min(-math.frexp(fraction)[1] // 2, LEVELS - 1), 0) if fraction > 0.0 else LEVELS - 1
    _flow_of(tables.series[now], tables.terms[now, level], fraction, count, room.flow)
    for k in range(steps + 1):
        _multiply(tables.screen[now] if k < steps else room.flow, distances, other)
        for i in range(count):
            for c in range(columns):
                distances[i, c] = other[i, c]
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
            value, slope = 0.0, 0.0
            for i in range(state.size):
                value += tables.taylor[mode, function, i, 0] * state[i]
                slope += tables.taylor[mode, function, i, 0] * rates[i]
            sizes = tables.sizes[mode, function]
            size = combined_moduli(state, sizes[0]) + combined_moduli(state, sizes[1])
            if abs(value) <= AT_REST * size and slope < 0.0:
                return True
    return False


@compiled
def _jump(  # noqa: PLR0913
    tables: Tables,
    before: int,
    fired: int,
    after: int,
    here: Reals,
    state: Reals,
    distances: Reals,
    room: Room,
) -> bool:
    """Multiply distances by the jump of an event; return False, and do nothing, if it is not the only one.

    Args:
        tables: The modes.
        before: The mode before.
        fired: What has fallen to zero.
        after: The mode after.
        here: The state in which it has.
        state: The state from which the motion goes on.
        distances: The distances, (n, columns).
        room: Room for more.
    """
    count, columns = distances.shape
    _multiply_state(tables.flow[before], here, room.before)
    if tables.owner[before, fired] >= 0 and _falls_with(tables, before, fired, here, room.before):
        return False
    _multiply_state(tables.flow[after], state, room.after)
    slope, gradient = 0.0, tables.taylor[before, fired]
    for i in range(here.size):
        slope += gradient[i, 0] * room.before[i]
    if slope != 0.0:
        for c in range(columns):
            earlier = 0.0
            for i in range(count):
                earlier += gradient[i, 0] * distances[i, c]
            for i in range(count):
                distances[i, c] += (room.after[i] - room.before[i]) / slope * earlier
    _fit(tables, after, distances, room.distances)
    return True


@compiled
def _resets(tables: Tables, log: Log, first: int, last: int) -> bool:
    """Return whether an event of some rows at one instant resets the state."""
    for row in range(first, last + 1):
        mode, fired = log.mode[row - 1], log.function[row]
        if fired >= 0 and (
            tables.reset[mode, fired, 0] != NO_RESET or tables.reset[mode, fired, 1] != NO_RESET
        ):
            return True
    return False


def _entry(sources: bytes) -> Callable[..., int]:
    def entry(tables: Tables, log: Log, end: float, row: int, distances: Reals, room: Room) -> int:
        sources  # noqa: B018
        rows = log.start.size
        jumped = row > 0  # What begins in a later row has jumped there already.
        if row == 0:
            _fit(tables, log.mode[0], distances, room.distances)
        while row < rows:
            following, fired = row, -1
            while following < rows and log.start[following] == log.start[row]:
                if fired < 0:
                    fired = log.function[following]
                following += 1
            last = following - 1  # Of the segments at one instant, the last one is that which goes on.
            if row > 0 and fired >= 0 and not jumped:
                if _resets(tables, log, row, last):
                    break
                before, here, state = log.mode[row - 1], log.state[row], log.state[last]
                if not _jump(tables, before, fired, log.mode[last], here, state, distances, room):
                    break
            until = log.start[following] if following < rows else end
            _go_on(tables, log.mode[last], until - log.start[last], distances, room)
            row, jumped = following, False
        return row

    return kept(entry)


_compiled_entry = _entry(sources())


def propagate(tables: Tables, log: Log, end: float, row: int, distances: Reals, room: Room) -> int:
    """Carry distances (n, columns), in place, to the end of a motion, or to what is not decided here.

    Args:
        tables: The modes.
        log: The segments of the motion.
        end: Time at which it ends, s.
        row: The first row; at a later one than the first, the distances have jumped already.
        distances: The distances there.
        room: Room for more.

    Returns:
        The row of the first segment at an instant at which several parts change; the number of rows at the
        end.
    """
    return int(_compiled_entry(tables, log, end, row, distances, room))
