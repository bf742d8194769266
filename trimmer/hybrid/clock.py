"""What happens to the state at known times: parts that sample it and hold what follows, compiled.

A sampler takes a demand from the state at one instant, limits it, and writes places of the state that nothing
else moves; of those one may begin to act at another instant, which is a plain copy. All that is due at one
instant is done together: first every sampler reads the state as it was, then what is due acts.
"""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass, field
from typing import TYPE_CHECKING, Any, NamedTuple

import numpy as np

from trimmer.arrays import Integers, Reals
from trimmer.hybrid.compilation import compiled, kept, sources
from trimmer.hybrid.linear_combination import copy
from trimmer.hybrid.system import ARRIVED, AT_LIMIT
from trimmer.hybrid.taylor import MOST_ZEROS

if TYPE_CHECKING:
    from trimmer.hybrid.system import Clockwork, ModeEquations, Sampler

TICKED = -10
"""In place of the event function that began a segment: an instant of the clock, with its code subtracted."""
DUE = -4
"""In place of an event function that has fallen to zero: an instant of the clock is due."""
TOGETHER = 1e-9
"""Share of a sample within which what happens is at one instant."""
WITHIN, ABOVE, BELOW = range(3)
"""Where a demand is: within its limit, or beyond it on either side."""


class Clock(NamedTuple):
    """What is due in each period, and what it does; c samplers that write up to h places each.

    Attributes:
        times: Of the instants of a period, s, rising, (instants,).
        samples: Whether a sampler samples there, (instants, c).
        acts: Whether what it holds acts from there on, (instants, c).
        slack: How much later an event may be that still comes first, s.
        first: Whether an event function is one of those that do, (modes, functions).
        continuous: How many derivatives of event functions do not jump at an instant, (modes, functions).
        demand: What is limited, (modes, c, N).
        limit: Its largest modulus, (c,).
        places: Where the state is written, -1 for nowhere, (c, h).
        updates: What is written there, within the limit and beyond it on either side, (modes, c, 3, h, N).
        acting: Where stands what is to act, and where what acts; twice the same if it acts at once, (c, 2).
    """

    times: Reals
    samples: Integers
    acts: Integers
    slack: float
    first: Integers
    continuous: Integers
    demand: Reals
    limit: Reals
    places: Integers
    updates: Reals
    acting: Integers


@compiled
def _dot(row: Reals, state: Reals) -> float:
    total = 0.0
    for i in range(state.size):
        total += row[i] * state[i]
    return total


@compiled
def tick(clock: Clock, number: int, mode: int, state: Reals, before: Reals) -> int:
    """Do what is due at an instant; returns its code, which tells the instant and where demands are."""
    copy(state, state.size, before)
    code = 0
    for c in range(clock.limit.size):
        if clock.samples[number, c]:
            demand, where = _dot(clock.demand[mode, c], before), WITHIN
            if demand > clock.limit[c]:
                where = ABOVE
            elif demand < -clock.limit[c]:
                where = BELOW
            for h in range(clock.places.shape[1]):
                if clock.places[c, h] >= 0:
                    state[clock.places[c, h]] = _dot(clock.updates[mode, c, where, h], before)
            code = 4 * code + 1 + where
        else:
            code = 4 * code
    for c in range(clock.limit.size):
        if clock.acts[number, c]:
            state[clock.acting[c, 1]] = state[clock.acting[c, 0]]
        code = 2 * code + clock.acts[number, c]
    return code


@compiled
def instant_of(start: Reals, functions: Integers, row: int) -> tuple[int, int]:
    """Return the row after those of an instant, of which a row is the first, and the first event function.

    What the clock does begins an instant of its own. Given are times and event functions of a log.
    """
    following, fired = row + 1, functions[row]
    while following < start.size and start[following] == start[row]:
        if functions[following] <= TICKED:
            break
        if TICKED < fired < 0:
            fired = functions[following]
        following += 1
    return following, fired


@compiled
def carry(clock: Clock, code: int, mode: int, distances: Reals, before: Reals) -> None:
    """Do with distances of the state, (n, columns), in place, what an instant with a code does with it."""
    count, columns = distances.shape
    for i in range(count):
        for k in range(columns):
            before[i, k] = distances[i, k]
    samplers = clock.limit.size
    sampled = code >> samplers
    for c in range(samplers - 1, -1, -1):
        where = sampled % 4 - 1
        sampled //= 4
        for h in range(clock.places.shape[1] if where >= 0 else 0):
            place = clock.places[c, h]
            for k in range(columns if place >= 0 else 0):
                total = 0.0
                for i in range(count):
                    total += clock.updates[mode, c, where, h, i] * before[i, k]
                distances[place, k] = total
    for c in range(samplers):
        if (code >> (samplers - 1 - c)) & 1:
            for k in range(columns):
                distances[clock.acting[c, 1], k] = distances[clock.acting[c, 0], k]


def _entry(sources: bytes) -> Callable[..., None]:
    def entry(clock: Clock, code: int, mode: int, distances: Reals, before: Reals) -> None:
        sources  # noqa: B018
        carry(clock, code, mode, distances, before)

    return kept(entry)


_compiled_entry = _entry(sources())


def carried(clock: Clock, code: int, mode: int, distances: Reals) -> Reals:
    """Return what an instant with a code makes of distances or states, (n, columns)."""
    found = np.array(distances, order="C")
    _compiled_entry(clock, code, mode, found, np.empty_like(found))
    return found


ROOM = 16
"""Modes for which there is room at first."""


@dataclass(eq=False)
class Samplings:
    """What samplers do in the modes that were met so far.

    Attributes:
        clockwork: The samplers.
        clock: What they do in all modes so far, without instants; it is replaced where there is no room.
    """

    clockwork: Clockwork
    clock: Clock = field(init=False)
    _count: int = 0

    def __post_init__(self) -> None:
        samplers = self.clockwork.samplers
        height = max(len(each.places) for each in samplers)
        none = np.zeros((0, len(samplers)), dtype=np.int64)
        self.clock = Clock(
            times=np.empty(0),
            samples=none,
            acts=none,
            slack=TOGETHER * min(each.sample for each in samplers),
            first=np.zeros((0, 0), dtype=np.int64),
            continuous=np.zeros((0, 0), dtype=np.int64),
            demand=np.empty((0, len(samplers), 0)),
            limit=np.array([each.limit for each in samplers]),
            places=np.array([[*each.places, *[-1] * (height - len(each.places))] for each in samplers]),
            updates=np.empty((0, len(samplers), 3, height, 0)),
            acting=np.array([each.acting for each in samplers], dtype=np.int64),
        )

    def add(self, modes: Any, number: int) -> None:
        """Add the mode with the next number."""
        assert number == self._count
        self._count += 1
        demand, updates = self.clockwork.sampling(modes, number)
        first, continuous = _of_functions(self.clockwork.samplers, modes[number])
        self._make_room(len(first), demand.shape[1])
        self.clock.demand[number], self.clock.updates[number] = demand, updates
        self.clock.first[number, : len(first)] = first
        self.clock.continuous[number, : len(first)] = continuous

    def _make_room(self, functions: int, size: int) -> None:
        room, wide = self.clock.first.shape
        if self._count <= room and functions <= wide:
            return
        room, wide = (2 * room or ROOM) if self._count > room else room, max(functions, wide)
        larger = {"first": (room, wide), "continuous": (room, wide)}
        larger |= {
            name: (room, *getattr(self.clock, name).shape[1:-1], size) for name in ("demand", "updates")
        }
        made: dict[str, Any] = {}
        for name, shape in larger.items():
            old = getattr(self.clock, name)
            made[name] = np.zeros(shape, dtype=old.dtype)
            if old.size:
                made[name][tuple(slice(0, length) for length in old.shape)] = old
        self.clock = self.clock._replace(**made)


def _of_functions(samplers: tuple[Sampler, ...], mode: ModeEquations) -> tuple[list[int], list[int]]:
    """Return which event functions come first at an instant, and how many derivatives do not jump there."""
    written = [place for each in samplers for place in (*each.places, each.acting[1])]
    continuous = []
    for function in mode.functions:
        row, derivatives = function.row, 0
        while derivatives < MOST_ZEROS and not row[written].any():
            row, derivatives = row @ mode.flow, derivatives + 1
        continuous.append(derivatives)
    first = [int(function.action not in (ARRIVED, AT_LIMIT)) for function in mode.functions]
    return first, continuous


class Instants(NamedTuple):
    """When samplers sample and act in a period: as those of ``Clock``."""

    times: Reals
    samples: Integers
    acts: Integers


def instants(samplers: tuple[Sampler, ...], begin: float, length: float) -> Instants:
    """Return the instants from a time, s, on over a length, s: those at its end belong to what follows.

    Args:
        samplers: What samples.
        begin: Time since all samplers sampled together, s.
        length: s.
    """
    times, what = [], []
    for number, each in enumerate(samplers):
        for offset, column in ((0.0, number), (each.delay, len(samplers) + number)):
            first, end = (
                int(np.ceil((time - offset) / each.sample - TOGETHER)) for time in (begin, begin + length)
            )
            times.append(np.maximum(np.arange(first, end) * each.sample + (offset - begin), 0.0))
            what.append(np.full(max(end - first, 0), column))
    at, of = np.concatenate(times), np.concatenate(what)
    order = np.argsort(at, kind="stable")
    at, of = at[order], of[order]
    near = TOGETHER * min(each.sample for each in samplers)
    begins = np.append(True, np.diff(at) > near) if len(at) else np.empty(0, dtype=bool)
    found = np.zeros((int(begins.sum()), 2 * len(samplers)), dtype=np.int64)
    found[np.cumsum(begins) - 1, of] = 1
    samples, acts = np.ascontiguousarray(found[:, : len(samplers)]), found[:, len(samplers) :]
    return Instants(at[begins], samples, np.ascontiguousarray(acts))
