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
LONG = 8  # Periods of the slowest mode in which it shows what it comes to
ROUNDING = 64 * float(np.finfo(float).eps)
"""Share of each entry by which rounding changes a matrix; its condition carries a zero eigenvalue so far."""


def slowest_period(matrix: Reals, *, growing: bool = True, decaying: bool = True) -> float:
    """Return the period of the slowest mode of a flow of states, (n, n), s; 0 if nothing moves.

    Unless ``growing``, or ``decaying``, those are left out that grow, or decay, more than they swing.

    What stays makes eigenvalues that are zero together, as a place and a velocity that stick do. Rounding
    parts these by its root: each is held against its condition (Golub, Van Loan, Matrix Computations, 7.2).
    """
    if not matrix.size:
        return 0.0
    values, left, right = scipy.linalg.eig(matrix, left=True)
    moduli, angles = abs(values), abs((left.conj() * right).sum(axis=0))
    moving = moduli > NEGLIGIBLE * moduli.max()
    moving &= moduli * angles > ROUNDING * (abs(left) * (abs(matrix) @ abs(right))).sum(axis=0)
    if not growing:
        moving &= values.real <= abs(values.imag)
    if not decaying:
        moving &= -values.real <= abs(values.imag)
    return float(2 * np.pi / moduli[moving].min(initial=np.inf))


def time_scale(flow: Flow, instant: Instant) -> float:
    """Return the period of the slowest mode of the motion at an instant, s; 1 s if nothing moves."""
    mode = flow.modes[flow.modes.number(instant.statuses)]
    return slowest_period(mode.flow[: flow.size, : flow.size]) or 1.0


def slowest_met(flow: Flow, *, decaying: bool = True) -> float:
    """Return the period of the slowest mode that was met and does not just grow, s; 0 if there is none.

    Unless ``decaying``, it is one that swings.
    """
    met = (flow.modes[number].flow for number in range(len(flow.modes.statuses)))
    return max(
        slowest_period(each[: flow.size, : flow.size], growing=False, decaying=decaying) for each in met
    )


def is_brief(flow: Flow, duration: float) -> bool:
    """Say whether a time, s, is less than ``LONG`` periods of the slowest mode that was met.

    What moves so slowly may seem to grow, or to swing about something, that has only not yet come back.
    """
    return duration < LONG * slowest_met(flow)
