"""1/G(j omega) as a function of x = ln omega, with bounds of what it does on an interval.

Harmonic balance reads N + 1/G = 0. The inverse response is used because it stays finite where G has a pole on
the imaginary axis. All bounds follow from the distances between an interval of the axis and the roots of G.
"""

from __future__ import annotations

from dataclasses import dataclass
from typing import TYPE_CHECKING, Self

import numpy as np

from trimmer.balance.response import Enclosure

if TYPE_CHECKING:
    from numpy.typing import NDArray

    from trimmer.zero_pole_gain import ZeroPoleGain

    Reals = NDArray[np.float64]
    Complexes = NDArray[np.complex128]
    Flags = NDArray[np.bool_]


@dataclass(frozen=True)
class Turning:
    """How 1/G turns on intervals of x; each field has one entry per interval.

    Attributes:
        centre: 1/G in the middle of the interval.
        spread: Upper bound of how far the phase is from that in the middle, rad.
        one_way: Whether the phase is proven to be monotonic.
    """

    centre: Complexes
    spread: Reals
    one_way: Flags


@dataclass(frozen=True)
class InverseResponse:
    """1/G(j omega) = gain * prod (j omega/reference - root)**exponent.

    Attributes:
        gain: Real factor.
        roots: Poles and zeros of G over the reference.
        exponents: +1 for a pole of G, -1 for a zero.
        reference: Geometric mean of the roots' magnitudes, rad/s; it keeps products within range.
    """

    gain: float
    roots: Complexes
    exponents: Reals
    reference: float

    @classmethod
    def of(cls, factored: ZeroPoleGain) -> Self:
        """Take it from the zeros, poles and gain of G."""
        magnitudes = np.abs(factored.roots)
        magnitudes = magnitudes[magnitudes > 0]
        reference = float(np.exp(np.log(magnitudes).mean())) if magnitudes.size else 1.0
        gain = reference**factored.relative_degree / factored.gain
        return cls(gain, factored.roots / reference, -factored.exponents, reference)

    @property
    def relative_degree(self) -> int:
        """Number of poles of G less number of its zeros."""
        return int(self.exponents.sum())

    @property
    def order_at_zero(self) -> int:
        """Number of poles of G at s = 0 less number of its zeros there."""
        return int(self.exponents[self.roots == 0].sum())

    def value(self, x: Reals) -> Complexes:
        """Evaluate 1/G(j exp x) at an array of x of one dimension."""
        return self._product(1j * self._omega(x) - self.roots[:, None])

    def value_and_slope(self, x: Reals) -> tuple[Complexes, Complexes]:
        """Evaluate 1/G(j exp x) and its derivative with respect to x."""
        rotating = 1j * self._omega(x)
        distances = rotating - self.roots[:, None]
        value = self._product(distances)
        return value, value * rotating * (self.exponents @ (1.0 / distances))

    def enclose(self, lower: Reals, upper: Reals) -> Enclosure:
        """Bound 1/G on the intervals [lower, upper] of x.

        With L = d ln(1/G)/dx = sum of exponent * s/(s - root) at s = j omega, the second derivative of
        ln(1/G) is at most the sum of omega |root| / distance**2, which gives the radius by Taylor's theorem.
        """
        half = 0.5 * (upper - lower)
        nearest, farthest = self._distances(self._omega(lower), self._omega(upper))
        sizes = np.abs(self.roots)
        with np.errstate(all="ignore"):
            centre, slope = self.value_and_slope(0.5 * (lower + upper))
            bend = self._omega(upper) * (sizes @ (1.0 / nearest**2))
            log_slope = np.abs(slope / centre)
            spread = half * (log_slope + 0.5 * half * bend)
            slope_radius = half * np.abs(centre) * np.exp(spread) * ((log_slope + half * bend) ** 2 + bend)
            poles = self.exponents > 0
            smallest = nearest[poles].prod(axis=0) / farthest[~poles].prod(axis=0)
            largest = farthest[poles].prod(axis=0) / nearest[~poles].prod(axis=0)
            radius = np.abs(centre) * np.expm1(spread)
        return Enclosure(
            centre,
            slope,
            np.where(np.isnan(radius), np.inf, radius),
            np.where(np.isnan(slope_radius), np.inf, slope_radius),
            abs(self.gain) * smallest,
            abs(self.gain) * largest,
        )

    def turning(self, lower: Reals, upper: Reals) -> Turning:
        """Bound the phase of 1/G on the intervals [lower, upper] of x, by the same theorem."""
        half = 0.5 * (upper - lower)
        nearest, _ = self._distances(self._omega(lower), self._omega(upper))
        with np.errstate(all="ignore"):
            centre, slope = self.value_and_slope(0.5 * (lower + upper))
            bend = self._omega(upper) * (np.abs(self.roots) @ (1.0 / nearest**2))
            rate = (slope / centre).imag
        spread = half * (np.abs(rate) + 0.5 * half * bend)
        return Turning(centre, np.where(np.isnan(spread), np.inf, spread), np.abs(rate) > half * bend)

    def _omega(self, x: Reals) -> Reals:
        return np.asarray(np.exp(x - np.log(self.reference)))

    def _product(self, distances: Complexes) -> Complexes:
        poles = self.exponents > 0
        quotient = distances[poles].prod(axis=0) / distances[~poles].prod(axis=0)
        return np.asarray(self.gain * quotient)

    def _distances(self, lower: Reals, upper: Reals) -> tuple[Reals, Reals]:
        """Smallest and largest distance of each root from the stretches j[lower, upper] of the axis."""
        height = self.roots.imag[:, None]
        below, above = lower - height, height - upper
        real = (self.roots.real**2)[:, None]
        nearest = np.sqrt(real + np.maximum(np.maximum(below, above), 0.0) ** 2)
        return nearest, np.sqrt(real + np.maximum(below**2, above**2))
