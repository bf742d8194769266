"""Coulomb friction with a displacement as its input."""

from __future__ import annotations

from dataclasses import dataclass
from typing import TYPE_CHECKING, final

import numpy as np

from trimmer.elements.arguments import require_positive
from trimmer.elements.bounds import constant_sensitivity, no_variation, unlimited_domain
from trimmer.elements.element import Derivatives, Element
from trimmer.elements.relay import SQUARE_WAVE

if TYPE_CHECKING:
    from numpy.typing import ArrayLike, NDArray

    from trimmer.elements.element import Range, Sensitivity, Variation

    Reals = NDArray[np.float64]
    Complexes = NDArray[np.complex128]


@final
@dataclass(frozen=True)
class CoulombFriction(Element):
    """Coulomb friction, F = force * sign(dx/dt), of a displacement x: N = j 4 force / (π A) at any amplitude.

    The harmonics are N_n = ±j 4 force / (π n A), + for n = 1, 5, 9 and - for n = 3, 7, 11. With a velocity as
    its input it is a ``Relay``. Source: thesis, section 2.3.5 (equations 2.48 to 2.52), with the sign of a
    displacement as the input.

    Attributes:
        force: Friction force, > 0, N.

    Raises:
        ValueError: if the force is not positive and finite.
    """

    force: float

    def __post_init__(self) -> None:
        require_positive("force", self.force, "N")

    @property
    def depends_on_frequency(self) -> bool:
        """False."""
        return False

    @property
    def amplitude_scale(self) -> float:
        """The force: then N = j (4/π) u with u = force / amplitude, N/m."""
        return self.force

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
        sign = 1.0 if harmonic % 4 == 1 else -1.0
        return 1j * (sign * SQUARE_WAVE / harmonic * self.force / amplitude).astype(complex)

    def _waveform(self, phase: Reals, amplitude: Reals, omega: Reals) -> Reals:
        return self.force * np.sign(np.cos(phase))

    def _derivatives(self, amplitude: Reals, omega: Reals) -> Derivatives:
        return Derivatives(
            np.full(amplitude.shape, 1j * SQUARE_WAVE), np.zeros(amplitude.shape, dtype=complex)
        )
