"""One segment of a motion, compiled: exact steps until an event function falls to zero.

A state that decays by itself, as a spring that relaxes behind a slot, may be faster than all else, but no
other depends on it. So the steps leave it out as long as its share of an event function can be told apart,
and it is known in closed form.
"""

from __future__ import annotations

import math

from trimmer.arrays import Integers, Reals
from trimmer.hybrid.compilation import inlined, merged
from trimmer.hybrid.linear_combination import combine, copy, evaluate_terms, within
from trimmer.hybrid.series import COUNT
from trimmer.hybrid.sparse import Rows, value_of
from trimmer.hybrid.step_event import NO_EVENT, first_event
from trimmer.hybrid.tables import Tables
from trimmer.hybrid.taylor import LEVELS
from trimmer.hybrid.work import Work

LARGEST = 1e150
"""Modulus of a state beyond which the motion is not followed."""
NEAR = 2.0
"""Value of an event function, in moduli of a decaying state, below which that is not left out."""
OUT_OF_BOUNDS = -2
"""In place of the number of an event function: the state has grown beyond ``LARGEST``."""
OUT_OF_STEPS = -3
"""In place of the number of an event function: there are no steps left."""


@merged
def _step(
    series: Reals,
    rows: Rows | None,
    terms: Integers,
    fraction: float,
    screened: Reals,
    room: Reals,
    state: Reals,
) -> None:
    """Go on for a fraction of a step, a whole one if it is greater than 1.

    Args:
        series: Table of the series, (N, (K + 1) N).
        rows: The rows of modes; then the terms are in the room.
        terms: How many of them do, by level.
        fraction: The fraction.
        screened: The state after a whole step comes first in it.
        room: The terms.
        state: The state, (N,).
    """
    if rows is not None:
        evaluate_terms(room, COUNT, min(fraction, 1.0), state)
    elif fraction >= 1.0:
        copy(screened, state.size, state)
    elif fraction > 0.0:
        level = max(min(-math.frexp(fraction)[1] // 2, LEVELS - 1), 0)
        combine(state, series, terms[level] * state.size, room)
        evaluate_terms(room, terms[level], fraction, state)


@inlined
def _decay(left_out: bool, rates: Reals, places: Integers, duration: float, state: Reals) -> None:
    """Let the states decay that a step has left out, if it has, for a duration, s."""
    for part in range(rates.size):
        if left_out and rates[part] > 0.0:
            state[places[part]] *= math.exp(-rates[part] * duration)


@inlined
def _set_margins(rates: Reals, places: Integers, negligible: Reals, state: Reals, margins: Reals) -> None:
    """Write by how much each decaying state could bring an event function to zero earlier from now on."""
    for part in range(margins.size):
        margins[part] = 0.0
        if rates[part] > 0.0:
            z = places[part]
            if abs(state[z]) <= negligible[part]:
                state[z] = 0.0
            margins[part] = abs(state[z])


@inlined
def _is_near(tables: Tables, rows: Rows | None, work: Work, mode: int) -> bool:
    """Return whether a decaying state is so close to an event that it is of no use to leave it out."""
    near = False
    for function in range(tables.function_count[mode]):
        owner = tables.owner[mode, function]
        if 0 <= owner < work.margins.size and tables.decay[mode, owner] > 0.0:
            distance = value_of(tables.taylor[mode], rows, mode, function, work.state)
            near |= distance <= NEAR * abs(work.state[tables.decaying_state[owner]])
    return near


@inlined
def rounding(first: float, second: float, total: float) -> float:
    """Return by how much a sum of two numbers is greater than what it was rounded to (Knuth's TwoSum)."""
    added = total - first
    return (first - (total - added)) + (second - added)


@inlined
def _touches_before(touches: Reals, functions: int, fraction: float) -> int:
    """Return how many event functions touch zero before a fraction of a step without crossing."""
    count = 0
    for function in range(functions):
        count += touches[function] < fraction
    return count


@inlined
def follow(
    tables: Tables, rows: Rows | None, work: Work, mode: int, recent: int, duration: float, most_steps: int
) -> tuple[int, bool, float, float, int, int]:
    """Follow one segment for a duration, s; ``work.state`` becomes the state at its end.

    Returns:
        The event function that ends it, or why there is none; whether it was negative at once; the time
        until then, s, and what that lost in rounding; the number of steps; how many times one touched zero
        without crossing.
    """
    settled, elapsed, steps, fired, jumped = tables.settled[mode], 0.0, 0, NO_EVENT, False
    near, touches, lost = settled != mode and _is_near(tables, rows, work, mode), 0, 0.0
    while True:
        if steps >= most_steps or not within(work.state, LARGEST):
            fired = OUT_OF_STEPS if steps >= most_steps else OUT_OF_BOUNDS
            break
        steps += 1
        now, left = mode if near else settled, duration - elapsed
        if settled != mode:
            _set_margins(tables.decay[mode], tables.decaying_state, work.negligible, work.state, work.margins)
        while True:
            fired, fraction, jumped, close = first_event(
                tables, rows, work, mode, now, elapsed == 0.0, recent
            )
            if not close:
                break
            now = mode
        step = tables.step[now]
        if fired != NO_EVENT and fraction * step > left:
            fired = NO_EVENT
        if fired == NO_EVENT:
            fraction = min(left / step, 1.0)
        touches += _touches_before(work.touches, tables.function_count[now], fraction)
        _step(tables.series[now], rows, tables.terms[now], fraction, work.screened, work.terms, work.state)
        _decay(now != mode, tables.decay[mode], tables.decaying_state, min(fraction, 1.0) * step, work.state)
        near = near and _is_near(tables, rows, work, mode)
        if fired == NO_EVENT and left <= step:
            elapsed, lost = duration, 0.0
            break
        before = elapsed
        elapsed = before + fraction * step
        lost += rounding(before, fraction * step, elapsed)
        if fired != NO_EVENT:
            break
    return fired, jumped, elapsed, lost, steps, touches
