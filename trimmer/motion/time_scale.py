"""The slowest of what moves, by whose period lengths of a motion are counted where no drive gives one."""

from __future__ import annotations

from typing import TYPE_CHECKING

import numpy as np
import scipy.linalg

if TYPE_CHECKING:
    from trimmer.arrays import Reals
    from trimmer.hybrid.stretch import Instant
    from trimmer.motion.flow import Flow

NEGLIGIBLE = 1e-9  # Share of the largest eigenvalue below which another one is that of a state that stays
ROUNDING = 64 * float(np.finfo(float).eps)
"""Share of each entry by which rounding changes a matrix; its condition carries a zero eigenvalue so far."""


def slowest_period(matrix: Reals) -> float:
    """Return the period of the slowest mode of a flow of states, (n, n), s; 0 if nothing moves.

    What stays makes eigenvalues that are zero together, as a place and a velocity that stick do. Rounding
    parts these by its root: each is held against its condition (Golub, Van Loan, Matrix Computations, 7.2).
    """
    if not matrix.size:
        return 0.0
    values, left, right = scipy.linalg.eig(matrix, left=True)
    moduli, angles = abs(values), abs((left.conj() * right).sum(axis=0))
    moving = moduli > NEGLIGIBLE * moduli.max()
    moving &= moduli * angles > ROUNDING * (abs(left) * (abs(matrix) @ abs(right))).sum(axis=0)
    return float(2 * np.pi / moduli[moving].min(initial=np.inf))


def time_scale(flow: Flow, instant: Instant) -> float:
    """Return the period of the slowest mode of the motion at an instant, s; 1 s if nothing moves."""
    mode = flow.modes[flow.modes.number(instant.statuses)]
    return slowest_period(mode.flow[: flow.size, : flow.size]) or 1.0
