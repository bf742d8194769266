"""Preload: a spring that is prestressed both ways, so that its force jumps where the input is zero."""

from __future__ import annotations

from dataclasses import dataclass
from typing import TYPE_CHECKING, final

import numpy as np

from trimmer.arguments import positive_number
from trimmer.elements.arguments import positive_amplitudes
from trimmer.elements.bounds import constant_sensitivity, no_variation, unlimited_domain
from trimmer.elements.element import Element
from trimmer.elements.expansion import Expansion
from trimmer.elements.square_wave import FUNDAMENTAL

if TYPE_CHECKING:
    from numpy.typing import ArrayLike

    from trimmer.arrays import Complexes, Reals
    from trimmer.elements.element import Range
    from trimmer.elements.expansion import Sensitivity, Variation


@final
@dataclass(frozen=True)
class Preload(Element):
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

    level: float
    slope: float

    def __post_init__(self) -> None:
        positive_number("level", self.level, "unit of the output")
        positive_number("slope", self.slope, "output per input")

    @property
    def depends_on_frequency(self) -> bool:
        """False: the output follows the input without memory."""
        return False

    @property
    def amplitude_scale(self) -> float:
        """The level, so that N = slope + (4/π) u; only its number counts, not its unit."""
        return self.level

    def domain(self, omega: ArrayLike | None = None) -> Reals:
        """Return infinity: any amplitude will do."""
        return unlimited_domain(self._omegas(omega))

    def sensitivity(self, u_range: Range, omega_range: Range | None = None) -> Sensitivity:
        """Return 4/π for |dN/du| and 0 for |dN/d(ln omega)|: N is linear in u."""
        return constant_sensitivity(FUNDAMENTAL, 0.0, u_range, omega_range)

    def variation(self, u_range: Range, omega_range: Range | None = None) -> Variation:
        """Return zeros: N is linear in u."""
        return no_variation(u_range, omega_range)

    def mean_gain(self, amplitude: ArrayLike) -> Reals:
        """Return slope + 2 level / (π A): that of the relay and of the gain together."""
        return np.asarray(self.slope + 2.0 * self.level / (np.pi * positive_amplitudes(amplitude)))[()]

    def _describing_function(self, amplitude: Reals, omega: Reals, harmonic: int) -> Complexes:
        gain = self.slope if harmonic == 1 else 0.0
        return (gain + FUNDAMENTAL / harmonic * self.level / amplitude).astype(complex)

    def _waveform(self, phase: Reals, amplitude: Reals, omega: Reals) -> Reals:
        given = np.sin(phase)
        return np.asarray(self.slope * amplitude * given + self.level * np.sign(given))

    def _expansion(self, amplitude: Reals, omega: Reals) -> Expansion:
        value = self._describing_function(amplitude, omega, 1)
        return Expansion(value, np.full_like(value, FUNDAMENTAL), np.zeros_like(value))
