"""Quantities as text with a unit, such as ``40 um`` or ``3.5 N s/m``, in SI units.

A unit is a product of factors, then perhaps quotients: ``N s/m``, ``kg m``, ``m/s/s``. A factor is a name,
perhaps with a prefix and a power: ``mm^2``, ``s²``. After a quotient a product stands in brackets, as in
``N/(m s)``, since ``N/m s`` may be read in two ways. Numbers are multiplied as fractions, so that ``40 um``
is exactly the number ``40e-6``.
"""

from __future__ import annotations

import math
import re
from dataclasses import dataclass
from fractions import Fraction

from trimmer.messages import near_match
from trimmer.sizes import reason_against_size

_NUMBER_AND_UNIT = re.compile(
    r"\s*(?P<number>[+-]?(?:[0-9]+\.?[0-9]*|\.[0-9]+)(?:[eE](?P<exponent>[+-]?[0-9]+))?)\s*(?P<unit>.*?)\s*",
    flags=re.DOTALL,
)
_FACTOR = re.compile(r"(?P<name>[A-Za-zµμ]+|°|1)(?:\^(?P<power>[+-]?[1-9])|(?P<raised>⁻?[¹²³⁴⁵⁶⁷⁸⁹]))?")
_RAISED = str.maketrans("⁻¹²³⁴⁵⁶⁷⁸⁹", "-123456789")
_LONGEST_NUMBER = 60
_LARGEST_EXPONENT = 100  # Beyond these a fraction would cost memory


class UnitError(ValueError):
    """A text is no quantity of the dimension that is wanted; the message is the end of a sentence."""


@dataclass(frozen=True)
class MeasurementUnit:
    """A unit: scale · pi^half_turns in kilograms, metres, seconds and radians."""

    scale: Fraction  # Factor to the SI unit, without powers of pi
    dimension: tuple[int, int, int, int]  # Powers of kilogram, metre, second and radian
    half_turns: int = 0  # Power of pi in the factor

    def __mul__(self, other: MeasurementUnit) -> MeasurementUnit:
        kilogram, metre, second, radian = map(sum, zip(self.dimension, other.dimension, strict=True))
        half_turns = self.half_turns + other.half_turns
        return MeasurementUnit(self.scale * other.scale, (kilogram, metre, second, radian), half_turns)

    def __pow__(self, power: int) -> MeasurementUnit:
        kilogram, metre, second, radian = (power * exponent for exponent in self.dimension)
        return MeasurementUnit(self.scale**power, (kilogram, metre, second, radian), power * self.half_turns)


_PREFIXES = {
    "": Fraction(1),
    **{"n": Fraction(1, 10**9), "u": Fraction(1, 10**6), "µ": Fraction(1, 10**6), "μ": Fraction(1, 10**6)},
    **{"m": Fraction(1, 1000), "c": Fraction(1, 100), "k": Fraction(1000), "M": Fraction(10**6)},
}
"""The micro sign and the Greek letter look the same; keyboards have either."""

_ONE = MeasurementUnit(Fraction(1), (0, 0, 0, 0))
_TURNS_A_MINUTE = MeasurementUnit(Fraction(1, 30), (0, 0, -1, 1), 1)
_PREFIXED = {
    "g": (MeasurementUnit(Fraction(1, 1000), (1, 0, 0, 0)), "numk"),
    "m": (MeasurementUnit(Fraction(1), (0, 1, 0, 0)), "numck"),
    "s": (MeasurementUnit(Fraction(1), (0, 0, 1, 0)), "num"),
    "N": (MeasurementUnit(Fraction(1), (1, 1, -2, 0)), "numkM"),
    "Hz": (MeasurementUnit(Fraction(1), (0, 0, -1, 0)), "mkM"),
    "rad": (MeasurementUnit(Fraction(1), (0, 0, 0, 1)), "m"),
}
_UNITS = {
    "1": _ONE,
    "t": MeasurementUnit(Fraction(1000), (1, 0, 0, 0)),
    "min": MeasurementUnit(Fraction(60), (0, 0, 1, 0)),
    "rpm": MeasurementUnit(Fraction(1, 60), (0, 0, -1, 0)),
    "Ns": MeasurementUnit(Fraction(1), (1, 1, -1, 0)),
    "deg": MeasurementUnit(Fraction(1, 180), (0, 0, 0, 1), 1),
    "°": MeasurementUnit(Fraction(1, 180), (0, 0, 0, 1), 1),
    "arcmin": MeasurementUnit(Fraction(1, 60 * 180), (0, 0, 0, 1), 1),
    "arcsec": MeasurementUnit(Fraction(1, 3600 * 180), (0, 0, 0, 1), 1),
    **{
        prefix + name: MeasurementUnit(size * unit.scale, unit.dimension)
        for name, (unit, allowed) in _PREFIXED.items()
        for prefix, size in _PREFIXES.items()
        if prefix.replace("µ", "u").replace("μ", "u") in ("", *allowed)
    },
}


def unit(text: str) -> MeasurementUnit:
    """Read a unit that can be read in one way only."""
    numerator, *denominators = text.replace("**", "^").split("/")
    result = _product(numerator, text)
    for denominator in denominators:
        bracketed = re.fullmatch(r"\s*\((.*)\)\s*", denominator)
        if bracketed is None and re.search(r"\S[\s*·⋅]+\S", denominator):
            raise UnitError(
                f"unit {text!r} can be read in two ways: write products first, as in 'N s/m', or in "
                "brackets, as in 'N/(m s)'"
            )
        result *= _product(bracketed[1] if bracketed else denominator, text) ** -1
    return result


def _product(text: str, whole: str) -> MeasurementUnit:
    result = _ONE
    for factor in re.split(r"\s*[*·⋅]\s*|\s+", text.strip()):
        result *= _factor(factor, whole)
    return result


def quantity(text: str, si_unit: str) -> float:
    """Read a number with its unit, such as ``40 um``, and give it in an SI unit, which may be ``1``."""
    found = _NUMBER_AND_UNIT.fullmatch(text)
    if found is None:
        raise UnitError(f"is no number{'' if si_unit == '1' else ' with a unit'}; text is not evaluated")
    if len(found["number"]) > _LONGEST_NUMBER or abs(int((found["exponent"] or "0")[:9])) > _LARGEST_EXPONENT:
        raise UnitError("has too many digits, or is too large or too small to be computed with")
    if reason := reason_against_size(float(found["number"])):
        raise UnitError(reason)
    wanted = unit(si_unit)
    if not found["unit"] and wanted != _ONE:
        raise UnitError(
            f"has no unit: write the number in {si_unit} without quotation marks, or add the unit"
        )
    given = _given(found["unit"] or "1", wanted)
    if given.dimension != wanted.dimension:
        raise UnitError(f"{found['unit']!r} does not measure what {si_unit} does")
    return float(Fraction(found["number"]) * given.scale / wanted.scale) * math.pi**given.half_turns


def dimension_of(text: str) -> tuple[int, int, int, int]:
    """Return what the unit of a quantity measures: powers of kilogram, metre, second and radian."""
    found = _NUMBER_AND_UNIT.fullmatch(text)
    if found is None:
        raise UnitError("is no number with a unit; text is not evaluated")
    return _given(found["unit"] or "1", _TURNS_A_MINUTE).dimension


def _given(text: str, wanted: MeasurementUnit) -> MeasurementUnit:
    """Return the unit of a text; rpm are a frequency, or an angular velocity where one is wanted."""
    turns = text == "rpm" and wanted.dimension == _TURNS_A_MINUTE.dimension
    return _TURNS_A_MINUTE if turns else unit(text)


def _factor(text: str, whole: str) -> MeasurementUnit:
    found = _FACTOR.fullmatch(text)
    if found is None or found["name"] not in _UNITS:
        name = found["name"] if found else text
        advice = near_match(name, _UNITS) or "known are m, kg, s, N, Hz, rad, deg with prefixes, as in 'N/mm'"
        raise UnitError(f"has the unknown unit {whole!r}; {advice}")
    return _UNITS[found["name"]] ** int(found["power"] or (found["raised"] or "1").translate(_RAISED))
