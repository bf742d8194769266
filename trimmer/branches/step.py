"""One step along a branch, with all that happens on it."""

from __future__ import annotations

import math
from dataclasses import dataclass, replace

import numpy as np

from trimmer.arrays import Reals, norm
from trimmer.branches.arc import Arc, LostError
from trimmer.branches.bifurcations import SHORTEST, Bifurcation, bifurcations, dips, straight
from trimmer.branches.borders import Border, borders, special_points
from trimmer.branches.branch import BranchEnd
from trimmer.branches.orbit import Place, Problem
from trimmer.branches.special import SpecialKind, SpecialPoint

FARTHEST_ASIDE = 1.0  # Largest distance of an orbit from the tangent, relative to that along it
MOST_CURVED = 0.1
"""Distance of the next orbit from the tangent, relative to that along it, up to which it is foreseen."""
STEEP = 0.1  # Share of the value in the tangent from which on orbits are sought at given values
TOWARDS_BORDER = (1e-4, 1e-2)  # Shares of a smooth piece at which it is looked at next to a change of phases
CLOSE_TO_JOINT = 2e-4
"""Length of a step in all coordinates within which a branch is taken to where it joins another."""
SINGLE = 1e-8  # Difference between the halves of a doubled orbit, below which it is a single one
OPPOSITE = -0.9
"""Cosine of an angle beyond which two differences between the halves of a doubled orbit are opposite."""


@dataclass(frozen=True, eq=False)
class Front:
    """How far a branch has been followed."""

    problem: Problem  # The orbits and their scale
    place: Place  # The last orbit
    tangent: Reals  # Unit tangent in the direction of travel, shape (n + 1,)
    turn: float  # Sign of the determinant of slope and tangent
    before: Place | None = None  # The orbit before it on the same smooth piece, None if there is none

    @property
    def direction(self) -> Reals:
        """Unit vector along which orbits are sought: that of the values, where the branch is not steep."""
        if abs(self.tangent[-1]) < STEEP:
            return self.tangent
        direction = np.zeros(len(self.tangent))
        direction[-1] = np.sign(self.tangent[-1])
        return direction

    def moved(self, place: Place, tangent: Reals) -> Front:
        """Return the front at another place."""
        before = self.place if self.place.signature == place.signature else None
        return begun(self.problem, place, tangent, before)


def begun(problem: Problem, place: Place, tangent: Reals, before: Place | None = None) -> Front:
    """Return the front at the beginning of a branch, or behind another orbit of it."""
    return Front(problem, place, tangent, float(np.sign(place.orientation(tangent))), before)


@dataclass(frozen=True, eq=False)
class BranchStep:
    """A step along a branch."""

    front: Front  # The front after it
    special: tuple[SpecialPoint, ...]  # The special points on it, in their order
    switches: tuple[Bifurcation, ...]  # The bifurcations among them at which another branch parts
    bend: float  # Angle between the tangents before and after it, rad
    ended: BranchEnd | None = None  # Why the branch ends with it; None if it goes on
    # A doubled orbit on the other side of the branch that it joins; None if it joins none
    beyond: Place | None = None


def step(front: Front, length: float, ends: tuple[float, float], *, smooth: bool = True) -> BranchStep | None:
    """Follow the branch over a length, or to the end of the interval of values if that comes first.

    Args:
        front: Where it has got to.
        length: In coordinates without units.
        ends: The end of the interval where the branch began, and the other one, in the same coordinates.
        smooth: Whether bifurcations are looked for too, and not only where phases change.

    Returns:
        The step; None if it does not succeed, or could have come upon another branch.
    """
    start, stop = ends
    arc = Arc(front.problem, front.place.position, front.direction)
    predicted = front.place.position + length * front.tangent
    end = _end_passed(predicted, start, stop)
    if end is None:
        ahead = float(front.direction @ (predicted - front.place.position))
        curved = _curved(front, arc, ahead, predicted)
        far = None if curved is None else arc.at(ahead, curved)
        far = arc.at(ahead, predicted) if far is None else far
        if far is not None:
            predicted, end = far.position, _end_passed(far.position, start, stop)
    if end is not None:
        far = _at_end(front, predicted, end)
    if far is None or _astray(front, far):
        return None
    if rejoined(front, far):
        close = norm(far.position - front.place.position) <= CLOSE_TO_JOINT
        return BranchStep(front, (), (), 0.0, BranchEnd.REJOINED, far) if close else None
    try:
        made = _examined(front, arc, far, smooth)
    except LostError:
        return None
    if made is None or end is None:
        return made
    return replace(made, ended=BranchEnd.LEFT_AT_START if end == start else BranchEnd.LEFT_AT_STOP)


def _curved(front: Front, arc: Arc, ahead: float, straight: Reals) -> Reals | None:
    """Return the coordinates at a distance along the cubic through the last two orbits and their tangents.

    Newton's method needs a step less from there than from the straight line. None where there is no orbit
    before on the smooth piece, or where the cubic bends away far from the line.
    """
    before = front.before
    slope = None if before is None else before.tangent(arc.direction)
    if before is None or slope is None:
        return None
    behind = -arc.distance(before)
    rise, first = front.tangent / (front.tangent @ arc.direction), slope / (slope @ arc.direction)
    chord = (front.place.position - before.position) / behind
    curvature, third = 2.0 * rise + first - 3.0 * chord, rise + first - 2.0 * chord
    share = ahead / behind
    curved = straight + ahead * share * (curvature + share * third)
    bend, reach = norm(curved - straight), norm(straight - front.place.position)
    return curved if bend <= MOST_CURVED * reach else None


def _end_passed(position: Reals, start: float, stop: float) -> float | None:
    """Return the end of the interval beyond which a position lies, None if it lies inside."""
    lowest, highest = sorted((start, stop))
    return lowest if position[-1] < lowest else highest if position[-1] > highest else None


def _at_end(front: Front, beyond: Reals, end: float) -> Place | None:
    """Find the orbit at an end of the interval between the front and a position beyond."""
    near = front.place.position
    share = (end - near[-1]) / (beyond[-1] - near[-1])
    guess = near + share * (beyond - near)
    guess[-1] = end
    across = np.zeros(len(guess))
    across[-1] = 1.0
    return front.problem.correct(guess, across, end)


def _astray(front: Front, far: Place) -> bool:
    """Say whether an orbit lies too far beside the tangent, or behind."""
    chord = far.position - front.place.position
    ahead = float(front.tangent @ chord)
    aside = norm(chord - ahead * front.tangent)
    return ahead <= 0.0 or aside > FARTHEST_ASIDE * ahead


def rejoined(front: Front, far: Place) -> bool:
    """Say whether a doubled orbit becomes a single one on the way to a place.

    There the difference between its halves passes through zero and changes its sign. Beyond that Newton's
    method may also find single orbits, of which it is zero.
    """
    first, last = halves(front.problem, front.place), halves(front.problem, far)
    if first is None or last is None:
        return False
    lengths = norm(first), norm(last)
    if lengths[1] <= SINGLE:
        return True
    return float(first @ last) < OPPOSITE * lengths[0] * lengths[1]


def halves(problem: Problem, place: Place) -> Reals | None:
    """Return the difference between the halves of a doubled orbit, shape (n,); None of a single one."""
    middle = place.passage.middle
    return None if middle is None else middle / problem.sizes - place.position[:-1]


def _examined(front: Front, arc: Arc, far: Place, smooth: bool) -> BranchStep | None:
    """Find what is special between the front and an orbit; None if they cannot be on one branch.

    Raises:
        LostError: if an orbit between them is not found.
    """
    crossed = borders(arc, front.place, far)
    if crossed is None:
        return None
    starts = [front.place, *(border.after for border in crossed)]
    ends = [*(border.before for border in crossed), far]
    pieces = list(zip(starts, ends, strict=True))
    if not all(straight(arc, *piece) for piece in pieces) or not all(_passes(arc, each) for each in crossed):
        return None
    special: list[SpecialPoint] = []
    switches: list[Bifurcation] = []
    for number, piece in enumerate(pieces):
        if smooth:
            border = (number > 0, number < len(crossed))
            found = bifurcations(arc, _between(front, arc, piece, border))
            special += [each.point for each in found]
            switches += [each for each in found if each.switches]
        if number < len(crossed):
            special += at_border(arc, crossed[number])
    tangent = far.tangent(arc.direction)
    if tangent is None:
        return None
    return BranchStep(
        front.moved(far, tangent), tuple(special), tuple(switches), angle(front.tangent, tangent)
    )


def angle(first: Reals, second: Reals) -> float:
    """Return the angle between two unit vectors, rad.

    Kahan, How futile are mindless assessments of roundoff, 2006, section 12: no rounding is enlarged.
    """
    return 2.0 * math.atan2(norm(first - second), norm(first + second))


def _passes(arc: Arc, border: Border) -> bool:
    """Say whether the branch goes on beyond a border, and does not turn around there.

    Where it turns, another part of it lies beyond the border as near as one likes. Where two phases change
    at once, as in a mechanism with two like sides, the sign says nothing.
    """
    if not border.is_single:
        return True
    tangents = [place.tangent(arc.direction) for place in (border.before, border.after)]
    if tangents[0] is None or tangents[1] is None:
        return False
    return border.before.orientation(tangents[0]) * border.after.orientation(tangents[1]) > 0.0


def _between(front: Front, arc: Arc, piece: tuple[Place, Place], border: tuple[bool, bool]) -> list[Place]:
    """Return the orbits of a smooth piece that are looked at: its ends, and where functions may change twice.

    Next to a change of phases they change with the root of the distance, so there some are taken closer and
    closer to it.

    Args:
        front: The front before the step.
        arc: The arc of the step.
        piece: The ends of the piece.
        border: Whether the phases change at either.

    Raises:
        LostError: if one of the orbits is not found.
    """
    near, far = piece
    first, last = arc.distance(near), arc.distance(far)
    distances: list[float] = []
    if any(border) and last - first > SHORTEST:
        from_near = [first + share * (last - first) for share in TOWARDS_BORDER if border[0]]
        from_far = [last - share * (last - first) for share in TOWARDS_BORDER if border[1]]
        distances = sorted(from_near + from_far)
    elif not any(border) and front.before is not None:
        distances = dips(arc, front.before, near, far)
    chain = [near]
    for distance in distances:
        chain.append(arc.smooth(distance, chain[-1], far))
    return [*chain, far]


def at_border(arc: Arc, border: Border) -> list[SpecialPoint]:
    """Return what a border is, and the fold if the branch turns around there."""
    points = special_points(border)
    tangents = [place.tangent(arc.direction) for place in (border.before, border.after)]
    if tangents[0] is None or tangents[1] is None or tangents[0][-1] * tangents[1][-1] >= 0.0:
        return points
    return [*points, fold_at(points)]


def fold_at(points: list[SpecialPoint]) -> SpecialPoint:
    """Return the fold of a branch that turns around where phases change, which no multiplier announces."""
    point = points[0]
    words = " and ".join(each.kind.word for each in points)
    return SpecialPoint(SpecialKind.FOLD, point.value, point.state, point.parts, f"a corner at {words}")
