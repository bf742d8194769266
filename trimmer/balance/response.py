"""What the search for limit cycles needs to know of 1/G, with bounds on intervals of x = ln omega."""

from __future__ import annotations

from dataclasses import dataclass
from typing import TYPE_CHECKING, Protocol

import numpy as np

if TYPE_CHECKING:
    from numpy.typing import NDArray

    Reals = NDArray[np.float64]
    Complexes = NDArray[np.complex128]


@dataclass(frozen=True)
class Enclosure:
    """What 1/G does on intervals of x; each field has one entry per interval.

    Attributes:
        centre: 1/G in the middle of the interval.
        slope: d(1/G)/dx there.
        radius: Upper bound of |1/G - centre| on the interval.
        slope_radius: Upper bound of the change of d(1/G)/dx from its value in the middle.
        smallest: Lower bound of |1/G| on the interval.
        largest: Upper bound of |1/G| on the interval.
    """

    centre: Complexes
    slope: Complexes
    radius: Reals
    slope_radius: Reals
    smallest: Reals
    largest: Reals

    def take(self, which: NDArray[np.intp]) -> Enclosure:
        """Keep those at some places."""
        return Enclosure(
            self.centre[which],
            self.slope[which],
            self.radius[which],
            self.slope_radius[which],
            self.smallest[which],
            self.largest[which],
        )


class Response(Protocol):
    """A complex function of x that stands for 1/G."""

    def value_and_slope(self, x: Reals) -> tuple[Complexes, Complexes]:
        """Evaluate it and its derivative at an array of x of one dimension."""

    def enclose(self, lower: Reals, upper: Reals) -> Enclosure:
        """Bound it on the intervals [lower, upper]."""


@dataclass(frozen=True)
class ConstantResponse:
    """The same 1/G at all x, as when the frequency is given and something else is looked for.

    Attributes:
        inverse: 1/G.
    """

    inverse: complex

    def value_and_slope(self, x: Reals) -> tuple[Complexes, Complexes]:
        """Give the constant, and no slope."""
        return np.full(x.shape, self.inverse), np.zeros(x.shape, dtype=complex)

    def enclose(self, lower: Reals, upper: Reals) -> Enclosure:
        """Give the constant with radius 0."""
        value, slope = self.value_and_slope(lower)
        nothing = np.zeros(lower.shape)
        return Enclosure(value, slope, nothing, nothing, np.abs(value), np.abs(value))
