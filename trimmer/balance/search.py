"""All solutions of N(u, x) + 1/G(x) = 0 in a box, by exclusion, subdivision and a test of uniqueness.

A box is dropped when bounds of N and 1/G on it prove that their sum is not zero there. A box on which bounds
of the derivatives prove that no two points give the same sum holds at most one solution, and Newton's method
finds it. All others are cut into smaller ones.
"""

from dataclasses import dataclass

import numpy as np

from trimmer.arrays import ArrayRecord, Flags, Reals
from trimmer.balance.cells import Cells
from trimmer.balance.exclusion import NARROWEST, EnclosedCells, EquationInBox, first_grid
from trimmer.balance.uniqueness import examine, solve_in

_PARTS = 3  # Into how many parts a box is cut

_RESOLUTION = 1e-6
"""Radii of the disks of a box, relative to what they hold, below which it is given up as undecided."""

_RESOLUTION_AT_EDGE = 1e-13
"""The same where the edge of the domain runs through the box, so that no test of uniqueness applies to it."""

_LAST_DIGIT = 1e-15  # Half width in u, relative, below which nothing is cut

_MOST_BOXES = 10_000  # Number of boxes at one level above which all of them are given up

_MARGIN = 2.0
"""How much wider than a box the region is on which uniqueness is tested; neighbours then share a solution."""


@dataclass(frozen=True)
class SearchResult:
    """Solutions in u and x = ln omega, (n,), boxes that may hold more, and how many boxes were examined."""

    u: Reals
    x: Reals
    undecided: Cells
    examined: int


@dataclass(frozen=True)
class _Solutions(ArrayRecord):
    """Solutions, each with a region in which it is the only one."""

    u: Reals
    x: Reals
    regions: Cells


def find_all(equation: EquationInBox) -> SearchResult:
    """Find all solutions in the box that the table of an equation covers."""
    found = _Solutions(np.empty(0), np.empty(0), Cells.none())
    undecided = [Cells.none()]
    # Bounds that overflow, or are no number, exclude nothing.
    with np.errstate(all="ignore"):
        boxes, examined = first_grid(equation)
        while len(boxes):
            found, settled = _settled(equation, boxes.cells, found)
            given_up = ~settled & _hopeless(equation, boxes)
            undecided.append(boxes.cells[given_up])
            left = ~(settled | given_up)
            if not left.any():
                break
            cells = boxes.cells[left].split(_along_u(boxes)[left], _PARTS)
            examined += len(cells)
            boxes = EnclosedCells.of(equation.response, equation.curve, cells).open(equation.smallest_gain)
    return SearchResult(found.u, found.x, Cells.joined(undecided), examined)


def _hopeless(equation: EquationInBox, boxes: EnclosedCells) -> Flags:
    """Whether boxes are too small, or too many, to be cut."""
    regions = boxes.cells.inflated(_MARGIN, equation.table.box)
    resolution = np.where(equation.curve.inside(regions), _RESOLUTION, _RESOLUTION_AT_EDGE)
    sizes = np.maximum(np.abs(boxes.disks.centre), np.abs(boxes.enclosure.centre))
    radius = boxes.disks.radius + boxes.enclosure.radius
    narrow = (boxes.cells.x_half <= NARROWEST) & ~_along_u(boxes)
    exhausted = boxes.cells.u_half <= _LAST_DIGIT * boxes.cells.u_centre
    tiny = (radius <= resolution * sizes) | narrow | exhausted | np.isnan(sizes)
    return np.asarray(tiny | (len(boxes) > _MOST_BOXES))


def _along_u(boxes: EnclosedCells) -> Flags:
    """Return whether the width of each box in u adds more to its bounds than that in x."""
    u_share = boxes.disks.u_share
    return np.asarray(u_share >= boxes.disks.radius - u_share + boxes.enclosure.radius)


def _settled(equation: EquationInBox, cells: Cells, found: _Solutions) -> tuple[_Solutions, Flags]:
    """Find the solutions of cells that hold at most one; flag the cells that are decided."""
    regions = cells.inflated(_MARGIN, equation.table.box)
    test = examine(equation.response, equation.curve, cells, regions)
    settled = test.empty | cells.lie_within(found.regions)
    tried = np.flatnonzero(~settled & test.single)
    if tried.size == 0:
        return found, settled
    tried_regions = regions[tried]
    u, x, converged = solve_in(equation.response, equation.curve, tried_regions, test.u[tried], test.x[tried])
    # What lies in the region of a solution is that solution.
    place = np.arange(tried.size)
    again = tried_regions.hold(u, x) & converged[:, None] & (place[:, None] < place)
    first = converged & ~again.any(axis=0) & ~found.regions.hold(u, x).any(axis=0)
    found = _Solutions.joined([found, _Solutions(u, x, tried_regions)[first]])
    settled[tried] |= tried_regions.hold(found.u, found.x).any(axis=1)
    return found, settled | cells.lie_within(found.regions)


@dataclass(frozen=True)
class SearchedRegion:
    """Solutions in u and x, and where they were looked for."""

    method: str  # How, in words
    result: SearchResult  # Solutions and undecided boxes
    omegas: tuple[float, float]  # Range of angular frequency that was searched, rad/s
    outside_excluded: bool  # Whether it is proven that there are none outside that range
    # |N| below which none were looked for, in the unit of N; 0 if it is proven that there are none either
    smallest_gain: float
