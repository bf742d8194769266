"""Where a branch joins one with half the period or the symmetric one: at a bifurcation of that other branch.

The doubled orbits turn around there, and their map is singular. The map of a single passage is not: it has a
multiplier that passes -1, which is located on the branch of its own orbits.
"""

import numpy as np
import scipy.optimize

from trimmer.arrays import Reals
from trimmer.branches.arc import Arc, LostError
from trimmer.branches.bifurcations import Bifurcation
from trimmer.branches.orbit import Place, Problem
from trimmer.branches.special import SpecialKind, SpecialPoint
from trimmer.branches.step import Front, begun, halves

BEGINNING = 1e-6  # Distance from the bifurcation at which the other branch begins, in values without units
EXACT = 1e-14  # Change of a value without units that ends its location
NEARBY = 1e-2
"""Largest distance of the bifurcation from where the doubled orbits show it, in values without units."""
MOST_ITERATIONS = 30


def joint(front: Front, far: Place) -> Bifurcation | None:
    """Locate the bifurcation at which a branch of doubled orbits joins that of single ones.

    Args:
        front: The last of the doubled orbits.
        far: One beyond, whose halves are exchanged.

    Returns:
        The bifurcation, with an orbit of the single map; None if it is not found near.
    """
    single = front.problem.map.single
    if single is None:
        return None
    problem = Problem(single, front.problem.span, front.problem.sizes)
    guess = _middle(front, far)
    across = np.append(np.zeros(len(guess) - 1), 1.0)
    place = problem.correct(guess, across, float(guess[-1]))
    if place is None:
        return None
    try:
        found = _located(Arc(problem, np.zeros(len(guess)), across), place)
    except LostError:
        return None
    if abs(found.position[-1] - guess[-1]) > NEARBY:
        return None
    kind = SpecialKind.SYMMETRY_BREAKING if single.mirrored else SpecialKind.PERIOD_DOUBLING
    note = (
        "the asymmetric branch joins the symmetric one, and so does its mirror image"
        if single.mirrored
        else "the branch joins the one with half the period"
    )
    return Bifurcation(SpecialPoint(kind, found.value, found.strobed, note=note), found, True)


def _middle(front: Front, far: Place) -> Reals:
    """Return about where the difference between the halves is zero, the state as the mean of both halves."""
    near = front.place
    differences = [halves(front.problem, place) for place in (near, far)]
    first, last = (np.zeros(1) if each is None else each for each in differences)
    lengths = float(np.linalg.norm(first)), float(np.linalg.norm(last))
    total = sum(lengths)
    share = lengths[0] / total if total > 0.0 else 0.5
    guess: Reals = near.position + share * (far.position - near.position)
    guess[:-1] += 0.5 * (first + share * (last - first))
    return guess


def _located(arc: Arc, place: Place) -> Place:
    """Find the orbit with a multiplier -1 by the secant method over the value.

    Raises:
        LostError: if an orbit on the way is not found, or the method does not converge.
    """
    places = [place]

    def orbit(value: float) -> Place:
        nearest = min(places, key=lambda each: abs(arc.distance(each) - value))
        found = arc.at(value, arc.predicted(nearest, value))
        if found is None:
            raise LostError
        places.append(found)
        return found

    def test(value: float) -> float:
        return float(np.prod(orbit(value).multipliers + 1.0).real)

    begin = arc.distance(place)
    _, result = scipy.optimize.newton(
        test, begin, x1=begin + BEGINNING, tol=EXACT, maxiter=MOST_ITERATIONS, full_output=True, disp=False
    )
    if not result.converged:
        raise LostError
    return orbit(float(result.root))


def front_beyond(bifurcation: Bifurcation, sign: float) -> Front | None:
    """Return where the branch of the single orbits begins on one side of a bifurcation on it.

    Args:
        bifurcation: What ``joint`` found.
        sign: 1 for larger values, -1 for smaller ones.
    """
    place = bifurcation.place
    along = np.append(np.zeros(len(place.miss)), sign)
    arc = Arc(place.problem, place.position, along)
    first = arc.at(BEGINNING, arc.predicted(place, BEGINNING))
    tangent = None if first is None else first.tangent(along)
    return None if first is None or tangent is None else begun(place.problem, first, tangent)
