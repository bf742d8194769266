"""Boxes that hold no solution of N + 1/G = 0, because disks that hold N and -1/G lie apart."""

from __future__ import annotations

from dataclasses import dataclass
from typing import TYPE_CHECKING

import numpy as np

from trimmer.balance.cells import Cells
from trimmer.balance.element_curve import GainDisks
from trimmer.balance.response import Enclosure

if TYPE_CHECKING:
    from numpy.typing import NDArray

    from trimmer.balance.element_curve import ElementCurve
    from trimmer.balance.response import Response

    Flags = NDArray[np.bool_]
    Reals = NDArray[np.float64]


@dataclass(frozen=True)
class EnclosedCells:
    """Boxes with what N and 1/G do on them, one entry of each part per box.

    Attributes:
        cells: The boxes.
        disks: Disks that hold N.
        enclosure: What 1/G does.
    """

    cells: Cells
    disks: GainDisks
    enclosure: Enclosure

    @classmethod
    def of(cls, response: Response, curve: ElementCurve, cells: Cells) -> EnclosedCells:
        """Enclose N and 1/G on boxes."""
        return cls(cells, curve.disks(cells), response.enclose(cells.x_lower, cells.x_upper))

    def __len__(self) -> int:
        return len(self.cells)

    def refined(self, curve: ElementCurve) -> EnclosedCells:
        """Replace the disks by those that hold N on the very boxes."""
        return EnclosedCells(self.cells, curve.disks(self.cells), self.enclosure)

    def open(self, smallest_gain: float) -> EnclosedCells:
        """Keep those that may hold a solution."""
        sizes, radius = np.abs(self.disks.centre), self.disks.radius
        smallest = np.maximum(sizes - radius, smallest_gain)
        possible = disks_meet(self.disks, self.enclosure)
        which = np.flatnonzero(possible & sizes_meet(self.enclosure, smallest, sizes + radius))
        return EnclosedCells(self.cells.take(which), self.disks.take(which), self.enclosure.take(which))


def disks_meet(disks: GainDisks, enclosure: Enclosure) -> Flags:
    """Whether N and -1/G can be the same, given disks that hold them; arguments of any shape broadcast."""
    apart = disks.centre + enclosure.centre
    reach = disks.radius + enclosure.radius
    return np.asarray(disks.exists & ~(apart.real**2 + apart.imag**2 > reach**2))


def sizes_meet(enclosure: Enclosure, smallest: Reals | float, largest: Reals | float) -> Flags:
    """Whether |1/G| can be between the smallest and the largest |N|."""
    # In this form it is true where a bound of 1/G is missing (NaN).
    return ~((enclosure.smallest > largest) | (enclosure.largest < smallest))
