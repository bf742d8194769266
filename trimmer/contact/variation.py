"""The derivative of a motion by the state it begins with: flow between events, and what events make of it.

At an event at which a functional g falls to zero, a neighbouring motion changes its mode earlier or later. So
its distance is multiplied by 1 + (f₊ - f₋) gᵀ / (g · f₋), with the rates f before and after (Aizerman and
Gantmakher 1958; Leine and Nijmeijer 2004, chapter 7). Where stick or contact takes a dimension away, this
matrix is singular.
"""

from __future__ import annotations

import math
from typing import TYPE_CHECKING

import numpy as np

from trimmer.contact.machine import free_springs
from trimmer.motion.taylor import DEGREE

if TYPE_CHECKING:
    from trimmer.arrays import Reals
    from trimmer.contact.tables import Modes
    from trimmer.contact.work import Log


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
        following = row
        while following < rows and log.start[following] == log.start[row]:
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
    for _, z in free_springs(modes.machine, modes[mode].statuses):
        fitted[z] = distances[z]
    return fitted


def _flow(modes: Modes, mode: int, duration: float, distances: Reals) -> None:
    """Multiply distances (n, columns), in place, by the flow of a mode over a duration, s."""
    tables, count = modes.tables, len(distances)
    settled = int(tables.settled[mode])
    step, size = tables.step[settled], tables.screen.shape[1]
    steps = max(math.ceil(duration / step) - 1, 0)
    powers = (duration / step - steps) ** np.arange(DEGREE + 1)
    flow = (powers @ tables.series[settled].reshape(size, DEGREE + 1, size)[:count, :, :count]).T
    whole = np.linalg.matrix_power(tables.screen[settled, :count, :count].T, steps)
    distances[:] = flow @ whole @ distances
    machine = modes.machine
    # Springs that relax, or that have relaxed, are left out of the flow.
    for contact, z in free_springs(machine, modes[settled].statuses):
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
    if slope:
        jump = (after.flow @ state - rates)[:count] / slope
        distances += np.outer(jump, gradient[:count] @ distances)
    distances[:] = _fitted(modes, int(log.mode[last]), distances)
