"""The modes of systems that differ by one number, where their tables are affine in it, as in a gap.

The tables are built at three values, of which that midway says whether they are affine. At any other value
between they are a sum, and nothing is assembled. Sums of moduli only bound rounding: they are convex, and the
sum is an upper bound of them.
"""

from __future__ import annotations

import sys
from collections.abc import Mapping
from dataclasses import dataclass
from typing import Any, Generic, NamedTuple, TypeVar

import numpy as np

from trimmer.arrays import Places, Reals
from trimmer.hybrid.system import System
from trimmer.hybrid.tables import FIXED, NO_RESET, UNKNOWN, Modes, Tables

UNUSED = 2  # References to an array that one list alone holds, while they are counted
STRAIGHT = 2.0**-46  # Share of the largest number of a kind by which a table may miss a straight line
NUMBERS = ("flow", "hold", "decay", "decayed", "scale", "resets", "series", "taylor", "sizes", "screen")
"""Tables of numbers."""
OF_EVENTS = ("target", "kind", "zeros", "reset", "resets")  # Tables that grow as events are met
SAME = (
    "statuses",
    "settled",
    "step",
    "terms",
    "function_count",
    "owner",
    "action",
    "continuous",
    "target",
    "reset",
)
"""Tables that do not depend on the number."""
_System = TypeVar("_System", bound=System)


class ArrayChange(NamedTuple):
    """By how much a table changes from the first value to the last: places in it, and how much there."""

    places: Places
    by: Reals

    def on(self, table: Reals, share: float) -> Reals:
        """Return a table at a share of the way."""
        found = table.copy()
        found.reshape(-1)[self.places] += share * self.by
        return found

    def alone(self, table: Reals) -> Reals:
        """Return the change as a table."""
        found = np.zeros_like(table)
        found.reshape(-1)[self.places] = self.by
        return found

    @classmethod
    def between(cls, first: Reals, last: Reals) -> ArrayChange:
        """Return how one table becomes another; what is not finite is the same in both."""
        places = np.flatnonzero(first != last)
        return cls(places, last.reshape(-1)[places] - first.reshape(-1)[places])


def is_straight(first: Reals, middle: Reals, last: Reals) -> bool:
    """Say whether a table changes evenly with a number, from a first value to a last one."""
    return _is_straight(first, middle, last, axis=None)


def _is_straight(*three: Reals, axis: int | None) -> bool:
    """Say so of tables with numbers of one kind, whose rounding may be compared, along an axis."""
    first, middle, last = three
    same = first == last
    size = np.maximum(abs(first), abs(last))
    size = size if axis is None else size.max(axis=axis, keepdims=True)
    with np.errstate(invalid="ignore"):
        missed = np.where(same, middle != first, abs(middle - 0.5 * (first + last)))
    return bool((missed <= STRAIGHT * size).all())


@dataclass(eq=False)
class AffineModes(Generic[_System]):
    """The modes of a system over a number."""

    # first, middle, last: The modes at a first value, midway, and at a last one
    first: Modes[_System]
    middle: Modes[_System]
    last: Modes[_System]

    def __post_init__(self) -> None:
        self._base: Tables | None = None
        self._changes: Mapping[str, ArrayChange] = {}
        self._blocks: _Blocks | None = None

    def learn(self, modes: Modes[Any]) -> bool:
        """Take the modes and transitions that other modes have met; say whether all are affine still."""
        if self._base is None or modes.tabulated or len(modes.statuses) > len(self.first.statuses):
            before = self.first.tabulated, len(self.first.statuses)
            self._take(modes)
            if self._base is None or before != (self.first.tabulated, len(self.first.statuses)):
                self._base = self._affine()
        return self._base is not None

    def _take(self, modes: Modes[Any]) -> None:
        for each in (self.first, self.middle, self.last):
            for statuses in modes.statuses:
                each.number(statuses)
            for there, function, jumped in np.argwhere(modes.tables.target != UNKNOWN).tolist():
                number = each.number(modes.statuses[there])
                is_there = function < len(each[number].functions)
                if is_there and each.tables.target[number, function, jumped] == UNKNOWN:
                    each.follow(number, function, bool(jumped))

    def _affine(self) -> Tables | None:
        """Return the tables at the first value, and keep how they change; None if that is not even."""
        three = [_first(each.tables, len(each.statuses)) for each in (self.first, self.middle, self.last)]
        first, middle, last = three
        same = all(
            np.array_equal(getattr(first, name), getattr(each, name)) for each in three for name in SAME
        )
        if not same or not _are_straight(first, middle, last):
            return None
        changes = {name: ArrayChange.between(getattr(first, name), getattr(last, name)) for name in NUMBERS}
        self._changes = {name: change for name, change in changes.items() if len(change.places)}
        self._blocks = _Blocks.of(first, self._changes)
        return first

    def numbers_alike(self, modes: Modes[Any]) -> bool:
        """Say whether other modes have the numbers here that they have there, and their resets."""
        own, count = self.first, len(modes.statuses)
        alike = own.statuses[:count] == modes.statuses
        if not alike or not modes.tabulated:
            return alike
        here, there = own.tables.reset[:count], modes.tables.reset[:count]
        return here.shape[1:] == there.shape[1:] and bool((here == there)[there != NO_RESET].all())

    def at(self, share: float, system: _System) -> Modes[_System]:
        """Return the modes of the system at a share of the way from the first value to the last."""
        assert self._base is not None
        assert self._blocks is not None
        base, changed = self._base, self._blocks.at(share)
        own = {name: getattr(base, name).copy() for name in OF_EVENTS if name not in changed}
        return self.first.continued(system, base._replace(**{**changed, **own}))

    def change(self, name: str) -> Reals:
        """Return by how much a table changes from the first value to the last."""
        assert self._base is not None
        table: Reals = getattr(self._base, name)
        return self._changes[name].alone(table) if name in self._changes else np.zeros_like(table)


@dataclass(eq=False)
class _Blocks:
    """Memory for the tables that change with a number, each piece of it for those of one value.

    Copying them takes longer than to write what changes. So a piece is written again once nobody holds a
    table in it any more, which its reference count tells.
    """

    base: Reals  # All these tables at the first value, one after the other
    change: ArrayChange  # Their change
    start: Reals  # What they are where they change, at the first value
    parts: Mapping[str, tuple[slice, tuple[int, ...]]]  # Where each of them is, and its shape
    known: list[Reals]  # The pieces

    @classmethod
    def of(cls, base: Tables, changes: Mapping[str, ArrayChange]) -> _Blocks:
        """Return memory for some tables, of which that at the first value and the changes are given."""
        parts, places, end = dict[str, tuple[slice, tuple[int, ...]]](), [np.empty(0, dtype=np.intp)], 0
        for name, change in changes.items():
            table = getattr(base, name)
            parts[name] = slice(end, end + table.size), table.shape
            places.append(end + change.places)
            end += table.size
        first = np.concatenate([np.empty(0), *(getattr(base, name).reshape(-1) for name in changes)])
        by = np.concatenate([np.empty(0), *(each.by for each in changes.values())])
        change = ArrayChange(np.concatenate(places), by)
        return cls(first, change, first[change.places], parts, [])

    def at(self, share: float) -> dict[str, Any]:
        """Return the tables at a share of the way by their names."""
        free = (each for each in range(len(self.known)) if sys.getrefcount(self.known[each]) == UNUSED)
        number = next(free, None)
        if number is None:
            number = len(self.known)
            self.known.append(self.base.copy())
        block, places = self.known[number], self.change.places
        block[places] = self.start + share * self.change.by
        return {name: block[part].reshape(shape) for name, (part, shape) in self.parts.items()}


def _are_straight(*three: Tables) -> bool:
    """Say whether tables at three values change evenly, those of a whole step with what they are made of."""
    count, size = three[0].flow.shape[:2]
    series = (each.series.reshape(count, size, -1, size) for each in three)
    return _is_straight(*series, axis=2) and all(
        _is_straight(*(getattr(each, name) for each in three), axis=3 if name == "taylor" else None)
        for name in NUMBERS
        if name not in ("series", "screen", "sizes")
    )


def _first(tables: Tables, count: int) -> Tables:
    """Return the tables of the first modes."""
    return tables._replace(
        **{name: each[:count] for name, each in tables._asdict().items() if name not in FIXED}
    )
