"""The flow of a mode over one step as a polynomial, and its event functions in Bernstein form."""

from __future__ import annotations

import math
from dataclasses import dataclass
from functools import cache
from typing import TYPE_CHECKING

import numpy as np
import scipy.linalg

if TYPE_CHECKING:
    from trimmer.arrays import Integers, Reals


DEGREE = 24
"""Degree of the polynomials; for the steps of ``step_series`` the remainder is less than rounding."""
REMAINDER = 2.0**-56
"""Bound of the next term of the series of exp(M h), in balanced coordinates."""
MOST_ZEROS = 3
"""No event function is known to vanish with more than its first three derivatives, the zeroth included."""
LEVELS = 6
"""Number of fractions 4^-level of a step for which ``sufficient_terms`` counts terms."""
LONGEST_STEP = 1e6
"""About the longest step, s, for motions that hardly change."""


@dataclass(frozen=True)
class StepSeries:
    """exp(M s h) for 0 <= s <= 1.

    Attributes:
        step: Length h of the step, s.
        terms: (M h)^k / k! for k = 0 to DEGREE, shape (DEGREE + 1, n, n).
    """

    step: float
    terms: Reals

    @property
    def whole(self) -> Reals:
        """exp(M h), the flow over a whole step, n x n."""
        whole: Reals = self.terms[::-1].sum(axis=0)
        return whole


def step_series(matrix: Reals, forcing: int) -> StepSeries:
    """Return the series of a flow, for the longest step at which it is exact to rounding.

    Args:
        matrix: M, n x n, 1/s.
        forcing: How many of the last entries of the state force the others and are not forced by them; their
            size has nothing to do with how fast the series converges, so the step does not depend on it.
    """
    forced = float(np.linalg.norm(matrix[-forcing:, -forcing:], 1))
    growth = max(_growth(matrix[:-forcing, :-forcing]), forced, 1.0 / LONGEST_STEP)
    step = (REMAINDER * math.factorial(DEGREE + 1)) ** (1 / (DEGREE + 1)) / growth
    terms = np.empty((DEGREE + 1, *matrix.shape))
    terms[0] = np.eye(matrix.shape[0])
    scaled = matrix * step
    for k in range(1, DEGREE + 1):
        np.matmul(scaled, terms[k - 1], out=terms[k])
        terms[k] /= k
    return StepSeries(step, terms)


def _growth(matrix: Reals) -> float:
    """Return the root of the norm of the power of the matrix that bounds the remainder, 1/s."""
    balanced = scipy.linalg.matrix_balance(matrix, permute=False)[0]
    size = float(np.linalg.norm(balanced, 1))
    if size == 0.0:
        return 0.0
    power = np.linalg.matrix_power(balanced / size, DEGREE + 1)
    return float(size * float(np.linalg.norm(power, 1)) ** (1 / (DEGREE + 1)))


def sufficient_terms(series: StepSeries) -> Integers:
    """Return how many terms give every entry of the flow to rounding, for fractions up to 4^-level of a step.

    Shape (LEVELS,).
    """
    powers = 4.0 ** -np.outer(np.arange(LEVELS), np.arange(DEGREE + 1))
    sizes = powers[..., None] * abs(series.terms.reshape(DEGREE + 1, -1))
    totals = sizes.cumsum(axis=1)
    enough = (totals[:, -1:] - totals <= REMAINDER * totals).all(axis=2)
    return np.asarray(enough.argmax(axis=1) + 1)


def along(row: Reals, series: StepSeries) -> Reals:
    """Return the coefficients of s^k of a signal over one step, as functionals of the state it begins with.

    Args:
        row: The signal, of shape (n,).
        series: The flow.

    Returns:
        Array (n, DEGREE + 1).
    """
    coefficients: Reals = np.einsum("i,kij->jk", row, series.terms)
    return coefficients


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
