"""The common base of saturation and dead zone: straight lines that meet at two corners.

With u = threshold / A, the input A sin θ passes the corner at α = asin u, which is β = π/2 - α before its
peak. For odd n >= 3 the clipped sine min(sin θ, u) has

N_n = 4 (n sin nα cos α - cos nα sin α) / (π n (n² - 1)).

Where α is large the same is written with β, so that no digits are lost just above the threshold.
"""

from abc import abstractmethod
from dataclasses import dataclass

import numpy as np

from trimmer.arguments import positive_number
from trimmer.arrays import Reals
from trimmer.elements.backlashes.backlash_bounds import ROUNDED_UP
from trimmer.elements.element import Bounds, Element, Limits
from trimmer.elements.expansion import Expansion
from trimmer.elements.small_arguments import argument_less_sine, sine_less_cosine_part

_STEEPEST = 4.0 / np.pi  # |dN/du| over the slope at u = 0, its largest value: it is (4/π) cos α

_ROUNDING = 1e-15  # More than the rounding error of a difference of cosines


@dataclass(frozen=True)
class CornerElement(Element):
    """A static odd element of two slopes, one of them zero, with a corner at either threshold.

    Raises:
        ValueError: if either is not positive and finite.
    """

    threshold: float  # Input at the corner, > 0, in the unit of the input
    slope: float = 1.0  # Output per input on the inclined part, > 0

    constant_from = 1.0  # 1: an amplitude below the threshold never reaches a corner

    def __post_init__(self) -> None:
        positive_number("threshold", self.threshold, "unit of the input")
        positive_number("slope", self.slope, "output per input")

    @property
    def amplitude_scale(self) -> float:
        """The threshold, in the unit of the input: N depends on threshold/amplitude alone."""
        return self.threshold

    def _sensitivity(self, u: Limits, omega: Limits) -> Bounds:
        """Return (4/π) slope cos α at the lowest u, as |dN/du| falls with u; and 0 for |dN/d(ln omega)|."""
        return ROUNDED_UP * _STEEPEST * self.slope * _cosine(u[0]), 0.0

    def _variation(self, u: Limits, omega: Limits) -> Bounds:
        """Return the change of (4/π) slope cos α between the ends of u, as it is monotonic; and 0."""
        change = _cosine(u[0]) - _cosine(u[1]) + _ROUNDING
        return ROUNDED_UP * _STEEPEST * self.slope * change, 0.0

    @property
    @abstractmethod
    def _direction(self) -> float:
        """1 if N rises with u, -1 if it falls."""

    def _expansion(self, amplitude: Reals, omega: Reals) -> Expansion:
        value = self._describing_function(amplitude, omega, 1)
        by_u = (self._direction * _STEEPEST * self.slope * np.sin(_beta(self, amplitude))).astype(complex)
        return Expansion(value, by_u, np.zeros_like(value))


def clipped_fundamental(element: CornerElement, amplitude: Reals) -> Reals:
    """Evaluate N_1 of the clipped sine, (2α + sin 2α) / π, in the shape of the amplitude."""
    alpha = _alpha(element, amplitude)
    return np.asarray((2.0 * alpha + np.sin(2.0 * alpha)) / np.pi)


def missing_fundamental(element: CornerElement, amplitude: Reals) -> Reals:
    """Evaluate 1 less N_1 of the clipped sine, (2β - sin 2β) / π, in the shape of the amplitude."""
    return argument_less_sine(2.0 * _beta(element, amplitude)) / np.pi


def clipped_harmonic(element: CornerElement, amplitude: Reals, harmonic: int) -> Reals:
    """Evaluate N_n of the clipped sine for odd n >= 3, in the shape of the amplitude."""
    n = float(harmonic)
    alpha, beta = _alpha(element, amplitude), _beta(element, amplitude)
    from_zero = n * np.sin(n * alpha) * np.cos(alpha) - np.cos(n * alpha) * np.sin(alpha)
    # n cos nβ sin β - sin nβ cos β, with what cancels for small nβ written apart.
    turned = n * beta
    lost = sine_less_cosine_part(turned)
    lost -= 2.0 * np.sin(0.5 * beta) ** 2 * np.sin(turned) - n * argument_less_sine(beta) * np.cos(turned)
    from_peak = -lost if harmonic % 4 == 1 else lost
    return np.asarray(4.0 / (np.pi * n * (n * n - 1.0)) * np.where(alpha < beta, from_zero, from_peak))


def corner_share(element: CornerElement, amplitude: Reals) -> Reals:
    """Evaluate the share of the time that the input is between the thresholds, 2α/π."""
    return _alpha(element, amplitude) * (2.0 / np.pi)


def _alpha(element: CornerElement, amplitude: Reals) -> Reals:
    return np.arctan2(element.threshold, _adjacent(element, amplitude))


def _beta(element: CornerElement, amplitude: Reals) -> Reals:
    return np.arctan2(_adjacent(element, amplitude), element.threshold)


def _adjacent(element: CornerElement, amplitude: Reals) -> Reals:
    """A cos α to full relative precision; 0 where the amplitude does not reach the corner."""
    beyond = np.maximum(amplitude - element.threshold, 0.0)
    return np.asarray(np.sqrt(beyond) * np.sqrt(amplitude + element.threshold))


def _cosine(u: Reals) -> Reals:
    ratio = np.minimum(u, 1.0)
    return np.asarray(np.sqrt((1.0 - ratio) * (1.0 + ratio)))
