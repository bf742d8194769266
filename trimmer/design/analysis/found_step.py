"""How controllers follow their steps, as a designer asks."""

from collections.abc import Callable, Mapping
from dataclasses import dataclass, replace
from functools import partial

from trimmer.contact.readouts.control_readouts import control_signal
from trimmer.design.analysis.motion_signals import MotionSignals, signals_of
from trimmer.design.specification.targets import Measure, followers
from trimmer.errors import UnsupportedMotionError
from trimmer.mechanism import Mechanism
from trimmer.motion.signals import along
from trimmer.motion.step_measures import Step, StepMeasures
from trimmer.response import MotionKind, Response, StepResponse, step_response
from trimmer.response.by_itself.self_excited import STRETCHES
from trimmer.response.respond import respond

ROUNDING = 1e-9  # Share of the step below which a final error is rounding, or what is left of the way to rest


@dataclass(frozen=True, eq=False)
class FoundStep:
    """How a controller follows a step.

    Attributes:
        reference, output: Names of the step, and of what the controller measures.
        step: The step.
        measures: How the output follows.
        hunting: Amplitude of what the output does at last, in its unit; 0 at rest.
        period: Of the hunting, s; None where nothing repeats, or all rests.
        ends: Where the motion ends, in words.
        signals: Reference, output and control over time.
    """

    reference: str
    output: str
    step: Step
    measures: StepMeasures
    hunting: float
    period: float | None
    ends: str
    signals: MotionSignals

    def value(self, measure: Measure) -> float:
        """Return a measure, SI unit; infinite for a time that does not come."""
        return _value(self.step, self.measures, self.hunting, measure)


def _value(step: Step, measures: StepMeasures, hunting: float, measure: Measure) -> float:
    if measure is Measure.HUNTING:
        return hunting
    found = getattr(measures, measure.key)
    if measure is Measure.FINAL_ERROR and abs(found) <= ROUNDING * abs(step.size):
        return 0.0
    return float("inf") if found is None else abs(float(found))


def step_responses(mechanism: Mechanism, settles_to: Response) -> Mapping[str, StepResponse]:
    """Return how each controller follows its step, by name, from what the mechanism settles to."""
    pairs = [(name, mechanism.controllers[name].reference or "") for name in followers(mechanism)]
    return {
        name: step_response(mechanism, reference, controller=name, settles_to=settles_to)
        for name, reference in pairs
    }


def found_step(response: StepResponse) -> FoundStep:
    """Return what a designer asks of a step."""
    hunting = response.hunting
    return FoundStep(
        response.reference,
        response.output,
        response.step,
        response.measures,
        0.0 if hunting is None else hunting.amplitude,
        None if hunting is None else hunting.period,
        response.ending,
        _signals(response),
    )


def _signals(response: StepResponse) -> MotionSignals:
    """Return reference, output and control, with contact and stick, until little moves any more."""
    flow, course, step = response.motion.flow, response.motion.course, response.step
    whole = signals_of(flow, course, response.shown_until / course.duration)
    control = along(course, control_signal(flow.modes, response.controller), *course.at(whole.times))
    unit, force = response.units
    return replace(
        whole,
        outputs={
            response.reference: step.reference(whole.times),
            response.output: whole.outputs[response.output],
        },
        forces={response.controller: control},
        units={response.reference: unit, response.output: unit},
        force_units={response.controller: force},
    )


def steps_tried(mechanism: Mechanism) -> tuple[MotionKind, Mapping[str, Callable[[Measure], float]]]:
    """Return what a mechanism settles to, and of each controller that follows a step what gives its measures.

    Raises:
        UnsupportedMotionError: if the motion through a step cannot be followed.
    """
    settles_to = respond(mechanism, most_periods=sum(STRETCHES))
    found: dict[str, Callable[[Measure], float]] = {}
    for name, response in step_responses(mechanism, settles_to).items():
        if not response.motion.success:
            raise UnsupportedMotionError(
                f"the motion could not be followed: {response.motion.course.ending.value}"
            )
        hunting = 0.0 if response.hunting is None else response.hunting.amplitude
        found[name] = partial(_value, response.step, response.measures, hunting)
    return settles_to.kind, found
