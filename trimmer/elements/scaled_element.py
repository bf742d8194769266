"""An element with a factor on its output."""

import math
from dataclasses import dataclass
from typing import cast, final

from trimmer.arguments import real_number
from trimmer.arrays import Complexes, Reals
from trimmer.elements.control_element import adopted
from trimmer.elements.derived_element import DerivedElement
from trimmer.elements.element import Bounds, Element, Limits
from trimmer.elements.expansion import Expansion
from trimmer.elements.small_gains import SmallGains
from trimmer.errors import WrongTypeError


@final
@dataclass(frozen=True)
class ScaledElement(DerivedElement):
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
        if isinstance(cast("object", self.factor), Element):
            raise WrongTypeError(
                "a product of elements is no element; those that act one after the other, with a lag between "
                "them, go into trimmer.Feedback(plant, {name: element})"
            )
        if not math.isfinite(real_number("factor", self.factor)) or self.factor == 0:
            raise ValueError(f"factor must be finite and not zero, not {self.factor!r}")

    @property
    def _source(self) -> Element:
        return self.element

    def small_gains(self) -> SmallGains | None:
        """Return what is known of the element, scaled."""
        small = super().small_gains()
        return None if small is None else small.scaled(self.factor)

    def _sensitivity(self, u: Limits, omega: Limits) -> Bounds:
        by_u, by_log_omega = super()._sensitivity(u, omega)
        return abs(self.factor) * by_u, abs(self.factor) * by_log_omega

    def _variation(self, u: Limits, omega: Limits) -> Bounds:
        by_u, by_log_omega = super()._variation(u, omega)
        return abs(self.factor) * by_u, abs(self.factor) * by_log_omega

    def _reach(self, u: Limits, omega: Limits) -> Reals:
        return abs(self.factor) * super()._reach(u, omega)

    def _mean_gain(self, amplitude: Reals) -> Reals | float:
        return self.factor * super()._mean_gain(amplitude)

    def _describing_function(self, amplitude: Reals, omega: Reals, harmonic: int) -> Complexes:
        return self.factor * super()._describing_function(amplitude, omega, harmonic)

    def _waveform(self, phase: Reals, amplitude: Reals, omega: Reals) -> Reals:
        return self.factor * super()._waveform(phase, amplitude, omega)

    def _expansion(self, amplitude: Reals, omega: Reals) -> Expansion:
        return Expansion(*(self.factor * part for part in super()._expansion(amplitude, omega)))
