"""The motion of a loop from an extended state, and its log in the modes of another loop."""

from collections.abc import Mapping
from typing import Any

import numpy as np

from trimmer.arrays import Reals
from trimmer.hybrid.advance import MOST_STEPS, advance
from trimmer.hybrid.stretch import Instant, Stretch
from trimmer.hybrid.tables import Modes
from trimmer.hybrid.work import Log
from trimmer.loops.system import LoopModes


def followed(
    modes: LoopModes,
    mode: int,
    state: Reals,
    duration: float,
    most_events: int,
    most_steps: int = MOST_STEPS,
    watched: bool = False,
) -> Stretch:
    """Follow the motion of a loop from a mode and an extended state, (n,), for a time, s."""
    return advance(
        modes,
        instant_in(modes, mode, state),
        1,
        duration,
        True,
        most_steps,
        forcing=state[modes.system.layout.state_count :],
        most_events=most_events,
        exact=True,
        watched=watched,
    )


def instant_in(modes: Modes[Any], mode: int, extended: Reals) -> Instant:
    """Return the instant t = 0 at which a loop is in a mode, by its number, with an extended state, (N,)."""
    system = modes.system
    state = np.ascontiguousarray(extended[: system.layout.state_count])
    zeros = np.zeros((system.part_count, system.action_count), dtype=np.int64)
    return Instant(state, modes[mode].statuses, 0, 0.0, zeros, np.zeros(0))


def visited(log: Log, modes: Modes[Any]) -> dict[int, tuple[int, ...]]:
    """Return the statuses of the modes in a log by their numbers, which their loop alone knows."""
    return {number: modes.statuses[number] for number in np.unique(log.mode).tolist()}


def renumbered(log: Log, statuses: Mapping[int, tuple[int, ...]], modes: Modes[Any]) -> Log:
    """Return a log with the numbers that its modes, by their statuses, have in other modes."""
    numbers = {number: modes.number(each) for number, each in statuses.items()}
    return log._replace(mode=np.array([numbers[number] for number in log.mode.tolist()], dtype=np.int64))
