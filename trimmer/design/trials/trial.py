"""What a mechanism or a loop with some other numbers does, cheaply enough for hundreds of trials."""

import math
from dataclasses import dataclass, replace

import numpy as np

from trimmer.design.analysis.found_step import steps_tried
from trimmer.design.specification.targets import (
    OF_CLOSING,
    OF_REPEATING,
    OF_STEP,
    Measure,
    Target,
    followers,
    has_profile,
    is_stepped,
    is_switched,
    unit_of_measure,
)
from trimmer.errors import TrimmerError
from trimmer.hybrid.stretch import Ending
from trimmer.maps.by_itself import came_to, came_to_in_loop
from trimmer.maps.inputs import varied
from trimmer.maps.settle import Settled, settle
from trimmer.mechanism.coordinates import shaken_ends
from trimmer.mechanism.mechanism import Mechanism
from trimmer.motion.extremes import extremes
from trimmer.motion.flow import Flow
from trimmer.motion.measures import Measures
from trimmer.motion.subject import Subject
from trimmer.response.flows import flow_of, is_silent
from trimmer.response.periodic.pace import pace_of
from trimmer.response.results.response import MotionKind
from trimmer.response.simulation.switching import Switching, switching
from trimmer.response.without_events.rest import stands

_SECTIONS = {
    Measure.STROKE: "outputs",
    Measure.RMS_ACCELERATION: "bodies",
    Measure.IMPACT_SPEED: "contacts",
    Measure.WEAR_POWER: "frictions",
    Measure.CLOSING_TIME: "closings",
    Measure.BOUNCE_TIME: "closings",
    **dict.fromkeys(OF_STEP, "controllers"),
}
WINDOW = 20  # Drive periods over which a motion is measured that does not repeat


@dataclass(frozen=True)
class MeasureOfPart:
    """A measure of a part.

    Attributes:
        measure: What is measured.
        part: The output, body, contact, friction or controller; empty for the period.
    """

    measure: Measure
    part: str

    @property
    def column(self) -> str:
        """What heads it in a table, as in that of a map."""
        return f"{_SECTIONS[self.measure]}.{self.part}.{self.measure.key}"

    def unit(self, flow: Flow) -> str:
        """Return its unit for what moves; empty for a number."""
        if isinstance(flow.subject, Mechanism):
            return unit_of_measure(flow.subject, self.measure, self.part)
        units = flow.units
        match self.measure:
            case Measure.STROKE:
                return units.length
            case Measure.IMPACT_SPEED:
                return units.speed
            case Measure.WEAR_POWER:
                return units.power
            case _:
                return self.measure.unit


@dataclass(frozen=True)
class Trial:
    """What a mechanism or a loop does from rest, or from its own start.

    Attributes:
        values: Of the places that were set, SI units.
        kind: What the motion is; None where it failed.
        period_count: Drive periods after which it repeats; None if it does not.
        measures: By what was asked; not a number where the motion failed.
    """

    values: tuple[float, ...]
    kind: MotionKind | None
    period_count: int | None
    measures: tuple[tuple[MeasureOfPart, float], ...]

    def value(self, measure: Measure, part: str) -> float:
        """Return a measure that was asked for."""
        return dict(self.measures)[MeasureOfPart(measure, part)]

    def meets(self, targets: tuple[Target, ...]) -> bool:
        """Say whether it meets all targets; a motion that failed or grows without bound meets none."""
        return self.kind is not MotionKind.DIVERGING and all(
            target.met_by(self.value(target.measure, target.part)) for target in targets
        )


@dataclass(frozen=True)
class TrialWork:
    """The work of a trial at some places, which a process or a cluster may do."""

    subject: Subject
    places: tuple[str, ...]
    asked: tuple[MeasureOfPart, ...]
    most_periods: int

    def __call__(self, values: tuple[float, ...]) -> Trial:
        """Return what the mechanism or loop does with these values."""
        try:
            subject = varied(self.subject, self.places, values)
            if isinstance(subject, Mechanism) and is_switched(subject, (each.measure for each in self.asked)):
                return self._switched(values, subject)
            if isinstance(subject, Mechanism) and is_stepped(each.measure for each in self.asked):
                return self._stepped(values, subject)
            flow = flow_of(subject)
            if not flow.period:
                return self._by_itself(values, flow)
            return self._measured(values, flow)
        except (TrimmerError, ArithmeticError, np.linalg.LinAlgError):
            return self._failed(values)

    def _failed(self, values: tuple[float, ...]) -> Trial:
        return Trial(values, None, None, tuple((each, float("nan")) for each in self.asked))

    def _switched(self, values: tuple[float, ...], mechanism: Mechanism) -> Trial:
        found = switching(mechanism)
        kind = MotionKind.UNDECIDED if found.rest is None else MotionKind.REST
        every = tuple((each, of_switching(found, each)) for each in self.asked)
        return Trial(values, kind, None, every)

    def _stepped(self, values: tuple[float, ...], mechanism: Mechanism) -> Trial:
        """Return how controllers follow their steps."""
        kind, found = steps_tried(mechanism)
        every = tuple((each, found[each.part](each.measure)) for each in self.asked)
        return Trial(values, kind, None, every)

    def _by_itself(self, values: tuple[float, ...], flow: Flow) -> Trial:
        """Return what goes on without a drive: over a period of its own, some returns, or at rest.

        Of a loop that rests where it begins it is the largest of its stable orbits.
        """
        silent = is_silent(flow.subject)
        found = came_to_in_loop(flow)[0] if silent else came_to(flow, flow.rest())
        if found.course is None:
            return replace(self._failed(values), kind=found.kind)
        still = found.kind is MotionKind.REST and stands(flow)
        measures = Measures(found.course, flow, 1, found.returns, still)
        count = None if found.orbit is None else 1
        every = tuple((each, measured(measures, each, count)) for each in self.asked)
        return Trial(values, found.kind, count, every)

    def _measured(self, values: tuple[float, ...], flow: Flow) -> Trial:
        settled = settle(flow, flow.rest(), self.most_periods * pace_of(flow.subject))
        measures = measures_of_settled(flow, settled)
        if measures is None:
            return self._failed(values)
        count = None if settled.orbit is None else settled.orbit.period_count
        every = tuple((each, measured(measures, each, count)) for each in self.asked)
        return Trial(values, settled.kind, count, every)


def measures_of_settled(flow: Flow, settled: Settled) -> Measures | None:
    """Return measures of an orbit, or over some drive periods of what does not repeat; None if it ends."""
    if settled.ending is not Ending.REACHED_END:
        return None
    if (orbit := settled.orbit) is not None:
        still = settled.kind is MotionKind.REST and stands(flow)
        return Measures(orbit.course, orbit.flow, orbit.period_count, orbit.periods, still)
    course = flow.course(settled.end, WINDOW)
    if course.ending is not Ending.REACHED_END:
        return None
    flow, course = flow.travelling(course)
    return Measures(course, flow, 1, WINDOW)


def of_switching(found: Switching, asked: MeasureOfPart) -> float:
    """Return a measure from start to rest; times of a contact that does not close are infinite."""
    closings, motion = found.closings, found.motion
    if asked.measure is Measure.STROKE:
        return float(np.ptp(extremes(motion.course, motion.flow.outputs[asked.part].signal)))
    never = 0.0 if asked.measure is Measure.IMPACT_SPEED else math.inf
    return getattr(closings[asked.part], asked.measure.key) if asked.part in closings else never


def measured(measures: Measures, asked: MeasureOfPart, period_count: int | None) -> float:
    """Return a measure of a motion that has settled; infinite for the period of one that does not repeat."""
    match asked.measure:
        case Measure.STROKE:
            return measures.peak_to_peak[asked.part]
        case Measure.RMS_ACCELERATION:
            return measures.rms_acceleration[asked.part]
        case Measure.IMPACT_SPEED:
            return measures.contacts[asked.part].impact_speed if asked.part in measures.contacts else 0.0
        case Measure.WEAR_POWER:
            return measures.frictions[asked.part].power if asked.part in measures.frictions else 0.0
        case Measure.PERIOD:
            return float(period_count) if period_count else float("inf")
        case _:
            raise ValueError(f"{asked.measure.key} is measured of a machine that switches")


def all_measures(
    subject: Subject, *, switched: bool = False, stepped: bool = False
) -> tuple[MeasureOfPart, ...]:
    """Return all measures that a mechanism or a loop has.

    Of one that switches they are those from start to rest, of one whose controllers follow steps those.
    """
    if not isinstance(subject, Mechanism):
        return _of_loop(flow_of(subject))
    if stepped:
        return tuple(MeasureOfPart(each, name) for name in followers(subject) for each in OF_STEP)
    if not (switched or has_profile(subject)):
        return _of_repeating(subject)
    kept = (each for each in _of_repeating(subject) if each.measure not in OF_REPEATING)
    contacts = (*subject.plays, *subject.stops, *subject.walls)
    return (*kept, *(MeasureOfPart(each, name) for name in contacts for each in OF_CLOSING))


def _of_repeating(mechanism: Mechanism) -> tuple[MeasureOfPart, ...]:
    return (
        *(MeasureOfPart(Measure.STROKE, name) for name in mechanism.outputs),
        *(MeasureOfPart(Measure.RMS_ACCELERATION, name) for name in shaken_ends(mechanism)),
        *(
            MeasureOfPart(Measure.IMPACT_SPEED, name)
            for name in (*mechanism.plays, *mechanism.stops, *mechanism.walls)
        ),
        *(
            MeasureOfPart(Measure.WEAR_POWER, name)
            for name, each in mechanism.frictions.items()
            if each.kinetic_force or each.curve
        ),
        *([MeasureOfPart(Measure.PERIOD, "")] if mechanism.frequency is not None else []),
    )


def _of_loop(flow: Flow) -> tuple[MeasureOfPart, ...]:
    return (
        *(MeasureOfPart(Measure.STROKE, name) for name in flow.outputs),
        *(MeasureOfPart(Measure.IMPACT_SPEED, part.name) for part in flow.parts if part.touches),
        *(MeasureOfPart(Measure.WEAR_POWER, name) for name in flow.rubbing),
        *([MeasureOfPart(Measure.PERIOD, "")] if flow.period else []),
    )
