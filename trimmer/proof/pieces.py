"""A motion in pieces without events; over each Z is Taylor's polynomial with an error."""

from __future__ import annotations

import functools
import math
from collections.abc import Iterator
from dataclasses import dataclass

from flint import arb, arb_mat, arb_poly

from trimmer.proof.balls import hull
from trimmer.proof.following import BY_LAW, BallMotion, Followed, Segment, block, moduli
from trimmer.proof.outcome import RefutedError, UndecidedError, require_time

TERMS = 30  # Of Taylor's polynomials over a step
REACHED, LEAST = 4.0, 1e-5
"""How often the largest modulus of a state a size may be; share of all sizes below which it may be any."""


@dataclass(frozen=True)
class Piece:
    """A step over a part of a segment."""

    number: int  # Of the segment
    begun: arb  # When it begins, s from the start of the motion
    duration: arb  # How long it is, s; negative for one that is followed backwards
    terms: arb_mat  # Those of Z by powers of the share of it, 0 to 1, (N, terms)
    off: arb_mat  # How far their sum may be off, (N, 1)

    def of(self, rows: arb_mat) -> list[tuple[arb_poly, arb]]:
        """Return functionals (m, N) as polynomials, each with its largest error."""
        if not rows.nrows():
            return []
        errors = (moduli(rows) * self.off).entries()
        return [(arb_poly(row), off) for row, off in zip((rows * self.terms).tolist(), errors, strict=True)]


def pieces(motion: BallMotion, over: Followed, free: tuple[int, ...]) -> Iterator[Piece]:
    """Yield a motion piece by piece; hold event functions and sizes against each.

    No event function but the one that ends a segment comes to zero, but for what is zero at its start by law,
    and for those that are left free.
    """
    before = 0.0
    largest, begun = [arb(0)] * motion.n, arb(0)
    for number, segment in enumerate(motion.segments):
        end, late, told = over.ends[number], over.lates[number], segment.told
        _require_demands(segment, end, f"at the end of segment {number}")
        at_once = told.at == before and told.duration == 0  # A clock does two things at one time.
        before = math.nan if told.at is None else told.at
        if not at_once:
            if not segment.duration + late > 0:
                raise RefutedError(f"segment {number} ends before it begins")
            falling = () if told.fired is None else (told.fired, *_together(motion, number))
            plain = block(segment.step, motion.count)
            z, length = over.starts[number], segment.duration / segment.count
            for place in range(segment.count):
                require_time()
                last = place == segment.count - 1
                piece = _piece(number, segment, begun, z, length + late if last else length)
                left = (*free, *falling) if last else free
                _require_positive(motion, piece, z, {} if place else dict(told.zeros), left)
                yield piece
                largest = [each.max(abs(z[i, 0]).lower()) for i, each in enumerate(largest)]
                z, begun = plain * z, begun + piece.duration
            if falling:
                others = tuple(k for k in range(segment.functions.nrows()) if k not in falling)
                back = _piece(number, segment, begun, end, -(length + late))
                _require_positive(motion, back, end, dict.fromkeys(falling, 1), others)
        largest = [each.max(abs(end[i, 0]).lower()) for i, each in enumerate(largest)]
    for i, (reached, size) in enumerate(zip(largest, motion.sizes, strict=False)):
        sizes = motion.course.sizes
        if not (size < REACHED * reached or sizes[i] < LEAST * max(sizes)):
            raise RefutedError(f"the size {sizes[i]!r} of state {i} is none that the motion reaches")


def _piece(number: int, segment: Segment, begun: arb, z: arb_mat, duration: arb) -> Piece:
    columns, scales = [z], segment.scales
    for k in range(1, TERMS):
        columns.append(segment.flow * columns[-1] * (duration / k))
    largest = functools.reduce(arb.max, (abs(z[i, 0]) / each for i, each in enumerate(scales)))
    reach = segment.rate * abs(duration)
    off = (reach**TERMS / math.factorial(TERMS) * reach.exp() * largest).upper()
    terms = arb_mat([each.entries() for each in columns]).transpose()
    return Piece(number, begun, duration, terms, arb_mat([[each * off] for each in scales]))


def _together(motion: BallMotion, number: int) -> tuple[int, ...]:
    """Return the event functions that fall with the one that ends a segment, of which they are multiples.

    They are so for all Z at its end that what came before it lets it have.
    """
    segment, size = motion.segments[number], motion.count
    reached = block(segment.propagator, size) * segment.reset
    last = motion.segments[-1]
    if not number and last.told.at is None:  # It goes on with the last segment, or its mirror image.
        reached = reached * motion.mirror * block(last.propagator, size) * last.reset
    rows = (segment.functions * reached).tolist()
    ending = rows[segment.told.fired or 0]
    for function in segment.told.together:
        row = rows[function]
        share = sum((a * b for a, b in zip(row, ending, strict=True)), arb(0))
        share /= sum((each * each for each in ending), arb(0))
        apart = max(float(abs(a - share * b).upper()) for a, b in zip(row, ending, strict=True))
        if not (share > 0 and apart < BY_LAW * max(float(abs(each).upper()) for each in row)):
            raise UndecidedError("two event functions come to zero at one instant")
    return segment.told.together


def _require_demands(segment: Segment, end: arb_mat, where: str) -> None:
    for value in (segment.strict * end).entries() if segment.told.strict else ():
        if value < 0:
            raise RefutedError(f"a demand is beyond its limit or not, other than said, {where}")
        if not value > 0:
            raise UndecidedError(f"a demand is at its limit {where}, to balls")


def _require_positive(
    motion: BallMotion, piece: Piece, z: arb_mat, zeros: dict[int, int], left: tuple[int, ...]
) -> None:
    """Enclose event functions, but for some that are left out, over a piece that begins at Z."""
    segment = motion.segments[piece.number]
    for function, (polynomial, error) in enumerate(piece.of(segment.functions)):
        if function in left:
            continue
        called, count = f"event function {function} of segment {piece.number}", zeros.get(function, 0)
        row = arb_mat([segment.functions.tolist()[function]]) if count else segment.functions
        _require_zeros(motion, row, segment.flow, z, count, called)
        _require_above(arb_poly(polynomial.coeffs()[count:]), error, called)


def _require_zeros(
    motion: BallMotion, row: arb_mat, flow: arb_mat, z: arb_mat, zeros: int, called: str
) -> None:
    """Hold what the law of an event makes zero against the sizes of its terms."""
    sizes = arb_mat([[each] for each in motion.sizes])
    for _ in range(zeros):
        if not abs((row * z)[0, 0]) < BY_LAW * (moduli(row) * sizes)[0, 0]:
            raise UndecidedError(f"{called} is not zero where it is said to be")
        z, sizes = flow * z, moduli(flow) * sizes


def _require_above(polynomial: arb_poly, error: arb, called: str) -> None:
    """Divide the shares of a step, 0 to 1, until a polynomial is larger than its error on each."""
    waiting = [(0.0, 1.0)]
    while waiting:
        require_time()
        first, width = waiting.pop()
        value = polynomial(hull(first, first + width))
        if value < -error:
            raise RefutedError(f"{called} is negative within it")
        if value > error:
            continue
        if width < 2.0**-24:
            raise UndecidedError(f"{called} may come to zero within it: a grazing, to balls")
        waiting += [(first, 0.5 * width), (first + 0.5 * width, 0.5 * width)]
