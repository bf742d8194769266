"""The first zero of a polynomial on [0, s_end], compiled.

Bernstein coefficients decide: where all are positive there is no zero, where their signs vary once there is
exactly one, and otherwise the interval is halved (Descartes' rule of signs; Farouki 2012). So no zero is
missed, however short the excursion, down to the rounding of the coefficients.
"""

from __future__ import annotations

import math

import numba
import numpy as np
from numpy.typing import NDArray

Reals = NDArray[np.float64]

NONE, CROSSING = 0, 1
DEEPEST = 48
"""Halvings after which a dip that does not show a sign is taken as touching, not crossing."""


@numba.njit(cache=True)
def sign_variations(coefficients: Reals, count: int) -> int:
    """Count the changes of sign; zeros do not count."""
    variations = 0
    previous = 0.0
    for i in range(count):
        value = coefficients[i]
        if value != 0.0:
            if previous != 0.0 and (value < 0.0) != (previous < 0.0):
                variations += 1
            previous = value
    return variations


@numba.njit(cache=True)
def halve(coefficients: Reals, count: int, left: Reals, right: Reals) -> None:
    """Split Bernstein coefficients at the middle of the interval (de Casteljau)."""
    for i in range(count):
        right[i] = coefficients[i]
    left[0] = right[0]
    for level in range(1, count):
        for i in range(count - level):
            right[i] = 0.5 * (right[i] + right[i + 1])
        left[level] = right[0]


@numba.njit(cache=True)
def polished(taylor: Reals, count: int, low: float, high: float) -> float:
    """Find the zero of a polynomial that falls through zero once between low and high, by Newton's method."""
    point = 0.5 * (low + high)
    for _ in range(100):
        value = 0.0
        slope = 0.0
        for k in range(count - 1, -1, -1):
            slope = slope * point + value
            value = value * point + taylor[k]
        if value > 0.0:
            low = point
        elif value < 0.0:
            high = point
        else:
            return point
        following = point - value / slope if slope < 0.0 else -1.0
        if not (low < following < high):
            following = 0.5 * (low + high)
        if abs(following - point) <= 1e-16 * abs(point) or following in (low, high):
            return following
        point = following
    return point


@numba.njit(cache=True)
def first_root(bernstein: Reals, taylor: Reals, count: int) -> tuple[int, float, int]:
    """Find where a polynomial that begins positive first falls through zero on [0, 1].

    Args:
        bernstein: Its Bernstein coefficients, ``count`` of them; the first one is positive.
        taylor: Its coefficients of s^k.
        count: Degree plus one.

    Returns:
        (NONE, 1) or (CROSSING, s), and how many times it came so near to zero in between that rounding
        decides whether it touches.
    """
    stack = np.empty((DEEPEST + 2, count))
    starts = np.empty(DEEPEST + 2)
    depths = np.empty(DEEPEST + 2, dtype=np.int64)
    stack[0] = bernstein[:count]
    starts[0] = 0.0
    depths[0] = 0
    top = 1
    touches = 0
    piece = np.empty(count)
    while top > 0:
        top -= 1
        piece[:] = stack[top]
        start = starts[top]
        depth = depths[top]
        variations = sign_variations(piece, count)
        if variations == 0:
            if piece[0] >= 0.0 and piece[count - 1] >= 0.0:
                continue
            return CROSSING, start, touches
        width = math.ldexp(1.0, -depth)
        if variations == 1 and piece[0] >= 0.0:
            return CROSSING, polished(taylor, count, start, start + width), touches
        if depth >= DEEPEST:
            if piece[count - 1] < 0.0:
                return CROSSING, start, touches
            touches += 1
            continue
        halve(piece, count, stack[top + 1], stack[top])
        starts[top + 1] = start
        starts[top] = start + 0.5 * width
        depths[top] = depth + 1
        depths[top + 1] = depth + 1
        top += 2
    return NONE, 1.0, touches
