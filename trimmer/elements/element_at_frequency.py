"""An element frozen at one frequency."""

from dataclasses import dataclass
from typing import final

import numpy as np

from trimmer.arguments import positive_number
from trimmer.arrays import Complexes, Reals
from trimmer.elements.control_element import adopted
from trimmer.elements.derived_element import DerivedElement
from trimmer.elements.element import Bounds, Element, Limits
from trimmer.elements.expansion import Expansion
from trimmer.elements.small_gains import SmallGains


@final
@dataclass(frozen=True)
class ElementAtFrequency(DerivedElement):
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
    def _source(self) -> Element:
        return self.element

    @property
    def depends_on_frequency(self) -> bool:
        """False: N is that of the frozen omega."""
        return False

    def small_gains(self) -> SmallGains | None:
        """Return what is known of the element if that does not depend on omega."""
        small = super().small_gains()
        return small if small is not None and small.lag == 0 else None

    def _domain(self, omega: Reals) -> Reals | float:
        return super()._domain(self._frozen(omega))

    def _sensitivity(self, u: Limits, omega: Limits) -> Bounds:
        by_u, _ = super()._sensitivity(u, (self._frozen(u[0]), self._frozen(u[1])))
        return by_u, 0.0

    def _variation(self, u: Limits, omega: Limits) -> Bounds:
        by_u, _ = super()._variation(u, (self._frozen(u[0]), self._frozen(u[1])))
        return by_u, 0.0

    def _reach(self, u: Limits, omega: Limits) -> Reals:
        return super()._reach(u, (self._frozen(u[0]), self._frozen(u[1])))

    def _describing_function(self, amplitude: Reals, omega: Reals, harmonic: int) -> Complexes:
        return super()._describing_function(amplitude, self._frozen(amplitude), harmonic)

    def _waveform(self, phase: Reals, amplitude: Reals, omega: Reals) -> Reals:
        return super()._waveform(phase, amplitude, self._frozen(amplitude))

    def _expansion(self, amplitude: Reals, omega: Reals) -> Expansion:
        frozen = super()._expansion(amplitude, self._frozen(amplitude))
        return frozen._replace(by_log_omega=np.zeros(frozen.by_u.shape, dtype=complex))

    def _frozen(self, alike: Reals) -> Reals:
        return np.full(alike.shape, self.omega)
