"""Two designs side by side: what changed in the file, and what that changed."""

from dataclasses import dataclass
from math import isfinite

from trimmer.design.design import Design
from trimmer.design.trials.trial import MeasureOfPart, all_measures
from trimmer.mechanism.mechanism import Mechanism

SAME = 1e-12  # Relative difference of two numbers below which they are one


@dataclass(frozen=True)
class ChangedNumber:
    """A number that differs between two designs.

    Attributes:
        place: Its dotted place.
        unit: SI unit.
        before, after: Its values; None where the file has no such part.
    """

    place: str
    unit: str
    before: float | None
    after: float | None


@dataclass(frozen=True)
class MeasureDifference:
    """A measure of both designs.

    Attributes:
        asked: The measure.
        before, after: Its values, SI units; None where there is no such thing or no motion.
    """

    asked: MeasureOfPart
    before: float | None
    after: float | None

    @property
    def change(self) -> float | None:
        """Relative change; None where it is not defined."""
        if not self.before or self.after is None or not isfinite(self.before) or not isfinite(self.after):
            return None
        return self.after / self.before - 1


@dataclass(frozen=True)
class DesignComparison:
    """What differs between two designs.

    Attributes:
        before, after: The designs; looked at as far as a comparison needs.
        changes: Numbers of the file that differ.
        others: Places that differ in something else than a number, such as the ends of a part.
        differences: Measures that either design has.
    """

    before: Design
    after: Design
    changes: tuple[ChangedNumber, ...]
    others: tuple[str, ...]
    differences: tuple[MeasureDifference, ...]


def compared(before: Design, after: Design) -> DesignComparison:
    """Compare two designs."""
    first, second = before.file.mechanism, after.file.mechanism
    asked = dict.fromkeys((*measures_of(before), *measures_of(after)))
    differences = tuple(MeasureDifference(each, _value(before, each), _value(after, each)) for each in asked)
    return DesignComparison(before, after, _changes(first, second), _others(first, second), differences)


def measures_of(design: Design) -> tuple[MeasureOfPart, ...]:
    """Return what is measured of a design: through its steps, from start to rest, or once it has settled."""
    file, motion = design.file, design.motion
    switched = file.switched or bool(motion and motion.switched)
    return all_measures(file.mechanism, switched=switched, stepped=file.stepped)


def _changes(first: Mechanism, second: Mechanism) -> tuple[ChangedNumber, ...]:
    units = {**first.places, **second.places}
    pairs = [(place, unit, _number(first, place), _number(second, place)) for place, unit in units.items()]
    return tuple(ChangedNumber(*each) for each in pairs if _differ(*each[2:]))


def _number(mechanism: Mechanism, place: str) -> float | None:
    if place not in mechanism.places or (place == "frequency" and mechanism.frequency is None):
        return None
    return mechanism.value(place)


def _differ(one: float | None, other: float | None) -> bool:
    if one is None or other is None:
        return (one or 0.0) != (other or 0.0)
    return abs(one - other) > SAME * abs(one)


def _others(first: Mechanism, second: Mechanism) -> tuple[str, ...]:
    """Return parts whose ends, carriers or laws differ."""
    found = []
    for section in ("pins", "links", "plays", "stops", "walls", "frictions", "forces"):
        ours, theirs = getattr(first, section), getattr(second, section)
        for name in ours:
            if name in theirs and _form(ours[name]) != _form(theirs[name]):
                found.append(f"{section}.{name}")
    return tuple(found)


def _form(part: object) -> tuple[object, ...]:
    return tuple(getattr(part, key, None) for key in ("between", "on", "law"))


def _value(design: Design, asked: MeasureOfPart) -> float | None:
    motion = design.motion
    if motion is None or asked not in measures_of(design):
        return None
    return motion.measure(asked.measure, asked.part)
