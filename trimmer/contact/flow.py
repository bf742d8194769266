"""The exact motion of a mechanism: the interface of this package.

Times in a ``Course`` count from its start, in which whole drive periods follow each other. Between the rows
of its log the motion is linear, so it is known at all times.
"""

from __future__ import annotations

from dataclasses import dataclass, replace
from functools import cached_property
from typing import TYPE_CHECKING

import numpy as np

from trimmer.contact.assembly import force_of
from trimmer.contact.frame import Frame, frame_of
from trimmer.contact.joint import decide
from trimmer.contact.machine import machine_of
from trimmer.contact.statuses import (
    ALWAYS,
    BACKWARD,
    FORWARD,
    FREE,
    MINUS,
    PLUS,
    RELAXES,
    RELAXING,
    RELEASED_MINUS,
    RELEASED_PLUS,
    STICK,
    TRUNCATES,
)
from trimmer.contact.system import MechanismSystem
from trimmer.hybrid.advance import MOST_STEPS, Ending, Instant, advance
from trimmer.hybrid.nodes import Nodes, nodes, sample
from trimmer.hybrid.system import ARRIVED, NO_STATE, NOTHING
from trimmer.hybrid.tables import Modes
from trimmer.hybrid.tabulated_change import AT_REST
from trimmer.hybrid.variation import propagated
from trimmer.hybrid.work import Log

if TYPE_CHECKING:
    from collections.abc import Mapping

    from trimmer.arrays import Integers, Reals
    from trimmer.mechanism.mechanism import Mechanism


BLOCK = 100_000
"""Steps that drive periods followed in one call of the compiled code may take: no interrupt ends it."""
NEGLIGIBLE = 1e-9
"""Share of the largest velocity of a motion below which the mean velocity is rounding."""


@dataclass(frozen=True, eq=False)
class Course:
    """A motion between two instants.

    Attributes:
        modes: The modes of the mechanism.
        begin: The instant at which it begins.
        end: The instant at which it ends.
        ending: Why it ends there.
        duration: s.
        log: Its segments; times count from its start.
    """

    modes: Modes[MechanismSystem]
    begin: Instant
    end: Instant
    ending: Ending
    duration: float
    log: Log

    @cached_property
    def nodes(self) -> Nodes:
        """The motion at the nodes of quadrature."""
        return nodes(self.modes.tables, self.log, self.duration)

    def states(self, times: Reals) -> Reals:
        """Return the extended states, (times, N), at times, s, that do not decrease."""
        return sample(self.modes.tables, self.log, times)

    def turned(self, time: float, phase: float) -> Course:
        """Return a motion that repeats after whole drive periods as one that begins at a later instant of it.

        Nothing is integrated again, so that each event is there once, also where it comes to that instant.

        Args:
            time: From the start to that instant, s.
            phase: Time of that instant since the start of a drive period, s.
        """
        count, log = int(np.searchsorted(self.log.start, time, side="right")), self.log
        (extended,) = self.states(np.array([time]))
        mode = int(log.mode[count - 1])
        cut = Log._make(each[count - 1 : count].copy() for each in log)
        cut.start[:], cut.state[:], cut.part[:], cut.kind[:], cut.function[:] = 0.0, extended, -1, NOTHING, -1
        later = log._replace(start=log.start - time), log._replace(start=log.start + self.duration - time)
        turned = cut, Log._make(each[count:] for each in later[0]), later[1].first(count)
        begin = replace(
            self.begin,
            state=extended[: self.modes.system.layout.state_count],
            statuses=self.modes[mode].statuses,
            periods=0,
            phase=phase,
            zeros=np.zeros_like(self.begin.zeros),
        )
        end = replace(begin, periods=self.end.periods - self.begin.periods)
        joined = Log._make(np.concatenate(arrays) for arrays in zip(*turned, strict=True))
        return replace(self, begin=begin, end=end, log=joined)

    def tangents(self, at_start: Reals) -> Reals:
        """Return what becomes of small distances of the state, (n, columns), over the motion.

        In a frame that follows leaders a distance in which all that they lead is shifted is none.
        """
        frame = self.modes.system.layout.frame
        at_start = frame.reduced(at_start.T).T if frame.follows else at_start
        return propagated(self.modes, self.log, self.duration, at_start)

    @property
    def monodromy(self) -> Reals:
        """The derivative of the state at the end by that at the start, (n, n)."""
        return self.tangents(np.eye(self.modes.system.layout.state_count))

    @property
    def times(self) -> Reals:
        """Times, s, at which its mode changes, in their order."""
        times: Reals = self.log.start[(self.log.kind != NOTHING) | (self.log.function >= 0)]
        return times

    @property
    def events(self) -> list[tuple[float, int, int]]:
        """Time, s, part and kind of each event that counts."""
        rows = np.flatnonzero(self.log.kind != NOTHING)
        return [
            (float(self.log.start[row]), int(self.log.part[row]), int(self.log.kind[row])) for row in rows
        ]


@dataclass(frozen=True, eq=False)
class Strobe:
    """A motion seen once a drive period.

    Attributes:
        states: At the start and after each period, (periods + 1, n).
        counts: Events of each period by kind, (periods, kinds).
        end: The instant at which it ends.
        ending: Why it ends there.
    """

    states: Reals
    counts: Integers
    end: Instant
    ending: Ending


@dataclass(frozen=True, eq=False)
class ExactFlow:
    """The exact motion of one mechanism.

    The state of n entries holds the displacements of the bodies, m, their velocities, m/s, and the stretches
    of relaxing springs, m, plays before stops, in the order of the mechanism.

    Attributes:
        mechanism: The mechanism.
        frame: In which displacements are; that of the ground if not given.
    """

    mechanism: Mechanism
    frame: Frame | None = None

    @classmethod
    def returning(cls, mechanism: Mechanism) -> ExactFlow:
        """Return the motion in the frame in which it repeats, if it does: see ``trimmer.contact.frame``."""
        return cls(mechanism, frame_of(mechanism))

    @cached_property
    def modes(self) -> Modes[MechanismSystem]:
        """The modes that were met so far, with their ``system``."""
        return Modes(MechanismSystem(*machine_of(self.mechanism, self.frame)))

    @property
    def size(self) -> int:
        """Number n of states."""
        return self.modes.system.layout.state_count

    @property
    def period(self) -> float:
        """Period of the drive, s; 0 without one."""
        return self.modes.system.layout.period

    @cached_property
    def names(self) -> tuple[str, ...]:
        """What the states are, such as ``motor``, ``motor'`` and ``bridge``."""
        layout = self.modes.system.layout
        return (*layout.bodies, *(f"{body}'" for body in layout.bodies), *layout.relaxing)

    def rest(self, start: Mapping[str, tuple[float, float]] | None = None) -> Instant:
        """Return the instant t = 0 at which bodies have given displacements, m, and velocities, m/s.

        The others are where the mechanism's own start puts them, or at rest at 0.
        """
        layout = self.modes.system.layout
        count = len(layout.bodies)
        state = np.zeros(self.size)
        for name, (displacement, velocity) in {**self.mechanism.start, **(start or {})}.items():
            body = layout.bodies.index(name)
            state[body], state[count + body] = displacement, velocity
        return self.at(state, stretched=False)

    def at(
        self, state: Reals, phase: float = 0.0, stretched: bool = True, like: Instant | None = None
    ) -> Instant:
        """Return the instant at which the mechanism is in a given state.

        Args:
            state: Displacements, velocities and, if ``stretched``, stretches of relaxing springs, (n,).
            phase: Time since the start of a drive period, s.
            stretched: Whether the stretches are given; otherwise the springs are as short as can be.
            like: An instant of a neighbouring motion, whose contacts hold and whose frictions stick in this
                one too; the state is made to fit.
        """
        machine, layout = self.modes.system.machine, self.modes.system.layout
        extended = np.concatenate([state, layout.forcing_at(phase)])
        if like is not None:
            held = self.modes[self.modes.number(like.statuses)].hold @ extended
            return replace(like, state=held[: self.size], periods=0, phase=phase)
        contacts = [self._contact(contact, extended, stretched) for contact in range(len(machine.stiffness))]
        negligible = 2.0**-56 * abs(machine.contact_distance @ extended)
        speeds = machine.friction_rate @ extended
        # A wave that turns back is at rest, although the cosine of its phase is rounding.
        largest = np.concatenate([abs(extended[: self.size]), np.ones(layout.forcing)])
        sizes = abs(machine.friction_rate) @ largest
        slow = abs(speeds) <= AT_REST * sizes
        frictions = [
            STICK if rest else FORWARD if v > 0 else BACKWARD for v, rest in zip(speeds, slow, strict=True)
        ]
        statuses = (*contacts, *frictions)
        if slow.any():
            statuses = decide(machine, statuses, extended, np.flatnonzero(slow))
        zeros = np.zeros((len(statuses), self.modes.system.action_count), dtype=np.int64)
        begun = [len(contacts) + i for i in np.flatnonzero(slow) if statuses[len(contacts) + i] != STICK]
        zeros[begun, ARRIVED] = 1
        return Instant(extended[: self.size], statuses, 0, phase, zeros, negligible)

    def _contact(self, contact: int, extended: Reals, stretched: bool) -> int:
        """Return the status of a contact, and set the stretch of its spring if that is not given."""
        machine = self.modes.system.machine
        z = machine.relaxing_state[contact]
        relaxes = z != NO_STATE
        distance = machine.contact_distance[contact] @ extended
        upper, lower = machine.offsets[contact]
        if machine.always[contact]:
            if relaxes:
                extended[z] = distance
            return ALWAYS
        nearest = distance - min(max(distance, lower), upper)
        if relaxes and not stretched:
            extended[z] = nearest
        held = relaxes and stretched and extended[z] != 0
        side = PLUS if distance >= upper else MINUS if distance <= lower else FREE
        if held:
            reach = distance - extended[z]
            side = PLUS if reach >= upper else MINUS if reach <= lower else FREE
        if side == FREE:
            return RELAXING if held else FREE
        force = force_of(machine, contact, side) @ extended
        force = force if side == PLUS else -force
        if machine.law[contact] == RELAXES:
            return side if force >= 0 else RELAXING
        if machine.law[contact] == TRUNCATES and force < 0:
            return RELEASED_PLUS if side == PLUS else RELEASED_MINUS
        return side

    def strobe(self, instant: Instant, periods: int, most_steps: int = MOST_STEPS) -> Strobe:
        """Go on for a number of drive periods, at least 1, and keep the state between them."""
        # What moves on for ever forces each period in a way of its own.
        portions = ([1] * periods if self.modes.system.layout.ramp else []) or [periods]
        states, counts, end = [instant.state[None]], [], instant
        for portion in portions:
            stretch = advance(self.modes, end, portion, self.period, False, most_steps)
            states.append(stretch.states[1:])
            counts.append(stretch.counts)
            end = stretch.end
            if stretch.ending is not Ending.REACHED_END:
                break
        return Strobe(np.concatenate(states), np.concatenate(counts), end, stretch.ending)

    def course(self, instant: Instant, periods: int, most_steps: int = MOST_STEPS) -> Course:
        """Go on for a number of drive periods, and keep the motion."""
        parts, end, ending = self._periods(instant, periods, most_steps)
        return self._joined(instant, end, ending, parts)

    def timed(self, instant: Instant, duration: float, most_steps: int = MOST_STEPS) -> Course:
        """Go on for a duration, s, and keep the motion; without a drive there are no periods."""
        if not self.period:
            stretch = advance(self.modes, instant, 1, duration, True, most_steps)
            return self._joined(instant, stretch.end, stretch.ending, [stretch.log], duration)
        whole = int(duration / self.period)
        parts, end, ending = self._periods(instant, whole, most_steps)
        rest = duration - whole * self.period
        if ending is Ending.REACHED_END and rest > 0:
            stretch = advance(self.modes, end, 1, rest, True, most_steps)
            parts.append(stretch.log._replace(start=stretch.log.start + whole * self.period))
            end, ending = stretch.end, stretch.ending
        return self._joined(instant, end, ending, parts, duration)

    def _periods(self, instant: Instant, periods: int, most_steps: int) -> tuple[list[Log], Instant, Ending]:
        """Go on for whole periods; returns the logs of the motion, its end, and why it ends."""
        logs, end, ending = list[Log](), instant, Ending.REACHED_END
        done, count = 0, 1
        while done < periods and ending is Ending.REACHED_END:
            # What moves on for ever forces each period in a way of its own.
            count = 1 if self.modes.system.layout.ramp else min(count, periods - done)
            stretch = advance(self.modes, end, count, self.period, True, most_steps, done)
            logs.append(stretch.log)
            end, ending, done = stretch.end, stretch.ending, done + count
            count = max(min(2 * count, count * BLOCK // max(stretch.steps, 1)), 1)
        return logs, end, ending

    def travelling(self, course: Course) -> tuple[ExactFlow, Course]:
        """Return a motion in the frame that moves evenly, at its leaders' mean velocities, and its flow.

        There a motion that repeats up to a shift returns to where it was; without leaders nothing changes.
        """
        frame = self.modes.system.layout.frame
        if not frame.follows or not self.shifts:
            return self, course
        bodies, nodes = len(self.modes.system.layout.bodies), course.nodes
        flow = self.moving(nodes.weights @ nodes.states[:, bodies : 2 * bodies] / course.duration)
        periods = course.end.periods - course.begin.periods
        if periods and course.end.phase == course.begin.phase:
            return flow, flow.course(course.begin, periods)
        return flow, flow.timed(course.begin, course.duration)

    @property
    def shifts(self) -> int:
        """Number of directions along which bodies may be shifted without a change of any force."""
        return len(self.modes.system.layout.frame.leading)

    def advances(self, sizes: Reals) -> bool:
        """Say whether the frame moves on, beyond rounding, beside a motion with the sizes of states, (n,)."""
        velocities = self.modes.system.layout.frame.velocities
        fastest = sizes[len(velocities) : 2 * len(velocities)].max(initial=0.0)
        return bool((abs(velocities) > NEGLIGIBLE * fastest).any())

    def reduced(self, states: Reals) -> Reals:
        """Return states, (..., n), shifted along all directions in which no force changes to leaders at 0."""
        return self.modes.system.layout.frame.reduced(states)

    def moving(self, mean: Reals) -> ExactFlow:
        """Return the same in a frame that moves evenly, at mean velocities, m/s, (bodies,), of leaders."""
        return ExactFlow(self.mechanism, self.modes.system.layout.frame.steady(mean))

    def _joined(
        self, begin: Instant, end: Instant, ending: Ending, parts: list[Log], duration: float | None = None
    ) -> Course:
        log = Log(*(np.concatenate(arrays) for arrays in zip(*parts, strict=True)))
        if duration is None or ending is not Ending.REACHED_END:
            duration = (end.periods - begin.periods) * self.period + end.phase - begin.phase
        return Course(self.modes, begin, end, ending, float(duration), log)
