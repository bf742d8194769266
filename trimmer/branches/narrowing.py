"""Where on a piece of branch a phase is born or dies, by how long it lasts on the side where it is there.

A contact that is born tangentially, or interrupted so, lasts like the root of the distance from there, and
stick like the root or the distance itself. So the distance is a smooth function of the duration, and where
that is zero is found in a few steps; halving the piece is left for where it is not.
"""

import math
from collections.abc import Sequence

import numpy as np

from trimmer.arrays import Reals
from trimmer.branches.arc import Arc
from trimmer.branches.orbit import Place
from trimmer.motion.part import Phase

MOST_TRIALS = 70
POWERS = (1, 2)  # Lowest powers of the duration that the distance may hold
ACCURATE = 0.1  # How much better the distance is known than it changes by the last orbit
SHRUNK = 0.25  # Share to which four trials must bring the piece, else it is halved
INSIDE = 0.2  # Share of the piece at which a second orbit with the phase is looked for
WIDENED = 10.0  # By how much a trial goes farther beyond the border where the one before did not pass it


def narrowed(arc: Arc, left: Place, right: Place) -> tuple[Place, Place] | None:
    """Return two orbits next to where the phases first change between two, as near as rounding permits.

    Args:
        arc: The piece of the branch.
        left: An orbit; the first of the two has its phases.
        right: One farther along, with other phases.

    Returns:
        The two; None if an orbit between them is not found.
    """
    seen, widths, on_left = [left, right], [math.inf] * 4, list[bool]()
    signature = left.signature
    for _ in range(MOST_TRIALS):
        first, last = arc.distance(left), arc.distance(right)
        width = last - first
        if width <= arc.narrowest:
            break
        slow = width > SHRUNK * widths[-4]
        at = None if slow else _likely(arc, seen, left, right, on_left)
        widths = [*widths, math.inf if slow else width]
        middle = arc.between(0.5 * (first + last) if at is None else at, left, right)
        if middle is None:
            return None
        seen.append(middle)
        on_left.append(middle.signature == signature)
        left, right = (middle, right) if on_left[-1] else (left, middle)
    return left, right


def _likely(
    arc: Arc, seen: Sequence[Place], left: Place, right: Place, on_left: Sequence[bool]
) -> float | None:
    """Return the distance to try next, None if the durations do not tell.

    Args:
        arc: The piece of the branch.
        seen: All orbits so far.
        left: The nearest before the border.
        right: The nearest behind it.
        on_left: Whether each trial so far lies before it.
    """
    key, sign = _difference(left, right)
    holder, other = (right, left) if sign > 0 else (left, right)
    alike = [place for place in seen if place.signature == holder.signature]
    origin, ahead = arc.distance(holder), arc.distance(other) - arc.distance(holder)
    if len(alike) == 1:
        return origin + INSIDE * ahead
    # Distances from the holder as shares of the piece, so that the border lies between 0 and 1.
    known = [((arc.distance(each) - origin) / ahead, each.passage.shortest(*key)) for each in alike]
    border, error = _root(sorted(known))
    least = 0.4 * arc.narrowest / abs(ahead)
    same = next((count for count, each in enumerate(reversed(on_left)) if each != on_left[-1]), len(on_left))
    error = max(error, least) * WIDENED ** (same - 1)
    if not -error <= border <= 1.0 + error:
        return None
    border, beyond = min(max(border, 0.0), 1.0), float(on_left[-1] == (holder is left))
    share = border + min(max(0.5 * (beyond - border), -error), error)
    return origin + ahead * min(max(share, least), 1.0 - least)


def _difference(left: Place, right: Place) -> tuple[tuple[str, Phase], int]:
    """Return a phase of which one has more than the other, and by how many the right one has."""
    before, after = dict(left.signature), dict(right.signature)
    changes = {key: after.get(key, 0) - before.get(key, 0) for key in {*before, *after}}
    key = min((key for key in changes if changes[key]), key=lambda each: (each[0], each[1].name))
    return key, changes[key]


def _root(known: Sequence[tuple[float, float]]) -> tuple[float, float]:
    """Return where durations reach zero, and about how well that is known; not finite if it is not.

    Args:
        known: Pairs of distance and duration, that nearest to the border last.
    """
    falling: list[tuple[float, float]] = []
    for pair in known:
        if pair[1] < (falling[-1][1] if falling else math.inf):
            falling.append(pair)
    if len(falling) < 2:
        return math.nan, math.nan
    return min((_extrapolated(falling[-3:], power) for power in POWERS), key=lambda found: found[1])


def _extrapolated(pairs: Sequence[tuple[float, float]], power: int) -> tuple[float, float]:
    """Return the distance at the duration zero, and how well it is known, from two pairs or three.

    The distance is taken as a sum of a constant, the duration to a power, and to the next one.
    """
    distances = np.array([distance for distance, _ in pairs])
    durations = np.array([duration for _, duration in pairs]) / pairs[0][1]
    rough = _constant(distances[-2:], durations[-2:], power)
    if len(pairs) == 2:
        return rough, abs(rough - pairs[-1][0])
    found = _constant(distances, durations, power)
    return found, ACCURATE * abs(found - rough)


def _constant(distances: Reals, durations: Reals, power: int) -> float:
    terms = [np.ones(len(distances)), *(durations ** (power + k) for k in range(len(distances) - 1))]
    try:
        return float(np.linalg.solve(np.column_stack(terms), distances)[0])
    except np.linalg.LinAlgError:
        return math.inf
