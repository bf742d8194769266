"""``step_response``: how a controlled mechanism follows a step of its reference, and what it settles to."""

from dataclasses import dataclass
from functools import cached_property

from trimmer.arguments import require_instance
from trimmer.contact.flow import MechanismFlow
from trimmer.contact.readouts.control_readouts import control_signal, largest_demand
from trimmer.errors import MechanismError
from trimmer.hybrid.stretch import Ending
from trimmer.mechanism import Mechanism, StepReference
from trimmer.messages import listed, near_match
from trimmer.motion.extremes import turning_points
from trimmer.motion.step_measures import Step, StepMeasures, step_measures
from trimmer.response.respond import respond
from trimmer.response.results.response import MotionKind, Response
from trimmer.response.simulation.motion import MechanismMotion
from trimmer.response.step.step_end import StepEnd, followed
from trimmer.showing.shown import Tabular
from trimmer.showing.table import Table, attributes

SEEN = 1.5  # Share of the time until nothing moves any more that is shown of a motion that comes to rest
MOST_EVENTS = 400_000  # Events and samples of a motion of a given length: some 2 GB to look at
CLOSE = 2e-3  # Share of the step within which an output counts as still


@dataclass(frozen=True)
class Hunting:
    """What an output does that does not come to rest.

    Attributes:
        amplitude: Half of peak to peak, in the unit of the output.
        period: Of the cycle, s; None where nothing repeats.
        frequency: Of the cycle, or of its largest line where nothing repeats, Hz; None if that is not known.
    """

    amplitude: float
    period: float | None
    frequency: float | None


@dataclass(frozen=True, eq=False, repr=False)
class StepResponse(Tabular):
    """How a controlled mechanism follows a step of its reference.

    Attributes:
        reference: Name of the reference.
        controller: Name of the controller that follows it.
        step: Its step.
        motion: The motion, from its start on.
        settles_to: What the mechanism settles to with the last value of the reference.
        settled_mean: Mean of the output in what it settles to, by which the error is told; None where that is
            the error at the end.
        hunting: What the output does if it does not come to rest without a drive; None if it does.
        ending: Where the motion ends that was followed as long as it takes; empty if its length was given.
    """

    reference: str
    controller: str
    step: Step
    motion: MechanismMotion
    settles_to: Response
    settled_mean: float | None = None
    hunting: Hunting | None = None
    ending: str = ""

    @property
    def output(self) -> str:
        """Name of the output that the controller measures."""
        return self.motion.mechanism.controllers[self.controller].measure

    @property
    def units(self) -> tuple[str, str]:
        """Unit of the output, and of the control."""
        mechanism = self.motion.mechanism
        return mechanism.output_units[self.output], mechanism.kind_of("controllers", self.controller).unit(
            "N"
        )

    @cached_property
    def measures(self) -> StepMeasures:
        """How the output follows; in a cycle the final error is that of its mean."""
        flow, course = self.motion.flow, self.motion.course
        return step_measures(
            course,
            flow.outputs[self.output].signal,
            self.step,
            settled_mean=self.settled_mean,
            control=control_signal(flow.modes, self.controller),
            largest_demand=largest_demand(course, self.controller),
        )

    @cached_property
    def shown_until(self) -> float:
        """Until when a picture shows the motion, s: all of a cycle; of the way to rest until little moves."""
        course = self.motion.course
        if not self.ending or self.hunting is not None or not self.motion.success:
            return course.duration
        points = turning_points(course, self.motion.flow.outputs[self.output].signal)
        moving = abs(points.values - points.values[-1]) > CLOSE * abs(self.step.size)
        last = max((time for time, *_ in course.events), default=0.0)
        until = max(last, self.step.at, *points.times[1:][moving[:-1]].tolist())
        return min(course.duration, self.step.at + SEEN * (until - self.step.at) or course.duration)

    def _told(self) -> str:
        return f"{self.output} follows {self.reference}: {self.settles_to.message}"

    def _table(self) -> Table:
        output, control = self.units
        times = attributes(rise_time="s", overshoot="%", settling_time="s", final_error=output)
        return Table(
            "Step", [self.measures], (*times, *attributes(largest_control=control, largest_demand=control))
        )


def step_response(
    mechanism: Mechanism,
    reference: str | None = None,
    *,
    controller: str | None = None,
    duration: float | None = None,
    settles_to: Response | None = None,
) -> StepResponse:
    """Follow a mechanism from its start through the step of a reference.

    Args:
        mechanism: The mechanism.
        reference: Name of the reference, a step; the only step that the mechanism has if not given.
        controller: Name of the controller whose output is measured; the only one that follows the reference
            if not given.
        duration: Length of the motion, s; until what it settles to is seen if not given.
        settles_to: What ``respond`` has found; it is asked if not given.

    Raises:
        MechanismError: if there is no such step, no one controller that follows it, or the motion ends
            before it.
        WrongTypeError: if the mechanism is none.
    """
    require_instance("mechanism", mechanism, Mechanism, "a trimmer.Mechanism")
    reference = _only(mechanism) if reference is None else reference
    step = _step(mechanism, reference)
    follower = _follower(mechanism, reference, controller)
    if duration is not None and duration <= step.at:
        raise MechanismError(
            f"a motion of {duration:g} s ends before {reference!r} steps; give more than {step.at:g} s"
        )
    settles_to, flow = settles_to or respond(mechanism), MechanismFlow(mechanism)
    output, settled = mechanism.controllers[follower].measure, settles_to.motion
    mean, ending = None, ""
    if duration is None:
        unknown = settles_to.kind is MotionKind.UNDECIDED and settled.slowing is None
        rests = None if unknown else settled.rest is not None
        end = followed(flow, output, step.at, step.size, cycle=settled.orbit, rests=rests)
        course, ending = end.course, _ending(end, settles_to)
        known = end.rests or settled.orbit is not None
        mean = end.mean if known else settled.mean.get(output, end.mean)
        amplitude = end.amplitude
    else:
        course, amplitude = flow.timed(flow.rest(), duration, most_events=MOST_EVENTS), None
        if settles_to.kind is MotionKind.PERIODIC:
            mean = settled.mean.get(output)
    hunting = _hunting(mechanism, settles_to, output, amplitude)
    motion = MechanismMotion(flow, course)
    return StepResponse(reference, follower, step, motion, settles_to, mean, hunting, ending)


def _ending(end: StepEnd, settles_to: Response) -> str:
    """Say where a motion that was followed ends; empty where it could not be followed."""
    if end.course.ending is not Ending.REACHED_END:
        return ""
    if end.rests:
        return "where it rests"
    orbit = settles_to.motion.orbit
    if settles_to.motion.slowing is not None:
        return "while it slows down for ever"
    if orbit is None:
        return "where it hunts evenly" if end.settled else "without having settled"
    count = round(end.course.duration / orbit.period)
    told = f"{count} times the period of what it settles to after the step"
    if not end.settled:
        return f"{told}, without having settled"
    return f"{told}; it comes to the mirror image of what stands below" if end.mirrored else told


def _hunting(mechanism: Mechanism, settles_to: Response, output: str, seen: float | None) -> Hunting | None:
    """Return how an output hunts; None if it rests, slows down, grows, or is driven."""
    settled = settles_to.motion
    calm = settled.rest is not None or settled.slowing is not None
    if mechanism.frequency is not None or calm or settles_to.kind is MotionKind.DIVERGING:
        return None
    size = settled.peak_to_peak.get(output)
    amplitude = seen if size is None else 0.5 * size
    if not amplitude:
        return None
    period = None if settled.orbit is None else settled.orbit.period
    peaks = () if settled.window is None else settled.window.peaks.get(output, ())
    frequency = max(peaks, key=lambda each: each[1], default=(None, 0.0))[0]
    return Hunting(amplitude, period, 1.0 / period if period else frequency)


def _steps(mechanism: Mechanism) -> tuple[list[str], str]:
    """Return the names of all steps, and what to say of them."""
    steps = [name for name, one in mechanism.references.items() if isinstance(one, StepReference)]
    return (
        steps,
        f"of steps there is {listed(steps)}" if steps else "[references] path = { step = 0.01 } is one",
    )


def _only(mechanism: Mechanism) -> str:
    """Return the name of the only step, or of the only one that is followed."""
    named, there = _steps(mechanism)
    followed = {each.reference for each in mechanism.controllers.values()}
    steps = [each for each in named if each in followed] or named
    if not steps:
        raise MechanismError(f"nothing steps; {there}", place=("references",))
    if len(steps) > 1:
        told = f"{listed(steps)} are steps; choose one (--reference {steps[0]})"
        raise MechanismError(told, place=("references",))
    return steps[0]


def _step(mechanism: Mechanism, name: str) -> Step:
    references, there = mechanism.references, _steps(mechanism)[1]
    if name not in references:
        told = f"there is no reference {name!r}; {near_match(name, references) or there}"
        raise MechanismError(told, place=("references",))
    reference = references[name]
    if not isinstance(reference, StepReference):
        raise MechanismError(
            f"references.{name} is a {reference.word} and no step; {there}", place=("references", name)
        )
    if reference.step == 0:
        raise MechanismError(
            f"references.{name}.step is 0, so that there is nothing to follow; give its size",
            place=("references", name, "step"),
        )
    return Step(reference.step, reference.at)


def _follower(mechanism: Mechanism, reference: str, name: str | None) -> str:
    """Return the name of the controller that follows a reference."""
    followers = [each for each, one in mechanism.controllers.items() if one.reference == reference]
    if not followers:
        raise MechanismError(
            f'no controller follows {reference!r}; write reference = "{reference}" into one of [controllers]',
            place=("controllers",),
        )
    if name is None and len(followers) > 1:
        told = f"{listed(followers)} follow {reference!r}; choose one (--controller)"
        raise MechanismError(told, place=("controllers",))
    if name is not None and name not in followers:
        there = near_match(name, followers) or f"{listed(followers)} does"
        told = f"no controller {name!r} follows {reference!r}; {there}"
        raise MechanismError(told, place=("controllers",))
    return name or followers[0]
