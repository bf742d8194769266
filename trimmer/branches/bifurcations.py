"""Bifurcations on a smooth piece of a branch: folds, period doublings, tori, and other branches that cross.

Each has a test function that changes its sign there and is smooth in between, so it is found like any root.
"""

import itertools
import math
from collections.abc import Callable, Sequence
from dataclasses import dataclass

import numpy as np

from trimmer.arrays import norm
from trimmer.branches.arc import Arc, LostError
from trimmer.branches.orbit import Place, pairs
from trimmer.branches.special import SpecialKind, SpecialPoint

STRAIGHT = 0.9  # Least cosine of the angle between the chord of a smooth piece and the tangents at its ends
SHORTEST = 1e-7  # Length of a piece, below which rounding decides on the direction of its chord
MOST_SPLITS = 6
JUMPING = 1e-3  # Share of its values at the ends that a test function has where it jumps past zero
TOUCHING = 0.3
"""Depth of the lowest point of a test function, relative to its ends, below which it may touch zero."""

TESTED = (SpecialKind.FOLD, SpecialKind.PERIOD_DOUBLING, SpecialKind.SYMMETRY_BREAKING, SpecialKind.TORUS)
"""Kinds of bifurcations of which each has a test function."""


@dataclass(frozen=True, eq=False)
class Bifurcation:
    """A bifurcation on a branch."""

    point: SpecialPoint  # What is told of it
    place: Place  # The orbit
    switches: bool  # Whether another branch parts there that can be followed


def straight(arc: Arc, near: Place, far: Place) -> bool:
    """Say whether a smooth curve may join two orbits: its chord must lie close to both tangents."""
    chord = far.position - near.position
    length = norm(chord)
    if length < SHORTEST:
        return True
    tangents = (near.tangent(arc.direction), far.tangent(arc.direction))
    return all(each is not None and each @ chord >= STRAIGHT * length for each in tangents)


def bifurcations(arc: Arc, places: Sequence[Place], splits: int = MOST_SPLITS) -> list[Bifurcation]:
    """Find the bifurcations on a chain of orbits with the same phases, in their order.

    Args:
        arc: The piece of the branch.
        places: Orbits in their order, two at least.
        splits: How often each link may be halved, if what is found on it does not explain which multipliers
            leave the unit circle.

    Raises:
        LostError: if an orbit between them is not found.
    """
    return [each for near, far in itertools.pairwise(places) for each in _between(arc, near, far, splits)]


def _between(arc: Arc, near: Place, far: Place, splits: int) -> list[Bifurcation]:
    found: list[Bifurcation] = []
    for kind, before, after in zip(TESTED, _values(arc, near), _values(arc, far), strict=True):
        if (before > 0.0) != (after > 0.0):
            test = _test(arc, kind)
            place = arc.root(test, near, far)
            jumps = abs(test(place)) > JUMPING * max(abs(before), abs(after))
            found += _corner(kind, place) if jumps else _located(arc, kind, place)
    if splits > 0 and not _explained(found, near, far):
        middle = arc.smooth(0.5 * (arc.distance(near) + arc.distance(far)), near, far)
        return bifurcations(arc, (near, middle, far), splits - 1)
    return sorted(found, key=lambda each: arc.distance(each.place))


def dips(arc: Arc, before: Place, near: Place, far: Place) -> list[float]:
    """Return where between two orbits a test function may touch zero and turn, by the parabola through three.

    A function that changes its sign twice between them shows no change at all.
    """
    behind, ahead = -arc.distance(before), arc.distance(far)
    found = set()
    for first, middle, last in zip(*(_values(arc, each) for each in (before, near, far)), strict=True):
        first, middle, last = (math.copysign(1.0, middle) * each for each in (first, middle, last))
        fall, rise = (middle - first) / behind, (last - middle) / ahead
        curvature = (rise - fall) / (behind + ahead)
        if curvature <= 0.0 or min(first, middle, last) <= 0.0:
            continue
        slope = fall + curvature * behind
        lowest = -0.5 * slope / curvature
        depth = middle + 0.5 * slope * lowest
        if 0.0 < lowest < ahead and depth < TOUCHING * min(middle, last):
            found.add(lowest)
    return sorted(found)


def _values(arc: Arc, place: Place) -> tuple[float, ...]:
    """Return the test functions of the kinds that are tested, in their order.

    Raises:
        LostError: if there is no one tangent.
    """
    values = place.tests(arc.direction)
    if values is None:
        raise LostError
    return values


def _test(arc: Arc, kind: SpecialKind) -> Callable[[Place], float]:
    number = TESTED.index(kind)
    return lambda place: _values(arc, place)[number]


def _located(arc: Arc, kind: SpecialKind, place: Place) -> list[Bifurcation]:
    """Return the bifurcation at a root of a test function; none where two real multipliers have product 1."""
    if kind is SpecialKind.TORUS:
        first, _ = pairs(len(place.multipliers))
        pair = place.multipliers[first[int(np.argmin(abs(place.products - 1.0)))]]
        if pair.imag == 0.0:
            return []
    mirrored = arc.problem.map.mirrored and kind is SpecialKind.PERIOD_DOUBLING
    named = SpecialKind.SYMMETRY_BREAKING if mirrored else kind
    switches = kind in (SpecialKind.PERIOD_DOUBLING, SpecialKind.SYMMETRY_BREAKING)
    return [Bifurcation(SpecialPoint(named, place.value, place.strobed), place, switches)]


def _corner(kind: SpecialKind, place: Place) -> list[Bifurcation]:
    """Return the fold where a test function jumps past zero, none for another kind.

    The slope of the map jumps where events change their order, and multipliers with it: no bifurcation.
    """
    if kind is not SpecialKind.FOLD:
        return []
    point = SpecialPoint(kind, place.value, place.strobed, note="a corner where events change their order")
    return [Bifurcation(point, place, False)]


def _explained(found: list[Bifurcation], near: Place, far: Place) -> bool:
    """Say whether what was found can change the number of multipliers outside the circle as it does."""
    outside = [int((abs(place.multipliers) > 1.0).sum()) for place in (near, far)]
    change = abs(outside[1] - outside[0])
    most = sum(2 if each.point.kind is SpecialKind.TORUS else 1 for each in found)
    return change <= most and (change - most) % 2 == 0
