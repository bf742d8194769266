"""Where a motion begins: at rest, with given displacements and velocities, or at a known instant."""

from collections.abc import Mapping
from typing import Any, TypeAlias

import numpy as np
from numpy.typing import ArrayLike

from trimmer.arguments import finite_number, real_array, shown
from trimmer.errors import LoopError, MechanismError, WrongTypeError
from trimmer.hybrid.stretch import Instant
from trimmer.loops.loops import Loop
from trimmer.messages import listed, near_or_all
from trimmer.motion.flow import Flow

Start: TypeAlias = "Mapping[str, Any] | ArrayLike | Instant | None"
"""Displacement, m, and velocity, m/s, by body, or of a loop states by name; all states, (n,); an instant; or
None for rest."""


def instant_of(flow: Flow, start: Start) -> Instant:
    """Return the instant at which a motion begins, at the start of a drive period.

    Args:
        flow: What moves.
        start: Where it begins.

    Raises:
        WrongTypeError: if it is nothing of that kind.
        MechanismError, LoopError: if it names a body or state that is not there, or has another number of
            states.
    """
    if isinstance(start, Instant):
        return start
    if start is None:
        return flow.rest()
    if isinstance(start, Mapping):
        read = _state if isinstance(flow.subject, Loop) else _moving
        return flow.rest({name: read(flow, name, given) for name, given in start.items()})
    state = real_array("the start", start)
    if isinstance(flow.subject, Loop) and state.shape == (len(flow.axes),):
        # The states of the linear system alone; loads begin at rest in their gaps.
        return flow.rest({name: (value,) for name, value in zip(flow.axes, state.tolist(), strict=True)})
    if state.shape != (flow.size,):
        error, what = (LoopError, "loop") if isinstance(flow.subject, Loop) else (MechanismError, "mechanism")
        raise error(
            f"the start has the shape {state.shape}, but the {what} has {flow.size} states: "
            f"{listed(flow.names)}"
        )
    return flow.at(np.array(state, dtype=np.float64))


def _moving(flow: Flow, name: str, pair: Any) -> tuple[float, float]:
    bodies = flow.axes
    if name not in bodies:
        raise MechanismError(f"the start names {name!r}, which is no body; {near_or_all(name, bodies)}")
    length, speed = flow.axis_units[name]
    try:
        displacement, velocity = tuple(pair)
    except (TypeError, ValueError):
        raise WrongTypeError(f"the start of {name} must be ({length}, {speed}), not {shown(pair)}") from None
    return (
        finite_number(f"displacement of {name}", displacement, length),
        finite_number(f"velocity of {name}", velocity, speed),
    )


def _state(flow: Flow, name: str, value: Any) -> tuple[float]:
    """Return the value of a state of a loop, given alone or in a pair of brackets."""
    if name not in flow.axes:
        there = near_or_all(name, flow.axes)
        raise LoopError(f"the start names {name!r}, which is no state of the loop; {there}")
    (number,) = value if isinstance(value, tuple | list) and len(value) == 1 else (value,)
    return (finite_number(name, number),)
