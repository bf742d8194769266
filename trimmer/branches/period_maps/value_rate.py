"""The derivative of a motion by a number of what moves, also through several events at one instant.

A difference of two motions would be wrong wherever their events differ, as next to a grazing.
"""

from __future__ import annotations

from dataclasses import dataclass
from typing import Any

import numpy as np

from trimmer.arrays import Reals
from trimmer.branches.period_maps.value_flow import CHANGES, Slopes, changing, flow_on
from trimmer.hybrid.clock import TICKED, Clock, carried
from trimmer.hybrid.propagation import room_for
from trimmer.hybrid.system import System
from trimmer.hybrid.tables import NO_RESET, Modes, Tables
from trimmer.hybrid.taylor import DEGREE
from trimmer.hybrid.variation import Saltation, end_of_instant, in_turn, jumps, key_of
from trimmer.hybrid.work import Log
from trimmer.kept_property import cached_property
from trimmer.motion.course import Course


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
        # As where the phase of the drive is varied.
        if own is not other and (own.phasors != other.phasors).any():
            phase = self.course.begin.phase
            both[1, own.state_count :] = (other.forcing_at(phase) - own.forcing_at(phase)) / self.step
        rows, end = len(log.start), self.course.duration
        row = flow_on(tables, slopes, log, end, 0, both, room, terms)
        while row < rows:
            last = end_of_instant(log, row) - 1
            if log.function[row] <= TICKED:
                both[1] = self._sampled(row, last, both[1])
            else:
                both[1] = self._jumped(row, last, both[1])
            row = flow_on(tables, slopes, log, end, row, both, room, terms)
        if self.longer:
            both[1] += tables.flow[int(log.mode[-1])] @ both[0] * self.longer
        return both[1, : own.state_count]

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

    def _changed(self, jump: Saltation, first: int) -> tuple[Reals, Reals | None]:
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
        places = (mode, function), *jump.following
        changed = [(self.other.mode(modes[number].statuses), place) for number, place in places]
        return row_rate, in_turn(self.other.reset(each, each.functions[place]) for each, place in changed)

    def _place_of(self, jump: Saltation, first: int) -> tuple[int, int]:
        """Return in which mode an event function is, and its number there: of the first mode that has it."""
        # A mode of a large system may have been assembled anew in between.
        return next(
            (mode, number)
            for mode in (jump.before, first)
            for number, own in enumerate(self.course.modes[mode].functions)
            if own is jump.function or key_of(own) == key_of(jump.function)
        )
