"""A loop as harmonic balance treats it: 1/G with the linear part of the element, and the rest of it."""

import math
from dataclasses import dataclass, field, replace
from functools import lru_cache
from typing import Self

import control
import numpy as np

from trimmer.arguments import shown
from trimmer.balance.element_curve import ElementCurve
from trimmer.balance.factoring_error import factoring_error
from trimmer.balance.inverse_response import LARGEST_ERROR, InverseResponse
from trimmer.balance.linear_part import LinearGain, parted, with_feedback
from trimmer.elements.control_element import adopted, is_element
from trimmer.elements.element import Element
from trimmer.errors import LinearElementError, UnsupportedElementError
from trimmer.linear.frequency_response import UnsupportedSystemError, require_siso
from trimmer.linear.zero_pole_gain import ZeroPoleGain

_NOTHING = LinearGain()


@dataclass(frozen=True)
class LoopEquation:
    """N + 1/G = 0: a response, which is 1/G plus the linear part of N, and the curve of its rest."""

    response: InverseResponse
    curve: ElementCurve
    linear: LinearGain = field(default=_NOTHING)

    @property
    def unproven(self) -> tuple[str, ...]:
        """What poles and zeros do not tell of the system, in sentences without a full stop."""
        if self.response.error <= LARGEST_ERROR:
            return ()
        return (
            "what the system was given by does not tell its poles and zeros: with those that were found "
            f"G(j omega) is uncertain by {min(self.response.error, 1.0):.1g}, relative, so limit cycles may "
            "be missing from the list; give the system in parts, as a state-space system",
        )


def require_element(element: object) -> Element:
    """Return the element that was given; a nonlinearity of python-control, if it is odd, as one."""
    if isinstance(element, type):
        raise UnsupportedElementError(
            f"element: the class {element.__name__} is not an element: give an instance, such as "
            "FrictionBacklash(4e-5)"
        )
    if not is_element(element):
        raise UnsupportedElementError(
            f"element: {shown(element)} is not an element: give a trimmer.elements.Element"
        )
    return adopted("element", element)


def loop_equation(G: control.lti.LTI, element: Element) -> LoopEquation:
    """Return the equation of a loop with negative feedback, with the linear part of the element split off."""
    require_element(element)
    response = inverse_response(G)
    linear, rest = parted(element)
    if rest is None:
        raise LinearElementError(
            f"{element!r} is linear: its describing function does not depend on the amplitude, so "
            "nothing sets the amplitude of a limit cycle"
        )
    if linear == _NOTHING:
        loop = LoopEquation(response, ElementCurve(element))
    else:
        closed = with_feedback(response, linear)
        closed = replace(closed, error=factoring_error(G, linear, closed))
        loop = LoopEquation(closed, ElementCurve(rest), linear)
    if loop.response.poles.size == 0:
        raise UnsupportedSystemError(
            "the system is a constant gain: nothing sets the frequency of a limit cycle"
        )
    return loop


def inverse_response(G: control.lti.LTI) -> InverseResponse:
    """Return 1/G of a proper system; the last few are kept, since sweeps ask for the same one again."""
    require_siso(G)
    return _inverse_response(ComparedSystem.of(G))


def range_of_roots(response: InverseResponse, beyond: float) -> tuple[float, float]:
    """Return the smallest and the largest x of the roots of G, widened on either side."""
    sizes = np.abs(response.roots[response.roots != 0]) * response.reference
    lowest, highest = sizes.min(initial=response.reference), sizes.max(initial=response.reference)
    return math.log(lowest) - beyond, math.log(highest) + beyond


@dataclass(frozen=True)
class ComparedSystem:
    """A system that is compared by its coefficients, so that a change of the object in place is noticed."""

    coefficients: tuple[bytes, ...]
    system: control.lti.LTI = field(compare=False)

    @classmethod
    def of(cls, G: control.lti.LTI) -> Self:
        """Take a system with one input and one output."""
        return cls(_coefficients(G), G)


def _coefficients(G: control.lti.LTI) -> tuple[bytes, ...]:
    fraction = isinstance(G, control.TransferFunction)
    parts = (G.num[0][0], G.den[0][0]) if fraction else (G.A, G.B, G.C, G.D)
    return tuple(np.asarray(part, dtype=float).tobytes() for part in parts)


@lru_cache(maxsize=16)  # A sweep over gaps, loads or forces asks for the same system again and again.
def _inverse_response(given: ComparedSystem) -> InverseResponse:
    factored = ZeroPoleGain.of(given.system)
    if factored.relative_degree < 0:
        raise UnsupportedSystemError("the system has more zeros than poles: give a proper one")
    response = InverseResponse.of(factored)
    return replace(response, error=factoring_error(given.system, _NOTHING, response))
