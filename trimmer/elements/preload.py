"""Preload: a spring that is prestressed both ways, so that its force jumps where the input is zero."""

from dataclasses import dataclass
from typing import final

import numpy as np

from trimmer.arguments import positive_number
from trimmer.arrays import Complexes, Reals
from trimmer.elements.square_wave import IdealRelay


@final
@dataclass(frozen=True)
class Preload(IdealRelay):
    """Preload, y = slope * x + level * sign(x): N = slope + 4 level / (π A), N_n = 4 level / (π n A).

    It is a ``Relay`` beside a gain; harmonic balance moves the gain to the linear system. Source: Gelb and
    Vander Velde, Multiple-Input Describing Functions (1968), appendix B; Atherton, Nonlinear Control
    Engineering (1975), chapter 3.

    Attributes:
        level: Output for a small positive input, > 0, in the unit of the output.
        slope: Output per input beyond that, > 0.

    Raises:
        ValueError: if either is not positive and finite; without slope it is a ``Relay``.
    """

    slope: float

    def __post_init__(self) -> None:
        positive_number("level", self.level, "unit of the output")
        positive_number("slope", self.slope, "output per input")

    def _mean_gain(self, amplitude: Reals) -> Reals:
        """Return slope + 2 level / (π A): that of the relay and of the gain together."""
        return self.slope + super()._mean_gain(amplitude)

    def _describing_function(self, amplitude: Reals, omega: Reals, harmonic: int) -> Complexes:
        of_relay = super()._describing_function(amplitude, omega, harmonic)
        return of_relay + self.slope if harmonic == 1 else of_relay

    def _waveform(self, phase: Reals, amplitude: Reals, omega: Reals) -> Reals:
        return self.slope * amplitude * np.sin(phase) + super()._waveform(phase, amplitude, omega)
