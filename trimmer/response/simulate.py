"""``simulate`` for loops and mechanisms."""

from __future__ import annotations

import math
from typing import TYPE_CHECKING, overload

from trimmer.arguments import real_number, whole_number
from trimmer.mechanism.mechanism import Mechanism

if TYPE_CHECKING:
    from numpy.typing import ArrayLike

    from trimmer.loops.loops import Loop
    from trimmer.loops.motion import LoopMotion
    from trimmer.response.motion import MechanismMotion
    from trimmer.response.starts import Start

MOST_STEPS = 20_000_000
"""Steps of one simulation, if no number is given: some ten seconds."""


@overload
def simulate(
    loop: Loop,
    duration: float,
    *,
    initial_state: ArrayLike | None = None,
    impulse: float = 0.0,
    element_output: float = 0.0,
    event_limit: int = 1_000_000,
    step_limit: int = MOST_STEPS,
) -> LoopMotion: ...
@overload
def simulate(
    loop: Mechanism, duration: float, *, state: Start = None, step_limit: int = MOST_STEPS
) -> MechanismMotion: ...
def simulate(
    loop: Loop | Mechanism,
    duration: float,
    *,
    state: Start = None,
    step_limit: int = MOST_STEPS,
    **of_loops: object,
) -> LoopMotion | MechanismMotion:
    """Follow the motion of a loop or a mechanism from t = 0.

    Between events the state is known in closed form; events are found on it as zeros of polynomials whose
    truncation is below rounding. ``trimmer.loops.simulation.simulate_loop`` says more about loops.

    Args:
        loop: What moves.
        duration: Length of the motion, > 0, s.
        state: Of a mechanism: where it begins at t = 0: displacement, m, and velocity, m/s, by body; or all
            states, (n,); rest, or the start of the mechanism, if not given.
        step_limit: Greatest number of steps between events.
        **of_loops: Of a loop: ``initial_state``, ``impulse``, ``element_output``, ``event_limit``.

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
        return _of_mechanism(loop, duration, state, step_limit)
    if state is not None:
        raise TypeError("state is an argument for mechanisms; give the initial_state of a loop")
    from trimmer.loops.simulation import simulate_loop

    return simulate_loop(loop, duration, step_limit=step_limit, **of_loops)  # type: ignore[arg-type]


def _of_mechanism(mechanism: Mechanism, duration: float, state: Start, step_limit: int) -> MechanismMotion:
    from trimmer.contact.flow import MechanismFlow
    from trimmer.response.motion import MechanismMotion
    from trimmer.response.starts import instant_of

    if not 0 < real_number("duration", duration, "s") < math.inf:
        raise ValueError(f"duration must be positive and finite (s), not {duration!r}")
    flow = MechanismFlow(mechanism)
    steps = whole_number("step_limit", step_limit, 1)
    return MechanismMotion(flow, flow.timed(instant_of(flow, state), float(duration), steps))
