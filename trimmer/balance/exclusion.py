"""Boxes that hold no solution of N + 1/G = 0, because disks that hold N and -1/G lie apart.

A search begins with a grid, less such boxes. The grid has the rows of a table of N, and columns. The columns
begin as the blocks of the table; those that may hold a solution are cut until 1/G changes little on each.
"""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

from trimmer.arrays import ArrayRecord, Flags, Places, Reals
from trimmer.balance.cells import Cells
from trimmer.balance.element_curve import ElementCurve, GainDisks, GainTable
from trimmer.balance.inverse_response import Enclosure, InverseGain
from trimmer.balance.vanishing import EmptyInterval


@dataclass(frozen=True)
class EquationInBox:
    """N(u, x) + 1/G(x) = 0 on the box of a table of N."""

    response: InverseGain  # 1/G, or the function that takes its place
    curve: ElementCurve  # N
    table: GainTable  # N on a coarse grid
    smallest_gain: float  # Solutions with |N| below this are not looked for
    # Intervals of x, each between two breaks of the table, that are proven to hold no solution
    empty: tuple[EmptyInterval, ...] = ()


@dataclass(frozen=True)
class EnclosedCells(ArrayRecord):
    """Boxes with disks that hold N and bounds of 1/G on them, one entry per box."""

    cells: Cells
    disks: GainDisks
    enclosure: Enclosure

    @classmethod
    def of(cls, response: InverseGain, curve: ElementCurve, cells: Cells) -> EnclosedCells:
        """Enclose N and 1/G on boxes."""
        return cls(cells, curve.disks(cells), response.enclose(cells.x_lower, cells.x_upper))

    def refined(self, curve: ElementCurve) -> EnclosedCells:
        """Replace the disks, which hold N on larger boxes, by those of the boxes themselves."""
        return EnclosedCells(self.cells, curve.disks(self.cells), self.enclosure)

    def open(self, smallest_gain: float) -> EnclosedCells:
        """Return the boxes that may hold a solution with |N| of at least ``smallest_gain``."""
        sizes, radius = np.abs(self.disks.centre), self.disks.radius
        smallest = np.maximum(sizes - radius, smallest_gain)
        possible = disks_meet(self.disks, self.enclosure)
        which = np.flatnonzero(possible & sizes_meet(self.enclosure, smallest, sizes + radius))
        return self[which]


def disks_meet(disks: GainDisks, enclosure: Enclosure) -> Flags:
    """Return whether N and -1/G can be equal, given disks that hold them; any shapes that broadcast."""
    apart = disks.centre + enclosure.centre
    reach = disks.radius + enclosure.radius
    return np.asarray(disks.exists & ~(apart.real**2 + apart.imag**2 > reach**2))


def sizes_meet(enclosure: Enclosure, smallest: Reals | float, largest: Reals | float) -> Flags:
    """Return whether |1/G| can be between the smallest and the largest |N|; shapes broadcast."""
    # In this form it is true where a bound of 1/G is missing (NaN).
    return ~((enclosure.smallest > largest) | (enclosure.largest < smallest))


_SPREAD = 0.05  # Relative change of 1/G below which a column is narrow enough

_MOST_PARTS = 32  # Into how many parts a column is cut at most

_MOST_COLUMNS = 50_000  # Number of columns above which none is cut; what is left of them is undecided then

NARROWEST = 1e-12  # Half width in x below which nothing is cut: there a zero and a pole on the axis cancel


@dataclass(frozen=True)
class _Columns(ArrayRecord):
    """Intervals of x, with 1/G on them and the number of the block that each is a part of."""

    lower: Reals
    upper: Reals
    enclosure: Enclosure
    block: Places

    @property
    def parts(self) -> Places:
        """Into how many parts to cut each; 1 where 1/G changes little on it."""
        excess = np.log1p(self.enclosure.radius / np.abs(self.enclosure.centre)) / _SPREAD
        parts = np.fmax(np.fmin(np.ceil(excess), _MOST_PARTS), 1.0)
        if self.lower.size > _MOST_COLUMNS:
            parts[:] = 1.0
        parts[self.upper - self.lower <= 2.0 * NARROWEST] = 1.0
        return parts.astype(int)


def first_grid(equation: EquationInBox) -> tuple[EnclosedCells, int]:
    """Return the boxes of the grid that may hold a solution, and the number of boxes that were compared."""
    breaks = equation.table.x_breaks
    blocks = _blocks(equation)
    columns = _columns(equation, breaks[blocks], breaks[blocks + 1], blocks)
    size = 0
    while True:
        possible = _possible(equation, columns)
        size += possible.size
        parts = np.where(possible.any(axis=0), columns.parts, 0)
        if (parts <= 1).all():
            break
        columns = _cut(equation, columns, parts)
    boxes = _boxes(equation, columns, possible)
    if equation.curve.depends_on_x:
        boxes = boxes.refined(equation.curve).open(equation.smallest_gain)
    return boxes, size


def _blocks(equation: EquationInBox) -> Places:
    """Blocks of the table that do not lie in an interval without a solution."""
    lower, upper = equation.table.x_breaks[:-1], equation.table.x_breaks[1:]
    left = np.ones(lower.size, dtype=bool)
    for interval in equation.empty:
        left &= (lower < interval.lower) | (upper > interval.upper)
    return np.flatnonzero(left)


def _columns(equation: EquationInBox, lower: Reals, upper: Reals, block: Places) -> _Columns:
    """Enclose 1/G on columns, and keep those on which it is of the size of N."""
    enclosure = equation.response.enclose(lower, upper)
    smallest = max(equation.smallest_gain, equation.table.smallest_gain)
    which = np.flatnonzero(sizes_meet(enclosure, smallest, equation.table.largest_gain))
    return _Columns(lower, upper, enclosure, block)[which]


def _possible(equation: EquationInBox, columns: _Columns) -> Flags:
    """Whether each row (first axis) of each column may hold a solution."""
    return disks_meet(equation.table.rows_at(columns.block), columns.enclosure)


def _boxes(equation: EquationInBox, columns: _Columns, which: Flags) -> EnclosedCells:
    """Boxes on some rows of some columns."""
    row, column = np.nonzero(which)
    table, chosen = equation.table, columns[column]
    cells = table.cells(row, chosen.lower, chosen.upper)
    return EnclosedCells(cells, table.disks_at(row, chosen.block), chosen.enclosure)


def _cut(equation: EquationInBox, columns: _Columns, parts: Places) -> _Columns:
    """Cut each column into a number of equal parts; none are left of those with 0."""
    width = np.repeat(columns.upper - columns.lower, parts) / np.repeat(parts, parts)
    place = np.arange(width.size) - np.repeat(np.cumsum(parts) - parts, parts)
    lower = np.repeat(columns.lower, parts) + place * width
    return _columns(equation, lower, lower + width, np.repeat(columns.block, parts))
