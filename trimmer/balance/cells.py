"""Boxes in the plane of u = amplitude_scale/amplitude, a number, and x = ln omega, omega in rad/s."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Self

import numpy as np

from trimmer.arrays import ArrayRecord, Flags, Reals


@dataclass(frozen=True)
class Cells(ArrayRecord):
    """Closed boxes between the smallest and the largest u and x of each, all of shape (n,)."""

    u_lower: Reals
    u_upper: Reals
    x_lower: Reals
    x_upper: Reals

    @classmethod
    def grid(cls, u_breaks: Reals, x_lower: Reals, x_upper: Reals) -> Self:
        """Combine limits of u, (rows + 1,), with intervals of x, (columns,); x varies slowest."""
        columns, rows = x_lower.size, u_breaks.size - 1
        return cls(
            np.tile(u_breaks[:-1], columns),
            np.tile(u_breaks[1:], columns),
            np.repeat(x_lower, rows),
            np.repeat(x_upper, rows),
        )

    @classmethod
    def none(cls) -> Self:
        """Return an empty set of boxes, to which others are joined."""
        return cls(*(np.empty(0) for _ in range(4)))

    @property
    def u_half(self) -> Reals:
        """Half of the width of each box in u, shape (n,)."""
        return 0.5 * (self.u_upper - self.u_lower)

    @property
    def x_half(self) -> Reals:
        """Half of the width of each box in x, shape (n,)."""
        return 0.5 * (self.x_upper - self.x_lower)

    @property
    def u_centre(self) -> Reals:
        """Centre of each box in u, shape (n,)."""
        return 0.5 * (self.u_lower + self.u_upper)

    @property
    def x_centre(self) -> Reals:
        """Centre of each box in x, shape (n,)."""
        return 0.5 * (self.x_lower + self.x_upper)

    def split(self, along_u: Flags, parts: int) -> Cells:
        """Cut each box into equal parts along u where flagged (shape (n,)), along x elsewhere."""
        shares = np.arange(parts + 1) / parts
        u = np.where(along_u[:, None], self.u_lower[:, None] + 2 * self.u_half[:, None] * shares, 0.0)
        x = np.where(along_u[:, None], 0.0, self.x_lower[:, None] + 2 * self.x_half[:, None] * shares)
        u_whole, x_whole = ~along_u[:, None], along_u[:, None]
        return Cells(
            np.where(u_whole, self.u_lower[:, None], u[:, :-1]).ravel(),
            np.where(u_whole, self.u_upper[:, None], u[:, 1:]).ravel(),
            np.where(x_whole, self.x_lower[:, None], x[:, :-1]).ravel(),
            np.where(x_whole, self.x_upper[:, None], x[:, 1:]).ravel(),
        )

    def inflated(self, factor: float, limits: Cells) -> Cells:
        """Widen each box about its centre by a factor, but not beyond the single box ``limits``."""
        excess = 0.5 * (factor - 1.0)
        u, x = excess * (self.u_upper - self.u_lower), excess * (self.x_upper - self.x_lower)
        return Cells(
            np.maximum(self.u_lower - u, limits.u_lower),
            np.minimum(self.u_upper + u, limits.u_upper),
            np.maximum(self.x_lower - x, limits.x_lower),
            np.minimum(self.x_upper + x, limits.x_upper),
        )

    def contains(self, u: Reals, x: Reals) -> Flags:
        """Return whether each box contains the point at the same place; all shapes (n,)."""
        inside_u = (self.u_lower <= u) & (u <= self.u_upper)
        return np.asarray(inside_u & (self.x_lower <= x) & (x <= self.x_upper))

    def hold(self, u: Reals, x: Reals) -> Flags:
        """Return whether each of n boxes contains each of m points: shape (n, m)."""
        inside_u = (self.u_lower[:, None] <= u) & (u <= self.u_upper[:, None])
        return np.asarray(inside_u & (self.x_lower[:, None] <= x) & (x <= self.x_upper[:, None]))

    def lie_within(self, others: Cells) -> Flags:
        """Return whether each box lies within at least one of the others, shape (n,)."""
        inside = (
            (others.u_lower[:, None] <= self.u_lower)
            & (self.u_upper <= others.u_upper[:, None])
            & (others.x_lower[:, None] <= self.x_lower)
            & (self.x_upper <= others.x_upper[:, None])
        )
        return np.asarray(inside.any(axis=0))
