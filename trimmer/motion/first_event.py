"""The first event within one step: the guard that falls to zero first, compiled."""

from __future__ import annotations

import numba
import numpy as np

from trimmer.motion.first_root import CROSSING, first_root
from trimmer.motion.linear_combination import combine, size_of_terms
from trimmer.motion.tables import Reals, Tables, Work

ROUNDING = 64 * 2.0**-53
"""A guard below this share of the sum of the moduli of its terms is zero to rounding."""
LATER = 2.0
"""A fraction of the step that lies beyond it: no event."""
MOST_ZEROS = 3
"""No guard is known to vanish with more than its first three derivatives, the zeroth included."""


@numba.njit(cache=True)
def first_event(tables: Tables, work: Work, mode: int, at_start: bool) -> tuple[int, float, bool, int]:
    """Find which guard falls to zero first during the step that begins at ``work.state``.

    Args:
        tables: The modes.
        work: ``state`` and ``known_zeros`` are read, the rest is written.
        mode: Number of the mode.
        at_start: Whether the step begins the stretch, so that guards may be zero.

    Returns:
        Guard (-1 for none), fraction of the step at which it does, whether it was negative at once, and how
        many times a guard came to zero without crossing.
    """
    count = tables.deflation.shape[1]
    combine(work.state, tables.bernstein[mode], work.bernstein)
    fired, fraction, touches, expanded = -1, LATER, 0, False
    for guard in range(tables.guard_count[mode]):
        coefficients = work.bernstein[guard * count : (guard + 1) * count]
        known = work.known_zeros[guard] if at_start else 0
        if coefficients.min() > 0.0 and known == 0:
            continue
        tolerance = ROUNDING * size_of_terms(tables.guard_rows[mode, guard], work.state)
        if np.abs(coefficients).max() <= tolerance:
            continue  # It stays at zero, as the contact force of a pin that sticks.
        zeros = _leading_zeros(coefficients, known, tolerance) if at_start else 0
        if coefficients[zeros] < 0.0:
            return guard, 0.0, at_start and zeros == 0, touches
        if coefficients[zeros + 1 :].min() >= 0.0:
            continue
        if not expanded:
            combine(work.state, tables.series[mode], work.terms)
            expanded = True
        _deflate(tables, work, mode, guard, zeros)
        kind, root, near = first_root(work.deflated, work.taylor, count - zeros)
        touches += near
        if kind == CROSSING and root < fraction:
            fired, fraction = guard, root
    return fired, fraction, False, touches


@numba.njit(cache=True)
def _leading_zeros(coefficients: Reals, known: int, tolerance: float) -> int:
    """Count the coefficients at the start that are known or found to be zero."""
    zeros = known
    while zeros < MOST_ZEROS and abs(coefficients[zeros]) <= tolerance:
        zeros += 1
    return zeros


@numba.njit(cache=True)
def _deflate(tables: Tables, work: Work, mode: int, guard: int, zeros: int) -> None:
    """Divide a guard by s^zeros, in Bernstein form and as a series."""
    count, size = tables.deflation.shape[1], work.state.size
    for i in range(count - zeros):
        work.deflated[i] = work.bernstein[guard * count + zeros + i] * tables.deflation[zeros, i]
        value = 0.0
        for j in range(size):
            value += tables.guard_rows[mode, guard, j] * work.terms[(i + zeros) * size + j]
        work.taylor[i] = value
