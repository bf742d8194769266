"""The first event within a step: which event function falls to zero first, and where. Compiled.

Event functions are polynomials over the step.
"""

from __future__ import annotations

from trimmer.arrays import Reals
from trimmer.hybrid.compilation import inlined
from trimmer.hybrid.first_root import NOWHERE, ROUNDING, first_root
from trimmer.hybrid.linear_combination import (
    all_positive,
    any_below,
    combine,
    combine_moduli,
    combine_polynomials,
    within,
)
from trimmer.hybrid.taylor import DEGREE, MOST_ZEROS
from trimmer.motion.tables import Tables, Work


@inlined
def first_event(
    tables: Tables, work: Work, mode: int, at_start: bool, recent: int
) -> tuple[int, float, bool]:
    """Find which event function falls to zero first during the step that begins at ``work.state``.

    Where several are negative at once, the component that has just changed its mode comes first: while it is
    in a mode that cannot hold, such as stick beyond its limit, what the others would do means nothing.

    Args:
        tables: The modes.
        work: ``state`` and ``known_zeros`` are read, the rest is written; ``touch`` becomes where each event
            function touches zero without crossing.
        mode: Number of the mode.
        at_start: Whether the step begins the segment, so that event functions may be zero.
        recent: Number of the component whose transition began the segment, -1 for none.

    Returns:
        The event function (-1 for none), the fraction of the step at which it falls to zero, and whether it
        was negative at once.
    """
    count = DEGREE + 1
    fired, fraction, jumped = -1, NOWHERE, False
    # Each use of an array in a tuple counts references, which costs as much as ten products.
    state, bernstein, touch, known_zeros = work.state, work.bernstein, work.touch, work.known_zeros
    for event_function in range(tables.event_count[mode]):
        touch[event_function] = NOWHERE
        combine_polynomials(state, tables.bernstein[mode, event_function], bernstein)
        known = known_zeros[event_function] if at_start else 0
        if known == 0 and all_positive(bernstein):
            continue
        taylor, sizes = work.taylor, work.sizes
        combine_polynomials(state, tables.taylor[mode, event_function], taylor)
        combine_moduli(state, tables.sizes[mode, event_function], sizes)
        rounding = ROUNDING * sizes[0]
        zeros = _leading_zeros(taylor, sizes, known)
        if zeros == count or within(bernstein, rounding):
            continue  # It stays at zero, as the contact force of a pin that sticks.
        zeros = min(zeros, MOST_ZEROS)
        if zeros > 0:
            # Without s^zeros, whose coefficients would drown the others in their rounding.
            combine(taylor[zeros:], tables.bernstein_from_taylor[zeros], count - zeros, bernstein)
        if bernstein[0] < 0.0:
            if fraction > 0.0 or tables.component[mode, event_function] == recent:
                fired, fraction, jumped = event_function, 0.0, at_start and zeros == 0
            continue
        if not any_below(bernstein, count - zeros, 0.0):
            continue
        root, touch[event_function] = first_root(
            bernstein, taylor[zeros:], count - zeros, rounding, work.pieces
        )
        if root < fraction:
            fired, fraction, jumped = event_function, root, False
    return fired, fraction, jumped


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
