"""Polynomials over one step: their degree, what the step follows from, and their Bernstein form."""

import math
from functools import cache

import numpy as np

from trimmer.arrays import Reals

DEGREE = 24
"""Degree of the polynomials; for the steps of ``trimmer.hybrid.series`` the rest is less than rounding."""
REMAINDER = 2.0**-56  # Bound of the next term of the series of exp(M h), in balanced coordinates
MOST_ZEROS = 3
"""No event function is known to vanish with more than its first three derivatives, the zeroth included."""
LEVELS = 6  # Number of fractions 4^-level of a step for which terms are counted
LONGEST_STEP = 1e6  # About the longest step, s, for motions that hardly change


@cache
def bernstein_from_taylor() -> Reals:
    """Return the matrices that turn coefficients of s^k into Bernstein coefficients on [0, 1].

    Array (MOST_ZEROS + 1, DEGREE + 1, DEGREE + 1), with one matrix for each degree from DEGREE downwards,
    which has one row for each k.
    """
    matrices = np.zeros((MOST_ZEROS + 1, DEGREE + 1, DEGREE + 1))
    for m in range(MOST_ZEROS + 1):
        degree = DEGREE - m
        for k in range(degree + 1):
            for i in range(k, degree + 1):
                matrices[m, k, i] = math.comb(i, k) / math.comb(degree, k)
    return matrices
