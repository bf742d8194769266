"""An element with a factor on its output."""

from __future__ import annotations

import math
from dataclasses import dataclass
from typing import TYPE_CHECKING, final

from trimmer.arguments import real_number
from trimmer.elements.control_element import adopted
from trimmer.elements.element import Element
from trimmer.elements.expansion import Expansion, GainSensitivity, GainVariation

if TYPE_CHECKING:
    from numpy.typing import ArrayLike

    from trimmer.arrays import Complexes, Reals
    from trimmer.elements.element import Range
    from trimmer.elements.small_gains import SmallGains


@final
@dataclass(frozen=True)
class ScaledElement(Element):
    """An element whose output is multiplied by a factor, and so is its describing function of each harmonic.

    Attributes:
        element: The element that is scaled.
        factor: Finite and not zero, of any sign; if it has a unit, that multiplies the unit of the output.

    Raises:
        ValueError: if the factor is zero, infinite or NaN.
    """

    element: Element
    factor: float

    def __post_init__(self) -> None:
        object.__setattr__(self, "element", adopted("element", self.element))
        if not math.isfinite(real_number("factor", self.factor)) or self.factor == 0:
            raise ValueError(f"factor must be finite and not zero, not {self.factor!r}")

    @property
    def depends_on_frequency(self) -> bool:
        """Whether the scaled element depends on frequency."""
        return self.element.depends_on_frequency

    @property
    def amplitude_scale(self) -> float:
        """The scale of the element: a factor on the output leaves the input alone."""
        return self.element.amplitude_scale

    @property
    def has_bounds(self) -> bool:
        """Whether the element has bounds."""
        return self.element.has_bounds

    @property
    def constant_from(self) -> float:
        """The u from which on N of the element does not change any more."""
        return self.element.constant_from

    def domain(self, omega: ArrayLike | None = None) -> Reals:
        """Return the supremum of u of the element, which the factor leaves alone."""
        return self.element.domain(omega)

    def sensitivity(self, u_range: Range, omega_range: Range | None = None) -> GainSensitivity:
        """Return the bounds of the element times the modulus of the factor."""
        bound = self.element.sensitivity(u_range, omega_range)
        return GainSensitivity(abs(self.factor) * bound.by_u, abs(self.factor) * bound.by_log_omega)

    def variation(self, u_range: Range, omega_range: Range | None = None) -> GainVariation:
        """Return the bounds of the element times the modulus of the factor."""
        bound = self.element.variation(u_range, omega_range)
        return GainVariation(abs(self.factor) * bound.by_u, abs(self.factor) * bound.by_log_omega)

    def reach(self, u_range: Range, omega_range: Range | None = None) -> Reals | None:
        """Return the bound of the element times the modulus of the factor."""
        bound = self.element.reach(u_range, omega_range)
        return None if bound is None else abs(self.factor) * bound

    def small_gains(self) -> SmallGains | None:
        """Return what is known of the element, scaled."""
        small = self.element.small_gains()
        return None if small is None else small.scaled(self.factor)

    def mean_gain(self, amplitude: ArrayLike) -> Reals:
        """Return the gain of the element times the factor."""
        return self.factor * self.element.mean_gain(amplitude)

    def _describing_function(self, amplitude: Reals, omega: Reals, harmonic: int) -> Complexes:
        return self.factor * self.element._describing_function(amplitude, omega, harmonic)

    def _waveform(self, phase: Reals, amplitude: Reals, omega: Reals) -> Reals:
        return self.factor * self.element._waveform(phase, amplitude, omega)

    def _expansion(self, amplitude: Reals, omega: Reals) -> Expansion:
        return Expansion(*(self.factor * part for part in self.element._expansion(amplitude, omega)))
