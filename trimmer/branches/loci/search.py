"""What is followed over two numbers, and finding it again where one of them is held."""

from dataclasses import dataclass, field, replace

import numpy as np

from trimmer.arrays import Reals
from trimmer.branches.loci.locus import LocusRanges
from trimmer.branches.loci.relocation import Sought, relocated
from trimmer.branches.period_maps.driven_map import DrivenMap
from trimmer.branches.special import SpecialPoint
from trimmer.errors import MechanismError

PREDICTING = 3  # Points from which the next one is predicted


@dataclass(frozen=True, eq=False)
class LocusPoint:
    """A point of a locus."""

    values: Reals  # As shares of the ranges, (2,)
    state: Reals  # State where the orbits begin at present, (n,)
    sizes: Reals  # Its scale, (n,)
    strobed: Reals  # State at the start of a drive period, (n,)


@dataclass(frozen=True, eq=False)
class Search:
    """What is followed: maps over either number, what is sought, the ranges and their lengths, (2,)."""

    maps: tuple[DrivenMap, DrivenMap]
    sought: Sought
    ranges: LocusRanges

    @property
    def spans(self) -> Reals:
        """Lengths of the ranges, (2,)."""
        return np.array([highest - lowest for lowest, highest in self.ranges.both])

    @property
    def lowest(self) -> Reals:
        """Where they begin, (2,)."""
        return np.array([lowest for lowest, _ in self.ranges.both])

    def map_at(self, held: int, value: float, share: float | None = None) -> DrivenMap:
        """Return the map over the number that is not held, with a value of the one that is.

        Args:
            held: Which one that is.
            value: Its value.
            share: Where orbits begin, in drive periods after the start of one.
        """
        map = self.maps[1 - held] if share is None else self.maps[1 - held].begun_at(share)
        return replace(map, subject=map.subject.with_value(self.maps[held].place, value))

    def inside(self, values: Reals) -> bool:
        """Say whether values are within the ranges."""
        return bool((values >= 0.0).all() and (values <= 1.0).all())


@dataclass
class Track:
    """The points so far, what else was found where the last one was looked for, and where orbits begin."""

    points: list[LocusPoint]
    others: list[SpecialPoint] = field(default_factory=list)
    share: float | None = None


def first_point(search: Search, values: Reals, state: Reals) -> LocusPoint:
    """Return the point to begin with, from values of both numbers and a state."""
    passage = search.map_at(1, float(values[1])).passage(float(values[0]), state)
    sizes = np.where(passage.sizes > 0.0, passage.sizes, 1.0)
    return LocusPoint((values - search.lowest) / search.spans, state, sizes, state)


def restart(search: Search, track: Track) -> None:
    """Let orbits begin elsewhere, where an event comes near to the instant at which they do."""
    *_, last = track.points
    first, second = search.lowest + last.values * search.spans
    passage = search.map_at(1, float(second), track.share).passage(float(first), last.state)
    other = passage.restart(np.zeros(len(last.state) + 1))
    if other is None:
        return
    track.share = other.map.share
    for number in range(max(0, len(track.points) - PREDICTING), len(track.points)):
        point = track.points[number]
        first, second = search.lowest + point.values * search.spans
        map = search.map_at(1, float(second), track.share)
        track.points[number] = replace(point, state=map.phases(float(first), point.strobed)[0])


def found_again(
    search: Search, track: Track, held: int, values: Reals, state: Reals, reach: float
) -> LocusPoint | None:
    """Find the point again with one number held."""
    numbers = search.lowest + values * search.spans
    free = 1 - held
    try:
        map = search.map_at(held, float(numbers[held]), track.share)
    except MechanismError:
        return None
    found = relocated(map, float(search.spans[free]), search.sought, float(numbers[free]), state, reach)
    if found is None:
        return None
    track.others = list(found.others)
    if found.point is None:
        return None
    located = values.copy()
    located[free] = (found.point.value - search.lowest[free]) / search.spans[free]
    (begin,) = map.phases(found.point.value, found.point.state)
    return LocusPoint(located, begin, found.problem.sizes, found.point.state)


def apart(point: LocusPoint, values: Reals, state: Reals) -> float:
    """Return the distance of a point from values and a state, in coordinates without units."""
    away = np.append(point.values - values, (point.state - state) / point.sizes)
    return float(np.linalg.norm(away))
