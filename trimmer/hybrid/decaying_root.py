"""Where an event function falls to zero over one step while a state in it decays by itself.

It is g(s) + z exp(-decay s), a polynomial and a known exponential: so it is where a gap closes while the
spring behind the slot still relaxes. Where g stays above the modulus of the second term there is no zero, and
where g falls everywhere faster than that term can change there is at most one. An interval is halved until
one or the other is so, and its later half is taken only if the earlier one has no zero; so the zero that is
found is the first one.
"""

from __future__ import annotations

import math

from trimmer.arrays import Reals
from trimmer.hybrid.compilation import compiled
from trimmer.hybrid.first_root import NOWHERE, halve, is_last
from trimmer.hybrid.linear_combination import any_below, copy, unsigned

UNSURE = -1.0
"""In place of a fraction of the step: shorter steps must decide."""
HALVINGS = 12
"""Halvings after which shorter steps are to decide."""


@compiled
def decaying_root(bernstein: Reals, taylor: Reals, state: float, decay: float, pieces: Reals) -> float:
    """Find the first zero of g(s) + state exp(-decay s) on [0, 1].

    Args:
        bernstein: Bernstein coefficients of g.
        taylor: Its coefficients of s^k.
        state: z, with the sign that it has in the event function.
        decay: Its rate, at least 0.
        pieces: Room for three intervals.

    Returns:
        The zero, ``NOWHERE`` for none, or ``UNSURE``.
    """
    piece, left, right, count = pieces[0], pieces[1], pieces[2], taylor.size
    copy(bernstein, count, piece)
    low, width, margin, root = 0.0, 1.0, abs(state), UNSURE
    for _ in range(HALVINGS if piece[0] > margin else 0):
        if not any_below(piece, count, margin):
            root = NOWHERE
            break
        if (
            piece[count - 1] < -margin
            and _steepest_rise(piece, count) * (count - 1) < -decay * width * margin
        ):
            root = _fallen(taylor, state, decay, low, low + width)
            break
        halve(piece, count, left, right)
        width *= 0.5
        if not any_below(left, count, margin):
            copy(right, count, piece)
            low += width
            margin = abs(state) * math.exp(-decay * low)
        elif left[count - 1] < -margin:
            copy(left, count, piece)
        else:
            break
    return root


@compiled
def _steepest_rise(bernstein: Reals, count: int) -> float:
    """Return the largest difference of neighbouring coefficients: a bound of the slope, over the degree."""
    rise = bernstein[1] - bernstein[0]
    for i in range(1, count - 1):
        rise = max(rise, bernstein[i + 1] - bernstein[i])
    return float(rise)


@compiled
def _fallen(taylor: Reals, state: float, decay: float, low: float, high: float) -> float:
    """Find the only zero of g(s) + state exp(-decay s) in an interval in which it falls (Halley)."""
    point, before = low, 0.0
    for _ in range(100):
        rest = state * math.exp(-decay * point)
        value, slope, bend = 0.0, 0.0, 0.0
        for k in range(taylor.size):
            bend = bend * point + slope
            slope = slope * point + value
            value = value * point + taylor[unsigned(taylor.size - 1 - k)]
        value += rest
        slope -= decay * rest
        bend += 0.5 * decay * decay * rest
        if value > 0.0:
            low = point
        elif value < 0.0:
            high = point
        else:
            break
        divisor = slope * slope - value * bend
        following = point - value * slope / divisor if slope < 0.0 < divisor else high
        step = abs(following - point)
        if is_last(step, before, point):
            point = min(max(following, low), high)
            break
        before = step
        if not low < following < high:
            before = 0.0
            following = 0.5 * (low + high)
        point = following
    return point
