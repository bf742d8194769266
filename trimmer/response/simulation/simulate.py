"""``simulate`` for loops and mechanisms."""

from __future__ import annotations

from typing import TYPE_CHECKING, overload

from trimmer.arguments import MOST_EVENTS, positive_number, whole_number
from trimmer.mechanism.mechanism import Mechanism

if TYPE_CHECKING:
    from collections.abc import Mapping

    from numpy.typing import ArrayLike

    from trimmer.hybrid.stretch import Instant
    from trimmer.loops.loops import Loop
    from trimmer.loops.motion import LoopMotion
    from trimmer.response.simulation.motion import MechanismMotion
    from trimmer.response.starts import Start

MOST_STEPS = 20_000_000  # Steps of one simulation, if no number is given: some ten seconds


@overload
def simulate(
    loop: Loop,
    duration: float,
    *,
    state: Start = None,
    initial_state: ArrayLike | None = None,
    impulse: float = 0.0,
    element_output: float = 0.0,
    event_limit: int = MOST_EVENTS,
    step_limit: int = MOST_STEPS,
) -> LoopMotion: ...
@overload
def simulate(
    loop: Mechanism,
    duration: float,
    *,
    state: Start = None,
    event_limit: int = MOST_EVENTS,
    step_limit: int = MOST_STEPS,
) -> MechanismMotion: ...
def simulate(
    loop: Loop | Mechanism,
    duration: float,
    *,
    state: Start = None,
    event_limit: int = MOST_EVENTS,
    step_limit: int = MOST_STEPS,
    **of_loops: object,
) -> LoopMotion | MechanismMotion:
    """Follow the motion of a loop or a mechanism from t = 0.

    Between events the state is known in closed form; events are found on it as zeros of polynomials whose
    truncation is below rounding. ``trimmer.loops.simulation.simulate_loop`` says more about loops.

    Args:
        loop: What moves.
        duration: Length of the motion, > 0, s.
        state: Where it begins at t = 0: displacement, m, and velocity, m/s, by body, or states of a loop by
            name; or all states, (n,), or of a loop those of its linear system; rest, or its own start, if not
            given.
        event_limit: Greatest number of events; of a mechanism also of samples and drive periods.
        step_limit: Greatest number of steps between events.
        **of_loops: Of a loop, in place of ``state``: ``initial_state``, ``impulse`` and ``element_output``.

    Returns:
        The motion. It ends early, and its ``outcome`` says why, if events accumulate, if it grows without
        bound, or if it is too long for the fastest mode.

    Raises:
        ValueError: if an argument is out of range, or a loop is not well posed.
        TypeError: if an argument is not one of what moves.
        MechanismError: if the state does not fit the mechanism.
    """
    if isinstance(loop, Mechanism):
        if of_loops:
            raise TypeError(f"{next(iter(of_loops))} is an argument for loops; give the state of a mechanism")
        return _of_mechanism(loop, duration, state, event_limit, step_limit)
    from trimmer.loops.simulation import simulate_loop

    begin = _begin_of_loop(loop, state, of_loops)
    limits = {"event_limit": event_limit, "step_limit": step_limit}
    return simulate_loop(loop, duration, begin=begin, **limits, **of_loops)  # type: ignore[arg-type]


def _begin_of_loop(loop: Loop, state: Start, others: Mapping[str, object]) -> Instant | None:
    """Return the instant at which a loop begins; None where other arguments say it."""
    from trimmer.loops.feedback import Feedback
    from trimmer.loops.flow import LoopFlow
    from trimmer.loops.loops import require_loop
    from trimmer.response.starts import instant_of

    require_loop(loop)
    if state is None and not isinstance(loop, Feedback):
        return None
    for name in others:
        raise TypeError(f"{name} is no argument beside a state, or of a Feedback; give its state alone")
    return instant_of(LoopFlow(loop), state)


def _of_mechanism(
    mechanism: Mechanism, duration: float, state: Start, event_limit: int, step_limit: int
) -> MechanismMotion:
    from trimmer.contact.flow import MechanismFlow
    from trimmer.response.simulation.motion import MechanismMotion
    from trimmer.response.starts import instant_of

    duration = positive_number("duration", duration, "s")
    flow = MechanismFlow(mechanism)
    events, steps = whole_number("event_limit", event_limit, 1), whole_number("step_limit", step_limit, 1)
    return MechanismMotion(flow, flow.timed(instant_of(flow, state), duration, steps, events))
