"""Whether controllers and references can be used, and go together with the rest of a mechanism."""

import math
from collections.abc import Iterator, Mapping, Sequence
from dataclasses import fields
from itertools import pairwise
from typing import Any

from trimmer.errors import MechanismError
from trimmer.mechanism.controls.controllers import DIFFERENCE, Cascade, Controller, Pid, TransferController
from trimmer.mechanism.controls.numbers import ROWS, kind_of, numbers_of
from trimmer.mechanism.controls.references import REFERENCES, ProfileReference, Reference
from trimmer.mechanism.kinds import Kind, entry
from trimmer.mechanism.parts import GROUND, OutputKind
from trimmer.mechanism.place_text import place_text
from trimmer.mechanism.points import ends_in
from trimmer.mechanism.problems import NOTHING, Problem, no_such, problems_of_name
from trimmer.mechanism.quantities import NumberField
from trimmer.mechanism.structures.ends import coordinates_in, no_such_end, points_in

SECTIONS = ("controllers", "references")
OPTIONAL = ("limit", "tracking", "sample", "pade", "ti")  # Numbers that may be None
_TEXTS = ("measure", "reference", "speed")
_FORMS = {
    "numerator": "[2.0, 1.0] for 2 s + 1",
    "denominator": "[0.01, 1.0] for 0.01 s + 1",
    "profile": "[[0.0, 0.0], [0.1, 0.5]]",
}
_FORCES = (OutputKind.ACCELERATION, OutputKind.FORCE, OutputKind.CONTROL)
"""Kinds of outputs that depend, or may depend, on a force at the same instant."""
ROUNDING = 1e-12


def problems_of_links(content: Mapping[str, Any]) -> Iterator[Problem]:
    """Find names in the controls of a file that nothing has: without them units would be told wrong."""
    sections = ("bodies", "points", "pins", "structures", "outputs", "references", "controllers")
    content = {**{section: {} for section in sections}, **content}
    yield from _unknown(content)
    followed = [each.get("reference") for each in content["controllers"].values()]
    yield from _not_followed(content["references"], followed)


def _unknown(content: Mapping[str, Any]) -> Iterator[Problem]:
    """Find names that nothing has in controllers, or in the tables of such."""
    outputs, references = content["outputs"], content["references"]
    ends = [*coordinates_in(content), *content["points"], *points_in(content), *content["pins"], GROUND]
    for name, controller in content["controllers"].items():
        place = ("controllers", name)
        for key, what, known in (
            ("measure", "output", outputs),
            ("speed", "output", outputs),
            ("reference", "reference", references),
        ):
            named = entry(controller, key)
            if isinstance(named, str) and named not in known and (key, named) != ("speed", DIFFERENCE):
                yield Problem((*place, key), no_such(what, named, known), named)
        acts = entry(controller, "acts")
        for end in dict.fromkeys(acts) if _are_words(acts) else ():
            if end not in ends:
                reason = no_such_end(content, ends_in(content), end, ends)
                yield Problem((*place, "acts"), reason, list(acts))


def _are_words(value: object) -> bool:
    return isinstance(value, list | tuple) and all(isinstance(each, str) for each in value)


def _not_followed(references: Mapping[str, Any], followed: Sequence[object]) -> Iterator[Problem]:
    for name, entries in references.items():
        if name in followed or any(each not in (None, *references) for each in followed):
            continue
        reason = f"no controller follows it, so its unit is not known; write reference = {name!r}"
        for place, value in _values_of(entries):
            if isinstance(value, str):
                yield Problem(("references", name, *place), reason, value)


def _values_of(entries: Mapping[str, Any]) -> Iterator[tuple[tuple[str, ...], object]]:
    """Yield what in the table of a reference has the unit of what is measured, with its place."""
    yield from (((key,), entries[key]) for key in REFERENCES if key in entries and key not in ROWS)
    points = entries.get("profile")
    for number, point in enumerate(points if isinstance(points, list) else (), start=1):
        if isinstance(point, list) and len(point) == 2:
            yield ("profile", str(number), "value"), point[1]


def problems_of_types(content: Mapping[str, Any], kinds: Mapping[str, Kind]) -> Iterator[Problem]:
    """Find fields of controllers and references that are not what they should be."""
    for section in SECTIONS:
        parts = content[section]
        if not isinstance(parts, Mapping):
            yield Problem((section,), f"must map names to {section} of trimmer.mechanism", parts)
            continue
        for name, part in parts.items():
            if isinstance(part, Mapping) or kind_of(section, part) is None:
                yield Problem((section, str(name)), f"give one of the {section} of trimmer.mechanism", part)
            elif wrong := list(problems_of_name((section,), name)):
                yield from wrong
            else:
                yield from _fields((section, name), part, numbers_of(content, kinds, section, name))


def _fields(place: tuple[str, str], part: Any, numbers: Mapping[str, NumberField]) -> Iterator[Problem]:
    for each in fields(part):
        value, there = getattr(part, each.name), (*place, each.name)
        if each.name in ROWS:
            yield from _rows(there, value, numbers)
        elif each.name in numbers:
            if value is not None or each.name not in OPTIONAL:
                yield from numbers[each.name].problems(there, value)
        elif each.name == "acts":
            if not _are_words(value) or len(value) != 2:
                yield Problem(there, 'name two ends, as in ["ground", "motor"]', value)
        elif (
            each.name in _TEXTS
            and not isinstance(value, str)
            and (value is not None or each.name == "measure")
        ):
            yield Problem(there, f"name {'a reference' if each.name == 'reference' else 'an output'}", value)


def _rows(place: tuple[str, ...], value: object, numbers: Mapping[str, NumberField]) -> Iterator[Problem]:
    points = place[-1] == "profile"
    listed_ = value if isinstance(value, list | tuple) else ()
    pairs = all(isinstance(row, list | tuple) and len(row) == 2 for row in listed_)
    if not listed_ or (points and not pairs):
        what = "points [time in s, value]" if points else "numbers, descending powers of s"
        yield Problem(place, f"give a list of {what}, as in {_FORMS[place[-1]]}", value)
        return
    for count, row in enumerate(listed_, start=1):
        if not points:
            yield from numbers["coefficient"].problems((*place, str(count)), row)
            continue
        for key, each in zip(("time", "value"), row, strict=True):
            yield from numbers[key].problems((*place, str(count), key), each)


def problems_of_control(content: Mapping[str, Any]) -> Iterator[Problem]:
    """Find controllers that do not go together with the rest: outputs, references, ends, loops."""
    yield from _unknown(content)
    for name, controller in content["controllers"].items():
        for end in dict.fromkeys(controller.acts):
            if end in content["pins"]:
                reason = f"a pin moves as prescribed; name what carries it, {content['pins'][end].on!r}"
                yield Problem(("controllers", name, "acts"), reason, list(controller.acts))
        yield from _speed(content, name, controller)
        if controller.sample is None:
            yield from _algebraic(content, name, controller)


def _speed(content: Mapping[str, Any], name: str, controller: Controller) -> Iterator[Problem]:
    place = ("controllers", name, "speed")
    if not isinstance(controller, Cascade):
        return
    if controller.speed == DIFFERENCE:
        if controller.sample is None:
            reason = "a difference is that of two samples; give a sample, or name an output"
            yield Problem(place, reason, controller.speed)
        return
    kinds = {name: OutputKind.chosen(each.kind, "kind") for name, each in content["outputs"].items()}
    displaces = kinds.get(controller.measure) is OutputKind.DISPLACEMENT
    if controller.speed is None and controller.measure in kinds and not displaces:
        reason = f"missing; {controller.measure!r} is no displacement, so name the output that is the speed"
        yield Problem(place, reason)
    elif displaces and kinds.get(controller.speed or "") is OutputKind.DISPLACEMENT:
        yield Problem(place, "it is a displacement, as what is measured; name a velocity", controller.speed)


def _algebraic(content: Mapping[str, Any], name: str, controller: Controller) -> Iterator[Problem]:
    """Find outputs of a continuous controller that depend on a force at the same instant."""
    for key in ("measure", "speed"):
        of = getattr(controller, key)
        output = content["outputs"].get(of) if isinstance(of, str) else None
        if output is None or (kind := OutputKind.chosen(output.kind, "kind")) not in _FORCES:
            continue
        if kind is OutputKind.FORCE and output.part in content["links"]:
            if content["links"][output.part].curve:
                reason = (
                    f"a continuous controller that measures the force of a curve, that of {output.part!r}, "
                    "is not computed; measure a displacement, or give the controller a sample"
                )
                yield Problem(("controllers", name, key), reason, of)
            continue  # Springs and dampers depend on the state alone.
        path = [repr(name), repr(of)]
        path += [repr(output.part)] if output.part is not None else ["forces"]
        path += [repr(name)] if path[-1] != repr(name) else []
        reason = (
            f"an algebraic loop, {' -> '.join(path)}: this output depends on a force that acts at the same "
            "instant; measure a displacement, a velocity or a link's force, or give the controller a sample"
        )
        yield Problem(("controllers", name, key), reason, of)


def problems_of_control_numbers(content: Mapping[str, Any]) -> Iterator[Problem]:
    """Find numbers of controllers and references that do not go together."""
    for name, controller in content["controllers"].items():
        for key, reason in _of_numbers(controller):
            value = getattr(controller, key)
            yield Problem(("controllers", name, key), reason, NOTHING if value is None else value)
    for name, reference in content["references"].items():
        yield from _of_reference(name, reference)


def _of_numbers(controller: Controller) -> Iterator[tuple[str, str]]:
    if isinstance(controller, Pid) and controller.kd != 0 and controller.filter_time == 0:
        yield "filter_time", "a gain kd needs a filter_time greater than 0, in s; give one, or leave kd out"
    if isinstance(controller, TransferController):
        yield from _of_transfer(controller)
    if controller.sample is None and controller.delay > 0 and controller.pade is None:
        reason = (
            "a delay needs a sample, or pade = 3 for its approximant of that order in a continuous controller"
        )
        yield "delay", reason
    if controller.sample is not None and controller.pade is not None:
        yield "pade", "a sampled controller delays exactly; leave this out"
    yield from _of_tracking(controller)


def _of_tracking(controller: Controller) -> Iterator[tuple[str, str]]:
    if controller.limit is not None and controller.integrates and controller.tracking_time is None:
        reason = (
            "missing; a limit and an integral part need the time in which the integral follows, in s, "
            "since kp and ki are not both positive; inf for never"
        )
        yield "tracking", reason
    if controller.tracking is None:
        return
    if isinstance(controller, TransferController):
        yield "tracking", "a transfer function has no integral that could follow its limit; leave this out"
    elif controller.limit is None:
        yield "tracking", "the integral follows a limit, and there is none; leave this out, or give a limit"
    elif not controller.integrates:
        needed = "ki is 0" if isinstance(controller, Pid) else "ti is missing"
        reason = f"there is no integral part that could follow the limit, since {needed}"
        yield "tracking", f"{reason}; give {needed.split()[0]}, or leave this out"
    elif controller.sample is not None and controller.tracking < controller.sample:
        yield "tracking", f"must not be shorter than the sample, {controller.sample!r} s"


def _of_transfer(controller: TransferController) -> Iterator[tuple[str, str]]:
    if controller.denominator[0] == 0:
        yield "denominator", "its first coefficient must not be 0; leave leading zeros out"
    order = len(controller.numerator) - next(
        (place for place, each in enumerate(controller.numerator) if each), len(controller.numerator) - 1
    )
    if order > len(controller.denominator):
        reason = (
            f"improper: it has the degree {order - 1}, and the denominator "
            f"{len(controller.denominator) - 1}; give it a further factor, such as a filter 1e-3 s + 1"
        )
        yield "numerator", reason
    if controller.sample is not None:
        s = 2.0 / controller.sample
        terms = [each * s**power for power, each in enumerate(reversed(controller.denominator))]
        if abs(math.fsum(terms)) <= ROUNDING * math.fsum(map(abs, terms)):
            reason = f"has a root at s = 2/sample = {s:.6g} 1/s, where Tustin's rule does not hold"
            yield "denominator", f"{reason}; choose another sample"


def _of_reference(name: str, reference: Reference) -> Iterator[Problem]:
    if not isinstance(reference, ProfileReference):
        return
    times = [float(row[0]) for row in reference.profile]
    for number, (before, after) in enumerate(pairwise(times), start=2):
        if not before < after:
            reason = f"the time must rise from point to point, and that before is {before!r}"
            yield Problem(("references", name, "profile", str(number), "time"), reason, after)


def require_uncontrolled(controllers: Mapping[str, object], what: str) -> None:
    """Check that there are no controllers, where they would be passed over."""
    if controllers:
        place = place_text(("controllers", next(iter(controllers))))
        raise MechanismError(f"{place}: {what} does not know controllers yet; leave them out")
