"""The flow of a mode over one step as a polynomial, and its event functions in Bernstein form: compiled.

It is what ``trimmer.motion.taylor`` does, which says where the length of a step comes from.
"""

from __future__ import annotations

import math
from collections.abc import Callable

import numpy as np

from trimmer.arrays import Integers, Reals
from trimmer.contact.compilation import sources
from trimmer.motion.compilation import inlined, kept
from trimmer.motion.taylor import DEGREE, LEVELS, LONGEST_STEP, REMAINDER

STEP = (REMAINDER * math.factorial(DEGREE + 1)) ** (1 / (DEGREE + 1))
"""Length of a step times the growth of its flow."""
SWEEPS = 12
"""Sweeps in which a matrix is balanced; a few are usual."""


@inlined
def _multiply(left: Reals, right: Reals, factor: float, result: Reals) -> None:
    """Write factor · left (n, n) · right (n, n)."""
    size = left.shape[0]
    for i in range(size):
        for j in range(size):
            result[i, j] = 0.0
        for k in range(size):
            weight = factor * left[i, k]
            if weight != 0.0:
                for j in range(size):
                    result[i, j] += weight * right[k, j]


@inlined
def _norm(matrix: Reals, first: int, end: int) -> float:
    """Return the largest sum of moduli of a column of a block on the diagonal."""
    largest = 0.0
    for j in range(first, end):
        total = 0.0
        for i in range(first, end):
            total += abs(matrix[i, j])
        largest = max(largest, total)
    return largest


@inlined
def _growth(matrix: Reals, count: int) -> float:
    """Return the root of the norm of a power of the first block of a matrix, balanced, 1/s.

    It bounds the remainder of the exponential series (Parlett and Reinsch 1969 for the balancing).
    """
    balanced = np.zeros((count, count))
    for i in range(count):
        for j in range(count):
            balanced[i, j] = matrix[i, j]
    for _ in range(SWEEPS):
        for i in range(count):
            column, row = 0.0, 0.0
            for j in range(count):
                if j != i:
                    column += abs(balanced[j, i])
                    row += abs(balanced[i, j])
            if column > 0.0 and row > 0.0:
                scale = math.sqrt(row / column)
                for j in range(count):
                    balanced[j, i] *= scale
                    balanced[i, j] /= scale
    size = _norm(balanced, 0, count)
    if size == 0.0:
        return 0.0
    total, other = np.zeros((count, count)), np.zeros((count, count))
    for i in range(count):
        for j in range(count):
            total[i, j] = balanced[i, j] / size
    for k in range(DEGREE):
        if k % 2 == 0:
            _multiply(balanced, total, 1.0 / size, other)
        else:
            _multiply(balanced, other, 1.0 / size, total)
    return float(size * _norm(total, 0, count) ** (1.0 / (DEGREE + 1)))


def _entry(sources: bytes) -> Callable[..., float]:
    def entry(
        flow: Reals,
        states: int,
        rows: Reals,
        screen: Reals,
        series: Reals,
        sufficient: Integers,
        taylor: Reals,
        sizes: Reals,
        bernstein_from_taylor: Reals,
    ) -> float:
        sources  # noqa: B018
        size, count = flow.shape[0], DEGREE + 1
        rate = max(_growth(flow, states), _norm(flow, states, size), 1.0 / LONGEST_STEP)
        step = STEP / rate
        terms = np.zeros((count, size, size))
        for i in range(size):
            terms[0, i, i] = 1.0
        for k in range(1, count):
            _multiply(flow, terms[k - 1], step / k, terms[k])
        for k in range(count - 1, -1, -1):
            for i in range(size):
                for j in range(size):
                    if k == count - 1:
                        screen[j, i] = 0.0
                    screen[j, i] += terms[k, i, j]
                    series[j, k * size + i] = terms[k, i, j]
        for function in range(rows.shape[0]):
            for j in range(size):
                for k in range(count):
                    value, modulus = 0.0, 0.0
                    for i in range(size):
                        term = rows[function, i] * terms[k, i, j]
                        value += term
                        modulus += abs(term)
                    taylor[function, j, k] = value
                    sizes[function, j, k] = modulus
                first = size + function * count
                for i in range(count):
                    screen[j, first + i] = 0.0
                for k in range(count):
                    for i in range(count):
                        screen[j, first + i] += taylor[function, j, k] * bernstein_from_taylor[0, k, i]
        for level in range(LEVELS):
            needed = 1
            for i in range(size):
                for j in range(size):
                    total, weight = 0.0, 1.0
                    for k in range(count):
                        total += weight * abs(terms[k, i, j])
                        weight *= 0.25**level
                    reached, weight, used = 0.0, 1.0, 0
                    while used < count and total - reached > REMAINDER * total:
                        reached += weight * abs(terms[used, i, j])
                        weight *= 0.25**level
                        used += 1
                    needed = max(needed, used)
            sufficient[level] = needed
        return step

    return kept(entry)


_compiled_entry = _entry(sources())


def tabulate(
    flow: Reals,
    states: int,
    rows: Reals,
    screen: Reals,
    series: Reals,
    sufficient: Integers,
    taylor: Reals,
    sizes: Reals,
    bernstein_from_taylor: Reals,
) -> float:
    """Write the tables of a mode, which ``trimmer.contact.tables.Tables`` describes.

    Args:
        flow: The matrix M, (N, N).
        states: How many of its first entries do not force the others.
        rows: Event functions as functionals, (functions, N).
        screen, series, sufficient, taylor, sizes: The tables to be written.
        bernstein_from_taylor: (MOST_ZEROS + 1, K + 1, K + 1).

    Returns:
        The length h of a step, s.
    """
    return _compiled_entry(  # type: ignore[no-any-return]
        flow, states, rows, screen, series, sufficient, taylor, sizes, bernstein_from_taylor
    )
