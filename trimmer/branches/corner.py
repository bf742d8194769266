"""Turning where a branch has a corner: at the birth or death of a phase the tangent jumps, even backwards."""

import numpy as np

from trimmer.arrays import Reals
from trimmer.branches.arc import Arc
from trimmer.branches.borders import Border, special_points
from trimmer.branches.null_vector import null_vector
from trimmer.branches.orbit import Place
from trimmer.branches.step import BranchStep, Front, angle, fold_at

REACHES = (1e-10, 1e-9, 1e-8, 1e-7, 1e-6)
"""Distances beyond the last orbit at which the other side of the border is looked for."""
JUMP = 1e-6  # Miss of a passage from just beyond an orbit that shows that the map jumps there
NEARBY = 30.0  # Largest distance of the first orbit behind the corner, in reaches


def turned(front: Front) -> BranchStep | None:
    """Go on behind a corner at the front.

    The map has a slope on the other side of the border too, where no orbit is; its null vector is the tangent
    there, and it points away from the border where slope and tangent keep the sign of their determinant.

    Returns:
        A very short step; None if there is no corner, or no orbit behind it.
    """
    for reach in REACHES:
        beyond = front.problem.place(front.place.position + reach * front.tangent)
        if beyond is None or beyond.signature == front.place.signature:
            continue
        for tangent in _tangents(front, beyond):
            found = _first_behind(front, tangent, reach)
            if found is not None:
                return _step(front, found, tangent)
    return None


def torn(front: Front) -> Border | None:
    """Return the front and what is just beyond it if the map jumps there, so that a motion ends elsewhere."""
    beyond = front.problem.place(front.place.position + REACHES[0] * front.tangent)
    return Border(front.place, beyond) if beyond is not None and beyond.error > JUMP else None


def _tangents(front: Front, beyond: Place) -> list[Reals]:
    """Return both directions along the curve on the other side, the one with the right determinant first."""
    tangent = null_vector(beyond.slope)
    right = beyond.orientation(tangent) * front.turn >= 0.0
    return [tangent, -tangent] if right else [-tangent, tangent]


def _first_behind(front: Front, tangent: Reals, reach: float) -> Place | None:
    arc = Arc(front.problem, front.place.position, tangent)
    place = arc.at(reach, front.place.position + reach * tangent)
    if place is None or place.signature == front.place.signature:
        return None
    near = np.linalg.norm(place.position - front.place.position) <= NEARBY * reach
    return place if near else None


def _step(front: Front, place: Place, reference: Reals) -> BranchStep | None:
    tangent = place.tangent(reference)
    if tangent is None:
        return None
    special = special_points(Border(front.place, place))
    if special and tangent[-1] * front.tangent[-1] < 0.0:
        special.append(fold_at(special))
    return BranchStep(front.moved(place, tangent), tuple(special), (), angle(front.tangent, tangent))
