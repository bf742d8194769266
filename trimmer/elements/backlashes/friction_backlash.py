"""Friction-controlled backlash: the load stops as soon as it is not pushed."""

from dataclasses import dataclass
from typing import final

import numpy as np

from trimmer.arrays import Complexes, Reals
from trimmer.elements.backlashes.backlash import Backlash
from trimmer.elements.backlashes.backlash_bounds import PHASE_ERROR, ROUNDED_UP
from trimmer.elements.backlashes.backlash_motion import (
    GAMMA_LIMITS,
    SLOPE_BY_RATIO,
    BacklashMotion,
    complex_of,
    separation,
)
from trimmer.elements.element import Bounds, Limits
from trimmer.elements.expansion import Expansion
from trimmer.elements.small_arguments import argument_less_sine
from trimmer.elements.small_gains import SmallGains, small_gains_of_backlash

_LARGEST = np.finfo(float).max


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

    def _domain(self, omega: Reals) -> float:
        """Return 2: the load moves if the amplitude exceeds half of the gap."""
        return 2.0

    def _variation(self, u: Limits, omega: Limits) -> Bounds:
        """Return the change of dN/du = (2/π) exp(-jθ_c) with the impact at θ_c = π/2 + acos(1 - u); and 0."""
        earliest, latest = (np.arccos(1.0 - np.minimum(each, 2.0)) for each in u)
        return ROUNDED_UP * SLOPE_BY_RATIO * 2.0 * np.sin(0.5 * (latest - earliest + PHASE_ERROR)), 0.0

    def small_gains(self) -> SmallGains:
        """Tell that N falls to 0 along the negative imaginary axis."""
        return small_gains_of_backlash(0.0)

    def gamma(self, omega: Reals) -> Reals:
        """Return the lower one of ``GAMMA_LIMITS`` in place of 0, by which formulas would divide."""
        return np.full(omega.shape, GAMMA_LIMITS[0])

    def _describing_function(self, amplitude: Reals, omega: Reals, harmonic: int) -> Complexes:
        if harmonic == 1:
            return _fundamental(*self._half_contact(amplitude))
        return super()._describing_function(amplitude, omega, harmonic)

    def _expansion(self, amplitude: Reals, omega: Reals) -> Expansion:
        """Evaluate N_1 and dN_1/du = 2j exp(jl) / π, with l for the angle of contact."""
        sine, cosine = self._half_contact(amplitude)
        by_u = complex_of(-2.0 * SLOPE_BY_RATIO * sine * cosine, SLOPE_BY_RATIO * (cosine**2 - sine**2))
        return Expansion(_fundamental(sine, cosine), by_u, 0.0 * by_u)

    def _motion(self, amplitude: Reals, omega: Reals) -> BacklashMotion:
        """Find the steady motion: from the pin's peak on, the load rests for acos(1 - gap/amplitude)."""
        sine, cosine = self._half_contact(amplitude)
        flight, contact = 2.0 * np.arctan2(cosine, sine), 2.0 * np.arctan2(sine, cosine)
        gamma = self.gamma(omega)
        return BacklashMotion(gamma, *separation(gamma), flight, contact, 2.0 * sine * cosine)

    def _half_contact(self, amplitude: Reals) -> tuple[Reals, Reals]:
        """Find sine and cosine of half the angle of contact, each to full relative precision."""
        finite = np.minimum(amplitude, _LARGEST)
        half_gap = 0.5 * self.gap
        pushed = finite - half_gap
        pushed[pushed <= 0] = np.nan
        return np.sqrt(pushed / finite), np.sqrt(half_gap / finite)


def _fundamental(sine: Reals, cosine: Reals) -> Complexes:
    """Evaluate N_1 = (l - sin l cos l - j sin² l) / π from the sine and cosine of l/2, l in (0, π)."""
    twice_the_contact = 4.0 * np.arctan2(sine, cosine)
    real = argument_less_sine(twice_the_contact) / (2.0 * np.pi)
    return complex_of(real, -4.0 / np.pi * (sine * cosine) ** 2)
