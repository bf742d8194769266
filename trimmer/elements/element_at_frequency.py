"""An element frozen at one frequency."""

from __future__ import annotations

from dataclasses import dataclass
from typing import TYPE_CHECKING, final

import numpy as np

from trimmer.arguments import positive_number
from trimmer.elements.bounds import range_shape
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
class ElementAtFrequency(Element):
    """An element with its describing function at one omega taken for all omega.

    The thesis does so where N depends on frequency, and plots of one curve need it.

    Attributes:
        element: The element that is frozen.
        omega: Angular frequency that takes the place of any other, > 0, rad/s.

    Raises:
        ValueError: if omega is not positive and finite.
    """

    element: Element
    omega: float

    def __post_init__(self) -> None:
        object.__setattr__(self, "element", adopted("element", self.element))
        positive_number("omega", self.omega, "rad/s")

    @property
    def amplitude_scale(self) -> float:
        """The scale of the element, in the unit of the input."""
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
        """Return the supremum of u of the element at the frozen omega, in the shape of ``omega``."""
        return np.full(self._omegas(omega).shape, self.element.domain(self.omega))[()]

    def sensitivity(self, u_range: Range, omega_range: Range | None = None) -> GainSensitivity:
        """Return the element's bound of |dN/du| at the frozen omega, and 0 for |dN/d(ln omega)|."""
        shape = range_shape(u_range, omega_range)
        bound = self.element.sensitivity(u_range, (self.omega, self.omega))
        return GainSensitivity(np.broadcast_to(bound.by_u, shape)[()], np.zeros(shape)[()])

    def variation(self, u_range: Range, omega_range: Range | None = None) -> GainVariation:
        """Return the element's bound of the change of dN/du at the frozen omega, and 0 for the other one."""
        shape = range_shape(u_range, omega_range)
        bound = self.element.variation(u_range, (self.omega, self.omega))
        return GainVariation(np.broadcast_to(bound.by_u, shape)[()], np.zeros(shape)[()])

    def reach(self, u_range: Range, omega_range: Range | None = None) -> Reals | None:
        """Return the element's bound at the frozen omega."""
        bound = self.element.reach(u_range, (self.omega, self.omega))
        return None if bound is None else np.broadcast_to(bound, range_shape(u_range, omega_range))[()]

    def small_gains(self) -> SmallGains | None:
        """Return what is known of the element if that does not depend on omega."""
        small = self.element.small_gains()
        return small if small is not None and small.lag == 0 else None

    def mean_gain(self, amplitude: ArrayLike) -> Reals:
        """Return the gain of the element, which does not depend on omega."""
        return self.element.mean_gain(amplitude)

    def _describing_function(self, amplitude: Reals, omega: Reals, harmonic: int) -> Complexes:
        return self.element._describing_function(amplitude, self._frozen(amplitude), harmonic)

    def _waveform(self, phase: Reals, amplitude: Reals, omega: Reals) -> Reals:
        return self.element._waveform(phase, amplitude, self._frozen(amplitude))

    def _expansion(self, amplitude: Reals, omega: Reals) -> Expansion:
        frozen = self.element._expansion(amplitude, self._frozen(amplitude))
        return frozen._replace(by_log_omega=np.zeros(frozen.by_u.shape, dtype=complex))

    def _frozen(self, amplitude: Reals) -> Reals:
        return np.full(amplitude.shape, self.omega)
