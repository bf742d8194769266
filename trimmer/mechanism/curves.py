"""Curves of links and frictions: a force by points, straight between them."""

from __future__ import annotations

from collections.abc import Callable, Iterator, Mapping
from dataclasses import dataclass, replace
from itertools import pairwise
from types import MappingProxyType
from typing import Any

from trimmer.mechanism.kinds import Kind
from trimmer.mechanism.parts import Curve, Friction, Link
from trimmer.mechanism.problems import Problem
from trimmer.mechanism.quantities import DISPLACEMENT, VELOCITY, NumberField, Range

FORCE = NumberField("N", "500 mN")


@dataclass(frozen=True)
class CurveForm:
    """What a curve is drawn over, and what will do.

    Attributes:
        keys: Names of abscissa and ordinate in dotted places.
        numbers: What they measure.
        fewest: Smallest number of points.
        example: How one is written.
    """

    keys: tuple[str, str]
    numbers: tuple[NumberField, NumberField]
    fewest: int
    example: str

    def of(self, kind: Kind) -> CurveForm:
        """Return the form of the same curve of a kind."""
        abscissa, ordinate = map(kind.field, self.numbers)
        return replace(self, numbers=(abscissa, ordinate))


FORMS: Mapping[type, CurveForm] = MappingProxyType(
    {
        Link: CurveForm(("elongation", "force"), (DISPLACEMENT, FORCE), 2, "[[-1e-3, -5.0], [1e-3, 5.0]]"),
        Friction: CurveForm(
            ("speed", "force"),
            (VELOCITY, NumberField("N", "500 mN", Range.NOT_NEGATIVE)),
            1,
            "[[0.0, 1.0], [0.5, 0.6]]",
        ),
    }
)
"""The curves that parts may have, by their kind."""


def problems_of_types(place: tuple[str, ...], curve: object, form: CurveForm) -> Iterator[Problem]:
    """Find what makes a value no curve: points, numbers."""
    points = curve if isinstance(curve, list | tuple) else ()
    what = " and ".join(f"{key} in {of.unit}" for key, of in zip(form.keys, form.numbers, strict=True))
    if len(points) < form.fewest or not all(map(_is_pair, points)):
        least = "two points" if form.fewest > 1 else "one point"
        yield Problem(place, f"give at least {least} [{what}], as in {form.example}", curve)
        return
    for number, point in enumerate(points, start=1):
        for key, of, value in zip(form.keys, form.numbers, point, strict=True):
            if reason := of.reason_against(value):
                yield Problem((*place, str(number), key), reason, value)


def problems_of_points(place: tuple[str, ...], part: Link | Friction) -> Iterator[Problem]:
    """Find points of a curve that do not go together."""
    if part.curve is None:
        return
    key, _ = FORMS[type(part)].keys
    abscissae = [float(each) for each, _ in part.curve]
    if isinstance(part, Friction) and abscissae[0] != 0.0:
        reason = "the curve of a friction begins at the speed 0; write its kinetic force there"
        yield Problem((*place, "curve", "1", key), reason, abscissae[0])
    for number, (before, after) in enumerate(pairwise(abscissae), start=2):
        if not before < after:
            reason = f"the {key} must rise from point to point, and that before is {before!r}"
            yield Problem((*place, "curve", str(number), key), reason, after)


def _is_pair(point: object) -> bool:
    return isinstance(point, list | tuple) and len(point) == 2


def taken(curve: Any, form: CurveForm) -> Curve:
    """Return the points of a curve as floats."""
    return tuple(tuple(of.taken(each) for of, each in zip(form.numbers, p, strict=True)) for p in curve)  # type: ignore[misc]


def read(
    place: tuple[str, ...],
    value: object,
    form: CurveForm,
    number: Callable[[tuple[str, ...], object, NumberField], Any],
) -> object:
    """Return a curve of a file with numbers for its texts; what is no list of pairs stays as it is."""
    if not isinstance(value, list) or not all(map(_is_pair, value)):
        return value
    named = list(zip(form.keys, form.numbers, strict=True))
    return [
        [number((*place, str(count), key), each, of) for (key, of), each in zip(named, point, strict=True)]
        for count, point in enumerate(value, start=1)
    ]


def quantities(part: object, kind: Kind) -> Mapping[tuple[str, ...], NumberField]:
    """Return the numbers of the curve of a part, if it has one, by the end of their places."""
    form, curve = FORMS.get(type(part)), getattr(part, "curve", None)
    if form is None or curve is None:
        return {}
    return {
        ("curve", str(number), key): of
        for number in range(1, len(curve) + 1)
        for key, of in zip(form.keys, form.of(kind).numbers, strict=True)
        if (number, key) != (1, "speed")  # Sliding begins at 0.
    }


def value_at(part: Link | Friction, point: str, key: str) -> float:
    """Return a number of a curve, its points counted from 1."""
    assert part.curve is not None
    return part.curve[int(point) - 1][FORMS[type(part)].keys.index(key)]


def with_value_at(part: Link | Friction, point: str, key: str, value: float) -> Curve:
    """Return a curve with another number, its points counted from 1."""
    assert part.curve is not None
    points = [list(each) for each in part.curve]
    points[int(point) - 1][FORMS[type(part)].keys.index(key)] = value
    return taken(points, FORMS[type(part)])


def is_odd(curve: Curve) -> bool:
    """Say whether a curve of a link is the same in both directions."""
    return sorted((-d, -force) for d, force in curve) == sorted(curve)
