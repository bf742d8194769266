"""The slowest of what moves, by whose period lengths of a motion are counted where no drive gives one."""

from __future__ import annotations

from typing import TYPE_CHECKING

import numpy as np

if TYPE_CHECKING:
    from trimmer.arrays import Reals
    from trimmer.hybrid.advance import Instant
    from trimmer.motion.flow import Flow

NEGLIGIBLE = 1e-9
"""Share of the largest eigenvalue below which another one is that of a state that stays."""


def slowest_period(matrix: Reals) -> float:
    """Return the period of the slowest mode of a flow of states, (n, n), s; 0 if nothing moves."""
    moduli = abs(np.linalg.eigvals(matrix))
    moving = moduli[moduli > NEGLIGIBLE * moduli.max(initial=0.0)]
    return float(2 * np.pi / moving.min(initial=np.inf))


def time_scale(flow: Flow, instant: Instant) -> float:
    """Return the period of the slowest mode of the motion at an instant, s; 1 s if nothing moves."""
    mode = flow.modes[flow.modes.number(instant.statuses)]
    return slowest_period(mode.flow[: flow.size, : flow.size]) or 1.0
