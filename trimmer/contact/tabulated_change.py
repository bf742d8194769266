"""What follows an event, compiled: the next mode and what is known to be zero then, as the tables say."""

from __future__ import annotations

from trimmer.arrays import Integers
from trimmer.contact.statuses import ARRIVED, AT_LIMIT, CONTACT_BROKEN, NOTHING, REVERSED, STICK_BEGUN
from trimmer.contact.tables import Tables
from trimmer.contact.work import Log, Work
from trimmer.hybrid.compilation import inlined
from trimmer.hybrid.linear_combination import combine, copy

NEGLIGIBLE_STRETCH = 2.0**-56
"""Share of the gap and of the stretch at release below which the spring behind a slot counts as relaxed."""
AT_REST = 2.0**-44
"""Share of the moduli of its terms, and of its change over a step, below which a velocity is zero."""


@inlined
def is_tabulated(tables: Tables, work: Work, mode: int, fired: int, jumped: bool) -> bool:
    """Return whether the tables say what follows an event, and no friction at rest has a say in it."""
    target, owner = tables.target[mode, fired, 1 if jumped else 0], tables.owner[mode, fired]
    action, found = tables.action[mode, fired], target >= 0
    if action == ARRIVED or (action == AT_LIMIT and jumped):
        for part in range(work.margins.size, work.known_zeros.size):
            if part != owner and work.known_zeros[part] > 0:
                found = False
        for function in range(tables.function_count[mode]):
            if function != fired and tables.action[mode, function] == ARRIVED:
                # Another friction that comes to rest at the same instant has a say as well.
                value, size = 0.0, 0.0
                for i in range(work.state.size):
                    value += tables.taylor[mode, function, i, 0] * work.state[i]
                    sizes = tables.sizes[mode, function, 0, i] + tables.sizes[mode, function, 1, i]
                    size += sizes * abs(work.state[i])
                if abs(value) <= AT_REST * size:
                    found = False
    return bool(found)


@inlined
def _counted_kind(
    tables: Tables, log: Log, row: int, mode: int, fired: int, jumped: bool, counts: Integers
) -> int:
    """Return what an event counts as; one that did not stick after all turns back, or goes on."""
    owner = tables.owner[mode, fired]
    kind = tables.kind[mode, fired, 1 if jumped else 0]
    last = row - 1
    while last > 0 and log.kind[last] == NOTHING and log.start[last] == log.start[row]:
        last -= 1
    begun = log.kind[last] == STICK_BEGUN and log.part[last] == owner
    if begun and jumped and tables.action[mode, fired] == AT_LIMIT and log.start[last] == log.start[row]:
        log.kind[last] = NOTHING
        counts[STICK_BEGUN] -= 1
        before, target = tables.statuses[log.mode[last - 1], owner], tables.target[mode, fired, 1]
        kind = NOTHING if before == tables.statuses[target, owner] else REVERSED
    return int(kind)


@inlined
def change(
    tables: Tables, work: Work, log: Log, row: int, mode: int, event: tuple[int, bool], counts: Integers
) -> int:
    """Change the mode as the tables say, and log it in a row whose time is there; returns the new mode."""
    fired, jumped = event
    flavour = 1 if jumped else 0
    target, owner = tables.target[mode, fired, flavour], tables.owner[mode, fired]
    state, size = work.state, work.state.size
    kind = _counted_kind(tables, log, row, mode, fired, jumped, counts)
    log.mode[row], log.part[row], log.kind[row], log.function[row] = target, owner, kind, fired
    counts[kind] += 1
    combine(state, tables.hold[target], size, work.following)
    copy(work.following, size, state)
    copy(state, size, log.state[row])
    work.known_action[owner] = tables.known_action[mode, fired, flavour]
    work.known_zeros[owner] = tables.known_zeros[mode, fired, flavour]
    if kind == CONTACT_BROKEN and tables.relaxation[target, owner] > 0.0:
        stretch = abs(state[tables.relaxing_state[owner]])
        work.negligible[owner] = NEGLIGIBLE_STRETCH * (tables.gap[owner] + stretch)
    return int(target)
