"""Where each part of the extended state stands: plant, components, sine and cosine of the drive, and one."""

from __future__ import annotations

from dataclasses import dataclass
from typing import TYPE_CHECKING

import numpy as np

if TYPE_CHECKING:
    from numpy.typing import NDArray

    from trimmer.motion.interconnection import Interconnection

    Reals = NDArray[np.float64]


@dataclass(frozen=True)
class Layout:
    """Positions in the extended state.

    Attributes:
        order: States of the plant, which come first.
        first_states: For each component, where its own states begin.
        sine: Where the drive's sine stands; its cosine follows.
        size: Number of entries; the last one is one.
    """

    order: int
    first_states: tuple[int, ...]
    sine: int
    size: int

    @classmethod
    def of(cls, interconnection: Interconnection) -> Layout:
        """Lay out an interconnection."""
        counts = [component.state_count for component in interconnection.components]
        ends = np.cumsum([interconnection.order, *counts])
        sine = int(ends[-1])
        return cls(interconnection.order, tuple(int(end) for end in ends[:-1]), sine, sine + 3)

    def unit(self, position: int) -> Reals:
        """Return the row that picks one entry."""
        row = np.zeros(self.size)
        row[position] = 1.0
        return row

    @property
    def one(self) -> Reals:
        """The row that gives one."""
        return self.unit(self.size - 1)
