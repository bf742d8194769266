"""Ideal relay, and with it Coulomb friction of a velocity."""

from __future__ import annotations

from dataclasses import dataclass
from typing import TYPE_CHECKING, ClassVar, final

import numpy as np

from trimmer.arguments import positive_number
from trimmer.elements.arguments import positive_amplitudes
from trimmer.elements.square_wave import SquareWaveElement

if TYPE_CHECKING:
    from numpy.typing import ArrayLike

    from trimmer.arrays import Reals


@final
@dataclass(frozen=True)
class Relay(SquareWaveElement):
    """Ideal relay, y = level * sign(x): N_n = 4 level / (π n A) for odd n, at any amplitude.

    Source: Gelb and Vander Velde (1968); thesis, section 2.3.5.

    Attributes:
        level: Output while the input is positive, > 0, in the unit of the output.

    Raises:
        ValueError: if the level is not positive and finite; ``-Relay(level)`` has the other sign.
    """

    level: float
    LEAD: ClassVar[complex] = 1.0

    def __post_init__(self) -> None:
        positive_number("level", self.level, "unit of the output")

    @property
    def height(self) -> float:
        """The level, in the unit of the output."""
        return self.level

    def mean_gain(self, amplitude: ArrayLike) -> Reals:
        """Return 2 level / (π A), half of N_1: the mean output is (2/π) level asin(b/A)."""
        return np.asarray(2.0 * self.level / (np.pi * positive_amplitudes(amplitude)))[()]

    def _waveform(self, phase: Reals, amplitude: Reals, omega: Reals) -> Reals:
        return self.level * np.sign(np.sin(phase))
