"""The numbers of controllers and references: their units follow those of what is measured and what acts.

Parts may be tables of a file here, with anything in them.
"""

from collections import Counter
from collections.abc import Mapping
from typing import Any

from trimmer.mechanism.controls.controllers import CONTROLLERS, DIFFERENCE, Cascade, Pid, TransferController
from trimmer.mechanism.controls.references import (
    REFERENCES,
    ProfileReference,
    RampReference,
    SineReference,
    StepReference,
)
from trimmer.mechanism.kinds import Kind, entry, kind_of_output, kind_of_part
from trimmer.mechanism.outputs import UNITS, output_of, problems_of_form
from trimmer.mechanism.parts import Output, OutputKind
from trimmer.mechanism.quantities import FREQUENCY, ORDER, PHASE, NumberField, Range

TIME = NumberField("s", "10 ms")
_SHARED: Mapping[str, NumberField] = {
    "tracking": NumberField("s", "50 ms", Range.TO_INFINITY),
    "sample": NumberField("s", "1 ms", Range.POSITIVE),
    "delay": NumberField("s", "0.5 ms", Range.NOT_NEGATIVE),
    "pade": ORDER,
}
ROWS = ("numerator", "denominator", "profile")  # Keys of lists of numbers


def kind_of(section: str, part: object) -> type | None:
    """Return the class of a controller or a reference, or of the table of one; None if it tells none."""
    known: Mapping[str, type] = CONTROLLERS if section == "controllers" else REFERENCES
    if not isinstance(part, Mapping):
        return type(part) if type(part) in known.values() else None
    if section == "controllers":
        word = part.get("kind")
        return known.get(word) if isinstance(word, str) else None
    return next((known[key] for key in part if key in known), None)


def numbers_of(
    content: Mapping[str, Any], kinds: Mapping[str, Kind], section: str, name: str
) -> dict[str, NumberField]:
    """Return what the numbers of a controller or a reference measure, by key; ``value`` those of profiles."""
    part = content[section][name]
    kind = kind_of(section, part)
    if section == "references":
        return _of_reference(kind, _unit_followed(content, kinds, name))
    measured = unit_of_output(content, kinds, entry(part, "measure"))
    acting = kind_of_part(kinds, "controllers", name, part).unit("N")
    found = {"limit": _field(acting, "2", Range.POSITIVE), **_SHARED}
    if kind is Pid:
        found |= {"kp": _field(quotient(acting, measured)), "ki": _field(quotient(acting, measured, "s"))}
        found |= {"kd": _field(quotient(acting, measured, "1/s"))}
        found |= {"filter_time": NumberField("s", "1 ms", Range.NOT_NEGATIVE)}
    if kind is Cascade:
        rate = quotient(measured, "s")
        speed = entry(part, "speed")
        if isinstance(speed, str) and speed != DIFFERENCE:
            rate = unit_of_output(content, kinds, speed)
        found |= {"kp": _field(quotient(rate, measured)), "kv": _field(quotient(acting, rate))}
        found |= {"ti": NumberField("s", "20 ms", Range.POSITIVE)}
        found |= {"feedforward": _field(quotient(rate, measured, "1/s"))}
    if kind is TransferController:
        found["coefficient"] = NumberField("1", "1")
    return found


def _of_reference(kind: type | None, unit: str) -> dict[str, NumberField]:
    value = _field(unit)
    if kind is StepReference:
        return {"step": value, "at": NumberField("s", "10 ms", Range.NOT_NEGATIVE)}
    if kind is RampReference:
        return {"ramp": _field(quotient(unit, "s")), "at": TIME}
    if kind is SineReference:
        return {"sine": value, "frequency": FREQUENCY, "phase": PHASE}
    return {"time": TIME, "value": value} if kind is ProfileReference else {}


def _field(unit: str, number: str = "0.5", range_: Range = Range.ANY) -> NumberField:
    return NumberField(unit, f"{number} {unit}", range_)


def _unit_followed(content: Mapping[str, Any], kinds: Mapping[str, Kind], name: str) -> str:
    """Return the unit of a reference: that of what the first controller measures that follows it."""
    controllers = content.get("controllers")
    for each in controllers.values() if isinstance(controllers, Mapping) else ():
        if entry(each, "reference") == name:
            return unit_of_output(content, kinds, entry(each, "measure"))
    return "m"


def unit_of_output(content: Mapping[str, Any], kinds: Mapping[str, Kind], name: object) -> str:
    """Return the SI unit of an output by its name, m if there is none."""
    outputs = content.get("outputs")
    output = outputs.get(name) if isinstance(outputs, Mapping) and isinstance(name, str) else None
    if isinstance(output, Mapping):
        place = ("outputs", str(name))
        if any(problems_of_form(place, output)):
            return "m"
        output = output_of(place, output, lambda _, weights: weights)
    if not isinstance(output, Output):
        return "m"
    return kind_of_output(content, kinds, output).unit(UNITS[OutputKind.chosen(output.kind, "kind")])


def quotient(numerator: str, *denominators: str) -> str:
    """Return a unit over others, with what cancels left out: N m over rad/s is ``N m s/rad``."""
    powers = _powers(numerator)
    for each in denominators:
        powers.subtract(_powers(each))
    above = " ".join(name for name, power in powers.items() for _ in range(power))
    below = "".join(f"/{name}" for name, power in powers.items() for _ in range(-power))
    return (above or "1") + below


def _powers(unit: str) -> Counter[str]:
    above, *below = unit.replace("s²", "s/s").split("/")
    found = Counter(each for each in above.split() if each != "1")
    found.subtract(below)
    return found
