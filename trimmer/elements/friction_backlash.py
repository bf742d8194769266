"""Friction-controlled backlash."""

from __future__ import annotations

from dataclasses import dataclass
from typing import TYPE_CHECKING, final

import numpy as np

from trimmer.elements.backlash import Backlash
from trimmer.elements.backlash_motion import (
    GAMMA_LIMITS,
    BacklashMotion,
    complex_of,
    separation,
)
from trimmer.elements.small_arguments import argument_less_sine

if TYPE_CHECKING:
    from numpy.typing import NDArray

    Reals = NDArray[np.float64]
    Complexes = NDArray[np.complex128]


@final
@dataclass(frozen=True)
class FrictionBacklash(Backlash):
    """Backlash in front of a load that stops at once when it is not pushed (time constant M/D → 0).

    Domain: amplitude > gap/2. Source: Gelb and Vander Velde (1968); thesis, section 2.3.4.

    Attributes:
        gap: Total clearance, > 0, in the unit of the input (m).

    Raises:
        ValueError: if the gap is not positive and finite.
    """

    @property
    def depends_on_frequency(self) -> bool:
        """False."""
        return False

    def gamma(self, omega: Reals) -> Reals:
        """Return what stands for zero."""
        return np.full(omega.shape, GAMMA_LIMITS[0])

    def _describing_function(self, amplitude: Reals, omega: Reals, harmonic: int) -> Complexes:
        """Evaluate N_n; N_1 = (l - sin l cos l - j sin² l) / π, with l for the angle of contact."""
        if harmonic > 1:
            return super()._describing_function(amplitude, omega, harmonic)
        motion = self._motion(amplitude, omega)
        return complex_of(
            argument_less_sine(2.0 * motion.contact) / (2.0 * np.pi), -(motion.impact**2) / np.pi
        )

    def _motion(self, amplitude: Reals, omega: Reals) -> BacklashMotion:
        """Find the steady motion: from the pin's peak on, the load rests for acos(1 - gap/amplitude)."""
        finite = np.minimum(amplitude, np.finfo(float).max)
        half_gap = 0.5 * self.gap
        # Whichever angle is below a quarter period is found first, from its own sine.
        known = 2.0 * np.arcsin(np.sqrt(np.minimum(half_gap, finite - half_gap) / finite))
        known[finite <= half_gap] = np.nan
        brief_flight = finite > self.gap
        flight, contact = (np.where(flag, known, np.pi - known) for flag in (brief_flight, ~brief_flight))
        gamma = self.gamma(omega)
        return BacklashMotion(gamma, *separation(gamma), flight, contact, np.sin(known))
