"""Bifurcations on a smooth piece of a branch: folds, period doublings, tori, and other branches that cross.

Each has a test function that changes its sign there and is smooth in between, so it is found like any root.
"""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass

import numpy as np

from trimmer.arrays import Reals
from trimmer.branches.arc import Arc, LostError
from trimmer.branches.orbit import Place
from trimmer.branches.special import SpecialKind, SpecialPoint

STRAIGHT = 0.9
"""Least cosine of the angle between the chord of a smooth piece and the tangents at its ends."""
SHORTEST = 1e-7
"""Length of a piece, below which rounding decides on the direction of its chord."""
MOST_SPLITS = 6

_Test = Callable[[Place], float]


@dataclass(frozen=True, eq=False)
class Bifurcation:
    """A bifurcation on a branch.

    Attributes:
        point: What is told of it.
        place: The orbit.
        switches: Whether another branch parts there that can be followed.
    """

    point: SpecialPoint
    place: Place
    switches: bool


def straight(arc: Arc, near: Place, far: Place) -> bool:
    """Say whether a smooth curve may join two orbits: its chord must lie close to both tangents."""
    chord = far.position - near.position
    length = float(np.linalg.norm(chord))
    if length < SHORTEST:
        return True
    tangents = (near.tangent(arc.direction), far.tangent(arc.direction))
    return all(each is not None and each @ chord >= STRAIGHT * length for each in tangents)


def bifurcations(arc: Arc, near: Place, far: Place, splits: int = MOST_SPLITS) -> list[Bifurcation]:
    """Find the bifurcations between two orbits with the same phases, in their order.

    Args:
        arc: The piece of the branch.
        near: The first orbit.
        far: The last orbit.
        splits: How often the piece may be halved, if what is found does not explain the multipliers that leave
            the unit circle.

    Raises:
        LostError: if an orbit between them is not found.
    """
    found = [
        bifurcation
        for kind, test in _tests(arc).items()
        if test(near) * test(far) < 0.0
        for bifurcation in _located(arc, kind, arc.root(test, near, far))
    ]
    if splits > 0 and not _explained(found, near, far):
        first, last = arc.distance(near), arc.distance(far)
        middle = arc.smooth(0.5 * (first + last), near, far)
        if middle.signature == near.signature:
            return [
                *bifurcations(arc, near, middle, splits - 1),
                *bifurcations(arc, middle, far, splits - 1),
            ]
    return sorted(found, key=lambda each: arc.distance(each.place))


def _tests(arc: Arc) -> dict[SpecialKind, _Test]:
    return {
        SpecialKind.FOLD: lambda place: _tangent(arc, place)[-1],
        SpecialKind.PERIOD_DOUBLING: lambda place: float(np.prod(place.multipliers + 1.0).real),
        SpecialKind.SYMMETRY_BREAKING: lambda place: place.orientation(_tangent(arc, place)),
        SpecialKind.TORUS: lambda place: float(np.prod(_products(place) - 1.0).real),
    }


def _tangent(arc: Arc, place: Place) -> Reals:
    tangent = place.tangent(arc.direction)
    if tangent is None:
        raise LostError
    return tangent


def _products(place: Place) -> Reals:
    """Return the products of all pairs of multipliers; one of them is 1 where a pair crosses the circle."""
    first, second = np.triu_indices(len(place.multipliers), 1)
    products: Reals = place.multipliers[first] * place.multipliers[second]
    return products


def _located(arc: Arc, kind: SpecialKind, place: Place) -> list[Bifurcation]:
    """Return the bifurcation at a root of its test function; none where two real multipliers have product 1."""
    if kind is SpecialKind.TORUS:
        first, _ = np.triu_indices(len(place.multipliers), 1)
        pair = place.multipliers[first[int(np.argmin(abs(_products(place) - 1.0)))]]
        if pair.imag == 0.0:
            return []
    mirrored = arc.problem.map.mirrored and kind is SpecialKind.PERIOD_DOUBLING
    named = SpecialKind.SYMMETRY_BREAKING if mirrored else kind
    value, state = arc.problem.value(place.position), arc.problem.state(place.position)
    switches = kind in (SpecialKind.PERIOD_DOUBLING, SpecialKind.SYMMETRY_BREAKING)
    return [Bifurcation(SpecialPoint(named, value, state), place, switches)]


def _explained(found: list[Bifurcation], near: Place, far: Place) -> bool:
    """Say whether the bifurcations found can change the number of multipliers outside the circle as it does."""
    outside = [int((abs(place.multipliers) > 1.0).sum()) for place in (near, far)]
    change = abs(outside[1] - outside[0])
    most = sum(2 if each.point.kind is SpecialKind.TORUS else 1 for each in found)
    return change <= most and (change - most) % 2 == 0
