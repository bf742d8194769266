"""What is read of a motion: extremes, mean and mean square of functionals, values before events, zeros.

Over each piece a functional is Taylor's polynomial with an error. Its square is integrated as a polynomial.
Its extremes are at the ends of what its slope says is monotone; elsewhere a piece is halved until the slope
leaves nothing to tell.
"""

from __future__ import annotations

import functools
from collections.abc import Callable, Sequence
from dataclasses import dataclass, replace

from flint import arb, arb_mat, arb_poly

from trimmer.proof.balls import about, between, hull, roots_between
from trimmer.proof.following import BallMotion, Followed, moduli
from trimmer.proof.outcome import UndecidedError, require_time
from trimmer.proof.pieces import Piece, pieces
from trimmer.proof.statement import Functional

DIGITS = 15  # Of what is told
FINE = 2.0**-56  # Share of the terms of a functional below which nothing is left to tell of an extreme
Along = Callable[[arb], tuple[arb, arb]]  # A functional and its slope over a piece, by the share of it


def readings(
    motion: BallMotion,
    over: Followed,
    functionals: Sequence[Functional],
    levels: Sequence[Functional] = (),
    free: tuple[int, ...] = (),
) -> str:
    """Hold a motion piece by piece against its equations; say what is read of it on the way.

    Args:
        motion: The motion.
        over: It from a ball of starts.
        functionals: Of these extremes, means, and values before events are told.
        levels: Of these when they are zero.
        free: Event functions that may fall to zero.
    """
    read = [Reading.of(motion, each, _by_mode(motion, each)) for each in functionals]
    rows = [_by_mode(motion, each) for each in levels]
    zeros: list[list[arb]] = [[] for _ in levels]
    for piece in pieces(motion, over, free):
        read = [each.with_piece(motion, piece) for each in read]
        for own, found in zip(rows, zeros, strict=True):
            roots = roots_between(_along(motion, piece, own)[0], arb(0), arb(1))
            found += sorted((piece.begun + each * piece.duration for each in roots), key=float)
    told = [each.told(motion, over) for each in read]
    for level, found in zip(levels, zeros, strict=True):
        instants = " and ".join(f"{bounds(each)} s" for each in found) or "no instant"
        told.append(f" What this file calls {level.about!r}, unchecked, is zero at {instants}.")
    return "".join(told)


def smallest(motion: BallMotion, over: Followed, function: int, free: tuple[int, ...]) -> arb:
    """Enclose the smallest value of an event function of a motion without events, as a share of its terms.

    Event functions are held positive but for those that are left free.
    """
    row = arb_mat([motion.segments[0].functions.tolist()[function]])
    read = Reading.of(motion, Functional("", (), ()), [row] * len(motion.tables.flows))
    for piece in pieces(motion, over, free):
        read = read.with_piece(motion, piece)
    return read.extremes[0] * FINE / read.fine


@dataclass(frozen=True)
class Reading:
    """What was read of a functional so far."""

    functional: Functional  # As the file says it
    rows: list[arb_mat]  # It by Z, in the units, of each mode
    fine: arb  # What is fine enough of an extreme
    extremes: tuple[arb, arb]  # Its smallest and its largest value
    integrals: tuple[arb, arb]  # Of it and of its square
    passed: arb  # How long it was read, s

    @classmethod
    def of(cls, motion: BallMotion, functional: Functional, rows: list[arb_mat]) -> Reading:
        """Begin to read."""
        sizes = arb_mat([[each] for each in motion.sizes])
        largest = functools.reduce(arb.max, ((moduli(row) * sizes)[0, 0] for row in rows))
        none = arb("inf"), arb("-inf")
        return cls(functional, rows, FINE * largest.lower(), none, (arb(0), arb(0)), arb(0))

    def with_piece(self, motion: BallMotion, piece: Piece) -> Reading:
        """Read on."""
        along, polynomial, off = _along(motion, piece, self.rows)
        size = sum(map(abs, polynomial.coeffs()), arb(0))
        once, twice = (each.integral()(arb(1)) for each in (polynomial, polynomial * polynomial))
        integrals = (
            self.integrals[0] + piece.duration * (once + about(off)),
            self.integrals[1] + piece.duration * (twice + about(off * (2 * size + off))),
        )
        passed = self.passed + piece.duration
        return replace(self, extremes=self._extremes(along), integrals=integrals, passed=passed)

    def _extremes(self, along: Along) -> tuple[arb, arb]:
        """Enclose the extremes over a piece and of what came before, to what is fine enough."""
        waiting = [(0.0, 1.0)]
        lowest, highest = _widened(self.extremes, [along(each)[0] for each in (arb(0), arb(1))])
        while waiting:
            require_time()
            first, last = waiting.pop()
            half, slope = 0.5 * (last - first), along(hull(first, last))[1]
            middle, reach = along(arb(first + half))[0], (abs(slope) * half).upper()
            if middle - reach > lowest and middle + reach < highest:
                continue
            seen = [middle]
            if not slope.contains(0):
                seen += [along(arb(each))[0] for each in (first, last)]
            elif reach <= self.fine:
                seen.append(middle + about(reach))
            elif half < 2.0**-50:
                raise UndecidedError("an extreme of what is read is not enclosed")
            else:
                waiting += [(first, first + half), (first + half, last)]
            lowest, highest = _widened((lowest, highest), seen)
        return lowest, highest

    def told(self, motion: BallMotion, over: Followed) -> str:
        """Say it."""
        course, (lowest, highest) = motion.course.segments, self.extremes
        mean, square = (each / self.passed for each in self.integrals)
        last = len(course) - 1
        places = {k: "at the end" if k == last else f"before event {k + 1}" for k in self.functional.before}
        found = {
            "smallest": lowest,
            "largest": highest,
            "peak to peak": highest - lowest,
            "integral": self.integrals[0],
            "mean": mean,
            "root mean square": _root(square),
            "about the mean": _root(square - mean * mean),
            **{called: (self.rows[course[k].mode] * over.ends[k])[0, 0] for k, called in places.items()},
        }
        if not all(each.is_finite() for each in found.values()):
            raise UndecidedError("what is read of the motion is not enclosed")
        # How wide balls are is no result.
        seen = {name: about(self.fine) if abs(each) < self.fine else each for name, each in found.items()}
        words = ", ".join(f"{name} {bounds(value)}" for name, value in seen.items())
        called = f"what this file calls {self.functional.about!r}, unchecked"
        return f" Over this motion, of {bounds(self.passed)} s, {called}, is: {words}."


def _by_mode(motion: BallMotion, functional: Functional) -> list[arb_mat]:
    return [motion.rows((each,)) for each in functional.rows]


def _along(motion: BallMotion, piece: Piece, rows: list[arb_mat]) -> tuple[Along, arb_poly, arb]:
    """Return a functional with its slope over a piece, and its polynomial with the error of that."""
    segment = motion.segments[piece.number]
    flow, row = segment.flow, rows[segment.told.mode]
    (value, off), (slope, slope_off) = piece.of(row)[0], piece.of(row * flow * piece.duration)[0]
    return lambda share: (value(share) + about(off), slope(share) + about(slope_off)), value, off


def _widened(extremes: tuple[arb, arb], values: list[arb]) -> tuple[arb, arb]:
    return functools.reduce(arb.min, values, extremes[0]), functools.reduce(arb.max, values, extremes[1])


def bounds(value: arb) -> str:
    """Say a ball."""
    return between(arb(value.lower()), arb(value.upper()), DIGITS)


def _root(square: arb) -> arb:
    """Enclose the root of what is not negative."""
    return hull(arb(square.lower()).max(arb(0)).sqrt(), arb(square.upper()).max(arb(0)).sqrt())
