"""The entry of exact simulation: a loop is followed from event to event."""

import numpy as np
from numpy.typing import ArrayLike

from trimmer.arguments import LARGEST_COUNT, MOST_EVENTS, positive_number, real_number
from trimmer.hybrid.stretch import AdvanceInterrupted, Ending, Instant
from trimmer.hybrid.work import Log
from trimmer.loops.components.backlash_component import BacklashComponent
from trimmer.loops.initial import initial_segment
from trimmer.loops.integration import followed
from trimmer.loops.loops import Loop, require_loop
from trimmer.loops.motion import LoopMotion, Outcome
from trimmer.loops.system import LoopModes

OUTCOMES = {
    Ending.REACHED_END: Outcome.COMPLETED,
    Ending.CHATTERING: Outcome.CHATTERING,
    Ending.UNDECIDED: Outcome.CHATTERING,
    Ending.EVENT_LIMIT: Outcome.EVENT_LIMIT,
    Ending.DIVERGED: Outcome.DIVERGED,
    Ending.STEP_LIMIT: Outcome.STEP_LIMIT,
}
MOST_STEPS = 50_000_000  # Steps of one motion if no number is given: about a minute


class SimulationInterrupted(KeyboardInterrupt):
    """An interrupt (Ctrl-C) ended a simulation.

    Attributes:
        motion: The motion until then.
    """

    def __init__(self, motion: LoopMotion) -> None:
        super().__init__(f"interrupted after {motion.duration:.6g} s of the motion")
        self.motion = motion


def simulate_loop(  # noqa: PLR0913
    loop: Loop,
    duration: float,
    *,
    initial_state: ArrayLike | None = None,
    impulse: float = 0.0,
    element_output: float = 0.0,
    event_limit: int = MOST_EVENTS,
    step_limit: int = MOST_STEPS,
    begin: Instant | None = None,
) -> LoopMotion:
    """Follow the motion of a loop from t = 0.

    Between events the state is known in closed form (a matrix exponential, with the drive among the states);
    events are found on it as zeros of polynomials whose truncation is below rounding.

    Friction that sticks for ever, or that is too large for anything to move, and a drive below half the gap
    give a motion that reaches its end without further events. A contact that only grazes is an impact and a
    separation, or counts in ``touches`` where it is less than rounding. Without backlash or friction, leave
    them out: a gap or a force of zero is an error.

    Args:
        loop: What moves.
        duration: Length of the motion, > 0, s.
        initial_state: States of ``loop.model`` at t = 0, of shape (n,), in their units; the loop's
            own start, or zeros, if not given.
            Only for a system that was given in state space, since a transfer function has no states of its
            own.
        impulse: Strength of an impulse at the input of the linear system at t = 0, in the unit of that input
            times s; it adds B * impulse to the states.
        element_output: Position of a load behind a backlash at t = 0, m, at rest; where the pin would lie
            outside the gap, the load starts in contact instead. For a relay with hysteresis, the output that
            it starts with, by its sign, where the input leaves a choice.
        event_limit: Greatest number of events.
        step_limit: Greatest number of steps between events, each as long as the fastest mode allows.
        begin: The instant at which it begins, in place of the three before.

    Returns:
        The motion. It ends early, and its ``outcome`` says why, if events accumulate or exceed the limit, if
        the motion grows without bound or too large for a gap, or if the fastest mode is too fast for it.

    Raises:
        ValueError: if an argument is out of range, a value of the system is not finite, or the loop is not
            well posed (``IllPosedLoopError``).
        UnsupportedMotionError: if the element or the system cannot be simulated.
        SimulationInterrupted: on an interrupt (Ctrl-C); it holds the motion until then.
    """
    require_loop(loop)
    duration = positive_number("duration", duration, "s")
    for name, limit in (("event_limit", event_limit), ("step_limit", step_limit)):
        if not (real_number(name, limit) >= 1 and limit % 1 == 0):
            raise ValueError(f"{name} must be a whole number of at least 1, not {limit!r}")
    modes = loop.modes
    if begin is None:
        mode, state = initial_segment(loop, modes, initial_state, impulse, element_output)
    else:
        forcing = modes.system.layout.forcing_at(begin.phase)
        mode, state = modes.number(begin.statuses), np.concatenate([begin.state, forcing])
    events, steps = (min(int(limit), LARGEST_COUNT) for limit in (event_limit, step_limit))
    try:
        stretch = followed(modes, mode, state, duration, events, steps, watched=True)
    except AdvanceInterrupted as interrupt:
        until = interrupt.stretch
        motion = LoopMotion(loop, float(until.duration), Outcome.INTERRUPTED, until.log)
        raise SimulationInterrupted(motion) from interrupt
    unresolved = unresolved_segment(modes, stretch.log)
    if unresolved is not None:
        log = stretch.log.first(unresolved + 1)
        return LoopMotion(loop, float(log.start[-1]), Outcome.UNRESOLVED, log)
    return LoopMotion(loop, float(stretch.duration), OUTCOMES[stretch.ending], stretch.log)


FINEST = 1e-13
"""Smallest gap over the position of its pin whose sides are told apart, about 450 units of rounding.

In random loops rounding began to repeat events at one instant with 1.4e-14.
"""


def unresolved_segment(modes: LoopModes, log: Log) -> int | None:
    """Return the first segment whose pin starts further than 1 / ``FINEST`` gaps from zero, if any.

    Beyond it the side of a gap would follow from the last bits of the position, and so from the
    processor.
    """
    backlashes = [
        (place, component.gap)
        for place, component in enumerate(modes.system.interconnection.components)
        if isinstance(component, BacklashComponent)
    ]
    first = len(log.mode)
    for number in np.unique(log.mode) if backlashes else ():
        signals = modes[int(number)].signals
        segments = np.flatnonzero(log.mode == number)
        for place, gap in backlashes:
            positions = abs(log.state[segments] @ signals[place].input)
            beyond = segments[~(FINEST * positions <= gap)]
            first = min(first, int(beyond[0]) if beyond.size else first)
    return first if first < len(log.mode) else None
