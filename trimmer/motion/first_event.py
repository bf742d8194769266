"""The first event within one step: the guard that falls to zero first, compiled."""

from __future__ import annotations

from trimmer.motion.compiled import inlined
from trimmer.motion.first_root import NOWHERE, first_root
from trimmer.motion.linear_combination import (
    all_positive,
    any_negative,
    combine,
    combine_polynomials,
    size_of_terms,
    within,
)
from trimmer.motion.tables import Reals, Tables, Work
from trimmer.motion.taylor import DEGREE, MOST_ZEROS

ROUNDING = 64 * 2.0**-53
"""A guard below this share of the sum of the moduli of all terms of its series is zero to rounding."""


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
        tolerance = ROUNDING * size_of_terms(tables.guard_sizes[mode, guard], work.state)
        if within(work.bernstein, tolerance):
            continue  # It stays at zero, as the contact force of a pin that sticks.
        zeros = _leading_zeros(work.bernstein, known, tolerance)
        polynomial, taylor = work.bernstein, work.taylor
        if zeros > 0:
            # Without s^zeros, whose coefficients would drown the others in their rounding.
            combine_polynomials(work.state, tables.taylor[mode, guard], taylor)
            taylor = taylor[zeros:]
            polynomial = work.deflated
            combine(taylor, tables.bernstein_from_taylor[zeros], count - zeros, polynomial)
        if polynomial[0] < 0.0:
            return guard, 0.0, at_start and zeros == 0
        if not any_negative(polynomial, count - zeros):
            continue
        if zeros == 0:
            combine_polynomials(work.state, tables.taylor[mode, guard], taylor)
        root, work.touch[guard] = first_root(polynomial, taylor, count - zeros, work.pieces)
        if root < fraction:
            fired, fraction = guard, root
    return fired, fraction, False


@inlined
def _leading_zeros(coefficients: Reals, known: int, tolerance: float) -> int:
    """Count the coefficients at the start that are known or found to be zero."""
    zeros = known
    while zeros < MOST_ZEROS and abs(coefficients[zeros]) <= tolerance:
        zeros += 1
    return zeros
