"""The derivative of a motion by the state it begins with: flow between events, and what events make of it.

At an event at which a functional g falls to zero, a neighbouring motion changes its mode earlier or later. So
its distance is multiplied by 1 + (f₊ - f₋) gᵀ / (g · f₋), with the rates f before and after (Aizerman and
Gantmakher 1958; Leine and Nijmeijer 2004, chapter 7). Where stick or contact takes a dimension away, this
matrix is singular.
"""

from collections.abc import Iterable, Iterator, Sequence
from dataclasses import dataclass
from functools import reduce
from typing import Any

import numpy as np

from trimmer.arrays import Reals
from trimmer.hybrid.clock import TICKED, carried
from trimmer.hybrid.propagation import propagate, room_for
from trimmer.hybrid.sparse import carry
from trimmer.hybrid.system import STRUCK, EventFunction, ModeEquations
from trimmer.hybrid.tables import Modes
from trimmer.hybrid.tabulated_change import AT_REST
from trimmer.hybrid.taylor import DEGREE
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
    distances = np.array(tangents, dtype=np.float64, order="C")
    if modes.tables.rows is not None:
        return _by_rows(modes, log, end, distances)
    room, rows = room_for(len(distances), distances.shape[1], log.state.shape[1]), len(log.start)
    clock = None if modes.samplings is None else modes.samplings.clock
    row = propagate(modes.tables, clock, log, end, 0, distances, room)
    while row < rows:
        # Of the segments at one instant, the last one is that which goes on.
        _jump(modes, log, row, end_of_instant(log, row) - 1, distances)
        row = propagate(modes.tables, clock, log, end, row, distances, room)
    return distances


def end_of_instant(log: Log, row: int) -> int:
    """Return the row after those of the same instant; what the clock does begins one of its own."""
    end = int(np.searchsorted(log.start, log.start[row], side="right"))
    ticks = np.flatnonzero(log.function[row + 1 : end] <= TICKED)
    return row + 1 + int(ticks[0]) if len(ticks) else end


def _by_rows(modes: Modes[Any], log: Log, end: float, distances: Reals) -> Reals:
    """Return what becomes of distances where modes are rows."""
    distances = _fitted(modes, int(log.mode[0]), distances)
    rows, row = len(log.start), 0
    while row < rows:
        following = end_of_instant(log, row)
        last = following - 1
        if log.function[row] <= TICKED and modes.samplings is not None:
            clock, code = modes.samplings.clock, TICKED - int(log.function[row])
            jumped = carried(clock, code, int(log.mode[row]), distances)
            distances[:] = _fitted(modes, int(log.mode[last]), jumped)
        elif row > 0:
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


def propagator(modes: Modes[Any], mode: int, duration: float) -> Reals:
    """Return exp(M duration) of a mode, (N, N); the duration in s. States that decay by themselves stay."""
    tables, size = modes.tables, modes.system.layout.size
    settled = int(tables.settled[mode])
    if tables.rows is not None:
        units = np.eye(size)
        carry(tables.rows, settled, float(tables.step[settled]), duration, units)
        transposed: Reals = units.T
        return transposed
    steps, fraction = divmod(duration / tables.step[settled], 1.0)
    terms = tables.series[settled].reshape(size, DEGREE + 1, size)
    rest = np.einsum("jki,k->ij", terms, fraction ** np.arange(DEGREE + 1))
    whole: Reals = np.linalg.matrix_power(tables.screen[settled, :, :size].T, int(steps))
    found: Reals = rest @ whole
    return found


def _jump(modes: Modes[Any], log: Log, first: int, last: int, distances: Reals) -> None:
    """Multiply by the jumps of what happens at one instant, one after the other."""
    count = len(distances)
    for each in jumps(modes, log, first, last):
        gradient, slope = each.function.row, each.slope
        moved = distances if each.reset is None else each.reset[:count, :count] @ distances
        if slope:
            # Before a reset is done the distance decides how much later the event comes.
            moved = moved + np.outer(each.change[:count] / slope, gradient[:count] @ distances)
        distances[:] = moved if each.after is None else _fitted(modes, each.after, moved)


@dataclass(frozen=True, eq=False)
class Saltation:
    """What one event makes of small distances."""

    before: int  # The mode before
    function: EventFunction  # What falls to zero
    # The mode afterwards; None between impulses at one instant, where nothing is made to fit
    after: int | None
    here: Reals  # Extended state at which it does, (N,)
    there: Reals  # The state afterwards, (N,)
    reset: Reals | None  # What becomes of the state, (N, N); None if it goes on
    rates: Reals  # Rates of the state before, 1/s, (N,)
    change: Reals  # Rates afterwards less those before, as the reset leaves them, (N,)
    kind: int | None = None  # What an impulse that was decided counts as; None for any other
    # Of what follows from it, and whose resets are in its own: numbers of modes, and of functions in them
    following: Sequence[tuple[int, int]] = ()

    @property
    def slope(self) -> float:
        """How fast the event function falls."""
        return float(self.function.row @ self.rates)


def jumps(modes: Modes[Any], log: Log, first: int, last: int) -> Iterator[Saltation]:
    """Yield what happens at one instant, of which some rows of a log tell, one after the other."""
    events = [row for row in range(first, last + 1) if log.function[row] >= 0]
    if not events:
        return
    if any(_impulse(modes, log, row) for row in range(first, last + 1)):
        yield from _jumps_by_impulses(modes, log, first, last)
        return
    found = list(changes(modes, log, first, last, int(log.function[events[0]])))
    resets = [modes.system.reset(modes[before], function) for before, function, _ in found]
    following = _that_follow(modes, log, events, found)
    resets[-1] = in_turn([resets[-1], *(reset for _, reset in following)])
    jumping = any(each is not None for each in resets)
    here = _before(modes, log, first) if jumping else log.state[first]
    for place, ((before, function, after), reset) in enumerate(zip(found, resets, strict=True), start=1):
        there = log.state[last] if not jumping else here if reset is None else reset @ here
        rates = modes[before].flow @ here
        change = modes[after].flow @ there - (rates if reset is None else reset @ rates)
        late = [number for number, _ in following] if place == len(found) else ()
        yield Saltation(before, function, after, here, there, reset, rates, change, following=late)
        here = there


def in_turn(resets: Iterable[Reals | None]) -> Reals | None:
    """Return the reset, (N, N), that some make one after the other; None if there is none among them."""
    made = [each for each in resets if each is not None]
    return reduce(lambda total, each: each @ total, made) if made else None


def _impulse(modes: Modes[Any], log: Log, row: int) -> tuple[Reals, Reals] | None:
    found: tuple[Reals, Reals] | None = modes.system.impulse(int(log.part[row]), int(log.kind[row]))
    return found


def _jumps_by_impulses(modes: Modes[Any], log: Log, first: int, last: int) -> Iterator[Saltation]:
    """Yield the impulses at one instant one after the other; all else that changes there follows the last.

    Each may come earlier or later in a neighbouring motion, but for one that ends what comes to rest.
    """
    before, after, here = int(log.mode[first - 1]), int(log.mode[last]), _before(modes, log, first)
    rows = [row for row in range(first, last + 1) if _impulse(modes, log, row)]
    for row in rows:
        impulse = _impulse(modes, log, row)
        assert impulse is not None
        reset, gap = impulse
        there, rates = reset @ here, modes[before].flow @ here
        is_last = row == rows[-1]
        change = modes[after if is_last else before].flow @ there - reset @ rates
        row_of_gap = gap if gap @ rates < 0 else np.zeros_like(gap)
        function = EventFunction(int(log.part[row]), STRUCK, row_of_gap)
        following, kind = after if is_last else None, int(log.kind[row])
        yield Saltation(before, function, following, here, there, reset, rates, change, kind)
        here = there


def _before(modes: Modes[Any], log: Log, row: int) -> Reals:
    """Return the extended state, (N,), just before what begins a row."""
    elapsed = float(log.start[row] - log.start[row - 1])
    state: Reals = propagator(modes, int(log.mode[row - 1]), elapsed) @ log.state[row - 1]
    return state


def _that_follow(
    modes: Modes[Any], log: Log, events: Sequence[int], found: Sequence[tuple[int, EventFunction, int]]
) -> list[tuple[tuple[int, int], Reals]]:
    """Return mode, function in it and reset, (N, N), of what resets the state beside what falls to zero."""
    known = {_at_status(modes[before], function) for before, function, _ in found}
    following = []
    for row in events[1:]:
        number, place = int(log.mode[row - 1]), int(log.function[row])
        fired = modes[number], modes[number].functions[place]
        reset = None if _at_status(*fired) in known else modes.system.reset(*fired)
        if reset is not None:
            following.append(((number, place), reset))
    return following


def _at_status(mode: ModeEquations, function: EventFunction) -> tuple[int, int, int]:
    """Return what tells an event function of a part: what it means, and in which status of the part."""
    return function.owner, function.action, mode.statuses[function.owner]


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
    same = (each for each in functions if key_of(each) == key_of(function))
    return next(same, function)


def key_of(function: EventFunction) -> tuple[int, int, tuple[int, ...]]:
    """Return what tells an event function in a mode: its owner, what it means, and in which directions."""
    return function.owner, function.action, function.signs
