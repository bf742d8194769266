"""The common base of friction-, inertia- and viscous-controlled backlash."""

from abc import abstractmethod
from dataclasses import dataclass

import numpy as np

from trimmer.arguments import positive_number
from trimmer.arrays import Complexes, Reals
from trimmer.elements.backlashes.backlash_bounds import BacklashBox
from trimmer.elements.backlashes.backlash_frequency import slope_by_log_gamma
from trimmer.elements.backlashes.backlash_harmonics import harmonic_of
from trimmer.elements.backlashes.backlash_motion import (
    SLOPE_BY_RATIO,
    BacklashMotion,
    fundamental,
    position,
    slope_by_ratio,
)
from trimmer.elements.backlashes.contact_equation import largest_ratio, steady_motion
from trimmer.elements.element import Bounds, Element, Limits
from trimmer.elements.expansion import Expansion


@dataclass(frozen=True)
class Backlash(Element):
    """Backlash in front of a load M v' + D v = 0 with u = gap / amplitude; N is a number (m/m).

    Raises:
        ValueError: if the gap is not positive and finite.
    """

    gap: float  # Total clearance, > 0, in the unit of the input (m)

    def __post_init__(self) -> None:
        positive_number("gap", self.gap, "m")

    @property
    def amplitude_scale(self) -> float:
        """The gap, in the unit of the input (m): N depends on gap/amplitude alone."""
        return self.gap

    @abstractmethod
    def gamma(self, omega: Reals) -> Reals:
        """Return omega M/D, a number, at each omega (rad/s, any shape), limited to ``GAMMA_LIMITS``."""

    def _domain(self, omega: Reals) -> Reals | float:
        """Return the largest gap/amplitude, (2 + gamma² (1 - exp(-π/gamma))) / sqrt(1 + gamma²)."""
        return largest_ratio(self.gamma(omega))

    def _sensitivity(self, u: Limits, omega: Limits) -> Bounds:
        """Return 2/π, which is |dN/du| everywhere, and a bound that follows from the longest flight."""
        dependent = self.depends_on_frequency
        return SLOPE_BY_RATIO, self._box(u, omega).slope_by_log_gamma() if dependent else 0.0

    def _variation(self, u: Limits, omega: Limits) -> Bounds:
        """Return bounds that follow from the range of the impact's phase."""
        box = self._box(u, omega)
        by_log_gamma = box.change_of_slope_by_log_gamma() if self.depends_on_frequency else 0.0
        return box.change_of_slope_by_ratio(), by_log_gamma

    def _mean_gain(self, amplitude: Reals) -> float:
        """Return 1: the load follows the mean of the pin, wherever that is."""
        return 1.0

    def _box(self, u: Limits, omega: Limits) -> BacklashBox:
        # Both impacts in one go: the solver takes little longer for them than for one.
        ratios, omegas = np.concatenate(u), np.concatenate(omega[::-1])
        earliest, latest = self._motion(self.gap / ratios, omegas).impact_phase.reshape(2, -1)
        highest_gamma, lowest_gamma = self.gamma(omegas).reshape(2, -1)
        return BacklashBox(lowest_gamma, highest_gamma, earliest, latest)

    def _motion(self, amplitude: Reals, omega: Reals) -> BacklashMotion:
        """Find the steady motion at arrays of one dimension and equal size; NaN where there is none."""
        return steady_motion(self.gap, amplitude, self.gamma(omega))

    def _describing_function(self, amplitude: Reals, omega: Reals, harmonic: int) -> Complexes:
        motion = self._motion(amplitude, omega)
        return fundamental(motion) if harmonic == 1 else harmonic_of(motion, harmonic)

    def _waveform(self, phase: Reals, amplitude: Reals, omega: Reals) -> Reals:
        return position(self._motion(amplitude, omega), phase, amplitude, self.gap)

    def _expansion(self, amplitude: Reals, omega: Reals) -> Expansion:
        motion = self._motion(amplitude, omega)
        by_u = slope_by_ratio(motion)
        by_log_omega = slope_by_log_gamma(motion) if self.depends_on_frequency else 0.0 * by_u
        return Expansion(fundamental(motion), by_u, by_log_omega)
