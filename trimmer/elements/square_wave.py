"""The common base of relay, preload and Coulomb friction: an output that switches between two values."""

from __future__ import annotations

from abc import abstractmethod
from typing import TYPE_CHECKING, ClassVar

import numpy as np

from trimmer.elements.bounds import constant_sensitivity, no_variation
from trimmer.elements.element import Element
from trimmer.elements.expansion import Expansion

if TYPE_CHECKING:
    from trimmer.arrays import Complexes, Reals
    from trimmer.elements.element import Range
    from trimmer.elements.expansion import GainSensitivity, GainVariation


FUNDAMENTAL = 4.0 / np.pi
"""First Fourier coefficient of a square wave between -1 and 1."""


class SquareWaveElement(Element):
    """An element whose output is a square wave of one height for any input A sin θ; a gain may be beside it.

    With u = height / A and the lead φ of the output, N_n = (4/(π n)) exp(jnφ) u for odd n.
    """

    LEAD: ClassVar[complex]
    """exp(jφ) with the lead φ of the output over the input."""

    @property
    @abstractmethod
    def height(self) -> float:
        """Output in its positive half period, > 0, in the unit of the output."""

    @property
    def amplitude_scale(self) -> float:
        """The height of the output, so that N = (4/π) exp(jφ) u; only its number counts, not its unit."""
        return self.height

    def sensitivity(self, u_range: Range, omega_range: Range | None = None) -> GainSensitivity:
        """Return 4/π for |dN/du| and 0 for |dN/d(ln omega)|: N is linear in u."""
        return constant_sensitivity(FUNDAMENTAL, 0.0, u_range, omega_range)

    def variation(self, u_range: Range, omega_range: Range | None = None) -> GainVariation:
        """Return zeros: N is linear in u."""
        return no_variation(u_range, omega_range)

    def _describing_function(self, amplitude: Reals, omega: Reals, harmonic: int) -> Complexes:
        return self.LEAD**harmonic * (FUNDAMENTAL / harmonic * self.height / amplitude).astype(complex)

    def _expansion(self, amplitude: Reals, omega: Reals) -> Expansion:
        value = self._describing_function(amplitude, omega, 1)
        return Expansion(value, np.full_like(value, self.LEAD * FUNDAMENTAL), np.zeros_like(value))
