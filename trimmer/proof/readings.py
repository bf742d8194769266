"""What is read of a motion: extremes, mean and mean square of functionals, and their values before events.

Over each step a functional is Taylor's polynomial with an error. Its square is integrated as a polynomial.
Its extremes are at the ends of what its slope says is monotone; elsewhere a piece is halved until the slope
leaves nothing to tell.
"""

from __future__ import annotations

import functools
from collections.abc import Iterator
from dataclasses import dataclass

from flint import arb, arb_mat, arb_poly

from trimmer.proof.balls import about, between, exact, hull, real
from trimmer.proof.between_events import steps_over, takes_time
from trimmer.proof.following import BallMotion, Followed, moduli
from trimmer.proof.outcome import UndecidedError, require_time
from trimmer.proof.statement import Functional

TERMS, DIGITS = 30, 15
"""Of Taylor's polynomials; of what is told."""
FINE = 2.0**-56
"""Share of the terms of a functional below which nothing is left to tell of an extreme."""


@dataclass(frozen=True)
class Piece:
    """A functional over a step, as polynomials of the share of it, 0 to 1, with their largest errors."""

    duration: arb
    value: arb_poly
    slope: arb_poly
    off: arb
    slope_off: arb

    def integrals(self) -> tuple[arb, arb]:
        """Integrate it, and its square."""
        largest = sum(map(abs, self.value.coeffs()), arb(0))
        of_square = about(self.off * (2 * largest + self.off))
        once, twice = (each.integral()(arb(1)) for each in (self.value, self.value * self.value))
        return self.duration * (once + about(self.off)), self.duration * (twice + of_square)

    def at(self, share: arb) -> arb:
        """Enclose its value."""
        return self.value(share) + about(self.off)

    def extremes(self, lowest: arb, highest: arb, fine: arb) -> tuple[arb, arb]:
        """Enclose the extremes of it and of what came before, to what is fine enough."""
        waiting = [(0.0, 1.0)]
        for each in map(self.at, (arb(0), arb(1))):
            lowest, highest = lowest.min(each), highest.max(each)
        while waiting:
            require_time()
            first, last = waiting.pop()
            slope = self.slope(hull(first, last)) + about(self.slope_off)
            half = 0.5 * (last - first)
            middle, reach = self.at(arb(first + half)), (abs(slope) * half).upper()
            if middle - reach > lowest and middle + reach < highest:
                continue
            lowest, highest = lowest.min(middle), highest.max(middle)
            if not slope.contains(0):
                ends = self.at(arb(first)), self.at(arb(last))
                lowest, highest = lowest.min(ends[0]).min(ends[1]), highest.max(ends[0]).max(ends[1])
            elif reach <= fine:
                lowest = lowest.min(middle + about(reach))
                highest = highest.max(middle + about(reach))
            elif half < 2.0**-50:
                raise UndecidedError("an extreme of what is read is not enclosed")
            else:
                waiting += [(first, first + half), (first + half, last)]
        return lowest, highest


def reading(motion: BallMotion, over: Followed, functional: Functional) -> str:
    """Say what a functional does over a motion, and before events."""
    rows = [_row(motion, each) for each in functional.rows]
    before = {k: (rows[motion.course.segments[k].mode] * over.ends[k])[0, 0] for k in functional.before}
    sizes = arb_mat([[each] for each in motion.sizes])
    fine = FINE * functools.reduce(arb.max, ((moduli(row) * sizes)[0, 0] for row in rows)).lower()
    pieces = list(_pieces(motion, over, rows))
    lowest = highest = pieces[0].at(arb(0))
    once = twice = period = arb(0)
    for piece in pieces:
        lowest, highest = piece.extremes(lowest, highest, fine)
        integrals = piece.integrals()
        once, twice, period = once + integrals[0], twice + integrals[1], period + piece.duration
    mean, square = once / period, twice / period
    told = {
        "smallest": lowest,
        "largest": highest,
        "peak to peak": highest - lowest,
        "integral": once,
        "mean": mean,
        "root mean square": _root(square),
        "about the mean": _root(square - mean * mean),
        **{f"before event {k + 1}": value for k, value in before.items()},
    }
    if not all(each.is_finite() for each in told.values()):
        raise UndecidedError("what is read of the motion is not enclosed")
    words = ", ".join(f"{name} {_bounds(value)}" for name, value in told.items())
    called = f"what this file calls {functional.about!r}, unchecked"
    return f" Over this motion, of {_bounds(period)} s, {called}, is: {words}."


def _row(motion: BallMotion, row: tuple[float, ...]) -> arb_mat:
    return arb_mat([[real(exact(each)) * unit for each, unit in zip(row, motion.units, strict=True)]])


def _pieces(motion: BallMotion, over: Followed, rows: list[arb_mat]) -> Iterator[Piece]:
    for number, (segment, told) in enumerate(zip(motion.segments, motion.course.segments, strict=True)):
        if not takes_time(motion, number):
            continue
        steps = steps_over(motion, number, over)
        both = rows[told.mode], rows[told.mode] * segment.flow * steps.duration
        for z in steps.begun[:-1]:
            columns, off = steps.taylor(segment.flow, z, steps.duration, TERMS)
            value, slope = (arb_poly([(row * each)[0, 0] for each in columns]) for row in both)
            offs = ((moduli(row) * off)[0, 0].upper() for row in both)
            yield Piece(steps.duration, value, slope, *map(arb, offs))


def _bounds(value: arb) -> str:
    return between(arb(value.lower()), arb(value.upper()), DIGITS)


def _root(square: arb) -> arb:
    """Enclose the root of what is not negative."""
    return hull(arb(square.lower()).max(arb(0)).sqrt(), arb(square.upper()).max(arb(0)).sqrt())
