"""Intervals by the profile likelihood: how far a number may move while the others make up for it.

An end of the interval lies where the least chi-square over all other numbers exceeds that of the fit by the
quantile of F(1, nu), which is that of chi-square with one degree of freedom where the noise is known from
many (Venzon and Moolgavkar 1988, Applied Statistics 37, 87-94; Raue et al. 2009, Bioinformatics 25, 1923).
"""

from __future__ import annotations

import math
from dataclasses import dataclass, replace
from typing import TYPE_CHECKING

import numpy as np

from trimmer.fitting.minimum import nearby_minimum
from trimmer.fitting.unknowns import bounds_of

if TYPE_CHECKING:
    from trimmer.arrays import Reals
    from trimmer.fitting.misfit import Fitted, Misfit

CLOSE = 0.03  # Relative error of the root of the excess at which an end counts as found
BETTER = 0.5  # By how much a profile may fall below the fit before the fit begins anew there
MOST_TRIALS = 24  # Places at which one side of a profile is tried
LONGEST = 0.7  # Largest change of the coordinate from one place to the next
JUMP = 3.0
"""Root of the excess from which on a place is far outside: a motion of another kind, or a poor guess."""
COARSE, FINE = 2e-3, 2e-5
"""Shares of the distance from the fit to which an end is known, and a jump is told from a steep rise."""
NARROW = 1e-7  # Change of the coordinate below which no end is told from the fit


@dataclass(frozen=True, eq=False)
class ProfileSide:
    """One side of a profile."""

    end: float | None  # Coordinate at which the interval ends; None where it is open
    reached: float  # Coordinate of the farthest place that was tried and still fits
    # Whether the motion is lost beyond ``reached``, or jumps to one that does not fit, so that it is not the
    # noise that ends the interval there
    lost: bool = False
    better: Fitted | None = None  # A fit that is better than the one it began with, if one was met


@dataclass(frozen=True)
class _Bracket:
    """What is known of the place of an end: distances from the fit, and roots of the excess there."""

    # inside, low: The farthest distance that fits, and its root, below 1
    inside: float = 0.0
    low: float = 0.0
    # outside, high: The nearest one that does not; infinite where none is known, or no motion is there
    outside: float = math.inf
    high: float = math.inf

    def narrowed(self, distance: float, excess: float) -> _Bracket:
        """Return what is known after another place."""
        if excess < 1.0:
            return replace(self, inside=distance, low=excess)
        return replace(self, outside=distance, high=excess)

    @property
    def is_narrow(self) -> bool:
        """Whether the end is known as well as is needed; what may be a jump is looked at more closely."""
        steep = JUMP < self.high < math.inf
        return self.outside - self.inside < NARROW + (FINE if steep else COARSE) * self.inside

    def following(self, farthest: float) -> float:
        """Return the next distance: where a parabola from the fit crosses, within what is known."""
        if math.isinf(self.outside):
            grown = self.inside * min(max(1.0 / max(self.low, 1e-6), 1.2), 4.0)
            return min(grown, self.inside + LONGEST, farthest)
        if self.high > JUMP:
            return 0.5 * (self.inside + self.outside)
        share = (1.0 - self.low) / (self.high - self.low)
        return self.inside + min(max(share, 0.1), 0.9) * (self.outside - self.inside)


@dataclass(frozen=True, eq=False)
class MisfitProfile:
    """The profile of one number about a fit."""

    misfit: Misfit  # The misfit
    best: Fitted  # The fit
    jacobian: Reals  # Its derivative, (residuals, unknowns)
    place: int  # Which unknown
    allowed: float  # Excess of chi-square at the ends of the interval

    def side(self, sign: float) -> ProfileSide:
        """Follow the profile to one side, +1 or -1, until the excess of chi-square is what is allowed."""
        bounds = bounds_of(self.misfit.model.unknowns)[1 if sign > 0 else 0]
        farthest = abs(float(bounds[self.place]) - self._centre)
        known = _Bracket()
        near, distance = self.best, min(self._expected(), LONGEST, farthest)
        for _ in range(MOST_TRIALS):
            fitted = self._at(sign * distance, near)
            if fitted is not None and fitted.chi_square < self.best.chi_square - BETTER:
                return ProfileSide(None, self._centre, better=fitted)
            excess = math.inf if fitted is None else self._excess(fitted)
            if abs(excess - 1.0) < CLOSE:
                return ProfileSide(self._centre + sign * distance, self._centre + sign * distance)
            known = known.narrowed(distance, excess)
            if fitted is not None and excess < 1.0:
                near = fitted
                if distance >= farthest:
                    break
            if known.is_narrow:
                break
            distance = known.following(farthest)
        return self._found(sign, known)

    @property
    def _centre(self) -> float:
        return float(self.best.coordinates[self.place])

    def _excess(self, fitted: Fitted) -> float:
        """Return the root of the excess of chi-square over what is allowed."""
        return math.sqrt(max(fitted.chi_square - self.best.chi_square, 0.0) / self.allowed)

    def _found(self, sign: float, known: _Bracket) -> ProfileSide:
        reached = self._centre + sign * known.inside
        if math.isinf(known.outside):
            return ProfileSide(None, reached)
        if known.high > JUMP:
            return ProfileSide(None, reached, lost=True)
        return ProfileSide(self._centre + sign * known.outside, reached)

    def _expected(self) -> float:
        """Return where the end would be if the residual were linear."""
        others = np.delete(self.jacobian, self.place, axis=1)
        column = self.jacobian[:, self.place]
        rest = column
        if others.shape[1]:
            rest = column - others @ np.linalg.lstsq(others, column, rcond=1e-9)[0]
        size = float(rest @ rest)
        return math.sqrt(self.allowed / size) if size > 0 else math.inf

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
        if begun is None or self._excess(begun) > JUMP:
            other = self.misfit.continued(coordinates, near)
            if begun is None or (other is not None and other.chi_square < begun.chi_square):
                begun = other
        return None if begun is None else nearby_minimum(self.misfit, begun, free, self.jacobian)

    def _made_up(self, free: Reals) -> Reals:
        """Return by how much the others change with the number to make up for it, (others,)."""
        others, column = self.jacobian[:, free], self.jacobian[:, self.place]
        if not others.shape[1]:
            return np.zeros(0)
        return np.asarray(np.clip(-np.linalg.lstsq(others, column, rcond=1e-6)[0], -3.0, 3.0))
