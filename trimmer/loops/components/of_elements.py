"""The switched components that an element is made of in the time domain, and those that have no modes."""

import math
import sys
from dataclasses import dataclass
from typing import final

from trimmer.elements.backlashes.friction_backlash import FrictionBacklash
from trimmer.elements.backlashes.inertia_backlash import InertiaBacklash
from trimmer.elements.backlashes.viscous_backlash import ViscousBacklash
from trimmer.elements.coulomb_friction import CoulombFriction
from trimmer.elements.dead_zone import DeadZone
from trimmer.elements.element import Element
from trimmer.elements.element_at_frequency import ElementAtFrequency
from trimmer.elements.preload import Preload
from trimmer.elements.relay import Relay
from trimmer.elements.saturation import Saturation
from trimmer.elements.scaled_element import ScaledElement
from trimmer.elements.sum_of_elements import SumOfElements
from trimmer.elements.unbounded import UnboundedElement
from trimmer.elements.viscous_friction import ViscousFriction
from trimmer.errors import UnsupportedMotionError
from trimmer.loops.components.backlash_component import BacklashComponent
from trimmer.loops.components.corner_component import CornerComponent
from trimmer.loops.components.relay_component import RelayComponent
from trimmer.loops.components.switched_component import Component, Explicit, OutputLaw, RateProportional
from trimmer.loops.components.threshold_component import ThresholdComponent


@final
@dataclass(frozen=True)
class RigidComponent(Component):
    """A pin without backlash: the output is the input."""

    name = "rigid pin"  # Name of the component: rigid pin; it has no events

    def output_law(self, mode: int) -> OutputLaw:
        """Return the law output = input."""
        return Explicit(1.0, (), 0.0)


@final
@dataclass(frozen=True)
class ViscousComponent(Component):
    """Viscous friction: a coefficient times the rate of the input, N s/m for a force of a displacement."""

    coefficient: float

    name = "viscous friction"  # Name of the component: viscous friction; it has no events
    output_jumps = True  # True: the output jumps with the rate of the input

    def output_law(self, mode: int) -> OutputLaw:
        """Return the law output = coefficient * rate of the input."""
        return RateProportional(self.coefficient)


def components_of(element: Element, of_velocity: bool = False) -> list[tuple[Component, float]]:
    """Return the components of an element, in the units of its terms, and the factors of their outputs."""
    match element:
        case SumOfElements():
            return [part for term in element.terms for part in components_of(term, of_velocity)]
        case ScaledElement():
            parts = components_of(element.element, of_velocity)
            return [(part, element.factor * factor) for part, factor in parts]
        case Preload():
            return [(RigidComponent(), element.slope), (RelayComponent(element.level, of_rate=False), 1.0)]
        case ViscousFriction() if of_velocity:
            return [(RigidComponent(), element.damping)]
        case CoulombFriction():
            return [(RelayComponent(element.force, not of_velocity, element.breakaway, of_velocity), 1.0)]
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
        case Relay():
            return _relay(element)
        case Saturation():
            return CornerComponent(element.threshold, element.slope, 0.0)
        case DeadZone():
            return CornerComponent(element.threshold, 0.0, element.slope)
        case ViscousFriction():
            return ViscousComponent(element.damping)
    reason = ": it is known by its output over a period only" if isinstance(element, UnboundedElement) else ""
    raise UnsupportedMotionError(f"{element!r} has no description in time{reason}")


def _relay(relay: Relay) -> Component:
    thresholds = relay.thresholds
    if thresholds is None:
        return RelayComponent(relay.level, of_rate=False)
    return ThresholdComponent(relay.level, thresholds.on, thresholds.off)


def _with_inverse(time_constant: float) -> float:
    """Return a time constant, or 0 if it is so small that its inverse is no number."""
    return time_constant if time_constant > 1.0 / sys.float_info.max else 0.0
