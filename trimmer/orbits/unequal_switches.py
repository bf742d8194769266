"""Orbits of a relay with two switches in a period that are not half a period apart.

With z = [x, 1] and x' = A x + b while the output is positive, z(T) = exp(M T) z(0) is
(I - t) z(T) = (I + t) z(0) for t = tanh(M T/2), which stays bounded where the system is unstable. Two such
equations, the second with -1 in place of 1, give the states at both switches for any two durations; both have
to be zeros of the relay's switching function. Their common zeros are looked for from the cells of a grid in
which both change their signs, so that one may be missed between its points.
"""

import math

import numpy as np

from trimmer.arrays import Reals
from trimmer.orbits.half_period import HalfPeriodEquation, Interval, solutions

POINTS = 48  # Durations along either side of the grid
UNEQUAL = 1e-4  # Relative difference of the durations below which the orbit is a symmetric one
SOLVED = 1e-8  # Largest value of the switching function, relative to the largest state, at both switches
MOST_CELLS = 200  # Cells from which a common zero is looked for
ITERATIONS = 8  # Of Newton's method
DIFFERENCE = 1e-7  # Of the logarithms of durations, for the slopes
STRIDE, FARTHEST = 0.3, 1.0  # Largest step of a logarithm, and its largest distance from the start


def unequal_switches(equation: HalfPeriodEquation, interval: Interval) -> list[tuple[float, float, Reals]]:
    """Find pairs of unequal durations, the longer one first, with the state where it begins.

    During the longer one the output of the relay is positive; the mirror images are left out.

    Args:
        equation: That of the half period, with the row of the switching function.
        interval: Shortest and longest duration, s.
    """
    durations = np.geomspace(*interval, POINTS)
    steady = equation.tangents(durations)
    long, short = np.nonzero(np.arange(POINTS)[:, None] >= np.arange(POINTS))
    values = np.full((POINTS, POINTS, 2), np.nan)
    values[long, short] = _switching(equation, steady[long], steady[short])
    cells = _cells(values)[:MOST_CELLS]
    if not cells:
        return []
    middles = 0.5 * (np.log(durations[:-1]) + np.log(durations[1:]))
    found: list[tuple[float, float, Reals]] = []
    for logarithms in _solved(equation, middles[np.array(cells)]):
        pair = _pair(equation, np.exp(logarithms))
        if not any(_alike(pair, other) for other in found):
            found.append(pair)
    return found


def _states(equation: HalfPeriodEquation, long: Reals, short: Reals) -> Reals:
    """Return the states at the beginning of both durations, (pairs, 2, n), from their tangents, or NaN."""
    count = len(equation.row)
    one = np.eye(count)
    matrix = np.block(
        [
            [one + long[:, :count, :count], long[:, :count, :count] - one],
            [one - short[:, :count, :count], -one - short[:, :count, :count]],
        ]
    )
    right = -2.0 * np.concatenate([long[:, :count, count], short[:, :count, count]], axis=1)
    return solutions(matrix, right[..., None]).reshape(-1, 2, count)


def _switching(equation: HalfPeriodEquation, long: Reals, short: Reals) -> Reals:
    """Return the switching function at both switches relative to the largest state; NaN if singular."""
    states, row = _states(equation, long, short), equation.balanced_row
    largest = abs(states).max(axis=(1, 2))[:, None] * abs(row).sum()
    return np.asarray((states @ row) / np.maximum(largest, np.finfo(float).tiny))


def _cells(values: Reals) -> list[tuple[int, int]]:
    """Return the cells in which both functions change their signs; above the diagonal neither has a value."""
    corners = np.stack([values[:-1, :-1], values[1:, :-1], values[:-1, 1:], values[1:, 1:]])
    lowest, highest = np.fmin.reduce(corners), np.fmax.reduce(corners)
    both = ((lowest <= 0) & (highest >= 0)).all(axis=-1)
    return [(int(i), int(j)) for i, j in zip(*np.nonzero(both), strict=True)]


def _solved(equation: HalfPeriodEquation, starts: Reals) -> Reals:
    """Return logarithms of unequal durations at common zeros, from all starts side by side (Newton).

    Args:
        equation: That of the half period.
        starts: Logarithms of pairs of durations, of shape (starts, 2).
    """

    def at(logarithms: Reals) -> Reals:
        tangents = equation.tangents(np.exp(logarithms))
        return _switching(equation, tangents[0::2], tangents[1::2])

    trials, shifts = starts.copy(), DIFFERENCE * np.array([[0.0, 0.0], [1.0, 0.0], [0.0, 1.0]])
    for _ in range(ITERATIONS):
        given = (trials[:, None] + shifts).reshape(-1)
        values = at(given).reshape(-1, 3, 2)
        slopes = (values[:, 1:] - values[:, :1]).transpose(0, 2, 1) / DIFFERENCE
        with np.errstate(invalid="ignore"):
            singular = ~(abs(np.linalg.det(slopes)) > 0)
        slopes[singular] = np.eye(2)
        steps = np.linalg.solve(slopes, values[:, 0, :, None])[..., 0]
        trials = trials - np.clip(np.nan_to_num(steps, nan=1.0), -STRIDE, STRIDE)
        trials = starts + np.clip(trials - starts, -FARTHEST, FARTHEST)
    missed = abs(at(trials.reshape(-1))).max(axis=1)
    kept = (missed <= SOLVED) & (abs(trials[:, 0] - trials[:, 1]) > UNEQUAL)
    return np.asarray(trials[kept], dtype=np.float64)


def _pair(equation: HalfPeriodEquation, durations: Reals) -> tuple[float, float, Reals]:
    """Return two durations, the longer one first, with the state where it begins."""
    tangents = equation.tangents(durations)
    begin, other = _states(equation, tangents[:1], tangents[1:])[0]
    first, second = durations.tolist()
    sizes = equation.state_sizes
    # The image of an orbit whose second duration is the longer one begins at the other switch.
    return (first, second, begin * sizes) if first > second else (second, first, -other * sizes)


def _alike(first: tuple[float, float, Reals], second: tuple[float, float, Reals]) -> bool:
    return all(
        math.isclose(one, other, rel_tol=1e-7) for one, other in zip(first[:2], second[:2], strict=True)
    )
