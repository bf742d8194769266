"""By how much the measures of the motion change with each number: central differences of exact orbits."""

import math
from collections.abc import Iterator, Mapping
from dataclasses import dataclass
from itertools import takewhile

import numpy as np

from trimmer.deadline import NEVER, Deadline
from trimmer.design.analysis.found_motion import FoundMotion
from trimmer.design.specification.targets import Measure, is_stepped
from trimmer.design.trials.trial import MeasureOfPart, TrialWork, all_measures, measured
from trimmer.errors import TrimmerError
from trimmer.mechanism.kinds import numbers_of_part
from trimmer.mechanism.mechanism import Mechanism
from trimmer.mechanism.place_text import parse_place, place_text
from trimmer.mechanism.quantities import PARTS, Range
from trimmer.response.exact_orbit import exact_orbit

STEP = 1e-3  # Change of a number, relative
AGREES = 0.1  # Share by which the difference over half of the step may differ from that over the whole
NOTHING = 1e-3  # Elasticity below which a number has no influence
LEFT_OUT = ("phase", "offset", "order")


@dataclass(frozen=True)
class Elasticity:
    """By how many per cent a measure changes for one per cent of a number.

    Attributes:
        asked: The measure.
        value: The elasticity.
        smooth: Whether half of the step gives the same; otherwise an impact or a phase of stick comes or goes
            nearby, and the value says little.
    """

    asked: MeasureOfPart
    value: float
    smooth: bool


@dataclass(frozen=True)
class Sensitivity:
    """By how much each measure changes with one number.

    Attributes:
        place: Its dotted place.
        unit: SI unit.
        value: The number.
        elasticities: Of each measure that is not zero.
    """

    place: str
    unit: str
    value: float
    elasticities: tuple[Elasticity, ...]

    def of(self, asked: MeasureOfPart) -> Elasticity | None:
        """Return the elasticity of a measure; None if the measure is zero."""
        return next((each for each in self.elasticities if each.asked == asked), None)


@dataclass(frozen=True)
class Sensitivities:
    """By how much each measure changes with each number.

    Attributes:
        step: Relative change of a number to either side.
        entries: Those that were found.
        failed: Places at which no orbit was found beside the one of the working point.
        left_out: Those that were not tried, as the time was over.
    """

    step: float
    entries: tuple[Sensitivity, ...]
    failed: tuple[str, ...]
    left_out: tuple[str, ...] = ()

    def ranked(self, asked: MeasureOfPart) -> tuple[Sensitivity, ...]:
        """Return the numbers with an influence on a measure, the largest first."""
        sizes = {each.place: _size(each.of(asked)) for each in self.entries}
        found = [each for each in self.entries if sizes[each.place] > NOTHING]
        return tuple(sorted(found, key=lambda each: -sizes[each.place]))


def _size(elasticity: Elasticity | None) -> float:
    return 0.0 if elasticity is None else abs(elasticity.value)


def sensitivities(
    mechanism: Mechanism, motion: FoundMotion, deadline: Deadline = NEVER, *, stepped: bool = False
) -> Sensitivities:
    """Change each number a little to either side, and solve for the exact orbit again."""
    every = all_measures(mechanism, switched=motion.switched is not None, stepped=stepped)
    asked = tuple(each for each in every if each.measure is not Measure.PERIOD)
    found, failed = [], []
    numbers = list(designable(mechanism, stepped=stepped))
    for place, unit, value in takewhile(lambda _: not deadline.passed, numbers):
        wide = _slopes(mechanism, place, value, motion, asked, STEP)
        narrow = _slopes(mechanism, place, value, motion, asked, STEP / 2)
        if wide is None or narrow is None:
            failed.append(place)
            continue
        entries = tuple(
            Elasticity(each, narrow[each], _agree(wide[each], narrow[each]))
            for each in narrow
            if each in wide
        )
        found.append(Sensitivity(place, unit, value, entries))
    tried = len(found) + len(failed)
    return Sensitivities(STEP, tuple(found), tuple(failed), tuple(place for place, *_ in numbers[tried:]))


def designable(mechanism: Mechanism, *, stepped: bool = False) -> Iterator[tuple[str, str, float]]:
    """Return place, SI unit and value of each number that a designer may change, as far as it is not zero.

    What an axis moves is given: of one that is ``stepped`` they are those of controllers, gaps and frictions.
    """
    for each in _every(mechanism):
        words = parse_place(each[0])  # one alone of the frequency
        if not stepped or words[0] in ("controllers", "frictions") or words[-1] == "gap":
            yield each


def _every(mechanism: Mechanism) -> Iterator[tuple[str, str, float]]:
    if mechanism.frequency is not None:
        yield "frequency", "Hz", mechanism.frequency
    for section in PARTS:
        for name, part in getattr(mechanism, section).items():
            for key, quantity in numbers_of_part(mechanism.kinds, section, name, part).items():
                value = getattr(part, key)
                if value and key not in LEFT_OUT and quantity.range is not Range.WHOLE:
                    yield place_text((section, name, key)), quantity.unit, value
    yield from _controls(mechanism)
    for name, point in mechanism.points.items():
        for of, weight in point.weights.items():
            place = place_text(("points", name, of))
            if weight and (abs(weight) != 1.0 or mechanism.places[place] == "m"):
                yield place, mechanism.places[place], weight


CONTROLS = ("kp", "kv", "ki", "kd", "ti", "filter_time", "limit", "tracking", "sample", "delay")
"""Numbers of controllers that a designer may change, the gains first."""


def _controls(mechanism: Mechanism) -> Iterator[tuple[str, str, float]]:
    for name, controller in mechanism.controllers.items():
        for key in CONTROLS:
            value = getattr(controller, key, None)
            if value and math.isfinite(value):
                place = place_text(("controllers", name, key))
                yield place, mechanism.places[place], value


def _agree(one: float, other: float) -> bool:
    return abs(one - other) <= AGREES * max(abs(one), abs(other)) + NOTHING


def _slopes(
    mechanism: Mechanism,
    place: str,
    value: float,
    motion: FoundMotion,
    asked: tuple[MeasureOfPart, ...],
    step: float,
) -> Mapping[MeasureOfPart, float] | None:
    """Return the elasticities by central differences; None if one of the orbits is not found."""
    sides = [_measures(mechanism, place, value * (1 + sign * step), motion, asked) for sign in (-1, 1)]
    below, above = sides
    if below is None or above is None:
        return None
    there = [each for each in asked if each in below and each in above]
    middle = {each: 0.5 * (below[each] + above[each]) for each in there}
    return {each: (above[each] - below[each]) / (2 * step * middle[each]) for each in there if middle[each]}


def _measures(
    mechanism: Mechanism, place: str, value: float, motion: FoundMotion, asked: tuple[MeasureOfPart, ...]
) -> Mapping[MeasureOfPart, float] | None:
    if motion.switched is not None or is_stepped(each.measure for each in asked):
        trial = TrialWork(mechanism, (place,), asked, 0)((value,))
        return {each: size for each, size in trial.measures if math.isfinite(size)}
    try:
        changed = mechanism.with_value(place, value)
        orbit = exact_orbit(changed, motion.period_count or 1, motion.state)
    except (TrimmerError, ArithmeticError, np.linalg.LinAlgError):
        return None
    return None if not orbit.success else {a: measured(orbit.measures, a, orbit.period_count) for a in asked}
