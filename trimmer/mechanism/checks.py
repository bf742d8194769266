"""Whether what a mechanism is made of has the right types and numbers.

``sense`` looks at how it goes together.
"""

import re
from collections.abc import Iterator, Mapping
from dataclasses import fields

from trimmer.choices import ChoiceError
from trimmer.mechanism import number_rows
from trimmer.mechanism.controls import checks as control_checks
from trimmer.mechanism.kinds import Kind, kind_of_part, kinds_of, numbers_of_part, numbers_of_start
from trimmer.mechanism.outputs import problems_of_kind
from trimmer.mechanism.parts import ContactLaw, Force, Output, Pin, Point
from trimmer.mechanism.problems import Problem, problems_of_name
from trimmer.mechanism.quantities import FREQUENCY, PARTS, QUANTITIES, WEIGHT
from trimmer.mechanism.structures.structure import Structure
from trimmer.mechanism.waves import problems_of_waveform

LONGEST_TITLE = 1000  # Characters of a title, and of who wrote a file
_SYMBOL_RULE = 'a symbol is a letter or a name, perhaps with an index, as in "k_2" or "k_bridge"'

_LETTER = "A-Za-zΑ-Ωα-ω"
_SYMBOL = re.compile(rf"[{_LETTER}]+[0-9]*(?:_[{_LETTER}0-9]+|_\{{[{_LETTER}0-9]+(?:,[{_LETTER}0-9]+)*\}})?")

Content = Mapping[str, object]  # Fields of a mechanism, by name

OPTIONAL_NUMBERS = {"static", "force", "mass", "inertia", "damping_ratio"}
"""Numbers that may be None, for what the docstring of the part says."""


def problems_of_types(content: Content) -> Iterator[Problem]:
    """Find fields that are not what they should be: sections, parts, numbers, words."""
    yield from _heading(content)
    kinds = kinds_of(content)
    for section, kind in PARTS.items():
        parts = content[section]
        if not isinstance(parts, Mapping):
            yield Problem(
                (section,), f"must map names to instances of trimmer.mechanism.{kind.__name__}", parts
            )
            continue
        for name, part in parts.items():
            yield from problems_of_name((section,), name)
            if type(part) is kind:
                yield from _fields((section, str(name)), part, kinds)
                if isinstance(part, Structure):
                    from trimmer.mechanism.structures.checks import problems_of_structure

                    yield from problems_of_structure((section, str(name)), part)
            else:
                yield Problem((section, str(name)), f"give a trimmer.mechanism.{kind.__name__}", part)
    yield from _sums("points", Point, content["points"])
    yield from _sums("outputs", Output, content["outputs"])
    yield from _start(content["start"], kinds)
    yield from control_checks.problems_of_types(content, kinds)


def _heading(content: Content) -> Iterator[Problem]:
    title, frequency = content["title"], content["frequency"]
    if not isinstance(title, str) or not title.isprintable():
        yield Problem(("title",), "must be text on one line", title)
    elif len(title) > LONGEST_TITLE:
        yield Problem(("title",), f"is too long; use at most {LONGEST_TITLE} characters", title)
    if frequency is not None:
        yield from FREQUENCY.problems(("frequency",), frequency)
    drives = content["drives"]
    if not isinstance(drives, Mapping):
        yield Problem(("drives",), "must map names to frequencies in Hz", drives)
        return
    for name, each in drives.items():
        yield from problems_of_name(("drives",), name)
        yield from FREQUENCY.problems(("drives", str(name)), each)


def _fields(place: tuple[str, str], part: object, kinds: Mapping[str, Kind]) -> Iterator[Problem]:
    rows = number_rows.forms_of(part)
    quantities, numbers = QUANTITIES[type(part)], numbers_of_part(kinds, *place, part)
    for each in fields(part):  # type: ignore[arg-type]
        value, there = getattr(part, each.name), (*place, each.name)
        if each.name == "force" and value is None and getattr(part, "curve", ()) is None:
            yield Problem(there, "missing; add force = 0.5")
        elif each.name in quantities:
            if value is not None or each.name not in OPTIONAL_NUMBERS:
                yield from numbers.get(each.name, quantities[each.name]).problems(there, value)
        elif each.name not in rows:
            yield from _word(there, value)
        elif value is not None:
            yield from number_rows.problems_of_types(
                there, value, rows[each.name].of(kind_of_part(kinds, *place, part))
            )
    if isinstance(part, Pin | Force):
        yield from problems_of_waveform(place, part)


def _word(place: tuple[str, ...], value: object) -> Iterator[Problem]:
    match place[-1]:
        case "symbol":
            if value is not None and not _is_symbol(value):
                yield Problem(place, _SYMBOL_RULE, value)
        case "law":
            yield from _law(place, value)
        case "drive":
            if value is not None and not isinstance(value, str):
                yield Problem(place, 'name one of [drives], as in drive = "hum"', value)
        case "on":
            if not isinstance(value, str):
                yield Problem(place, "name a body", value)
        case "between":
            if not _is_pair(value) or not all(isinstance(end, str) for end in value):  # type: ignore[attr-defined]
                yield Problem(place, 'name two ends, as in ["ground", "motor"]', value)


def _is_symbol(value: object) -> bool:
    """Say whether a value can be a symbol in printed equations."""
    return isinstance(value, str) and _SYMBOL.fullmatch(value) is not None


def _law(place: tuple[str, ...], value: object) -> Iterator[Problem]:
    try:
        ContactLaw.chosen(value, "law")  # type: ignore[arg-type]
    except ChoiceError as error:
        yield Problem(place, str(error).split(": ", 1)[-1], value)


def _sums(section: str, kind: type[Output | Point], sums: object) -> Iterator[Problem]:
    """Find points or outputs that are no weights by name."""
    if not isinstance(sums, Mapping):
        yield Problem((section,), f"must map names to instances of trimmer.mechanism.{kind.__name__}", sums)
        return
    for name, each in sums.items():
        yield from problems_of_name((section,), name)
        place = (section, str(name))
        if not isinstance(each, kind) or type(each) is not kind or not isinstance(each.weights, Mapping):
            reason = f"give a trimmer.mechanism.{kind.__name__} with a mapping of weights"
            yield Problem(place, reason, each)
            continue
        if isinstance(each, Output):
            yield from problems_of_kind(place, each)
        by_length: object = getattr(each, "by_length", False)
        if not isinstance(by_length, bool):
            yield Problem((*place, "by_length"), "must be True or False", by_length)
        for body, weight in each.weights.items():
            yield from problems_of_name(place, body)
            yield from WEIGHT.problems((*place, str(body)), weight)


def _start(start: object, kinds: Mapping[str, Kind]) -> Iterator[Problem]:
    if not isinstance(start, Mapping):
        yield Problem(("start",), "must map bodies to [displacement in m, velocity in m/s]", start)
        return
    for body, state in start.items():
        yield from problems_of_name(("start",), body)
        place = ("start", str(body))
        numbers = numbers_of_start(kinds, body)
        if not _is_pair(state):
            units = [each.unit for each in numbers]
            reason = "give two numbers: [displacement in {}, velocity in {}]".format(*units)
            yield Problem(place, reason, state)
            continue
        for value, quantity in zip(state, numbers, strict=True):
            if reason := quantity.reason_against(value):
                yield Problem(place, f"{value!r} {reason}" if reason.startswith("must") else reason, state)


def _is_pair(value: object) -> bool:
    return isinstance(value, list | tuple) and len(value) == 2
