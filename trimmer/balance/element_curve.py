"""A describing function as N(u, x), u = amplitude_scale/amplitude, x = ln omega, with bounds on boxes."""

from __future__ import annotations

from dataclasses import dataclass
from functools import cached_property
from typing import TYPE_CHECKING, Any

import numpy as np

if TYPE_CHECKING:
    from numpy.typing import NDArray

    from trimmer.balance.cells import Cells
    from trimmer.elements.element import Element
    from trimmer.elements.expansion import Expansion

    Reals = NDArray[np.float64]
    Complexes = NDArray[np.complex128]
    Flags = NDArray[np.bool_]


@dataclass(frozen=True)
class GainDisks:
    """Disks that hold N on boxes, one entry per box.

    Attributes:
        centre: Centre of the disk.
        radius: Radius of the disk.
        u_share: Part of the radius that comes from the width in u.
        exists: Whether the element has a describing function anywhere in the box.
    """

    centre: Complexes
    radius: Reals
    u_share: Reals
    exists: Flags

    def take(self, which: Any) -> GainDisks:
        """Keep those at some places, given as NumPy takes an index."""
        return GainDisks(self.centre[which], self.radius[which], self.u_share[which], self.exists[which])


@dataclass(frozen=True)
class ElementCurve:
    """The describing function of an element.

    Attributes:
        element: The nonlinear element.
    """

    element: Element

    @property
    def depends_on_x(self) -> bool:
        """Whether N changes with x."""
        return self.element.depends_on_frequency

    def value(self, u: Reals, x: Reals) -> Complexes:
        """Evaluate N; NaN outside the element's domain."""
        return np.asarray(self.element.describing_function(self.amplitude(u), self._omega(x)))

    def expansion(self, u: Reals, x: Reals) -> Expansion:
        """Evaluate N, dN/du at fixed x and dN/dx at fixed u; NaN outside the element's domain."""
        return self.element.expansion(self.amplitude(u), self._omega(x))

    def amplitude(self, u: Reals) -> Reals:
        """Amplitude that belongs to u; infinite for u = 0, with NumPy's warning. NaN for u < 0."""
        return np.asarray(self.element.amplitude_scale / np.where(u >= 0, u, np.nan))

    def edge(self, x: Reals) -> Reals:
        """Least upper bound of u at which the element has a describing function; broadcasts with x."""
        if self.depends_on_x:
            return np.asarray(self.element.domain(self._omega(x)))
        return self._edge

    @cached_property
    def _edge(self) -> Reals:
        return np.asarray(self.element.domain())

    def inside(self, cells: Cells) -> Flags:
        """Whether each box lies inside the domain; its edge rises or falls with omega, but not both."""
        edge = np.minimum(self.edge(cells.x_lower), self.edge(cells.x_upper))
        return np.asarray(cells.u_upper <= edge)

    def variation(self, cells: Cells) -> tuple[Reals, Reals]:
        """Bound the changes of dN/du and of dN/dx on boxes inside the domain."""
        by_u, by_x = self.element.variation((cells.u_lower, cells.u_upper), self._omega_range(cells))
        return np.asarray(by_u), np.asarray(by_x)

    def disks(self, cells: Cells) -> GainDisks:
        """Enclose N on boxes from its value at one point of each and the bounds of its slopes.

        That point is the middle. Where the edge of the domain runs through the box it is the corner that is
        farthest inside the domain, and the whole widths count.
        """
        by_u, by_x = self.element.sensitivity((cells.u_lower, cells.u_upper), self._omega_range(cells))
        u_reach = np.broadcast_to(by_u * cells.u_half, cells.u_half.shape)
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
