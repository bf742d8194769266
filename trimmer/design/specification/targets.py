"""What a designer wants of a mechanism: the table ``[targets]`` of its file."""

import math
from collections.abc import Iterable, Iterator, Mapping
from dataclasses import dataclass
from enum import Enum
from typing import Any

from trimmer.mechanism import Mechanism, OutputKind, StepReference
from trimmer.mechanism.coordinates import shaken_ends
from trimmer.mechanism.problems import Problem
from trimmer.mechanism.quantities import NumberField, Range
from trimmer.mechanism.units import UnitError, quantity
from trimmer.messages import listed, near_match, near_or_all, there_is


class Measure(Enum):
    """What is measured of a motion. The value is its key in tables and its unit, that of translations."""

    STROKE = "peak_to_peak", "m"
    RMS_ACCELERATION = "rms_acceleration", "m/s²"
    IMPACT_SPEED = "impact_speed", "m/s"
    PERIOD = "period", "drive periods"
    WEAR_POWER = "wear_power", "W"
    CLOSING_TIME = "closing_time", "s"
    BOUNCE_TIME = "bounce_time", "s"
    RISE_TIME = "rise_time", "s"
    OVERSHOOT = "overshoot", "%"
    SETTLING_TIME = "settling_time", "s"
    FINAL_ERROR = "final_error", "m"
    LARGEST_CONTROL = "largest_control", "N"
    HUNTING = "hunting", "m"

    @property
    def key(self) -> str:
        """What it is called in tables."""
        return self.value[0]

    @property
    def unit(self) -> str:
        """Its SI unit, of displacements and translations."""
        return self.value[1]


@dataclass(frozen=True)
class Target:
    """A bound on a measure.

    Attributes:
        key: The key in ``[targets]``.
        measure: What is bounded.
        part: The output, body, contact or controller; empty for the period of the motion.
        bound: In SI units: the least, or the most that will do.
        unit: The unit; empty for that of the measure.
    """

    key: str
    measure: Measure
    part: str
    bound: float
    unit: str = ""

    @property
    def at_least(self) -> bool:
        """Whether the bound is the smallest value that will do."""
        return self.measure is Measure.STROKE and self.key != PEAK_TO_PEAK_AT_MOST

    def margin(self, value: float) -> float:
        """Return how far a value is beyond the bound, as a share of it, from -1 to 1; below 0 if missed.

        A period is met or not; so is a bound of zero.
        """
        if self.measure is Measure.PERIOD or not self.bound or not math.isfinite(value):
            return 1.0 if self.met_by(value) else -1.0
        share = value / self.bound - 1
        return min(max(share if self.at_least else -share, -1.0), 1.0)

    def met_by(self, value: float) -> bool:
        """Say whether a value will do; one that is no number will not."""
        return value >= self.bound if self.at_least else value <= self.bound


PEAK_TO_PEAK_AT_MOST = "peak_to_peak_at_most"
BOUNDS: Mapping[str, Measure] = {
    "stroke_at_least": Measure.STROKE,
    PEAK_TO_PEAK_AT_MOST: Measure.STROKE,
    "rms_acceleration_at_most": Measure.RMS_ACCELERATION,
    "impact_speed_at_most": Measure.IMPACT_SPEED,
    "closing_time_at_most": Measure.CLOSING_TIME,
    "bounce_time_at_most": Measure.BOUNCE_TIME,
    "rise_time_at_most": Measure.RISE_TIME,
    "overshoot_at_most": Measure.OVERSHOOT,
    "settling_time_at_most": Measure.SETTLING_TIME,
    "final_error_at_most": Measure.FINAL_ERROR,
    "control_at_most": Measure.LARGEST_CONTROL,
    "hunting_at_most": Measure.HUNTING,
}
"""What each key bounds."""
OF_CLOSING = (Measure.CLOSING_TIME, Measure.BOUNCE_TIME)
"""What is measured of a machine that switches, from its start until it rests."""
OF_STEP = (
    *(Measure.RISE_TIME, Measure.OVERSHOOT, Measure.SETTLING_TIME),
    *(Measure.FINAL_ERROR, Measure.LARGEST_CONTROL, Measure.HUNTING),
)
"""What is measured of a controller that follows a step."""
OF_REPEATING = (Measure.RMS_ACCELERATION, Measure.PERIOD, Measure.WEAR_POWER)
"""What is measured of a motion that repeats alone: of one that ends it depends on how long is looked."""
_EXAMPLES = {
    **{"s": "5 ms", "%": "5 %", "m": "2.5 mm", "m/s": "0.2 m/s", "m/s²": "90 m/s²", "N": "20 N"},
    **{"rad": "2 deg", "rad/s": "0.5 rad/s", "rad/s²": "900 rad/s^2", "N m": "20 mN m"},
}
ONLY_DRIVE_PERIOD = "only_drive_period"
KEYS = (*BOUNDS, ONLY_DRIVE_PERIOD)


def targets_of(
    content: Mapping[str, Any], mechanism: Mechanism, problems: list[Problem]
) -> tuple[Target, ...]:
    """Read the targets of a file; what cannot be used is added to the problems."""
    if not isinstance(content, dict):
        problems.append(Problem(("targets",), "is a section: write [targets] on a line of its own", content))
        return ()
    found: list[Target] = []
    for key, value in content.items():
        if key in BOUNDS:
            found += _bounds(key, value, mechanism, problems)
        elif key == ONLY_DRIVE_PERIOD:
            found += _of_period(value, mechanism, problems)
        else:
            advice = near_match(key, KEYS) or f"[targets] may hold {listed(KEYS)}"
            problems.append(Problem(("targets", key), f"unknown key; {advice}"))
    others = dict.fromkeys(each.key for each in found if each.measure not in OF_STEP)
    if any(each.measure in OF_STEP for each in found):
        problems += [Problem(("targets", key), _BESIDE_A_STEP) for key in others]
    return tuple(found)


def unit_of_measure(mechanism: Mechanism, measure: Measure, part: str) -> str:
    """Return the SI unit of a measure of a part of a mechanism."""
    match measure:
        case Measure.STROKE:
            return mechanism.output_units[part]
        case Measure.RMS_ACCELERATION:
            return mechanism.kinds[part].unit(measure.unit)
        case Measure.IMPACT_SPEED:
            section = next(each for each in ("plays", "stops", "walls") if part in getattr(mechanism, each))
            return mechanism.kind_of(section, part).unit(measure.unit)
        case Measure.FINAL_ERROR | Measure.HUNTING:
            return mechanism.output_units[mechanism.controllers[part].measure]
        case Measure.LARGEST_CONTROL:
            return mechanism.kind_of("controllers", part).unit(measure.unit)
        case _:
            return measure.unit


def _of_period(value: object, mechanism: Mechanism, problems: list[Problem]) -> Iterator[Target]:
    place = ("targets", ONLY_DRIVE_PERIOD)
    if not isinstance(value, bool):
        problems.append(Problem(place, "write true or false", value))
    elif value and mechanism.frequency is None:
        problems.append(Problem(place, "the mechanism has no drive, so there is no period to keep", value))
    elif value and has_profile(mechanism):
        problems.append(Problem(place, _SWITCHES, value))
    elif value:
        yield Target(ONLY_DRIVE_PERIOD, Measure.PERIOD, "", 1.0)


def _bounds(key: str, value: object, mechanism: Mechanism, problems: list[Problem]) -> Iterator[Target]:
    measure = BOUNDS[key]
    parts, noun = _parts(measure, mechanism), _NAMES.get(measure, "play, stop or wall")
    if measure in OF_STEP:
        noun = "controller that follows a step"
        if not parts:
            problems.append(Problem(("targets", key), _NO_STEP))
            return
    if measure in (*OF_REPEATING, *OF_STEP) and has_profile(mechanism):
        problems.append(Problem(("targets", key), _SWITCHES))
        return
    if measure in OF_CLOSING and mechanism.frequency is not None and not has_profile(mechanism):
        problems.append(Problem(("targets", key), _REPEATS))
        return
    if not parts:
        reason = f"the mechanism has no {noun} that this could bound; leave the line out"
        problems.append(Problem(("targets", key), reason))
        return
    given = value if isinstance(value, dict) else dict.fromkeys(_meant(measure, parts, mechanism), value)
    if not given and not isinstance(value, dict):
        reason = f"no output is a displacement, so say which one this bounds; {there_is(parts)}"
        problems.append(Problem(("targets", key), reason, value))
    for part, bound in given.items():
        place = ("targets", key, part) if isinstance(value, dict) else ("targets", key)
        if part not in parts:
            reason = f"there is no {noun} {part!r}; {near_or_all(part, parts)}"
            problems.append(Problem(place, reason, bound))
            continue
        unit = unit_of_measure(mechanism, measure, part)
        wanted = NumberField(unit, _EXAMPLES[unit], Range.NOT_NEGATIVE)
        if (number := _number(place, bound, wanted, problems)) is not None:
            yield Target(key, measure, part, number, unit)


_NAMES = {Measure.STROKE: "output", Measure.RMS_ACCELERATION: "body"}
_SWITCHES = (
    "a force follows a profile, with which nothing repeats; of a machine that switches, bound "
    "closing_time_at_most, bounce_time_at_most, impact_speed_at_most, stroke_at_least or peak_to_peak_at_most"
)
_REPEATS = (
    "the machine is driven and its contacts close again and again; this is for one that switches: give a "
    "force a profile, or leave frequency out"
)


_NO_STEP = (
    "no controller follows a step, so that there is none to measure; give one a reference, with "
    "path = { step = 0.01 } below [references]"
)
_BESIDE_A_STEP = (
    "is of what the machine settles to, while other targets are of a step; judge the two in a file each"
)


def is_stepped(measures: Iterable[Measure]) -> bool:
    """Say whether what is measured is taken from the start through a step of a reference."""
    return any(each in OF_STEP for each in measures)


def followers(mechanism: Mechanism) -> tuple[str, ...]:
    """Return the names of the controllers that follow a step, which is not 0."""
    references = mechanism.references.items()
    steps = {name for name, each in references if isinstance(each, StepReference) and each.step}
    return tuple(name for name, each in mechanism.controllers.items() if each.reference in steps)


def is_switched(mechanism: Mechanism, measures: Iterable[Measure]) -> bool:
    """Say whether what is measured is taken from the start until all rests, and not once it has settled."""
    return has_profile(mechanism) or any(each in OF_CLOSING for each in measures)


def has_profile(mechanism: Mechanism) -> bool:
    """Say whether a force switches over time, so that nothing repeats."""
    return any(force.profile for force in mechanism.forces.values())


def _meant(measure: Measure, parts: tuple[str, ...], mechanism: Mechanism) -> tuple[str, ...]:
    """Return the parts that a bound without names is for: of outputs those that are displacements."""
    if measure is not Measure.STROKE:
        return parts
    return tuple(each for each in parts if mechanism.outputs[each].kind is OutputKind.DISPLACEMENT)


def _parts(measure: Measure, mechanism: Mechanism) -> tuple[str, ...]:
    match measure:
        case Measure.STROKE:
            return tuple(mechanism.outputs)
        case Measure.RMS_ACCELERATION:
            return shaken_ends(mechanism)
        case _ if measure in OF_STEP:
            return followers(mechanism)
        case _:
            return (*mechanism.plays, *mechanism.stops, *mechanism.walls)


def _number(
    place: tuple[str, ...], value: object, wanted: NumberField, problems: list[Problem]
) -> float | None:
    number = value
    if isinstance(value, str):
        try:
            percent = wanted.unit == "%"
            number = quantity(value.replace("%", "") if percent else value, "1" if percent else wanted.unit)
        except UnitError as error:
            problems.append(Problem(place, f'{error}; "{wanted.example}" would do', value))
            return None
    if reason := wanted.reason_against(number):
        problems.append(Problem(place, reason, value))
        return None
    return wanted.taken(number)
