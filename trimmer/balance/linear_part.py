"""The linear part of an element, which harmonic balance takes over to the linear system exactly.

With N = N_linear + N_rest, 1 + N G = 0 is 1/G + N_linear + N_rest = 0. So viscous friction leaves the element
and joins 1/G, and what is left is bounded, or proportional to 1/A.
"""

from __future__ import annotations

from dataclasses import dataclass
from functools import reduce
from operator import add
from typing import TYPE_CHECKING

import numpy as np

from trimmer.elements.element_at_frequency import ElementAtFrequency
from trimmer.elements.scaled_element import ScaledElement
from trimmer.elements.sum_of_elements import SumOfElements
from trimmer.elements.viscous_friction import ViscousFriction

if TYPE_CHECKING:
    from numpy.typing import NDArray

    from trimmer.elements.element import Element

    Reals = NDArray[np.float64]
    Complexes = NDArray[np.complex128]


@dataclass(frozen=True)
class LinearGain:
    """The describing function constant + j omega damping, the same at all amplitudes.

    Attributes:
        constant: In the unit of output over input.
        damping: That times s.
    """

    constant: complex = 0.0
    damping: float = 0.0

    def __add__(self, other: LinearGain) -> LinearGain:
        return LinearGain(self.constant + other.constant, self.damping + other.damping)

    def scaled(self, factor: float) -> LinearGain:
        """Multiply it by a factor."""
        return LinearGain(factor * self.constant, factor * self.damping)

    def value(self, omega: Reals) -> Complexes:
        """Evaluate it at angular frequencies, rad/s."""
        return np.asarray(self.constant + 1j * self.damping * omega)

    def frozen(self, omega: float) -> LinearGain:
        """Take its value at one omega, rad/s, for all."""
        return LinearGain(self.constant + 1j * self.damping * omega)


def parted(element: Element) -> tuple[LinearGain, Element | None]:
    """Part an element into its linear part and the rest; None if there is no rest."""
    match element:
        case ViscousFriction():
            return LinearGain(damping=element.damping), None
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
