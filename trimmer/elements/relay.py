"""Ideal relay."""

from __future__ import annotations

from dataclasses import dataclass
from typing import TYPE_CHECKING, final

import numpy as np

from trimmer.elements.arguments import require_positive
from trimmer.elements.bounds import constant_sensitivity, no_variation, unlimited_domain
from trimmer.elements.element import Derivatives, Element

if TYPE_CHECKING:
    from numpy.typing import ArrayLike, NDArray

    from trimmer.elements.element import Range, Sensitivity, Variation

    Reals = NDArray[np.float64]
    Complexes = NDArray[np.complex128]

SQUARE_WAVE = 4.0 / np.pi
"""First Fourier coefficient of a square wave between -1 and 1."""


@final
@dataclass(frozen=True)
class Relay(Element):
    """Ideal relay, y = level * sign(x): N_n = 4 level / (π n A) for odd n, at any amplitude.

    Source: Gelb and Vander Velde (1968); thesis, section 2.3.5.

    Attributes:
        level: Output while the input is positive, > 0, in the unit of the output.

    Raises:
        ValueError: if the level is not positive and finite; ``-Relay(level)`` has the other sign.
    """

    level: float

    def __post_init__(self) -> None:
        require_positive("level", self.level, "unit of the output")

    @property
    def depends_on_frequency(self) -> bool:
        """False."""
        return False

    @property
    def amplitude_scale(self) -> float:
        """The level: then N = (4/π) u with u = level / amplitude."""
        return self.level

    def domain(self, omega: ArrayLike | None = None) -> Reals:
        """Return infinity: any amplitude will do."""
        return unlimited_domain(self._omegas(omega))

    def sensitivity(self, u_range: Range, omega_range: Range | None = None) -> Sensitivity:
        """Return 4/π and 0."""
        return constant_sensitivity(SQUARE_WAVE, 0.0, u_range, omega_range)

    def variation(self, u_range: Range, omega_range: Range | None = None) -> Variation:
        """Return zeros: N is proportional to u."""
        return no_variation(u_range, omega_range)

    def _describing_function(self, amplitude: Reals, omega: Reals, harmonic: int) -> Complexes:
        return (SQUARE_WAVE / harmonic * self.level / amplitude).astype(complex)

    def _waveform(self, phase: Reals, amplitude: Reals, omega: Reals) -> Reals:
        return self.level * np.sign(np.sin(phase))

    def _derivatives(self, amplitude: Reals, omega: Reals) -> Derivatives:
        return Derivatives(
            np.full(amplitude.shape, SQUARE_WAVE + 0j), np.zeros(amplitude.shape, dtype=complex)
        )
