"""The first event within one step: the guard that falls to zero first, compiled."""

from __future__ import annotations

from trimmer.motion.compiled import inlined
from trimmer.motion.first_root import NOWHERE, first_root
from trimmer.motion.linear_combination import (
    all_positive,
    any_negative,
    combine,
    combine_moduli,
    combine_polynomials,
    within,
)
from trimmer.motion.tables import Reals, Tables, Work
from trimmer.motion.taylor import DEGREE, MOST_ZEROS

ROUNDING = 64 * 2.0**-53
"""A coefficient below this share of the moduli of its terms, or of those of the value, is zero."""


@inlined
def first_event(tables: Tables, work: Work, mode: int, at_start: bool) -> tuple[int, float, bool]:
    """Find which guard falls to zero first during the step that begins at ``work.state``.

    Args:
        tables: The modes.
        work: ``state`` and ``known_zeros`` are read, the rest is written; ``touch`` becomes where each guard
            touches zero without crossing.
        mode: Number of the mode.
        at_start: Whether the step begins the stretch, so that guards may be zero.

    Returns:
        Guard (-1 for none), fraction of the step at which it does, and whether it was negative at once.
    """
    count = DEGREE + 1
    fired, fraction = -1, NOWHERE
    for guard in range(tables.guard_count[mode]):
        work.touch[guard] = NOWHERE
        combine_polynomials(work.state, tables.bernstein[mode, guard], work.bernstein)
        known = work.known_zeros[guard] if at_start else 0
        if known == 0 and all_positive(work.bernstein):
            continue
        combine_polynomials(work.state, tables.taylor[mode, guard], work.taylor)
        combine_moduli(work.state, tables.sizes[mode, guard], work.sizes)
        zeros = _leading_zeros(work.taylor, work.sizes, known)
        if zeros == count or within(work.bernstein, ROUNDING * work.sizes[0]):
            continue  # It stays at zero, as the contact force of a pin that sticks.
        zeros = min(zeros, MOST_ZEROS)
        polynomial, taylor = work.bernstein, work.taylor[zeros:]
        if zeros > 0:
            # Without s^zeros, whose coefficients would drown the others in their rounding.
            polynomial = work.deflated
            combine(taylor, tables.bernstein_from_taylor[zeros], count - zeros, polynomial)
        if polynomial[0] < 0.0:
            return guard, 0.0, at_start and zeros == 0
        if not any_negative(polynomial, count - zeros):
            continue
        root, work.touch[guard] = first_root(polynomial, taylor, count - zeros, work.pieces)
        if root < fraction:
            fired, fraction = guard, root
    return fired, fraction, False


@inlined
def _leading_zeros(taylor: Reals, sizes: Reals, known: int) -> int:
    """Count the coefficients at the start that are known or found to be zero, and make them so."""
    zeros = 0
    while zeros < taylor.size:
        if zeros >= known and abs(taylor[zeros]) > ROUNDING * max(sizes[0], sizes[zeros]):
            break
        taylor[zeros] = 0.0
        zeros += 1
    return zeros
