"""The half-period equation of a relay, and all its zeros on an interval (Hamel; Tsypkin 1984).

While the output of the relay is constant, x' = A x + b. If x returns with its signs changed after T, it began
at x(0) = -A^-1 tanh(A T/2) b. The relay switches there, so c x(0) = 0, with the row c of its switching
function; with hysteresis, c x(0) is that.

On a piece of the interval the left side is interpolated in Chebyshev points until the last coefficients are
rounding, which they are as soon as no pole of tanh is near; all roots of the interpolant are eigenvalues of a
matrix (Trefethen, Approximation Theory and Approximation Practice, 2013, chapters 8 and 18). Pieces that come
too near a pole, as at odd multiples of half a period of an undamped mode, are given back as undecided.
"""

import math
from dataclasses import dataclass
from enum import Enum
from functools import cached_property

import numpy as np
import scipy.linalg
from numpy.polynomial import chebyshev

from trimmer.arrays import Reals

Interval = tuple[float, float]

NODES = 32  # Chebyshev points of a piece
LAST = 4  # Coefficients at the end that must be rounding
RESOLVED = 1e-11  # Share of the largest coefficient below which they are
ROUNDING = 1e-12  # Share of the sum of moduli below which the value of the switching function is rounding
RATIO = 1.5  # Of the ends of the pieces that are tried first
NARROWEST = 1e-5  # Relative width below which a piece is not halved any more
MOST_PIECES = 5_000  # Pieces after which what is left is undecided: about two seconds
NEARLY_REAL = 1e-5
"""Imaginary part, in units of half a piece, of a root that counts as real; two may have merged."""
SMALL = 0.25  # Norm of a matrix below which the rational approximation of tanh is exact to rounding

POINTS = np.cos(np.pi * (np.arange(NODES) + 0.5) / NODES)
TO_COEFFICIENTS = chebyshev.chebvander(POINTS, NODES - 1).T * (2.0 / NODES)
TO_COEFFICIENTS[0] *= 0.5


@dataclass(frozen=True, eq=False)
class HalfPeriodEquation:
    """c x(0) = level as an equation for the half period T."""

    matrix: Reals  # [[A, b], [0, 0]], (n + 1) x (n + 1), 1/s
    row: Reals  # c, of shape (n,)
    # What the switching function is where the output becomes positive; 0 without hysteresis
    level: float = 0.0

    def states(self, halves: Reals) -> Reals:
        """Return x(0) for half periods, s: (number of half periods, n)."""
        return -self.tangents(halves)[:, :-1, -1] * self.state_sizes

    def tangents(self, durations: Reals) -> Reals:
        """Return tanh(matrix T/2) in balanced coordinates for durations T, s."""
        return _tanh(0.5 * durations[:, None, None] * self._balanced[0])

    @property
    def state_sizes(self) -> Reals:
        """What turns states in balanced coordinates into x: factors of shape (n,)."""
        return self._balanced[1]

    @property
    def balanced_row(self) -> Reals:
        """The row c for states in balanced coordinates, of shape (n,)."""
        return self.row * self.state_sizes

    @cached_property
    def _balanced(self) -> tuple[Reals, Reals]:
        """Return the matrix in balanced coordinates, and the sizes of the states in them."""
        balanced, (scaling, _) = scipy.linalg.matrix_balance(self.matrix, permute=False, separate=True)
        # The last row is zero, so the last factor stays 1.
        return balanced, scaling[:-1]


@dataclass(frozen=True)
class Zeros:
    """Zeros on an interval."""

    halves: tuple[float, ...]  # Half periods, s, rising
    undecided: tuple[Interval, ...]  # Parts of the interval in which there may be others


def zeros(equation: HalfPeriodEquation, interval: Interval) -> Zeros:
    """Find all zeros of the half-period equation on an interval of half periods, s."""
    # From the first piece to the last, halves in their order.
    pending, found, undecided = _first_pieces(interval), [], []
    examined = 0
    while pending:
        begin, end = pending.pop()
        examined += 1
        given_up = examined > MOST_PIECES
        piece = Unsolved.UNDECIDED if given_up else _on_piece(equation, begin, end)
        if not isinstance(piece, Unsolved):
            found += piece
        elif piece is Unsolved.UNDECIDED or end - begin <= NARROWEST * end:
            undecided.append((begin, end))
        else:
            middle = 0.5 * (begin + end)
            pending += [(middle, end), (begin, middle)]
    return Zeros(_without_repetition(sorted(found)), _joined(undecided))


def interval_of(equation: HalfPeriodEquation) -> Interval:
    """Return the half periods, s, that the roots of the linear system suggest.

    They begin at a hundredth of the shortest time constant of a pole or zero, where the first term of the
    series in T rules; they end where the slowest transient has died away (40 time constants), but after no
    more than 25 periods of a mode without damping.
    """
    count = len(equation.row)
    A, b = equation.matrix[:count, :count], equation.matrix[:count, count]
    poles = np.linalg.eigvals(A)
    fastest = float(abs(poles).max(initial=0.0))
    bordered = np.block([[A, b[:, None]], [equation.row[None], np.zeros((1, 1))]])
    finite = scipy.linalg.eigvals(bordered, np.diag([1.0] * count + [0.0]))
    finite = finite[np.isfinite(finite)]
    roots = np.concatenate([poles, finite])
    largest = 1e3 * fastest if fastest > 0 else math.inf
    roots = roots[(abs(roots) > 1e-9 * fastest) & (abs(roots) <= largest)]
    if not roots.size:
        return 1e-2, 1e3
    with np.errstate(divide="ignore"):
        ends = np.minimum(40.0 / abs(roots.real), 50.0 * np.pi / abs(roots))
    return 0.01 / float(abs(roots).max()), float(ends.max())


class Unsolved(Enum):
    """Why a piece gives no zeros yet."""

    UNRESOLVED = "to be halved"
    UNDECIDED = "the left side is rounding everywhere"


def _on_piece(equation: HalfPeriodEquation, begin: float, end: float) -> list[float] | Unsolved:
    """Return the zeros on a piece, or why there are none yet."""
    middle, half = 0.5 * (begin + end), 0.5 * (end - begin)
    states = equation.states(middle + half * POINTS)
    coefficients = TO_COEFFICIENTS @ (states @ equation.row - equation.level)
    if not np.isfinite(coefficients).all():
        return Unsolved.UNRESOLVED
    rounding = ROUNDING * (float((abs(states) @ abs(equation.row)).max()) + abs(equation.level))
    largest = float(abs(coefficients).max())
    if largest <= rounding:
        return Unsolved.UNDECIDED
    if abs(coefficients[-LAST:]).max() > max(RESOLVED * largest, rounding):
        return Unsolved.UNRESOLVED
    if abs(coefficients[0]) > abs(coefficients[1:]).sum() + rounding:
        return []
    significant = np.flatnonzero(abs(coefficients) > 1e-3 * rounding)[-1] + 1
    roots = chebyshev.chebroots(coefficients[:significant])
    real = roots[(abs(roots.imag) <= NEARLY_REAL) & (abs(roots.real) <= 1.0 + NEARLY_REAL)].real
    return [middle + half * float(root) for root in real]


def _tanh(matrices: Reals) -> Reals:
    """Return the hyperbolic tangents of matrices: a rational approximation, and the argument doubled.

    Unlike exponentials it stays bounded where the system is unstable. At a pole of tanh it is NaN.
    """
    norm = float(abs(matrices).sum(axis=1).max())
    doublings = int(norm / SMALL).bit_length()
    small = matrices * 2.0**-doublings
    one, square = np.eye(matrices.shape[-1]), small @ small
    odd = ((square + 378.0 * one) @ square + 17325.0 * one) @ square + 135135.0 * one
    even = ((28.0 * square + 3150.0 * one) @ square + 62370.0 * one) @ square + 135135.0 * one
    result = solutions(even, odd @ small)
    for _ in range(doublings):
        result = solutions(one + result @ result, 2.0 * result)
    return result


def solutions(matrices: Reals, right: Reals) -> Reals:
    """Return what solves each of many systems of equations, (count, n, columns); NaN where it is singular."""
    try:
        return np.asarray(np.linalg.solve(matrices, right), dtype=np.float64)
    except np.linalg.LinAlgError:
        if len(matrices) == 1:
            return np.full_like(right, np.nan)
    middle = len(matrices) // 2
    return np.concatenate(
        [solutions(matrices[part], right[part]) for part in (slice(middle), slice(middle, None))]
    )


def _first_pieces(interval: Interval) -> list[Interval]:
    """Cut an interval into pieces whose ends are in a fixed ratio, the first one last."""
    begin, end = interval
    ends = np.geomspace(begin, end, 1 + max(1, math.ceil(math.log(end / begin) / math.log(RATIO))))
    return list(zip(ends[:-1].tolist(), ends[1:].tolist(), strict=True))[::-1]


def _without_repetition(rising: list[float]) -> tuple[float, ...]:
    """Drop a zero that two neighbouring pieces share."""
    kept: list[float] = []
    for each in rising:
        if not kept or each - kept[-1] > 1e-9 * each:
            kept.append(each)
    return tuple(kept)


def _joined(rising: list[Interval]) -> tuple[Interval, ...]:
    """Join intervals that touch."""
    joined: list[Interval] = []
    for begin, end in rising:
        if joined and begin <= joined[-1][1] * (1.0 + 1e-12):
            joined[-1] = joined[-1][0], end
        else:
            joined.append((begin, end))
    return tuple(joined)
