"""The common base of relay, preload and Coulomb friction: an output that switches between two values."""

from abc import abstractmethod
from dataclasses import dataclass
from typing import ClassVar

import numpy as np

from trimmer.arrays import Complexes, Reals
from trimmer.elements.element import Bounds, Element, Limits
from trimmer.elements.expansion import Expansion

FUNDAMENTAL = 4.0 / np.pi  # First Fourier coefficient of a square wave between -1 and 1


class SquareWaveElement(Element):
    """An element whose output is a square wave of one height for any input A sin θ; a gain may be beside it.

    With u = height / A and the lead φ of the output, N_n = (4/(π n)) exp(jnφ) u for odd n.
    """

    LEAD: ClassVar[complex]  # exp(jφ) with the lead φ of the output over the input

    @property
    @abstractmethod
    def height(self) -> float:
        """Output in its positive half period, > 0, in the unit of the output."""

    @property
    def amplitude_scale(self) -> float:
        """The height of the output, so that N = (4/π) exp(jφ) u; only its number counts, not its unit."""
        return self.height

    def _sensitivity(self, u: Limits, omega: Limits) -> Bounds:
        """Return 4/π for |dN/du| and 0 for |dN/d(ln omega)|: N is linear in u."""
        return FUNDAMENTAL, 0.0

    def _variation(self, u: Limits, omega: Limits) -> Bounds:
        """Return zeros: N is linear in u."""
        return 0.0, 0.0

    def _describing_function(self, amplitude: Reals, omega: Reals, harmonic: int) -> Complexes:
        return self.LEAD**harmonic * (FUNDAMENTAL / harmonic * self.height / amplitude).astype(complex)

    def _expansion(self, amplitude: Reals, omega: Reals) -> Expansion:
        value = self._describing_function(amplitude, omega, 1)
        return Expansion(value, np.full_like(value, self.LEAD * FUNDAMENTAL), np.zeros_like(value))


@dataclass(frozen=True)
class IdealRelay(SquareWaveElement):
    """A relay without thresholds, y = level * sign(x), with a level > 0."""

    level: float
    LEAD: ClassVar[complex] = 1.0

    @property
    def height(self) -> float:
        """The level, in the unit of the output."""
        return self.level

    def _mean_gain(self, amplitude: Reals) -> Reals:
        """Return 2 level / (π A), half of N_1: the mean output is (2/π) level asin(b/A)."""
        return np.asarray(2.0 * self.level / (np.pi * amplitude))

    def _waveform(self, phase: Reals, amplitude: Reals, omega: Reals) -> Reals:
        return np.asarray(self.level * np.sign(np.sin(phase)))
