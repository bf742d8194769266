"""Disks that hold N on a coarse grid of boxes: rows of u, and blocks of x if N depends on it."""

from __future__ import annotations

from dataclasses import dataclass
from functools import cached_property
from typing import TYPE_CHECKING, Self

import numpy as np

from trimmer.balance.cells import Cells
from trimmer.balance.element_curve import GainDisks

if TYPE_CHECKING:
    from numpy.typing import NDArray

    from trimmer.balance.element_curve import ElementCurve

    Reals = NDArray[np.float64]
    Places = NDArray[np.intp]

_ROWS = 64
"""Rows where one table serves all x."""

_ROWS_PER_BLOCK = 32
"""Rows where each block has its own."""


@dataclass(frozen=True)
class GainTable:
    """N on rows of u and blocks of x.

    Attributes:
        curve: N.
        u_breaks: Limits of the rows, from 0 on.
        x_breaks: Limits of the blocks.
        disks: Disks that hold N, of shape (rows, blocks), or (rows, 1) if N does not depend on x.
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
        table = GainDisks(
            disks.centre.reshape(blocks, rows).T,
            disks.radius.reshape(blocks, rows).T,
            disks.u_share.reshape(blocks, rows).T,
            disks.exists.reshape(blocks, rows).T,
        )
        return cls(curve, u_breaks, x_breaks, table)

    @cached_property
    def box(self) -> Cells:
        """The one box that all of it covers."""
        sides = (self.u_breaks[0], self.u_breaks[-1], self.x_breaks[0], self.x_breaks[-1])
        return Cells(*(np.array([side]) for side in sides))

    @cached_property
    def largest_gain(self) -> float:
        """Upper bound of |N|."""
        sizes = np.abs(self.disks.centre) + self.disks.radius
        return float(sizes[self.disks.exists].max())

    @cached_property
    def smallest_gain(self) -> float:
        """Lower bound of |N|; 0 if it may vanish."""
        sizes = np.abs(self.disks.centre) - self.disks.radius
        return max(0.0, float(sizes[self.disks.exists].min()))

    def rows_at(self, blocks: Places) -> GainDisks:
        """Disks of all rows at some blocks; of shape (rows, blocks), or (rows, 1) if all blocks are alike."""
        return self.disks.take((slice(None), blocks)) if self.curve.depends_on_x else self.disks

    def disks_at(self, rows: Places, blocks: Places) -> GainDisks:
        """Disks of some rows, each at a block."""
        return self.disks.take((rows, blocks if self.curve.depends_on_x else 0))

    def cells(self, rows: Places, x_lower: Reals, x_upper: Reals) -> Cells:
        """Boxes on some rows between given x."""
        return Cells(self.u_breaks[rows], self.u_breaks[rows + 1], x_lower, x_upper)
