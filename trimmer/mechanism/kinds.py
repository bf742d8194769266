"""Translations and rotations: which of them everything in a mechanism is, and the units that follow.

The units of all numbers are written down for translations; a kind says what stands in their places. Kinds are
asked for of a file before its texts are numbers, so parts may be tables of TOML here, with anything in them.
"""

from collections.abc import Iterator, Mapping
from dataclasses import replace
from enum import Enum
from types import MappingProxyType
from typing import Any

from trimmer.mechanism.parts import COUPLINGS, GROUND, Body, Output, OutputKind
from trimmer.mechanism.problems import Problem
from trimmer.mechanism.quantities import DISPLACEMENT, PARTS, QUANTITIES, VELOCITY, WEIGHT, NumberField
from trimmer.mechanism.structures.ends import rotations_in
from trimmer.mechanism.structures.structure import Structure
from trimmer.mechanism.units import UnitError, dimension_of

_OF_ROTATIONS: Mapping[str, str] = MappingProxyType(
    {
        **{"m": "rad", "m/s": "rad/s", "m/s²": "rad/s²", "N": "N m", "N s": "N m s"},
        **{"N/m": "N m/rad", "N s/m": "N m s/rad", "m/N": "rad/(N m)", "kg": "kg m²", "kg m": "kg m²"},
    }
)
_EXAMPLES: Mapping[str, str] = MappingProxyType(
    {
        **{"rad": "0.5 deg", "rad/s": "3000 rpm", "N m": "20 mN m", "N m/rad": "50 N m/rad"},
        **{"N m s/rad": "0.02 N m s/rad", "kg m²": "2 g mm^2"},
    }
)


class Kind(Enum):
    """Whether something moves along the line or turns; the value says so after "is a"."""

    TRANSLATION = "translation"
    ROTATION = "rotation"

    def unit(self, unit: str) -> str:
        """Return what stands in place of a unit of translations, as rad/s does in place of m/s."""
        return unit if self is Kind.TRANSLATION else _OF_ROTATIONS.get(unit, unit)

    def field(self, field: NumberField) -> NumberField:
        """Return a number of a translation as one of this kind."""
        unit = self.unit(field.unit)
        return field if unit == field.unit else replace(field, unit=unit, example=_EXAMPLES[unit])


ARM = NumberField("m", "50 mm")  # Weight of a rotation in a point that moves along the line
_FIELDS: Mapping[tuple[type, Kind], Mapping[str, NumberField]] = MappingProxyType(
    {
        (part, kind): MappingProxyType({key: kind.field(each) for key, each in numbers.items()})
        for part, numbers in QUANTITIES.items()
        for kind in Kind
    }
)
_BODIES: Mapping[Kind, Mapping[str, NumberField]] = MappingProxyType(
    {kind: {key: QUANTITIES[Body][key]} for kind, key in zip(Kind, ("mass", "inertia"), strict=True)}
)


def kinds_of(content: Mapping[str, Any]) -> dict[str, Kind]:
    """Return the kind of everything that can be an end, by name, as far as it can be told.

    A pin on the ground is what its units measure, or else what it is joined to.
    """
    found = {
        name: Kind.TRANSLATION if entry(body, "inertia") is None else Kind.ROTATION
        for name, body in _parts(content, "bodies")
        if entry(body, "mass") is not None or entry(body, "inertia") is not None
    }
    turning = rotations_in(content)
    found |= {name: Kind.ROTATION if turns else Kind.TRANSLATION for name, turns in turning.items()}
    points = {name: kind_of_point(found, point) for name, point in _parts(content, "points")}
    found |= {name: kind for name, kind in points.items() if kind is not None}
    grounded = []
    for name, pin in _parts(content, "pins"):
        if entry(pin, "on") == GROUND:
            grounded.append(name)
        elif (kind := _known(found, entry(pin, "on"))) is not None:
            found[name] = kind
    joined: dict[str, Kind] = {}
    for _, _, (start, end) in _joined(content):
        for one, other in ((start, end), (end, start)):
            if (kind := _known(found, other)) is not None:
                joined.setdefault(one, kind)
    pins = dict(_parts(content, "pins"))
    for name in grounded:
        found[name] = _of_texts(pins[name]) or joined.get(name, Kind.TRANSLATION)
    return found


def kind_of_point(kinds: Mapping[str, Kind], point: object) -> Kind | None:
    """Return the kind of a weighted sum: a rotation where all turn and no weight is a length."""
    weights = weights_of(point)
    met = {_known(kinds, each) for each in weights}
    if Kind.TRANSLATION in met or entry(point, "by_length") is True or any(map(is_length, weights.values())):
        return Kind.TRANSLATION
    return Kind.ROTATION if Kind.ROTATION in met else None


def number_of_weight(kinds: Mapping[str, Kind], kind: Kind | None, of: str) -> NumberField:
    """Return what a weight measures in a sum of a kind: a length, m, where a rotation makes it move."""
    turns = kind is Kind.TRANSLATION and _known(kinds, of) is Kind.ROTATION
    return ARM if turns else WEIGHT


def weights_of(part: object) -> Mapping[str, Any]:
    """Return the weights of a point or an output, or of the table of one."""
    weights = part if isinstance(part, Mapping) else getattr(part, "weights", {})
    for key in place_of_weights(part):
        weights = weights[key]
    return weights if isinstance(weights, Mapping) else {}


def place_of_weights(part: object) -> tuple[str, ...]:
    """Return the key below which the weights stand in the table of an output, such as ``velocity``."""
    inner = list(part.items()) if isinstance(part, Mapping) else []
    return (inner[0][0],) if len(inner) == 1 and isinstance(inner[0][1], Mapping) else ()


def kind_of_output(content: Mapping[str, Any], kinds: Mapping[str, Kind], output: Output) -> Kind:
    """Return the kind of an output, which is there: of a force that of its part."""
    if output.part is None:
        return kind_of_point(kinds, output) or Kind.TRANSLATION
    sections = ("controllers",) if OutputKind.chosen(output.kind, "kind") is OutputKind.CONTROL else COUPLINGS
    parts = ((each, content.get(each, {}).get(output.part)) for each in sections)
    found = (kind_of_part(kinds, section, output.part, part) for section, part in parts if part is not None)
    return next(found, Kind.TRANSLATION)


def is_length(value: object) -> bool:
    """Say whether a weight is text with a unit of length."""
    return isinstance(value, str) and _fits(value, ARM)


def kind_of_part(kinds: Mapping[str, Kind], section: str, name: str, part: object) -> Kind:
    """Return the kind of a part: its own if it can be an end, else that of what it acts on.

    Of ends that are not there it is what the part's units say.
    """
    ends: Any = (name,)
    if section in COUPLINGS:
        ends = entry(part, "between")
    elif section == "controllers":
        ends = entry(part, "acts")
    elif section == "forces":
        ends = (entry(part, "on"),)
    known = (_known(kinds, each) for each in (ends if _is_list(ends) else ()))
    return next((kind for kind in known if kind is not None), None) or _of_units(section, part)


def _of_units(section: str, part: object) -> Kind:
    if section not in PARTS:
        return Kind.TRANSLATION
    turning, moving = (_FIELDS[PARTS[section], kind] for kind in (Kind.ROTATION, Kind.TRANSLATION))
    texts = [(key, text) for key in moving if isinstance(text := entry(part, key), str)]
    turns = any(_fits(text, turning[key]) and not _fits(text, moving[key]) for key, text in texts)
    return Kind.ROTATION if turns else Kind.TRANSLATION


def _fits(text: str, number: NumberField) -> bool:
    try:
        return dimension_of(text) == dimension_of(f"1 {number.unit}")
    except UnitError:
        return False


def numbers_of_part(
    kinds: Mapping[str, Kind], section: str, name: str, part: object
) -> Mapping[str, NumberField]:
    """Return the numbers of a part by their keys, in the units of its kind; of a body the one that it has."""
    kind = kind_of_part(kinds, section, name, part)
    if section == "bodies":
        return _BODIES[kind]
    if isinstance(part, Structure) and (part.modes is not None or part.damping is not None):
        return {}
    return _FIELDS[PARTS[section], kind]


def numbers_of_start(kinds: Mapping[str, Kind], body: object) -> tuple[NumberField, NumberField]:
    """Return what a start gives of a body, in the order of the file: displacement and velocity."""
    kind = _known(kinds, body) or Kind.TRANSLATION
    return kind.field(DISPLACEMENT), kind.field(VELOCITY)


def problems_of_kinds(content: Mapping[str, Any], kinds: Mapping[str, Kind]) -> Iterator[Problem]:
    """Find parts between two ends of different kinds."""
    for section, name, (start, end) in _joined(content):
        first, second = _known(kinds, start), _known(kinds, end)
        if first is not None and second is not None and first is not second:
            reason = (
                f"{start!r} is a {first.value} and {end!r} a {second.value}; both ends are of one kind, "
                "so let one be a point that turns the other's motion into its own"
            )
            yield Problem((section, name, key_of_ends(section)), reason, [start, end])


def key_of_ends(section: str) -> str:
    """Return the key below which the parts of a section have their two ends."""
    return "acts" if section == "controllers" else "between"


def entry(part: object, key: str) -> Any:
    """Return what a part, or the table of one, has below a key; None for nothing."""
    return part.get(key) if isinstance(part, Mapping) else getattr(part, key, None)


def _parts(content: Mapping[str, Any], section: str) -> list[tuple[str, Any]]:
    parts = content.get(section)
    return list(parts.items()) if isinstance(parts, Mapping) else []


def _joined(content: Mapping[str, Any]) -> Iterator[tuple[str, str, tuple[str, str]]]:
    """Yield section and name of each part between two ends, and their names."""
    for section in (*COUPLINGS, "controllers"):
        for name, part in _parts(content, section):
            ends = entry(part, key_of_ends(section))
            if _is_list(ends) and len(ends) == 2 and all(isinstance(e, str) for e in ends):
                yield section, name, (ends[0], ends[1])


def _known(kinds: Mapping[str, Kind], end: object) -> Kind | None:
    return kinds.get(end) if isinstance(end, str) else None


def _of_texts(pin: object) -> Kind | None:
    """Return what the units of a pin measure, None where none is written."""
    given = entry(pin, "harmonics")
    rows = [row for row in given if _is_list(row) and len(row) == 3] if _is_list(given) else []
    texts = [*(entry(pin, key) for key in ("amplitude", "offset", "velocity")), *(row[1] for row in rows)]
    measured = map(_measures, texts)
    return next((kind for kind in measured if kind is not None), None)


def _is_list(value: object) -> bool:
    return isinstance(value, list | tuple)


def _measures(value: object) -> Kind | None:
    """Return what a text with a unit of length or angle, or of a rate of one, measures."""
    if not isinstance(value, str):
        return None
    kinds = {unit: kind for kind in Kind for unit in (kind.unit("m"), kind.unit("m/s"))}
    fitting = (kind for unit, kind in kinds.items() if _fits(value, NumberField(unit, "")))
    return next(fitting, None)
