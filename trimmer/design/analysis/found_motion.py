"""A motion of the mechanism as it was found, with all that a designer asks of it."""

from collections.abc import Mapping
from dataclasses import dataclass, field, replace

import numpy as np

from trimmer.arrays import Complexes, Reals
from trimmer.design.analysis.found_step import FoundStep, found_step
from trimmer.design.analysis.hand_arm import HandArm, hand_arm_of_orbit, hand_arm_of_samples
from trimmer.design.analysis.motion_signals import MotionSignals, signals_of
from trimmer.design.specification.targets import Measure, Target
from trimmer.hybrid.stretch import Ending
from trimmer.mechanism.mechanism import Mechanism
from trimmer.motion.course import Course
from trimmer.motion.flow import Flow
from trimmer.motion.measures import Measures, OutputMeasures
from trimmer.motion.part_measures import ContactMeasures, FrictionMeasures
from trimmer.response.periodic.orbit import Orbit
from trimmer.response.periodic.pace import DRIVE_PERIOD, period_word
from trimmer.response.results.response import MotionKind, SettledMotion
from trimmer.response.simulation.closings import Closing
from trimmer.response.simulation.switching import switching
from trimmer.response.statistics.estimate import Estimate
from trimmer.response.step.step import StepResponse

WINDOW = 96  # Drive periods over which a motion is measured that does not repeat
SAMPLES = 256  # Samples per drive period of the acceleration of such a motion
ROUNDING = 1e-9  # Share of the largest displacement below which an advance is rounding
SEEN = 1.15
"""Up to which multiple of the time of its last event the motion of a machine that switches is kept."""
SHOWN = 6  # Of these, how many are kept as signals


@dataclass(frozen=True)
class Switched:
    """What a machine that switches does from its start on.

    Attributes:
        closings: How its contacts close, by name.
        last: Time of its last event, or of the end of its last profile, s.
        forces: Of each part where it rests, N, positive where it pulls its ends together; empty if it does
            not come to rest.
        positions: Of each body there, m.
    """

    closings: Mapping[str, Closing]
    last: float
    forces: Mapping[str, float]
    positions: Mapping[str, float]


@dataclass(frozen=True, eq=False)
class FoundMotion:
    """A motion and its measures.

    Attributes:
        kind: What it is.
        period_count: Drive periods after which it repeats; None if it does not, 1 without a drive.
        period: Time after which it repeats, s; None if it does not.
        starts: How many of the starts settle to it; 0 if only a neighbour led there.
        mirrored: Whether it is the mirror image of another one.
        drive_periods: Drive periods that were followed until this was known.
        neighbour_agrees: Whether a neighbouring start was found to do the same; None if none was tried.
        lyapunov: Growth of small distances per drive period, as a logarithm; None where not measured.
        multipliers: Floquet multipliers of an orbit, (n,); empty otherwise.
        neutral: Whether some disturbance stays as it is.
        state: State at the start of the period, (n,).
        measured_periods: Drive periods over which it was measured.
        outputs, rms_acceleration, contacts, frictions: Its measures, by name.
        hand_arm: Vibration of each body that does not turn, as a hand would feel it.
        events: Events per drive period.
        signals: Over a period, or over some drive periods.
        driven: Whether a drive, or the clock of a controller, gives the period.
        switched: Where it is that of a machine that switches, from its start on; else None.
        period_word: What is counted: drive periods, or the samples that alone drive.
        steps: How each controller follows its step, by name.
    """

    kind: MotionKind
    period_count: int | None
    period: float | None
    starts: int
    mirrored: bool
    drive_periods: int
    neighbour_agrees: bool | None
    lyapunov: Estimate | None
    multipliers: Complexes
    neutral: bool
    state: Reals
    measured_periods: int
    outputs: Mapping[str, OutputMeasures]
    rms_acceleration: Mapping[str, float]
    contacts: Mapping[str, ContactMeasures]
    frictions: Mapping[str, FrictionMeasures]
    hand_arm: Mapping[str, HandArm]
    events: float
    signals: MotionSignals
    driven: bool = True
    period_word: str = DRIVE_PERIOD
    switched: Switched | None = None
    steps: Mapping[str, FoundStep] = field(default_factory=dict)

    @property
    def repeats(self) -> bool:
        """Whether it is periodic."""
        return self.kind is MotionKind.PERIODIC

    @property
    def advances(self) -> Mapping[str, float]:
        """Shift of each output over the period, m, of those for which it is more than rounding."""
        units = self.signals.units
        moving = {name: each for name, each in self.outputs.items() if units.get(name, "m") in ("m", "rad")}
        largest = max((abs(each.advance) + each.peak_to_peak for each in moving.values()), default=0.0)
        found = {name: each.advance for name, each in moving.items()}
        return {name: each for name, each in found.items() if abs(each) > ROUNDING * largest}

    def measure(self, measure: Measure, part: str) -> float:
        """Return a measure, SI unit; infinite for the period of what does not repeat."""
        match measure:
            case Measure.STROKE:
                return self.outputs[part].peak_to_peak
            case Measure.RMS_ACCELERATION:
                return self.rms_acceleration[part]
            case Measure.IMPACT_SPEED:
                return self.contacts[part].impact_speed if part in self.contacts else 0.0
            case Measure.WEAR_POWER:
                return self.frictions[part].power if part in self.frictions else 0.0
            case Measure.CLOSING_TIME | Measure.BOUNCE_TIME:
                closing = self.switched.closings.get(part) if self.switched else None
                return float("inf") if closing is None else float(getattr(closing, measure.key))
            case Measure.PERIOD:
                return float(self.period_count) if self.period_count else float("inf")
            case _:
                return self.steps[part].value(measure)

    def body_felt(self, held: str | None, targets: tuple[Target, ...]) -> str | None:
        """Return the body whose acceleration is shown: the held one, a bounded one, or that shaken most."""
        bounded = [each.part for each in targets if each.measure is Measure.RMS_ACCELERATION]
        wanted = [name for name in bounded if name in self.hand_arm] or self.hand_arm
        return held or max(wanted, key=lambda name: self.rms_acceleration[name], default=None)

    def value(self, target: Target) -> float:
        """Return what a target bounds, in its unit."""
        return self.measure(target.measure, target.part)

    def meets(self, targets: tuple[Target, ...]) -> bool:
        """Say whether it meets all targets."""
        return all(target.met_by(self.value(target)) for target in targets)


def of_settled(settled: SettledMotion, *, felt: bool = True) -> FoundMotion | None:
    """Return what a start settles to; None if it could not be followed to anything that can be measured.

    What a hand feels is left out where nothing is ``felt``.
    """
    if settled.orbit is not None:
        return of_orbit(settled.orbit, settled, felt=felt)
    if settled.rest is not None:
        return _made(settled.rest.flow, settled.rest.course, settled, None, 1, felt=felt)
    if settled.window is None or not settled.window.flow.period:
        return None
    flow = settled.window.flow
    course = flow.course(settled.window.end, WINDOW)
    if course.ending is not Ending.REACHED_END:
        return None
    flow, course = flow.travelling(course)
    return _made(flow, course, settled, None, WINDOW, felt=felt)


def of_steps(responses: Mapping[str, StepResponse], settled: SettledMotion) -> FoundMotion | None:
    """Return what controllers settle to that follow steps, with how they do; None if that grows.

    Of what neither rests nor repeats it is what it does for half as long again after the last step.
    """
    motion = of_settled(settled, felt=False)
    if motion is None and settled.kind is not MotionKind.DIVERGING:
        last = list(responses.values())[-1].motion
        course = last.flow.timed(last.course.end, 0.5 * last.duration)
        motion = _made(last.flow, course, settled, None, 1, felt=False) if last.success else None
    steps = {name: found_step(each) for name, each in responses.items()}
    return None if motion is None else replace(motion, steps=steps)


def of_switching(mechanism: Mechanism) -> FoundMotion:
    """Return what a machine does from its start until it rests."""
    found = switching(mechanism)
    flow, course, rest = found.motion.flow, found.motion.course, found.rest
    share = min(1.0, SEEN * found.last / course.duration) or 1.0
    motion = _made(flow, course, None, None, 1, share)
    return replace(
        motion,
        kind=MotionKind.UNDECIDED if rest is None else MotionKind.REST,
        starts=1,
        rms_acceleration={},
        hand_arm={},
        switched=Switched(
            found.closings,
            found.last,
            {} if rest is None else dict(rest.forces),
            {} if rest is None else dict(rest.positions),
        ),
    )


def of_orbit(orbit: Orbit, settled: SettledMotion | None = None, *, felt: bool = True) -> FoundMotion:
    """Return an orbit with its measures; without starts, if no settled motion is given with it."""
    return _made(orbit.flow, orbit.course, settled, orbit, orbit.periods or 1, felt=felt)


def _made(
    flow: Flow,
    course: Course,
    settled: SettledMotion | None,
    orbit: Orbit | None,
    periods: int,
    share: float | None = None,
    *,
    felt: bool = True,
) -> FoundMotion:
    measures = Measures(course, flow, max(orbit.period_count, 1) if orbit else 1, periods)
    along_a_line = {name for name in flow.accelerations if flow.units_of_body(name).length == "m"}
    every = _hand_arm(course, orbit, measures.rms_acceleration, periods) if felt and along_a_line else {}
    return FoundMotion(
        kind=settled.kind if settled else MotionKind.PERIODIC,
        period_count=orbit.period_count if orbit else None,
        period=orbit.period if orbit else None,
        starts=settled.starts if settled else 0,
        mirrored=bool(settled and settled.mirrored),
        drive_periods=settled.drive_periods if settled else 0,
        neighbour_agrees=settled.neighbour_agrees if settled else None,
        lyapunov=settled.lyapunov if settled else None,
        multipliers=orbit.nontrivial_multipliers if orbit else np.empty(0, dtype=complex),
        neutral=bool(orbit and orbit.neutral) or bool(settled and settled.rest and settled.rest.family),
        state=course.begin.state,
        measured_periods=periods,
        outputs=dict(measures.outputs),
        rms_acceleration=dict(measures.rms_acceleration),
        contacts=dict(measures.contacts),
        frictions=dict(measures.frictions),
        hand_arm={name: each for name, each in every.items() if name in along_a_line},
        events=measures.events_per_period,
        signals=signals_of(flow, course, share or min(1.0, SHOWN / periods)),
        driven=bool(flow.period),
        period_word=period_word(flow.subject),
    )


def _hand_arm(
    course: Course, orbit: Orbit | None, rms: Mapping[str, float], periods: int
) -> Mapping[str, HandArm]:
    if orbit is not None:
        return hand_arm_of_orbit(course, 2 * np.pi / course.duration, rms)
    return hand_arm_of_samples(course, rms, SAMPLES * periods / course.duration)
