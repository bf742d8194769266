"""Measurements and misfits made by hand, whose best fit and intervals are known."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass, field
from types import SimpleNamespace
from typing import Any

import numpy as np

from trimmer import Signal
from trimmer.fitting.measured import MeasuredLines
from trimmer.fitting.stray import StrayLine
from trimmer.fitting.unknowns import Unknown


def measured(
    lines: np.ndarray,
    factors: np.ndarray | None = None,
    *,
    freedom: float = 50.0,
    periods: float = 100.0,
    period_count: int = 1,
    strays: tuple[StrayLine, ...] = (),
    noiseless: bool = False,
) -> MeasuredLines:
    """Return lines, (m, outputs), whose drive of 50 Hz lasts some periods; by default with a noise of 1."""
    count, outputs = lines.shape
    samples = round(20 * periods)
    signals = {f"s{place}": Signal(np.zeros(samples), 1000.0, f"s{place}", "m") for place in range(outputs)}
    unit = np.broadcast_to(np.eye(outputs, dtype=complex), (count, outputs, outputs))
    used = unit if factors is None else factors
    return MeasuredLines(signals, 50.0, True, period_count, lines, used, freedom, strays, noiseless)


@dataclass(eq=False)
class At:
    """A motion of a known misfit."""

    coordinates: np.ndarray
    residual: np.ndarray

    @property
    def chi_square(self) -> float:
        return float(self.residual @ self.residual)


@dataclass(eq=False)
class Known:
    """A misfit whose residual is a known function of the coordinates; it counts its calls.

    The function returns None where there is no motion.
    """

    function: Callable[[np.ndarray], np.ndarray | None]
    count: int = 2
    unknowns: tuple[Unknown, ...] = ()
    tried: list[np.ndarray] = field(default_factory=list)
    jacobians: int = 0

    @property
    def model(self) -> Any:
        usual = tuple(Unknown(f"plays.p{each}.gap", "m", 4e-5, True) for each in range(self.count))
        return SimpleNamespace(unknowns=self.unknowns or usual)

    @property
    def size(self) -> int:
        found = self.function(np.zeros(self.count))
        assert found is not None
        return len(found)

    def at(self, *coordinates: float) -> At:
        found = self.function(np.array(coordinates))
        assert found is not None
        return At(np.array(coordinates), found)

    def settled(self, coordinates: np.ndarray) -> At | None:
        return self.continued(coordinates, None)

    def continued(self, coordinates: np.ndarray, near: At | None) -> At | None:
        self.tried.append(coordinates)
        found = self.function(coordinates)
        return None if found is None else At(coordinates, found)

    def jacobian(self, fitted: At, free: np.ndarray | None = None) -> np.ndarray:
        self.jacobians += 1
        slope = np.zeros((self.size, self.count))
        for place in range(self.count):
            if free is None or free[place]:
                step = np.zeros(self.count)
                step[place] = 1e-6
                slope[:, place] = self._difference(fitted, step)
        return slope

    def _difference(self, fitted: At, step: np.ndarray) -> np.ndarray:
        above, below = (self.function(fitted.coordinates + each) for each in (step, -step))
        above = fitted.residual if above is None else above
        below = fitted.residual if below is None else below
        missing = sum(each is fitted.residual for each in (above, below))
        if missing == 2:
            return np.zeros(self.size)
        return (above - below) / ((2 - missing) * step.sum())
