"""Small dense kernels, compiled, written so that the compiler can use vector instructions."""

from __future__ import annotations

import numba
import numpy as np
from numpy.typing import NDArray

Reals = NDArray[np.float64]


@numba.njit(cache=True)
def combine(weights: Reals, rows: Reals, result: Reals) -> None:
    """Write the sum of rows with weights."""
    result[:] = 0.0
    for j in range(weights.size):
        weight = weights[j]
        if weight != 0.0:
            row = rows[j]
            for i in range(result.size):
                result[i] += weight * row[i]


@numba.njit(cache=True)
def evaluate_terms(terms: Reals, count: int, fraction: float, result: Reals) -> None:
    """Evaluate the state at a fraction of a step from its ``count`` Taylor terms (Horner)."""
    size = result.size
    for i in range(size):
        result[i] = terms[(count - 1) * size + i]
    for k in range(count - 2, -1, -1):
        for i in range(size):
            result[i] = result[i] * fraction + terms[k * size + i]


@numba.njit(cache=True)
def evaluate_polynomial(coefficients: Reals, points: Reals, values: Reals) -> None:
    """Evaluate a polynomial at all points (Horner)."""
    values[:] = coefficients[coefficients.size - 1]
    for k in range(coefficients.size - 2, -1, -1):
        coefficient = coefficients[k]
        for i in range(points.size):
            values[i] = values[i] * points[i] + coefficient


@numba.njit(cache=True)
def size_of_terms(row: Reals, state: Reals) -> float:
    """Sum the moduli of the terms of a functional."""
    total = 0.0
    for i in range(state.size):
        total += abs(row[i] * state[i])
    return total
