"""Winding number of F = N + 1/G about zero along the border of a region of amplitude and frequency.

By the theory of the degree it is the sum, over the solutions inside, of the signs of the Jacobian
determinant. With the border run so that the region lies to the left in the plane of ln A and ln omega, a
solution counts +1 where Loeb's criterion holds and -1 where it does not. So it is a check of a list of
limit cycles that uses none of the steps that found them.

The border is cut until a disk that holds F on a piece is seen from zero within 90 degrees. Then the phase
changes by less than that along the piece, and the values at its two ends determine the change.
"""

from __future__ import annotations

import math
from dataclasses import dataclass
from typing import TYPE_CHECKING, Self

import numpy as np

from trimmer.balance.cells import Cells

if TYPE_CHECKING:
    from trimmer.arrays import Flags, Reals
    from trimmer.balance.element_curve import ElementCurve
    from trimmer.balance.inverse_response import InverseResponse
    from trimmer.balance.loop import LoopEquation


_INSIDE = 1.0 - 1e-13
"""Where the border runs, over the largest u."""

_PARTS_OF_U = 16
"""Equal parts of a border of constant frequency to begin with."""

_MOST_PIECES = 20_000
"""Number of pieces at one level above which the search is given up."""

_MOST_LEVELS = 100

_NARROWEST = math.sin(math.pi / 4)
"""Radius over distance from zero of a disk that is seen within 90 degrees."""

_ROUNDING = 1e-13
"""More than the rounding error of F over its terms."""


@dataclass(frozen=True)
class _Pieces:
    """Pieces of the border between two points each, given as x and as u over the largest one at that x."""

    v_start: Reals
    v_end: Reals
    x_start: Reals
    x_end: Reals

    @classmethod
    def joined(cls, groups: list[_Pieces]) -> Self:
        """Concatenate the pieces of several groups."""
        return cls(
            np.concatenate([group.v_start for group in groups]),
            np.concatenate([group.v_end for group in groups]),
            np.concatenate([group.x_start for group in groups]),
            np.concatenate([group.x_end for group in groups]),
        )

    def take(self, which: Flags) -> _Pieces:
        """Return the pieces that are flagged."""
        return _Pieces(self.v_start[which], self.v_end[which], self.x_start[which], self.x_end[which])

    def halves(self, which: Flags) -> _Pieces:
        """Return both halves of the pieces that are flagged: all first halves, then all second ones."""
        v, x = 0.5 * (self.v_start + self.v_end)[which], 0.5 * (self.x_start + self.x_end)[which]
        return _Pieces(
            np.concatenate([self.v_start[which], v]),
            np.concatenate([v, self.v_end[which]]),
            np.concatenate([self.x_start[which], x]),
            np.concatenate([x, self.x_end[which]]),
        )


def winding_number(loop: LoopEquation, omegas: tuple[float, float]) -> int | None:
    """Count the turns of N + 1/G along the border of all amplitudes and a range of frequencies.

    Args:
        loop: N, which is bounded or proportional to u, and 1/G.
        omegas: Lowest and highest angular frequency, rad/s.

    Returns:
        Number of turns; None if a solution, or a zero of G, is too near to the border to count them.
    """
    with np.errstate(all="ignore"):
        pieces = _border(loop.response, math.log(omegas[0]), math.log(omegas[1]))
        largest_u = _largest_u(loop, pieces)
        if largest_u is None:
            return None
        narrow_pieces = []
        for _ in range(_MOST_LEVELS):
            narrow = _is_seen_narrowly(loop, pieces, largest_u)
            narrow_pieces.append(pieces.take(narrow))
            if narrow.all():
                return _turns(loop, _Pieces.joined(narrow_pieces), largest_u)
            pieces = pieces.halves(~narrow)
            if pieces.x_start.size > _MOST_PIECES:
                break
    return None


def _turns(loop: LoopEquation, pieces: _Pieces, largest_u: float) -> int | None:
    """Add the changes of the phase of F from end to end of all pieces."""
    v, x = np.concatenate([pieces.v_start, pieces.v_end]), np.concatenate([pieces.x_start, pieces.x_end])
    residual = loop.curve.value(_u(loop.curve, v, x, largest_u), x) + loop.response.value(x)
    start, end = np.split(residual, 2)
    angle = float(np.angle(end / start).sum())
    return round(angle / (2.0 * math.pi)) if math.isfinite(angle) else None


def _largest_u(loop: LoopEquation, pieces: _Pieces) -> float | None:
    """Find u beyond which an N proportional to u exceeds 1/G everywhere; None if there is none."""
    if np.isfinite(loop.curve.edge(pieces.x_start)).all():
        return math.inf
    largest = 0.0
    for _ in range(_MOST_LEVELS):
        enclosure = loop.response.enclose(
            np.minimum(pieces.x_start, pieces.x_end), np.maximum(pieces.x_start, pieces.x_end)
        )
        fine = enclosure.radius <= np.abs(enclosure.centre)
        largest = max(largest, float(enclosure.largest[fine].max(initial=0.0)))
        pieces = pieces.halves(~fine)
        if pieces.x_start.size == 0:
            slope = loop.curve.value(np.ones(1), np.zeros(1))
            return 2.0 * largest / float(np.abs(slope[0]))
        if pieces.x_start.size > _MOST_PIECES:  # pieces at a zero of G are never fine, and double each time
            break
    return None


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


def _u(curve: ElementCurve, v: Reals, x: Reals, largest_u: float) -> Reals:
    return np.asarray(v * np.minimum(curve.edge(x), largest_u) * _INSIDE)


def _is_seen_narrowly(loop: LoopEquation, pieces: _Pieces, largest_u: float) -> Flags:
    """Return whether a disk that holds F on the box round each piece is seen from zero within 90 degrees."""
    u_start = _u(loop.curve, pieces.v_start, pieces.x_start, largest_u)
    u_end = _u(loop.curve, pieces.v_end, pieces.x_end, largest_u)
    cells = Cells(
        np.minimum(u_start, u_end),
        np.maximum(u_start, u_end),
        np.minimum(pieces.x_start, pieces.x_end),
        np.maximum(pieces.x_start, pieces.x_end),
    )
    disks = loop.curve.disks(cells)
    enclosure = loop.response.enclose(cells.x_lower, cells.x_upper)
    distance = np.abs(disks.centre + enclosure.centre)
    rounding = _ROUNDING * (np.abs(disks.centre) + np.abs(enclosure.centre))
    return np.asarray(disks.radius + enclosure.radius + rounding < _NARROWEST * distance)
