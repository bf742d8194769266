"""The interface of a nonlinear element: describing function, waveform, derivatives and their bounds."""

from __future__ import annotations

import math
from abc import ABC, abstractmethod
from dataclasses import dataclass
from typing import TYPE_CHECKING, TypeVar, final

import numpy as np
from numpy.typing import ArrayLike, NDArray

from trimmer.arguments import real_values, whole_number
from trimmer.arrays import Complexes, Reals
from trimmer.elements.arguments import positive_amplitudes, positive_omegas
from trimmer.elements.expansion import Derivatives, Expansion, GainSensitivity, GainVariation
from trimmer.elements.small_gains import SmallGains
from trimmer.showing.drawn import Drawn, drawn

if TYPE_CHECKING:
    from matplotlib.axes import Axes

    from trimmer.elements.element_at_frequency import ElementAtFrequency
    from trimmer.elements.scaled_element import ScaledElement
    from trimmer.elements.sum_of_elements import SumOfElements

Range = tuple[ArrayLike, ArrayLike]
Limits = tuple[Reals, Reals]
Bounds = tuple[Reals | float, Reals | float]

Number = TypeVar("Number", np.float64, np.complex128)

_ANY_OMEGA = np.ones(())  # Omega, rad/s, that is used where the element does not depend on it

BLOCK = 16384
"""Entries that are computed together: few enough for the processor's cache, enough to make calls cheap."""


class Element(Drawn, ABC):
    """A nonlinear element with input x = A sin θ, θ = omega t, and a steady output that repeats with it.

    The describing function of harmonic n is N_n = (b_n + j a_n) / A with the Fourier coefficients a_n of
    cos nθ and b_n of sin nθ of the output (equation 2.35 of the thesis for n = 1). All elements are odd,
    y(θ + π) = -y(θ), so even harmonics are zero. A is half of peak to peak.

    Where an element has no steady output (an amplitude too small for its gap) it returns NaN; ``domain``
    gives the limit. NaN in gives NaN out. ``describing_function(A)`` is what python-control calls, so
    an element that does not depend on frequency is accepted by ``control.describing_function_plot`` and
    ``control.describing_function_response``; freeze another with ``at``.

    Elements add, subtract, and take a factor: ``a + b``, ``a - b``, ``2.0 * a``, ``-a``.
    """

    @property
    def depends_on_frequency(self) -> bool:
        """Whether N depends on omega; if so, omega must be given."""
        return False

    @property
    @abstractmethod
    def amplitude_scale(self) -> float:
        """Natural scale of the amplitude, in the unit of the input; u = amplitude_scale / amplitude."""

    @property
    def has_bounds(self) -> bool:
        """Whether ``sensitivity`` and ``variation`` are finite bounds, on which a certificate can rest."""
        return True

    @property
    def constant_from(self) -> float:
        """The u from which on N does not change with u any more; infinite if there is none, or none is known.

        Below an amplitude a static element may be linear. A limit cycle there would be one of any amplitude.
        """
        return math.inf

    def describing_function(
        self, amplitude: ArrayLike, omega: ArrayLike | None = None, harmonic: int = 1
    ) -> Complexes:
        """Evaluate the describing function N_n of a harmonic.

        Args:
            amplitude: A > 0, in the unit of the input, of any shape; infinity gives the limit.
            omega: Angular frequency, rad/s, > 0, of a shape that broadcasts with the amplitude. Needed if
                ``depends_on_frequency``.
            harmonic: n >= 1.

        Returns:
            N_n in the unit of output over input, of the broadcast shape; NaN outside the domain.

        Raises:
            ValueError: if an amplitude or omega is not positive, omega is infinite or missing, or the
                harmonic is no integer >= 1.
        """
        number = whole_number("harmonic", harmonic, 1)
        amplitudes, omegas = self._inputs(amplitude, omega)
        missing = np.isnan(amplitudes) | np.isnan(omegas)
        values: Complexes = np.empty(amplitudes.size, dtype=complex)
        flat_amplitudes, flat_omegas = amplitudes.ravel(), omegas.ravel()
        with np.errstate(all="ignore"):
            for start in range(0, values.size, BLOCK):
                block = slice(start, start + BLOCK)
                # An even harmonic is zero wherever the first one exists.
                values[block] = self._describing_function(
                    flat_amplitudes[block], flat_omegas[block], number if number % 2 else 1
                )
        values = values.reshape(amplitudes.shape)
        values[missing] = np.nan
        if number % 2 == 0:
            values[~np.isnan(values)] = 0.0
        return _scalar_if_0d(values)

    def waveform(self, phase: ArrayLike, amplitude: ArrayLike, omega: ArrayLike | None = None) -> Reals:
        """Evaluate the steady output for the input A sin θ.

        Args:
            phase: θ, rad, any real number; the output has period 2π.
            amplitude: A > 0, finite, in the unit of the input.
            omega: Angular frequency, rad/s, > 0. Needed if ``depends_on_frequency``.

        Returns:
            Output in its unit, of the shape that phase, amplitude and omega broadcast to; NaN outside the
            domain.

        Raises:
            ValueError: as for ``describing_function``, and for an infinite amplitude.
        """
        amplitudes, omegas = self._inputs(amplitude, omega)
        if np.isinf(amplitudes).any():
            raise ValueError("amplitude must be finite for a waveform, not inf")
        phases, amplitudes, omegas = np.broadcast_arrays(real_values("phase", phase), amplitudes, omegas)
        with np.errstate(all="ignore"):
            values = self._waveform(phases.ravel(), amplitudes.ravel(), omegas.ravel())
        values = values.reshape(phases.shape)
        values[np.isnan(phases) | np.isnan(amplitudes) | np.isnan(omegas)] = np.nan
        return _scalar_if_0d(values)

    def derivatives(self, amplitude: ArrayLike, omega: ArrayLike | None = None) -> Derivatives:
        """Evaluate dN/du and dN/d(ln omega) of the first harmonic analytically, in the unit of N.

        Arguments, shapes and errors are those of ``describing_function``; NaN outside the domain.
        """
        expansion = self.expansion(amplitude, omega)
        return Derivatives(expansion.by_u, expansion.by_log_omega)

    def expansion(self, amplitude: ArrayLike, omega: ArrayLike | None = None) -> Expansion:
        """Evaluate N of the first harmonic and its derivatives together, which costs less than each alone.

        Arguments, shapes and errors are those of ``describing_function``; NaN outside the domain.
        """
        amplitudes, omegas = self._inputs(amplitude, omega)
        missing = np.isnan(amplitudes) | np.isnan(omegas)
        with np.errstate(all="ignore"):
            parts = self._expansion(amplitudes.ravel(), omegas.ravel())
        if np.count_nonzero(missing):
            for part in parts:
                part[missing.ravel()] = np.nan
        return Expansion(*(_scalar_if_0d(part.reshape(amplitudes.shape)) for part in parts))

    def domain(self, omega: ArrayLike | None = None) -> Reals:
        """Return the supremum of u = amplitude_scale / amplitude at each omega; N is NaN from there on.

        Args:
            omega: Angular frequency, rad/s, > 0, of any shape. Needed if ``depends_on_frequency``.

        Returns:
            Supremum, a number without unit, in the shape of ``omega``; infinite if any amplitude will do.

        Raises:
            ValueError: as for ``describing_function``.
        """
        omegas = self._omegas(omega)
        return _in_shape(self._domain(omegas.ravel()), omegas.shape)

    def sensitivity(self, u_range: Range, omega_range: Range | None = None) -> GainSensitivity:
        """Bound the derivatives of N on boxes of u and omega, as far as they lie in the domain.

        Args:
            u_range: Lower and upper u, 0 <= lower <= upper, of any shape.
            omega_range: Lower and upper omega, rad/s, of a shape that broadcasts. Needed if
                ``depends_on_frequency``.

        Returns:
            Bounds of broadcast shape, in the unit of N. They are proven for exact arithmetic and rounded
            upwards.

        Raises:
            ValueError: as for ``describing_function``.
        """
        shape, boxes = self._boxes(u_range, omega_range)
        with np.errstate(all="ignore"):
            return GainSensitivity(*(_in_shape(each, shape) for each in self._sensitivity(*boxes)))

    def variation(self, u_range: Range, omega_range: Range | None = None) -> GainVariation:
        """Bound how much the derivatives of N change on boxes of u and omega, inside the domain.

        With it Newton's method and the uniqueness of a solution can be proven. Arguments and errors are those
        of ``sensitivity``, and so is what is proven.
        """
        shape, boxes = self._boxes(u_range, omega_range)
        with np.errstate(all="ignore"):
            return GainVariation(*(_in_shape(each, shape) for each in self._variation(*boxes)))

    def reach(self, u_range: Range, omega_range: Range | None = None) -> Reals | None:
        """Bound how far N is from its value in the middle of u, on boxes in the domain, at constant omega.

        An element whose |dN/du| is not bounded gives it. None: |dN/du| times half the width is a bound.

        Arguments and errors are those of ``sensitivity``, and so is what is proven.
        """
        if not self._has_reach:
            return None
        shape, boxes = self._boxes(u_range, omega_range)
        with np.errstate(all="ignore"):
            return _in_shape(self._reach(*boxes), shape)

    def small_gains(self) -> SmallGains | None:
        """Tell how N goes to zero at the edge of the domain; None if nothing is known of that.

        With it the solver can prove that there is no limit cycle where both N and 1/G vanish.
        """
        return None

    def mean_gain(self, amplitude: ArrayLike) -> Reals:
        """Return the gain for the mean of the input, while that oscillates.

        It is the slope of the mean output over the mean b of the input b + A sin θ, at b = 0. A mean that
        runs away makes a limit cycle unstable. Gelb and Vander Velde (1968), chapter 6, treat such inputs.

        Args:
            amplitude: A > 0, of any shape; inside the domain.

        Returns:
            In the unit of output over input, of the shape of the amplitude.
        """
        amplitudes = positive_amplitudes(amplitude)
        with np.errstate(all="ignore"):
            return _in_shape(self._mean_gain(amplitudes.ravel()), amplitudes.shape)

    def at(self, omega: float) -> ElementAtFrequency:
        """Return this element frozen at an omega, rad/s: its N depends on amplitude only.

        Raises:
            ValueError: if omega is not positive and finite.
        """
        from trimmer.elements.element_at_frequency import ElementAtFrequency

        return ElementAtFrequency(self, omega)

    def plot(self, ax: Axes | None = None, omega: float | None = None) -> Axes:
        """Draw magnitude and phase of the describing function over the amplitude.

        Args:
            ax: Where to draw; new axes if not given. The phase has an axis of its own, at the right.
            omega: Angular frequency, rad/s. Needed if ``depends_on_frequency``.

        Raises:
            WrongTypeError: if ``ax`` is no Matplotlib axes.
            ValueError: as for ``describing_function``.
        """
        return drawn(self, ax, omega=omega)

    def plot_locus(self, ax: Axes | None = None, omega: float | None = None) -> Axes:
        """Draw -1/N in the complex plane, with an arrow towards larger amplitudes.

        Arguments and errors are those of ``plot``.
        """
        return ElementLocus(self, omega).plot(ax)

    # The results of arithmetic are elements themselves, so their modules need this one first.
    def __add__(self, other: Element) -> SumOfElements:
        from trimmer.elements.control_element import is_element
        from trimmer.elements.sum_of_elements import SumOfElements

        return SumOfElements((self, other)) if is_element(other) else NotImplemented

    def __sub__(self, other: Element) -> SumOfElements:
        from trimmer.elements.control_element import adopted, is_element

        return self + (-adopted("other", other)) if is_element(other) else NotImplemented

    def __mul__(self, factor: float) -> ScaledElement:
        from trimmer.elements.scaled_element import ScaledElement

        return ScaledElement(self, factor)

    __rmul__ = __mul__

    def __neg__(self) -> ScaledElement:
        return -1.0 * self

    @abstractmethod
    def _describing_function(self, amplitude: Reals, omega: Reals, harmonic: int) -> Complexes:
        """Evaluate N_n for an odd harmonic; all arrays have shape (n,)."""

    @abstractmethod
    def _waveform(self, phase: Reals, amplitude: Reals, omega: Reals) -> Reals:
        """Evaluate the output; all arrays have shape (n,)."""

    @abstractmethod
    def _expansion(self, amplitude: Reals, omega: Reals) -> Expansion:
        """Evaluate N_1 and its derivatives; all arrays have shape (n,)."""

    @abstractmethod
    def _sensitivity(self, u: Limits, omega: Limits) -> Bounds:
        """Bound |dN/du| and |dN/d(ln omega)| between limits of shape (n,), each alike or by one number."""

    @abstractmethod
    def _variation(self, u: Limits, omega: Limits) -> Bounds:
        """Bound the changes of dN/du and dN/d(ln omega), as ``_sensitivity`` does."""

    @abstractmethod
    def _mean_gain(self, amplitude: Reals) -> Reals | float:
        """Evaluate the gain for the mean at amplitudes of shape (n,), alike or as one number."""

    def _domain(self, omega: Reals) -> Reals | float:
        """Return the supremum of u at omegas of shape (n,), alike or one number; infinity if any will do."""
        return math.inf

    @property
    def _has_reach(self) -> bool:
        """Whether ``_reach`` bounds how far N is from its value in the middle of u, as |dN/du| does not."""
        return False

    def _reach(self, u: Limits, omega: Limits) -> Reals:
        raise NotImplementedError

    def _boxes(
        self, u_range: Range, omega_range: Range | None
    ) -> tuple[tuple[int, ...], tuple[Limits, Limits]]:
        """Return the shape of boxes, and their limits, each of shape (n,)."""
        limits = [*u_range, *(self._omegas(each) for each in omega_range or (None, None))]
        shapes = {np.shape(each) for each in (limits if omega_range else u_range)}
        shape = shapes.pop() if len(shapes) == 1 else np.broadcast_shapes(*shapes)
        boxes = np.empty((4, *shape))
        for place, limit in enumerate(limits):
            boxes[place, ...] = limit
        lower, upper, slowest, fastest = boxes.reshape(4, -1)
        return shape, ((lower, upper), (slowest, fastest))

    def _inputs(self, amplitude: ArrayLike, omega: ArrayLike | None) -> tuple[Reals, Reals]:
        amplitudes, omegas = positive_amplitudes(amplitude), self._omegas(omega)
        # What broadcast_arrays does, for the frequent case, in a fraction of its time.
        if omegas.ndim == 0:
            return amplitudes, np.full(amplitudes.shape, omegas)
        amplitudes, omegas = np.broadcast_arrays(amplitudes, omegas)
        return amplitudes, omegas

    def _omegas(self, omega: ArrayLike | None) -> Reals:
        """Return omega as an array; an element that does not depend on it may do without."""
        if omega is None:
            if self.depends_on_frequency:
                raise ValueError(
                    f"{self!r} depends on frequency: give omega (rad/s), or freeze it with .at(omega)"
                )
            return _ANY_OMEGA
        return positive_omegas(omega)


def _in_shape(values: ArrayLike, shape: tuple[int, ...]) -> Reals:
    """Return numbers, one or one for each entry of a shape, in that shape; a scalar where it is ()."""
    whole = np.empty(shape)
    whole.reshape(-1)[:] = values
    return whole[()]


def _scalar_if_0d(values: NDArray[Number]) -> NDArray[Number]:
    """Return an array as it is, and a scalar in place of an array without dimensions, as NumPy does."""
    return values[()]


@final
@dataclass(frozen=True)
class ElementLocus(Drawn):
    """The curve -1/N of an element; ``plot`` draws it with an arrow towards larger amplitudes."""

    element: Element  # The element
    omega: float | None = None  # Angular frequency, rad/s; needed if N depends on it
