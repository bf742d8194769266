"""The switched components that an element is made of in the time domain."""

from __future__ import annotations

import math
import sys
from typing import TYPE_CHECKING

from trimmer.elements.coulomb_friction import CoulombFriction
from trimmer.elements.element_at_frequency import ElementAtFrequency
from trimmer.elements.friction_backlash import FrictionBacklash
from trimmer.elements.inertia_backlash import InertiaBacklash
from trimmer.elements.relay import Relay
from trimmer.elements.scaled_element import ScaledElement
from trimmer.elements.sum_of_elements import SumOfElements
from trimmer.elements.viscous_backlash import ViscousBacklash
from trimmer.elements.viscous_friction import ViscousFriction
from trimmer.errors import UnsupportedMotionError
from trimmer.motion.backlash_component import BacklashComponent
from trimmer.motion.linear_components import ViscousComponent
from trimmer.motion.relay_component import RelayComponent

if TYPE_CHECKING:
    from trimmer.elements.element import Element
    from trimmer.motion.switched_component import Component


def components_of(element: Element) -> list[tuple[Component, float]]:
    """Return the components of an element in the order of its terms, each with the factor of its output.

    A component has the units of its term; the factors of nested scaled elements are multiplied.

    Raises:
        UnsupportedMotionError: if the element has no motion in time, as one that is frozen at a frequency.
    """
    match element:
        case SumOfElements():
            return [part for term in element.terms for part in components_of(term)]
        case ScaledElement():
            return [(part, element.factor * factor) for part, factor in components_of(element.element)]
        case ElementAtFrequency():
            raise UnsupportedMotionError(
                f"{element!r} is frozen at a frequency; its motion is that of {element.element!r}"
            )
    return [(_component(element), 1.0)]


def _component(element: Element) -> Component:
    match element:
        case FrictionBacklash():
            return BacklashComponent(element.gap, 0.0)
        case InertiaBacklash():
            return BacklashComponent(element.gap, math.inf)
        case ViscousBacklash():
            return BacklashComponent(element.gap, _with_inverse(element.time_constant))
        case CoulombFriction():
            return RelayComponent(element.force, of_rate=True)
        case Relay():
            return RelayComponent(element.level, of_rate=False)
        case ViscousFriction():
            return ViscousComponent(element.damping)
    raise UnsupportedMotionError(f"{element!r} has no description in time")


def _with_inverse(time_constant: float) -> float:
    """Return a time constant, or 0 if it is so small that its inverse is no number."""
    return time_constant if time_constant > 1.0 / sys.float_info.max else 0.0
