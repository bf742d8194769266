"""Mechanisms from TOML: sections, keys and units; what is wrong is named with its line."""

from collections.abc import Callable, Iterator, Mapping
from dataclasses import MISSING, fields, replace
from functools import partial
from pathlib import Path
from types import MappingProxyType
from typing import Any

from trimmer.errors import MechanismError
from trimmer.mechanism import number_rows
from trimmer.mechanism.controls import reading as control_reading
from trimmer.mechanism.controls.checks import SECTIONS as CONTROLS
from trimmer.mechanism.controls.checks import problems_of_links
from trimmer.mechanism.kinds import (
    Kind,
    is_length,
    kind_of_part,
    kind_of_point,
    kinds_of,
    number_of_weight,
    numbers_of_part,
    numbers_of_start,
    problems_of_kinds,
)
from trimmer.mechanism.mechanism import Mechanism, problems_with
from trimmer.mechanism.open_values import open_values, replaced
from trimmer.mechanism.outputs import output_of, problems_of_form
from trimmer.mechanism.parts import Body, Point
from trimmer.mechanism.place_text import place_text
from trimmer.mechanism.points import problems_of_weights
from trimmer.mechanism.problems import Problem, as_message_of_file
from trimmer.mechanism.quantities import FREQUENCY, PARTS, QUANTITIES, NumberField, if_plain
from trimmer.mechanism.sense import NO_MASS
from trimmer.mechanism.structures.ends import problems_of_dots
from trimmer.mechanism.structures.reading import problems_of_keys, structure_of
from trimmer.mechanism.structures.structure import Structure
from trimmer.mechanism.toml_lines import lines_of_keys
from trimmer.mechanism.units import UnitError
from trimmer.mechanism.waves import samples_of
from trimmer.messages import listed, near_match
from trimmer.toml_files import decoded, is_parameter_file, parsed, read_bytes_of_text

SECTIONS = ("drives", *PARTS, "points", "outputs", *CONTROLS, "start")
FOR_OTHERS = ("author", "held", "targets", "uncertainty")
"""Keys that are no part of the mechanism: ``trimmer design`` and ``trimmer sample`` read them."""
KEYS = ("title", "frequency", *SECTIONS, *FOR_OTHERS)
NO_VALUES: Mapping[str, float | str] = MappingProxyType({})


def read_mechanism(path: Path, values: Mapping[str, float | str] = NO_VALUES) -> Mechanism:
    """Read a mechanism from a file, or from standard input if the path is ``-``.

    Values, in SI units or with a unit, are for what the file leaves open, by dotted places; others are
    passed over.
    """
    return mechanism_of_text(text_of_file(path), str(path), values, path.parent)


def text_of_file(path: Path) -> str:
    """Read the text of a mechanism file."""
    return decoded(bytes_of_file(path))


def bytes_of_file(path: Path) -> bytes:
    """Read a mechanism file as it is."""
    return read_bytes_of_text(path, MechanismError, "'trimmer init FILE' writes one to start from")


def mechanism_of_text(
    text: str, name: str, values: Mapping[str, float | str] = NO_VALUES, folder: Path = Path()
) -> Mechanism:
    """Read a mechanism from the text of a file that messages call by a name, and tables from its folder."""
    content = content_of_text(text, name)
    left_open = {place_text(each.place): each for each in open_values(content)}
    lacking = [each.problem() for place, each in left_open.items() if place not in values]
    if lacking:
        raise MechanismError(as_message_of_file(name, lacking, content, lines_of_keys(text)))
    given = {each.place: values[place] for place, each in left_open.items()}
    content = replaced(content, given)
    problems = list(_problems_of_form(content))
    written = content
    if not problems:
        content = {**content, "structures": _structures(content, folder, problems)}
    if not problems:
        kinds = kinds_of(content)
        problems = [*problems_of_kinds(content, kinds), *problems_of_weights(content, kinds)]
    if not problems:
        problems = list(problems_of_links(content))
    if not problems:
        arguments = _arguments(content, folder, problems)
        problems = problems or problems_with(arguments)
        if not problems:
            return Mechanism(**arguments)
    raise MechanismError(as_message_of_file(name, problems, written, lines_of_keys(text)))


def content_of_text(text: str, name: str) -> dict[str, Any]:
    """Return the text of a mechanism file as nested dictionaries, before any of it is checked."""
    advice = "a part is written as in 'motor = { mass = 0.035 }' below [bodies]"
    content = parsed(text, name, MechanismError, advice)
    if is_parameter_file(content):
        raise MechanismError(
            f"{name}: this is a parameter file, for 'trimmer linear --parameters FILE' and other commands "
            "for the thesis's loop; a mechanism has [bodies], as 'trimmer init' writes one"
        )
    return content


def _problems_of_form(content: Mapping[str, Any]) -> Iterator[Problem]:
    """Find unknown and missing keys, and what should be a table and is none."""
    for key, value in content.items():
        if key not in KEYS:
            yield Problem((key,), _unknown(key, KEYS, "the top of the file"), if_plain(value))
        elif key in SECTIONS and not isinstance(value, dict):
            yield Problem((key,), f"is a section: write [{key}] on a line of its own", value)
        elif key in _FORMS:
            for name, entries in value.items():
                yield from _FORMS[key]((key, name), entries)
    yield from problems_of_dots(content)
    if "bodies" not in content and "structures" not in content:
        yield Problem(("bodies",), "there is none; write one, as in motor = { mass = 0.035 } below [bodies]")


def _problems_of_part(place: tuple[str, str], entries: object) -> Iterator[Problem]:
    kind = PARTS[place[0]]
    if not isinstance(entries, dict):
        yield Problem(place, f"give its keys in braces, as in {{ {_example(kind)} }}", entries)
        return
    known = [each.name for each in fields(kind) if each.name != "files"]
    unknown = [key for key in entries if key not in known]
    for key in unknown:
        reason = _unknown(key, known, f"a part of [{place[0]}]")
        yield Problem((*place, key), reason, if_plain(entries[key]))
    if unknown:  # what is missing is there perhaps, but misspelt
        return
    if kind is Structure:
        yield from problems_of_keys(place, entries)
    if kind is Body and not {"mass", "inertia"} & entries.keys():
        yield Problem((*place, "mass"), NO_MASS)
    for each in fields(kind):
        if each.default is MISSING is each.default_factory and each.name not in entries:
            yield Problem((*place, each.name), f"missing; add {_example(kind, each.name)}")


_FORMS: Mapping[str, Callable[[tuple[str, str], object], Iterator[Problem]]] = MappingProxyType(
    {
        **dict.fromkeys(PARTS, _problems_of_part),
        **dict.fromkeys(("points", "outputs"), problems_of_form),
        **dict.fromkeys(CONTROLS, control_reading.problems_of_form),
    }
)


def _structures(content: Mapping[str, Any], folder: Path, problems: list[Problem]) -> dict[str, Structure]:
    """Return the structures; what cannot be read is added to the problems."""
    convert, ratio = _Converter(problems), QUANTITIES[Structure]["damping_ratio"]
    found = {}
    for name, entries in content.get("structures", {}).items():
        place = ("structures", name)
        structure = structure_of(place, entries, folder, problems)
        number = convert.number((*place, "damping_ratio"), structure.damping_ratio, ratio)
        found[name] = replace(structure, damping_ratio=number)
    return found


def _arguments(content: Mapping[str, Any], folder: Path, problems: list[Problem]) -> dict[str, Any]:
    """Return the fields of the mechanism; what cannot be read is added to the problems."""
    convert, kinds = _Converter(problems), kinds_of(content)
    arguments: dict[str, Any] = {each.name: {} for each in fields(Mechanism)}
    arguments["title"] = content.get("title", "")
    arguments["frequency"] = convert.number(("frequency",), content.get("frequency"), FREQUENCY)
    for name, value in content.get("drives", {}).items():
        arguments["drives"][name] = convert.number(("drives", name), value, FREQUENCY)
    for section, kind in PARTS.items():
        rows = number_rows.forms_of(kind)
        for name, entries in content.get(section, {}).items():
            if isinstance(entries, Structure):
                arguments[section][name] = entries
                continue
            numbers = {**QUANTITIES[kind], **numbers_of_part(kinds, section, name, entries)}
            turns = kind_of_part(kinds, section, name, entries)
            arguments[section][name] = kind(
                **{
                    key: convert.number((section, name, key), value, numbers[key])
                    if key in numbers
                    else number_rows.read((section, name, key), value, rows[key].of(turns), convert.number)
                    if key in rows
                    else samples_of((section, name, key), value, folder, problems)
                    if key == "waveform"
                    else value
                    for key, value in entries.items()
                }
            )
    for name, weights in content.get("points", {}).items():
        by_length = any(map(is_length, weights.values()))
        arguments["points"][name] = Point(convert.weights(kinds, ("points", name), weights), by_length)
    for name, entries in content.get("outputs", {}).items():
        arguments["outputs"][name] = output_of(("outputs", name), entries, partial(convert.weights, kinds))
    for section in CONTROLS:
        arguments[section] = control_reading.controls_of(content, kinds, section, convert.number)
    for name, state in content.get("start", {}).items():
        arguments["start"][name] = convert.state(("start", name), state, numbers_of_start(kinds, name))
    return arguments


class _Converter:
    """Numbers of text with units; what cannot be read is noted among the problems."""

    def __init__(self, problems: list[Problem]) -> None:
        self._problems = problems

    def number(self, place: tuple[str, ...], value: object, wanted: NumberField) -> Any:
        """Return the number of a text in the SI unit; what is no text is returned as it is."""
        if not isinstance(value, str):
            return value
        try:
            return wanted.read(value)
        except UnitError as error:
            self._problems.append(Problem(place, f'{error}; "{wanted.example}" would do', value))
            return None

    def weights(
        self, kinds: Mapping[str, Kind], place: tuple[str, ...], weights: Mapping[str, object]
    ) -> dict[str, Any]:
        """Return the weights of a sum, each of which may be text."""
        kind = kind_of_point(kinds, weights)
        return {
            of: self.number((*place, of), weight, number_of_weight(kinds, kind, of))
            for of, weight in weights.items()
        }

    def state(self, place: tuple[str, ...], value: object, wanted: tuple[NumberField, NumberField]) -> object:
        """Return displacement and velocity, each of which may be text."""
        if not isinstance(value, list) or len(value) != 2:
            return value
        return [self.number(place, each, of) for each, of in zip(value, wanted, strict=True)]


def _unknown(key: str, known: tuple[str, ...] | list[str], where: str) -> str:
    return f"unknown key; {near_match(key, known) or f'{where} may hold {listed(known)}'}"


def _example(kind: type, key: str | None = None) -> str:
    examples = {"on": 'on = "motor"', "between": 'between = ["ground", "motor"]', "mass": "mass = 0.035"}
    if kind is Structure:
        return 'mass = "M.mtx", stiffness = "K.mtx", coordinates = ["u1", "u2"]'
    required = ["mass"] if kind is Body else [each.name for each in fields(kind) if each.default is MISSING]
    return ", ".join(examples.get(name, f"{name} = 0.5") for name in ([key] if key else required))
