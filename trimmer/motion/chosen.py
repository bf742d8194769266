"""Measures by the dotted keys that they have in the JSON of ``trimmer respond``."""

from collections.abc import Callable, Iterator, Mapping
from dataclasses import dataclass
from fractions import Fraction
from types import MappingProxyType
from typing import Any, TypeAlias

from trimmer.choices import ChoiceError
from trimmer.mechanism.place_text import parse_place
from trimmer.messages import near_match
from trimmer.motion.flow import Flow
from trimmer.motion.measures import HARMONICS, Measures
from trimmer.motion.units import Units

Of: TypeAlias = Callable[[Any], float]
SIZES = ("peak_to_peak", "rms", "mean", "advance")
CONTACT: Mapping[str, tuple[Of, Callable[[Units], str]]] = MappingProxyType(
    {
        "impacts_per_period": (lambda each: each.impacts, lambda _: ""),
        "impact_speed": (lambda each: each.impact_speed, lambda units: units.speed),
        "largest_force": (lambda each: each.largest_force or 0.0, lambda units: units.force),
        "share_of_time": (lambda each: each.share, lambda _: ""),
    }
)
FRICTION: Mapping[str, tuple[Of, Callable[[Units], str]]] = MappingProxyType(
    {
        "work_per_period": (lambda each: each.work, lambda units: units.work),
        "power": (lambda each: each.power, lambda units: units.power),
        "share_of_stick": (lambda each: each.stick, lambda _: ""),
    }
)


@dataclass(frozen=True)
class ChosenMeasure:
    """A measure with its dotted key and SI unit, taken out of the measures of a motion."""

    key: str
    unit: str
    of: Callable[[Measures], float]


def chosen_measure(flow: Flow, key: str) -> ChosenMeasure:
    """Return the measure with a key, of what moves so.

    Beside those of the JSON there are ``rattle``, 1 where sides of contacts meet and 0 elsewhere,
    ``impacts_per_period`` and ``impact_speed`` of all contacts together, ``impact_speed`` of each, and
    ``outputs.NAME.lines.P/K``, the amplitude at P/K of the drive.
    """
    known = {each.key: each for each in _known(flow)}
    if key in known:  # As it stands, with whatever is in the names.
        return known[key]
    names = parse_place(key)
    match names:
        case ("outputs", name, "harmonics", order) if name in flow.outputs and order.isdecimal():
            if 1 <= int(order) <= HARMONICS:
                return ChosenMeasure(key, flow.outputs[name].unit, _line(name, Fraction(order)))
        case ("outputs", name, "lines", order) if name in flow.outputs:
            if all(part.isdecimal() and int(part) for part in order.split("/")) and order.count("/") <= 1:
                return ChosenMeasure(key, flow.outputs[name].unit, _line(name, Fraction(order)))
        case _ if ".".join(names) in known:
            return known[".".join(names)]
    there = near_match(key, known) or f"such are {', '.join(list(known)[:4])} and rattle"
    raise ChoiceError(f"there is no measure {key!r}; {there}")


def _line(name: str, order: Fraction) -> Callable[[Measures], float]:
    def amplitude(measures: Measures) -> float:
        found = measures.outputs[name]
        place = order * found.period_count
        inside = place.denominator == 1 and place <= len(found.amplitudes)
        return float(abs(found.amplitudes[int(place) - 1])) if inside else 0.0

    return amplitude


def _known(flow: Flow) -> Iterator[ChosenMeasure]:
    for name, output in flow.outputs.items():
        for size in SIZES:
            yield ChosenMeasure(f"outputs.{name}.{size}", output.unit, _size(name, size))
    for name in flow.accelerations:
        yield ChosenMeasure(
            f"bodies.{name}.rms_acceleration", flow.units_of_body(name).acceleration, _acceleration(name)
        )
    for part in (each.name for each in flow.parts if each.touches):
        for word, (of, unit) in CONTACT.items():
            yield ChosenMeasure(
                f"contacts.{part}.{word}", unit(flow.units_of_part(part)), _part("contacts", part, of)
            )
    for part in flow.rubbing:
        for word, (of, unit) in FRICTION.items():
            yield ChosenMeasure(
                f"frictions.{part}.{word}", unit(flow.units_of_part(part)), _part("frictions", part, of)
            )
    yield ChosenMeasure("events_per_period", "", lambda each: each.events_per_period)
    yield ChosenMeasure("impacts_per_period", "", _impacts)
    yield ChosenMeasure(
        "impact_speed",
        flow.units.speed,
        lambda each: max((contact.impact_speed for contact in each.contacts.values()), default=0.0),
    )
    yield ChosenMeasure("rattle", "", lambda each: float(_impacts(each) > 0))


def _impacts(measures: Measures) -> float:
    return sum(each.impacts for each in measures.contacts.values())


def _size(name: str, size: str) -> Callable[[Measures], float]:
    return lambda measures: float(getattr(measures.outputs[name], size))


def _acceleration(name: str) -> Callable[[Measures], float]:
    return lambda measures: measures.rms_acceleration[name]


def _part(section: str, name: str, of: Of) -> Callable[[Measures], float]:
    """Return what takes a number out of the measures of a part; 0 where it exerts no force."""

    def number(measures: Measures) -> float:
        parts = getattr(measures, section)
        return float(of(parts[name])) if name in parts else 0.0

    return number
