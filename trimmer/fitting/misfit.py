"""The whitened distance between measured and simulated lines, with the origin of time free."""

from dataclasses import dataclass
from functools import cached_property

import numpy as np

from trimmer.arrays import Complexes, Flags, Reals
from trimmer.fitting.measured import MeasuredLines
from trimmer.fitting.model import GOES_ON, Model, ModelMotion
from trimmer.spectra.comparison import best_angle

STEP = 1e-5  # Difference of a coordinate from which derivatives are taken; orbits are exact to about 1e-13
ROUGH = 0.1  # Share by which the two one-sided derivatives may differ before a smaller difference is tried
SMALLER = 1e-2  # By how much smaller that is


@dataclass(frozen=True, eq=False)
class Fitted:
    """A motion of the model, shifted in time so that it agrees best."""

    motion: ModelMotion  # The motion
    angle: float  # By which its first line is turned, rad
    lines: Complexes  # Its lines after that, (m, outputs)
    # Real and imaginary parts of the whitened differences, (2 m outputs,), and without a drive the difference
    # of the frequencies over its deviation
    residual: Reals

    @property
    def coordinates(self) -> Reals:
        """Those of the unknowns, (unknowns,)."""
        return self.motion.coordinates

    @property
    def chi_square(self) -> float:
        """Sum of the squares of the residual."""
        return float(self.residual @ self.residual)


@dataclass(frozen=True, eq=False)
class Misfit:
    """The distance of a model from a measurement."""

    measured: MeasuredLines
    model: Model

    @cached_property
    def _whitened(self) -> Complexes:
        return self.measured.whitened(self.measured.lines)

    @property
    def size(self) -> int:
        """Number of residuals."""
        return 2 * self.measured.lines.size + int(self.model.by_itself)

    def settled(self, coordinates: Reals) -> Fitted | None:
        """Return what the mechanism settles to from its start; None if it repeats otherwise or never."""
        motion = self.model.settled(coordinates)
        return None if motion is None else self._aligned(motion)

    def continued(self, coordinates: Reals, near: Fitted, settling: int = GOES_ON) -> Fitted | None:
        """Return the motion that goes on from one of neighbouring numbers; see ``Model.continued``."""
        motion = self.model.continued(coordinates, near.motion, settling)
        return None if motion is None else self._aligned(motion)

    def _aligned(self, motion: ModelMotion) -> Fitted:
        simulated = self.measured.whitened(motion.lines)
        apart, angle, turn = self._turned(self._whitened, simulated)
        residual = np.concatenate([apart.real, apart.imag])
        if self.model.by_itself:
            off = 1.0 / motion.orbit.period - self.measured.frequency
            residual = np.append(residual, off / self.measured.frequency_deviation)
        return Fitted(motion, angle, motion.lines * turn, residual)

    @staticmethod
    def _turned(measured: Complexes, simulated: Complexes) -> tuple[Complexes, float, Complexes]:
        """Return differences, (m outputs,), the angle by which the first line is turned, and that of each."""
        angle = best_angle((measured * simulated.conj()).sum(axis=1))
        turn = np.exp(1j * angle * np.arange(1, len(simulated) + 1))[:, None]
        return (simulated * turn - measured).ravel(), angle, turn

    def opposite(self, fitted: Fitted) -> float:
        """Return the chi-square of the same motion if the measurement had the opposite sign."""
        simulated = self.measured.whitened(fitted.motion.lines)
        return float(np.sum(abs(self._turned(-self._whitened, simulated)[0]) ** 2))

    def jacobian(self, fitted: Fitted, free: Flags | None = None) -> Reals:
        """Return the derivative of the residual by the free coordinates, (residuals, unknowns), or else zero.

        The origin of time is fitted anew on both sides, so that what it can take up is not in the
        derivative. A column is zero where no neighbouring motion is found.
        """
        slope = np.zeros((self.size, len(fitted.coordinates)))
        for place in range(len(fitted.coordinates)):
            if free is None or free[place]:
                slope[:, place] = self._column(fitted, place)
        return slope

    def _column(self, fitted: Fitted, place: int) -> Reals:
        column, rough = self._difference(fitted, place, STEP)
        if rough > ROUGH:
            finer, rougher = self._difference(fitted, place, SMALLER * STEP)
            column = finer if rougher < rough else column
        return column

    def _difference(self, fitted: Fitted, place: int, step: float) -> tuple[Reals, float]:
        """Return the derivative by one coordinate, and by how much it differs from side to side."""
        sides = []
        for sign in (1.0, -1.0):
            coordinates = fitted.coordinates.copy()
            coordinates[place] += sign * step
            # Where stick leaves a position free, Newton's method has no one solution to go to.
            other = self.continued(coordinates, fitted, GOES_ON if fitted.motion.orbit.neutral else 0)
            if other is not None:
                sides.append(sign * (other.residual - fitted.residual) / step)
        if not sides:
            return np.zeros(self.size), 0.0
        mean = np.mean(sides, axis=0)
        if len(sides) == 1:
            return mean, 0.0
        size = float(np.linalg.norm(mean))
        return mean, float(np.linalg.norm(sides[0] - sides[1])) / size if size else 0.0
