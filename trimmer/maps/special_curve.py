"""Curves over a map, on which folds, period doublings, grazings and their like lie."""

from collections import Counter
from collections.abc import Callable, Iterator
from dataclasses import dataclass
from functools import cached_property
from itertools import pairwise

import numpy as np

from trimmer.arrays import Reals
from trimmer.branches import Locus, SpecialKind, SpecialPoint
from trimmer.one_orbit import same_states
from trimmer.showing.drawn import Drawn
from trimmer.showing.shown import Tabular, counted
from trimmer.showing.table import Column, Table

ON_CURVE = 5e-3  # Distance in shares of the ranges within which a special point lies on a curve that is known
INTERPOLATED = 5e-2  # Error of states between two points of a curve, relative to their sizes on it


@dataclass(frozen=True, eq=False, repr=False)
class SpecialCurve(Tabular, Drawn):
    """A curve on which a special point lies.

    ``plot`` draws it over both numbers, in their units, such as over a map.

    Attributes:
        sides: The locus from where it was found, on either side; one if it closes.
    """

    sides: tuple[Locus, ...]

    @property
    def kind(self) -> SpecialKind:
        """What happens there."""
        return self.sides[0].kind

    @property
    def parts(self) -> tuple[str, ...]:
        """Names of the parts whose phases change there."""
        return self.sides[0].parts

    @property
    def periods(self) -> int:
        """Drive periods after which the orbits repeat."""
        return self.sides[0].periods

    @cached_property
    def values(self) -> Reals:
        """Values of both numbers along the curve, SI units, (points, 2)."""
        return np.concatenate([self.sides[-1].values[:0:-1], self.sides[0].values][-len(self.sides) :])

    @cached_property
    def states(self) -> Reals:
        """States at the start of a drive period, (points, n)."""
        return np.concatenate([self.sides[-1].states[:0:-1], self.sides[0].states][-len(self.sides) :])

    @property
    def residual(self) -> float:
        """Largest difference of an orbit's end and start, relative to the sizes of the states."""
        return float(max(np.nanmax(side.residual) for side in self.sides))

    @property
    def ends(self) -> tuple[Locus, ...]:
        """The sides in the order of the curve's ends; one that closes has one."""
        return self.sides[::-1]

    @property
    def name(self) -> str:
        """What it is, with the parts, for a legend."""
        return self.sides[0].name

    def _told(self) -> str:
        return f"{self.name} over {' and '.join(self.sides[0].places)}, {counted(len(self.values), 'point')}"

    def _table(self) -> Table:
        return SpecialCurves((self,), "")._table()

    def holds(self, point: SpecialPoint, second: float, spans: Reals) -> bool:
        """Say whether it passes a special point at a value of the second number, as near as can be told."""
        if (point.kind, point.parts) != (self.kind, self.parts):
            return False
        sizes = abs(self.states).max(axis=0)
        sizes = np.where(sizes > 0.0, sizes, 1.0)
        target = np.array([point.value, second]) / spans
        return any(
            _passes(values / spans, states, target, point.state, sizes)
            for values, states in zip(_pairs(self.values), _pairs(self.states), strict=True)
        )


def _pairs(rows: Reals) -> Iterator[Reals]:
    """Yield each two rows that follow one another, (2, n)."""
    return (np.array(pair) for pair in pairwise(rows))


def are_alike(state: Reals, another: Reals, sizes: Reals) -> bool:
    """Return whether two orbits seem to be one, of which states between points of curves are known, (n,)."""
    return same_states(state[None], another[None], INTERPOLATED * sizes)


def _passes(values: Reals, states: Reals, target: Reals, state: Reals, sizes: Reals) -> bool:
    chord = values[1] - values[0]
    length = float(chord @ chord)
    share = float(np.clip(chord @ (target - values[0]) / length, 0.0, 1.0)) if length else 0.0
    near = np.linalg.norm(values[0] + share * chord - target) <= ON_CURVE
    between = states[0] + share * (states[1] - states[0])
    return bool(near and are_alike(between, state, sizes))


@dataclass(frozen=True, eq=False)
class Meeting:
    """Where two curves meet with the same orbit, as near as the points of the curves tell.

    Attributes:
        curves: Numbers of the two curves, the lower first.
        values: Values of both numbers, SI units, (2,).
        ends: Whether one of them ends there; otherwise they cross.
        distance: How far apart they are, as a share of the ranges; 0 where they cross.
    """

    curves: tuple[int, int]
    values: Reals
    ends: bool
    distance: float


@dataclass(frozen=True, eq=False, repr=False)
class SpecialCurves(Tabular, Drawn):
    """The curves over a map.

    ``plot`` draws them over both numbers, in their units, such as over a map.

    Attributes:
        curves: The curves, in the order in which they were found.
        searched: What was looked for and where, in a sentence.
        meetings: Where two of them meet.
    """

    curves: tuple[SpecialCurve, ...]
    searched: str
    meetings: tuple[Meeting, ...] = ()

    @property
    def drawn(self) -> list[tuple[str, Reals]]:
        """The curves as ``MotionMap.plot`` takes them, ordered by their names."""
        return sorted(((curve.name, curve.values) for curve in self.curves), key=lambda each: each[0])

    @property
    def places_and_units(self) -> tuple[tuple[str, str], tuple[str, str]]:
        """Places and units of the two numbers; empty if there is no curve."""
        if not self.curves:
            return ("", ""), ("", "")
        side = self.curves[0].sides[0]
        return side.places, side.units

    def _told(self) -> str:
        kinds = Counter(curve.kind.word for curve in self.curves)
        found = ", ".join(f"{count} of {word}" for word, count in kinds.items())
        return counted(len(self.curves), "curve") + (f": {found}" if found else "")

    def _table(self) -> Table:
        items = [
            (number, curve, values) for number, curve in enumerate(self.curves) for values in curve.values
        ]
        columns = [
            Column("curve", "", lambda item: item[0]),
            Column("kind", "", lambda item: item[1].kind),
            Column("parts", "", lambda item: ", ".join(item[1].parts)),
            Column("drive_periods", "", lambda item: item[1].periods),
        ]
        if self.curves:
            columns += [
                Column(place, unit, _value(number))
                for number, (place, unit) in enumerate(zip(*self.places_and_units, strict=True))
            ]
        return Table("Points of the curves", items, tuple(columns))


def _value(number: int) -> Callable[[tuple[int, SpecialCurve, Reals]], float]:
    """Return what gives one of the two values of a point beside its curve."""
    return lambda item: float(item[2][number])
