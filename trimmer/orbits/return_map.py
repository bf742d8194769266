"""The state after a time as a function of the state before, and its derivative."""

from __future__ import annotations

from dataclasses import dataclass
from typing import TYPE_CHECKING

import numpy as np

from trimmer.hybrid.advance import Ending
from trimmer.hybrid.taylor import DEGREE
from trimmer.loops.integration import followed
from trimmer.orbits.saltation import jump

if TYPE_CHECKING:
    from trimmer.arrays import Reals
    from trimmer.hybrid.work import Log
    from trimmer.loops.system import LoopModes


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
        events: All events at its end, in their order: the mode before, and the event function.
    """

    duration: float
    mode: int
    state: Reals
    event_function: int
    reset: Reals
    following: int
    events: tuple[tuple[int, int], ...] = ()


def follow(modes: LoopModes, mode: int, state: Reals, duration: float) -> Log | None:
    """Integrate from an extended state, shape (n,), for a time, s.

    Returns:
        The segments of the motion; None if events accumulate, a limit is reached or the motion diverges.
    """
    stretch = followed(modes, mode, state, duration, MOST_EVENTS)
    return stretch.log if stretch.ending is Ending.REACHED_END else None


def arcs(modes: LoopModes, log: Log, end: float) -> list[Arc]:
    """Return the segments of positive length; events at one instant are combined into one.

    The last segment ends at the time ``end``, s, without an event.
    """
    stops = np.append(log.start[1:], end)
    lasting = [each for each in range(len(stops)) if stops[each] > log.start[each]]
    chain = []
    for segment, following in zip(lasting, [*lasting[1:], None], strict=True):
        reset, events = np.eye(modes.system.layout.size), []
        for event in range(segment + 1, (len(stops) if following is None else following + 1)):
            if log.function[event] >= 0:
                events.append((int(log.mode[event - 1]), int(log.function[event])))
                reset = modes[int(log.mode[event])].hold @ _reset(modes, *events[-1]) @ reset
        chain.append(
            Arc(
                duration=float(stops[segment] - log.start[segment]),
                mode=int(log.mode[segment]),
                state=log.state[segment],
                event_function=-1 if following is None else int(log.function[segment + 1]),
                reset=reset,
                following=int(log.mode[segment if following is None else following]),
                events=tuple(events),
            )
        )
    return chain


def _reset(modes: LoopModes, mode: int, function: int) -> Reals:
    reset = modes.system.reset(modes[mode], modes[mode].functions[function])
    return np.eye(modes.system.layout.size) if reset is None else reset


def flow(modes: LoopModes, mode: int, duration: float) -> Reals:
    """Return exp(M duration) of a mode, n x n; the duration in s."""
    tables, size = modes.tables, modes.system.layout.size
    steps, fraction = divmod(duration / tables.step[mode], 1.0)
    terms = tables.series[mode].reshape(size, DEGREE + 1, size)
    rest = np.einsum("jki,k->ij", terms, fraction ** np.arange(DEGREE + 1))
    whole: Reals = np.linalg.matrix_power(tables.screen[mode, :, :size].T, int(steps))
    propagator: Reals = rest @ whole
    return propagator


def derivative(modes: LoopModes, chain: list[Arc]) -> tuple[Reals, Reals]:
    """Return the derivative, n x n, of the state at the end of a chain by that at its start, and that end."""
    total = np.eye(modes.system.layout.size)
    for arc in chain:
        transition = flow(modes, arc.mode, arc.duration)
        before = transition @ arc.state
        total = transition @ total
        if arc.event_function >= 0:
            total = jump(modes, arc, before) @ total
    return total, before
