"""Dead zone: no output up to a threshold, proportional beyond it."""

from dataclasses import dataclass
from typing import final

import numpy as np

from trimmer.arrays import Complexes, Reals
from trimmer.elements.corners import CornerElement, clipped_harmonic, corner_share, missing_fundamental
from trimmer.elements.small_gains import SmallGains, real_small_gains


@final
@dataclass(frozen=True)
class DeadZone(CornerElement):
    """Dead zone, y = 0 up to |x| = threshold, and slope * (x - threshold * sign(x)) beyond.

    With cos β = threshold/A, N = slope (2β - sin 2β) / π for A >= threshold, and zero below: it is the slope
    less the N of a ``Saturation``. The zone is 2 threshold wide. Source: Gelb and Vander Velde,
    Multiple-Input Describing Functions (1968), section 2.3 and appendix B; Slotine and Li, Applied Nonlinear
    Control (1991), section 5.2.

    Attributes:
        threshold: Input from which on there is an output, half the width of the zone, > 0, in the unit of the
            input.
        slope: Output per input beyond the threshold, > 0.

    Raises:
        ValueError: if either is not positive and finite; ``-DeadZone(threshold)`` has the other sign.
    """

    _direction = -1.0

    def small_gains(self) -> SmallGains:
        """Tell that N is real and positive wherever it is not zero."""
        return real_small_gains(self.slope)

    def _mean_gain(self, amplitude: Reals) -> Reals:
        """Return the slope times the share of the time beyond the threshold."""
        return self.slope * (1.0 - corner_share(self, amplitude))

    def _describing_function(self, amplitude: Reals, omega: Reals, harmonic: int) -> Complexes:
        gain = (
            missing_fundamental(self, amplitude)
            if harmonic == 1
            else -clipped_harmonic(self, amplitude, harmonic)
        )
        return np.asarray(self.slope * gain, dtype=complex)

    def _waveform(self, phase: Reals, amplitude: Reals, omega: Reals) -> Reals:
        given = amplitude * np.sin(phase)
        return np.asarray(self.slope * (given - np.clip(given, -self.threshold, self.threshold)))
