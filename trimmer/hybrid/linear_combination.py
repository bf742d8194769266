"""Sums of rows and values of polynomials, compiled, in loops that the compiler can vectorize.

Results are written into an array of the caller, the last argument.
"""

from __future__ import annotations

from trimmer.arrays import Reals
from trimmer.hybrid.compilation import compiled


@compiled
def copy(values: Reals, count: int, result: Reals) -> None:
    """Copy the first values. A slice would do, but brings a second of compiling for its error messages."""
    for i in range(count):
        result[i] = values[i]


@compiled
def combine(weights: Reals, rows: Reals, count: int, result: Reals) -> None:
    """Write the first ``count`` entries of weights (m,) times rows (m, n), four rows at a time."""
    last = weights.size - 1
    for i in range(count):
        result[i] = weights[last] * rows[last, i]
    j = 0
    while j + 4 <= last:
        a, b, c, d = weights[j], weights[j + 1], weights[j + 2], weights[j + 3]
        for i in range(count):
            result[i] += a * rows[j, i] + b * rows[j + 1, i] + c * rows[j + 2, i] + d * rows[j + 3, i]
        j += 4
    while j < last:
        for i in range(count):
            result[i] += weights[j] * rows[j, i]
        j += 1


@compiled
def evaluate_terms(terms: Reals, count: int, fraction: float, result: Reals) -> None:
    """Evaluate the state (n,) at a fraction of a step from its first ``count`` Taylor terms, side by side."""
    size = result.size
    for i in range(size):
        result[i] = terms[(count - 1) * size + i]
    for k in range(count - 2, -1, -1):
        for i in range(size):
            result[i] = result[i] * fraction + terms[k * size + i]


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
    outside = False
    for i in range(values.size):
        outside |= not abs(values[i]) <= bound
    return not outside


@compiled
def any_below(values: Reals, count: int, bound: float) -> bool:
    """Return whether one of the first ``count`` values is less than a bound."""
    found = False
    for i in range(count):
        found |= values[i] < bound
    return found
