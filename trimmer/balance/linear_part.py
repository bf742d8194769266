"""The linear part of an element, which harmonic balance moves to the linear system without approximation.

With N = N_linear + N_rest, 1 + N G = 0 is 1/G + N_linear + N_rest = 0. So viscous friction, and the slope of
a preload, leave the element and join 1/G as a linear feedback round the system; what is left is bounded, or
proportional to 1/A.
"""

from __future__ import annotations

from dataclasses import dataclass, replace
from functools import reduce
from operator import add
from typing import TYPE_CHECKING

import numpy as np

from trimmer.elements.element_at_frequency import ElementAtFrequency
from trimmer.elements.preload import Preload
from trimmer.elements.relay import Relay
from trimmer.elements.scaled_element import ScaledElement
from trimmer.elements.sum_of_elements import SumOfElements
from trimmer.elements.viscous_friction import ViscousFriction
from trimmer.linear.frequency_response import UnsupportedSystemError

if TYPE_CHECKING:
    from trimmer.arrays import Complexes, Reals
    from trimmer.balance.inverse_response import InverseResponse
    from trimmer.elements.element import Element


@dataclass(frozen=True)
class LinearGain:
    """The describing function constant + j omega damping, the same at all amplitudes.

    Attributes:
        constant: In the unit of output over input of the element.
        damping: In that unit times s.
    """

    constant: complex = 0.0
    damping: float = 0.0

    def __add__(self, other: LinearGain) -> LinearGain:
        return LinearGain(self.constant + other.constant, self.damping + other.damping)

    def scaled(self, factor: float) -> LinearGain:
        """Return the gain multiplied by a factor."""
        return LinearGain(factor * self.constant, factor * self.damping)

    def value(self, omega: Reals) -> Complexes:
        """Evaluate the gain at angular frequencies, rad/s, in their shape."""
        return np.asarray(self.constant + 1j * self.damping * omega)

    def frozen(self, omega: float) -> LinearGain:
        """Return the constant gain that has the value at one omega, rad/s."""
        return LinearGain(self.constant + 1j * self.damping * omega)


def parted(element: Element) -> tuple[LinearGain, Element | None]:
    """Split an element into its linear part and the rest, which is None for a linear element."""
    match element:
        case ViscousFriction():
            return LinearGain(damping=element.damping), None
        case Preload():
            return LinearGain(element.slope), Relay(element.level)
        case ScaledElement():
            linear, rest = parted(element.element)
            return linear.scaled(element.factor), None if rest is None else element.factor * rest
        case ElementAtFrequency():
            linear, rest = parted(element.element)
            return linear.frozen(element.omega), None if rest is None else rest.at(element.omega)
        case SumOfElements():
            linears, rests = zip(*map(parted, element.terms), strict=True)
            return reduce(add, linears), _sum_of([rest for rest in rests if rest is not None])
    return LinearGain(), element


def _sum_of(elements: list[Element]) -> Element | None:
    return SumOfElements(tuple(elements)) if len(elements) > 1 else elements[0] if elements else None


_ROUNDING = 64 * np.finfo(float).eps
"""Relative size below which a computed quantity is taken for a rounded zero."""

_POLISHING = 3
"""Steps, each of which squares the error of a root."""


def with_feedback(response: InverseResponse, feedback: LinearGain) -> InverseResponse:
    """Return 1/G plus a linear gain, in the unit of 1/G.

    The sum has the zeros of G as its poles; its zeros, the poles of the loop, are those of a polynomial.

    Raises:
        UnsupportedSystemError: if the highest powers of s cancel, so that the loop has no bounded response.
    """
    zeros, poles = np.poly(response.zeros), np.poly(response.poles)
    gains = np.array([feedback.damping * response.reference, feedback.constant])
    added = np.polymul(np.trim_zeros(gains, "f"), zeros)
    own = response.gain * poles
    total, sizes = np.polyadd(own, added), np.polyadd(np.abs(own), np.abs(added))
    if abs(total[0]) <= _ROUNDING * sizes[0]:
        raise UnsupportedSystemError(
            "the linear part of the element cancels the highest derivative in the system: change either"
        )
    rooted = _polished(np.roots(total).astype(complex), total[0], response, feedback)
    return replace(response, gain=total[0], poles=_cleaned(rooted))


def _polished(
    roots: Complexes, leading: complex, response: InverseResponse, feedback: LinearGain
) -> Complexes:
    """Improve roots by Weierstrass's method, with the polynomial in factors, which lose no digits."""
    for _ in range(_POLISHING):
        apart = roots[:, None] - roots
        np.fill_diagonal(apart, 1.0)
        added = feedback.constant + feedback.damping * response.reference * roots
        value = response.gain * (roots[:, None] - response.poles).prod(axis=1)
        value = value + added * (roots[:, None] - response.zeros).prod(axis=1)
        with np.errstate(all="ignore"):
            step = value / (leading * apart.prod(axis=1))
        roots = np.where(np.isfinite(step), roots - step, roots)
    return roots


def _cleaned(roots: Complexes) -> Complexes:
    """Put roots in order of magnitude, and on the axis if they are there to rounding."""
    roots = roots[np.argsort(np.abs(roots))]
    negligible = _ROUNDING * np.abs(roots).max(initial=0.0)
    return np.asarray(np.where(np.abs(roots.real) <= negligible, 1j * roots.imag, roots))
