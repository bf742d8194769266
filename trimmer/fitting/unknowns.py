"""The numbers that are fitted, in coordinates without units."""

import math
from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np

from trimmer.arrays import Reals
from trimmer.errors import FitError, TrimmerError
from trimmer.mechanism.mechanism import Mechanism
from trimmer.mechanism.place_text import parse_place, place_text
from trimmer.mechanism.places import quantities
from trimmer.mechanism.quantities import Range
from trimmer.messages import listed
from trimmer.motion.subject import Subject
from trimmer.response.flows import called

REACH = 1e3  # Factor by which a positive number may leave its start, and how many times its size another one
USUAL = (("plays", ("gap", "stiffness", "damping")), ("frictions", ("force",)))
"""Numbers of a mechanism that are fitted if none is named."""
USUAL_OF_LOOP = ("element", "elements", "frictions")
"""What of a loop has the numbers that are fitted if none is named."""


@dataclass(frozen=True)
class Unknown:
    """A number that is fitted."""

    place: str  # Its dotted place
    unit: str  # SI unit
    start: float  # Its value in the file
    # Whether its coordinate is the logarithm of the value over the start; else the coordinate is the
    # difference from the start over the start's modulus (1 rad for a phase)
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


def unknowns_of(subject: Subject, free: Sequence[str] = ()) -> tuple[Unknown, ...]:
    """Return the numbers that are fitted, by their dotted places.

    By default they are gap, stiffness and damping of each play and the force of each friction, or the
    numbers of a loop's element and frictions, as far as they are finite and greater than zero.
    """
    if not free:
        usual = tuple(
            _unknown(subject, place) for place in _usual(subject) if 0 < subject.value(place) < math.inf
        )
        if not usual:
            parts = "play" if isinstance(subject, Mechanism) else "element"
            raise FitError(
                f"the {called(subject)} has no {parts} and no friction with a number greater than zero; name "
                "the numbers to fit (--free PLACE)"
            )
        return usual
    for place in free:
        subject.value(place)
    places = [place_text(parse_place(place)) for place in free]
    if twice := sorted({place for place in places if places.count(place) > 1}):
        raise FitError(f"{listed(twice)}: named twice among the numbers to fit")
    return tuple(_unknown(subject, place) for place in places)


def _usual(subject: Subject) -> list[str]:
    """Return the places of the numbers that are fitted if none is named."""
    if not isinstance(subject, Mechanism):
        return [place for place in subject.places if parse_place(place)[0] in USUAL_OF_LOOP]
    return [
        place_text((section, name, key))
        for section, keys in USUAL
        for name in getattr(subject, section)
        for key in keys
    ]


def _unknown(subject: Subject, place: str) -> Unknown:
    names = parse_place(place)
    start = subject.value(place)
    if names == ("frequency",):
        raise FitError("frequency: is taken from the measurement, and not fitted beside the motion")
    if names[0] == "start":
        raise FitError(f"{place}: a steady motion does not depend on it; leave it out")
    if names == ("drive", "phase"):
        raise FitError(f"{place}: when the record began in the drive's period is fitted anyway; leave it out")
    unit, is_whole, positive = _kind(subject, place, start)
    if is_whole:
        raise FitError(f"{place}: is a whole number, and cannot be fitted")
    if (start == 0 and unit != "rad") or math.isinf(start):
        raise FitError(
            f"{place}: is {start:g}, which gives no size to begin with; set another start (--set {place}=...)"
        )
    return Unknown(place, unit, start, positive)


def _kind(subject: Subject, place: str, start: float) -> tuple[str, bool, bool]:
    """Return the unit of a number, whether it is a whole one, and whether it cannot be negative."""
    if isinstance(subject, Mechanism):
        quantity = quantities(subject)[parse_place(place)]
        positive = quantity.range in (Range.POSITIVE, Range.NOT_NEGATIVE)
        return quantity.unit, quantity.range is Range.WHOLE, positive
    try:
        subject.with_value(place, -1.0 if math.isinf(start) else -abs(start))
    except TrimmerError:
        return subject.places[place], False, True
    return subject.places[place], False, start == 0


def values_at(unknowns: Sequence[Unknown], coordinates: Reals) -> list[float]:
    """Return the numbers of coordinates, (unknowns,)."""
    return [each.value(float(at)) for each, at in zip(unknowns, coordinates, strict=True)]


def bounds_of(unknowns: Sequence[Unknown]) -> tuple[Reals, Reals]:
    """Return the least and the largest coordinates, each (unknowns,)."""
    reach = np.array([each.reach for each in unknowns])
    return -reach, reach
