"""The motion from a state over a time, and its derivative by that state (saltation matrices)."""

from __future__ import annotations

from dataclasses import dataclass
from typing import TYPE_CHECKING

import numpy as np

from trimmer.motion.kernel import REACHED_END
from trimmer.motion.marching import march_on, new_log
from trimmer.motion.tables import SETTLED
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
    """A segment of motion of positive length with what ends it.

    Attributes:
        duration: s.
        mode: Its mode.
        state: Extended state at its start.
        event_function: The one that ends it; -1 if time does.
        reset: The state after all that happens at its end from the state before, n x n.
        following: Mode afterwards.
    """

    duration: float
    mode: int
    state: Reals
    event_function: int
    reset: Reals
    following: int


def follow(modes: ModeTables, mode: int, state: Reals, duration: float) -> Log | None:
    """March from a state for a time, s; return what happened, or None if events accumulate."""
    reason, log, _ = march_on(modes, new_log(FIRST_ROWS, mode, state), duration, MOST_EVENTS)
    return log if reason == REACHED_END else None


def arcs(modes: ModeTables, log: Log, end: float) -> list[Arc]:
    """Return the segments of positive length; what happens at one instant is taken together.

    The last segment ends at ``end``, s, by time.
    """
    stops = np.append(log.start[1:], end)
    lasting = [each for each in range(len(stops)) if stops[each] > log.start[each]]
    chain = []
    for segment, following in zip(lasting, [*lasting[1:], None], strict=True):
        reset = np.eye(modes.layout.size)
        for event in range(segment + 1, (len(stops) if following is None else following + 1)):
            if log.event_function[event] != SETTLED:
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
    """Return exp(M duration) of a mode."""
    tables, size = modes.tables, modes.layout.size
    steps, fraction = divmod(duration / tables.step[mode], 1.0)
    terms = tables.series[mode].reshape(size, DEGREE + 1, size)
    rest = np.einsum("jki,k->ij", terms, fraction ** np.arange(DEGREE + 1))
    whole: Reals = np.linalg.matrix_power(tables.whole[mode].T, int(steps))
    propagator: Reals = rest @ whole
    return propagator


def derivative(modes: ModeTables, chain: list[Arc]) -> tuple[Reals, Reals]:
    """Return how the state at the end of a chain of arcs depends on that at its start, and that state.

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
