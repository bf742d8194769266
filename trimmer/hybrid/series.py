"""The flow of a mode over one step as a polynomial, and its event functions in Bernstein form: compiled.

A step is the longest at which the series is exact to rounding. It does not depend on what forces the states
and is not forced by them, whose size has nothing to do with how fast the series converges.
"""

from __future__ import annotations

import math
from collections.abc import Callable
from typing import NamedTuple

import numpy as np

from trimmer.arrays import Integers, Reals
from trimmer.hybrid.compilation import compiled, kept, sources
from trimmer.hybrid.linear_combination import multiply, unsigned
from trimmer.hybrid.taylor import DEGREE, LEVELS, LONGEST_STEP, REMAINDER

STEP = (REMAINDER * math.factorial(DEGREE + 1)) ** (1 / (DEGREE + 1))
"""Length of a step times the growth of its flow."""
SWEEPS = 12
"""Sweeps in which a matrix is balanced; a few are usual."""
COUNT = DEGREE + 1
"""Coefficients of a polynomial."""


class ModeTables(NamedTuple):
    """Where the tables of one mode are written, which ``trimmer.hybrid.tables.Tables`` describes.

    Attributes:
        screen: (N, N + functions (K + 1)).
        series: (N, (K + 1) N).
        terms: (LEVELS,).
        taylor: (functions, N, K + 1).
        sizes: (functions, K + 1, N).
        bernstein_from_taylor: It is read, (MOST_ZEROS + 1, K + 1, K + 1).
    """

    screen: Reals
    series: Reals
    terms: Integers
    taylor: Reals
    sizes: Reals
    bernstein_from_taylor: Reals


@compiled
def _norm(matrix: Reals, first: int, end: int) -> float:
    """Return the largest sum of moduli of a column of a block on the diagonal."""
    largest = 0.0
    for j in range(first, end):
        total = 0.0
        for i in range(first, end):
            total += abs(matrix[i, j])
        largest = max(largest, total)
    return largest


@compiled
def _balance(matrix: Reals) -> None:
    """Scale rows and columns of a square matrix alike until their sums match (Parlett and Reinsch 1969)."""
    count = len(matrix)
    for _ in range(SWEEPS):
        for i in range(count):
            column, row = 0.0, 0.0
            for j in range(count):
                if j != i:
                    column += abs(matrix[j, i])
                    row += abs(matrix[i, j])
            if column > 0.0 and row > 0.0:
                scale = math.sqrt(row / column)
                for j in range(count):
                    matrix[j, i] *= scale
                    matrix[i, j] /= scale


@compiled
def _growth(matrix: Reals, room: Reals) -> float:
    """Return the root of the norm of a power of the first block of a matrix, balanced, 1/s.

    It bounds the remainder of the exponential series. The room is for three blocks.
    """
    balanced, total, other = room[0], room[1], room[2]
    count = len(balanced)
    for i in range(count):
        for j in range(count):
            total[i, j] = 1.0 if i == j else 0.0
            balanced[i, j] = matrix[i, j]
    _balance(balanced)
    size, growth = _norm(balanced, 0, count), 0.0
    if size > 0.0:
        for _ in range(COUNT):
            multiply(balanced, total, 1.0 / size, other)
            for i in range(count):
                for j in range(count):
                    total[i, j] = other[i, j]
        growth = size * _norm(total, 0, count) ** (1.0 / COUNT)
    return growth


@compiled
def _write_flow(terms: Reals, target: ModeTables) -> None:
    """Write the flow over a whole step, and the terms of its series side by side."""
    size = unsigned(terms.shape[1])
    for j in range(size):
        for i in range(size):
            target.screen[j, i] = 0.0
        for k in range(COUNT):
            place = unsigned(COUNT - 1 - k)  # The smallest terms first.
            for i in range(size):
                target.screen[j, i] += terms[place, i, j]
                target.series[j, place * size + i] = terms[place, i, j]


@compiled
def _expand(row: Reals, terms: Reals, taylor: Reals, sizes: Reals) -> None:
    """Write the coefficients of s^k of a functional, and the sums of the moduli of their terms."""
    for k in range(COUNT):
        for j in range(row.size):
            taylor[j, k] = sizes[k, j] = 0.0
        for i in range(row.size):
            for j in range(row.size if row[i] != 0.0 else 0):
                term = row[i] * terms[k, i, j]
                taylor[j, k] += term
                sizes[k, j] += abs(term)


@compiled
def _write_screen(function: int, target: ModeTables) -> None:
    """Write the Bernstein coefficients of an event function beside those of the others."""
    size = len(target.screen)
    first = unsigned(size + function * COUNT)
    for j in range(size):
        for i in range(unsigned(COUNT)):
            target.screen[j, first + i] = 0.0
        for k in range(COUNT):
            value = target.taylor[function, j, k]
            for i in range(unsigned(k), unsigned(COUNT if value != 0.0 else k)):  # The matrix is triangular.
                target.screen[j, first + i] += value * target.bernstein_from_taylor[0, k, i]


@compiled
def _sufficient(terms: Reals, level: int) -> int:
    """Return how many of the terms give every entry of the flow to rounding, for fractions up to 4^-level.

    The terms stand in the first K + 1 rows, (2 K + 2, N N). The others are room for sums of their moduli.
    """
    size, used, weight = terms.shape[1], 1, 1.0
    for k in range(COUNT):
        for i in range(size):
            before = terms[COUNT + k - 1, i] if k > 0 else 0.0
            terms[COUNT + k, i] = before + weight * abs(terms[k, i])
        weight *= 0.25**level
    for i in range(size):
        total = terms[2 * COUNT - 1, i]
        while used < COUNT and total - terms[COUNT + used - 1, i] > REMAINDER * total:
            used += 1
    return used


def _entry(sources: bytes) -> Callable[..., float]:
    def entry(flow: Reals, rows: Reals, target: ModeTables, room: Reals, terms: Reals, flat: Reals) -> float:
        sources  # noqa: B018
        size = len(flow)
        rate = max(_growth(flow, room), _norm(flow, room.shape[1], size), 1.0 / LONGEST_STEP)
        step = STEP / rate
        for i in range(size):
            terms[0, i, i] = 1.0
        for k in range(1, COUNT):
            multiply(flow, terms[k - 1], step / k, terms[k])
        _write_flow(terms, target)
        for function in range(len(rows)):
            _expand(rows[function], terms, target.taylor[function], target.sizes[function])
            _write_screen(function, target)
        for level in range(LEVELS):
            target.terms[level] = _sufficient(flat, level)
        return float(step)

    return kept(entry)


_compiled_entry = _entry(sources())


def tabulate(flow: Reals, states: int, rows: Reals, target: ModeTables) -> float:
    """Write the tables of a mode.

    Args:
        flow: The matrix M, (N, N).
        states: How many of its first entries do not force the others.
        rows: Event functions as functionals, (functions, N).
        target: The tables to be written.

    Returns:
        The length h of a step, s.
    """
    size = len(flow)
    room, flat = np.empty((3, states, states)), np.empty((2 * COUNT, size * size))
    flat[0] = 0.0
    flow, terms = np.ascontiguousarray(flow), flat[:COUNT].reshape(COUNT, size, size)
    return _compiled_entry(flow, rows, target, room, terms, flat)
