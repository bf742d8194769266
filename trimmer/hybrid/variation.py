"""The derivative of a motion by the state it begins with: flow between events, and what events make of it.

At an event at which a functional g falls to zero, a neighbouring motion changes its mode earlier or later. So
its distance is multiplied by 1 + (f₊ - f₋) gᵀ / (g · f₋), with the rates f before and after (Aizerman and
Gantmakher 1958; Leine and Nijmeijer 2004, chapter 7). Where stick or contact takes a dimension away, this
matrix is singular.
"""

from __future__ import annotations

from typing import TYPE_CHECKING, Any

import numpy as np

from trimmer.hybrid.propagation import Room, propagate
from trimmer.hybrid.sparse import carry
from trimmer.hybrid.tabulated_change import AT_REST

if TYPE_CHECKING:
    from collections.abc import Iterator, Sequence

    from trimmer.arrays import Reals
    from trimmer.hybrid.system import EventFunction
    from trimmer.hybrid.tables import Modes
    from trimmer.hybrid.work import Log


def propagated(modes: Modes[Any], log: Log, end: float, tangents: Reals) -> Reals:
    """Return what becomes of small distances from a motion.

    Args:
        modes: The modes of the system.
        log: The segments of the motion, their times within one period or in all.
        end: Time at which it ends, s, counted as in the log.
        tangents: Distances at its start, (n, columns).

    Returns:
        Distances at its end, (n, columns). Where contact or stick holds at the start, they fit it first.
    """
    distances, size = np.array(tangents, dtype=np.float64, order="C"), log.state.shape[1]
    count = len(distances)
    room = Room(np.empty_like(distances), np.empty((count, count)), np.empty(size), np.empty(size))
    if modes.tables.rows is not None:
        return _by_rows(modes, log, end, distances)
    rows = len(log.start)
    row = propagate(modes.tables, log, end, 0, distances, room)
    while row < rows:
        # Of the segments at one instant, the last one is that which goes on.
        last = int(np.searchsorted(log.start, log.start[row], side="right")) - 1
        _jump(modes, log, row, last, distances)
        row = propagate(modes.tables, log, end, row, distances, room)
    return distances


def _by_rows(modes: Modes[Any], log: Log, end: float, distances: Reals) -> Reals:
    """Return what becomes of distances where modes are rows."""
    distances = _fitted(modes, int(log.mode[0]), distances)
    rows, row = len(log.start), 0
    while row < rows:
        following = int(np.searchsorted(log.start, log.start[row], side="right"))
        last = following - 1
        if row > 0:
            _jump(modes, log, row, last, distances)
        until = float(log.start[following] if following < rows else end)
        _go_on(modes, int(log.mode[last]), until - log.start[last], distances)
        row = following
    return distances


def _go_on(modes: Modes[Any], mode: int, duration: float, distances: Reals) -> None:
    """Multiply distances (n, columns), in place, by the flow of a mode over a duration, s."""
    tables, count = modes.tables, len(distances)
    settled = int(tables.settled[mode])
    extended = np.zeros((distances.shape[1], tables.resets.shape[1]))
    extended[:, :count] = distances.T
    assert tables.rows is not None
    carry(tables.rows, settled, float(tables.step[settled]), duration, extended)
    distances[:] = extended[:, :count].T
    # States that decay by themselves, or have done so, are left out of the flow.
    for place, rate in modes[settled].decayed:
        distances[place] *= np.exp(-rate * duration)


def _fitted(modes: Modes[Any], mode: int, distances: Reals) -> Reals:
    """Return distances that fit what a mode holds; a state that has decayed may have begun elsewhere."""
    fitted: Reals = modes[mode].hold[: len(distances), : len(distances)] @ distances
    for place, _ in modes[mode].decayed:
        fitted[place] = distances[place]
    return fitted


def _jump(modes: Modes[Any], log: Log, first: int, last: int, distances: Reals) -> None:
    """Multiply by the jumps of what happens at one instant, one after the other."""
    fired = [int(log.function[row]) for row in range(first, last + 1) if log.function[row] >= 0]
    if not fired:
        return
    count, state = len(distances), log.state[last]
    for before, function, after in changes(modes, log, first, last, fired[0]):
        gradient = function.row
        rates = modes[before].flow @ (log.state[first] if before == log.mode[first - 1] else state)
        slope = gradient @ rates
        if slope:
            jump = (modes[after].flow @ state - rates)[:count] / slope
            distances += np.outer(jump, gradient[:count] @ distances)
        distances[:] = _fitted(modes, after, distances)


def changes(
    modes: Modes[Any], log: Log, first: int, last: int, fired: int
) -> Iterator[tuple[int, EventFunction, int]]:
    """Yield the changes of mode at one instant: the mode before, what fell to zero in it, the mode after.

    Where several event functions of the mode before fall to zero together, a neighbouring motion meets them
    one after the other, and so do the distances. The first one has fired. What else changes at the instant
    follows from one of them and takes place with the last.

    Args:
        modes: The modes of the system.
        log: The segments of the motion.
        first: Row of the first segment that begins at the instant.
        last: Row of the last one.
        fired: Number of the event function that fired first.
    """
    before, after = int(log.mode[first - 1]), int(log.mode[last])
    falling = _falling(modes, before, fired, log.state[first])
    statuses = list(modes[before].statuses)
    for number, function in enumerate(falling, start=1):
        here = _counterpart(function, modes[before].functions)
        following = after
        if number < len(falling):
            statuses[function.owner] = modes[after].statuses[function.owner]
            following = modes.number(tuple(statuses))
        yield before, here, following
        before = following


def _falling(modes: Modes[Any], before: int, fired: int, state: Reals) -> list[EventFunction]:
    """Return what falls to zero at an event: what has fired, then one function of each other part.

    What is the same as one of them for all motions of the mode falls to zero with it in a neighbour too: two
    frictions of a body come to rest together where the other body of the one is held.
    """
    mode = modes[before]
    falling = [mode.functions[fired]]
    values = np.array([each.row for each in mode.functions]) @ state
    for number in np.flatnonzero(abs(values) <= AT_REST * modes.moduli(before, state)):
        function = mode.functions[number]
        others = all(function.owner != each.owner for each in falling)
        if not others or function.row @ (mode.flow @ state) >= 0:
            continue
        if not any(_are_one(function.row @ mode.hold, each.row @ mode.hold) for each in falling):
            falling.append(function)
    # What several frictions do jointly is no change of one of them.
    return falling if min(each.owner for each in falling) >= 0 else falling[:1]


def _are_one(row: Reals, other: Reals) -> bool:
    """Say whether one functional is a multiple of another."""
    largest = abs(other).max()
    away = row if largest == 0.0 else row - other * (row @ other) / (other @ other)
    return bool(abs(away).max() <= AT_REST * abs(row).max())


def _counterpart(function: EventFunction, functions: Sequence[EventFunction]) -> EventFunction:
    """Return the same event function of another mode; itself if it is of that, or if that has it no more."""
    if any(each is function for each in functions):
        return function
    same = (each for each in functions if _identity(each) == _identity(function))
    return next(same, function)


def _identity(function: EventFunction) -> tuple[int, int, tuple[int, ...]]:
    return function.owner, function.action, function.signs
