"""What the slopes of F = N + 1/G prove about boxes: that they hold no solution, or at most one.

Between two points of a box F changes by p du + q dx, where p and q lie in disks that hold dF/du and dF/dx on
the box. So F differs at any two points, and there is at most one solution, if no choice from the two disks is
a pair of parallel vectors of the plane. And F vanishes nowhere on the box if the parallelogram of its
linear part about the middle stays farther from 0 than the disks allow it to be off.

The radii of the disks are proven bounds: those of 1/G follow from its zeros and poles, those of N are the
element's own (``Element.variation``).
Newton's method finds the solution of a box that holds at most one.
"""

from dataclasses import dataclass

import numpy as np

from trimmer.arrays import Complexes, Flags, Reals
from trimmer.balance.cells import Cells
from trimmer.balance.element_curve import ElementCurve
from trimmer.balance.inverse_response import InverseGain, Sloped


@dataclass(frozen=True)
class CellTest:
    """Result of the tests of n boxes, shapes (n,); nothing is proven of a box that leaves the domain of N."""

    empty: Flags  # Whether the box is proven to hold no solution
    single: Flags  # Whether its region is proven to hold at most one
    u: Reals  # Where the linear part puts the solution, its u; within the region
    x: Reals  # Its x


def examine(response: InverseGain, curve: ElementCurve, cells: Cells, regions: Cells) -> CellTest:
    """Test n boxes for emptiness, and a wider region around each for at most one solution."""
    u, x = regions.u_centre, regions.x_centre
    enclosure = response.enclose(regions.x_lower, regions.x_upper)
    gain, by_u, gain_by_x = curve.expansion(u, x)
    u_radius, x_radius = curve.variation(regions)
    by_x = enclosure.slope + gain_by_x
    excess = gain + enclosure.centre
    x_radius = x_radius + enclosure.slope_radius
    across = cross(by_u, by_x)
    parallel = u_radius * np.abs(by_x) + x_radius * np.abs(by_u) + u_radius * x_radius
    u_reach = np.maximum(cells.u_upper - u, u - cells.u_lower)
    x_reach = np.maximum(cells.x_upper - x, x - cells.x_lower)
    off = u_radius * u_reach + x_radius * x_reach
    along_u, along_x = cross(by_u, excess), cross(excess, by_x)
    beside = np.abs(along_u) > np.abs(across) * x_reach + np.abs(by_u) * off
    beside |= np.abs(along_x) > np.abs(across) * u_reach + np.abs(by_x) * off
    inside = curve.inside(regions)
    return CellTest(
        inside & beside,
        inside & (np.abs(across) > parallel),
        np.minimum(np.maximum(u - along_x / across, regions.u_lower), regions.u_upper),
        np.minimum(np.maximum(x - along_u / across, regions.x_lower), regions.x_upper),
    )


def cross(first: Complexes, second: Complexes) -> Reals:
    """Return the cross product of complex numbers as vectors of the plane; shapes broadcast."""
    return np.asarray(first.real * second.imag - first.imag * second.real)


_STEPS = 12

_CONVERGED = 5e-8
"""Step, relative to u and as change of x, after which the next would be of the size of rounding."""


def solve_in(
    response: InverseGain, curve: ElementCurve, boxes: Cells, u: Reals, x: Reals
) -> tuple[Reals, Reals, Flags]:
    """Solve N + 1/G = 0 by Newton's method from u and x, (n,), in each of n boxes; say which converged.

    It stops early for boxes that hold the solution of another one, as the only solution they can hold is
    then known.
    """
    for _ in range(_STEPS):
        u_step, x_step = newton_step(response, curve, u, x)
        u, x = u + u_step, x + x_step
        inside = boxes.contains(u, x)
        converged = (np.abs(u_step) <= _CONVERGED * u) & (np.abs(x_step) <= _CONVERGED)
        solved = converged & inside
        left = inside & ~solved
        if solved.any():
            left[left] = ~boxes[left].hold(u[solved], x[solved]).any(axis=1)
        if not left.any():
            break
    gain, _, _ = curve.expansion(u, x)
    # At the very edge of its domain N is no number.
    return u, x, solved & np.isfinite(gain)


def newton_step(response: Sloped, curve: ElementCurve, u: Reals, x: Reals) -> tuple[Reals, Reals]:
    """Return the step in u and in x of Newton's method for the real and imaginary part of N + 1/G."""
    inverse, slope = response.value_and_slope(x)
    gain, by_u, gain_by_x = curve.expansion(u, x)
    by_x = slope + gain_by_x
    excess = gain + inverse
    determinant = cross(by_u, by_x)
    return -cross(excess, by_x) / determinant, -cross(by_u, excess) / determinant
