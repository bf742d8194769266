"""The modes that a motion has met, as the tables that the compiled integration reads."""

from __future__ import annotations

from dataclasses import dataclass, field
from functools import cached_property
from typing import Generic, NamedTuple, TypeVar

import numpy as np

from trimmer.arrays import Integers, Reals
from trimmer.hybrid.series import ModeTables, tabulate
from trimmer.hybrid.system import Mode, System
from trimmer.hybrid.taylor import DEGREE, LEVELS, bernstein_from_taylor

UNKNOWN = -1
"""In place of a mode to go on in: not tabulated yet."""
NO_RESET = -1
"""In place of the number of a reset: the state goes on."""
JOINT = -2
"""In place of a mode to go on in: several parts at rest decide it together."""
CAPACITY = 12
"""Modes for which there is room at first."""


class Tables(NamedTuple):
    """First axis: mode; second: event function; last of transitions: fell to zero, or was negative at once.

    Attributes:
        statuses: Of all parts, (modes, parts).
        settled: The mode without states that decay by themselves, itself if there are none, (modes,).
        step: Length h of a step, s, (modes,).
        screen: Side by side exp(M h), transposed, and the Bernstein coefficients of the event functions over
            a step, (modes, N, N + functions (K + 1)).
        series: (M h)^k / k!, transposed and side by side, (modes, N, (K + 1) N).
        terms: How many terms of the series do for fractions up to 4^-level of a step, (modes, LEVELS).
        taylor: Coefficients of s^k of the event functions, (modes, functions, N, K + 1).
        sizes: Sums of the moduli of what these are made of, (modes, functions, K + 1, N).
        flow: The matrix M, (modes, N, N).
        hold: The state, made to fit what is held, transposed, (modes, N, N).
        function_count: Number of event functions, (modes,).
        owner: The parts that they belong to, (modes, functions).
        action: What it means that they fall to zero, (modes, functions).
        continuous: How many of their derivatives do not jump with other parts, (modes, functions).
        target: The mode to go on in, (modes, functions, 2).
        kind: What the event counts as, (modes, functions, 2).
        zeros: How many derivatives of the event functions of the part vanish then, by their actions,
            (modes, functions, 2, actions).
        reset: Number of the state's reset, ``NO_RESET`` for none, (modes, functions, 2).
        resets: The resets, transposed, (resets, N, N).
        decaying_state: Place of the state of each part that may decay by itself, -1 for none, (m,).
        decay: Rates of those that decay, 1/s, 0 for others, (modes, m).
        decayed: Rates of those that decay or have done so, and count as zero, 1/s, 0 for others, (modes, m).
        scale: Size by which it is measured what of it is negligible, (m,).
        bernstein_from_taylor: Matrices of ``trimmer.hybrid.taylor.bernstein_from_taylor``.
    """

    statuses: Integers
    settled: Integers
    step: Reals
    screen: Reals
    series: Reals
    terms: Integers
    taylor: Reals
    sizes: Reals
    flow: Reals
    hold: Reals
    function_count: Integers
    owner: Integers
    action: Integers
    continuous: Integers
    target: Integers
    kind: Integers
    zeros: Integers
    reset: Integers
    resets: Reals
    decaying_state: Integers
    decay: Reals
    decayed: Reals
    scale: Reals
    bernstein_from_taylor: Reals


def _empty(system: System, capacity: int, functions: int) -> Tables:
    size, decaying, degree = system.layout.size, system.decaying_states, DEGREE + 1

    def integers(*shape: int) -> Integers:
        return np.full((capacity, *shape), UNKNOWN, dtype=np.int64)

    return Tables(
        statuses=integers(system.part_count),
        settled=integers(),
        step=np.empty(capacity),
        screen=np.empty((capacity, size, size + functions * degree)),
        series=np.empty((capacity, size, degree * size)),
        terms=integers(LEVELS),
        taylor=np.empty((capacity, functions, size, degree)),
        sizes=np.empty((capacity, functions, degree, size)),
        flow=np.empty((capacity, size, size)),
        hold=np.empty((capacity, size, size)),
        function_count=integers(),
        owner=integers(functions),
        action=integers(functions),
        continuous=integers(functions),
        target=integers(functions, 2),
        kind=integers(functions, 2),
        zeros=integers(functions, 2, system.action_count),
        reset=integers(functions, 2),
        resets=np.empty((0, size, size)),
        decaying_state=decaying,
        decay=np.zeros((capacity, len(decaying))),
        decayed=np.zeros((capacity, len(decaying))),
        scale=system.scales,
        bernstein_from_taylor=bernstein_from_taylor(),
    )


_FIXED = ("decaying_state", "scale", "bernstein_from_taylor", "resets")
_System = TypeVar("_System", bound=System)


@dataclass(eq=False)
class Modes(Generic[_System]):
    """The modes of a system by number; they are assembled and tabulated when they are first asked for.

    Attributes:
        system: What moves.
        tables: Tables of the modes that were asked for.
    """

    system: _System
    _known: list[Mode] = field(default_factory=list, init=False, repr=False)
    _numbers: dict[tuple[int, ...], int] = field(default_factory=dict, init=False, repr=False)

    @cached_property
    def tables(self) -> Tables:
        """Tables of all modes so far; they are replaced where there is no room."""
        return _empty(self.system, CAPACITY, 2 * self.system.part_count)

    def __getitem__(self, number: int) -> Mode:
        return self._known[number]

    def number(self, statuses: tuple[int, ...]) -> int:
        """Return the number of a mode, which is tabulated when it is new."""
        if statuses in self._numbers:
            return self._numbers[statuses]
        mode = self.system.mode(statuses)
        settled = self.number(mode.settled) if mode.settled != statuses else None
        number = len(self._known)
        self._make_room(number + 1, len(mode.functions))
        self._numbers[statuses] = number
        self._known.append(mode)
        self._tabulate(number, mode)
        self.tables.settled[number] = number if settled is None else settled
        return number

    def follow(self, number: int, function: int, jumped: bool) -> None:
        """Tabulate the mode that follows an event, if the statuses decide it."""
        change = self.system.transition(self[number], self[number].functions[function], jumped)
        target = JOINT if change is None else self.number(change.statuses)
        place = number, function, int(jumped)
        self.tables.target[place] = target
        if change is not None:
            self.tables.kind[place] = change.kind
            self.tables.zeros[place] = 0
            for action, zeros in change.zeros:
                self.tables.zeros[(*place, action)] = zeros
            self.tables.reset[place] = NO_RESET if change.reset is None else self._keep(change.reset)

    def _make_room(self, modes: int, functions: int) -> None:
        tables = self.tables
        if modes <= len(tables.step) and functions <= tables.taylor.shape[1]:
            return
        capacity = max(len(tables.step), 2 * len(tables.step) * (modes > len(tables.step)))
        larger = _empty(self.system, capacity, max(functions, tables.taylor.shape[1]))
        for name, old in tables._asdict().items():
            if name not in _FIXED:
                new = getattr(larger, name)
                new[tuple(slice(0, length) for length in old.shape)] = old
        self.__dict__["tables"] = larger._replace(resets=tables.resets)

    def _keep(self, reset: Reals) -> int:
        """Keep a reset, and return its number."""
        tables = self.tables
        self.__dict__["tables"] = tables._replace(resets=np.concatenate([tables.resets, reset.T[None]]))
        return len(tables.resets)

    def _tabulate(self, number: int, mode: Mode) -> None:
        tables, count = self.tables, len(mode.functions)
        rows = np.array([each.row for each in mode.functions]).reshape(count, len(mode.flow))
        target = ModeTables(
            tables.screen[number],
            tables.series[number],
            tables.terms[number],
            tables.taylor[number],
            tables.sizes[number],
            tables.bernstein_from_taylor,
        )
        tables.step[number] = tabulate(mode.flow, self.system.layout.state_count, rows, target)
        tables.statuses[number] = mode.statuses
        tables.flow[number], tables.hold[number] = mode.flow, mode.hold.T
        tables.function_count[number] = count
        tables.owner[number, :count] = [each.owner for each in mode.functions]
        tables.action[number, :count] = [each.action for each in mode.functions]
        tables.continuous[number, :count] = [each.continuous for each in mode.functions]
        tables.decay[number] = mode.decay
        for place, rate in mode.decayed:
            tables.decayed[number, tables.decaying_state == place] = rate
