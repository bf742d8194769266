"""What follows an event, compiled: the next mode and what is known to be zero then, as the tables say."""

from __future__ import annotations

from trimmer.arrays import Integers, Reals
from trimmer.hybrid.compilation import compiled, inlined
from trimmer.hybrid.linear_combination import combine, copy
from trimmer.hybrid.sparse import Rows, hold, modulus_of, value_of
from trimmer.hybrid.system import ARRIVED, AT_LIMIT, HOLD_BEGUN, NOTHING, REVERSED, STRUCK
from trimmer.hybrid.tables import NO_RESET, Tables
from trimmer.hybrid.work import Log, Work

DECAYED = 2.0**-56
"""Share of its scale and of its first value below which a state that decays by itself counts as zero."""
AT_REST = 2.0**-44
"""Share of the moduli of its terms, and of its change over a step, below which a function is zero."""


@compiled
def is_at_zero(
    tables: Tables, rows: Rows | None, mode: int, function: int, state: Reals, room: Reals
) -> bool:
    """Return whether an event function is zero, as far as rounding tells, beside its change over a step."""
    value, size, step = value_of(tables.taylor[mode], rows, mode, function, state), 0.0, tables.step[mode]
    for k in range(2):
        size += modulus_of(tables.sizes[mode], rows, mode, step, function, k, state, room)
    return bool(abs(value) <= AT_REST * size)


@compiled
def _is_struck_alone(
    tables: Tables, rows: Rows | None, work: Work, mode: int, fired: int, jumped: bool
) -> bool:
    """Return whether a function that is reset at zero falls to it clearly, and no other with it."""
    alone = rows is None and not jumped
    if rows is None:
        rate, second, size, step = 0.0, 0.0, 0.0, tables.step[mode]
        for i in range(work.state.size):
            rate -= tables.taylor[mode, fired, i, 1] * work.state[i]
            second -= 2.0 * tables.taylor[mode, fired, i, 2] * work.state[i]
            size += tables.sizes[mode, fired, 1, i] * abs(work.state[i])
        alone &= rate > AT_REST * size
        alone &= rate * step > tables.shortest[mode, fired] * second
        for function in range(tables.function_count[mode]):
            if function != fired and tables.action[mode, function] == STRUCK:
                alone &= not is_at_zero(tables, rows, mode, function, work.state, work.moduli)
    return bool(alone)


@inlined
def is_tabulated(tables: Tables, rows: Rows | None, work: Work, mode: int, fired: int, jumped: bool) -> bool:
    """Return whether the tables say what follows an event, and no other part at rest has a say in it."""
    target, owner = tables.target[mode, fired, 1 if jumped else 0], tables.owner[mode, fired]
    action, found = tables.action[mode, fired], target >= 0
    if action == STRUCK:
        found &= _is_struck_alone(tables, rows, work, mode, fired, jumped)
    if action == ARRIVED or (action == AT_LIMIT and jumped):
        for part in range(work.zeros.shape[0]):
            if part != owner and work.zeros[part, ARRIVED] > 0:
                found = False
        for function in range(tables.function_count[mode]):
            if function != fired and tables.action[mode, function] == ARRIVED:
                # Another part that comes to rest at the same instant has a say as well.
                found &= not is_at_zero(tables, rows, mode, function, work.state, work.moduli)
    return bool(found)


@inlined
def _counted_kind(
    tables: Tables, log: Log, row: int, mode: int, fired: int, jumped: bool, counts: Integers
) -> int:
    """Return what an event counts as; what is not held after all turns back, or goes on."""
    owner = tables.owner[mode, fired]
    kind = tables.kind[mode, fired, 1 if jumped else 0]
    last = row - 1
    while last > 0 and log.kind[last] == NOTHING and log.start[last] == log.start[row]:
        last -= 1
    begun = log.kind[last] == HOLD_BEGUN and log.part[last] == owner
    if begun and jumped and tables.action[mode, fired] == AT_LIMIT and log.start[last] == log.start[row]:
        log.kind[last] = NOTHING
        counts[HOLD_BEGUN] -= 1
        before, target = tables.statuses[log.mode[last - 1], owner], tables.target[mode, fired, 1]
        kind = NOTHING if before == tables.statuses[target, owner] else REVERSED
    return int(kind)


@inlined
def change(  # noqa: PLR0913
    tables: Tables,
    rows: Rows | None,
    work: Work,
    log: Log,
    row: int,
    mode: int,
    event: tuple[int, bool],
    counts: Integers,
) -> int:
    """Change the mode as the tables say, and log it in a row whose time is there; returns the new mode."""
    fired, jumped = event
    flavour = 1 if jumped else 0
    target, owner = tables.target[mode, fired, flavour], tables.owner[mode, fired]
    state, size = work.state, work.state.size
    kind = _counted_kind(tables, log, row, mode, fired, jumped, counts)
    log.mode[row], log.part[row], log.kind[row], log.function[row] = target, owner, kind, fired
    log.touches[row] = 0
    counts[kind] += 1
    reset = tables.reset[mode, fired, flavour]
    if reset != NO_RESET:
        combine(state, tables.resets[reset], size, work.following)
        copy(work.following, size, state)
    hold(tables.hold[target], rows, target, state, work.following)
    copy(state, size, log.state[row])
    for function in range(tables.function_count[target]):
        other = tables.owner[target, function]
        if other >= 0 and other != owner:
            action = tables.action[target, function]
            known = work.zeros[other, action]
            work.zeros[other, action] = min(known, tables.continuous[target, function])
    for action in range(work.zeros.shape[1]):
        work.zeros[owner, action] = tables.zeros[mode, fired, flavour, action]
    if (
        0 <= owner < work.margins.size
        and tables.decay[target, owner] > 0.0
        and tables.decay[mode, owner] == 0.0
    ):
        first = abs(state[tables.decaying_state[owner]])
        work.negligible[owner] = DECAYED * (tables.scale[owner] + first)
    return int(target)
