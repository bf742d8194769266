"""Following a special point of a branch over two numbers of a mechanism.

A point is predicted by the parabola through the last three. Then the number that changes more is held, and
the point is found again on a short piece of branch over the other; so a locus may turn in either number.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass, field, replace
from itertools import pairwise

import numpy as np

from trimmer.arguments import require_instance
from trimmer.arrays import Reals
from trimmer.branches.fitting import is_symmetric, shortest_map
from trimmer.branches.followed import FollowedBranch
from trimmer.branches.locus import Locus, LocusEnd, LocusRanges, LocusSettings
from trimmer.branches.mechanism_map import MechanismMap
from trimmer.branches.orbit import Place, Problem
from trimmer.branches.relocation import Sought, relocated
from trimmer.branches.self_excited_map import SelfExcitedMap
from trimmer.branches.special import SpecialKind, SpecialPoint
from trimmer.errors import MechanismError, UnsupportedMotionError
from trimmer.mechanism.place_text import parse_place, place_text, unit_of
from trimmer.progress import progress_bar

DEFAULT = LocusSettings()
FIRST_STEP = 2e-3
"""Length of the first step, as a share of the ranges."""
FIRST_REACHES = (1e-2, 1e-3, 1e-1)
"""Distances at which the first points are looked for, in coordinates without units, in their order."""
REACH = 0.5
"""Distance from a prediction within which a point is looked for, relative to the step."""
LEAST_REACH = 2e-5
WORST = 0.2
"""Error of a prediction, relative to the step, above which the step is shortened."""
MUCH_SHORTER = 0.1
LARGEST_MOVE = 0.2
"""Largest length of a step, states included."""
ACCURATE = 0.03
"""Error of a prediction, relative to the step, below which the next step is longer."""
SHARP = 0.05
"""Share of the numbers in a step, against the states, below which a locus turns sharply back."""
SAME = 1e-3
"""Distance from the first point, in ranges, within which a locus may close."""


@dataclass(frozen=True, eq=False)
class _Point:
    """A point of a locus: values as shares of the ranges, (2,), state, (n,), and the state's scale, (n,)."""

    values: Reals
    state: Reals
    sizes: Reals


@dataclass(frozen=True, eq=False)
class _Search:
    """What is followed: maps over either number, what is sought, the ranges and their lengths, (2,)."""

    maps: tuple[MechanismMap, MechanismMap]
    sought: Sought
    ranges: LocusRanges

    @property
    def spans(self) -> Reals:
        return np.array([highest - lowest for lowest, highest in self.ranges.both])

    @property
    def lowest(self) -> Reals:
        return np.array([lowest for lowest, _ in self.ranges.both])

    def map_at(self, held: int, value: float) -> MechanismMap:
        """Return the map over the number that is not held, with a value of the one that is."""
        map = self.maps[1 - held]
        return replace(map, mechanism=map.mechanism.with_value(self.maps[held].place, value))

    def inside(self, values: Reals) -> bool:
        return bool((values >= 0.0).all() and (values <= 1.0).all())


@dataclass
class _Track:
    points: list[_Point]
    others: list[SpecialPoint] = field(default_factory=list)


def follow_special(
    branch: FollowedBranch,
    special: SpecialPoint,
    place: str,
    stop: float | str,
    *,
    ranges: LocusRanges | None = None,
    settings: LocusSettings = DEFAULT,
) -> Locus:
    """Follow a special point of a branch while a second number of the mechanism varies too.

    The locus begins at the value that the second number has in the branch's mechanism, goes towards ``stop``,
    and may turn around. It ends on leaving the ranges.

    Args:
        branch: A branch over the first number.
        special: One of its special points.
        place: Dotted place of the second number, such as ``plays.bridge.gap``.
        stop: Value of the second number towards which to go, in SI units, or text with its unit.
        ranges: Values of both numbers within which to stay; by default those of the branch's points, and from
            the second number's own value to ``stop``.
        settings: How to follow it.

    Raises:
        UnsupportedMotionError: if the mechanism has no drive.
        MechanismError: if there is no such number, it is that of the branch, or it cannot have that value.
        ValueError: if the number has the value of stop already, or the ranges do not hold the point.
        WrongTypeError: if an argument has another type.
    """
    require_instance("branch", branch, FollowedBranch, "a trimmer.FollowedBranch")
    require_instance("special", special, SpecialPoint, "a special point of the branch")
    if isinstance(branch.map, SelfExcitedMap):
        raise UnsupportedMotionError(
            "special points are followed over two numbers for driven motions only, and the mechanism has no "
            "frequency; follow branches at several values of the second number"
        )
    mechanism, first = branch.map.mechanism, place_text(parse_place(branch.map.place))
    second = place_text(parse_place(place))
    if second == first or second.endswith(".order"):
        raise MechanismError(f"{place}: vary a second number, one that need not be whole")
    begin, end = mechanism.value(second), mechanism.with_value(second, stop).value(second)
    if begin == end:
        raise ValueError(f"{place} is {begin:.10g} already: follow the point to another value")
    if ranges is None:
        ranges = _ranges_of(branch, special, begin, end)
    search = _search(branch, special, second, ranges)
    start = _first_point(search, np.array([special.value, begin]), special.state)
    if not search.inside(start.values):
        raise ValueError(f"the ranges do not hold the point, at {special.value:.10g} and {begin:.10g}")
    track = _Track([start])
    reason = _followed(search, track, 1.0 if end > begin else -1.0, settings)
    return _locus(search, track, reason)


def _ranges_of(branch: FollowedBranch, special: SpecialPoint, begin: float, end: float) -> LocusRanges:
    values = [special.value, *(point.value for point in branch.points)]
    return LocusRanges((min(values), max(values)), (min(begin, end), max(begin, end)))


def _search(branch: FollowedBranch, special: SpecialPoint, second: str, ranges: LocusRanges) -> _Search:
    mechanism = branch.map.mechanism.with_value(branch.map.place, special.value)
    map = shortest_map(replace(branch.map, mechanism=mechanism, single=None), special.value, special.state)
    map = replace(map, mirrored=is_symmetric(map, special.value, special.state))
    scales = [max(abs(lowest), abs(highest)) for lowest, highest in ranges.both]
    maps = replace(map, scale=scales[0]), replace(map, place=second, scale=scales[1])
    return _Search(maps, Sought(special.kind, special.parts), ranges)


def _first_point(search: _Search, values: Reals, state: Reals) -> _Point:
    passage = search.map_at(1, float(values[1])).passage(float(values[0]), state)
    sizes = np.where(passage.sizes > 0.0, passage.sizes, 1.0)
    return _Point((values - search.lowest) / search.spans, state, sizes)


def _followed(search: _Search, track: _Track, sign: float, settings: LocusSettings) -> LocusEnd:
    """Add point after point to a track, and return why it ends."""
    length = min(FIRST_STEP, settings.largest_step)
    bar = progress_bar(description=search.sought.kind.word, quiet=settings.quiet, unit=" points")
    with bar:
        while len(track.points) < settings.most_points:
            made = _step(search, track, sign, length)
            if made is None:
                length *= 0.5
                if length < settings.smallest_step:
                    return _obstacle(search, track)
                continue
            point, error = made
            track.points.append(point)
            bar.update()
            if not search.inside(point.values) or _at_border(point):
                return LocusEnd.LEFT
            if _closed(track.points):
                return LocusEnd.CLOSED
            length = _next_length(track.points, length * (2.0 if error < ACCURATE else 1.0), settings)
    return LocusEnd.MOST_POINTS


def _next_length(points: Sequence[_Point], wanted: float, settings: LocusSettings) -> float:
    """Return a length at which the two numbers change no more than they may."""
    before, last = points[-2:]
    share = float(np.linalg.norm(last.values - before.values)) / _apart(before, last.values, last.state)
    return min(wanted, LARGEST_MOVE, settings.largest_step / max(share, 1e-300))


def _at_border(point: _Point) -> bool:
    return bool((abs(point.values - 0.5) >= 0.5 - 1e-12).any())


def _step(search: _Search, track: _Track, sign: float, length: float) -> tuple[_Point, float] | None:
    """Return the next point and the error of its prediction relative to the step; None if none was found."""
    if len(track.points) == 1:
        return _second_point(search, track, sign, length)
    before, last = track.points[-2:]
    predicted = _predicted(track.points, length)
    ahead = predicted[0] - last.values
    holds = [int(each) for each in np.argsort(-abs(ahead))]
    rooms = _rooms(last.values, ahead)
    if rooms.min() <= 1.0:
        border = int(np.argmin(rooms))
        predicted = _predicted(track.points, length * float(rooms[border]))
        predicted[0][border] = 1.0 if ahead[border] > 0.0 else 0.0
        holds = [border]
    values, state = predicted
    move = _apart(last, values, state)
    # After a step that was too long its direction says little: a much shorter one finds a better.
    worst = WORST if length > MUCH_SHORTER * _apart(before, last.values, last.state) else REACH
    for held in holds:
        found = _found(search, track, held, values, state, max(LEAST_REACH, REACH * move))
        if found is not None and _apart(found, values, state) <= worst * move:
            return found, _apart(found, values, state) / move
    return None


def _second_point(search: _Search, track: _Track, sign: float, length: float) -> tuple[_Point, float] | None:
    (start,) = track.points
    values = np.clip(start.values + np.array([0.0, sign * length]), 0.0, 1.0)
    for reach in FIRST_REACHES:
        found = _found(search, track, 1, values, start.state, reach)
        if found is not None:
            return found, 0.0
    return None


def _predicted(points: Sequence[_Point], length: float) -> tuple[Reals, Reals]:
    """Return values, (2,), and state, (n,), farther on by a length, on the curve through the last points."""
    last = points[-3:]
    rows = [np.append(point.values, point.state) for point in last]
    chords = [_apart(left, right.values, right.state) for left, right in pairwise(last)]
    at = np.cumsum([0.0, *chords])
    ahead = at[-1] + length
    predicted = np.zeros(len(rows[0]))
    for own, row in zip(at, rows, strict=True):
        others = at[at != own]
        predicted += np.prod((ahead - others) / (own - others)) * row
    return predicted[:2], predicted[2:]


def _rooms(values: Reals, ahead: Reals) -> Reals:
    """Return how much of a step leads to the border of either number, (2,)."""
    room = np.where(ahead > 0.0, 1.0 - values, values)
    return np.asarray(room / np.maximum(abs(ahead), 1e-300))


def _found(
    search: _Search, track: _Track, held: int, values: Reals, state: Reals, reach: float
) -> _Point | None:
    """Find the point again with one number held."""
    numbers = search.lowest + values * search.spans
    free = 1 - held
    try:
        map = search.map_at(held, float(numbers[held]))
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
    return _Point(located, found.point.state, found.problem.sizes)


def _apart(point: _Point, values: Reals, state: Reals) -> float:
    away = np.append(point.values - values, (point.state - state) / point.sizes)
    return float(np.linalg.norm(away))


def _closed(points: Sequence[_Point]) -> bool:
    """Say whether the last step passes the first point."""
    if len(points) < 4:
        return False
    first, before, last = points[0], points[-2], points[-1]
    chord = last.values - before.values
    share = float(chord @ (first.values - before.values)) / float(chord @ chord)
    if not 0.0 < share <= 1.0:
        return False
    state = before.state + share * (last.state - before.state)
    return _apart(first, before.values + share * chord, state) <= SAME + 0.1 * float(np.linalg.norm(chord))


def _obstacle(search: _Search, track: _Track) -> LocusEnd:
    if len(track.points) > 2:
        before, last = track.points[-2:]
        moved = np.linalg.norm(last.values - before.values)
        if moved < SHARP * np.linalg.norm((last.state - before.state) / last.sizes):
            return LocusEnd.CUSP
    return LocusEnd.CHANGED if track.others else LocusEnd.LOST


def _locus(search: _Search, track: _Track, reason: LocusEnd) -> Locus:
    values = search.lowest + np.array([point.values for point in track.points]) * search.spans
    places = [_place(search, numbers, point) for numbers, point in zip(values, track.points, strict=True)]
    units = search.maps[0].mechanism.places
    return Locus(
        kind=search.sought.kind,
        parts=search.sought.parts,
        places=(search.maps[0].place, search.maps[1].place),
        periods=search.maps[0].periods,
        values=values,
        states=np.array([point.state for point in track.points]),
        residual=np.array([np.nan if place is None else place.error for place in places]),
        distance=np.array([_distance(search, place) for place in places]),
        reason=reason,
        message=_message(search, track, reason, values[-1]),
        units=(unit_of(units, search.maps[0].place), unit_of(units, search.maps[1].place)),
    )


def _place(search: _Search, numbers: Reals, point: _Point) -> Place | None:
    problem = Problem(search.map_at(1, float(numbers[1])), 1.0, point.sizes)
    return problem.place(problem.position(float(numbers[0]), point.state))


def _distance(search: _Search, place: Place | None) -> float:
    """Return how far the nearest multiplier is from what the kind says, NaN if it says nothing of them."""
    kind = search.sought.kind
    if place is None or kind in (SpecialKind.GRAZING, SpecialKind.STICK):
        return float("nan")
    multipliers = place.multipliers
    if kind is SpecialKind.TORUS:
        pairs = multipliers[abs(multipliers.imag) > 0.0]
        return float(abs(abs(pairs) - 1.0).min()) if len(pairs) else float("nan")
    flips = kind is SpecialKind.PERIOD_DOUBLING or (search.maps[0].mirrored and kind is not SpecialKind.FOLD)
    return float(abs(multipliers + 1.0 if flips else multipliers - 1.0).min())


def _message(search: _Search, track: _Track, reason: LocusEnd, numbers: Reals) -> str:
    at = " and ".join(
        f"{map.place} = {number:.10g}" for map, number in zip(search.maps, numbers, strict=True)
    )
    found = sorted({each.kind.word for each in track.others})
    beside = f"; beside it: {', '.join(found)}" if reason is LocusEnd.CHANGED else ""
    return f"{reason.value}, at {at}{beside}"
