"""Least squares from several starts: the misfit has kinks where events appear, and local minima."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from dataclasses import dataclass, field
from typing import TYPE_CHECKING

import numpy as np

from trimmer.fitting.minimum import nearby_minimum
from trimmer.fitting.unknowns import Unknown, bounds_of
from trimmer.progress import progress_bar

if TYPE_CHECKING:
    from trimmer.arrays import Reals
    from trimmer.fitting.misfit import Fitted, Misfit

MOST_EVALUATIONS = 40  # Orbits of one start, those for derivatives not counted
LOST = 10.0  # Size of the residual where no motion is found, over that of the start
AGREES = 1.0  # Excess of chi-square over the least one within which a start has come to the same fit
WORTH = 1.5  # Chi-square over the least one up to which a fit is made exact


@dataclass(frozen=True, eq=False)
class FitSearch:
    """What the starts came to.

    Attributes:
        best: The least misfit.
        starts: Number of starts.
        agreeing: How many of them came to it.
        elsewhere: Chi-square of the others that came to a fit, rising.
        lost: How many began where the motion does not repeat as the measured one does.
    """

    best: Fitted
    starts: int
    agreeing: int
    elsewhere: tuple[float, ...]
    lost: int


def search(misfit: Misfit, starts: int, spread: float, seed: int) -> FitSearch | None:
    """Fit from several starts; None if none of them repeats as the measured motion does.

    Those after the first are random, with numbers off by a factor of ``spread`` at most.
    """
    found = []
    for coordinates in progress_bar(list(_begun(misfit.model.unknowns, starts, spread, seed)), "starts"):
        begun = misfit.settled(coordinates)
        if begun is not None:
            found.append(_Descent(misfit, begun).lowest())
    if not found:
        return None
    least, free = min(each.chi_square for each in found), np.ones(len(misfit.model.unknowns), dtype=bool)
    near = WORTH * least + misfit.size
    found = [nearby_minimum(misfit, each, free) if each.chi_square <= near else each for each in found]
    best = min(found, key=lambda each: each.chi_square)
    others = sorted(each.chi_square for each in found if each.chi_square > best.chi_square + AGREES)
    return FitSearch(best, starts, len(found) - len(others), tuple(others), starts - len(found))


def _begun(unknowns: Sequence[Unknown], starts: int, spread: float, seed: int) -> Iterator[Reals]:
    from scipy.stats import qmc

    yield np.zeros(len(unknowns))
    if starts > 1:
        drawn = qmc.LatinHypercube(len(unknowns), seed=seed).random(starts - 1)
        yield from np.log(spread) * (2.0 * drawn - 1.0)


@dataclass(eq=False)
class _Descent:
    """One run of least squares, which keeps the last motion that it accepted to go on from."""

    misfit: Misfit
    begun: Fitted
    near: Fitted = field(init=False)
    tried: dict[bytes, Fitted] = field(default_factory=dict)

    def __post_init__(self) -> None:
        self.near = self.begun
        self.tried[self.begun.coordinates.tobytes()] = self.begun

    def lowest(self) -> Fitted:
        from scipy.optimize import least_squares

        least, largest = bounds_of(self.misfit.model.unknowns)
        least_squares(
            self._residual,
            self.begun.coordinates,
            self._jacobian,
            bounds=(least, largest),
            x_scale="jac",
            xtol=1e-8,
            ftol=1e-6,
            gtol=1e-12,
            max_nfev=MOST_EVALUATIONS,
        )
        return min(self.tried.values(), key=lambda each: each.chi_square)

    def _residual(self, coordinates: Reals) -> Reals:
        fitted = self.tried.get(coordinates.tobytes()) or self.misfit.continued(coordinates.copy(), self.near)
        if fitted is None:
            size = LOST * np.sqrt(self.begun.chi_square / self.misfit.size)
            return np.full(self.misfit.size, max(size, LOST))
        self.tried[coordinates.tobytes()] = fitted
        return fitted.residual

    def _jacobian(self, coordinates: Reals) -> Reals:
        self.near = self.tried[coordinates.tobytes()]
        return self.misfit.jacobian(self.near)
