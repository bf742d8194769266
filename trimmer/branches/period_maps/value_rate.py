"""The derivative of a motion by a number of what moves: compiled flow, and what events make of it.

With Z' = M Z between events, the derivative Y of Z at a fixed time obeys Y' = M Y + M_p Z. An event at which
g · Z = 0 moves by dt = -(g · Y + g_p · Z) / (g · f) with the rate f before it. A difference of two motions
would be wrong wherever their events differ, as next to a grazing.
"""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass
from functools import cached_property

import numpy as np

from trimmer.arrays import Reals
from trimmer.hybrid.compilation import kept, sources
from trimmer.hybrid.linear_combination import copy
from trimmer.hybrid.system import EventFunction, Mode, System
from trimmer.hybrid.taylor import DEGREE
from trimmer.hybrid.variation import identity, jumps
from trimmer.motion.course import Course


def _entry(sources: bytes) -> Callable[..., None]:
    def entry(
        flow: Reals, change: Reals, step: float, duration: float, state: Reals, tangent: Reals, room: Reals
    ) -> None:
        """Follow a state and its derivative, both (N,), in place, over a duration, s, in steps."""
        sources  # noqa: B018
        size, left = state.size, duration
        x, y, next_x, next_y = room[0], room[1], room[2], room[3]
        while left > 0.0:
            h = min(step, left)
            copy(state, size, x)
            copy(tangent, size, y)
            for k in range(1, DEGREE + 2):
                for i in range(size):
                    x_sum, y_sum = 0.0, 0.0
                    for j in range(size):
                        x_sum += flow[i, j] * x[j]
                        y_sum += flow[i, j] * y[j] + change[i, j] * x[j]
                    next_x[i], next_y[i] = x_sum * h / k, y_sum * h / k
                for i in range(size):
                    x[i], y[i] = next_x[i], next_y[i]
                    state[i] += x[i]
                    tangent[i] += y[i]
            left -= step

    return kept(entry)


_compiled_entry = _entry(sources())


@dataclass(frozen=True, eq=False)
class ValueChange:
    """How the equations change with a number: two systems of one layout with values a little apart.

    Attributes:
        course: A motion of the first system.
        other: The second system.
        step: Difference of the values, in their unit.
        longer: Derivative of the motion's duration by the number, s per unit.
    """

    course: Course
    other: System
    step: float
    longer: float

    def rate(self) -> Reals:
        """Return the derivative of the end by the number, from a state that stays, shape (n,)."""
        log = self.course.log
        tangent = np.zeros(log.state.shape[1])
        own, other = self.course.modes.system.layout, self.other.layout
        if (own.phasors != other.phasors).any():  # as where the phase of the drive is varied
            phase = self.course.begin.phase
            tangent[own.state_count :] = (other.forcing_at(phase) - own.forcing_at(phase)) / self.step
        tangent[:] = self._held(int(log.mode[0]), log.state[0], tangent)
        row, rows = 0, len(log.start)
        state = log.state[0]
        while row < rows:
            following = row + 1
            while following < rows and log.start[following] == log.start[row]:
                following += 1
            last = following - 1
            if row > 0:
                tangent = self._jumped(row, last, tangent)
            until = log.start[following] if following < rows else self.course.duration
            state, tangent = self._flown(last, float(until - log.start[last]), tangent)
            row = following
        flow = self.course.modes[int(log.mode[-1])].flow
        count = len(self.course.end.state)
        return np.asarray((tangent + flow @ state * self.longer)[:count])

    @cached_property
    def _others(self) -> dict[int, Mode]:
        return {}

    def _other(self, mode: int) -> Mode:
        if mode not in self._others:
            self._others[mode] = self.other.mode(self.course.modes[mode].statuses)
        return self._others[mode]

    def _held(self, mode: int, state: Reals, tangent: Reals) -> Reals:
        """Return the derivative that fits what a mode holds."""
        own, other = self.course.modes[mode], self._other(mode)
        held: Reals = own.hold @ tangent + (other.hold - own.hold) @ state / self.step
        for z, _ in own.decayed:
            held[z] = tangent[z]
        return held

    def _flown(self, row: int, duration: float, tangent: Reals) -> tuple[Reals, Reals]:
        """Return state and derivative at the end of a segment; springs that relax flow by themselves."""
        modes, state = self.course.modes, self.course.log.state[row].copy()
        settled = int(modes.tables.settled[int(self.course.log.mode[row])])
        own, other = modes[settled], self._other(settled)
        change = (other.flow - own.flow) / self.step
        begun, tangent = state.copy(), tangent.copy()
        stretched = tangent.copy()
        room = np.empty((4, len(state)))
        _compiled_entry(own.flow, change, modes.tables.step[settled], duration, state, tangent, room)
        for (z, rate), (_, other_rate) in zip(own.decayed, other.decayed, strict=True):
            faster = other_rate - rate
            decay = np.exp(-rate * duration)
            state[z] = begun[z] * decay
            tangent[z] = decay * (stretched[z] - faster / self.step * duration * begun[z])
        return state, tangent

    def _jumped(self, first: int, last: int, tangent: Reals) -> Reals:
        """Return the derivative after an event, or after several at one instant, one after the other."""
        log, modes = self.course.log, self.course.modes
        for jump in jumps(modes, log, first, last):
            gradient, here = jump.function.row, jump.here
            mode, changed = self._changed(jump.function, (jump.before, int(log.mode[first - 1])))
            later: float = 0.0
            if jump.slope != 0.0:
                missed = gradient @ tangent + (changed.row - gradient) @ here / self.step
                later = -float(missed) / jump.slope
            if jump.reset is not None:
                other = self.other.reset(mode, changed)
                tangent = jump.reset @ tangent
                tangent += 0.0 if other is None else (other - jump.reset) @ here / self.step
            tangent = self._held(jump.after, jump.there, tangent - jump.change * later)
        return tangent

    def _changed(self, function: EventFunction, among: tuple[int, ...]) -> tuple[Mode, EventFunction]:
        """Return an event function with the other value, and its mode: of the first mode that has it."""
        for mode in among:
            pairs = zip(self.course.modes[mode].functions, self._other(mode).functions, strict=True)
            for own, other in pairs:
                # A mode of a large system may have been assembled anew in between.
                if own is function or identity(own) == identity(function):
                    return self._other(mode), other
        return self._other(among[0]), function
