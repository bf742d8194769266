"""Sums of rows and values of polynomials, compiled, in loops that the compiler can vectorize.

Results are written into an array of the caller, the last argument.
"""

from __future__ import annotations

import numpy as np

from trimmer.arrays import Reals
from trimmer.hybrid.compilation import compiled

unsigned = np.uint64
"""Kind of a sum of whole numbers that is a place: else each place may be one from the end, and is asked."""


@compiled
def copy(values: Reals, count: int, result: Reals) -> None:
    """Copy the first values. A slice would do, but brings a second of compiling for its error messages."""
    for i in range(count):
        result[i] = values[i]


@compiled
def combine(weights: Reals, rows: Reals, count: int, result: Reals) -> None:
    """Write the first ``count`` entries of weights (m,) times rows (m, n), four rows at a time."""
    j, size = 0, weights.size
    if size >= 4:
        a, b, c, d = weights[0], weights[1], weights[2], weights[3]
        for i in range(count):
            result[i] = a * rows[0, i] + b * rows[1, i] + c * rows[2, i] + d * rows[3, i]
        j = 4
    else:
        for i in range(count):
            result[i] = 0.0
    while j + 4 <= size:
        a, b, c, d = weights[j], weights[j + 1], weights[j + 2], weights[j + 3]
        for i in range(count):
            value = result[i] + a * rows[j, i] + b * rows[j + 1, i]
            result[i] = value + c * rows[j + 2, i] + d * rows[j + 3, i]
        j += 4
    while j < size:
        for i in range(count):
            result[i] += weights[j] * rows[j, i]
        j += 1


@compiled
def multiply(left: Reals, right: Reals, factor: float, result: Reals) -> None:
    """Write factor · left (n, n) · right (n, n)."""
    size = len(left)
    for i in range(size):
        for j in range(size):
            result[i, j] = 0.0
        for k in range(size):
            weight = factor * left[i, k]
            if weight != 0.0:
                for j in range(size):
                    result[i, j] += weight * right[k, j]


@compiled
def evaluate_terms(terms: Reals, count: int, fraction: float, result: Reals) -> None:
    """Evaluate the state (n,) at a fraction of a step from its first ``count`` Taylor terms, side by side."""
    size, left = unsigned(result.size), count - 1
    at = unsigned(left) * size
    for i in range(size):
        result[i] = terms[at + i]
    while left >= 4:  # Four terms at a time: a result that was written has to be waited for.
        a, b, c = at - size, at - size - size, at - size - size - size
        at = c - size
        for i in range(size):
            value = (result[i] * fraction + terms[a + i]) * fraction + terms[b + i]
            result[i] = (value * fraction + terms[c + i]) * fraction + terms[at + i]
        left -= 4
    while left >= 1:
        at -= size
        for i in range(size):
            result[i] = result[i] * fraction + terms[at + i]
        left -= 1


@compiled
def combined_moduli(weights: Reals, row: Reals) -> float:
    """Return the sum of the moduli of weights (m,) times a row of moduli (m,)."""
    total = 0.0
    for j in range(weights.size):
        total += abs(weights[j]) * row[j]
    return total


@compiled
def within(values: Reals, bound: float) -> bool:
    """Return whether all moduli are at most a bound; NaN is not."""
    inside = 0
    for i in range(values.size):
        inside += abs(values[i]) <= bound
    return inside == values.size


@compiled
def any_below(values: Reals, count: int, bound: float) -> bool:
    """Return whether one of the first ``count`` values is less than a bound."""
    found = 0
    for i in range(count):
        found += values[i] < bound
    return found > 0


@compiled
def all_above(values: Reals, first: int, end: int, bound: float) -> bool:
    """Return whether the values from a first place up to an end are greater than a bound; NaN is not."""
    found, begin = 0, unsigned(first)
    for i in range(unsigned(end - first)):
        found += values[begin + i] > bound
    return found == end - first
