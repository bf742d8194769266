"""The common base of elements that behave as another one does."""

from abc import abstractmethod

from trimmer.arrays import Complexes, Reals
from trimmer.elements.element import Bounds, Element, Limits
from trimmer.elements.expansion import Expansion
from trimmer.elements.small_gains import SmallGains


class DerivedElement(Element):
    """An element that is another one in all that it does not say itself."""

    @property
    @abstractmethod
    def _source(self) -> Element:
        """The other element."""

    @property
    def depends_on_frequency(self) -> bool:
        """Whether the other element depends on frequency."""
        return self._source.depends_on_frequency

    @property
    def amplitude_scale(self) -> float:
        """The scale of the other element, in the unit of the input."""
        return self._source.amplitude_scale

    @property
    def has_bounds(self) -> bool:
        """Whether the other element has bounds."""
        return self._source.has_bounds

    @property
    def constant_from(self) -> float:
        """The u from which on N of the other element does not change any more."""
        return self._source.constant_from

    def small_gains(self) -> SmallGains | None:
        """Return what is known of the other element."""
        return self._source.small_gains()

    def _domain(self, omega: Reals) -> Reals | float:
        return self._source._domain(omega)

    def _sensitivity(self, u: Limits, omega: Limits) -> Bounds:
        return self._source._sensitivity(u, omega)

    def _variation(self, u: Limits, omega: Limits) -> Bounds:
        return self._source._variation(u, omega)

    @property
    def _has_reach(self) -> bool:
        return self._source._has_reach

    def _reach(self, u: Limits, omega: Limits) -> Reals:
        return self._source._reach(u, omega)

    def _mean_gain(self, amplitude: Reals) -> Reals | float:
        return self._source._mean_gain(amplitude)

    def _describing_function(self, amplitude: Reals, omega: Reals, harmonic: int) -> Complexes:
        return self._source._describing_function(amplitude, omega, harmonic)

    def _waveform(self, phase: Reals, amplitude: Reals, omega: Reals) -> Reals:
        return self._source._waveform(phase, amplitude, omega)

    def _expansion(self, amplitude: Reals, omega: Reals) -> Expansion:
        return self._source._expansion(amplitude, omega)
