"""All solutions of N(u, x) + 1/G(x) = 0 in a box, by exclusion, subdivision and a test of uniqueness.

A box is dropped when disks that hold N and 1/G on it prove that their sum is not zero there. A box on which
the bounds of the two derivatives prove that no two points give the same sum holds at most one solution, and
Newton's method finds it. All others are cut into smaller ones.
"""

from __future__ import annotations

from dataclasses import dataclass
from typing import TYPE_CHECKING

import numpy as np

from trimmer.balance.cells import Cells
from trimmer.balance.element_curve import GainDisks
from trimmer.balance.response import Enclosure
from trimmer.balance.uniqueness import distinct_values, newton

if TYPE_CHECKING:
    from numpy.typing import NDArray

    from trimmer.balance.element_curve import ElementCurve
    from trimmer.balance.response import Response

    Reals = NDArray[np.float64]
    Flags = NDArray[np.bool_]

FIRST_ROWS = 64
"""Intervals of u to begin with."""

_FIRST_COLUMNS = 48
"""Intervals of x to begin with."""

_FIRST_SPREAD = 0.05
"""Relative change of 1/G below which an interval of x is no longer cut before it meets u."""

_MOST_PARTS = 32
"""Into how many parts an interval of x is cut at most."""

_PARTS = 3
"""Into how many parts a box is cut."""

_NARROWEST = 1e-10
"""Width in x below which nothing is cut, whatever the bounds: a zero and a pole on the axis cancel there."""

_MARGIN = 3.0
"""How much wider than a box the region is on which uniqueness is tested; neighbours then share a solution."""


@dataclass(frozen=True)
class SearchLimits:
    """What is looked for, and when a box is given up as undecided.

    Attributes:
        smallest_gain: Solutions with |N| below this are not looked for.
        largest_gain: Upper bound of |N|.
        resolution: Radii of the disks, relative to |N|, below which a box is given up.
        boxes: Number of boxes at one level above which all of them are given up.
    """

    smallest_gain: float
    largest_gain: float
    resolution: float = 1e-6
    boxes: int = 10_000


@dataclass(frozen=True)
class SearchResult:
    """What a search has found.

    Attributes:
        u: Solutions, their u.
        x: Solutions, their x.
        undecided: Boxes that may hold any number of solutions beside those.
        examined: Number of boxes looked at.
    """

    u: Reals
    x: Reals
    undecided: Cells
    examined: int


@dataclass(frozen=True)
class Problem:
    """What is searched, as all steps need it.

    Attributes:
        response: 1/G, or what stands for it.
        curve: N.
        box: The one box that is searched.
        limits: What is looked for.
        rows: N on the ``FIRST_ROWS`` equal parts of the box in u, if N does not depend on x.
    """

    response: Response
    curve: ElementCurve
    box: Cells
    limits: SearchLimits
    rows: GainDisks | None = None


@dataclass(frozen=True)
class _Solutions:
    """Solutions, each with a region in which it is the only one."""

    u: Reals
    x: Reals
    regions: Cells


def find_all(problem: Problem) -> SearchResult:
    """Find all solutions in the box of a problem."""
    cells, disks, enclosure, examined = _first_cells(problem)
    found = _Solutions(np.empty(0), np.empty(0), Cells.none())
    undecided = [Cells.none()]
    while len(cells):
        found, settled = _settled(problem, cells, found)
        radius = disks.radius + enclosure.radius
        finest = problem.limits.resolution * np.maximum(np.abs(disks.centre), problem.limits.smallest_gain)
        hopeless = (radius <= finest) | (cells.x_half <= _NARROWEST) | (len(cells) > problem.limits.boxes)
        given_up = ~settled & hopeless
        undecided.append(cells.take(given_up))
        keep = ~(settled | given_up)
        along_u = disks.u_share >= radius - disks.u_share
        if not keep.any():
            break
        cells = cells.take(keep).split(along_u[keep], _PARTS)
        examined += len(cells)
        cells, disks, enclosure = _open_cells(problem, cells)
    return SearchResult(found.u, found.x, Cells.joined(undecided), examined)


def _first_cells(problem: Problem) -> tuple[Cells, GainDisks, Enclosure, int]:
    """Find the boxes of a first grid that may hold a solution, and give the number of all its boxes."""
    lower, upper, enclosure = _first_intervals(problem)
    breaks = np.linspace(problem.box.u_lower[0], problem.box.u_upper[0], FIRST_ROWS + 1)
    number = FIRST_ROWS * lower.size
    if problem.rows is None:
        return (*_open_cells(problem, Cells.grid(breaks, lower, upper)), number)
    every_row = problem.rows.take(np.arange(FIRST_ROWS)[:, None])
    rows, columns = np.nonzero(_may_hold_a_solution(every_row, enclosure, problem.limits))
    cells = Cells(breaks[rows], breaks[rows + 1], lower[columns], upper[columns])
    return cells, problem.rows.take(rows), enclosure.take(columns), number


def _open_cells(problem: Problem, cells: Cells) -> tuple[Cells, GainDisks, Enclosure]:
    """Drop the boxes that cannot hold a solution; enclose N and 1/G on the others."""
    disks = problem.curve.disks(cells)
    enclosure = problem.response.enclose(cells.x_lower, cells.x_upper)
    remaining = np.flatnonzero(_may_hold_a_solution(disks, enclosure, problem.limits))
    return cells.take(remaining), disks.take(remaining), enclosure.take(remaining)


def _first_intervals(problem: Problem) -> tuple[Reals, Reals, Enclosure]:
    """Intervals of x on which 1/G changes little and is of the size of N."""
    limits = problem.limits
    breaks = np.linspace(problem.box.x_lower[0], problem.box.x_upper[0], _FIRST_COLUMNS + 1)
    lower, upper = breaks[:-1], breaks[1:]
    done: list[tuple[Reals, Reals]] = []
    enclosures: list[Enclosure] = []
    while lower.size:
        enclosure = problem.response.enclose(lower, upper)
        possible = (enclosure.smallest <= limits.largest_gain) & (enclosure.largest >= limits.smallest_gain)
        with np.errstate(invalid="ignore", divide="ignore"):
            excess = np.log1p(enclosure.radius / np.abs(enclosure.centre)) / _FIRST_SPREAD
        fine = (excess <= 1.0) | (upper - lower <= 2.0 * _NARROWEST)
        chosen = np.flatnonzero(possible & fine)
        done.append((lower[chosen], upper[chosen]))
        enclosures.append(enclosure.take(chosen))
        coarse = possible & ~fine
        parts = np.fmin(np.ceil(excess[coarse]), _MOST_PARTS).astype(int)
        lower, upper = _cut(lower[coarse], upper[coarse], parts)
    lower, upper = (np.concatenate(side) for side in zip(*done, strict=True))
    return lower, upper, Enclosure.joined(enclosures)


def _cut(lower: Reals, upper: Reals, parts: NDArray[np.intp]) -> tuple[Reals, Reals]:
    """Cut each interval into a number of equal parts."""
    start, width = np.repeat(lower, parts), np.repeat((upper - lower) / parts, parts)
    place = np.arange(start.size) - np.repeat(np.cumsum(parts) - parts, parts)
    return start + place * width, start + (place + 1) * width


def _may_hold_a_solution(disks: GainDisks, enclosure: Enclosure, limits: SearchLimits) -> Flags:
    """Whether the sum of a point of one disk and a point of the other can be zero, and is looked for."""
    size = np.abs(disks.centre)
    apart = np.abs(disks.centre + enclosure.centre) > disks.radius + enclosure.radius
    too_large = enclosure.smallest > size + disks.radius
    too_small = enclosure.largest < np.maximum(size - disks.radius, limits.smallest_gain)
    return np.asarray(disks.exists & ~(apart | too_large | too_small))


def _settled(problem: Problem, cells: Cells, found: _Solutions) -> tuple[_Solutions, Flags]:
    """Find the solutions of cells that hold at most one; flag the cells of which nothing is left to know."""
    settled = cells.lie_within(found.regions)
    regions = cells.inflated(_MARGIN, problem.box)
    tried = np.flatnonzero(~settled & distinct_values(problem.response, problem.curve, regions))
    if tried.size == 0:
        return found, settled
    tried_regions = regions.take(tried)
    u, x, converged = newton(problem.response, problem.curve, tried_regions)
    for place in np.flatnonzero(converged):
        if not found.regions.contains(u[place], x[place]).any():
            found = _Solutions(
                np.append(found.u, u[place]),
                np.append(found.x, x[place]),
                Cells.joined([found.regions, tried_regions.take(np.array([place]))]),
            )
    settled[tried] |= tried_regions.hold_any_of(found.u, found.x)
    return found, settled | cells.lie_within(found.regions)
