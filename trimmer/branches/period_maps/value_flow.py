"""The compiled flow of a derivative of a motion by a number, from event to event.

With Z' = M Z between events, the derivative Y of Z at a fixed time obeys Y' = M Y + M_p Z. An event at which
g · Z = 0 moves by dt = -(g · Y + g_p · Z) / (g · f) with the rate f before it.
"""

from __future__ import annotations

import math
from collections.abc import Callable
from typing import NamedTuple

from trimmer.arrays import Integers, Reals
from trimmer.hybrid.clock import TICKED, instant_of
from trimmer.hybrid.compilation import compiled, kept, merged, sources
from trimmer.hybrid.linear_combination import combine, copy, evaluate_terms, unsigned
from trimmer.hybrid.propagation import SEVERAL, Room, falling, fly, is_decided, met, parted, reset_at
from trimmer.hybrid.tables import NO_RESET, Tables
from trimmer.hybrid.work import Log

CHANGES, PUSHED = 1, 2
"""How a flow changes with a number."""


class Slopes(NamedTuple):
    """Derivatives of the equations of modes by a number; first axis: the mode, or the reset.

    Attributes:
        flow: Of the flow, (modes, N, N).
        flows: Whether that changes, ``CHANGES`` or, in columns of what stays alone, ``PUSHED``, (modes,).
        hold: Of what makes the state fit what is held, transposed, (modes, N, N).
        functions: Of the event functions, (modes, functions, N).
        decayed: Of the rates of states that decay by themselves, (modes, m).
        resets: Of the resets, transposed, (resets, N, N).
    """

    flow: Reals
    flows: Integers
    hold: Reals
    functions: Reals
    decayed: Reals
    resets: Reals


def changing(flow: Reals, change: Reals) -> int:
    """Return how a flow, (N, N), changes, whose derivative is given; what nothing moves has rows of zeros."""
    columns = change.any(axis=0)
    if not columns.any():
        return 0
    return CHANGES if flow[columns].any() or change[columns].any() else PUSHED


@compiled
def _held(tables: Tables, slopes: Slopes, mode: int, state: Reals, tangent: Reals, room: Room) -> None:
    """Make the derivative fit what a mode holds; a state that has decayed may have begun elsewhere."""
    size = tangent.size
    combine(tangent, tables.hold[mode], size, room.before)
    combine(state, slopes.hold[mode], size, room.after)
    for part in range(tables.decaying_state.size):
        if tables.decayed[mode, part] > 0.0:
            place = tables.decaying_state[part]
            room.before[place], room.after[place] = tangent[place], 0.0
    for i in range(size):
        tangent[i] = room.before[i] + room.after[i]


@merged
def _step(
    flow: Reals, change: Reals, step: float, terms: int, state: Reals, tangent: Reals, room: Reals
) -> None:
    """Follow a state and its derivative, both (N,), over a step, s, by a term more than the state needs.

    Both matrices are transposed, so that the inner loop runs over neighbours.
    """
    size = state.size
    x, y, next_x, next_y = room[0], room[1], room[2], room[3]
    copy(state, size, x)
    copy(tangent, size, y)
    for k in range(1, terms + 2):
        for i in range(size):
            next_x[i], next_y[i] = 0.0, 0.0
        for j in range(size):
            for i in range(size):
                next_x[i] += flow[j, i] * x[j]
                next_y[i] += flow[j, i] * y[j] + change[j, i] * x[j]
        for i in range(size):
            x[i], y[i] = next_x[i] * step / k, next_y[i] * step / k
            state[i] += x[i]
            tangent[i] += y[i]


@compiled
def _push(
    screen: Reals,
    series: Reals,
    step: float,
    parts: tuple[int, float, int],
    vector: Reals,
    rates: Reals,
    room: Room,
) -> None:
    """Follow a vector, (N,), that constant rates push, with the fraction of a step last."""
    size, added, terms = vector.size, room.there, room.terms
    steps, fraction, _ = parts
    for k in range(steps + 1):
        share, most = (1.0, series.shape[1] // size) if k < steps else (fraction, parts[2])
        if k == 0 or k == steps:
            combine(rates, series, most * size, terms)
            for term in range(most):
                for i in range(unsigned(size)):
                    terms[unsigned(term * size) + i] *= share * step / (term + 1)
            evaluate_terms(terms, most, share, added)
        fly(screen, series, (1, 0.0, 1) if k < steps else (0, fraction, most), vector, terms)
        for i in range(size):
            vector[i] += added[i]


@merged
def _go_on(
    tables: Tables, slopes: Slopes, mode: int, duration: float, both: Reals, room: Room, terms: Reals
) -> None:
    """Follow a state and its derivative, (2, N), over a duration, s; what decays does so by itself."""
    now, state, tangent = tables.settled[mode], both[0], both[1]
    parts = parted(tables.step[now], tables.terms[now], duration)
    if slopes.flows[now] == CHANGES:
        steps, fraction, count = parts
        size = state.size
        flow, change = terms[4 : 4 + size], terms[4 + size :]
        for i in range(size):
            for j in range(size):
                flow[j, i], change[j, i] = tables.flow[now, i, j], slopes.flow[now, i, j]
        for k in range(steps + 1):
            length = tables.step[now] * (1.0 if k < steps else fraction)
            most = tables.terms[now, 0] if k < steps else count
            _step(flow, change, length, most, state, tangent, terms)
    else:
        screen, series = tables.screen[now], tables.series[now]
        if slopes.flows[now] == PUSHED:
            for i in range(state.size):
                room.here[i] = 0.0
                for j in range(state.size):
                    room.here[i] += slopes.flow[now, i, j] * state[j]
            _push(screen, series, tables.step[now], parts, tangent, room.here, room)
        else:
            fly(screen, series, parts, tangent, room.terms)
        fly(screen, series, parts, state, room.terms)
    for part in range(tables.decaying_state.size):
        rate = tables.decayed[now, part]
        if rate > 0.0:
            place, decay = tables.decaying_state[part], math.exp(-rate * duration)
            tangent[place] = decay * (tangent[place] - slopes.decayed[now, part] * duration * state[place])
            state[place] *= decay


@merged
def _jump(
    tables: Tables, slopes: Slopes, before: int, fired: int, reset: int, tangent: Reals, room: Room
) -> None:
    """Write the derivative after an event, before it fits what is held then."""
    slope, later, size = falling(tables.taylor[before, fired], room.before), 0.0, tangent.size
    if slope != 0.0:
        missed = falling(tables.taylor[before, fired], tangent)
        for i in range(size):
            missed += slopes.functions[before, fired, i] * room.here[i]
        later = -missed / slope
    if reset != NO_RESET:
        combine(tangent, tables.resets[reset], size, room.before)
        combine(room.here, slopes.resets[reset], size, room.terms)
        for i in range(size):
            tangent[i] = room.before[i] + room.terms[i]
    for i in range(size):
        tangent[i] -= room.after[i] * later


def _entry(sources: bytes) -> Callable[..., int]:
    def entry(  # noqa: PLR0913
        tables: Tables, slopes: Slopes, log: Log, end: float, row: int, both: Reals, room: Room, terms: Reals
    ) -> int:
        sources  # noqa: B018
        rows, size = log.start.size, both.shape[1]
        jumped = row > 0
        if row == 0:
            _held(tables, slopes, log.mode[0], log.state[0], both[1], room)
        while row < rows:
            following, fired = instant_of(log.start, log.function, row)
            last = following - 1
            if fired <= TICKED and not jumped:
                break
            if row > 0 and fired >= 0 and not jumped:
                reset = reset_at(tables, log, row, last)
                if is_decided(tables, log, row, last, reset):
                    break
                if reset == SEVERAL or not met(tables, tables.resets, log, row, last, fired, reset, room):
                    break
                _jump(tables, slopes, log.mode[row - 1], fired, reset, both[1], room)
                _held(tables, slopes, log.mode[last], room.there, both[1], room)
            until = log.start[following] if following < rows else end
            copy(log.state[last], size, both[0])
            _go_on(tables, slopes, log.mode[last], until - log.start[last], both, room, terms)
            row, jumped = following, False
        return row

    return kept(entry)


flow_on = _entry(sources())
