"""Switching to a branch that parts from another at a period doubling or where symmetry is lost."""

import numpy as np

from trimmer.arrays import Reals
from trimmer.branches.arc import Arc
from trimmer.branches.bifurcations import Bifurcation
from trimmer.branches.null_vector import null_vector
from trimmer.branches.orbit import Problem
from trimmer.branches.step import Front, begun

DISTANCES = (3e-5, 1e-4, 1e-3, 1e-2)
"""Distances from the bifurcation at which the first orbit of the other branch is sought, in their order."""
ASIDE = 0.5  # Largest distance of that orbit from where it was sought, relative to the distance


def parted_fronts(problem: Problem, bifurcation: Bifurcation) -> list[Front]:
    """Return where branches that part at a bifurcation begin.

    At a period doubling the branch of twice the period has the shape p - p0 = c a², x - x0 = a v with v the
    critical eigenvector; a and -a are the same orbit half a period apart. A mirrored map loses its symmetry
    in the same way: a and -a are mirror images. Where branches cross otherwise there is one on each side.
    """
    doubled = abs(bifurcation.place.multipliers + 1.0).min() < abs(bifurcation.place.multipliers - 1.0).min()
    matrix = bifurcation.place.monodromy
    critical = np.append(null_vector(matrix - (-1.0 if doubled else 1.0) * np.eye(len(matrix))), 0.0)
    if doubled:
        problem = Problem(problem.map.doubled(), problem.span, problem.sizes)
    directions = [critical] if doubled else [critical, -critical]
    fronts = [_first(problem, bifurcation.place.position, each) for each in directions]
    return [front for front in fronts if front is not None]


def _first(problem: Problem, origin: Reals, direction: Reals) -> Front | None:
    arc = Arc(problem, origin, direction)
    for distance in DISTANCES:
        guess = origin + distance * direction
        place = arc.at(distance, guess)
        if place is None or np.linalg.norm(place.position - guess) > ASIDE * distance:
            continue
        tangent = place.tangent(direction)
        if tangent is not None:
            return begun(problem, place, tangent)
    return None
