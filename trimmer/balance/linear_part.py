"""The linear part of an element, which harmonic balance moves to the linear system without approximation.

With N = N_linear + N_rest, 1 + N G = 0 is 1/G + N_linear + N_rest = 0. So viscous friction, and the slope of
a preload, leave the element and join 1/G as a linear feedback round the system; what is left is bounded, or
proportional to 1/A.
"""

from __future__ import annotations

from dataclasses import dataclass, replace
from functools import reduce
from operator import add

import numpy as np

from trimmer.arrays import Complexes, Reals
from trimmer.balance.inverse_response import InverseResponse
from trimmer.elements.element import Element
from trimmer.elements.element_at_frequency import ElementAtFrequency
from trimmer.elements.preload import Preload
from trimmer.elements.relay import Relay
from trimmer.elements.scaled_element import ScaledElement
from trimmer.elements.sum_of_elements import SumOfElements
from trimmer.elements.viscous_friction import ViscousFriction
from trimmer.linear.frequency_response import UnsupportedSystemError


@dataclass(frozen=True)
class LinearGain:
    """The gain constant + j omega damping at all amplitudes, in output over input, and that times s."""

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


_EPSILON = float(np.finfo(float).eps)

_ROUNDING = 64 * _EPSILON  # Relative size below which a computed quantity is taken for a rounded zero

_NEAR_AXIS = 1e-6  # Real part over modulus up to which a pole may be one on the axis

_POLISHING = 3  # Steps, each of which squares the error of a root


def with_feedback(response: InverseResponse, feedback: LinearGain) -> InverseResponse:
    """Return 1/G plus a linear gain, in the unit of 1/G: its zeros are the poles of the loop.

    Its poles are the zeros of G. A zero that the imaginary axis holds as well, to rounding, is on it.
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
    is_real = not np.any(total.imag)
    roots = np.asarray(np.roots(total.real if is_real else total), dtype=complex)
    rooted = _polished(roots, complex(total[0]), is_real, response, feedback)
    return replace(response, gain=complex(total[0]), poles=rooted[np.argsort(np.abs(rooted))])


def _polished(
    roots: Complexes, leading: complex, is_real: bool, response: InverseResponse, feedback: LinearGain
) -> Complexes:
    """Improve roots by Weierstrass's method, with the polynomial in factors, which lose no digits."""
    above, below, real = roots.imag > 0, roots.imag < 0, roots.imag == 0
    for _ in range(_POLISHING):
        apart = roots[:, None] - roots
        np.fill_diagonal(apart, 1.0)
        value, _ = _sum_at(roots, response, feedback)
        with np.errstate(all="ignore"):
            step = value / (leading * apart.prod(axis=1))
        roots = np.asarray(np.where(np.isfinite(step), roots - step, roots), dtype=complex)
        if is_real:  # then they come in pairs, one beside the other
            roots[below] = roots[above].conj()
            roots.imag[real] = 0.0
    near = np.abs(roots.real) <= _NEAR_AXIS * np.abs(roots)
    value, size = _sum_at(np.asarray(1j * roots.imag, dtype=complex), response, feedback)
    on_axis = near & (np.abs(value) <= 4.0 * roots.size * _EPSILON * size)
    return np.asarray(np.where(on_axis, 1j * roots.imag, roots))


def _sum_at(s: Complexes, response: InverseResponse, feedback: LinearGain) -> tuple[Complexes, Reals]:
    """Evaluate gain prod(s - pole) + feedback prod(s - zero), and the sum of the moduli of both."""
    added = feedback.constant + feedback.damping * response.reference * s
    own = response.gain * (s[:, None] - response.poles).prod(axis=1)
    other = added * (s[:, None] - response.zeros).prod(axis=1)
    return np.asarray(own + other), np.asarray(np.abs(own) + np.abs(other))
