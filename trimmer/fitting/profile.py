"""Intervals by the profile likelihood: how far a number may move while the others make up for it.

An end of the interval lies where the least chi-square over all other numbers exceeds that of the fit by the
quantile of F(1, nu), which is that of chi-square with one degree of freedom where the noise is known from
many (Venzon and Moolgavkar 1988, Applied Statistics 37, 87-94; Raue et al. 2009, Bioinformatics 25, 1923).
"""

from __future__ import annotations

import math
from dataclasses import dataclass
from typing import TYPE_CHECKING

import numpy as np

from trimmer.fitting.minimum import nearby_minimum
from trimmer.fitting.unknowns import bounds_of

if TYPE_CHECKING:
    from trimmer.arrays import Reals
    from trimmer.fitting.misfit import Fitted, Misfit

CLOSE = 0.03
"""Relative error of the root of the excess at which an end counts as found."""
BETTER = 0.3
"""By how much a profile may fall below the fit before the fit begins anew there."""
MOST_TRIALS = 14
"""Places at which one side of a profile is tried."""
LONGEST = 0.7
"""Largest change of the coordinate from one place to the next."""
NARROW = 1e-7
"""Change of the coordinate below which no end is told from the fit."""


@dataclass(frozen=True, eq=False)
class Side:
    """One side of a profile.

    Attributes:
        end: Coordinate at which the interval ends; None where it is open.
        reached: Coordinate of the farthest place that was tried and still fits.
        lost: Whether the motion is lost beyond ``reached``, so that the interval ends there for another
            reason than the misfit.
        better: A fit that is better than the one it began with, if one was met.
    """

    end: float | None
    reached: float
    lost: bool = False
    better: Fitted | None = None


@dataclass(frozen=True, eq=False)
class Profile:
    """The profile of one number about a fit.

    Attributes:
        misfit: The misfit.
        best: The fit.
        jacobian: Its derivative, (residuals, unknowns).
        place: Which unknown.
        allowed: Excess of chi-square at the ends of the interval.
    """

    misfit: Misfit
    best: Fitted
    jacobian: Reals
    place: int
    allowed: float

    def side(self, sign: float) -> Side:
        """Follow the profile to one side, +1 or -1, until the excess of chi-square is what is allowed."""
        bounds = bounds_of(self.misfit.model.unknowns)[1 if sign > 0 else 0]
        farthest = abs(float(bounds[self.place]) - self._centre)
        inside, outside, near, excess = 0.0, math.inf, self.best, 0.0
        distance = min(self._expected(), LONGEST, farthest)
        for _ in range(MOST_TRIALS):
            fitted = self._at(sign * distance, near)
            if fitted is None:
                outside, beyond = distance, math.inf
            else:
                beyond = (fitted.chi_square - self.best.chi_square) / self.allowed
                if fitted.chi_square < self.best.chi_square - BETTER:
                    return Side(None, self._centre, better=fitted)
                if abs(math.sqrt(max(beyond, 0.0)) - 1.0) < CLOSE:
                    return Side(self._centre + sign * distance, self._centre + sign * distance)
                if beyond < 1.0:
                    inside, near, excess = distance, fitted, max(beyond, 0.0)
                    if distance >= farthest:
                        return Side(None, self._centre + sign * distance)
                else:
                    outside = distance
            distance = self._next(inside, excess, outside, beyond, farthest)
            if outside - inside < NARROW + 1e-3 * inside:
                return self._narrowed(sign, inside, outside, beyond)
        return self._narrowed(sign, inside, outside, beyond)

    @property
    def _centre(self) -> float:
        return float(self.best.coordinates[self.place])

    def _narrowed(self, sign: float, inside: float, outside: float, beyond: float) -> Side:
        reached = self._centre + sign * inside
        if math.isinf(outside):
            return Side(None, reached)
        lost = math.isinf(beyond)
        return Side(None if lost else self._centre + sign * outside, reached, lost)

    def _expected(self) -> float:
        """Return where the end would be if the residual were linear."""
        others = np.delete(self.jacobian, self.place, axis=1)
        column = self.jacobian[:, self.place]
        rest = column
        if others.shape[1]:
            rest = column - others @ np.linalg.lstsq(others, column, rcond=1e-9)[0]
        size = float(rest @ rest)
        return math.sqrt(self.allowed / size) if size > 0 else math.inf

    def _next(self, inside: float, excess: float, outside: float, beyond: float, farthest: float) -> float:
        """Return the next distance: where a parabola from the fit crosses, within what is known."""
        if math.isinf(outside):
            grown = inside * min(max(1.0 / math.sqrt(max(excess, 1e-12)), 1.2), 4.0)
            return min(grown, inside + LONGEST, farthest)
        if math.isinf(beyond):
            return 0.5 * (inside + outside)
        low, high = math.sqrt(excess), math.sqrt(beyond)
        share = (1.0 - low) / max(high - low, 1e-12)
        return inside + min(max(share, 0.1), 0.9) * (outside - inside)

    def _at(self, apart: float, near: Fitted) -> Fitted | None:
        """Return the least misfit with the number at a distance from its fit; None if no motion is there."""
        free = np.ones(len(self.best.coordinates), dtype=bool)
        free[self.place] = False
        coordinates = near.coordinates.copy()
        change = self._centre + apart - coordinates[self.place]
        coordinates[self.place] += change
        guess = coordinates.copy()
        guess[free] += self._made_up(free) * change
        least, largest = bounds_of(self.misfit.model.unknowns)
        begun = self.misfit.continued(np.clip(guess, least, largest), near)
        begun = begun or self.misfit.continued(coordinates, near)
        return None if begun is None else nearby_minimum(self.misfit, begun, free, self.jacobian)

    def _made_up(self, free: Reals) -> Reals:
        """Return by how much the others change with the number to make up for it, (others,)."""
        others, column = self.jacobian[:, free], self.jacobian[:, self.place]
        if not others.shape[1]:
            return np.zeros(0)
        return np.asarray(np.clip(-np.linalg.lstsq(others, column, rcond=1e-6)[0], -3.0, 3.0))
