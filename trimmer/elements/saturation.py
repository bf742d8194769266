"""Saturation: proportional up to a threshold, constant beyond it."""

from dataclasses import dataclass
from typing import final

import numpy as np

from trimmer.arrays import Complexes, Reals
from trimmer.elements.corners import CornerElement, clipped_fundamental, clipped_harmonic, corner_share
from trimmer.elements.small_gains import SmallGains, real_small_gains


@final
@dataclass(frozen=True)
class Saturation(CornerElement):
    """Saturation, y = slope * x up to |x| = threshold, and slope * threshold * sign(x) beyond.

    With sin α = threshold/A, N = slope (2α + sin 2α) / π for A >= threshold, and the slope below. Source:
    Gelb and Vander Velde, Multiple-Input Describing Functions (1968), section 2.3 and appendix B; Slotine and
    Li, Applied Nonlinear Control (1991), section 5.2.

    Attributes:
        threshold: Input from which on the output is constant, > 0, in the unit of the input.
        slope: Output per input below the threshold, > 0.

    Raises:
        ValueError: if either is not positive and finite; ``-Saturation(threshold)`` has the other sign.
    """

    _direction = 1.0

    def small_gains(self) -> SmallGains:
        """Tell that N is real and positive at all amplitudes."""
        return real_small_gains(self.slope)

    def _mean_gain(self, amplitude: Reals) -> Reals:
        """Return the slope times 2α/π, the share of the time below the threshold."""
        return self.slope * corner_share(self, amplitude)

    def _describing_function(self, amplitude: Reals, omega: Reals, harmonic: int) -> Complexes:
        gain = (
            clipped_fundamental(self, amplitude)
            if harmonic == 1
            else clipped_harmonic(self, amplitude, harmonic)
        )
        return np.asarray(self.slope * gain, dtype=complex)

    def _waveform(self, phase: Reals, amplitude: Reals, omega: Reals) -> Reals:
        clipped = np.clip(amplitude * np.sin(phase), -self.threshold, self.threshold)
        return np.asarray(self.slope * clipped)
