"""A mechanism as the text of a TOML file."""

from collections.abc import Iterator
from dataclasses import MISSING, fields
from typing import Any

import numpy as np

from trimmer.mechanism.controls.checks import SECTIONS
from trimmer.mechanism.controls.reading import entries_of as entries_of_control
from trimmer.mechanism.kinds import Kind
from trimmer.mechanism.mechanism import Mechanism
from trimmer.mechanism.outputs import entries_of
from trimmer.mechanism.parts import ContactLaw
from trimmer.mechanism.place_text import key_text, quoted
from trimmer.mechanism.quantities import PARTS
from trimmer.mechanism.structures.reading import COLUMNS, KEYS
from trimmer.mechanism.structures.structure import Structure

_HEAD = (
    "# Mechanism that moves along one line, in SI units: bodies, and what holds, pushes and rubs them.\n\n"
)


def mechanism_as_toml(mechanism: Mechanism) -> str:
    """Write a mechanism as TOML text, which reads back equal; what has its default is left out."""
    return _HEAD + "".join(_paragraphs(mechanism))


def _paragraphs(mechanism: Mechanism) -> Iterator[str]:
    if mechanism.title:
        yield f"title = {_value(mechanism.title)}\n"
    if mechanism.frequency is not None:
        yield f"frequency = {_value(mechanism.frequency)}\n"
    if mechanism.drives:
        yield _section("drives", {name: _value(each) for name, each in mechanism.drives.items()})
    for section, parts in _written(mechanism).items():
        if parts:
            yield _section(section, {name: _value(entries) for name, entries in parts.items()})


def _written(mechanism: Mechanism) -> dict[str, dict[str, object]]:
    """Return what stands in each section, by name."""
    found: dict[str, dict[str, object]] = {
        section: {name: _entries(part) for name, part in getattr(mechanism, section).items()}
        for section in PARTS
    }
    found["points"] = {name: _weights(mechanism, name) for name in mechanism.points}
    found["outputs"] = {name: entries_of(output) for name, output in mechanism.outputs.items()}
    for section in SECTIONS:
        controls = getattr(mechanism, section).items()
        found[section] = {name: entries_of_control(part) for name, part in controls}
    return found | {"start": dict(mechanism.start)}


def _section(name: str, entries: dict[str, str]) -> str:
    return f"\n[{name}]\n" + "".join(f"{key_text(key)} = {text}\n" for key, text in entries.items())


def _entries(part: Any) -> dict[str, object]:
    """Return the fields of a part that a file has to hold: needed ones, and what is not as by default."""
    if isinstance(part, Structure):
        return _entries_of_structure(part)
    held = {each.name: getattr(part, each.name) for each in fields(part)}
    defaults = {each.name: each.default for each in fields(part)}
    return {
        name: value for name, value in held.items() if defaults[name] is MISSING or value != defaults[name]
    }


def _weights(mechanism: Mechanism, name: str) -> dict[str, object]:
    """Return the weights of a point; lengths with their unit where nothing else tells that they are."""
    point = mechanism.points[name]
    if point.by_length and all(mechanism.kinds[of] is Kind.ROTATION for of in point.weights):
        return {of: f"{weight!r} m" for of, weight in point.weights.items()}
    return dict(point.weights)


def _entries_of_structure(structure: Structure) -> dict[str, object]:
    """Return the fields of a structure, matrices and modes written out, so that no other file is needed."""
    held: dict[str, object] = {name: getattr(structure, name) for name in KEYS}
    if structure.modes is not None:
        numbers = {name: getattr(structure.modes, name) for name in COLUMNS}
        held["modes"] = {**numbers, **structure.modes.shapes}
    absent = [
        name for name, value in held.items() if value is None or (isinstance(value, tuple) and not value)
    ]
    return {name: value for name, value in held.items() if name not in absent}


def _inline(entries: dict[str, object]) -> str:
    return "{ " + ", ".join(f"{key_text(key)} = {_value(value)}" for key, value in entries.items()) + " }"


def _value(value: object) -> str:
    match value:
        case ContactLaw():
            return quoted(value.word)
        case str():
            return quoted(value)
        case np.ndarray():
            return repr(value.tolist())
        case dict():
            return _inline(value)
        case tuple():
            return f"[{', '.join(map(_value, value))}]"
        case _:
            return repr(value)
