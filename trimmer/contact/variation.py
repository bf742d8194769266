"""The derivative of a motion by the state it begins with: compiled flow, and what events make of it.

At an event at which a functional g falls to zero, a neighbouring motion changes its mode earlier or later. So
its distance is multiplied by 1 + (f₊ - f₋) gᵀ / (g · f₋), with the rates f before and after (Aizerman and
Gantmakher 1958; Leine and Nijmeijer 2004, chapter 7). Where stick or contact takes a dimension away, this
matrix is singular.
"""

from __future__ import annotations

from collections.abc import Callable
from typing import TYPE_CHECKING

import numpy as np

from trimmer.arrays import Reals
from trimmer.contact.compilation import sources
from trimmer.contact.statuses import FREE
from trimmer.motion.compilation import inlined, kept
from trimmer.motion.taylor import DEGREE

if TYPE_CHECKING:
    from trimmer.contact.tables import Modes
    from trimmer.contact.work import Log


@inlined
def _apply(matrix: Reals, first: int, size: int, stride: int, left: Reals, result: Reals) -> None:
    """Write the product of a matrix, kept transposed from a column on, and ``left``, (n, columns)."""
    columns = left.shape[1]
    for i in range(stride):
        for j in range(columns):
            result[i, j] = 0.0
    for k in range(size):
        for i in range(stride):
            weight = matrix[k, first + i]
            if weight != 0.0:
                for j in range(columns):
                    result[i, j] += weight * left[k, j]


def _entry(sources: bytes) -> Callable[..., None]:
    def entry(step: float, screen: Reals, series: Reals, duration: float, tangents: Reals) -> None:
        """Multiply tangents (n, columns), in place, by the flow of a mode over a duration, s."""
        sources  # noqa: B018
        count, columns = tangents.shape
        size = screen.shape[0]
        following, total = np.empty((count, columns)), np.empty((count, columns))
        left = duration
        while left > step:
            _apply(screen, 0, count, count, tangents, following)
            for i in range(count):
                for j in range(columns):
                    tangents[i, j] = following[i, j]
            left -= step
        fraction = left / step
        _apply(series, DEGREE * size, count, count, tangents, total)
        for k in range(DEGREE - 1, -1, -1):
            _apply(series, k * size, count, count, tangents, following)
            for i in range(count):
                for j in range(columns):
                    total[i, j] = total[i, j] * fraction + following[i, j]
        for i in range(count):
            for j in range(columns):
                tangents[i, j] = total[i, j]

    return kept(entry)


_compiled_entry = _entry(sources())


def propagated(modes: Modes, log: Log, end: float, tangents: Reals) -> Reals:
    """Return what becomes of small distances from a motion.

    Args:
        modes: The modes of the mechanism.
        log: The segments of the motion, their times within one period or in all.
        end: Time at which it ends, s, counted as in the log.
        tangents: Distances at its start, (n, columns).

    Returns:
        Distances at its end, (n, columns). Where contact or stick holds at the start, they fit it first.
    """
    distances = np.ascontiguousarray(_fitted(modes, int(log.mode[0]), tangents))
    rows = len(log.start)
    row = 0
    while row < rows:
        following = row + 1
        while following < rows and log.start[following] == log.start[row] and log.kind[row] >= 0:
            following += 1
        last = following - 1  # Of the segments at one instant, the last one is that which goes on.
        if row > 0:
            _jump(modes, log, row, last, distances)
        mode = int(log.mode[last])
        until = log.start[following] if following < rows else end
        _flow(modes, mode, float(until - log.start[last]), distances)
        row = following
    return distances


def _fitted(modes: Modes, mode: int, distances: Reals) -> Reals:
    """Return distances that fit what a mode holds; a spring that has relaxed may have been stretched."""
    fitted: Reals = modes[mode].hold[: len(distances), : len(distances)] @ distances
    for contact, z in enumerate(modes.machine.relaxing_state):
        if z >= 0 and modes[mode].statuses[contact] == FREE:
            fitted[z] = distances[z]
    return fitted


def _flow(modes: Modes, mode: int, duration: float, distances: Reals) -> None:
    tables = modes.tables
    settled = int(tables.settled[mode])
    _compiled_entry(tables.step[settled], tables.screen[settled], tables.series[settled], duration, distances)
    machine = modes.machine
    for contact, z in enumerate(machine.relaxing_state):
        # Springs that relax, or that have relaxed, are left out of the flow.
        if z >= 0 and modes[settled].statuses[contact] == FREE:
            distances[z] *= np.exp(-machine.stiffness[contact] / machine.damping[contact] * duration)


def _jump(modes: Modes, log: Log, first: int, last: int, distances: Reals) -> None:
    """Multiply by the jump at an event, or at several at one instant, of which the first sets the time."""
    count = len(distances)
    events = [row for row in range(first, last + 1) if log.function[row] >= 0]
    before = modes[int(log.mode[first - 1])]
    if not events:
        return
    after = modes[int(log.mode[last])]
    state = log.state[last]
    gradient = before.functions[int(log.function[events[0]])].row
    rates = before.flow @ log.state[first]
    slope = gradient @ rates
    if slope != 0:
        jump = (after.flow @ state - rates)[:count] / slope
        distances += np.outer(jump, gradient[:count] @ distances)
    distances[:] = _fitted(modes, int(log.mode[last]), distances)
