"""``step_response``: how a controlled mechanism follows a step of its reference, and what it settles to."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass
from functools import cached_property

import numpy as np

from trimmer.arguments import require_instance
from trimmer.contact.control_readouts import control_signal, largest_demand
from trimmer.errors import MechanismError
from trimmer.mechanism.controls.references import StepReference
from trimmer.mechanism.mechanism import Mechanism
from trimmer.messages import listed, near_match
from trimmer.motion.extremes import extremes, turning_points
from trimmer.motion.step_measures import Step, StepMeasures, step_measures
from trimmer.response.flows import flow_of
from trimmer.response.motion import MechanismMotion
from trimmer.response.respond import respond
from trimmer.response.response import MotionKind, Response
from trimmer.response.self_excited import time_scale
from trimmer.response.simulate import simulate
from trimmer.response.solved import rest_after
from trimmer.showing.shown import Tabular
from trimmer.showing.table import Table, attributes

STRETCHES = (5, 20, 80, 320, 1280)
"""How long is followed after a step until it is seen to have settled, in periods of the slowest mode."""
STILL = 1e-12
"""Share of its largest value by which an output moves at most that has come to rest."""
SEEN = 1000
"""Instants at which it is looked at."""
SETTLED = 1e-6
"""Share of its size by which a motion may still miss the cycle that it settles to."""


@dataclass(frozen=True, eq=False, repr=False)
class StepResponse(Tabular):
    """How a controlled mechanism follows a step of its reference.

    Attributes:
        reference: Name of the reference.
        controller: Name of the controller that follows it.
        step: Its step.
        motion: The motion, from its start on.
        settles_to: What the mechanism settles to with the last value of the reference.
        cycles: Whether that is a cycle, to whose mean the error is told.
    """

    reference: str
    controller: str
    step: Step
    motion: MechanismMotion
    settles_to: Response
    cycles: bool

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
            settled_mean=self.settles_to.motion.mean.get(self.output) if self.cycles else None,
            control=control_signal(flow.modes, self.controller),
            largest_demand=largest_demand(course, self.controller),
        )

    def _told(self) -> str:
        return f"{self.output} follows {self.reference}: {self.settles_to.message}"

    def _table(self) -> Table:
        output, control = self.units
        times = attributes(rise_time="s", overshoot="%", settling_time="s", final_error=output)
        return Table(
            "Step",
            [self.measures],
            (*times, *attributes(largest_control=control, largest_demand=control)),
        )


def step_response(
    mechanism: Mechanism, reference: str, *, controller: str | None = None, duration: float | None = None
) -> StepResponse:
    """Follow a mechanism from its start through the step of a reference.

    Args:
        mechanism: The mechanism.
        reference: Name of the reference, a step.
        controller: Name of the controller whose output is measured; the only one that follows the reference
            if not given.
        duration: Length of the motion, s; until what it settles to is seen if not given.

    Raises:
        MechanismError: if there is no such step, no one controller that follows it, or the motion ends
            before it.
        WrongTypeError: if the mechanism is none.
    """
    require_instance("mechanism", mechanism, Mechanism, "a trimmer.Mechanism")
    step = _step(mechanism, reference)
    follower = _follower(mechanism, reference, controller)
    if duration is not None and duration <= step.at:
        raise MechanismError(
            f"a motion of {duration:g} s ends before {reference!r} steps; give more than {step.at:g} s"
        )
    settles_to, output = respond(mechanism), mechanism.controllers[follower].measure
    for length in _lengths(mechanism, settles_to, step.at) if duration is None else (duration,):
        motion = simulate(mechanism, length)
        if not motion.success or _has_settled(motion, settles_to, output):
            break
    # A torus is left out where a given duration may end before it.
    kinds = (MotionKind.PERIODIC, *((MotionKind.TORUS, MotionKind.CHAOTIC) if duration is None else ()))
    return StepResponse(reference, follower, step, motion, settles_to, settles_to.kind in kinds)


def _step(mechanism: Mechanism, name: str) -> Step:
    references = mechanism.references
    steps = [each for each, one in references.items() if isinstance(one, StepReference)]
    there = f"of steps there is {listed(steps)}" if steps else "[references] path = { step = 0.01 } is one"
    if name not in references:
        raise MechanismError(f"there is no reference {name!r}; {near_match(name, references) or there}")
    reference = references[name]
    if not isinstance(reference, StepReference):
        raise MechanismError(f"references.{name} is a {reference.word} and no step; {there}")
    if reference.step == 0:
        raise MechanismError(
            f"references.{name}.step is 0, so that there is nothing to follow; give its size"
        )
    return Step(reference.step, reference.at)


def _follower(mechanism: Mechanism, reference: str, name: str | None) -> str:
    """Return the name of the controller that follows a reference."""
    followers = [each for each, one in mechanism.controllers.items() if one.reference == reference]
    if not followers:
        raise MechanismError(
            f'no controller follows {reference!r}; write reference = "{reference}" into one of [controllers]'
        )
    if name is None and len(followers) > 1:
        raise MechanismError(f"{listed(followers)} follow {reference!r}; choose one (--controller)")
    if name is not None and name not in followers:
        there = near_match(name, followers) or f"{listed(followers)} does"
        raise MechanismError(f"no controller {name!r} follows {reference!r}; {there}")
    return name or followers[0]


def _lengths(mechanism: Mechanism, response: Response, at: float) -> Iterator[float]:
    """Yield how long a motion is followed, s, each time longer."""
    flow, motion = flow_of(mechanism), response.motion
    if motion.orbit is None and motion.rest is None and flow.period and motion.drive_periods:
        yield at + motion.drive_periods * flow.period
    unit = max(time_scale(flow, flow.rest()), 0.0 if motion.orbit is None else motion.orbit.period)
    yield from (at + each * unit for each in STRETCHES)


def _has_settled(motion: MechanismMotion, response: Response, output: str) -> bool:
    settled, course = response.motion, motion.course
    if settled.rest is not None:
        # What creeps to rest for ever stands still to rounding.
        late = motion.output(output, np.linspace(0.5, 1.0, SEEN) * course.duration)
        still = float(np.ptp(late)) <= STILL * abs(late).max()
        return still or rest_after(motion.flow, course) is not None
    orbit = settled.orbit
    if orbit is None:
        return True
    cycle = np.array(extremes(orbit.course, orbit.flow.outputs[output].signal))
    found = turning_points(course, motion.flow.outputs[output].signal)
    last = found.values[found.times >= course.duration - orbit.period]
    missed = abs(cycle - (last.min(), last.max())).max()
    return bool(orbit.period < course.duration and missed <= SETTLED * (cycle[1] - cycle[0]))
