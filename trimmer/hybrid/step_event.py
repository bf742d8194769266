"""The first event within a step, compiled; zeros are found as in ``trimmer.hybrid.first_root``."""

from __future__ import annotations

from trimmer.arrays import Reals
from trimmer.hybrid.compilation import inlined
from trimmer.hybrid.decaying_root import UNSURE, decaying_root
from trimmer.hybrid.first_root import NOWHERE, ROUNDING, first_root
from trimmer.hybrid.linear_combination import (
    any_below,
    combine,
    combined_moduli,
    within,
)
from trimmer.hybrid.tables import Tables
from trimmer.hybrid.taylor import DEGREE, MOST_ZEROS
from trimmer.hybrid.work import Work

NO_EVENT = -1
"""In place of the number of an event function."""
COUNT = DEGREE + 1
"""Coefficients of a polynomial."""


@inlined
def _known_zeros(tables: Tables, work: Work, now: int, function: int) -> int:
    """Return how many derivatives of an event function are known to vanish, because of an event just now."""
    owner, known = tables.owner[now, function], 0
    if owner >= 0:
        known = work.zeros[owner, tables.action[now, function]]
    return known


@inlined
def _zeros(taylor: Reals, state: Reals, sizes: Reals, known: int, at_start: bool) -> int:
    """Count the coefficients at the start that are known or found to be zero, and make them so."""
    zeros, size = 0, combined_moduli(state, sizes[0])
    while zeros < COUNT:
        if zeros >= known and taylor[zeros] != 0.0:
            if not at_start:
                break
            if abs(taylor[zeros]) > ROUNDING * max(size, combined_moduli(state, sizes[zeros])):
                break
        taylor[zeros] = 0.0
        zeros += 1
    return zeros


@inlined
def _root(
    tables: Tables, work: Work, now: int, function: int, known: int, at_start: bool
) -> tuple[float, bool]:
    """Find the first zero of an event function within a step, and write where it touches zero.

    Returns:
        The fraction of the step, ``NOWHERE`` for none, and whether it was negative at once.
    """
    state, bernstein, taylor, sizes = work.state, work.bernstein, work.taylor, tables.sizes[now, function]
    combine(state, tables.taylor[now, function], taylor.size, taylor)
    rounding, root, jumped = ROUNDING * combined_moduli(state, sizes[0]), NOWHERE, False
    zeros = _zeros(taylor, state, sizes, known, at_start)
    if zeros < COUNT and not within(bernstein, rounding):  # Otherwise it stays at zero.
        zeros = min(zeros, MOST_ZEROS)
        if zeros > 0:
            # Without s^zeros, whose coefficients would drown the others in their rounding.
            combine(taylor[zeros:], tables.bernstein_from_taylor[zeros], COUNT - zeros, bernstein)
        if bernstein[0] < 0.0:
            root, jumped = 0.0, at_start and zeros == 0
        elif any_below(bernstein, COUNT - zeros, 0.0):
            root, work.touches[function] = first_root(
                bernstein, taylor[zeros:], COUNT - zeros, rounding, work.pieces
            )
    return root, jumped


@inlined
def _root_while_decaying(tables: Tables, work: Work, mode: int, now: int, function: int) -> float:
    """Find the first zero within a step that leaves a decaying state out, which is added here."""
    owner = tables.owner[now, function]
    z = tables.decaying_state[owner]
    share = tables.taylor[mode, function, z, 0] * work.state[z]
    combine(work.state, tables.taylor[now, function], work.taylor.size, work.taylor)
    decay = tables.decay[mode, owner] * tables.step[now]
    return decaying_root(work.bernstein, work.taylor, share, decay, work.pieces)


@inlined
def first_event(
    tables: Tables, work: Work, mode: int, now: int, at_start: bool, recent: int
) -> tuple[int, float, bool, bool]:
    """Find which event function falls to zero first during a step from ``work.state``.

    Args:
        tables: The modes.
        work: The state, and what is known to be zero.
        mode: The mode.
        now: The same, or the one without decaying states, which are counted with margins alone.
        at_start: Whether something may be zero because of the last event.
        recent: The part that had it, whose functions come first where several are negative at once.

    Returns:
        The event function, the fraction of the step at which it falls to zero, whether it was negative at
        once, and whether a decaying state that was left out has a say.
    """
    size, decaying = work.state.size, work.margins.size
    fired, fraction, jumped, close = NO_EVENT, NOWHERE, False, False
    functions, first = tables.function_count[now], size
    screened, bernstein = work.screened, work.bernstein
    combine(work.state, tables.screen[now], size + functions * COUNT, screened)
    for function in range(functions):
        # First a glance at the coefficients, which is enough as a rule.
        owner, margin = tables.owner[now, function], 0.0
        if now != mode and 0 <= owner < decaying:
            margin = work.margins[owner]
        known = _known_zeros(tables, work, now, function) if at_start else 0
        below, work.touches[function] = False, NOWHERE
        for i in range(first, first + COUNT):
            below |= not screened[i] > margin
        if known > 0 or below:
            for i in range(COUNT):
                bernstein[i] = screened[first + i]
            if margin > 0.0:
                root, at_once = _root_while_decaying(tables, work, mode, now, function), False
            else:
                root, at_once = _root(tables, work, now, function, known, at_start)
            if root == UNSURE or (known > 0 and margin > 0.0):
                close = True
                break
            if root < fraction or (root == 0.0 and owner == recent):
                fired, fraction, jumped = function, root, at_once
        first += COUNT
    return fired, fraction, jumped, close
