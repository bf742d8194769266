"""Outputs of every kind in a file and in Python: ``{ cutter = 1 }``, ``{ velocity = { cutter = 1 } }``."""

from collections.abc import Callable, Iterator, Mapping
from types import MappingProxyType
from typing import Any

from trimmer.choices import ChoiceError
from trimmer.mechanism.parts import COUPLINGS, GROUND, Output, OutputKind
from trimmer.mechanism.place_text import Place
from trimmer.mechanism.points import ends_in
from trimmer.mechanism.problems import Problem, no_such
from trimmer.mechanism.quantities import WEIGHT
from trimmer.mechanism.read_only import ReadOnly
from trimmer.mechanism.structures.ends import no_such_end
from trimmer.messages import listed

OF_ENDS = {kind.word: kind for kind in (OutputKind.VELOCITY, OutputKind.ACCELERATION)}
"""The kinds with weights that have a key of their own."""
FORCE = OutputKind.FORCE.word
CONTROL = OutputKind.CONTROL.word
OF_PARTS = {kind.word: kind for kind in (OutputKind.FORCE, OutputKind.CONTROL)}  # The kinds that name a part
KEYS = (*OF_ENDS, FORCE, CONTROL)  # Keys that say of which kind an output is, each of which then stands alone
UNITS: Mapping[OutputKind, str] = MappingProxyType(
    {
        OutputKind.DISPLACEMENT: "m",
        OutputKind.VELOCITY: "m/s",
        OutputKind.ACCELERATION: "m/s²",
        OutputKind.FORCE: "N",
        OutputKind.CONTROL: "N",
    }
)
"""SI unit of each kind."""
_EXAMPLE = "{ cutter = 1, guard = -1 }"


def problems_of_form(place: Place, entries: object) -> Iterator[Problem]:
    """Find what should be a table in a point or an output of a file and is none."""
    if not isinstance(entries, dict):
        yield Problem(place, f"give weights, as in {_EXAMPLE}", entries)
        return
    key = _kind_key(entries) if place[0] == "outputs" else None
    if key in OF_ENDS and not isinstance(entries[key], dict):
        yield Problem((*place, key), f"give weights, as in {{ {key} = {_EXAMPLE} }}", entries[key])
    elif key == FORCE and not isinstance(entries[key], str):
        yield Problem((*place, key), 'name a part, as in { force = "bridge" }', entries[key])
    elif key == CONTROL and not isinstance(entries[key], str):
        yield Problem((*place, key), 'name a controller, as in { control = "axis" }', entries[key])


def output_of(
    place: Place, entries: Mapping[str, Any], read: Callable[[Place, Mapping[str, Any]], Mapping[str, Any]]
) -> Output:
    """Return an output of a file, whose weights are read by the place of all and their texts."""
    key = _kind_key(entries)
    if key in OF_PARTS:
        return Output(kind=OF_PARTS[key], part=entries[key])
    kind, inner = OutputKind.DISPLACEMENT, place
    if key is not None:
        kind, inner, entries = OF_ENDS[key], (*place, key), entries[key]
    return Output(read(inner, entries), kind)


def _kind_key(entries: Mapping[str, Any]) -> str | None:
    return next(iter(entries)) if len(entries) == 1 and next(iter(entries)) in KEYS else None


def entries_of(output: Output) -> dict[str, object]:
    """Return an output as what a file has to hold."""
    match output.kind:
        case OutputKind.DISPLACEMENT:
            return dict(output.weights)
        case OutputKind.FORCE | OutputKind.CONTROL:
            return {output.kind.word: output.part}
        case kind:
            return {kind.word: dict(output.weights)}


def weight_place(name: str, kind: OutputKind, of: str) -> Place:
    """Return the place of a weight, such as ``outputs.speed.velocity.cutter``."""
    inner = () if kind is OutputKind.DISPLACEMENT else (kind.word,)
    return ("outputs", name, *inner, of)


def problems_of_kind(place: Place, output: Output) -> Iterator[Problem]:
    """Find an output that is of no kind, or holds what does not belong to its kind."""
    try:
        kind = OutputKind.chosen(output.kind, "kind")
    except ChoiceError as error:
        yield Problem((*place, "kind"), str(error).split(": ", 1)[-1], output.kind)
        return
    if kind not in OF_PARTS.values():
        if output.part is not None:
            yield Problem((*place, "part"), "only the force of a part is asked for by its name", output.part)
    elif not isinstance(output.part, str):
        yield Problem((*place, kind.word), f'name a part, as in {{ {kind.word} = "bridge" }}', output.part)
    elif output.weights:
        yield Problem(
            place, f"a {kind.word} has no weights; leave them out, or write another output for them"
        )


def taken(output: Output) -> Output:
    """Return an output with floats for all weights and its kind for the word."""
    weights = {name: WEIGHT.taken(weight) for name, weight in output.weights.items()}
    return Output(ReadOnly(weights), OutputKind.chosen(output.kind, "kind"), output.part)


def problems_of_outputs(content: Mapping[str, Any], known: list[str]) -> Iterator[Problem]:
    """Find outputs that ask for what is not there."""
    for name, output in content["outputs"].items():
        place, kind = ("outputs", name), OutputKind.chosen(output.kind, "kind")
        if kind is OutputKind.FORCE:
            yield from _of_force((*place, FORCE), output.part, content)
        elif kind is OutputKind.CONTROL:
            if output.part not in content["controllers"]:
                reason = no_such("controller", output.part, content["controllers"])
                yield Problem((*place, CONTROL), reason, output.part)
        elif not output.weights:
            yield Problem(place, f"has no weights; write them, as in {_EXAMPLE}")
        elif kind is OutputKind.DISPLACEMENT and (key := _kind_key(output.weights)) is not None:
            yield Problem(place, f"with the one key {key!r} it is no displacement; rename the body", key)
        for of, weight in output.weights.items():
            there = weight_place(name, kind, of)
            if of == GROUND:
                yield Problem(there, "the ground does not move; leave it out", weight)
            elif of not in known:
                yield Problem(there, no_such_end(content, ends_in(content), of, known), weight)
    yield from _of_names(content, known)


def _of_force(place: Place, part: str, content: Mapping[str, Any]) -> Iterator[Problem]:
    sections = [each for each in COUPLINGS if part in content[each]]
    if not sections:
        known = [name for each in COUPLINGS for name in content[each]]
        yield Problem(place, no_such("link, play, stop, wall or friction", part, known), part)
    elif len(sections) > 1:
        yield Problem(place, f"a part of this name is in {listed(sections)}; rename all but one", part)


def _of_names(content: Mapping[str, Any], known: list[str]) -> Iterator[Problem]:
    """Find names that are keys too where both are used."""
    kinds = {OutputKind.chosen(each.kind, "kind") for each in content["outputs"].values()}
    if kinds <= {OutputKind.DISPLACEMENT}:
        return
    for name in known:
        if name in KEYS:
            section = next(each for each in ("bodies", "pins", "points") if name in content[each])
            yield Problem((section, name), "this name says of which kind an output is; choose another one")
