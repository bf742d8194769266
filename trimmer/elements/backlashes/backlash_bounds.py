"""Bounds of the derivatives of backlash's describing function on boxes of g/A and gamma = omega M/D.

They rest on the phase of the impact, θ_c = atan(1/gamma) + flight. It rises with g/A. It falls with gamma at
constant g/A: at any phase of the flight the derivative of the load's position by gamma is not negative, so
the load meets the wall sooner. So it is earliest at the lowest g/A and the highest gamma, and latest at the
other two limits. All bounds are rounded upwards.
"""

from dataclasses import dataclass

import numpy as np

from trimmer.arrays import Reals
from trimmer.elements.backlashes.backlash_motion import SLOPE_BY_RATIO

ROUNDED_UP = 1.0 + 1e-9  # Factor that outweighs the rounding errors of a bound
LARGEST_LAG = 0.29844  # Upper bound of (1 - (1 + x) exp(-x)) / x for x > 0; the maximum is at x = 1.7933
PHASE_ERROR = 1e-9  # More than the error of a computed θ_c, rad


@dataclass(frozen=True)
class BacklashBox:
    """Boxes of g/A and gamma, all arrays of one dimension and equal size."""

    lowest_gamma: Reals  # Lower limit of gamma, within ``GAMMA_LIMITS``
    highest_gamma: Reals  # Upper limit of gamma
    earliest_impact: Reals  # θ_c at the lower limit of g/A and the upper one of gamma; NaN outside the domain
    latest_impact: Reals  # θ_c at the upper limit of g/A and the lower one of gamma; NaN outside the domain

    def slope_by_log_gamma(self) -> Reals:
        """Bound |dN/d(ln gamma)| on each box, shape (n,).

        The modulus is at most (2/π) cos θ_s ∫ k(s) ds over the flight, with the k of backlash_frequency.py.
        With x = s/gamma, k(s) = (s²/gamma) f(x) and f(x) = (1 - (1 + x) exp(-x)) / x², which falls from 1/2
        with x. So cos θ_s k(s) = sin θ_s s² f(x) is at most the sin θ_s of the lowest gamma times the s² f(x)
        of the highest. It is also at most ``LARGEST_LAG`` s times the cos θ_s of the highest gamma, as x f(x)
        is at most that. The smaller bound is returned.
        """
        flight, gamma = self._longest_flight(), self.highest_gamma
        decay = flight / gamma
        exact = gamma**2 * (flight * (1.0 + np.exp(-decay)) + 2.0 * gamma * np.expm1(-decay))
        # The difference loses its digits where the simple bound f <= 1/2 is within 1 %.
        moment = np.where(decay < 0.01, flight**3 / 6.0, exact)
        falling = moment / np.hypot(1.0, self.lowest_gamma)
        rising = 0.5 * LARGEST_LAG * flight**2 * gamma / np.hypot(1.0, gamma)
        return ROUNDED_UP * SLOPE_BY_RATIO * np.minimum(falling, rising)

    def change_of_slope_by_ratio(self) -> Reals:
        """Bound the change of dN/d(g/A) = (2/π) exp(-jθ_c) between two points of each box, shape (n,)."""
        angle = np.minimum(self._impact_range(), np.pi)
        return ROUNDED_UP * SLOPE_BY_RATIO * 2.0 * np.sin(0.5 * angle)

    def change_of_slope_by_log_gamma(self) -> Reals:
        """Bound the change of dN/d(ln gamma) between two points of each box, shape (n,).

        The derivative is (2j/π) ∫ p exp(-jθ) dθ from θ_s to θ_c, with p = cos θ_s k(θ - θ_s), zero at θ_s. So
        it changes by at most (2/π) (max p times the range of θ_c + max |dp/d(ln gamma)| times the longest
        flight and the range of ln gamma). With h(x) = 1 - (1 + x) exp(-x) and x = (θ - θ_s)/gamma:
        p = gamma cos θ_s h(x),
        dp/d(ln gamma) = gamma cos θ_s ((1 + sin² θ_s) h(x) + (sin² θ_s - x) x exp(-x)).
        """
        flight = self._longest_flight()
        decay = flight / self.lowest_gamma
        scale = self.highest_gamma * self.highest_gamma / np.hypot(1.0, self.highest_gamma)
        sine_squared = 1.0 / (1.0 + self.lowest_gamma**2)
        lag = np.minimum(1.0, np.minimum(LARGEST_LAG * decay, 0.5 * decay**2))
        # max x exp(-x) = 1/e and max x² exp(-x) = 4/e²
        drift = np.maximum(
            sine_squared * np.minimum(decay, np.exp(-1.0)), np.minimum(decay**2, 4.0 * np.exp(-2.0))
        )
        bend = (1.0 + sine_squared) * lag + drift
        log_range = np.log(self.highest_gamma / self.lowest_gamma)
        change = lag * self._impact_range() + bend * flight * log_range
        return np.asarray(ROUNDED_UP * SLOPE_BY_RATIO * scale * change)

    def _latest(self) -> Reals:
        """Largest θ_c; outside the domain the flight is taken as π."""
        beyond = np.arctan(1.0 / self.lowest_gamma) + np.pi
        return np.where(np.isnan(self.latest_impact), beyond, self.latest_impact)

    def _impact_range(self) -> Reals:
        """Bound the range of θ_c; a box wholly outside the domain has the flight start at once."""
        at_once = np.arctan(1.0 / self.highest_gamma)
        earliest = np.where(np.isnan(self.earliest_impact), at_once, self.earliest_impact)
        return np.asarray(self._latest() - earliest + PHASE_ERROR)

    def _longest_flight(self) -> Reals:
        return np.minimum(self._latest() - np.arctan(1.0 / self.highest_gamma) + PHASE_ERROR, np.pi)
