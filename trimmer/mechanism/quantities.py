"""Which fields of the parts are numbers: unit, and which values will do."""

import math
from collections.abc import Iterator, Mapping
from dataclasses import dataclass
from enum import Enum
from numbers import Real
from types import MappingProxyType

from trimmer.arguments import scalar
from trimmer.mechanism.parts import Body, Force, Friction, Link, Pin, Play, Stop, Wall
from trimmer.mechanism.problems import NOTHING, Problem
from trimmer.mechanism.structures.structure import Structure
from trimmer.mechanism.units import quantity

_LOWEST = 1e-300  # Hz; thousands of periods of it are still finite


class Range(Enum):
    """Which numbers will do; the value says so after "must be"."""

    ANY = "finite"
    NOT_NEGATIVE = "zero or greater"
    POSITIVE = "greater than zero"
    WHOLE = "a whole number from 1 on"
    SHARE = "from 0 to 1"
    TO_INFINITY = "greater than zero, or inf"


@dataclass(frozen=True)
class NumberField:
    """A field of a part that is a number."""

    unit: str  # SI unit as text, such as ``N/m``
    example: str  # How it may be written as text in a file
    range: Range = Range.ANY  # Which values will do

    def reason_against(self, value: object) -> str:
        """Return why a value cannot be used, as a piece of a message; empty if it can.

        NumPy's real scalars count as numbers; truth values, text and complex numbers do not.
        """
        if not is_number(value):
            return f"give a number{self._in_unit}"
        number = self.taken(value)
        if self.range is Range.TO_INFINITY and value == math.inf:
            return ""
        if isinstance(number, float) and not math.isfinite(number):
            return "is too large for a floating-point number" if isinstance(value, int) else "must be finite"
        if self.unit == "Hz" and not math.isfinite(math.tau * number):
            return "is too large: its angular frequency must be finite"
        if self.unit == "Hz" and 0 < number < _LOWEST:
            return "is too small: its period must be finite"
        return "" if self._fits(number) else f"must be {self.range.value}{self._in_unit}"

    def _fits(self, number: float) -> bool:
        match self.range:
            case Range.ANY:
                return True
            case Range.NOT_NEGATIVE:
                return number >= 0
            case Range.POSITIVE | Range.TO_INFINITY:
                return number > 0
            case Range.WHOLE:
                return isinstance(number, int) and number >= 1
            case Range.SHARE:
                return 0 <= number <= 1

    def problems(self, place: tuple[str, ...], value: object) -> Iterator[Problem]:
        """Find what is wrong with a value at a place; None is one that is missing."""
        if reason := self.reason_against(value):
            missing = value is None
            yield Problem(place, f"missing; {reason}" if missing else reason, NOTHING if missing else value)

    def read(self, text: str) -> float:
        """Return the number of a text in the SI unit."""
        if self.range is Range.TO_INFINITY and text.strip() == "inf":
            return math.inf
        return quantity(text, self.unit)

    def taken(self, value: object) -> float:
        """Return a number as the float, or for a whole one the int, that the parts hold."""
        try:
            number = float(scalar(value))  # type: ignore[arg-type]
        except OverflowError:
            return math.inf
        return int(number) if self.range is Range.WHOLE and number.is_integer() else number

    @property
    def _in_unit(self) -> str:
        return "" if self.unit == "1" else f", in {self.unit}"


def is_number(value: object) -> bool:
    """Say whether a value is a real number; truth values are none, scalars of NumPy are."""
    number = scalar(value)
    return isinstance(number, Real) and not isinstance(number, bool)


def if_plain(value: object) -> object:
    """Return a text or a number, and of what else stands in a file nothing, as it is too long to show."""
    return value if isinstance(value, str) or is_number(value) else NOTHING


FREQUENCY = NumberField("Hz", "110 Hz", Range.POSITIVE)
DISPLACEMENT = NumberField("m", "40 um")
VELOCITY = NumberField("m/s", "20 mm/s")
WEIGHT = NumberField("1", "1")
_MASS = NumberField("kg", "35 g", Range.POSITIVE)
_INERTIA = NumberField("kg m²", "2e-6 kg m^2", Range.POSITIVE)
_STIFFNESS = NumberField("N/m", "200 N/mm", Range.NOT_NEGATIVE)
_DAMPING = NumberField("N s/m", "3.5 N s/m", Range.NOT_NEGATIVE)
_CLEARANCE = NumberField("m", "40 um", Range.NOT_NEGATIVE)
FORCE = NumberField("N", "500 mN")
FORCE_LIMIT = NumberField("N", "500 mN", Range.NOT_NEGATIVE)
PHASE = NumberField("rad", "90 deg")
ORDER = NumberField("1", "2", Range.WHOLE)

QUANTITIES: Mapping[type, Mapping[str, NumberField]] = MappingProxyType(
    {
        Body: {"mass": _MASS, "inertia": _INERTIA},
        Structure: {"damping_ratio": NumberField("1", "0.02", Range.NOT_NEGATIVE)},
        Pin: {
            **{"amplitude": DISPLACEMENT, "phase": PHASE, "offset": DISPLACEMENT, "velocity": VELOCITY},
            "order": ORDER,
        },
        Link: {"stiffness": _STIFFNESS, "damping": _DAMPING},
        Play: {"stiffness": _STIFFNESS, "damping": _DAMPING, "gap": _CLEARANCE},
        Stop: {"stiffness": _STIFFNESS, "damping": _DAMPING, "gap": DISPLACEMENT},
        Wall: {"restitution": NumberField("1", "0.8", Range.SHARE), "gap": DISPLACEMENT},
        Friction: {"force": FORCE_LIMIT, "static": FORCE_LIMIT, "viscous": _DAMPING},
        Force: {
            **{"constant": FORCE, "amplitude": FORCE, "phase": PHASE, "order": ORDER},
            "unbalance": NumberField("kg m", "50 g mm"),
        },
    }
)
"""The numbers of each kind of part, by field, in units of translations; see ``kinds``."""

PARTS: Mapping[str, type] = MappingProxyType(
    {
        "bodies": Body,
        "structures": Structure,
        "pins": Pin,
        "links": Link,
        "plays": Play,
        "stops": Stop,
        "walls": Wall,
        "frictions": Friction,
        "forces": Force,
    }
)
"""What each section holds, apart from ``outputs`` and ``start``."""
