"""Points of the unit cube that fill it more evenly than random ones do."""

import math

import numpy as np

from trimmer.arrays import Reals
from trimmer.choices import Choice
from trimmer.showing.shown import counted

EDGE = 2.0**-40  # Least distance from the faces of the cube, where a normal distribution has no value


class Plan(Choice):
    """How samples are spread: as a Latin hypercube, or by Sobol's sequence."""

    LATIN_HYPERCUBE = "latin-hypercube"
    SOBOL = "sobol"

    def count(self, wanted: int) -> int:
        """Return how many points there will be: of Sobol a power of two, since others are not even."""
        return 2 ** math.ceil(math.log2(wanted)) if self is Plan.SOBOL else wanted

    def points(self, count: int, dimensions: int, seed: int) -> Reals:
        """Return points in the open unit cube, shape (count, dimensions).

        A point of Sobol depends on its number and the seed alone, so more points go on with the same ones.
        """
        from scipy.stats import qmc

        if self is Plan.SOBOL:
            drawn = qmc.Sobol(dimensions, rng=seed).random(count)
        else:
            drawn = qmc.LatinHypercube(dimensions, rng=seed).random(count)
        return within_cube(drawn)


def within_cube(points: Reals) -> Reals:
    """Return points that lie on no face of the unit cube, but next to it."""
    return np.asarray(np.clip(points, EDGE, 1.0 - EDGE))


def left_out(number: int, whose: str) -> str:
    """Say that samples were left out whose values nothing can have: a mechanism, a trimmer."""
    return f"{counted(number, 'sample')} that no {whose} can have {'was' if number == 1 else 'were'} left out"
