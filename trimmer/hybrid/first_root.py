"""The first zero of a polynomial on [0, 1], such as an event function over a step: compiled.

Bernstein coefficients decide: where all are positive there is no zero, where their signs vary once there is
exactly one, and otherwise the interval is halved (Descartes' rule of signs; Farouki 2012). So no zero is
missed, however short the excursion, down to the rounding of the coefficients.
"""

from __future__ import annotations

from trimmer.arrays import Reals
from trimmer.hybrid.compilation import compiled, merged
from trimmer.hybrid.linear_combination import any_below, copy, unsigned

DEEPEST = 48
"""Halvings after which a minimum whose sign is not settled is taken as touching, not crossing."""
NARROWEST = 2.0**-DEEPEST
"""Width of an interval after as many halvings."""
CLOSE = 2.0**-10
"""Width of an interval from which on its polynomial counts as near its smallest value."""
ROUNDING = 64 * 2.0**-53
"""A coefficient below this share of the moduli of its terms, or of those of the value, is zero."""
NOWHERE = 2.0
"""A fraction of the step that lies beyond it: there is no such point."""


@compiled
def sign_variations(coefficients: Reals, count: int) -> tuple[int, bool]:
    """Count the changes of sign of the first ``count`` coefficients; zeros do not count.

    Returns:
        Number of changes, and whether the first sign is a minus.
    """
    variations, begins_negative = 0, False
    previous = 0.0
    for i in range(count):
        value = coefficients[i]
        if value != 0.0:
            if previous == 0.0:
                begins_negative = value < 0.0
            elif (value < 0.0) != (previous < 0.0):
                variations += 1
            previous = value
    return variations, begins_negative


@compiled
def halve(coefficients: Reals, count: int, left: Reals, right: Reals) -> None:
    """Split ``count`` Bernstein coefficients at the middle of the interval into ``left`` and ``right``.

    This is de Casteljau's algorithm.
    """
    copy(coefficients, count, right)
    left[0] = right[0]
    for level in range(1, count):
        for i in range(count - level):
            right[i] = 0.5 * (right[i] + right[i + 1])
        left[level] = right[0]


@merged
def is_last(step: float, before: float, point: float) -> bool:
    """Return whether a step of Halley's method to a zero is the last one, by the one before, 0 for none.

    Steps shrink to the third power, so that both tell what the next one would be.
    """
    following = step * (step / before) ** 3 if before > 0.0 else step
    return step <= 2.0**-52 * point or following <= 2.0**-56 * point


@compiled
def polished(bernstein: Reals, taylor: Reals, count: int, low: float, width: float) -> float:
    """Find the zero of a polynomial that falls through zero once in an interval, by Halley's method.

    Args:
        bernstein: Bernstein coefficients on the interval, which give the first guess.
        taylor: Coefficients of s^k.
        count: Degree plus one.
        low: Start of the interval.
        width: Its width.
    """
    high, place = low + width, 1
    while place < count - 1 and bernstein[place] > 0.0:
        place += 1
    drop = bernstein[place - 1] - bernstein[place]
    share = bernstein[place - 1] / drop if drop > 0.0 else 0.5
    point = low + width * (place - 1 + share) / (count - 1)
    before = 0.0
    for _ in range(100):
        value, slope, bend = 0.0, 0.0, 0.0
        for k in range(count):
            bend = bend * point + slope
            slope = slope * point + value
            value = value * point + taylor[unsigned(count - 1 - k)]
        if value > 0.0:
            low = point
        elif value < 0.0:
            high = point
        else:
            return point
        divisor = slope * slope - value * bend
        following = point - value * slope / divisor if slope < 0.0 < divisor else -1.0
        step = abs(following - point)
        if is_last(step, before, point):
            return min(max(following, low), high)
        before = step
        if not (low < following < high):
            before = 0.0
            following = 0.5 * (low + high)
            if not (low < following < high):
                return following
        point = following
    return point


@compiled
def first_root(
    bernstein: Reals, taylor: Reals, count: int, rounding: float, pieces: Reals
) -> tuple[float, float]:
    """Find where a polynomial that begins positive first falls through zero on [0, 1].

    Args:
        bernstein: Its Bernstein coefficients, ``count`` of them; the first one is positive.
        taylor: Its coefficients of s^k.
        count: Degree plus one.
        rounding: Value below which rounding decides whether there is a zero.
        pieces: Room for DEEPEST + 3 intervals: coefficients, start and width of each.

    Returns:
        The zero, and the place before it where the polynomial first falls below ``rounding`` without a zero;
        ``NOWHERE`` in place of either that does not exist.
    """
    begin, wide = pieces.shape[1] - 2, pieces.shape[1] - 1
    piece = pieces[DEEPEST + 2]
    copy(bernstein, count, pieces[0])
    pieces[0, begin], pieces[0, wide] = 0.0, 1.0
    top, touch = 1, NOWHERE
    while top > 0:
        top -= 1
        copy(pieces[top], piece.size, piece)
        start, width = piece[begin], piece[wide]
        variations, begins_negative = sign_variations(piece, count)
        root = NOWHERE
        if begins_negative or (width <= NARROWEST and piece[count - 1] < 0.0):
            root = start
        elif variations == 1:
            root = polished(piece, taylor, count, start, width)
        if root < NOWHERE:
            return root, touch if touch < root - CLOSE else NOWHERE
        if variations == 0 or width <= NARROWEST:
            if width <= CLOSE and any_below(piece, count, rounding):
                touch = min(touch, start)
            continue
        halve(piece, count, pieces[top + 1], pieces[top])
        pieces[top + 1, begin], pieces[top, begin] = start, start + 0.5 * width
        pieces[top + 1, wide] = pieces[top, wide] = 0.5 * width
        top += 2
    return NOWHERE, touch
