"""What an event, or several at one instant, make of small distances from a motion (saltation matrices)."""

from __future__ import annotations

from typing import TYPE_CHECKING

import numpy as np

from trimmer.loops.switched_component import Constrained

if TYPE_CHECKING:
    from trimmer.arrays import Reals
    from trimmer.loops.mode import LoopFunction
    from trimmer.loops.system import LoopModes
    from trimmer.orbits.return_map import Arc

AT_ZERO = 2.0**-44
"""Share of the moduli of its terms, and of its change over a step, below which an event function is zero."""
SEED = 3
"""Of the direction of the neighbour whose order of events is taken."""


def jump(modes: LoopModes, arc: Arc, before: Reals) -> Reals:
    """Return the matrix, n x n, by which the events at the end of a segment multiply small distances.

    An event that comes later by dt lets the old flow act for dt longer and the new one shorter, which is the
    saltation matrix R + (f_after - R f_before) g / (g f_before) with the reset R, the event function g
    and the flows f (Leine and Nijmeijer 2004, section 7). Where several event functions fall to zero
    together, a neighbouring motion meets them one after the other, and so do the distances. What else changes
    at the instant follows from one of them and takes place with the last.

    Args:
        modes: The modes.
        arc: The segment; an event ends it.
        before: Extended state at its end, shape (n,).
    """
    falling = _falling(modes, arc, before)
    if len(falling) == 1:
        row = falling[0].row
        return _saltation(modes, (arc.mode, arc.following), row, arc.reset, before)
    neighbour = np.random.default_rng(SEED).normal(size=len(before))
    neighbour[modes.system.layout.sine :] = 0.0
    total, state, mode, left = np.eye(len(before)), before, arc.mode, list(falling)
    while left:
        event = _next(modes, mode, left, state, total @ (neighbour * abs(before)))
        left.remove(event)
        place = _place(modes, mode, event)
        reset = np.eye(len(before)) if place is None else _reset(modes, mode, place)
        if not left:
            reset = _of_those_that_follow(modes, arc, falling) @ reset
        following = _changed(modes, mode, event, arc.following) if left else arc.following
        row = event.row if place is None else modes[mode].functions[place].row
        rate = modes[mode].flow @ state
        # What the events before it have stopped falls no more.
        falls = row @ rate < -AT_ZERO * (abs(row) @ abs(rate))
        total = (_saltation(modes, (mode, following), row, reset, state) if falls else reset) @ total
        state, mode = reset @ state, following
    return total


def _next(
    modes: LoopModes, mode: int, left: list[LoopFunction], state: Reals, distance: Reals
) -> LoopFunction:
    """Return which of several event functions that fall to zero together a neighbour meets first.

    Args:
        modes: The modes.
        mode: The present one.
        left: Those that it has not met yet.
        state: Extended state at the instant, shape (n,).
        distance: That of the neighbour, shape (n,).
    """
    rate = modes[mode].flow @ state

    def later(event: LoopFunction) -> float:
        place = _place(modes, mode, event)
        row = event.row if place is None else modes[mode].functions[place].row
        falls = row @ rate
        return float(-(row @ distance) / falls) if falls < -AT_ZERO * (abs(row) @ abs(rate)) else np.inf

    return min(left, key=later)


def _saltation(modes: LoopModes, both: tuple[int, int], row: Reals, reset: Reals, state: Reals) -> Reals:
    """Return the saltation matrix of a change from one mode to another, n x n."""
    rate, rate_after = modes[both[0]].flow @ state, modes[both[1]].flow @ (reset @ state)
    saltation: Reals = reset + np.outer(rate_after - reset @ rate, row) / (row @ rate)
    return saltation


def _falling(modes: LoopModes, arc: Arc, before: Reals) -> list[LoopFunction]:
    """Return what falls to zero at the end of a segment: what has fired, then others that have an effect.

    What is the same as one of them for all motions of the mode falls to zero with it in a neighbour too.
    """
    mode, tables = modes[arc.mode], modes.tables
    falling = [mode.functions[arc.event_function]]
    count = len(mode.functions)
    if count == 1:
        return falling
    held = _held(modes, arc.mode)
    after = modes[arc.following].statuses
    sizes = tables.sizes[arc.mode, :count, :2].sum(axis=1) @ abs(before)
    for number, event in enumerate(mode.functions):
        at_zero = abs(event.row @ before) <= AT_ZERO * sizes[number]
        changes = any(after[each.component] != mode.statuses[each.component] for each in event.reached)
        falls = event.row @ mode.flow @ before < 0.0
        if at_zero and changes and falls and not any(_are_one(event.row, each.row, held) for each in falling):
            falling.append(event)
    return falling


def _held(modes: LoopModes, number: int) -> Reals:
    """Return the matrix, n x n, that takes what a mode holds at zero out of a functional."""
    mode = modes[number]
    components = modes.system.interconnection.components
    each = zip(components, mode.signals, mode.statuses, strict=True)
    rows = [c.switching_function(s) for c, s, one in each if isinstance(c.output_law(one), Constrained)]
    size = modes.system.layout.size
    return np.eye(size) - (np.linalg.pinv(np.array(rows)) @ np.array(rows) if rows else 0.0)


def _are_one(row: Reals, other: Reals, held: Reals) -> bool:
    """Say whether one functional is a multiple of another."""
    one, another = row @ held, other @ held
    size = another @ another
    away = one - another * (one @ another) / size if size else one
    return bool(abs(away).max() <= AT_ZERO * abs(row).max())


def _is_one(event: LoopFunction, other: LoopFunction) -> bool:
    """Say whether an event function of one mode is that of another mode."""
    if (event.owner, event.action) != (other.owner, other.action):
        return False
    changed, theirs = (
        {(each.component, each.transition.target) for each in one.reached} for one in (event, other)
    )
    return bool(changed & theirs)


def _place(modes: LoopModes, mode: int, event: LoopFunction) -> int | None:
    """Return the place of an event function among those of another mode; None if it is not there any more."""
    here = enumerate(modes[mode].functions)
    return next((place for place, each in here if _is_one(each, event)), None)


def _reset(modes: LoopModes, mode: int, place: int) -> Reals:
    """Return what an event makes of the states of its components, n x n.

    What comes to rest is not projected to zero here: a neighbour may come to rest later, or go on.
    """
    return modes.system.of_states(modes[mode].functions[place])


def _of_those_that_follow(modes: LoopModes, arc: Arc, falling: list[LoopFunction]) -> Reals:
    """Return the resets, n x n, of all that happens at the end of a segment beside what falls to zero."""
    total = np.eye(modes.system.layout.size)
    for mode, place in arc.events:
        if not any(_is_one(modes[mode].functions[place], each) for each in falling):
            total = _reset(modes, mode, place) @ total
    return total


def _changed(modes: LoopModes, mode: int, event: LoopFunction, final: int) -> int:
    """Return the mode after an event alone: its components do already what they will do."""
    changed, after = list(modes[mode].statuses), modes[final].statuses
    for each in event.reached:
        changed[each.component] = after[each.component]
    return modes.number(tuple(changed))
