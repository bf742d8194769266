"""Values that a file leaves open: ``"unknown"``, or a range such as ``"20 um..60 um"``."""

import re
from collections.abc import Iterator, Mapping
from dataclasses import dataclass
from typing import Any

from trimmer.mechanism.controls.checks import SECTIONS
from trimmer.mechanism.controls.numbers import numbers_of
from trimmer.mechanism.kinds import kinds_of, numbers_of_part
from trimmer.mechanism.place_text import place_text
from trimmer.mechanism.problems import Problem
from trimmer.mechanism.quantities import FREQUENCY, PARTS, NumberField, Range
from trimmer.mechanism.units import UnitError, quantity

UNKNOWN = "unknown"
_RANGE = re.compile(r"(?P<lowest>[^.]*(?:\.[^.]+)*)\.\.(?P<highest>[^.]*(?:\.[^.]+)*)")
_NUMBER = re.compile(r"\s*[+-]?(?:[0-9]+\.?[0-9]*|\.[0-9]+)(?:[eE][+-]?[0-9]+)?\s*")


@dataclass(frozen=True)
class OpenValue:
    """A number that a file leaves open: names that lead there, what stands there, what it measures."""

    place: tuple[str, ...]
    text: str
    quantity: NumberField

    @property
    def is_unknown(self) -> bool:
        """Whether the file gives no range either."""
        return self.text.strip() == UNKNOWN

    def ends(self) -> tuple[float, float]:
        """Return both ends of the range, in the SI unit; an end without a unit takes that of the other."""
        found = _RANGE.fullmatch(self.text)
        if found is None:
            raise UnitError('is no range; write both ends, as in "20 um..60 um"')
        lowest, highest = found["lowest"].strip(), found["highest"].strip()
        if _NUMBER.fullmatch(lowest) and (unit := _unit(highest)):
            lowest = f"{lowest} {unit}"
        first, last = (quantity(each, self.quantity.unit) for each in (lowest, highest))
        for end in (first, last):
            if reason := self.quantity.reason_against(end):
                raise UnitError(f"has an end that {reason}")
        if not first < last:
            raise UnitError("has no length: write the smaller end first")
        return first, last

    def problem(self) -> Problem:
        """Return what to tell where one number is needed."""
        place = place_text(self.place)
        what = "nobody knows this value" if self.is_unknown else "this is a range"
        who = "'trimmer design' and 'trimmer sample'"
        reason = f"{what}, which {who} carry; write one number, or --set '{place}=VALUE'"
        return Problem(self.place, reason, self.text)


def open_values(content: Mapping[str, Any]) -> Iterator[OpenValue]:
    """Find the numbers that a file leaves open; what has a wrong form is passed over."""
    if _is_open(content.get("frequency")):
        yield OpenValue(("frequency",), content["frequency"], FREQUENCY)
    kinds = kinds_of(content)
    for section in (*PARTS, *SECTIONS):
        for name, entries in _tables(content.get(section)):
            numbers = (
                numbers_of_part(kinds, section, name, entries)
                if section in PARTS
                else numbers_of(content, kinds, section, name)
            )
            for key, wanted in numbers.items():
                if wanted.range is not Range.WHOLE and _is_open(entries.get(key)):
                    yield OpenValue((section, name, key), entries[key], wanted)


def replaced(content: Mapping[str, Any], values: Mapping[tuple[str, ...], float | str]) -> dict[str, Any]:
    """Return a file's content with numbers, SI or with a unit, in the places of what it leaves open."""
    whole = dict(content)
    for place, value in values.items():
        table = whole
        for name in place[:-1]:
            table[name] = dict(table[name])
            table = table[name]
        table[place[-1]] = value
    return whole


def _is_open(value: object) -> bool:
    return isinstance(value, str) and (value.strip() == UNKNOWN or ".." in value)


def _tables(section: object) -> Iterator[tuple[str, Mapping[str, Any]]]:
    if isinstance(section, dict):
        yield from ((name, entries) for name, entries in section.items() if isinstance(entries, dict))


def _unit(text: str) -> str:
    number = _NUMBER.match(text)
    return text[number.end() :].strip() if number else ""
