"""Viscous friction with a displacement as its input: a linear element, for sums with nonlinear ones."""

from dataclasses import dataclass
from typing import final

import numpy as np

from trimmer.arguments import positive_number
from trimmer.arrays import Complexes, Reals
from trimmer.elements.element import Bounds, Element, Limits
from trimmer.elements.expansion import Expansion


@final
@dataclass(frozen=True)
class ViscousFriction(Element):
    """Viscous friction, F = damping * dx/dt, of a displacement x: N = j omega damping; no higher harmonics.

    Attributes:
        damping: Coefficient of viscous friction, > 0, N s/m.

    Raises:
        ValueError: if the damping is not positive and finite.
    """

    damping: float

    depends_on_frequency = True
    """True: N = j omega damping."""
    amplitude_scale = 1.0
    """1: a linear element has no amplitude of its own."""

    def __post_init__(self) -> None:
        positive_number("damping", self.damping, "N s/m")

    def _sensitivity(self, u: Limits, omega: Limits) -> Bounds:
        """Return 0 for |dN/du|, and the damping times the upper omega for |dN/d(ln omega)|, N/m."""
        return 0.0, self.damping * omega[1]

    def _variation(self, u: Limits, omega: Limits) -> Bounds:
        """Return 0 for the change of dN/du, and the damping times the width in omega for the other, N/m."""
        return 0.0, self.damping * (omega[1] - omega[0])

    def _mean_gain(self, amplitude: Reals) -> float:
        """Return 0: a mean of the displacement does not change its velocity, hence not the force."""
        return 0.0

    def _describing_function(self, amplitude: Reals, omega: Reals, harmonic: int) -> Complexes:
        return 1j * (self.damping * omega if harmonic == 1 else 0.0 * omega).astype(complex)

    def _waveform(self, phase: Reals, amplitude: Reals, omega: Reals) -> Reals:
        return self.damping * omega * amplitude * np.cos(phase)

    def _expansion(self, amplitude: Reals, omega: Reals) -> Expansion:
        value = 1j * (self.damping * omega).astype(complex)
        return Expansion(value, np.zeros(amplitude.shape, dtype=complex), value.copy())
