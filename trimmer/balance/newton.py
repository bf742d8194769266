"""Newton's method for N + 1/G = 0 in boxes that hold at most one solution."""

from __future__ import annotations

from typing import TYPE_CHECKING

import numpy as np

from trimmer.balance.cell_test import cross

if TYPE_CHECKING:
    from numpy.typing import NDArray

    from trimmer.balance.cells import Cells
    from trimmer.balance.element_curve import ElementCurve
    from trimmer.balance.response import Response

    Reals = NDArray[np.float64]
    Flags = NDArray[np.bool_]

_STEPS = 12

_CONVERGED = 5e-8
"""Step, relative to u and as change of x, after which the next would be of the size of rounding."""


def solve_in(
    response: Response, curve: ElementCurve, boxes: Cells, u: Reals, x: Reals
) -> tuple[Reals, Reals, Flags]:
    """Solve N + 1/G = 0 from a start in each box.

    Returns:
        u, x, and whether Newton's method converged inside the box. It stops early for boxes that hold the
        solution of another one, as the only solution they can hold is then known.
    """
    for _ in range(_STEPS):
        u_step, x_step = newton_step(response, curve, u, x)
        u, x = u + u_step, x + x_step
        inside = boxes.contains(u, x)
        converged = (np.abs(u_step) <= _CONVERGED * u) & (np.abs(x_step) <= _CONVERGED)
        solved = converged & inside
        left = inside & ~solved
        if solved.any():
            left[left] = ~boxes.take(left).hold(u[solved], x[solved]).any(axis=1)
        if not left.any():
            break
    return u, x, solved


def newton_step(response: Response, curve: ElementCurve, u: Reals, x: Reals) -> tuple[Reals, Reals]:
    """One step of Newton's method for the real and imaginary part of N + 1/G."""
    inverse, slope = response.value_and_slope(x)
    gain, by_u, gain_by_x = curve.expansion(u, x)
    by_x = slope + gain_by_x
    excess = gain + inverse
    determinant = cross(by_u, by_x)
    return -cross(excess, by_x) / determinant, -cross(by_u, excess) / determinant
