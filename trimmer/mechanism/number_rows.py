"""Lists of rows of numbers in a part: ``harmonics``, the ``profile`` of a force, the ``curve`` of a link."""

from __future__ import annotations

from collections.abc import Callable, Iterator, Mapping
from dataclasses import dataclass, replace
from itertools import pairwise
from types import MappingProxyType
from typing import Any

from trimmer.mechanism.kinds import Kind
from trimmer.mechanism.parts import Force, Friction, Link, Pin, Row
from trimmer.mechanism.problems import Problem
from trimmer.mechanism.quantities import DISPLACEMENT, FORCE, FORCE_LIMIT, ORDER, PHASE, VELOCITY, NumberField

TIME = NumberField("s", "10 ms")
_FEWEST = ("one row", "one point", "two points")


@dataclass(frozen=True)
class RowForm:
    """What a row holds."""

    numbers: Mapping[str, NumberField]  # What each number measures, by its name in dotted places
    example: str  # How such a list is written
    points: int = 0  # Fewest points of a curve; 0 of other lists, which have at least one row

    @property
    def abscissa(self) -> str | None:
        """The number that rises from row to row, which is the first; None for harmonics."""
        first = next(iter(self.numbers))
        return None if first == "order" else first

    def of(self, kind: Kind) -> RowForm:
        """Return the form of the same list of a kind."""
        return replace(self, numbers={key: kind.field(each) for key, each in self.numbers.items()})


def _harmonics(amplitude: NumberField, example: str) -> RowForm:
    return RowForm({"order": ORDER, "amplitude": amplitude, "phase": PHASE}, example)


FORMS: Mapping[type, Mapping[str, RowForm]] = MappingProxyType(
    {
        Link: {
            "curve": RowForm({"elongation": DISPLACEMENT, "force": FORCE}, "[[-1e-3, -5.0], [1e-3, 5.0]]", 2)
        },
        Friction: {
            "curve": RowForm({"speed": VELOCITY, "force": FORCE_LIMIT}, "[[0.0, 1.0], [0.5, 0.6]]", 1)
        },
        Pin: {"harmonics": _harmonics(DISPLACEMENT, "[[2, 0.4e-3, 0.9]]")},
        Force: {
            "harmonics": _harmonics(FORCE, "[[2, 0.5, 0.3]]"),
            "profile": RowForm({"time": TIME, "force": FORCE}, "[[0.01, 0.0], [0.012, 1.5]]"),
        },
    }
)
"""The lists that parts may have, by their kind and key."""


def forms_of(part: object) -> Mapping[str, RowForm]:
    """Return the lists that a part, or parts of a kind, may have, by key."""
    return FORMS.get(part if isinstance(part, type) else type(part), {})


def problems_of_types(place: tuple[str, ...], rows: object, form: RowForm) -> Iterator[Problem]:
    """Find what makes a value no list of rows."""
    listed = rows if isinstance(rows, list | tuple) else ()
    if len(listed) < max(form.points, 1) or not all(_is_row(row, form) for row in listed):
        named = (f"{key} in {of.unit}" if of.unit != "1" else key for key, of in form.numbers.items())
        what = (" and " if form.points else ", ").join(named)
        yield Problem(place, f"give at least {_FEWEST[form.points]} [{what}], as in {form.example}", rows)
        return
    for number, row in enumerate(listed, start=1):
        for (key, of), value in zip(form.numbers.items(), row, strict=True):
            if reason := of.reason_against(value):
                yield Problem((*place, str(number), key), reason, value)


def problems_of_order(place: tuple[str, ...], part: object) -> Iterator[Problem]:
    """Find abscissae of points that do not rise, and a curve of a friction that does not begin at rest."""
    for key, form in forms_of(part).items():
        if (abscissa := form.abscissa) is None:
            continue
        found = [float(row[0]) for row in getattr(part, key) or ()]
        if isinstance(part, Friction) and found and found[0] != 0.0:
            reason = "the curve of a friction begins at the speed 0; write its kinetic force there"
            yield Problem((*place, key, "1", abscissa), reason, found[0])
        for number, (before, after) in enumerate(pairwise(found), start=2):
            if not before < after:
                reason = f"the {abscissa} must rise from point to point, and that before is {before!r}"
                yield Problem((*place, key, str(number), abscissa), reason, after)


def _is_row(row: object, form: RowForm) -> bool:
    return isinstance(row, list | tuple) and len(row) == len(form.numbers)


def taken(rows: Any, form: RowForm) -> tuple[Row, ...]:
    """Return rows as tuples of numbers."""
    fields = form.numbers.values()
    return tuple(tuple(of.taken(each) for of, each in zip(fields, row, strict=True)) for row in rows)


def read(
    place: tuple[str, ...],
    value: object,
    form: RowForm,
    number: Callable[[tuple[str, ...], object, NumberField], Any],
) -> object:
    """Return rows of a file with numbers for its texts; what is no list of rows stays as it is."""
    if not isinstance(value, list) or not all(_is_row(row, form) for row in value):
        return value
    named = list(form.numbers.items())
    return [
        [number((*place, str(count), key), each, of) for (key, of), each in zip(named, row, strict=True)]
        for count, row in enumerate(value, start=1)
    ]


def quantities(part: object, kind: Kind) -> Mapping[tuple[str, ...], NumberField]:
    """Return the numbers of the lists that a part has, by the end of their places."""
    return {
        (key, str(number), name): of
        for key, form in forms_of(part).items()
        for number in range(1, len(getattr(part, key) or ()) + 1)
        for name, of in form.of(kind).numbers.items()
        if (number, name) != (1, "speed")  # Sliding begins at 0.
    }


def columns_of(part: object, key: str) -> tuple[str, ...]:
    """Return what the numbers of a row are called; of a reference they are time and value."""
    form = forms_of(part).get(key)
    return ("time", "value") if form is None else tuple(form.numbers)


def value_at(part: object, key: str, row: str, name: str) -> float:
    """Return a number of a list, its rows counted from 1."""
    return float(getattr(part, key)[int(row) - 1][columns_of(part, key).index(name)])
