"""Controllers and references in a file: their tables read and written, and the places of their numbers."""

from collections.abc import Callable, Iterator, Mapping
from dataclasses import MISSING, fields, replace
from typing import Any

from trimmer.mechanism.controls.checks import SECTIONS
from trimmer.mechanism.controls.controllers import CONTROLLERS, Controller
from trimmer.mechanism.controls.numbers import ROWS, kind_of, numbers_of
from trimmer.mechanism.controls.references import REFERENCES
from trimmer.mechanism.kinds import Kind
from trimmer.mechanism.place_text import Place
from trimmer.mechanism.problems import Problem
from trimmer.mechanism.quantities import NumberField, if_plain
from trimmer.mechanism.read_only import ReadOnly
from trimmer.messages import listed, near_match

_EXAMPLES = {
    "measure": 'measure = "angle"',
    "acts": 'acts = ["ground", "motor"]',
    "numerator": "numerator = [2.0, 1.0]",
    "denominator": "denominator = [0.01, 1.0]",
    "frequency": "frequency = 5.0",
}
Read = Callable[[Place, object, NumberField], Any]
"""Returns the number of a text, or what is none as it is, by place, value and what is wanted."""


def problems_of_form(place: tuple[str, str], entries: object) -> Iterator[Problem]:
    """Find what is no table of a controller or a reference, with its unknown and missing keys."""
    section = place[0]
    if not isinstance(entries, dict):
        example = "kind, measure, acts and gains" if section == "controllers" else "{ step = 0.5, at = 0.1 }"
        yield Problem(place, f"give a table of {example}", entries)
        return
    kind = kind_of(section, entries)
    if kind is None:
        yield _of_no_kind(place, entries)
        return
    known = [each.name for each in fields(kind)]
    known = ["kind", *known] if section == "controllers" else known
    unknown = [key for key in entries if key not in known]
    for key in unknown:
        value, word = entries[key], kind.word  # type: ignore[attr-defined]
        advice = near_match(key, known) or f"{word!r} may hold {listed(known)}"
        yield Problem((*place, key), f"unknown key; {advice}", if_plain(value))
    for each in fields(kind):
        if each.default is MISSING and each.name not in entries and not unknown:
            yield Problem((*place, each.name), f"missing; add {_EXAMPLES[each.name]}")


def _of_no_kind(place: tuple[str, str], entries: Mapping[str, Any]) -> Problem:
    if place[0] == "references":
        near = next((advice for key in entries if (advice := near_match(key, list(REFERENCES)))), "")
        return Problem(
            place, f"gives no {listed(REFERENCES, 'or')}; {near or 'write { step = 0.5, at = 0.1 }'}"
        )
    word, words = entries.get("kind"), list(CONTROLLERS)
    if word is None:
        return Problem((*place, "kind"), f"missing; write one of {listed(map(repr, words), 'or')}")
    near = near_match(word, words) if isinstance(word, str) else ""
    return Problem((*place, "kind"), near or f"choose {listed(map(repr, words), 'or')}", word)


def controls_of(
    content: Mapping[str, Any], kinds: Mapping[str, Kind], section: str, read: Read
) -> dict[str, Any]:
    """Return the controllers or the references of a file whose form is good, by name."""
    found = {}
    for name, entries in content.get(section, {}).items():
        kind, numbers = kind_of(section, entries), numbers_of(content, kinds, section, name)
        assert kind is not None
        found[name] = kind(
            **{
                key: _read((section, name, key), value, numbers, read)
                for key, value in entries.items()
                if (section, key) != ("controllers", "kind")
            }
        )
    return found


def _read(place: Place, value: object, numbers: Mapping[str, NumberField], read: Read) -> object:
    key = place[-1]
    if key in numbers:
        return read(place, value, numbers[key])
    if key not in ROWS or not isinstance(value, list):
        return value
    if key != "profile":
        rows = enumerate(value, start=1)
        return [read((*place, str(count)), each, numbers["coefficient"]) for count, each in rows]
    if not all(isinstance(row, list) and len(row) == 2 for row in value):
        return value
    return [
        [
            read((*place, str(count), name), each, numbers[name])
            for name, each in zip(("time", "value"), row, strict=True)
        ]
        for count, row in enumerate(value, start=1)
    ]


def taken(content: Mapping[str, Any], kinds: Mapping[str, Kind]) -> dict[str, ReadOnly[Any]]:
    """Return both sections with floats for all numbers, and tuples of ends and rows."""
    return {
        section: ReadOnly(
            {
                name: _taken(part, numbers_of(content, kinds, section, name))
                for name, part in content[section].items()
            }
        )
        for section in SECTIONS
    }


def _taken(part: Any, numbers: Mapping[str, NumberField]) -> Any:
    found = {
        key: number.taken(getattr(part, key))
        for key, number in numbers.items()
        if getattr(part, key, None) is not None
    }
    rows: dict[str, object] = {
        key: tuple(tuple(map(float, row)) if key == "profile" else float(row) for row in getattr(part, key))
        for key in ROWS
        if hasattr(part, key)
    }
    return replace(part, **found, **rows, **({"acts": tuple(part.acts)} if hasattr(part, "acts") else {}))


def entries_of(part: Any) -> dict[str, object]:
    """Return a controller or a reference as what a file has to hold."""
    kind: dict[str, object] = {"kind": part.word} if isinstance(part, Controller) else {}
    held = {each.name: (getattr(part, each.name), each.default) for each in fields(part)}
    return kind | {name: value for name, (value, default) in held.items() if value != default}


def quantities(content: Mapping[str, Any], kinds: Mapping[str, Kind]) -> dict[Place, NumberField]:
    """Return the numbers that controllers and references have, by place, with what they measure."""
    found: dict[Place, NumberField] = {}
    for section in SECTIONS:
        for name, part in content[section].items():
            numbers = numbers_of(content, kinds, section, name)
            for key, number in numbers.items():
                undelayed = key == "delay" and part.sample is None and part.pade is None
                given = getattr(part, "tracking_time" if key == "tracking" else key, None)
                if key != "pade" and not undelayed and given is not None:
                    found[section, name, key] = number
            for key in ROWS:
                for count in range(1, len(getattr(part, key, ())) + 1):
                    of_rows = ("time", "value") if key == "profile" else ()
                    found |= {(section, name, key, str(count), each): numbers[each] for each in of_rows}
                    if not of_rows:
                        found[section, name, key, str(count)] = numbers["coefficient"]
    return found
