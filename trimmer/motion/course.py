"""A motion between two instants, and one that is seen once a period.

Times in a ``Course`` count from its start, in which whole periods of the drive follow each other. Between the
rows of its log the motion is linear, so it is known at all times.
"""

from __future__ import annotations

from dataclasses import dataclass, replace
from typing import Any

import numpy as np

from trimmer.arrays import Integers, Reals, identity
from trimmer.hybrid.nodes import Nodes, nodes, sample
from trimmer.hybrid.stretch import Ending, Instant
from trimmer.hybrid.system import NOTHING, OWN_KINDS
from trimmer.hybrid.tables import Modes
from trimmer.hybrid.variation import propagated
from trimmer.hybrid.work import Log
from trimmer.kept_property import cached_property


@dataclass(frozen=True, eq=False)
class Course:
    """A motion between two instants."""

    modes: Modes[Any]  # The modes of the system
    begin: Instant  # The instant at which it begins
    end: Instant  # The instant at which it ends
    ending: Ending  # Why it ends there
    duration: float  # s
    log: Log  # Its segments; times count from its start

    @cached_property
    def nodes(self) -> Nodes:
        """The motion at the nodes of quadrature."""
        return nodes(self.modes.tables, self.log, self.duration)

    @cached_property
    def met(self) -> tuple[Integers, Integers]:
        """Numbers of the modes that it meets, and which of these each row of the log has."""
        return np.unique(self.log.mode, return_inverse=True)

    @cached_property
    def points(self) -> tuple[Reals, Integers, Reals]:
        """Times, rows of the log and states of nodes and of both ends of segments, in their order."""
        log, nodes = self.log, self.nodes
        until = np.append(log.start[1:], self.duration)
        lasting = np.flatnonzero(until > log.start)
        times = np.concatenate([log.start[lasting], nodes.times, until[lasting]])
        rows = np.concatenate([lasting, nodes.rows, lasting])
        order = np.lexsort((times, rows))
        states = np.concatenate([log.state[lasting], nodes.states, self.segment_ends[lasting]])[order]
        return times[order], rows[order], states

    def states(self, times: Reals) -> Reals:
        """Return the extended states, (times, N), at times, s, that do not decrease."""
        return sample(self.modes.tables, self.log, times)

    def at(self, times: Reals) -> tuple[Integers, Reals]:
        """Return rows of the log, (times,), and states in them, at times, s, that do not decrease."""
        rows = np.searchsorted(self.log.start, times, side="right") - 1
        return rows.astype(np.int64, copy=False), self.states(times)

    def instant(self, time: float) -> Instant:
        """Return a motion without a drive at a time, s, amid a segment, where nothing happens."""
        row = int(np.searchsorted(self.log.start, time, side="right")) - 1
        state = self.states(np.array([time]))[0, : self.modes.system.layout.state_count]
        statuses = self.modes[int(self.log.mode[row])].statuses
        zeros = np.zeros_like(self.end.zeros)
        return replace(self.end, state=state, statuses=statuses, phase=0.0, periods=0, zeros=zeros)

    def since(self, time: float) -> Course:
        """Return it without what was over before a time, s; times count as before."""
        row = max(int(np.searchsorted(self.log.start, time, side="right")) - 1, 0)
        return replace(self, log=Log._make(each[row:] for each in self.log))

    def turned(self, time: float, phase: float) -> Course:
        """Return a motion that repeats as one that begins at a later instant of it, s, at a phase, s.

        Nothing is integrated again, so that each event is there once, also where it comes to that
        instant.
        """
        count, rows = int(np.searchsorted(self.log.start, time, side="right")), len(self.log.start)
        (extended,) = self.states(np.array([time]))
        mode, order = int(self.log.mode[count - 1]), np.arange(count - 1, rows + count) % rows
        log = Log._make(each[order] for each in self.log)
        log.start[rows - count + 1 :] += self.duration
        log.start[:] -= time
        log.start[0], log.state[0], log.part[0], log.kind[0], log.function[0] = 0.0, extended, -1, NOTHING, -1
        begin = replace(
            self.begin,
            state=extended[: self.modes.system.layout.state_count],
            statuses=self.modes[mode].statuses,
            periods=self._later(time, phase),
            phase=phase,
            zeros=np.zeros_like(self.begin.zeros),
        )
        end = replace(begin, periods=begin.periods + self.end.periods - self.begin.periods)
        return replace(self, begin=begin, end=end, log=log)

    def _later(self, time: float, phase: float) -> int:
        """Return the periods before an instant, s, from the start; 0 where each is as the others."""
        layout, begin = self.modes.system.layout, self.begin
        return begin.periods + round((begin.phase + time - phase) / layout.period) if layout.drifts else 0

    def tangents(self, at_start: Reals) -> Reals:
        """Return what becomes of small distances of the state, (n, columns), over the motion.

        Distances that are none, since nothing depends on them, are taken out of them first.
        """
        return propagated(self.modes, self.log, self.duration, self.modes.system.layout.felt(at_start))

    @property
    def monodromy(self) -> Reals:
        """The derivative of the state at the end by that at the start, (n, n)."""
        return self.tangents(identity(self.modes.system.layout.state_count))

    def before(self, row: int) -> Reals:
        """Return the extended state, (N,), just before the event that begins a row of the log."""
        state: Reals = self._before(np.array([row]))[0]
        return state

    def _before(self, rows: Integers) -> Reals:
        """Return the extended states, (rows, N), just before what begins rows, at different instants."""
        states = np.empty((len(rows), self.log.state.shape[1]))
        for every_other in (slice(0, None, 2), slice(1, None, 2)):  # So each is over before the next begins.
            some = rows[every_other]
            segments = Log._make(each[some - 1] for each in self.log)
            states[every_other] = sample(self.modes.tables, segments, self.log.start[some])
        return states

    @cached_property
    def segment_ends(self) -> Reals:
        """Extended states at the end of each segment, just before what ends it, (rows, N)."""
        log, impulse = self.log, self.modes.system.impulse
        ends = np.vstack([log.state[1:], self.states(np.array([self.duration]))])
        held = self.modes.system.layout.holding
        ends[:, held] = log.state[:, held]  # Between samples nothing moves it.
        # Where no event begins a segment, a profile or a reference may have jumped.
        jumps = (log.kind == NOTHING) & (log.function == -1)
        for row in np.flatnonzero(log.kind >= OWN_KINDS).tolist():
            jumps[row] = impulse(int(log.part[row]), int(log.kind[row])) is not None
        rows = np.flatnonzero(jumps[1:] & (np.diff(log.start) > 0)) + 1
        ends[rows - 1] = self._before(rows)
        return ends

    @property
    def alone(self) -> Course:
        """It as if nothing happened after it has begun."""
        return replace(self, log=Log._make(each[:1] for each in self.log))

    @property
    def times(self) -> Reals:
        """Times, s, at which its mode changes, in their order."""
        times: Reals = self.log.start[(self.log.kind != NOTHING) | (self.log.function >= 0)]
        return times

    @property
    def events(self) -> list[tuple[float, int, int]]:
        """Time, s, part and kind of each event that counts."""
        log, counts = self.log, self.log.kind != NOTHING
        columns = (each[counts].tolist() for each in (log.start, log.part, log.kind))
        return list(zip(*columns, strict=True))


@dataclass(frozen=True, eq=False)
class Strobe:
    """A motion seen once a period."""

    states: Reals  # At the start and after each period, (periods + 1, n)
    counts: Integers  # Events of each period by kind, (periods, kinds)
    end: Instant  # The instant at which it ends
    ending: Ending  # Why it ends there
