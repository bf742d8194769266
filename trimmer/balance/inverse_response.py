"""1/G(j omega) as a function of x = ln omega (omega in rad/s), with bounds on intervals of x.

Harmonic balance reads N + 1/G = 0. The inverse response is used because it stays finite where G has a pole on
the imaginary axis. All bounds follow from the distances between an interval of the axis and the roots of G.
"""

import math
import sys
from dataclasses import dataclass
from functools import cached_property
from typing import Protocol, Self, TypeVar

import numpy as np
from numpy.typing import NDArray

from trimmer.arrays import ArrayRecord, Complexes, Flags, Reals
from trimmer.linear import UnsupportedSystemError, ZeroPoleGain


@dataclass(frozen=True)
class Enclosure(ArrayRecord):
    """Value and bounds of 1/G on n intervals of x; each field has shape (n,) and the unit of 1/G."""

    centre: Complexes  # 1/G in the middle of the interval
    slope: Complexes  # d(1/G)/dx there
    radius: Reals  # Upper bound of |1/G - centre| on the interval
    slope_radius: Reals  # Upper bound of the change of d(1/G)/dx from its value in the middle
    smallest: Reals  # Lower bound of |1/G| on the interval
    largest: Reals  # Upper bound of |1/G| on the interval


class Sloped(Protocol):
    """A complex function of x that takes the place of 1/G in N + 1/G = 0."""

    def value_and_slope(self, x: Reals) -> tuple[Complexes, Complexes]:
        """Evaluate the function and its derivative by x, both of the shape (n,) of x."""


class InverseGain(Sloped, Protocol):
    """The same with bounds."""

    def enclose(self, lower: Reals, upper: Reals) -> Enclosure:
        """Bound the function on the n intervals [lower, upper] of x, both of shape (n,)."""


@dataclass(frozen=True)
class ConstantResponse:
    """The same 1/G at all x, as when the frequency is given and something else is looked for."""

    inverse: complex

    def value_and_slope(self, x: Reals) -> tuple[Complexes, Complexes]:
        """Return the constant, and zero for its derivative, at each x."""
        return np.full(x.shape, self.inverse), np.zeros(x.shape, dtype=complex)

    def enclose(self, lower: Reals, upper: Reals) -> Enclosure:
        """Return the constant with radius 0 for each interval."""
        value, slope = self.value_and_slope(lower)
        nothing = np.zeros(lower.shape)
        return Enclosure(value, slope, nothing, nothing, np.abs(value), np.abs(value))


LARGEST_ERROR = math.sqrt(sys.float_info.epsilon)
"""Relative error of 1/G from which on nothing is certain: half of the digits are lost."""

_EVEN = 16  # Equal parts of a range of x

_BESIDE_A_ROOT = np.sinh(0.75 * np.arange(-4, 5))
"""Distances from a root's frequency at which the range is cut too, over the root's distance from the axis."""

Number = TypeVar("Number", np.float64, np.complex128)


@dataclass(frozen=True)
class Turning:
    """Bounds of the phase of 1/G on n intervals of x; each field has shape (n,)."""

    direction: Complexes  # 1/G over its modulus in the middle of the interval; NaN where that is a root
    # Upper bound of how far the phase is from that in the middle, rad; infinite if there is none
    spread: Reals
    one_way: Flags  # Whether the phase is proven to be monotonic


@dataclass(frozen=True)
class InverseResponse:
    """1/G(j omega) = gain * prod(j omega/reference - pole) / prod(j omega/reference - zero)."""

    gain: complex  # Factor, in the unit of 1/G; real for a real G
    poles: Complexes  # Poles of G over the reference, shape (number of poles,); at least as many as zeros
    zeros: Complexes  # Zeros of G over the reference, shape (number of zeros,)
    reference: float  # Geometric mean of the roots' magnitudes, rad/s; it keeps products within range
    # How far 1/G may be off on the axis, relative: by rounding of what it was factored from, and of the
    # factoring (``trimmer.balance.factoring_error``). All bounds allow for it, as long as it is at most
    # ``LARGEST_ERROR``; what holds beyond is not certain.
    error: float = 0.0

    @classmethod
    def of(cls, factored: ZeroPoleGain) -> Self:
        """Return 1/G from the zeros, poles and gain of G, if its size among its roots is one of a double."""
        magnitudes = np.abs(factored.roots)
        magnitudes = magnitudes[magnitudes > 0]
        reference = float(np.exp(np.log(magnitudes).mean())) if magnitudes.size else 1.0
        gain = _power_over(reference, factored.relative_degree, factored.gain)
        poles, zeros = np.array(factored.poles, complex), np.array(factored.zeros, complex)
        return cls(gain, poles / complex(reference), zeros / complex(reference), reference)

    @cached_property
    def roots(self) -> Complexes:
        """Poles of G, then its zeros, over the reference; shape (number of roots,)."""
        return np.concatenate([self.poles, self.zeros])

    @cached_property
    def exponents(self) -> Reals:
        """Exponent of each of ``roots`` in 1/G, of the same shape: +1 for a pole of G, -1 for a zero."""
        return np.repeat([1.0, -1.0], [self.poles.size, self.zeros.size])

    @cached_property
    def is_real(self) -> bool:
        """Whether all coefficients are real: roots come in exact pairs."""
        above, below = self.roots[self.roots.imag > 0], self.roots[self.roots.imag < 0]
        signs = self.exponents[self.roots.imag > 0], self.exponents[self.roots.imag < 0]
        pairs = (
            sorted(zip(roots.real.tolist(), np.abs(roots.imag).tolist(), sign.tolist(), strict=True))
            for roots, sign in zip((above, below), signs, strict=True)
        )
        return complex(self.gain).imag == 0.0 and next(pairs) == next(pairs)

    @cached_property
    def _root_columns(self) -> tuple[Reals, Reals, Reals]:
        """Of each root the modulus, the imaginary part and the squared real part, of shape (roots, 1)."""
        column = self.roots[:, None]
        return np.abs(column), column.imag, column.real**2

    @property
    def allowance(self) -> float:
        """What bounds allow for the error."""
        return min(self.error, LARGEST_ERROR)

    @property
    def _steepness(self) -> float:
        """Bound of the slope in x of a polynomial of the order of G, over its size: an error is one."""
        return 2.0 * self.roots.size

    @property
    def relative_degree(self) -> int:
        """Number of poles of G less number of its zeros."""
        return self.poles.size - self.zeros.size

    @property
    def order_at_zero(self) -> int:
        """Number of poles of G at s = 0 less number of its zeros there."""
        return int(self.exponents[self.roots == 0].sum())

    def value(self, x: Reals) -> Complexes:
        """Evaluate 1/G(j exp x) at x of shape (n,)."""
        return self.gain * self._quotient(1j * self._omega(x) - self.roots[:, None])

    def value_and_slope(self, x: Reals) -> tuple[Complexes, Complexes]:
        """Evaluate 1/G(j exp x) and its derivative by x at x of shape (n,)."""
        value, log_slope = self._value_and_log_slope(x)
        return value, value * log_slope

    def enclose(self, lower: Reals, upper: Reals) -> Enclosure:
        """Bound 1/G on the intervals [lower, upper] of x, both of shape (n,).

        With L = d ln(1/G)/dx = sum of exponent * s/(s - root) at s = j omega, the second derivative of
        ln(1/G) is at most the sum of omega |root| / distance**2, which gives the radius by Taylor's theorem.
        """
        half = 0.5 * (upper - lower)
        with np.errstate(all="ignore"):
            middle = 0.5 * (lower + upper)
            centre, log_slope = self._value_and_log_slope(middle)
            bend = self._bend(lower, upper)
            slope, size, rate = centre * log_slope, self._size(centre, middle), np.abs(log_slope)
            spread = half * (rate + 0.5 * half * bend) + self.allowance
            # Without a number, as where the centre is a root, there is no bound.
            spread[np.isnan(spread)] = np.inf
            growth = np.exp(spread)
            slope_radius = half * ((rate + half * bend) ** 2 + bend) + self.allowance * (
                rate + self._steepness
            )
            slope_radius *= size * growth
            slope_radius[np.isnan(slope_radius)] = np.inf
            radius, smallest, largest = size * (growth - 1.0), size / growth, size * growth
            if self._reaches_zero_or_infinity:
                least, most = self._extremes(lower, upper)
                least, most = (1.0 - self.allowance) * least, (1.0 + self.allowance) * most
                smallest, largest = np.fmax(smallest, least), np.fmin(largest, most)
                radius = np.fmin(radius, size + largest)
            return Enclosure(centre, slope, radius, slope_radius, smallest, largest)

    def turning(self, lower: Reals, upper: Reals) -> Turning:
        """Bound the phase of 1/G on intervals of x, (n,), by Taylor's theorem, as in ``enclose``."""
        half = 0.5 * (upper - lower)
        with np.errstate(all="ignore"):
            rotating = 1j * self._omega(0.5 * (lower + upper))
            distances = rotating - self.roots[:, None]
            rate = (self.exponents @ (rotating / distances)).imag
            bend = self._bend(lower, upper)
            direction = self._direction(distances)
            spread = half * (np.abs(rate) + 0.5 * half * bend) + self.allowance
            one_way = np.abs(rate) > half * bend + self.allowance * self._steepness
        return Turning(direction, np.where(np.isnan(spread), np.inf, spread), one_way)

    def direction(self, x: Reals) -> Complexes:
        """Evaluate 1/G over its modulus at x of shape (n,); it neither overflows nor vanishes far away."""
        with np.errstate(all="ignore"):
            return self._direction(1j * self._omega(x) - self.roots[:, None])

    def log_size(self, x: Reals) -> Reals:
        """Evaluate ln |1/G| at x of shape (n,)."""
        with np.errstate(divide="ignore"):
            distances = np.log(np.abs(1j * self._omega(x) - self.roots[:, None]))
        return np.asarray(math.log(abs(self.gain)) + self.exponents @ distances)

    def _direction(self, distances: Complexes) -> Complexes:
        return self.gain / abs(self.gain) * self._quotient(distances / np.abs(distances))

    def breaks(self, x_lower: float, x_upper: float) -> Reals:
        """Return limits, rising, of intervals that cover a range of x; short beside lightly damped roots."""
        roots = self.roots[self.roots.imag > 0]
        beside = roots.imag + roots.real * _BESIDE_A_ROOT[:, None]
        x = np.log(np.maximum(beside, self._omega(np.array(x_lower))) * self.reference).ravel()
        even = np.linspace(x_lower, x_upper, _EVEN + 1)
        return np.sort(np.concatenate([x[(x > x_lower) & (x < x_upper)], even]))

    @cached_property
    def _reaches_zero_or_infinity(self) -> bool:
        """Whether G has a root on the axis above the origin, where no bound of ln(1/G) holds."""
        return bool(np.any((self.roots.real == 0) & (self.roots.imag > 0)))

    def _extremes(self, x_lower: Reals, x_upper: Reals) -> tuple[Reals, Reals]:
        """Bound |1/G| from the smallest and the largest distance of each root."""
        below = self._omega(x_lower) - self.roots.imag[:, None]
        above = self.roots.imag[:, None] - self._omega(x_upper)
        aside = self.roots.real[:, None]
        nearest = np.hypot(np.maximum(np.maximum(below, above), 0.0), aside)
        farthest = np.hypot(np.maximum(np.abs(below), np.abs(above)), aside)
        poles = self.poles.size
        least = self._quotient(np.concatenate([nearest[:poles], farthest[poles:]]))
        most = self._quotient(np.concatenate([farthest[:poles], nearest[poles:]]))
        return abs(self.gain) * least, abs(self.gain) * most

    def _omega(self, x: Reals) -> Reals:
        return np.asarray(np.exp(x) / self.reference)

    def _size(self, value: Complexes, x: Reals) -> Reals:
        """|1/G| at x, with its value; infinite where 1/G overflows and its parts are no numbers."""
        sizes = np.abs(value)
        lost = np.isnan(sizes)
        if lost.any():
            distances = np.abs(1j * self._omega(x[lost]) - self.roots[:, None])
            sizes[lost] = abs(self.gain) * self._quotient(distances)
        return np.asarray(sizes)

    def _value_and_log_slope(self, x: Reals) -> tuple[Complexes, Complexes]:
        """Evaluate 1/G and d ln(1/G)/dx, which stays finite where 1/G overflows."""
        rotating = 1j * self._omega(x)
        distances = rotating - self.roots[:, None]
        log_slope = self.exponents @ (rotating / distances)
        return self.gain * self._quotient(distances), log_slope

    def _quotient(self, factors: NDArray[Number]) -> NDArray[Number]:
        """Product of the first rows, one per pole, over the others; in pairs, so that it seldom overflows."""
        poles, zeros = self.poles.size, self.zeros.size
        quotients = factors[:poles].copy()
        quotients[:zeros] /= factors[poles:]
        return np.asarray(quotients.prod(axis=0))

    def _bend(self, x_lower: Reals, x_upper: Reals) -> Reals:
        """Upper bound of the second derivative of ln(1/G) between two x; terms peak at omega = |root|."""
        sizes, heights, squared_distances = self._root_columns
        worst = np.minimum(np.maximum(sizes, self._omega(x_lower)), self._omega(x_upper))
        return np.asarray((sizes * worst / ((worst - heights) ** 2 + squared_distances)).sum(axis=0))


def _power_over(base: float, exponent: int, divisor: float) -> float:
    """Return base**exponent / divisor, also where the power alone is too large for a double."""
    mantissa, octaves = math.frexp(base)
    below, less = math.frexp(divisor)
    try:
        value = math.ldexp(mantissa**exponent / below, octaves * exponent - less)
    except OverflowError:
        value = math.inf
    if not sys.float_info.min <= abs(value) < math.inf:
        raise UnsupportedSystemError(
            "the gain of the system among its poles and zeros is beyond the numbers of a computer, about "
            "1e-308 to 1e308: give it in other units"
        )
    return value
