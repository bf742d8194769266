"""Integration from event to event, compiled: exact steps, the first event, resets.

The first zero of event functions is found as in ``trimmer.motion.first_event``. A spring that relaxes behind
a slot is faster than all else, but it exerts no force. So the steps leave it out while it cannot bring
contact forward, and its stretch is known in closed form.
"""

from __future__ import annotations

import math
from collections.abc import Callable

from trimmer.arrays import Integers, Reals
from trimmer.contact.compilation import sources
from trimmer.contact.statuses import (
    ARRIVED,
    AT_LIMIT,
    CONTACT_BROKEN,
    NOTHING,
    REVERSED,
    STICK_BEGUN,
)
from trimmer.contact.tables import Tables
from trimmer.contact.work import Log, Work
from trimmer.motion.compilation import inlined, kept
from trimmer.motion.first_event import NOWHERE, ROUNDING, first_root
from trimmer.motion.linear_combination import (
    any_below,
    combine,
    combine_moduli,
    combine_polynomials,
    copy,
    evaluate_terms,
    within,
)
from trimmer.motion.taylor import DEGREE, LEVELS, MOST_ZEROS

REACHED_END, LOG_FULL, TO_DECIDE, CYCLING, DIVERGED, STEP_LIMIT = range(6)
"""Why the integration stopped."""
LONGEST_CASCADE = 60
"""Events at one instant, after which the integration stops."""
LARGEST = 1e150
"""Modulus of a state beyond which the motion is not followed."""
NEGLIGIBLE_STRETCH = 2.0**-56
"""Share of the gap and of the stretch at release below which the spring behind a slot counts as relaxed."""
NO_EVENT = -1


def _entry(sources: bytes) -> Callable[..., tuple[int, int, int, float, int, int, bool]]:
    def entry(
        tables: Tables,
        work: Work,
        log: Log,
        place: tuple[int, int, int, float, int],
        end: float,
        keeps: bool,
        forcing: Reals,
        states: Reals,
        counts: Integers,
    ) -> tuple[int, int, int, float, int, int, bool]:
        sources  # noqa: B018
        done, row, mode, time, steps_left = place
        state, count = work.state, DEGREE + 1
        contacts, parts, size = work.margins.size, work.known_zeros.size, work.state.size
        free, cascade, recent = size - forcing.size, 0, -2
        while True:
            # A period, or what is left of it, begins.
            if row + 1 >= log.start.size:
                return LOG_FULL, done, row, time, mode, -1, False
            if time == 0.0:
                for i in range(forcing.size):
                    state[free + i] = forcing[i]
                combine(state, tables.hold[mode], size, work.following)
                copy(work.following, size, state)
            log.start[row], log.mode[row] = time, mode
            log.part[row], log.kind[row], log.function[row] = -1, NOTHING, -1
            copy(state, size, log.state[row])
            row += 1
            while True:
                # A segment: steps until an event function falls to zero, or until the end.
                settled, elapsed, fired, jumped = tables.settled[mode], 0.0, NO_EVENT, False
                while True:
                    if steps_left <= 0 or not within(state, LARGEST):
                        reason = STEP_LIMIT if steps_left <= 0 else DIVERGED
                        return reason, done, row, time + elapsed, mode, -1, False
                    steps_left -= 1
                    now = settled
                    if settled != mode:
                        _set_margins(tables, mode, work)
                    while True:
                        first, step = size, tables.step[now]
                        fired, fraction, jumped, close = NO_EVENT, NOWHERE, False, False
                        functions = tables.function_count[now]
                        combine(state, tables.screen[now], size + functions * count, work.screened)
                        for function in range(functions):
                            # First a glance at the coefficients, which is enough as a rule.
                            owner, margin, known = tables.owner[now, function], 0.0, 0
                            if now != mode and 0 <= owner < contacts:
                                margin = work.margins[owner]
                            if elapsed == 0.0 and owner >= 0 and work.known_zeros[owner] > 0:
                                if work.known_action[owner] == tables.action[now, function]:
                                    known = work.known_zeros[owner]
                            below = False
                            for i in range(first, first + count):
                                below |= not work.screened[i] > margin
                            first += count
                            if known == 0 and not below:
                                continue
                            if margin > 0.0:
                                close = True
                                break
                            bernstein, taylor, sizes = work.bernstein, work.taylor, work.sizes
                            for i in range(count):
                                bernstein[i] = work.screened[first - count + i]
                            combine_polynomials(state, tables.taylor[now, function], taylor)
                            combine_moduli(state, tables.sizes[now, function], sizes)
                            rounding, zeros = ROUNDING * sizes[0], 0
                            while zeros < count:
                                small = elapsed == 0.0 and abs(taylor[zeros]) <= ROUNDING * max(
                                    sizes[0], sizes[zeros]
                                )
                                if zeros >= known and not small and taylor[zeros] != 0.0:
                                    break
                                taylor[zeros] = 0.0
                                zeros += 1
                            if zeros == count or within(bernstein, rounding):
                                continue  # It stays at zero.
                            zeros = min(zeros, MOST_ZEROS)
                            if zeros > 0:
                                # Without s^zeros, whose coefficients would drown the others.
                                combine(
                                    taylor[zeros:],
                                    tables.bernstein_from_taylor[zeros],
                                    count - zeros,
                                    bernstein,
                                )
                            if bernstein[0] < 0.0:
                                if fraction > 0.0 or owner == recent:
                                    fired, fraction = function, 0.0
                                    jumped = elapsed == 0.0 and zeros == 0
                            elif any_below(bernstein, count - zeros, 0.0):
                                root, _ = first_root(
                                    bernstein, taylor[zeros:], count - zeros, rounding, work.pieces
                                )
                                if root < fraction:
                                    fired, fraction, jumped = function, root, False
                        if not close:
                            break
                        now = mode
                    left = end - time - elapsed
                    if fired == NO_EVENT or fraction * step > left:
                        fired, fraction = NO_EVENT, left / step
                    if fired == NO_EVENT and fraction > 1.0:
                        copy(work.screened, size, state)
                        fraction = 1.0
                    elif fraction > 0.0:
                        level = max(min(-math.frexp(fraction)[1] // 2, LEVELS - 1), 0)
                        terms = tables.terms[now, level]
                        combine(state, tables.series[now], terms * size, work.terms)
                        evaluate_terms(work.terms, terms, fraction, state)
                    if now != mode:
                        _relax(tables, mode, fraction * step, work)
                    if left <= step * fraction and fired == NO_EVENT:
                        elapsed = end - time
                        break
                    elapsed += fraction * step
                    if fired != NO_EVENT:
                        break
                # What follows it.
                time += elapsed
                cascade = 0 if elapsed > 0.0 else cascade + 1
                if elapsed > 0.0:
                    for part in range(parts):
                        work.known_zeros[part] = 0
                if fired == NO_EVENT:
                    break
                if cascade > LONGEST_CASCADE:
                    return CYCLING, done, row, time, mode, fired, jumped
                flavour = 1 if jumped else 0
                target, owner = tables.target[mode, fired, flavour], tables.owner[mode, fired]
                action = tables.action[mode, fired]
                if action == ARRIVED or (action == AT_LIMIT and jumped):
                    for part in range(contacts, parts):
                        if part != owner and work.known_zeros[part] > 0:
                            target = -1
                if target < 0:
                    return TO_DECIDE, done, row, time, mode, fired, jumped
                if row >= log.start.size:
                    return LOG_FULL, done, row, time, mode, fired, jumped
                kind = tables.kind[mode, fired, flavour]
                if jumped and action == AT_LIMIT and log.kind[row - 1] == STICK_BEGUN:
                    if log.part[row - 1] == owner and log.start[row - 1] == time:
                        # It did not stick after all: it turns back, or goes on.
                        log.kind[row - 1] = NOTHING
                        counts[done, STICK_BEGUN] -= 1
                        before = tables.statuses[log.mode[row - 2], owner]
                        kind = NOTHING if before == tables.statuses[target, owner] else REVERSED
                log.start[row], log.mode[row] = time, target
                log.part[row], log.kind[row], log.function[row] = owner, kind, fired
                counts[done, kind] += 1
                combine(state, tables.hold[target], size, work.following)
                copy(work.following, size, state)
                copy(state, size, log.state[row])
                row += 1
                work.known_action[owner] = tables.known_action[mode, fired, flavour]
                work.known_zeros[owner] = tables.known_zeros[mode, fired, flavour]
                if kind == CONTACT_BROKEN and tables.relaxation[target, owner] > 0.0:
                    stretch = abs(state[tables.relaxing_state[owner]])
                    work.negligible[owner] = NEGLIGIBLE_STRETCH * (tables.gap[owner] + stretch)
                mode, recent = target, owner
                if row + 1 >= log.start.size and not keeps and kind != STICK_BEGUN:
                    log.mode[0], log.kind[0], log.part[0] = mode, NOTHING, -1
                    log.start[0] = time
                    row = 1
            done += 1
            copy(state, free, states[done])
            if done == counts.shape[0]:
                return REACHED_END, done, row, end, mode, -1, False
            time = 0.0
            recent = -2
            if not keeps:
                row = 0

    return kept(entry)


@inlined
def _relax(tables: Tables, mode: int, duration: float, work: Work) -> None:
    """Let the springs relax that were left out, for a duration, s."""
    for contact in range(work.margins.size):
        rate = tables.relaxation[mode, contact]
        if rate > 0.0:
            work.state[tables.relaxing_state[contact]] *= math.exp(-rate * duration)


@inlined
def _set_margins(tables: Tables, mode: int, work: Work) -> None:
    """Write by how much each relaxing spring could bring contact forward from now on, m."""
    for contact in range(work.margins.size):
        work.margins[contact] = 0.0
        if tables.relaxation[mode, contact] > 0.0:
            z = tables.relaxing_state[contact]
            if abs(work.state[z]) <= work.negligible[contact]:
                work.state[z] = 0.0
            work.margins[contact] = abs(work.state[z])


_compiled_entry = _entry(sources())


def integrate(
    tables: Tables,
    work: Work,
    log: Log,
    place: tuple[int, int, int, float, int],
    end: float,
    keeps: bool,
    forcing: Reals,
    states: Reals,
    counts: Integers,
) -> tuple[int, int, int, float, int, int, bool]:
    """Integrate over periods of one length, and log the segments of the motion.

    Args:
        tables: The modes.
        work: The state and what is known to be zero, which become those at the end.
        log: Where segments are written.
        place: Number of periods done, of rows in the log, of the mode, the time in the period, s, and the
            number of steps that are left.
        end: Length of a period, s.
        keeps: Whether the log goes on over periods; otherwise it begins again with each, and when it is full.
        forcing: Entries that force the states at the start of each period, (forcing,).
        states: State after each number of periods, (periods + 1, n); the first one is not written.
        counts: Events of each period by kind, (periods, kinds), which are added to.

    Returns:
        Why it stopped, number of periods done and of rows in the log, time in the period, s, and mode; then
        the event function that has just fallen to zero, if something is to be done about it, and whether it
        was negative at once.
    """
    return _compiled_entry(  # type: ignore[no-any-return]
        tables, work, log, place, end, keeps, forcing, states, counts
    )
