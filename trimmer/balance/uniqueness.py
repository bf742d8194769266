"""Whether a box can hold two solutions of N + 1/G = 0, and Newton's method for the one it may hold.

For two points of a box the mean values of dN/du and of d(1/G)/dx + dN/dx between them lie in disks that hold
these derivatives on the box. If no choice from the two disks makes a pair of parallel vectors of the plane,
the sum N + 1/G differs between the two points, so that the box holds at most one solution.

The radii of the disks are proven bounds: those of 1/G follow from its zeros and poles, those of N are the
element's own (``Element.variation``).
"""

from __future__ import annotations

from typing import TYPE_CHECKING

import numpy as np

if TYPE_CHECKING:
    from numpy.typing import NDArray

    from trimmer.balance.cells import Cells
    from trimmer.balance.element_curve import ElementCurve
    from trimmer.balance.response import Response

    Reals = NDArray[np.float64]
    Complexes = NDArray[np.complex128]
    Flags = NDArray[np.bool_]

_STEPS = 12
_CONVERGED = 1e-8
"""Newton's step, relative to u and as change of x, after which the next would be of the size of rounding."""


def distinct_values(response: Response, curve: ElementCurve, boxes: Cells) -> Flags:
    """Whether N + 1/G is proven to take each value at most once in each box."""
    enclosure = response.enclose(boxes.x_lower, boxes.x_upper)
    by_u, gain_by_x = curve.slopes(boxes.u_centre, boxes.x_centre)
    u_radius, x_radius = curve.variation(boxes)
    by_x = enclosure.slope + gain_by_x
    with np.errstate(invalid="ignore", over="ignore"):
        x_radius = x_radius + enclosure.slope_radius
        slack = u_radius * np.abs(by_x) + x_radius * np.abs(by_u) + u_radius * x_radius
        return np.asarray(curve.inside(boxes) & (np.abs(_cross(by_u, by_x)) > slack))


def newton(response: Response, curve: ElementCurve, boxes: Cells) -> tuple[Reals, Reals, Flags]:
    """Solve N + 1/G = 0 from the middle of each box.

    Returns:
        u, x, and whether Newton's method converged inside the box. It stops early for boxes that hold the
        solution of another one, as the only solution they can hold is then known.
    """
    u, x = boxes.u_centre, boxes.x_centre
    with np.errstate(all="ignore"):
        for _ in range(_STEPS):
            u_step, x_step = newton_step(response, curve, u, x)
            u, x = u + u_step, x + x_step
            inside = boxes.contains(u, x)
            converged = (np.abs(u_step) <= _CONVERGED * u) & (np.abs(x_step) <= _CONVERGED)
            solved = converged & inside
            if np.all(solved | ~inside | boxes.hold_any_of(u[solved], x[solved])):
                break
    return u, x, solved


def newton_step(response: Response, curve: ElementCurve, u: Reals, x: Reals) -> tuple[Reals, Reals]:
    """One step of Newton's method for the real and imaginary part of N + 1/G."""
    inverse, slope = response.value_and_slope(x)
    by_u, gain_by_x = curve.slopes(u, x)
    by_x = slope + gain_by_x
    excess = curve.value(u, x) + inverse
    determinant = _cross(by_u, by_x)
    return -_cross(excess, by_x) / determinant, -_cross(by_u, excess) / determinant


def _cross(first: Complexes, second: Complexes) -> Reals:
    """Cross product of complex numbers as vectors of the plane."""
    return np.asarray(first.real * second.imag - first.imag * second.real)
