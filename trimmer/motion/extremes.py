"""Extreme values of a signal along a motion, exact to rounding: at events, and where its rate is zero."""

from __future__ import annotations

from functools import cache
from typing import TYPE_CHECKING, NamedTuple

import numpy as np

from trimmer.motion.signals import Signal, along, rate, row_of_each

if TYPE_CHECKING:
    from trimmer.arrays import Integers, Reals
    from trimmer.motion.course import Course

ROUNDING = 8 * float(np.finfo(float).eps)  # Of a sum, as a share of the moduli of its terms
NEWTON_STEPS = 5  # Steps of Newton's method from between two nodes to the place of an extreme


class TurningPoints(NamedTuple):
    """Times, s, rows of the log and values, (count,), between which a signal only rises or only falls."""

    times: Reals
    rows: Integers
    values: Reals


def extremes(course: Course, signal: Signal) -> tuple[float, float]:
    """Return the smallest and the largest value of a signal over a motion, in its unit.

    They are one where they differ by the rounding of the terms of which it is the sum.
    """
    values = turning_points(course, signal).values
    smallest, largest = float(values.min()), float(values.max())
    if largest > smallest and largest - smallest <= ROUNDING * _terms(course, signal):
        return (smallest, smallest)
    return smallest, largest


def _terms(course: Course, signal: Signal) -> float:
    """Return the largest sum of moduli of the terms of a signal at events, in its unit."""
    _, rows, states = course.points
    return float(np.einsum("ij,ij->i", abs(states), abs(row_of_each(course, signal)[rows])).max())


def largest(course: Course, signal: Signal) -> float:
    """Return the largest modulus of a signal over a motion, in its unit."""
    return max(map(abs, extremes(course, signal)))


def turning_points(course: Course, signal: Signal) -> TurningPoints:
    """Return a signal at both ends of each segment and at its extremes in between."""
    times, rows, states = course.points
    slope = cache(rate(course.modes, signal))
    first = row_of_each(course, slope)
    slopes = np.einsum("ij,ij->i", states, first[rows])
    turning = np.flatnonzero((rows[1:] == rows[:-1]) & (slopes[1:] * slopes[:-1] < 0))
    last = np.flatnonzero(rows[1:] != rows[:-1])
    ends = np.sort(np.concatenate([[0], last, last + 1, [len(rows) - 1]]))
    at_ends = TurningPoints(times[ends], rows[ends], along(course, signal, rows[ends], states[ends]))
    if not len(turning):
        return at_ends
    bracket = times[turning], times[turning + 1], slopes[turning], slopes[turning + 1]
    inside, second = rows[turning], row_of_each(course, rate(course.modes, slope))
    between = _between(course, signal, inside, (first[inside], second[inside]), bracket)
    joined = TurningPoints._make(np.concatenate(pair) for pair in zip(at_ends, between, strict=True))
    order = np.lexsort((joined.times, joined.rows))
    return TurningPoints._make(each[order] for each in joined)


def _between(
    course: Course,
    signal: Signal,
    rows: Integers,
    rates: tuple[Reals, Reals],
    bracket: tuple[Reals, Reals, Reals, Reals],
) -> TurningPoints:
    """Return a signal where its rate is zero, by Newton's method between two times of unlike slopes.

    ``rates`` are the functionals of its rate and of its second rate in each of the rows of the log.
    """
    low, high, slope_low, slope_high = (each.copy() for each in bracket)
    first, second = rates
    times = (low * slope_high - high * slope_low) / (slope_high - slope_low)
    with np.errstate(divide="ignore"):
        for _ in range(NEWTON_STEPS):
            states = course.states(times)
            slope = np.einsum("ij,ij->i", states, first)
            curvature = np.einsum("ij,ij->i", states, second)
            before = slope * slope_low > 0
            low, high = np.where(before, times, low), np.where(before, high, times)
            following = times - np.divide(slope, curvature, out=np.zeros_like(slope), where=slope != 0)
            inside = (following >= low) & (following <= high)
            times = np.where(inside, following, 0.5 * (low + high))
    return TurningPoints(times, rows, along(course, signal, rows, course.states(times)))
