"""The numbers of a loop by their dotted places, such as ``element.gap`` and ``frictions.q2-q4.force``.

The terms of a sum are numbered from 0, as in ``element.1.level``. ``start.q1`` is a state with which a motion
begins.
"""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import fields, is_dataclass, replace
from typing import Any, cast

from trimmer.arguments import finite_number, require_instance
from trimmer.elements.scaled_element import ScaledElement
from trimmer.elements.sum_of_elements import SumOfElements
from trimmer.errors import LoopError
from trimmer.loops.drive import Drive
from trimmer.loops.feedback import Feedback
from trimmer.loops.loops import COMPUTED, Loop
from trimmer.mechanism.place_text import Place, advice, parse_place, place_text
from trimmer.mechanism.units import UnitError, quantity
from trimmer.messages import shown_value
from trimmer.parameters import TrimmerParameters

FREQUENCY: Place = ("frequency",)
OF_LENGTH = ("amplitude", "gap", "threshold", "hysteresis", "dead_zone", "level")
"""Fields in the unit of the element's input or output."""
UNITS = {"time_constant": "s", "phase": "rad"}
"""Units of fields that are the same in every loop."""
OF_FORCE = {"force": "N", "level": "N", "damping": "N s/m"}
"""Units of what works against the motion of bodies in newtons."""


def numbers_of(loop: Loop) -> dict[Place, str]:
    """Return the unit of every number of a loop, by its place; empty for one without a unit."""
    found: dict[Place, str] = {}
    drive: Drive | None = getattr(loop, "drive", None)
    if drive is not None:
        found |= {FREQUENCY: "Hz", ("drive", "amplitude"): loop.length, ("drive", "phase"): "rad"}
    for names in _of_element(getattr(loop, "element", None)):
        found[("element", *names)] = UNITS.get(names[-1], loop.length if names[-1] in OF_LENGTH else "")
    if isinstance(loop, Feedback):
        found |= _of_feedback(loop)
    parameters = getattr(loop, "parameters", None)
    if isinstance(parameters, TrimmerParameters):
        found |= {("parameters", each.name): each.metadata["quantity"].unit for each in fields(parameters)}
    for label, friction in _frictions(loop).items():
        for names in _of_element(friction.law):
            found[("frictions", label, *names)] = OF_FORCE.get(names[-1], UNITS.get(names[-1], ""))
    states = zip(loop.model.state_labels, loop.state_units, strict=True)
    return found | {("start", name): unit for name, unit in states}


def _of_feedback(loop: Feedback) -> dict[Place, str]:
    """Return the unit of every number of elements and drives; ``frequency`` is that of all drives."""
    found: dict[Place, str] = {FREQUENCY: "Hz"} if loop.frequency is not None else {}
    for name in loop.drives:
        found |= {("drives", name, "frequency"): "Hz", ("drives", name, "phase"): "rad"}
        found[("drives", name, "amplitude")] = ""
    for name, element in loop.elements.items():
        found |= {("elements", name, *names): UNITS.get(names[-1], "") for names in _of_element(element)}
    return found


def _frictions(loop: Loop) -> dict[str, Any]:
    """Return the frictions of a trimmer by what they act between; of several between the same, numbered."""
    found: dict[str, Any] = {}
    for friction in getattr(loop, "frictions", ()):
        label, count = friction.between.label, 2
        while label in found:
            label, count = f"{friction.between.label} {count}", count + 1
        found[label] = friction
    return found


def _of_element(element: object) -> Iterator[Place]:
    """Yield the places of the numbers of an element within it."""
    if isinstance(element, SumOfElements):
        for number, term in enumerate(element.terms):
            yield from ((str(number), *names) for names in _of_element(term))
    elif isinstance(element, ScaledElement):
        yield ("factor",)
        yield from _of_element(element.element)
    elif is_dataclass(element):
        yield from ((each.name,) for each in fields(element) if _is_number(getattr(element, each.name)))


def _is_number(value: object) -> bool:
    return isinstance(value, int | float) and not isinstance(value, bool)


def value_at(loop: Loop, place: str) -> float:
    """Return the number at a place, in its unit.

    Raises:
        LoopError: if there is none.
    """
    names, _ = _found(loop, place)
    if names == FREQUENCY:
        assert loop.frequency is not None
        return loop.frequency
    match names:
        case ("element", *inner):
            return _value(getattr(loop, "element", None), tuple(inner))
        case ("elements", name, *inner):
            return _value(getattr(loop, "elements", {})[name], tuple(inner))
        case ("drives", name, field):
            return float(getattr(getattr(loop, "drives", {})[name], field))
        case ("frictions", label, *inner):
            return _value(_frictions(loop)[label].law, tuple(inner))
        case ("start", name):
            return loop.start.get(name, 0.0)
    section, name = names
    return float(getattr(getattr(loop, section), name))


def _value(element: Any, names: Place) -> float:
    if isinstance(element, SumOfElements):
        return _value(element.terms[int(names[0])], names[1:])
    if isinstance(element, ScaledElement) and names != ("factor",):
        return _value(element.element, names)
    return float(getattr(element, names[0]))


def with_value_at(loop: Loop, place: str, value: float | str) -> Loop:
    """Return the loop with another number at a place.

    Args:
        loop: The loop, which stays as it is.
        place: Such as ``element.gap``.
        value: The number in its unit, or text with a unit, such as ``40 um``.

    Raises:
        LoopError: if there is no such place, or the number cannot stand there.
    """
    names, unit = _found(loop, place)
    try:
        number = quantity(value, unit or "1") if isinstance(value, str) else finite_number(place, value)
        changed: Loop = _changed(loop, names, number)
    except (UnitError, ValueError) as error:
        raise LoopError(f"{place_text(names)} = {shown_value(value)}: {error}") from None
    return changed


def _changed(loop: Any, names: Place, number: float) -> Any:
    changes: dict[str, Any] = {}
    match names:
        case ("frequency",) if isinstance(loop, Feedback):
            share = number / cast("float", loop.frequency)
            changes["drives"] = {
                name: _at_frequency(each, share * each.frequency) for name, each in loop.drives.items()
            }
        case ("frequency",):
            changes["drive"] = _at_frequency(loop.drive, number)
        case ("elements", name, *inner):
            element = _element_with(loop.elements[name], tuple(inner), number)
            changes["elements"] = {**loop.elements, name: element}
        case ("drives", name, field):
            drive = loop.drives[name]
            other = (
                _at_frequency(drive, number) if field == "frequency" else replace(drive, **{field: number})
            )
            changes["drives"] = {**loop.drives, name: other}
        case ("element", *inner):
            changes["element"] = _element_with(loop.element, tuple(inner), number)
        case ("frictions", label, *inner):
            frictions = _frictions(loop)
            law = _element_with(frictions[label].law, tuple(inner), number)
            frictions[label] = replace(frictions[label], law=law)
            changes["frictions"] = tuple(frictions.values())
        case ("start", name):
            changes["start"] = {**loop.start, name: number}
        case (section, name):
            changes[section] = replace(getattr(loop, section), **{name: number})
    changed: Loop = replace(loop, **changes)
    # Another start moves by the same equations; another element or drive leaves the linear system the same.
    same = () if names[0] == "parameters" else COMPUTED if names[0] == "start" else ("model",)
    vars(changed).update({each: getattr(loop, each) for each in same})
    return changed


def _at_frequency(drive: Drive, frequency: float) -> Drive:
    return Drive(drive.amplitude, phase=drive.phase, frequency=frequency)


def _element_with(element: Any, names: Place, number: float) -> Any:
    if isinstance(element, SumOfElements):
        terms = list(element.terms)
        terms[int(names[0])] = _element_with(terms[int(names[0])], names[1:], number)
        return replace(element, terms=tuple(terms))
    if isinstance(element, ScaledElement) and names != ("factor",):
        return replace(element, element=_element_with(element.element, names, number))
    return replace(element, **{names[0]: number})


def _found(loop: Loop, place: str) -> tuple[Place, str]:
    require_instance("place", place, str, "a dotted place such as element.gap")
    names, known = parse_place(place), numbers_of(loop)
    if names not in known:
        raise LoopError(f"there is no number at {place_text(names)}; {advice(names, known)}")
    return names, known[names]
