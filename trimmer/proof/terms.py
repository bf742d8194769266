"""A loop as data of a proof: coefficients and numbers of elements as they are, and nothing computed."""

import math
from typing import Any

import control
import numpy as np

from trimmer.elements.backlashes.backlash import Backlash
from trimmer.elements.backlashes.friction_backlash import FrictionBacklash
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
from trimmer.elements.viscous_friction import ViscousFriction
from trimmer.proof.statement import NUMBERS

_KINDS = {
    Relay: "relay",
    Preload: "preload",
    CoulombFriction: "Coulomb friction",
    ViscousFriction: "viscous friction",
    Saturation: "saturation",
    DeadZone: "dead zone",
}


def plant_data(system: control.lti.LTI) -> dict[str, Any]:
    """Return the coefficients of a linear system, of falling powers, or its matrices."""
    if isinstance(system, control.TransferFunction):
        sides = ("numerator", system.num[0][0]), ("denominator", system.den[0][0])
        return {name: np.asarray(side, dtype=float).tolist() for name, side in sides}
    return {name: np.asarray(getattr(system, name), dtype=float).tolist() for name in "ABCD"}


def element_data(
    element: Element, factors: tuple[float, ...] = (), frozen: float | None = None
) -> list[dict[str, Any]] | None:
    """Return the terms of an element, each with its factors; None if one has no closed form here."""
    if isinstance(element, SumOfElements):
        terms = [element_data(each, factors, frozen) for each in element.terms]
        return None if None in terms else [each for part in terms for each in part or ()]
    if isinstance(element, ScaledElement):
        return element_data(element.element, (*factors, float(element.factor)), frozen)
    if isinstance(element, ElementAtFrequency):
        return element_data(element.element, factors, frozen or float(element.omega))
    if isinstance(element, Backlash):
        return [{"kind": "backlash", **_backlash(element, frozen), "factors": list(factors)}]
    if type(element) not in _KINDS or (frozen and isinstance(element, ViscousFriction)):
        return None
    kind = _KINDS[type(element)]
    numbers = {name: float(getattr(element, name)) for name in NUMBERS[kind]}
    return [{"kind": kind, **numbers, "factors": list(factors)}]


def _backlash(element: Backlash, frozen: float | None) -> dict[str, float | None]:
    lag: float | None = 0.0 if isinstance(element, FrictionBacklash) else None
    if isinstance(element, ViscousBacklash) and math.isfinite(element.time_constant):
        lag = float(element.time_constant)
    return {"gap": float(element.gap), "time_constant": lag, "frozen_omega": frozen if lag else None}
