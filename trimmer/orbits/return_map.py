"""The state after a time as a function of the state before, and its derivative (saltation matrices)."""

from __future__ import annotations

from dataclasses import dataclass
from typing import TYPE_CHECKING

import numpy as np

from trimmer.motion.integration import integrate_on, new_log
from trimmer.motion.kernel import REACHED_END
from trimmer.motion.tables import TOGETHER
from trimmer.motion.taylor import DEGREE

if TYPE_CHECKING:
    from trimmer.arrays import Reals
    from trimmer.motion.mode_tables import ModeTables
    from trimmer.motion.tables import Log


FIRST_ROWS = 64
MOST_EVENTS = 10_000
"""Events in one period, beyond which there is no orbit to speak of."""


@dataclass(frozen=True)
class Arc:
    """A segment of motion of positive length with the event that ends it.

    Attributes:
        duration: Length in time, s.
        mode: Number of its mode.
        state: Extended state at its start, shape (n,).
        event_function: Number of the event function that ends it; -1 if the time is over.
        reset: Matrix that gives the state after all events at its end from the state before, n x n.
        following: Number of the mode afterwards.
    """

    duration: float
    mode: int
    state: Reals
    event_function: int
    reset: Reals
    following: int


def follow(modes: ModeTables, mode: int, state: Reals, duration: float) -> Log | None:
    """Integrate from an extended state, shape (n,), for a time, s.

    Returns:
        The segments of the motion; None if events accumulate, a limit is reached or the motion diverges.
    """
    reason, log, _ = integrate_on(modes, new_log(FIRST_ROWS, mode, state), duration, MOST_EVENTS)
    return log if reason == REACHED_END else None


def arcs(modes: ModeTables, log: Log, end: float) -> list[Arc]:
    """Return the segments of positive length; events at one instant are combined into one.

    The last segment ends at the time ``end``, s, without an event.
    """
    stops = np.append(log.start[1:], end)
    lasting = [each for each in range(len(stops)) if stops[each] > log.start[each]]
    chain = []
    for segment, following in zip(lasting, [*lasting[1:], None], strict=True):
        reset = np.eye(modes.layout.size)
        for event in range(segment + 1, (len(stops) if following is None else following + 1)):
            if log.event_function[event] != TOGETHER:
                reset = modes.tables.reset[log.mode[event - 1], log.event_function[event]].T @ reset
        chain.append(
            Arc(
                duration=float(stops[segment] - log.start[segment]),
                mode=int(log.mode[segment]),
                state=log.state[segment],
                event_function=-1 if following is None else int(log.event_function[segment + 1]),
                reset=reset,
                following=int(log.mode[segment if following is None else following]),
            )
        )
    return chain


def flow(modes: ModeTables, mode: int, duration: float) -> Reals:
    """Return exp(M duration) of a mode, n x n; the duration in s."""
    tables, size = modes.tables, modes.layout.size
    steps, fraction = divmod(duration / tables.step[mode], 1.0)
    terms = tables.series[mode].reshape(size, DEGREE + 1, size)
    rest = np.einsum("jki,k->ij", terms, fraction ** np.arange(DEGREE + 1))
    whole: Reals = np.linalg.matrix_power(tables.whole[mode].T, int(steps))
    propagator: Reals = rest @ whole
    return propagator


def derivative(modes: ModeTables, chain: list[Arc]) -> tuple[Reals, Reals]:
    """Return the derivative, n x n, of the state at the end of a chain by that at its start, and the former.

    An event that comes later by dt lets the old flow act for dt longer and the new one shorter, which is the
    saltation matrix R + (f_after - R f_before) g / (g f_before) with the reset R, the event function g
    and the flows f (Leine and Nijmeijer 2004, section 7).
    """
    total = np.eye(modes.layout.size)
    for arc in chain:
        transition = flow(modes, arc.mode, arc.duration)
        before = transition @ arc.state
        total = transition @ total
        if arc.event_function >= 0:
            row = modes.tables.event_rows[arc.mode, arc.event_function]
            rate = modes.mode(arc.mode).matrix @ before
            rate_after = modes.mode(arc.following).matrix @ (arc.reset @ before)
            jump = np.outer(rate_after - arc.reset @ rate, row) / (row @ rate)
            total = (arc.reset + jump) @ total
    return total, before
