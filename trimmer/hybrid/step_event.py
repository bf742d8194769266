"""The first event within a step, compiled; zeros are found as in ``trimmer.hybrid.first_root``."""

from __future__ import annotations

from trimmer.arrays import Reals
from trimmer.hybrid.compilation import inlined, merged
from trimmer.hybrid.decaying_root import UNSURE, decaying_root
from trimmer.hybrid.first_root import NOWHERE, ROUNDING, first_root
from trimmer.hybrid.linear_combination import all_above, any_below, combine, combined_moduli, unsigned, within
from trimmer.hybrid.series import COUNT
from trimmer.hybrid.sparse import Rows, coefficient, expand, modulus_of, write_terms
from trimmer.hybrid.tables import Tables
from trimmer.hybrid.taylor import MOST_ZEROS
from trimmer.hybrid.work import Work

NO_EVENT = -1
"""In place of the number of an event function."""


@inlined
def _zeros(  # noqa: PLR0913
    taylor: Reals,
    sizes: Reals,
    rows: Rows | None,
    mode: int,
    step: float,
    function: int,
    known: int,
    at_start: bool,
    state: Reals,
    room: Reals,
) -> tuple[int, float]:
    """Make the coefficients zero that are known or found to be zero at the start.

    Returns:
        How many there are, and the value below which rounding decides whether the function is zero.
    """
    zeros, size = 0, modulus_of(sizes, rows, mode, step, function, 0, state, room)
    while zeros < COUNT:
        if zeros >= known and taylor[zeros] != 0.0:
            if not at_start:
                break
            here = modulus_of(sizes, rows, mode, step, function, zeros, state, room)
            if abs(taylor[zeros]) > ROUNDING * max(size, here):
                break
        taylor[zeros] = 0.0
        zeros += 1
    return zeros, ROUNDING * size


@inlined
def _root(
    bernstein: Reals,
    taylor: Reals,
    zeros: int,
    rounding: float,
    at_start: bool,
    bernstein_from_taylor: Reals,
    pieces: Reals,
) -> tuple[float, bool, float]:
    """Find the first zero of an event function within a step.

    Returns:
        The fraction of the step, ``NOWHERE`` for none, whether it was negative at once, and where it touches
        zero before, ``NOWHERE`` if it does not.
    """
    root, jumped, touch = NOWHERE, False, NOWHERE
    if zeros < COUNT and not within(bernstein, rounding):  # Otherwise it stays at zero.
        zeros = min(zeros, MOST_ZEROS)
        if zeros > 0:
            # Without s^zeros, whose coefficients would drown the others in their rounding.
            combine(taylor[zeros:], bernstein_from_taylor[zeros], COUNT - zeros, bernstein)
        if bernstein[0] < 0.0:
            root, jumped = 0.0, at_start and zeros == 0
        elif any_below(bernstein, COUNT - zeros, 0.0):
            root, touch = first_root(bernstein, taylor[zeros:], COUNT - zeros, rounding, pieces)
    return root, jumped, touch


@merged
def _look_ahead(  # noqa: PLR0913
    screen: Reals,
    rows: Rows | None,
    mode: int,
    step: float,
    functions: int,
    state: Reals,
    screened: Reals,
    terms: Reals,
) -> None:
    """Write the state after a step and the Bernstein coefficients of all event functions, or Taylor terms."""
    if rows is None:
        combine(state, screen, state.size + functions * COUNT, screened)
    else:
        write_terms(rows, mode, step, state, terms)


@merged
def _glance(  # noqa: PLR0913
    sizes: Reals,
    rows: Rows | None,
    mode: int,
    function: int,
    margin: float,
    known: int,
    state: Reals,
    screened: Reals,
    terms: Reals,
    bernstein_from_taylor: Reals,
    taylor: Reals,
    bernstein: Reals,
) -> bool:
    """Say whether an event function must be looked at: its Bernstein coefficients are written then.

    So it is if one is at most the margin, or no number. What is known to be zero at the start, with the
    first of its derivatives, rises from there if all further coefficients are greater than rounding.
    """
    if rows is None:
        first, floor = terms.size // COUNT + function * COUNT, margin
        if known > 0 and margin == 0.0:
            size = combined_moduli(state, sizes[function, 0]) + combined_moduli(state, sizes[function, 1])
            floor = ROUNDING * size
        seen = known > 0 and margin > 0.0
        seen |= not all_above(screened, first + known, first + COUNT, floor)
        for i in range(unsigned(COUNT if seen else 0)):
            bernstein[i] = screened[unsigned(first) + i]
    else:
        seen = known > 0
        seen |= expand(rows, mode, function, margin, known, terms, bernstein_from_taylor, taylor, bernstein)
    return seen


@merged
def _write_taylor(dense: Reals, rows: Rows | None, state: Reals, taylor: Reals) -> None:
    """Write the coefficients of s^k of an event function, which stand there already if modes are rows."""
    if rows is None:
        combine(state, dense, COUNT, taylor)


@inlined
def first_event(
    tables: Tables, rows: Rows | None, work: Work, mode: int, now: int, at_start: bool, recent: int
) -> tuple[int, float, bool, bool]:
    """Find which event function falls to zero first during a step from ``work.state``.

    Args:
        tables: The modes.
        rows: Their rows, None if the tables of a step are there.
        work: The state, and what is known to be zero.
        mode: The mode.
        now: The same, or the one without decaying states, which are counted with margins alone.
        at_start: Whether something may be zero because of the last event.
        recent: The part that had it, whose functions come first where several are negative at once.

    Returns:
        The event function, the fraction of the step at which it falls to zero, whether it was negative at
        once, and whether a decaying state that was left out has a say.
    """
    size, decaying, matrices = work.state.size, work.margins.size, tables.bernstein_from_taylor
    state, bernstein, taylor = work.state, work.bernstein, work.taylor
    fired, fraction, jumped, close = NO_EVENT, NOWHERE, False, False
    functions, step = tables.function_count[now], tables.step[now]
    _look_ahead(tables.screen[now], rows, now, step, functions, state, work.screened, work.terms)
    for function in range(functions):
        # First a glance at the coefficients, which is enough as a rule.
        owner, margin, known = tables.owner[now, function], 0.0, 0
        if now != mode and 0 <= owner < decaying:
            margin = work.margins[owner]
        if at_start and owner >= 0:
            known = work.zeros[owner, tables.action[now, function]]
        work.touches[function] = NOWHERE
        seen = _glance(
            tables.sizes[now],
            rows,
            now,
            function,
            margin,
            known,
            state,
            work.screened,
            work.terms,
            matrices,
            taylor,
            bernstein,
        )
        if seen:
            _write_taylor(tables.taylor[now, function], rows, state, taylor)
            if margin > 0.0:
                z, at_once = tables.decaying_state[owner], False
                share = coefficient(tables.taylor[mode], rows, mode, function, z, size) * state[z]
                root = decaying_root(bernstein, taylor, share, tables.decay[mode, owner] * step, work.pieces)
            else:
                sizes = tables.sizes[now]
                zeros, rounding = _zeros(
                    taylor, sizes, rows, now, step, function, known, at_start, state, work.moduli
                )
                root, at_once, work.touches[function] = _root(
                    bernstein, taylor, zeros, rounding, at_start, matrices, work.pieces
                )
            if root == UNSURE or (known > 0 and margin > 0.0):
                close = True
                break
            if root < fraction or (root == 0.0 and owner == recent):
                fired, fraction, jumped = function, root, at_once
    return fired, fraction, jumped, close
