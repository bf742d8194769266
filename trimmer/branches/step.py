"""One step along a branch, with all that happens on it."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

from trimmer.arrays import Reals
from trimmer.branches.arc import Arc, LostError
from trimmer.branches.bifurcations import Bifurcation, bifurcations, straight
from trimmer.branches.borders import Border, borders, special_points
from trimmer.branches.orbit import Place, Problem
from trimmer.branches.special import SpecialKind, SpecialPoint

FARTHEST_ASIDE = 1.0
"""Largest distance of an orbit from its prediction, relative to the step."""


@dataclass(frozen=True, eq=False)
class Front:
    """How far a branch has been followed.

    Attributes:
        problem: The orbits and their scale.
        place: The last orbit.
        tangent: Unit tangent in the direction of travel, shape (n + 1,).
        turn: Sign of the determinant of slope and tangent.
    """

    problem: Problem
    place: Place
    tangent: Reals
    turn: float

    def moved(self, place: Place, tangent: Reals) -> Front:
        """Return the front at another place."""
        return Front(self.problem, place, tangent, float(np.sign(place.orientation(tangent))))


@dataclass(frozen=True, eq=False)
class Step:
    """A step along a branch.

    Attributes:
        front: The front after it.
        special: The special points on it, in their order.
        switches: The bifurcations among them at which another branch parts.
        bend: Angle between the tangents before and after it, rad.
        left: Whether it ends at an end of the interval.
    """

    front: Front
    special: tuple[SpecialPoint, ...]
    switches: tuple[Bifurcation, ...]
    bend: float
    left: bool = False


def step(front: Front, length: float, lowest: float, highest: float) -> Step | None:
    """Follow the branch over a length, or to the end of the interval of values if that comes first.

    Args:
        front: Where it has got to.
        length: In coordinates without units.
        lowest: Lower end of the interval, in the same coordinates.
        highest: Its upper end.

    Returns:
        The step; None if it does not succeed, or could have come upon another branch.
    """
    arc = Arc(front.problem, front.place.position, front.tangent)
    predicted = front.place.position + length * front.tangent
    end = lowest if predicted[-1] < lowest else highest if predicted[-1] > highest else None
    if end is None:
        far = arc.at(length, predicted)
        if far is not None and not lowest <= far.position[-1] <= highest:
            end = lowest if far.position[-1] < lowest else highest
            predicted = far.position
    if end is not None:
        far = _at_end(front, predicted, end)
    if far is None or _astray(arc, far, length):
        return None
    try:
        return _examined(front, arc, far, end is not None)
    except LostError:
        return None


def _at_end(front: Front, beyond: Reals, end: float) -> Place | None:
    """Find the orbit at an end of the interval between the front and a position beyond."""
    near = front.place.position
    share = (end - near[-1]) / (beyond[-1] - near[-1])
    guess = near + share * (beyond - near)
    guess[-1] = end
    across = np.zeros(len(guess))
    across[-1] = 1.0
    return front.problem.correct(guess, across, end)


def _astray(arc: Arc, far: Place, length: float) -> bool:
    ahead = arc.distance(far)
    aside = float(np.linalg.norm(far.position - arc.origin - ahead * arc.direction))
    return not 0.0 < ahead <= 1.5 * length or aside > FARTHEST_ASIDE * ahead


def _examined(front: Front, arc: Arc, far: Place, left: bool) -> Step | None:
    """Find all that is special between the front and an orbit; None if they cannot be on one branch.

    Raises:
        LostError: if an orbit between them is not found.
    """
    crossed = borders(arc, front.place, far)
    if crossed is None:
        return None
    starts = [front.place, *(border.after for border in crossed)]
    ends = [*(border.before for border in crossed), far]
    pieces = list(zip(starts, ends, strict=True))
    if not all(straight(arc, *piece) for piece in pieces):
        return None
    special: list[SpecialPoint] = []
    switches: list[Bifurcation] = []
    for number, piece in enumerate(pieces):
        found = bifurcations(arc, *piece)
        special += [each.point for each in found]
        switches += [each for each in found if each.switches]
        if number < len(crossed):
            special += at_border(arc, crossed[number])
    tangent = far.tangent(arc.direction)
    if tangent is None:
        return None
    bend = float(np.arccos(np.clip(tangent @ front.tangent, -1.0, 1.0)))
    return Step(front.moved(far, tangent), tuple(special), tuple(switches), bend, left)


def at_border(arc: Arc, border: Border) -> list[SpecialPoint]:
    """Return what a border is, and the fold if the branch turns around there."""
    points = special_points(arc, border)
    tangents = [place.tangent(arc.direction) for place in (border.before, border.after)]
    if tangents[0] is None or tangents[1] is None or tangents[0][-1] * tangents[1][-1] >= 0.0:
        return points
    return [*points, fold_at(points)]


def fold_at(points: list[SpecialPoint]) -> SpecialPoint:
    """Return the fold of a branch that turns around where phases change, which no multiplier announces."""
    point = points[0]
    words = " and ".join(each.kind.word for each in points)
    return SpecialPoint(SpecialKind.FOLD, point.value, point.state, point.parts, f"a corner at {words}")
