"""The locus of a special point over two numbers of a mechanism."""

from dataclasses import dataclass

from trimmer.arguments import finite_number, positive_number, whole_number
from trimmer.arrays import Reals
from trimmer.branches.special import SpecialKind
from trimmer.choices import Choice
from trimmer.showing.drawn import Drawn
from trimmer.showing.shown import Tabular, counted
from trimmer.showing.table import Column, Table, arrays


class LocusEnd(Choice):
    """Why a locus ends."""

    LEFT = "it leaves the ranges"
    CLOSED = "it closes on itself"
    CHANGED = "the point becomes one of another kind, or of other parts"
    CUSP = "it turns sharply back, as where two folds meet in a cusp"
    LOST = "no such point was found near the last one"
    MOST_POINTS = "it has as many points as were asked for at most"

    @property
    def is_success(self) -> bool:
        """Whether there is no more of it, as far as it is known."""
        return self in (LocusEnd.LEFT, LocusEnd.CLOSED)


@dataclass(frozen=True)
class LocusSettings:
    """How a locus is followed.

    Attributes:
        most_points: Number of points after which to stop.
        largest_step: Largest change of the two numbers between two points, as a share of their ranges.
        smallest_step: The same below which a step is not shortened any more.
        quiet: Whether to show no progress bar.

    Raises:
        WrongTypeError: if one of them has another type.
        ValueError: if one is out of its range.
    """

    most_points: int = 400
    largest_step: float = 0.03
    smallest_step: float = 1e-5
    quiet: bool = False

    def __post_init__(self) -> None:
        whole_number("most_points", self.most_points, 2)
        if positive_number("largest_step", self.largest_step) > 1.0:
            raise ValueError(f"largest_step must be a share of the ranges, not {self.largest_step!r}")
        if positive_number("smallest_step", self.smallest_step) > self.largest_step:
            raise ValueError(f"smallest_step must not be above largest_step, but is {self.smallest_step!r}")


@dataclass(frozen=True)
class LocusRanges:
    """The values within which a locus is followed, in the units of the numbers.

    Attributes:
        first: Lowest and highest of the first number.
        second: Of the second.

    Raises:
        ValueError: if one is empty.
    """

    first: tuple[float, float]
    second: tuple[float, float]

    def __post_init__(self) -> None:
        for name, (lowest, highest) in (("first", self.first), ("second", self.second)):
            if not finite_number(name, lowest) < finite_number(name, highest):
                raise ValueError(f"{name} must be a lower and a higher number, not {(lowest, highest)!r}")

    @property
    def both(self) -> tuple[tuple[float, float], tuple[float, float]]:
        """First and second."""
        return self.first, self.second


@dataclass(frozen=True, eq=False, repr=False)
class Locus(Tabular, Drawn):
    """Where a special point lies over two numbers: of each pair the exact orbit is known.

    Each point is located as on a branch, to some 1e-10 of the numbers.

    ``plot`` draws it over both numbers, in their units, such as over a map.

    Attributes:
        kind: What happens there.
        parts: Names of the parts whose phases change there.
        places: Dotted places of the two numbers.
        periods: Drive periods after which the orbits repeat.
        values: Values of both numbers, in their units, (points, 2).
        states: States at the start of a drive period, (points, n).
        residual: Difference of each orbit's end and start, relative to the sizes of the states, (points,).
        distance: How far the nearest Floquet multiplier is from what the kind says: 1, -1 or the unit circle,
            (points,); NaN for a grazing or stick, which no multiplier shows. One of the half period for an
            orbit that is its own mirror image then.
        reason: Why it ends.
        message: The same as a sentence, with the values at which it ends.
        units: Of the two numbers; empty for a number without one.
    """

    kind: SpecialKind
    parts: tuple[str, ...]
    places: tuple[str, str]
    periods: int
    values: Reals
    states: Reals
    residual: Reals
    distance: Reals
    reason: LocusEnd
    message: str
    units: tuple[str, str] = ("", "")

    @property
    def first(self) -> Reals:
        """Values of the first number, (points,)."""
        return self.values[:, 0]

    @property
    def second(self) -> Reals:
        """Values of the second number, (points,)."""
        return self.values[:, 1]

    @property
    def name(self) -> str:
        """What it is, with the parts, for a legend."""
        parts = f", {' and '.join(self.parts)}" if self.parts else ""
        return f"{self.kind.word}{parts}"

    def _told(self) -> str:
        over, points = " and ".join(self.places), counted(len(self.values), "point")
        return f"{self.name} over {over}, {points}; {self.message}"

    def _table(self) -> Table:
        places = (
            Column(place, unit, self.values[:, number].__getitem__)
            for number, (place, unit) in enumerate(zip(self.places, self.units, strict=True))
        )
        measures = arrays(residual=("", self.residual), distance=("", self.distance))
        return Table(self.name, range(len(self.values)), (*places, *measures))

    @property
    def success(self) -> bool:
        """Whether it was followed until it leaves the ranges or closes."""
        return self.reason.is_success
