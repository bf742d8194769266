"""Contacts, frictions and walls of the second way, as its equations have them."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from dataclasses import dataclass

import numpy as np


def nothing(t: float) -> tuple[float, float, float]:
    """Return displacement, velocity and acceleration of what does not move."""
    return 0.0, 0.0, 0.0


@dataclass(frozen=True)
class Contact:
    """T = k z + c s', force -w T; s = w q + the pin's share. Above ``upper`` or below ``lower`` it touches.

    It lets go where T changes its sign; free, z relaxes by k z + c z' = 0 until s - z is at an edge again.
    """

    w: Sequence[float]
    k: float
    c: float
    lower: float
    upper: float
    pin: Callable[[float], tuple[float, float, float]] = nothing

    def s(self, t: float, q: np.ndarray, v: np.ndarray) -> tuple[float, float]:
        """Return s and its rate."""
        at, rate, _ = self.pin(t)
        return float(np.dot(self.w, q)) + at, float(np.dot(self.w, v)) + rate


@dataclass(frozen=True)
class Friction:
    """Force -w (F(|u|) sgn u + d u) with u = w q' + the pin's velocity; in stick up to ``static``."""

    w: Sequence[float]
    force: Callable[[float], float]
    static: float
    d: float = 0.0
    pin: Callable[[float], tuple[float, float, float]] = nothing
    knots: Sequence[float] = ()

    def u(self, t: float, v: np.ndarray) -> float:
        """Return the sliding speed."""
        return float(np.dot(self.w, v)) + self.pin(t)[1]


@dataclass(frozen=True)
class Wall:
    """w q + the pin's share <= gap; where it is met with a rate r > 0, the rate becomes -e r."""

    w: Sequence[float]
    e: float
    gap: float = 0.0
    pin: Callable[[float], tuple[float, float, float]] = nothing
