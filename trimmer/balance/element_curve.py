"""A describing function as N(u, x), u = amplitude_scale/amplitude, x = ln omega, with bounds on boxes.

A table holds such bounds on a coarse grid: rows of u, and blocks of x if N depends on it.
"""

from dataclasses import dataclass
from functools import cached_property
from typing import Self

import numpy as np

from trimmer.arrays import ArrayRecord, Complexes, Flags, Places, Reals
from trimmer.balance.cells import Cells
from trimmer.elements.element import Element
from trimmer.elements.expansion import Expansion


@dataclass(frozen=True)
class GainDisks(ArrayRecord):
    """Disks that hold N on boxes; all arrays have the same shape, with one entry per box."""

    centre: Complexes  # Centre of the disk, in the unit of N
    radius: Reals  # Radius of the disk, in the unit of N
    u_share: Reals  # Part of the radius that comes from the width in u
    exists: Flags  # Whether the element has a describing function anywhere in the box


@dataclass(frozen=True)
class ElementCurve:
    """The describing function of an element over u and x, in the unit of output over input."""

    element: Element

    @property
    def depends_on_x(self) -> bool:
        """Whether N depends on the frequency."""
        return self.element.depends_on_frequency

    def value(self, u: Reals, x: Reals) -> Complexes:
        """Evaluate N at arrays of equal shape; NaN outside the element's domain."""
        return np.asarray(self.element.describing_function(self.amplitude(u), self._omega(x)))

    def expansion(self, u: Reals, x: Reals) -> Expansion:
        """Evaluate N, dN/du at fixed x and dN/dx at fixed u; NaN outside the element's domain."""
        return self.element.expansion(self.amplitude(u), self._omega(x))

    def amplitude(self, u: Reals) -> Reals:
        """Amplitude of u, in the unit of the element's input; infinite at 0, NaN for u < 0 or infinite."""
        amplitude = self.element.amplitude_scale / np.where(u >= 0, u, np.nan)
        # A step of Newton's method may lead to an amplitude that is too small for a double.
        return np.asarray(np.where(amplitude > 0, amplitude, np.nan))

    def edge(self, x: Reals) -> Reals:
        """Supremum of u at which N exists and changes with u, a number or in the shape of x."""
        if self.depends_on_x:
            return np.minimum(self.element.domain(self._omega(x)), self.element.constant_from)
        return self._edge

    @cached_property
    def _edge(self) -> Reals:
        return np.asarray(min(float(self.element.domain()), self.element.constant_from))

    def inside(self, cells: Cells) -> Flags:
        """Return whether each box lies inside the domain, whose edge is monotonic in omega."""
        edge = np.minimum(self.edge(cells.x_lower), self.edge(cells.x_upper))
        return np.asarray(cells.u_upper <= edge)

    def variation(self, cells: Cells) -> tuple[Reals, Reals]:
        """Bound the changes of dN/du and of dN/dx on boxes inside the domain, two arrays of shape (n,)."""
        by_u, by_x = self.element.variation((cells.u_lower, cells.u_upper), self._omega_range(cells))
        return np.asarray(by_u), np.asarray(by_x)

    def disks(self, cells: Cells) -> GainDisks:
        """Enclose N on boxes from its value at one point of each and the bounds of its slopes.

        That point is the middle. Where the edge of the domain runs through the box it is the corner that is
        farthest inside the domain, and the whole widths count.
        """
        ranges = (cells.u_lower, cells.u_upper), self._omega_range(cells)
        by_u, by_x = self.element.sensitivity(*ranges)
        reach = self.element.reach(*ranges)
        u_reach = np.broadcast_to(by_u * cells.u_half if reach is None else reach, cells.u_half.shape)
        if not self.depends_on_x:
            centre = self.value(cells.u_centre, cells.x_centre)
            return GainDisks(centre, u_reach, u_reach, np.ones(len(cells), dtype=bool))
        lower_edge, upper_edge = self.edge(cells.x_lower), self.edge(cells.x_upper)
        crossed = np.minimum(lower_edge, upper_edge) <= cells.u_upper
        factor = np.where(crossed, 2.0, 1.0)
        corner = np.where(lower_edge > upper_edge, cells.x_lower, cells.x_upper)
        centre = self.value(
            np.where(crossed, cells.u_lower, cells.u_centre), np.where(crossed, corner, cells.x_centre)
        )
        radius = factor * (u_reach + by_x * cells.x_half)
        exists = cells.u_lower < np.maximum(lower_edge, upper_edge)
        return GainDisks(centre, radius, factor * u_reach, exists)

    def _omega_range(self, cells: Cells) -> tuple[Reals, Reals] | None:
        return (np.exp(cells.x_lower), np.exp(cells.x_upper)) if self.depends_on_x else None

    def _omega(self, x: Reals) -> Reals | None:
        return np.asarray(np.exp(x)) if self.depends_on_x else None


_ROWS = 64  # Rows of a table where N does not depend on x, so that all blocks share them

_ROWS_PER_BLOCK = 32  # Rows of a table where each block has its own


@dataclass(frozen=True)
class GainTable:
    """Disks that hold N on a coarse grid, (rows, blocks), or (rows, 1) if N does not depend on x.

    Its breaks are the limits of the rows of u, from 0 on, (rows + 1,), and of the blocks of x, (blocks +
    1,).
    """

    curve: ElementCurve
    u_breaks: Reals
    x_breaks: Reals
    disks: GainDisks

    @classmethod
    def of(cls, curve: ElementCurve, x_breaks: Reals) -> Self:
        """Bound N on all u for which it exists, and between the given x."""
        blocks = x_breaks.size - 1 if curve.depends_on_x else 1
        rows = _ROWS_PER_BLOCK if curve.depends_on_x else _ROWS
        # The edge of the domain rises or falls with x, but not both.
        u_upper = float(curve.edge(x_breaks[[0, -1]]).max())
        u_breaks = np.linspace(0.0, u_upper, rows + 1)
        cells = Cells.grid(u_breaks, x_breaks[:blocks], x_breaks[1 : blocks + 1])
        disks = curve.disks(cells)
        table = (each.reshape(blocks, rows).T for each in vars(disks).values())
        return cls(curve, u_breaks, x_breaks, GainDisks(*table))

    @cached_property
    def box(self) -> Cells:
        """The single box that the whole table covers."""
        sides = (self.u_breaks[0], self.u_breaks[-1], self.x_breaks[0], self.x_breaks[-1])
        return Cells(*(np.array([side]) for side in sides))

    @cached_property
    def largest_gain(self) -> float:
        """Upper bound of |N| on the whole table."""
        sizes = np.abs(self.disks.centre) + self.disks.radius
        return float(sizes[self.disks.exists].max())

    @cached_property
    def smallest_gain(self) -> float:
        """Lower bound of |N| on the whole table; 0 if N may vanish."""
        sizes = np.abs(self.disks.centre) - self.disks.radius
        return max(0.0, float(sizes[self.disks.exists].min()))

    def rows_at(self, blocks: Places) -> GainDisks:
        """Disks of all rows at some blocks; of shape (rows, blocks), or (rows, 1) if all blocks are alike."""
        return self.disks[:, blocks] if self.curve.depends_on_x else self.disks

    def disks_at(self, rows: Places, blocks: Places) -> GainDisks:
        """Disks at pairs of row and block, arrays of the same length."""
        return self.disks[rows, blocks if self.curve.depends_on_x else 0]

    def cells(self, rows: Places, x_lower: Reals, x_upper: Reals) -> Cells:
        """Boxes of some rows between given x, arrays of the same length."""
        return Cells(self.u_breaks[rows], self.u_breaks[rows + 1], x_lower, x_upper)
