"""The numbers of a loop by their dotted places, such as ``element.gap`` and ``frictions.q2-q4.force``.

The terms of a sum are numbered from 0, as in ``element.1.level``. ``start.q1`` is a state with which a motion
begins.
"""

from collections.abc import Iterator, Mapping
from dataclasses import fields, is_dataclass, replace
from typing import Any, cast

from trimmer.arguments import finite_number, require_instance
from trimmer.elements import ScaledElement, SumOfElements
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
UNITS = {"time_constant": "s", "phase": "rad"}  # Units of fields that are the same in every loop
OF_DRIVE = {"frequency": "Hz", "phase": "rad", "amplitude": ""}  # Units of a drive among several
OF_FORCE = {"force": "N", "level": "N", "damping": "N s/m"}
"""Units of what works against the motion of bodies in newtons."""


def numbers_of(loop: Loop) -> dict[Place, str]:
    """Return the unit of every number of a loop, by its place; empty for one without a unit."""
    found: dict[Place, str] = {} if loop.frequency is None else {FREQUENCY: "Hz"}
    elements: dict[Place, object] = {("element",): getattr(loop, "element", None)}
    length = loop.length
    if isinstance(loop, Feedback):
        elements, length = {("elements", name): each for name, each in loop.elements.items()}, ""
        for name in loop.drives:
            found |= {("drives", name, each): unit for each, unit in OF_DRIVE.items()}
    elif loop.frequency is not None:
        found |= {("drive", "amplitude"): length, ("drive", "phase"): "rad"}
    for place, element in elements.items():
        for names in _of_element(element):
            unit = length if names[-1] in OF_LENGTH else ""
            found[(*place, *names)] = UNITS.get(names[-1], unit)
    parameters = getattr(loop, "parameters", None)
    if isinstance(parameters, TrimmerParameters):
        found |= {("parameters", each.name): each.metadata["quantity"].unit for each in fields(parameters)}
    for label, friction in _frictions(loop).items():
        for names in _of_element(friction.law):
            found[("frictions", label, *names)] = OF_FORCE.get(names[-1], UNITS.get(names[-1], ""))
    states = zip(loop.model.state_labels, loop.state_units, strict=True)
    return found | {("start", name): unit for name, unit in states}


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
    """Return the number at a place, in its unit; a ``LoopError`` if there is none."""
    names, _ = _found(loop, place)
    match names:
        case ("frictions", label, *inner):
            return _value(_frictions(loop)[label].law, tuple(inner))
        case ("start", name):
            return loop.start.get(name, 0.0)
    return _value(loop, names)


def _value(part: Any, names: Place) -> float:
    """Return the number at a place within a part of a loop, or within the loop."""
    if not names:
        return float(part)
    first, *rest = names
    if isinstance(part, SumOfElements):
        return _value(part.terms[int(first)], tuple(rest))
    if isinstance(part, ScaledElement) and names != ("factor",):
        return _value(part.element, names)
    return _value(part[first] if isinstance(part, Mapping) else getattr(part, first), tuple(rest))


def with_value_at(loop: Loop, place: str, value: float | str) -> Loop:
    """Return the loop with another number at a place, in its unit or with a unit, such as ``40 um``."""
    names, unit = _found(loop, place)
    try:
        number = quantity(value, unit or "1") if isinstance(value, str) else finite_number(place, value)
        changed: Loop = _changed(loop, names, number)
    except (UnitError, ValueError) as error:
        raise LoopError(f"{place_text(names)} = {shown_value(value)}: {error}", place=names) from None
    return changed


def _changed(loop: Any, names: Place, number: float) -> Any:
    match names:
        case ("frequency",):
            changed = _at_frequency(loop, number)
        case ("frictions", label, *inner):
            frictions = _frictions(loop)
            frictions[label] = _with(frictions[label], ("law", *inner), number)
            changed = replace(loop, frictions=tuple(frictions.values()))
        case _:
            changed = _with(loop, names, number)
    # Another start moves by the same equations; another element or drive leaves the linear system the same.
    same = () if names[0] == "parameters" else COMPUTED if names[0] == "start" else ("model",)
    vars(changed).update({each: getattr(loop, each) for each in same})
    return changed


def _at_frequency(loop: Any, frequency: float) -> Any:
    """Return a loop with its drive at another frequency, Hz, or with all at the same multiples of that."""
    if not isinstance(loop, Feedback):
        return replace(loop, drive=_with(loop.drive, FREQUENCY, frequency))
    share = frequency / cast("float", loop.frequency)
    return replace(
        loop,
        drives={name: _with(each, FREQUENCY, share * each.frequency) for name, each in loop.drives.items()},
    )


def _with(part: Any, names: Place, number: float) -> Any:
    """Return a part of a loop, or the loop, with another number at a place within it."""
    if not names:
        return number
    first, *rest = names
    inner = tuple(rest)
    if isinstance(part, Drive) and names == FREQUENCY:
        return Drive(part.amplitude, phase=part.phase, frequency=number)
    if isinstance(part, SumOfElements):
        place = int(first)
        changed = _with(part.terms[place], inner, number)
        return replace(part, terms=(*part.terms[:place], changed, *part.terms[place + 1 :]))
    if isinstance(part, ScaledElement) and names != ("factor",):
        return replace(part, element=_with(part.element, names, number))
    if isinstance(part, Mapping):
        return {**part, first: _with(part.get(first), inner, number)}
    return replace(part, **{first: _with(getattr(part, first), inner, number)})


def _found(loop: Loop, place: str) -> tuple[Place, str]:
    require_instance("place", place, str, "a dotted place such as element.gap")
    names, known = parse_place(place), numbers_of(loop)
    if names not in known:
        raise LoopError(f"there is no number at {place_text(names)}; {advice(names, known)}", place=names)
    return names, known[names]
