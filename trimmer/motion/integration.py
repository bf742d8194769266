"""Integration over a time: modes are tabulated, the log gets longer, and a cascade of events is cut short."""

from __future__ import annotations

from typing import TYPE_CHECKING

import numpy as np

from trimmer.motion.frictions.complementarity import complementary_mode
from trimmer.motion.frictions.coupled_relays import attracting
from trimmer.motion.kernel import (
    CYCLING,
    FULL,
    LONGEST_CASCADE,
    MOST_STEPS,
    STEP_LIMIT,
    UNKNOWN_MODE,
    integrate,
)
from trimmer.motion.relay_component import HELD
from trimmer.motion.tables import TOGETHER, Limits, Log, new_pause
from trimmer.progress import progress_bar

if TYPE_CHECKING:
    from trimmer.arrays import Reals
    from trimmer.motion.mode import Change
    from trimmer.motion.mode_tables import ModeTables


AT_ONCE = 1_000_000
"""Steps after which the compiled code comes back, so that an interrupt is heard; they take about a second."""
MOST_TOGETHER = 16
"""Segments of one instant, at most, whose modes are decided together; other events may come in between."""


def new_log(rows: int, mode: int, state: Reals) -> Log:
    """Return a log with room for some segments, the first of which begins with a mode and a state."""
    log = Log(
        start=np.zeros(rows),
        mode=np.zeros(rows, dtype=np.int64),
        state=np.zeros((rows, state.size)),
        event_function=np.full(rows, -1, dtype=np.int64),
        jumped=np.zeros(rows, dtype=np.bool_),
        touches=np.zeros(rows, dtype=np.int64),
    )
    log.mode[0], log.state[0] = mode, state
    return log


def integrate_on(
    modes: ModeTables,
    log: Log,
    end: float,
    most_segments: int,
    most_steps: int = MOST_STEPS,
    longest_cascade: int = LONGEST_CASCADE,
) -> tuple[int, Log, float]:
    """Integrate from the first segment of a log until a time, s.

    After two seconds a progress bar shows on a terminal.

    Args:
        modes: The modes.
        log: From ``new_log``.
        end: s.
        most_segments: Largest number of segments in the log.
        most_steps: Largest number of steps, each time the integration is continued.
        longest_cascade: Events at one instant after which relays and frictions are decided together.

    Returns:
        Why it stopped (of ``trimmer.motion.kernel``), the log with all its segments, and the time reached, s.

    Raises:
        IntegrationInterrupted: on an interrupt (Ctrl-C); it holds the log until then.
    """
    segment, left = 0, most_steps
    pause, bar = new_pause(modes.tables), None
    try:
        while True:
            limits = Limits(most_segments, min(left, AT_ONCE), longest_cascade)
            reason, segment, reached = integrate(modes.tables, log, segment, end, limits, pause)
            if reason == STEP_LIMIT and left > AT_ONCE:
                left -= AT_ONCE
                if bar is None:
                    bar = progress_bar(description="simulate", total=end, unit="s", unit_scale=True)
                bar.update(reached - bar.n)
                continue
            left = most_steps
            if reason == UNKNOWN_MODE:
                modes.tabulate(int(log.mode[segment]))
            elif reason == FULL:
                log = _longer(log)
            else:
                following = None
                if reason == CYCLING:
                    log = _longer(log) if segment + 2 >= log.start.size else log
                    following = _decide_together(modes, log, segment)
                if following is None:
                    return reason, shortened(log, segment), reached
                segment = following
    except KeyboardInterrupt as interrupt:
        until = shortened(log, int(pause.segment[0]))
        raise IntegrationInterrupted(until, float(pause.reached[0])) from interrupt
    finally:
        if bar is not None:
            bar.close()


class IntegrationInterrupted(KeyboardInterrupt):
    """An interrupt (Ctrl-C) ended an integration: the log with its segments, and the time reached, s."""

    def __init__(self, log: Log, reached: float) -> None:
        super().__init__("the integration was interrupted")
        self.log, self.reached = log, reached


def shortened(log: Log, last: int) -> Log:
    """Return the log up to a segment."""
    return Log._make(column[: last + 1].copy() for column in log)


def _longer(log: Log) -> Log:
    """Return a log with twice the room."""
    return Log._make(np.concatenate([column, np.zeros_like(column)]) for column in log)


def changes(modes: ModeTables, log: Log, segment: int) -> tuple[Change, ...]:
    """Return what changed at the event that began a segment, if the integration found it."""
    entry = modes.mode(int(log.mode[segment - 1])).event_functions[int(log.event_function[segment])]
    return entry.jumped if log.jumped[segment] else entry.reached


def _decide_together(modes: ModeTables, log: Log, last: int) -> int | None:
    """Write the mode that all relays go on in, in place of events that repeat each other.

    It takes two segments without duration: first all are held whose switching functions are zero, so that it
    is known of which they are. Returns the second; None if the mode cannot be told, or is told too often.
    """
    first = int(np.searchsorted(log.start[: last + 1], log.start[last]))
    kept, at_rest = first, set[int]()
    for each in range(max(first, 1), last + 1):
        if log.event_function[each] == TOGETHER:
            kept = each
            continue
        changed = {change.component for change in changes(modes, log, each)}
        switched = {k for k in changed if attracting(modes.system, k)}
        at_rest |= switched
        kept = each if changed != switched else kept
    if np.count_nonzero(log.event_function[first : last + 1] == TOGETHER) >= MOST_TOGETHER:
        return None
    relays = _all_at_rest(modes, int(log.mode[last]), at_rest)
    mode = complementary_mode(modes, int(log.mode[last]), log.state[last], relays)
    if mode is None:
        return None
    held = [HELD if k in relays else one for k, one in enumerate(modes.component_modes(int(log.mode[last])))]
    state = modes.at_rest(modes.mode(int(log.mode[last])), tuple(held)) @ log.state[last]
    for segment, number in ((kept + 1, modes.number(tuple(held))), (kept + 2, mode)):
        log.start[segment], log.mode[segment], log.state[segment] = log.start[last], number, state
        log.event_function[segment], log.jumped[segment], log.touches[segment] = TOGETHER, False, 0
        if not modes.tables.known[number]:
            modes.tabulate(number)
    return kept + 2


def _all_at_rest(modes: ModeTables, number: int, some: set[int]) -> tuple[int, ...]:
    """Return the relays whose switching functions are zero: some, those held, and those that follow."""
    held = list(modes.component_modes(number))
    for k in some:
        held[k] = HELD
    closed = modes.coupled.closed(tuple(held))
    return tuple(k for k, one in enumerate(closed) if attracting(modes.system, k) and one == HELD)
