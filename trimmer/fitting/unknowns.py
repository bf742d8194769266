"""The numbers that are fitted, in coordinates without units."""

from __future__ import annotations

import math
from collections.abc import Sequence
from dataclasses import dataclass
from typing import TYPE_CHECKING

import numpy as np

from trimmer.errors import FitError
from trimmer.mechanism.place_text import parse_place, place_text
from trimmer.mechanism.places import quantities
from trimmer.mechanism.quantities import Range
from trimmer.messages import listed

if TYPE_CHECKING:
    from trimmer.arrays import Reals
    from trimmer.mechanism.mechanism import Mechanism

REACH = 1e3
"""Factor by which a positive number may leave its start, and how many times its size another one."""
USUAL = (("plays", ("gap", "stiffness", "damping")), ("frictions", ("force",)))
"""Numbers that are fitted if none is named."""


@dataclass(frozen=True)
class Unknown:
    """A number that is fitted.

    Attributes:
        place: Its dotted place.
        unit: SI unit.
        start: Its value in the file.
        positive: Whether its coordinate is the logarithm of the value over the start; else the coordinate is
            the difference from the start over the start's modulus (1 rad for a phase).
    """

    place: str
    unit: str
    start: float
    positive: bool

    @property
    def scale(self) -> float:
        """Change of the number with its coordinate, at the start."""
        return 1.0 if self.unit == "rad" else abs(self.start)

    @property
    def reach(self) -> float:
        """Largest modulus of the coordinate."""
        return math.log(REACH) if self.positive else REACH

    def value(self, coordinate: float) -> float:
        """Return the number of a coordinate."""
        if self.positive:
            return self.start * math.exp(coordinate)
        return self.start + self.scale * coordinate

    @property
    def short(self) -> str:
        """The key and what it belongs to, as ``gap of bridge``."""
        names = parse_place(self.place)
        return f"{names[-1]} of {names[-2]}" if len(names) > 1 else self.place


def unknowns_of(mechanism: Mechanism, free: Sequence[str] = ()) -> tuple[Unknown, ...]:
    """Return the numbers that are fitted.

    Args:
        mechanism: The mechanism with their starting values.
        free: Dotted places; by default gap, stiffness and damping of each play and the force of each
            friction, as far as they are greater than zero.

    Raises:
        FitError: if there is nothing to fit, or a number is named that cannot be fitted.
        MechanismError: if there is no such number.
    """
    if not free:
        places = [
            place_text((section, name, key))
            for section, keys in USUAL
            for name in getattr(mechanism, section)
            for key in keys
        ]
        usual = tuple(_unknown(mechanism, place) for place in places if mechanism.value(place) > 0)
        if not usual:
            raise FitError(
                "the mechanism has no play and no friction with a number greater than zero; name the numbers "
                "to fit (--free PLACE)"
            )
        return usual
    for place in free:
        mechanism.value(place)
    places = [place_text(parse_place(place)) for place in free]
    if twice := sorted({place for place in places if places.count(place) > 1}):
        raise FitError(f"{listed(twice)}: named twice among the numbers to fit")
    return tuple(_unknown(mechanism, place) for place in places)


def _unknown(mechanism: Mechanism, place: str) -> Unknown:
    names = parse_place(place)
    quantity = quantities(mechanism)[names]
    start = mechanism.value(place)
    if names == ("frequency",):
        raise FitError("frequency: is taken from the measurement, and not fitted beside the motion")
    if names[0] == "start":
        raise FitError(f"{place}: a steady motion does not depend on it; leave it out")
    if quantity.range is Range.WHOLE:
        raise FitError(f"{place}: is a whole number, and cannot be fitted")
    if start == 0 and quantity.unit != "rad":
        raise FitError(
            f"{place}: is 0, which gives no size to begin with; set another start (--set {place}=...)"
        )
    positive = quantity.range in (Range.POSITIVE, Range.NOT_NEGATIVE)
    return Unknown(place, quantity.unit, start, positive)


def values_at(unknowns: Sequence[Unknown], coordinates: Reals) -> list[float]:
    """Return the numbers of coordinates, (unknowns,)."""
    return [each.value(float(at)) for each, at in zip(unknowns, coordinates, strict=True)]


def bounds_of(unknowns: Sequence[Unknown]) -> tuple[Reals, Reals]:
    """Return the least and the largest coordinates, each (unknowns,)."""
    reach = np.array([each.reach for each in unknowns])
    return -reach, reach
