"""The numbers of a mechanism by their dotted places, such as ``plays.bridge.gap``: read, replaced, listed."""

from collections.abc import Iterable, Mapping, Sequence
from dataclasses import replace
from functools import lru_cache
from typing import Any, Protocol, Self, TypeVar

from trimmer.arguments import require_instance
from trimmer.errors import MechanismError, TrimmerError
from trimmer.mechanism import number_rows
from trimmer.mechanism.controls import reading as control_reading
from trimmer.mechanism.controls.checks import OPTIONAL
from trimmer.mechanism.controls.controllers import Controller
from trimmer.mechanism.kinds import number_of_weight, numbers_of_part, numbers_of_start
from trimmer.mechanism.mechanism import Mechanism, changed
from trimmer.mechanism.outputs import weight_place
from trimmer.mechanism.parts import Friction
from trimmer.mechanism.place_text import Place, advice, parse_place, place_text, split_assignment
from trimmer.mechanism.quantities import FREQUENCY, PARTS, NumberField
from trimmer.mechanism.read_only import ReadOnly
from trimmer.mechanism.units import UnitError, quantity
from trimmer.messages import shown_value


class Numbered(Protocol):
    """What has numbers at places: a mechanism or a loop."""

    def with_value(self, place: str, value: float | str) -> Self: ...  # noqa: D102


_Numbered = TypeVar("_Numbered", bound=Numbered)
STATE = ("displacement", "velocity")  # What a start gives of a body, in the order of the file


def quantities(mechanism: Mechanism) -> dict[Place, NumberField]:
    """Return all numbers that may be set, with what they measure."""
    found: dict[Place, NumberField] = {("frequency",): FREQUENCY}
    found |= {("drives", name): FREQUENCY for name in mechanism.drives}
    for section in PARTS:
        for name in getattr(mechanism, section):
            found |= {(section, name, *end): each for end, each in _of_part(mechanism, section, name).items()}
    for name, point in mechanism.points.items():
        found |= {("points", name, of): _weight(mechanism, "points", name, of) for of in point.weights}
    for name, output in mechanism.outputs.items():
        for of in output.weights:
            found[weight_place(name, output.kind, of)] = _weight(mechanism, "outputs", name, of)
    found |= control_reading.quantities(vars(mechanism), mechanism.kinds)
    for name in mechanism.coordinates:
        state = zip(STATE, numbers_of_start(mechanism.kinds, name), strict=True)
        found |= {("start", name, key): each for key, each in state}
    return found


def _of_part(mechanism: Mechanism, section: str, name: str) -> dict[Place, NumberField]:
    """Return the numbers of a part by the ends of their places."""
    part = getattr(mechanism, section)[name]
    numbers = numbers_of_part(mechanism.kinds, section, name, part)
    found: dict[Place, NumberField] = {(key,): each for key, each in numbers.items()}
    if isinstance(part, Friction) and part.curve:
        del found["force",]
    return {**found, **number_rows.quantities(part, mechanism.kind_of(section, name))}


def _weight(mechanism: Mechanism, section: str, name: str, of: str) -> NumberField:
    return number_of_weight(mechanism.kinds, mechanism.kind_of(section, name), of)


def value_at(mechanism: Mechanism, place: str) -> float:
    """Return the number at a place, SI units."""
    names, _ = _found(mechanism, place)
    if names == ("frequency",) and mechanism.frequency is None:
        raise MechanismError("frequency: the mechanism has none; it moves by itself", place=names)
    if names[0] == "start" and names[1] not in mechanism.start:
        return 0.0
    *before, last = _steps(mechanism, names)
    part = _at(mechanism, before)
    match part, last:
        case Friction(), "static":
            return part.static_force
        case Controller(), "tracking":
            return float(part.tracking_time or 0.0)
    return _at(part, [last]) or 0.0  # a ratio that is not given damps nothing


def with_value_at(mechanism: Mechanism, place: str, value: float | str) -> Mechanism:
    """Return the mechanism with another number, SI or with a unit, at a place: ``plays.bridge.gap``."""
    names, wanted = _found(mechanism, place)
    number = _number(names, value, wanted)
    field, *inner = _steps(mechanism, names)
    content, name = getattr(mechanism, names[0]), "".join(names[1:2])
    if field == "start":
        content = {**content, name: content.get(name, (0.0, 0.0))}
    return changed(mechanism, names, _with(content, inner, number), value)


def with_values(subject: _Numbered, values: Iterable[tuple[str, float | str]]) -> _Numbered:
    """Return a mechanism or a loop with other numbers at some places, in whatever order they can be set.

    A static force may have to rise before the kinetic one does.

    Raises:
        MechanismError, LoopError: if the numbers cannot stand there together.
    """
    left = list(values)
    while left:
        first = None
        for at, (place, value) in enumerate(left):
            try:
                subject = subject.with_value(place, value)
            except TrimmerError as error:
                first = first or error
            else:
                del left[at]
                break
        else:
            assert first is not None
            raise first
    return subject


def _steps(mechanism: Mechanism, names: Place) -> tuple[Any, ...]:
    """Return the fields, keys and numbers in tuples that lead from a mechanism to the number at a place."""
    match names:
        case ("outputs" | "points", name, *_, body):
            return names[0], name, "weights", body
        case ("start", name, key):
            return "start", name, STATE.index(key)
        case (section, name, key, row, *column):
            columns = number_rows.columns_of(getattr(mechanism, section)[name], key)
            return section, name, key, int(row) - 1, *(columns.index(each) for each in column)
    return names


def _at(part: Any, steps: Sequence[Any]) -> Any:
    for each in steps:
        part = part[each] if isinstance(part, Mapping | tuple) else getattr(part, each)
    return part


def _with(part: Any, steps: Sequence[Any], number: float) -> Any:
    """Return a part with another number where some steps lead."""
    if not steps:
        return number
    first, *rest = steps
    inner = _with(_at(part, [first]), rest, number)
    if isinstance(part, tuple):
        return tuple(inner if place == first else each for place, each in enumerate(part))
    if isinstance(part, Mapping):
        return ReadOnly({**part, first: inner})
    return replace(part, **{first: inner})


def assignment(text: str) -> tuple[str, float | str]:
    """Read ``PLACE=VALUE``, such as ``plays.bridge.gap=40um``; the value is a number, or text with a unit.

    Text is never evaluated; whether the place is there and the unit fits is for the mechanism to say.
    """
    place, value = split_assignment(text)
    names = parse_place(place)
    if not value:
        raise MechanismError(
            f"{text!r} sets nothing: write a number, or one with its unit, after the equals sign"
        )
    try:
        return place_text(names), quantity(value, "1")
    except UnitError:
        return place_text(names), value


def _number(names: Place, value: float | str, wanted: NumberField) -> float:
    if isinstance(value, str):
        try:
            value = wanted.read(value)
        except UnitError as error:
            reason = f'{error}; "{wanted.example}" would do'
            raise _unusable(names, value, reason) from None
    if reason := wanted.reason_against(value):
        raise _unusable(names, value, reason)
    return wanted.taken(value)


def _unusable(names: Place, value: float | str, reason: str) -> MechanismError:
    return MechanismError(f"{place_text(names)} = {shown_value(value)}: {reason}", place=names)


def _found(mechanism: Mechanism, place: str) -> tuple[Place, NumberField]:
    require_instance("place", place, str, "a dotted place such as plays.bridge.gap")
    names = _parsed(place)
    if (quantity := _quantity(mechanism, names)) is not None:
        return names, quantity
    if _is_left_out(mechanism, names):
        raise MechanismError(
            f"{place_text(names)} is not given; write it into the file before it is changed", place=names
        )
    known = quantities(mechanism)
    raise MechanismError(f"there is no number at {place_text(names)}; {advice(names, known)}", place=names)


def _is_left_out(mechanism: Mechanism, names: Place) -> bool:
    """Say whether a controller could have a number there, such as a sample, that is not given."""
    if len(names) != 3 or names[0] != "controllers" or names[2] not in (*OPTIONAL, "delay"):
        return False
    return hasattr(mechanism.controllers.get(names[1]), names[2])


_parsed = lru_cache(maxsize=256)(parse_place)  # The same few places are asked for over and over


def _quantity(mechanism: Mechanism, names: Place) -> NumberField | None:
    """Return what the number at a place measures, as ``quantities`` says; None if there is none."""
    match names:
        case ("frequency",):
            return FREQUENCY
        case ("drives", name):
            return FREQUENCY if name in mechanism.drives else None
        case ("points", name, body):
            there = name in mechanism.points and body in mechanism.points[name].weights
            return _weight(mechanism, "points", name, body) if there else None
        case ("outputs", name, *_, body):
            output = mechanism.outputs.get(name)
            if output is None or body not in output.weights:
                return None
            there = names == weight_place(name, output.kind, body)
            return _weight(mechanism, "outputs", name, body) if there else None
        case ("start", name, key) if key in STATE and name in mechanism.coordinates:
            return numbers_of_start(mechanism.kinds, name)[STATE.index(key)]
        case ("controllers" | "references", *_):
            return control_reading.quantities(vars(mechanism), mechanism.kinds).get(names)
        case (section, name, *end) if section in PARTS and name in getattr(mechanism, section):
            return _of_part(mechanism, section, name).get(tuple(end))
    return None
