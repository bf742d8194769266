"""Where a motion begins: at rest, with given displacements and velocities, or at a known instant."""

from __future__ import annotations

from collections.abc import Mapping
from typing import TYPE_CHECKING, Any, TypeAlias

import numpy as np

from trimmer.arguments import finite_number, real_array, shown
from trimmer.errors import MechanismError, WrongTypeError
from trimmer.hybrid.advance import Instant
from trimmer.messages import listed, near_match

if TYPE_CHECKING:
    from numpy.typing import ArrayLike

    from trimmer.contact.flow import ExactFlow

Start: TypeAlias = "Mapping[str, tuple[float, float]] | ArrayLike | Instant | None"
"""Displacement, m, and velocity, m/s, by body; all states, (n,); an instant; or None for rest."""


def instant_of(flow: ExactFlow, start: Start) -> Instant:
    """Return the instant at which a motion begins, at the start of a drive period.

    Args:
        flow: The motion of the mechanism.
        start: Where it begins.

    Raises:
        WrongTypeError: if it is nothing of that kind.
        MechanismError: if it names a body that is not there, or has another number of states.
    """
    if isinstance(start, Instant):
        return start
    if start is None:
        return flow.rest()
    if isinstance(start, Mapping):
        return flow.rest({name: _moving(flow, name, pair) for name, pair in start.items()})
    state = real_array("the start", start)
    if state.shape != (flow.size,):
        raise MechanismError(
            f"the start has the shape {state.shape}, but the mechanism has {flow.size} states: "
            f"{listed(flow.names)}"
        )
    return flow.at(np.array(state, dtype=np.float64))


def _moving(flow: ExactFlow, name: str, pair: Any) -> tuple[float, float]:
    bodies = flow.modes.system.layout.bodies
    if name not in bodies:
        there = near_match(name, bodies) or f"there are {listed(bodies)}"
        raise MechanismError(f"the start names {name!r}, which is no body; {there}")
    try:
        displacement, velocity = tuple(pair)
    except (TypeError, ValueError):
        raise WrongTypeError(f"the start of {name} must be (m, m/s), not {shown(pair)}") from None
    return (
        finite_number(f"displacement of {name}", displacement, "m"),
        finite_number(f"velocity of {name}", velocity, "m/s"),
    )
