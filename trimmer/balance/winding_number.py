"""Winding number of F = N + 1/G about zero along the border of a region of amplitude and frequency.

By the theory of the degree it is the sum, over the solutions inside, of the signs of the Jacobian
determinant. With the border run so that the region lies to the left in the plane of ln A and ln omega, a
solution counts +1 where Loeb's criterion holds and -1 where it does not. So it is a check of a list of
limit cycles that uses none of the steps that found them, nor the range in which they were searched: that of
the check has its own source, the coefficients of G (``trimmer.balance.rational``).

The border is cut until a disk that holds F on a piece is seen from zero within 90 degrees. Then the phase
changes by less than that along the piece, and the values at its two ends determine the change. With N = c u
all of F is c u at large u and 1/G at u = 0, so that the phase of 1/G alone decides, which does not overflow.
Next to a root of G on the axis that phase jumps; a strip about it is left out, in which the search leaves out
what it finds too.
"""

from __future__ import annotations

import math
from dataclasses import dataclass, replace

import numpy as np

from trimmer.arrays import ArrayRecord, Flags, Reals
from trimmer.balance.cells import Cells
from trimmer.balance.element_curve import ElementCurve
from trimmer.balance.exclusion import EnclosedCells
from trimmer.balance.inverse_response import InverseResponse
from trimmer.balance.loop import LoopEquation

_INSIDE = 1.0 - 1e-13  # Where the border runs, over the largest u

_PARTS_OF_U = 16  # Equal parts of a border of constant frequency to begin with

_MOST_PIECES = 20_000  # Number of pieces at one level above which the search is given up

_MOST_LEVELS = 100

_NARROWEST = math.sin(math.pi / 4)  # Radius over distance from zero of a disk that is seen within 90 degrees

_ROUNDING = 1e-13  # More than the rounding error of F over its terms


@dataclass(frozen=True)
class _Pieces(ArrayRecord):
    """Pieces of the border between two points each, given as x and as u over the largest one at that x."""

    v_start: Reals
    v_end: Reals
    x_start: Reals
    x_end: Reals

    def halves(self, which: Flags) -> _Pieces:
        """Return both halves of the pieces that are flagged: all first halves, then all second ones."""
        whole = self[which]
        v, x = 0.5 * (whole.v_start + whole.v_end), 0.5 * (whole.x_start + whole.x_end)
        return _Pieces.joined([replace(whole, v_end=v, x_end=x), replace(whole, v_start=v, x_start=x)])


def winding_number(loop: LoopEquation, omegas: tuple[float, float]) -> int | None:
    """Count the turns of N + 1/G along the border of all amplitudes and a range of frequencies, rad/s.

    N is bounded or proportional to u. None if a solution, or a zero of G, is too near to the border.
    """
    with np.errstate(all="ignore"):
        x_lower, x_upper = math.log(omegas[0]), math.log(omegas[1])
        if math.isinf(loop.curve.edge(np.zeros(1)).item()):
            return _turns_with_strips_left_out(loop, x_lower, x_upper)
        pieces = _border(loop.response, x_lower, x_upper)
        narrow_pieces = []
        for _ in range(_MOST_LEVELS):
            narrow = _is_seen_narrowly(loop, pieces)
            narrow_pieces.append(pieces[narrow])
            if narrow.all():
                return _turns(loop, _Pieces.joined(narrow_pieces))
            pieces = pieces.halves(~narrow)
            if pieces.x_start.size > _MOST_PIECES:
                break
    return None


def _turns(loop: LoopEquation, pieces: _Pieces) -> int | None:
    """Add the changes of the phase of F from end to end of all pieces."""
    v, x = np.concatenate([pieces.v_start, pieces.v_end]), np.concatenate([pieces.x_start, pieces.x_end])
    residual = loop.curve.value(_u(loop.curve, v, x), x) + loop.response.value(x)
    start, end = np.split(residual, 2)
    angle = float(np.angle(end / start).sum())
    return round(angle / (2.0 * math.pi)) if math.isfinite(angle) else None


_STRIP = 6e-9  # Half of the width in x of what is left out about a root of G on the axis


def _turns_with_strips_left_out(loop: LoopEquation, x_lower: float, x_upper: float) -> int | None:
    """Count the turns where N is proportional to u, and infinite u is on the border."""
    response = loop.response
    heights = response.roots.imag[(response.roots.real == 0) & (response.roots.imag > 0)]
    places = np.unique(np.log(heights * response.reference))
    starts, ends = (np.clip(places + side * _STRIP, x_lower, x_upper) for side in (1.0, -1.0))
    direction = complex(loop.curve.value(np.ones(1), np.zeros(1))[0])
    total = 0
    for lower, upper in zip([x_lower, *starts], [*ends, x_upper], strict=True):
        turns = _turns_between(response, direction, lower, upper) if lower < upper else 0
        if turns is None:
            return None
        total += turns
    return total


def _turns_between(
    response: InverseResponse, direction: complex, x_lower: float, x_upper: float
) -> int | None:
    """Count the turns along the border of all u and a range of x without a root on the axis.

    Going round, the phase of F over that of N goes from 0, at infinite u, to that of 1/G over it at the
    lowest x, follows that to the highest x, and returns to 0.
    """
    x = response.breaks(x_lower, x_upper)
    lower, upper = x[:-1], x[1:]
    angle = 0.0
    for _ in range(_MOST_LEVELS):
        fine = response.turning(lower, upper).spread < 0.5 * math.pi
        start, end = response.direction(lower[fine]), response.direction(upper[fine])
        angle += float(np.angle(end / start).sum())
        lower, upper = lower[~fine], upper[~fine]
        if not lower.size:
            break
        middle = 0.5 * (lower + upper)
        lower, upper = np.concatenate([lower, middle]), np.concatenate([middle, upper])
        if lower.size > _MOST_PIECES:
            return None
    corners = response.direction(np.array([x_lower, x_upper])) / direction
    off = np.abs(np.angle(-corners))
    if lower.size or not off.min() > response.allowance + _ROUNDING * (1 + response.roots.size):
        return None
    first, last = np.angle(corners)
    return round((float(first) + angle - float(last)) / (2.0 * math.pi))


def _border(response: InverseResponse, x_lower: float, x_upper: float) -> _Pieces:
    """Cut the border; it rises along the lowest frequency in A, hence falls in u."""
    x = response.breaks(x_lower, x_upper)
    v = np.linspace(0.0, 1.0, _PARTS_OF_U + 1)
    corners = (
        (v[::-1], np.full(v.size, x_lower)),
        (np.zeros(x.size), x),
        (v, np.full(v.size, x_upper)),
        (np.ones(x.size), x[::-1]),
    )
    return _Pieces(
        np.concatenate([v[:-1] for v, _ in corners]),
        np.concatenate([v[1:] for v, _ in corners]),
        np.concatenate([x[:-1] for _, x in corners]),
        np.concatenate([x[1:] for _, x in corners]),
    )


def _u(curve: ElementCurve, v: Reals, x: Reals) -> Reals:
    return np.asarray(v * curve.edge(x) * _INSIDE)


def _is_seen_narrowly(loop: LoopEquation, pieces: _Pieces) -> Flags:
    """Return whether a disk that holds F on the box round each piece is seen from zero within 90 degrees."""
    u_start = _u(loop.curve, pieces.v_start, pieces.x_start)
    u_end = _u(loop.curve, pieces.v_end, pieces.x_end)
    cells = Cells(
        np.minimum(u_start, u_end),
        np.maximum(u_start, u_end),
        np.minimum(pieces.x_start, pieces.x_end),
        np.maximum(pieces.x_start, pieces.x_end),
    )
    known = EnclosedCells.of(loop.response, loop.curve, cells)
    disks, enclosure = known.disks, known.enclosure
    distance = np.abs(disks.centre + enclosure.centre)
    rounding = _ROUNDING * (np.abs(disks.centre) + np.abs(enclosure.centre))
    return np.asarray(disks.radius + enclosure.radius + rounding < _NARROWEST * distance)
