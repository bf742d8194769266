"""The least misfit near a motion, with some coordinates held: Gauss-Newton steps with a kept derivative.

Near the best fit the derivative hardly changes, so it is taken anew only where a step does not do what it
says. So a profile costs few orbits.
"""

from __future__ import annotations

from typing import TYPE_CHECKING

import numpy as np

from trimmer.fitting.unknowns import bounds_of

if TYPE_CHECKING:
    from trimmer.arrays import Flags, Reals
    from trimmer.fitting.misfit import Fitted, Misfit

ENOUGH = 1e-2  # Decrease of chi-square that is not worth a step
MOST_STEPS = 15
LONGEST = 0.7  # Largest change of a coordinate in one step
SHORTEST = 0.05  # Share of a step that is tried at least
FAITHFUL = 0.5  # Share of what a step promises that it has to do, or the derivative is taken anew


def nearby_minimum(misfit: Misfit, fitted: Fitted, free: Flags, jacobian: Reals | None = None) -> Fitted:
    """Return the least misfit that is found from a motion over the free coordinates, (unknowns,)."""
    if not free.any():
        return fitted
    slope = misfit.jacobian(fitted, free) if jacobian is None else jacobian
    fresh = jacobian is None
    for _ in range(MOST_STEPS):
        step, promised = _step(misfit, fitted, slope, free)
        trial = _tried(misfit, fitted, step) if promised > ENOUGH else None
        if fresh and trial is None:
            break
        fresh = trial is None or fitted.chi_square - trial.chi_square < FAITHFUL * promised
        fitted = fitted if trial is None else trial
        if fresh:
            slope = misfit.jacobian(fitted, free)
    return fitted


def _step(misfit: Misfit, fitted: Fitted, slope: Reals, free: Flags) -> tuple[Reals, float]:
    """Return the step of Gauss and Newton within the bounds, and the decrease of chi-square it promises."""
    least, largest = bounds_of(misfit.model.unknowns)
    step = np.zeros(len(free))
    step[free] = np.linalg.lstsq(slope[:, free], -fitted.residual, rcond=1e-9)[0]
    step *= min(1.0, LONGEST / max(float(abs(step).max()), 1e-300))
    step = np.clip(fitted.coordinates + step, least, largest) - fitted.coordinates
    after = fitted.residual + slope @ step
    return step, fitted.chi_square - float(after @ after)


def _tried(misfit: Misfit, fitted: Fitted, step: Reals) -> Fitted | None:
    """Return what a step leads to, shortened until it reduces the misfit; None if nothing does."""
    share = 1.0
    while share >= SHORTEST:
        trial = misfit.continued(fitted.coordinates + share * step, fitted)
        if trial is not None and trial.chi_square < fitted.chi_square:
            return trial
        share *= 0.4
    return None
