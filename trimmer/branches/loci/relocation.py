"""Finding a special point again near where it was, after another number of the mechanism has changed."""

from collections.abc import Iterator
from dataclasses import dataclass

import numpy as np

from trimmer.arrays import Reals
from trimmer.branches.null_vector import null_vector
from trimmer.branches.orbit import Place, Problem
from trimmer.branches.period_maps.driven_map import DrivenMap
from trimmer.branches.settings import FollowSettings
from trimmer.branches.special import SpecialKind, SpecialPoint
from trimmer.branches.step import Front, begun
from trimmer.branches.stepping import SMALLEST, Interval, Limits, longest_step, scales
from trimmer.errors import TrimmerError

MOST_STEPS = 24  # Steps within which a piece of branch must have been followed
ACROSS = 2.2  # Length of the first step, in reaches: one that passes the guess, where nothing shortens it
BEYOND = 1.1  # How far behind the guess a piece ends, in reaches
SHORT = 1e-3  # Length of a step, in reaches, below which a piece without a corner is given up
FARTHEST = 2.0  # Largest distance of the point from the guess, in reaches


@dataclass(frozen=True)
class Sought:
    """What a special point must be to be the same."""

    kind: SpecialKind  # What happens there
    parts: tuple[str, ...]  # Names of the parts whose phases change there

    def fits(self, point: SpecialPoint) -> bool:
        """Say whether a point is of this kind, in these parts."""
        return point.kind is self.kind and point.parts == self.parts


@dataclass(frozen=True, eq=False)
class Relocated:
    """What was found on a short piece of branch."""

    point: SpecialPoint | None  # The special point that was sought; None if it is not there
    others: tuple[SpecialPoint, ...]  # The special points of other kinds or parts
    problem: Problem  # The scale of the coordinates


def relocated(
    map: DrivenMap, span: float, sought: Sought, value: float, state: Reals, reach: float
) -> Relocated | None:
    """Find a special point on a short piece of branch around a guess.

    The piece begins at a distance on either side of the guess, since a branch that turns at a corner lies on
    one side alone, and is followed past it.

    Args:
        map: The map of a period.
        span: Length of the interval of values, for the scale.
        sought: What is looked for.
        value: Guess of the value.
        state: Guess of the state, shape (n,).
        reach: Distance from the guess at which the piece begins, in coordinates without units.

    Returns:
        What was found; None if there is no branch near the guess.
    """
    first = Problem(map, span, np.ones(len(state)))
    guess = first.place(first.position(value, state))
    if guess is None:
        return None
    problem = Problem(map, span, scales(guess, None))
    try:
        centre = _centre(problem.adopted(guess))
        if centre is None:
            return None
        tangent = null_vector(centre.slope)
    except (np.linalg.LinAlgError, TrimmerError):
        return None
    found: list[Relocated] = []
    for direction in (tangent, -tangent):
        piece = _searched(centre, direction, sought, reach)
        if piece is not None and piece.point is not None:
            return piece
        found += [] if piece is None else [piece]
    return found[0] if found else None


def _centre(guess: Place) -> Place | None:
    """Return the orbit beside a guess, across the direction of the branch there."""
    normal = null_vector(guess.slope)
    return guess.problem.correct(guess.position, normal, float(normal @ guess.position))


def _searched(centre: Place, direction: Reals, sought: Sought, reach: float) -> Relocated | None:
    """Follow a piece of branch along a direction past an orbit, until the point is found."""
    problem = centre.problem
    start = centre.position - reach * direction
    place = problem.correct(start, direction, float(direction @ start))
    if place is None or np.linalg.norm(place.position - start) > reach:
        return None
    tangent = place.tangent(direction)
    if tangent is None:
        return None
    others: list[SpecialPoint] = []
    # Only what has parts may lie in a corner, to which steps must shorten until they reach it.
    smallest = SMALLEST if sought.parts else SHORT * reach
    front, smooth = begun(problem, place, tangent), not sought.parts
    for point in _special_points(front, centre.position, reach, (smallest, smooth)):
        (begin,) = problem.map.phases(point.value, point.state)
        near = np.linalg.norm(problem.position(point.value, begin) - centre.position) <= FARTHEST * reach
        if near and sought.fits(point):
            return Relocated(point, tuple(others), problem)
        others += [point] if near else []
    return Relocated(None, tuple(others), problem)


def _special_points(
    front: Front, centre: Reals, reach: float, look: tuple[float, bool]
) -> Iterator[SpecialPoint]:
    """Yield the special points of a branch from a front until it leaves the neighbourhood of a centre.

    Args:
        front: Where it begins.
        centre: Coordinates, (n + 1,).
        reach: Distance from there within which it stays.
        look: Length of the shortest step, and whether bifurcations are looked for.
    """
    smallest, smooth = look
    value = front.problem.value(front.place.position)
    half = 0.5 * front.problem.span  # positions are in spans, and ends of an interval in its length
    interval = Interval(value - half, value + half)
    limits = Limits(interval, FollowSettings(largest_step=1.0), smooth)
    length = farthest = ACROSS * reach
    for _ in range(MOST_STEPS):
        made, length = longest_step(front, min(length, farthest), limits, smallest)
        if made is None:
            return
        yield from made.special
        front = made.front
        if np.linalg.norm(front.place.position - centre) > BEYOND * reach:
            return
