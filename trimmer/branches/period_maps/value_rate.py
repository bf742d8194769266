"""The derivative of a motion by a number of what moves: compiled flow, and what events make of it.

With Z' = M Z between events, the derivative Y of Z at a fixed time obeys Y' = M Y + M_p Z. An event at which
g · Z = 0 moves by dt = -(g · Y + g_p · Z) / (g · f) with the rate f before it. A difference of two motions
would be wrong wherever their events differ, as next to a grazing.
"""

from __future__ import annotations

import math
from collections.abc import Callable
from dataclasses import dataclass
from functools import cached_property
from typing import Any, NamedTuple

import numpy as np

from trimmer.arrays import Integers, Reals
from trimmer.hybrid.clock import TICKED, Clock, carried, instant_of
from trimmer.hybrid.compilation import compiled, kept, merged, sources
from trimmer.hybrid.linear_combination import combine, copy, evaluate_terms, unsigned
from trimmer.hybrid.propagation import (
    SEVERAL,
    Room,
    falling,
    fly,
    is_decided,
    met,
    parted,
    reset_at,
    room_for,
)
from trimmer.hybrid.system import System
from trimmer.hybrid.tables import NO_RESET, Modes, Tables
from trimmer.hybrid.taylor import DEGREE
from trimmer.hybrid.variation import Jump, end_of_instant, identity, jumps
from trimmer.hybrid.work import Log
from trimmer.motion.course import Course

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
        tables: Tables,
        slopes: Slopes,
        log: Log,
        end: float,
        row: int,
        both: Reals,
        room: Room,
        terms: Reals,
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


_compiled_entry = _entry(sources())


def _met(modes: Modes[Any], log: Log) -> list[int]:
    """Return the numbers of the modes that a motion meets, and of those without states that decay."""
    found = np.unique(log.mode)
    numbers: list[int] = np.union1d(found, modes.tables.settled[found]).tolist()
    return numbers


def _dense(modes: Modes[Any], log: Log) -> Tables:
    """Return tables of the modes that a motion of a large system meets, without those of a whole step."""
    tables, size = modes.tables, log.state.shape[1]
    count, most = tables.owner.shape
    flow, hold = np.zeros((2, count, size, size))
    taylor, sizes = np.zeros((count, most, size, 1)), np.zeros((count, most, 2, size))
    for number in _met(modes, log):
        mode = modes[number]
        flow[number], hold[number] = mode.flow, mode.hold.T
        for place, function in enumerate(mode.functions):
            taylor[number, place, :, 0] = function.row
            sizes[number, place] = abs(function.row), tables.step[number] * abs(function.row) @ abs(mode.flow)
    terms = np.full_like(tables.terms, DEGREE + 1)
    return tables._replace(rows=None, flow=flow, hold=hold, taylor=taylor, sizes=sizes, terms=terms)


@dataclass(frozen=True, eq=False)
class ValueChange:
    """How the equations change with a number: two systems of one layout with values a little apart.

    Attributes:
        course: A motion of the first system.
        other: The second system.
        step: Difference of the values, in their unit.
        longer: Derivative of the motion's duration by the number, s per unit.
        known: Derivatives of the equations, if they are known.
    """

    course: Course
    other: System
    step: float
    longer: float
    known: Slopes | None = None

    def rate(self) -> Reals:
        """Return the derivative of the end by the number, from a state that stays, shape (n,)."""
        log, modes, slopes = self.course.log, self.course.modes, self.slopes
        tables, size = modes.tables, log.state.shape[1]
        if tables.rows is not None:
            tables = _dense(modes, log)
        both, room, terms = np.zeros((2, size)), room_for(0, 0, size), np.empty((4 + 2 * size, size))
        own, other = modes.system.layout, self.other.layout
        if (own.phasors != other.phasors).any():  # as where the phase of the drive is varied
            phase = self.course.begin.phase
            both[1, own.state_count :] = (other.forcing_at(phase) - own.forcing_at(phase)) / self.step
        rows, end = len(log.start), self.course.duration
        row = _compiled_entry(tables, slopes, log, end, 0, both, room, terms)
        while row < rows:
            last = end_of_instant(log, row) - 1
            if log.function[row] <= TICKED:
                both[1] = self._sampled(row, last, both[1])
            else:
                both[1] = self._jumped(row, last, both[1])
            row = _compiled_entry(tables, slopes, log, end, row, both, room, terms)
        flow = tables.flow[int(log.mode[-1])]
        return np.asarray((both[1] + flow @ both[0] * self.longer)[: own.state_count])

    @cached_property
    def slopes(self) -> Slopes:
        """Derivatives of the equations of the modes that the motion meets."""
        if self.known is not None:
            return self.known
        modes, log = self.course.modes, self.course.log
        tables, size = modes.tables, log.state.shape[1]
        count, most = tables.owner.shape
        slopes = Slopes(
            np.zeros((count, size, size)),
            np.zeros(count, dtype=np.int64),
            np.zeros((count, size, size)),
            np.zeros((count, most, size)),
            np.zeros_like(tables.decayed),
            np.zeros_like(tables.resets),
        )
        for number in _met(modes, log):
            own, other = modes[number], self.other.mode(modes[number].statuses)
            slopes.flow[number] = (other.flow - own.flow) / self.step
            change = slopes.flow[number]
            slopes.flows[number] = CHANGES if tables.rows is not None else changing(own.flow, change)
            slopes.hold[number] = (other.hold - own.hold).T / self.step
            pairs = zip(own.functions, other.functions, strict=True)
            for function, (one, another) in enumerate(pairs):
                slopes.functions[number, function] = (another.row - one.row) / self.step
            for (z, rate), (_, other_rate) in zip(own.decayed, other.decayed, strict=True):
                slopes.decayed[number, tables.decaying_state == z] = (other_rate - rate) / self.step
        self._write_resets(slopes.resets)
        return slopes

    def _write_resets(self, slopes: Reals) -> None:
        modes, log = self.course.modes, self.course.log
        for row in np.flatnonzero(log.function[1:] >= 0) + 1 if len(slopes) else ():
            number, function = int(log.mode[row - 1]), int(log.function[row])
            reset = modes.tables.reset[number, function].max()
            if reset != NO_RESET and not slopes[reset].any():
                other = self.other.mode(modes[number].statuses)
                change = self.other.reset(other, other.functions[function])
                slopes[reset] = (0.0 if change is None else change.T) - modes.tables.resets[reset]
                slopes[reset] /= self.step

    def _sampled(self, first: int, last: int, tangent: Reals) -> Reals:
        """Return the derivative after what the clock does, at a time that stays, and what follows from it."""
        log, modes = self.course.log, self.course.modes
        code, mode = TICKED - int(log.function[first]), int(log.mode[first])
        assert modes.samplings is not None
        here, clock = self.course.before(first)[:, None], modes.samplings.clock
        after = carried(clock, code, mode, tangent[:, None])[:, 0]
        for sign, each in ((-1.0, clock), (1.0, self._other_clock)):
            after += sign / self.step * carried(each, code, mode, here)[:, 0]
        return self._fitted(int(log.mode[last]), after, log.state[last])

    @cached_property
    def _other_clock(self) -> Clock:
        """What samplers do at the other value, in modes of the same numbers."""
        other = Modes(self.other)
        for statuses in self.course.modes.statuses:
            other.number(statuses)
        assert other.samplings is not None
        return other.samplings.clock

    def _fitted(self, mode: int, tangent: Reals, state: Reals) -> Reals:
        """Return a derivative that fits what a mode holds."""
        modes = self.course.modes
        held: Reals = modes[mode].hold @ tangent + state @ self.slopes.hold[mode]
        for z, _ in modes[mode].decayed:
            held[z] = tangent[z]
        return held

    def _jumped(self, first: int, last: int, tangent: Reals) -> Reals:
        """Return the derivative after several events at one instant, one after the other."""
        log, modes = self.course.log, self.course.modes
        for jump in jumps(modes, log, first, last):
            row_rate, other = self._changed(jump, int(log.mode[first - 1]))
            later: float = 0.0
            if jump.slope != 0.0:
                missed = jump.function.row @ tangent + row_rate @ jump.here
                later = -float(missed) / jump.slope
            if jump.reset is not None:
                tangent = jump.reset @ tangent
                tangent += 0.0 if other is None else (other - jump.reset) @ jump.here / self.step
            tangent = tangent - jump.change * later
            if jump.after is None:
                continue
            tangent = self._fitted(jump.after, tangent, jump.there)
        return tangent

    def _changed(self, jump: Jump, first: int) -> tuple[Reals, Reals | None]:
        """Return the derivative of what falls to zero, (N,), and the reset at the other value, (N, N)."""
        modes = self.course.modes
        if jump.kind is not None:
            own, other = (each.impulse(jump.function.owner, jump.kind) for each in (modes.system, self.other))
            assert own is not None
            assert other is not None
            return (other[1] - own[1]) / self.step, other[0]
        mode, function = self._place_of(jump, first)
        row_rate: Reals = self.slopes.functions[mode, function]
        if jump.reset is None:
            return row_rate, None
        changed = self.other.mode(modes[mode].statuses)
        return row_rate, self.other.reset(changed, changed.functions[function])

    def _place_of(self, jump: Jump, first: int) -> tuple[int, int]:
        """Return in which mode an event function is, and its number there: of the first mode that has it."""
        # A mode of a large system may have been assembled anew in between.
        return next(
            (mode, number)
            for mode in (jump.before, first)
            for number, own in enumerate(self.course.modes[mode].functions)
            if own is jump.function or identity(own) == identity(jump.function)
        )
