"""From one instant of a motion to a later one: the compiled integration, and what it leaves to decide."""

from __future__ import annotations

from dataclasses import dataclass, replace
from typing import TYPE_CHECKING

import numpy as np

from trimmer.choices import Choice
from trimmer.contact.integration import (
    AT_REST,
    CYCLING,
    DIVERGED,
    LOG_FULL,
    LONGEST_CASCADE,
    NEGLIGIBLE_STRETCH,
    REACHED_END,
    STEP_LIMIT,
    TO_DECIDE,
    Place,
    Task,
    integrate,
)
from trimmer.contact.joint import decide
from trimmer.contact.statuses import (
    ARRIVED,
    AT_LIMIT,
    CONTACT_BROKEN,
    KINDS,
    NOTHING,
    REVERSED,
    STICK,
    STICK_BEGUN,
    STICK_ENDED,
)
from trimmer.contact.tables import Modes
from trimmer.contact.work import Log, work_for

if TYPE_CHECKING:
    from trimmer.arrays import Integers, Places, Reals

ROWS = 64
"""Rows of a log to begin with."""
MOST_STEPS = 20_000_000
"""Steps of one integration if no number is given: some ten seconds."""


class Ending(Choice):
    """Why a motion ends where it does."""

    REACHED_END = "it reached its end"
    CHATTERING = "more events at one instant than can be told apart"
    DIVERGED = "it grew beyond all bounds"
    STEP_LIMIT = "it took more steps than allowed"
    UNDECIDED = "rounding kept dry friction at rest from being decided"


_ENDINGS = {
    REACHED_END: Ending.REACHED_END,
    CYCLING: Ending.CHATTERING,
    DIVERGED: Ending.DIVERGED,
    STEP_LIMIT: Ending.STEP_LIMIT,
}


@dataclass(frozen=True, eq=False)
class Instant:
    """All that determines the motion from an instant on.

    Attributes:
        state: Displacements, m, velocities, m/s, and stretches of relaxing springs, m, shape (n,).
        statuses: Of all contacts, then of all frictions.
        periods: Whole drive periods since the start.
        phase: Time since then, s.
        known_zeros: For each part, how many derivatives of one of its event functions vanish, (m + p,).
        known_action: Which one that is, (m + p,).
        negligible: Stretches of relaxing springs that count as zero, m, (m,).
    """

    state: Reals
    statuses: tuple[int, ...]
    periods: int
    phase: float
    known_zeros: Integers
    known_action: Integers
    negligible: Reals


@dataclass(frozen=True, eq=False)
class Stretch:
    """A motion over some periods.

    Attributes:
        end: The instant at which it ends.
        ending: Why.
        log: Its segments, if they were to be kept; else those of the end.
        states: State at the start and after each period, (periods done + 1, n).
        counts: Events of each period by kind, (periods begun, kinds).
    """

    end: Instant
    ending: Ending
    log: Log
    states: Reals
    counts: Integers


def advance(
    modes: Modes, instant: Instant, periods: int, length: float, keeps: bool, most_steps: int = MOST_STEPS
) -> Stretch:
    """Go on for some periods of one length, s.

    Args:
        modes: The modes of the mechanism; those that are met are added.
        instant: Where the motion begins.
        periods: Number of periods, at least 1.
        length: Their length, s, that of the drive's period if there are several; of a part of it otherwise.
        keeps: Whether all segments are logged.
        most_steps: Largest number of steps.

    Raises:
        ValueError: if there is no period.
    """
    if periods < 1:
        raise ValueError(f"the number of periods must be at least 1, not {periods}")
    return _Progress(modes, instant, periods, length, keeps).run(most_steps)


class _Progress:
    """The state of an integration between calls of the compiled code."""

    def __init__(self, modes: Modes, instant: Instant, periods: int, length: float, keeps: bool) -> None:
        self.modes, self.instant, self.keeps = modes, instant, keeps
        self.begin = instant.phase
        self.length = length
        self.mode = modes.number(instant.statuses)
        self.work = work_for(modes.tables)
        self._take(instant)
        self.log = Log.empty(ROWS, modes.layout.size)
        self.states = np.empty((periods + 1, modes.layout.state_count))
        self.states[0] = instant.state
        self.counts = np.zeros((periods, KINDS), dtype=np.int64)
        self.cascade, self.cascade_at = 0, (-1, -1.0)

    def _take(self, instant: Instant) -> None:
        free = self.modes.layout.state_count
        self.work.state[:free] = instant.state
        self.work.state[free:] = self._forcing()
        self.work.known_zeros[:] = instant.known_zeros
        self.work.known_action[:] = instant.known_action
        self.work.negligible[:] = instant.negligible

    def _forcing(self) -> Reals:
        # Ramps count the time since the start of the motion, waves that since the start of the period.
        layout, instant = self.modes.layout, self.instant
        return layout.forcing_at(self.begin, instant.periods * layout.period)

    def run(self, most_steps: int) -> Stretch:
        task = Task(self.length, self.keeps, self._forcing(), self.states, self.counts)
        place = Place(0, 0, self.mode, 0.0, most_steps)
        while True:
            tables = self.modes.tables
            if len(self.work.screened) != tables.screen.shape[2]:
                self.work = self.work._replace(screened=np.empty(tables.screen.shape[2]))
            reason, place, fired, jumped = integrate(tables, self.work, self.log, place, task)
            done, row, self.mode, time, _ = place
            if reason == LOG_FULL:
                self.log = self.log.doubled()
                continue
            if reason != TO_DECIDE:
                return self._stretch(_ENDINGS[reason], done, row, time)
            if not self._is_finite(done, time):
                return self._stretch(Ending.CHATTERING, done, row, time)
            try:
                row = self._decide(done, row, time, fired, jumped)
            except ArithmeticError:
                return self._stretch(Ending.UNDECIDED, done, row, time)
            place = place._replace(row=row, mode=self.mode)

    def _is_finite(self, done: int, time: float) -> bool:
        self.cascade = self.cascade + 1 if self.cascade_at == (done, time) else 0
        self.cascade_at = done, time
        return self.cascade <= LONGEST_CASCADE

    def _decide(self, done: int, row: int, time: float, fired: int, jumped: bool) -> int:
        """Do what follows an event that is not in the tables; returns the number of rows in the log."""
        while row + len(self.instant.statuses) >= len(self.log.start):
            self.log = self.log.doubled()
        function = self.modes[self.mode].functions[fired]
        at_rest = self._at_rest(function.owner if function.action == ARRIVED else None)
        alone = function.action not in (ARRIVED, AT_LIMIT) or len(at_rest) == 1
        place = self.mode, fired, int(jumped)
        if self.modes.tables.target[place] < 0 and (alone or function.action == AT_LIMIT):
            self.modes.follow(*place[:2], jumped)
        tables = self.modes.tables
        smooth = function.action == AT_LIMIT and not jumped
        if tables.target[place] >= 0 and (alone or smooth):
            return self._change(done, row, time, fired, int(jumped))
        before = self.modes[self.mode].statuses
        after, zeros = self._joint(before, function.signs, function.action, jumped, at_rest)
        return self._change_together(done, row, time, fired, (before, after), zeros, at_rest)

    def _at_rest(self, arrived: int | None) -> Places:
        contacts, tables = len(self.modes.machine.stiffness), self.modes.tables
        state, statuses = self.work.state, self.modes[self.mode].statuses
        at_rest = {
            part
            for part in range(contacts, len(statuses))
            if statuses[part] == STICK or self.work.known_zeros[part] > 0 or part == arrived
        }
        for number, function in enumerate(self.modes[self.mode].functions):
            if function.action == ARRIVED:
                sizes = tables.sizes[self.mode, number, :, :2].sum(axis=1)
                if abs(function.row @ state) <= AT_REST * (sizes @ abs(state)):
                    at_rest.add(function.owner)
        return np.array(sorted(at_rest), dtype=np.intp) - contacts

    def _joint(
        self, before: tuple[int, ...], signs: tuple[int, ...], action: int, jumped: bool, at_rest: Places
    ) -> tuple[tuple[int, ...], int]:
        """Return the statuses after frictions at rest decided together, and zeros of those that slide."""
        machine, state = self.modes.machine, self.work.state
        if action == ARRIVED:
            return decide(machine, before, state, at_rest), 1
        if jumped:
            after = decide(machine, before, state, at_rest)
            if after != before:
                return after, 1
        contacts = len(machine.stiffness)
        sliding = [friction for friction, sign in enumerate(signs) if sign]
        after = tuple(
            (0 if signs[part - contacts] > 0 else 1) if part >= contacts and signs[part - contacts] else each
            for part, each in enumerate(before)
        )
        if not (machine.static[sliding] > machine.kinetic[sliding]).any():
            return after, 2
        others = np.array([each for each in at_rest if each not in sliding], dtype=np.intp)
        return (decide(machine, after, state, others) if len(others) else after), 1

    def _change(self, done: int, row: int, time: float, fired: int, flavour: int) -> int:
        """Change the mode as the tables say, in the same way as the compiled code does."""
        tables, work, place = self.modes.tables, self.work, (self.mode, fired, flavour)
        target, owner = int(tables.target[place]), int(tables.owner[self.mode, fired])
        kind = int(tables.kind[place])
        if flavour and tables.action[self.mode, fired] == AT_LIMIT:
            kind = self._turned_back(done, row, time, owner, target, kind)
        self._enter(target)
        work.known_action[owner], work.known_zeros[owner] = (
            tables.known_action[place],
            tables.known_zeros[place],
        )
        if kind == CONTACT_BROKEN and tables.relaxation[target, owner] > 0:
            stretch = abs(work.state[tables.relaxing_state[owner]])
            work.negligible[owner] = NEGLIGIBLE_STRETCH * (tables.gap[owner] + stretch)
        return self._write(done, row, time, owner, kind, fired)

    def _turned_back(self, done: int, row: int, time: float, owner: int, target: int, kind: int) -> int:
        log = self.log
        last = row - 1
        while last > 0 and log.kind[last] == NOTHING and log.start[last] == time:
            last -= 1
        if (log.kind[last], log.part[last], log.start[last]) != (STICK_BEGUN, owner, time):
            return kind
        log.kind[last] = NOTHING
        self.counts[done, STICK_BEGUN] -= 1
        before = self.modes.tables.statuses[log.mode[last - 1], owner]
        return NOTHING if before == self.modes.tables.statuses[target, owner] else REVERSED

    def _change_together(
        self,
        done: int,
        row: int,
        time: float,
        fired: int,
        change: tuple[tuple[int, ...], tuple[int, ...]],
        zeros: int,
        at_rest: Places,
    ) -> int:
        before, after = change
        contacts, work = len(self.modes.machine.stiffness), self.work
        self._enter(self.modes.number(after))
        for friction in at_rest:
            part = contacts + int(friction)
            if after[part] == STICK:
                work.known_zeros[part] = 0
            elif before[part] != after[part] or zeros == 1:
                work.known_action[part], work.known_zeros[part] = ARRIVED, zeros
        changed = [part for part in range(len(after)) if before[part] != after[part]]
        for part in changed or [-1]:
            row = self._write(done, row, time, part, _kind(before, after, part), fired)
            fired = -1
        return row

    def _enter(self, mode: int) -> None:
        self.mode = mode
        self.work.state[:] = self.modes[mode].hold @ self.work.state

    def _write(self, done: int, row: int, time: float, part: int, kind: int, fired: int) -> int:
        log = self.log
        log.start[row], log.mode[row], log.state[row] = time, self.mode, self.work.state
        log.part[row], log.kind[row], log.function[row] = part, kind, fired
        self.counts[done, kind] += 1
        return row + 1

    def _stretch(self, ending: Ending, done: int, row: int, time: float) -> Stretch:
        free, work = self.modes.layout.state_count, self.work
        periods, phase = self._place(done, 0.0 if done == len(self.counts) else time)
        end = replace(
            self.instant,
            state=work.state[:free].copy(),
            statuses=self.modes[self.mode].statuses,
            periods=self.instant.periods + periods,
            phase=phase,
            known_zeros=work.known_zeros.copy(),
            known_action=work.known_action.copy(),
            negligible=work.negligible.copy(),
        )
        return Stretch(
            end,
            ending,
            self.log.first(row),
            self.states[: done + 1],
            self.counts[: min(done + 1, len(self.counts))],
        )

    def _place(self, done: int, time: float) -> tuple[int, float]:
        """Return the drive periods that are over since the start, and the time in the next one, s."""
        period = self.modes.layout.period
        if self.length == period:
            return done, self.begin + time
        phase = self.begin + done * self.length + time
        return (1, phase - period) if period and phase >= period else (0, phase)


def _kind(before: tuple[int, ...], after: tuple[int, ...], part: int) -> int:
    if part < 0:
        return NOTHING
    if after[part] == STICK:
        return STICK_BEGUN
    return STICK_ENDED if before[part] == STICK else REVERSED
