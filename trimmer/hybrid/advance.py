"""From one instant of a motion to a later one: the compiled integration, and what it leaves to decide."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any

import numpy as np

from trimmer.arguments import LARGEST_COUNT
from trimmer.hybrid.clock import DUE, TICKED, instants
from trimmer.hybrid.integration import (
    CYCLING,
    DIVERGED,
    LOG_FULL,
    LONGEST_CASCADE,
    PERIOD_BEGUN,
    REACHED_END,
    STEP_LIMIT,
    Place,
    Task,
    integrate,
)
from trimmer.hybrid.step_event import NO_EVENT
from trimmer.hybrid.stretch import AdvanceInterrupted, Ending, Instant, Stretch
from trimmer.hybrid.system import (
    ARRIVED,
    AT_LIMIT,
    HOLD_BEGUN,
    HOLD_ENDED,
    NOTHING,
    REVERSED,
    STRUCK,
    Decision,
    JointEvent,
    ModeEquations,
)
from trimmer.hybrid.tables import UNKNOWN, Modes
from trimmer.hybrid.tabulated_change import AT_REST
from trimmer.hybrid.work import ROWS, Log, work_for
from trimmer.progress import progress_bar

if TYPE_CHECKING:
    from tqdm import tqdm

    from trimmer.arrays import Places, Reals
    from trimmer.hybrid.clock import Clock, Instants
    from trimmer.hybrid.tables import Tables
    from trimmer.hybrid.work import Work

MOST_STEPS = 20_000_000  # Steps of one integration if no number is given: some ten seconds
AT_ONCE = 1_000_000
"""Steps after which the compiled code comes back, so that an interrupt is heard: less than a second."""
MOST_TOGETHER = 6  # Decisions at one instant that are taken because events repeat each other


_ENDINGS = {REACHED_END: Ending.REACHED_END, DIVERGED: Ending.DIVERGED, STEP_LIMIT: Ending.STEP_LIMIT}


def advance(  # noqa: PLR0913
    modes: Modes[Any],
    instant: Instant,
    periods: int,
    length: float,
    keeps: bool,
    most_steps: int = MOST_STEPS,
    before: int = 0,
    *,
    forcing: Reals | None = None,
    most_events: int = LARGEST_COUNT,
    exact: bool = False,
    watched: bool = False,
) -> Stretch:
    """Go on for some periods of one length, s.

    Args:
        modes: The modes of the system; those that are met are added.
        instant: Where the motion begins.
        periods: Number of periods, at least 1.
        length: Their length, s, that of the layout's period if there are several; of a part of it otherwise.
        keeps: Whether all segments are logged.
        most_steps: Largest number of steps.
        before: Periods of the same length that the times of the log count too.
        forcing: Entries that force the states at the start of each period, (forcing,); those of the layout if
            not given.
        most_events: Largest number of rows that are logged after the first one.
        exact: Whether it is followed what times lose in rounding, for periods of many events.
        watched: Whether a progress bar shows on a terminal after two seconds.

    Raises:
        ValueError: if there is no period.
        AdvanceInterrupted: on an interrupt (Ctrl-C).
    """
    if periods < 1:
        raise ValueError(f"the number of periods must be at least 1, not {periods}")
    integration = _Integration(modes, instant, periods, length, keeps, before)
    forcing = integration.forcing() if forcing is None else forcing
    return integration.run(forcing, most_steps, most_events, exact, watched)


class _Integration:
    """The state of an integration between calls of the compiled code."""

    def __init__(
        self, modes: Modes[Any], instant: Instant, periods: int, length: float, keeps: bool, before: int
    ) -> None:
        self.modes, self.instant, self.keeps, self.before = modes, instant, keeps, before
        self.begin = instant.phase
        self.length = length
        self.mode = modes.number(instant.statuses)
        self.work = work_for(modes.tables)
        self._take(instant)
        self.states = np.empty((periods + 1, modes.system.layout.state_count))
        self.states[0] = instant.state
        self.counts = np.zeros((periods, modes.system.kind_count), dtype=np.int64)
        self.cascade: int
        self.cascade_at: tuple[int, float] | None = None
        self.continued: list[int] = []
        self.instants: Instants | None = None

    def _take(self, instant: Instant) -> None:
        free = self.modes.system.layout.state_count
        self.work.state[:free] = instant.state
        self.work.zeros[:] = instant.zeros
        self.work.negligible[:] = instant.negligible

    def forcing(self) -> Reals:
        """Return the entries that force the states at the start of each period."""
        # Ramps count the time since the start of the motion, waves that since the start of the period.
        layout, instant = self.modes.system.layout, self.instant
        forcing: Reals = layout.forcing_at(self.begin, instant.periods * layout.period)
        return forcing

    def run(self, forcing: Reals, most_steps: int, most_events: int, exact: bool, watched: bool) -> Stretch:
        reached = np.array([0.0, 0.0, self.mode, 0.0, 0.0])
        task = Task(self.length, exact, self.keeps, forcing, self.states, self.counts, reached)
        left, now = most_steps, min(most_steps, AT_ONCE)
        place = Place(0, 0, self.mode, 0.0, now)
        self.log = Log.empty(min(ROWS, most_events + 1), self.modes.system.layout.size)
        bar: tqdm[Any] | None = None
        try:
            while True:
                tables, work = self._tables()
                reason, place = integrate(tables, self._clock(most_events), work, self.log, place, task)
                self.mode, left = place.mode, left - (now - place.steps_left)
                now = min(left, AT_ONCE)
                if reason == STEP_LIMIT and left > 0:
                    if watched:
                        bar = self._bar() if bar is None else bar
                        bar.update(place.time - bar.n)
                elif (ending := self._ending(reason, place, most_events)) is not None:
                    return self._stretch(ending, place, most_steps - left)
                elif reason == LOG_FULL:
                    self.log = self.log.longer(most_events + 1)
                elif reason == CYCLING:
                    place = self._together(place, most_events, *self._cycling(place))
                else:
                    place = self._decided(place, most_events)
                place = place._replace(steps_left=now)
        except ArithmeticError:
            return self._stretch(Ending.UNDECIDED, place, most_steps - left)
        except KeyboardInterrupt as interrupt:
            # Python may not have seen yet what the compiled code has done.
            done, row, self.mode = reached[:3].astype(int).tolist()
            place = Place(done, row, self.mode, float(reached[3]), 0)
            stretch = self._stretch(Ending.INTERRUPTED, place, most_steps - left)
            raise AdvanceInterrupted(stretch) from interrupt
        finally:
            if bar is not None:
                bar.close()

    def _bar(self) -> tqdm[Any]:
        """Return a progress bar of the time reached, s; only a long motion has one."""
        return progress_bar(description="simulate", total=self.length, unit="s", unit_scale=True)

    def _tables(self) -> tuple[Tables, Work]:
        """Return the tables as they are now, and work space that fits them."""
        tables = self.modes.tables
        if len(self.work.touches) != tables.owner.shape[1]:
            self.work = self.work._replace(
                screened=np.empty(tables.screen.shape[2]), touches=np.empty(tables.owner.shape[1])
            )
        return tables, self.work

    def _clock(self, most_events: int) -> Clock | None:
        """Return what is due in each period at known times, None for nothing."""
        samplings = self.modes.samplings
        if samplings is None:
            return None
        if self.instants is None:
            self.instants = self._instants(most_events)
        return samplings.clock._replace(**self.instants._asdict())

    def _instants(self, most_events: int) -> Instants:
        """Return when something is due in each period; each is forced as the others are.

        What comes after the greatest number of events is left out, which are too many to be listed.
        """
        clockwork, instant, layout = self.modes.system.clockwork, self.instant, self.modes.system.layout
        fastest = min(each.sample for each in clockwork.samplers)
        length = min(self.length, (most_events + 2) * fastest) if self.keeps else self.length
        return instants(clockwork.samplers, layout.clock(instant.periods, instant.phase), length)

    def _ending(self, reason: int, place: Place, most_events: int) -> Ending | None:
        """Return why the motion ends, None if it goes on."""
        if reason in _ENDINGS:
            return _ENDINGS[reason]
        if self.keeps and place.row + (reason == LOG_FULL) > most_events:
            return Ending.EVENT_LIMIT
        if reason == LOG_FULL:
            return None
        nobody = reason == CYCLING and not self._cycling(place)[0].size
        return Ending.CHATTERING if nobody or not self._is_finite(place, reason) else None

    def _is_finite(self, place: Place, reason: int) -> bool:
        now = place.done, place.time
        more = LONGEST_CASCADE // MOST_TOGETHER if reason == CYCLING else 1
        self.cascade = self.cascade + more if self.cascade_at == now else 0
        self.cascade_at = now
        return self.cascade <= LONGEST_CASCADE

    def _decided(self, place: Place, most_events: int) -> Place:
        """Tabulate what follows an event, or do it where several parts at rest have a say."""
        if place.row >= len(self.log.start):
            self.log = self.log.longer(most_events + 1)
        if place.fired == DUE:
            return place
        mode, event = self.modes[self.mode], (self.mode, place.fired, int(place.jumped))
        function = mode.functions[place.fired]
        at_rest, alone = None, function.action not in (ARRIVED, AT_LIMIT)
        if function.action == STRUCK and self.modes.tables.target[event] != UNKNOWN:
            # What the tables say was not enough to go on.
            return self._together(place, most_events, self._at_rest(None))
        if not alone:
            at_rest = self._at_rest(function.owner if function.action == ARRIVED else None)
            alone = not {*at_rest.tolist()} - {*mode.held, function.owner}
        if alone or (function.action == AT_LIMIT and not place.jumped):
            self.modes.follow(self.mode, place.fired, place.jumped)
            if self.modes.tables.target[event] >= 0:
                return place
        return self._together(place, most_events, self._at_rest(None) if at_rest is None else at_rest)

    def _together(self, place: Place, most_events: int, at_rest: Places, dropped: int = 0) -> Place:
        """Let parts at rest decide together what they do, in place of some rows of the log."""
        mode = self.modes[self.mode]
        function = mode.functions[place.fired]
        decide, state = self.modes.system.decide, self.work.state
        decision = decide(mode, state, JointEvent(function, place.jumped, at_rest, self._held_before(place)))
        state[:] = decision.state
        more = place.row + len(decision.statuses) + len(decision.impulses)
        while more >= len(self.log.start):
            self.log = self.log.longer(max(most_events, more) + 1)
        log = self.log
        if dropped:
            first = place.row - dropped
            np.subtract.at(self.counts[place.done], log.kind[first : place.row], 1)
            mode = self.modes[int(log.mode[first - 1])]
            place = place._replace(row=first, fired=int(log.function[first]))
        row = self._change_together(place, mode, decision, at_rest)
        return place._replace(row=row, mode=self.mode, fired=NO_EVENT, jumped=False)

    def _held_before(self, place: Place) -> tuple[int, ...]:
        """Return the parts that were held before all that happens at this instant."""
        row = place.row - 1
        while row > 0 and self.log.start[row] == place.time:
            row -= 1
        return self.modes[int(self.log.mode[row])].held

    def _cycling(self, place: Place) -> tuple[Places, int]:
        """Return the parts at rest where events repeat each other, and how many last rows say what they did.

        There are none where no part that can be held has changed at this instant.
        """
        log, changed, last = self.log, set[int](), place.row
        for row in range(place.row - 1, 0, -1):
            if log.start[row] != place.time or log.function[row] <= TICKED:
                break
            number = int(log.function[row])
            function = self.modes[int(log.mode[row - 1])].functions[number] if number >= 0 else None
            if function is not None and function.action in (ARRIVED, AT_LIMIT) and function.owner >= 0:
                changed.add(function.owner)
                last = row if last == row + 1 else last
        at_rest = sorted(changed | {*self._at_rest(None).tolist()}) if changed else []
        return np.array(at_rest, dtype=np.intp), place.row - last

    def _at_rest(self, arrived: int | None) -> Places:
        """Return the parts whose switching functions are zero now, in order."""
        state, mode, moduli = self.work.state, self.modes[self.mode], None
        known = self.work.zeros[:, ARRIVED] > 0
        at_rest = {*mode.held, *np.flatnonzero(known).tolist()} | (
            {arrived} if arrived is not None else set()
        )
        for number, function in enumerate(mode.functions):
            if function.action == ARRIVED:
                moduli = self.modes.moduli(self.mode, state) if moduli is None else moduli
                if abs(function.row @ state) <= AT_REST * moduli[number]:
                    at_rest.add(function.owner)
        return np.array(sorted(at_rest), dtype=np.intp)

    def _change_together(self, place: Place, mode: ModeEquations, decision: Decision, at_rest: Places) -> int:
        """Change the mode, and log what each part does in a row of its own; returns the number of rows."""
        before, after, zeros, work = mode.statuses, decision.statuses, decision.zeros, self.work
        self.mode = self.modes.number(after)
        following = self.modes[self.mode]
        work.state[:] = following.hold @ work.state
        for part in at_rest.tolist():
            if part in following.held:
                work.zeros[part] = 0
            elif before[part] != after[part] or zeros == 1:
                work.zeros[part], work.zeros[part, ARRIVED], work.zeros[part, STRUCK] = 0, zeros, zeros + 1
        changed = [part for part in range(len(after)) if before[part] != after[part]]
        happened = [(each.part, each.kind, each.state) for each in decision.impulses]
        happened += [(part, _kind(mode, following, part), work.state) for part in changed]
        happened = happened or [(-1, NOTHING, work.state)]
        if decision.impulses:
            work.zeros[:] = 0
        for part, action, count in decision.known:
            work.zeros[part, action] = count
        for row, (part, kind, state) in enumerate(happened, start=place.row):
            log = self.log
            log.start[row], log.mode[row], log.state[row] = place.time, self.mode, state
            log.part[row], log.kind[row] = part, kind
            log.function[row], log.touches[row] = place.fired if row == place.row else NO_EVENT, 0
            self.counts[place.done, kind] += 1
        row = place.row + len(happened)
        self.log.state[row - 1] = work.state
        self.continued.append(row)
        return row

    def _stretch(self, ending: Ending, place: Place, steps: int) -> Stretch:
        free, work, done = self.modes.system.layout.state_count, self.work, place.done
        within = 0.0 if done == len(self.counts) else place.time
        periods, phase = self._reached(done, within)
        end = Instant(
            work.state[:free].copy(),
            self.modes.statuses[self.mode],
            self.instant.periods + periods,
            phase,
            work.zeros.copy(),
            work.negligible.copy(),
        )
        return Stretch(
            end,
            ending,
            self._timed(self.log.first(place.row)),
            self.states[: done + 1],
            self.counts[: done + 1],
            steps,
            float(done * self.length + within),
        )

    def _timed(self, log: Log) -> Log:
        """Return a log with times since the start of all; before, each is since that of its period."""
        begun = log.function == PERIOD_BEGUN
        log.function[begun] = NO_EVENT
        if self.keeps and (self.before or len(self.counts) > 1):
            # What was decided together at the start of a period goes on in it.
            begun[[row for row in self.continued if row < len(begun)]] = False
            log.start[:] += (np.cumsum(begun) - 1 + self.before) * self.length
        return log

    def _reached(self, done: int, time: float) -> tuple[int, float]:
        """Return the drive periods that are over since the start, and the time in the next one, s."""
        period = self.modes.system.layout.period
        if self.length == period:
            return done, self.begin + time
        phase = self.begin + done * self.length + time
        over = int(phase // period) if period else 0
        return over, phase - over * period if over else phase


def _kind(before: ModeEquations, after: ModeEquations, part: int) -> int:
    """Return what a part has done; of what is never held nothing is told, as of a piece of a curve."""
    if part in after.held:
        return HOLD_BEGUN
    if part in before.held:
        return HOLD_ENDED
    may_be_held = any((each.owner, each.action) == (part, ARRIVED) for each in before.functions)
    return REVERSED if may_be_held else NOTHING
