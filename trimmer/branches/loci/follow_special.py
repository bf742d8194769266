"""Following a special point of a branch over two numbers of a mechanism."""

from dataclasses import replace

import numpy as np

from trimmer.arguments import require_instance
from trimmer.arrays import Reals
from trimmer.branches.followed import FollowedBranch
from trimmer.branches.loci.locus import Locus, LocusEnd, LocusRanges, LocusSettings
from trimmer.branches.loci.relocation import Sought
from trimmer.branches.loci.search import LocusPoint, Search, Track, first_point
from trimmer.branches.loci.steps import followed
from trimmer.branches.orbit import Place, Problem
from trimmer.branches.period_maps.fitting import is_symmetric, shortest_map
from trimmer.branches.period_maps.self_excited_map import SelfExcitedMap
from trimmer.branches.special import SpecialKind, SpecialPoint
from trimmer.errors import MechanismError, UnsupportedMotionError
from trimmer.mechanism.place_text import parse_place, place_text, unit_of

DEFAULT = LocusSettings()


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
    mechanism, first = branch.map.subject, place_text(parse_place(branch.map.place))
    second = place_text(parse_place(place))
    if second == first or second.endswith(".order"):
        raise MechanismError(f"{place}: vary a second number, one that need not be whole")
    begin, end = mechanism.value(second), mechanism.with_value(second, stop).value(second)
    if begin == end:
        raise ValueError(f"{place} is {begin:.10g} already: follow the point to another value")
    if ranges is None:
        ranges = _ranges_of(branch, special, begin, end)
    search = _search(branch, special, second, ranges)
    start = first_point(search, np.array([special.value, begin]), special.state)
    if not search.inside(start.values):
        raise ValueError(f"the ranges do not hold the point, at {special.value:.10g} and {begin:.10g}")
    track = Track([start])
    reason = followed(search, track, 1.0 if end > begin else -1.0, settings)
    return _locus(search, track, reason)


def _ranges_of(branch: FollowedBranch, special: SpecialPoint, begin: float, end: float) -> LocusRanges:
    values = [special.value, *(point.value for point in branch.points)]
    return LocusRanges((min(values), max(values)), (min(begin, end), max(begin, end)))


def _search(branch: FollowedBranch, special: SpecialPoint, second: str, ranges: LocusRanges) -> Search:
    mechanism = branch.map.subject.with_value(branch.map.place, special.value)
    map = shortest_map(replace(branch.map, subject=mechanism, single=None), special.value, special.state)
    map = replace(map, mirrored=is_symmetric(map, special.value, special.state))
    scales = [max(abs(lowest), abs(highest)) for lowest, highest in ranges.both]
    maps = replace(map, scale=scales[0]), replace(map, place=second, scale=scales[1])
    return Search(maps, Sought(special.kind, special.parts), ranges)


def _locus(search: Search, track: Track, reason: LocusEnd) -> Locus:
    values = search.lowest + np.array([point.values for point in track.points]) * search.spans
    places = [_place(search, numbers, point) for numbers, point in zip(values, track.points, strict=True)]
    units = search.maps[0].subject.places
    return Locus(
        kind=search.sought.kind,
        parts=search.sought.parts,
        places=(search.maps[0].place, search.maps[1].place),
        periods=search.maps[0].periods,
        values=values,
        states=np.array([point.strobed for point in track.points]),
        residual=np.array([np.nan if place is None else place.error for place in places]),
        distance=np.array([_distance(search, place) for place in places]),
        reason=reason,
        message=_message(search, track, reason, values[-1]),
        units=(unit_of(units, search.maps[0].place), unit_of(units, search.maps[1].place)),
    )


def _place(search: Search, numbers: Reals, point: LocusPoint) -> Place | None:
    """Return the orbit of a point, from where nothing happens; None if it cannot be followed."""
    problem = Problem(search.map_at(1, float(numbers[1])), 1.0, point.sizes)
    place = problem.place(problem.position(float(numbers[0]), point.strobed))
    restart = None if place is None else place.passage.restart(np.zeros(len(point.strobed) + 1))
    if restart is None:
        return place
    problem = replace(problem, map=restart.map)
    return problem.place(problem.position(float(numbers[0]), restart.state))


def _distance(search: Search, place: Place | None) -> float:
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


def _message(search: Search, track: Track, reason: LocusEnd, numbers: Reals) -> str:
    at = " and ".join(
        f"{map.place} = {number:.10g}" for map, number in zip(search.maps, numbers, strict=True)
    )
    found = sorted({each.kind.word for each in track.others})
    beside = f"; beside it: {', '.join(found)}" if reason is LocusEnd.CHANGED else ""
    return f"{reason.value}, at {at}{beside}"
