"""What is held at zero is zero to the last digit: the state is moved there along the forces that hold it.

An event is found to rounding, so a body that comes to rest keeps a velocity of some 1e-17 of the largest. It
has that still when it slips, and a backlash whose pin it carries would take the sign of that rounding for the
sign of the pin's velocity: part and meet again for ever at one instant.
"""

from itertools import combinations

import numpy as np

from trimmer.arrays import Reals
from trimmer.loops.interconnection import NEGLIGIBLE

DEPENDENT = 1e-10  # Held functions that differ by less, relative to their sizes, follow from one another


def projection(held: Reals, pushes: Reals) -> Reals:
    """Return the matrix, n x n, that moves a state along forces to where functions of it are zero.

    Functions are m x n and may depend on each other, what the forces do is n x m. For frictions this is
    the projection in the metric of the masses, without rounding in the velocities of what is held
    together.
    """
    influence = held @ pushes
    sizes = np.sqrt(abs(influence.diagonal()))
    inverse = np.linalg.pinv(influence / sizes / sizes[:, None], rcond=DEPENDENT) / sizes / sizes[:, None]
    moved = pushes @ inverse @ held
    terms = np.eye(len(moved)) + abs(pushes) @ abs(inverse) @ abs(held)
    onto = np.eye(len(moved)) - moved
    return _with_equal_rows(np.where(abs(onto) > NEGLIGIBLE * terms, onto, 0.0))


def _with_equal_rows(matrix: Reals) -> Reals:
    """Make rows equal that differ by rounding."""
    rows = matrix.copy()
    for first, other in combinations(range(len(rows)), 2):
        if abs(rows[first] - rows[other]).max() <= NEGLIGIBLE * abs(rows[first]).max():
            rows[other] = rows[first]
    return rows
