"""The map of a period of a mechanism over one of its numbers."""

from __future__ import annotations

from collections import Counter
from dataclasses import dataclass, replace
from functools import cached_property

import numpy as np

from trimmer.arrays import Reals
from trimmer.branches.period_maps.period_map import Phase, Signature
from trimmer.branches.period_maps.value_rate import ValueChange
from trimmer.contact.advance import Ending, Instant
from trimmer.contact.flow import Course, ExactFlow
from trimmer.contact.frame import frame_of
from trimmer.contact.machine import machine_of
from trimmer.contact.statuses import (
    BACKWARD,
    CONTACT_MADE,
    FORWARD,
    MINUS,
    PLUS,
    RELEASED_MINUS,
    RELEASED_PLUS,
    STICK,
    STICK_BEGUN,
)
from trimmer.errors import MechanismError, UnsupportedMotionError
from trimmer.mechanism.mechanism import Mechanism

DIFFERENCE = 1e-7
"""Relative difference of the value from which the derivative by it is taken."""
MOST_STEPS = 200_000
"""Steps of a passage, after which it counts as one that cannot be followed."""
STATUSES = {
    Phase.UPPER: (PLUS,),
    Phase.LOWER: (MINUS,),
    Phase.EITHER: (PLUS, MINUS),
    Phase.STICK: (STICK,),
}
"""Statuses of a part in each phase."""
MIRRORED_CONTACT = {PLUS: MINUS, MINUS: PLUS, RELEASED_PLUS: RELEASED_MINUS, RELEASED_MINUS: RELEASED_PLUS}
MIRRORED_FRICTION = {FORWARD: BACKWARD, BACKWARD: FORWARD}


@dataclass(frozen=True, eq=False)
class MechanismMap:
    """The map of some drive periods, or of half of them with the mirror image of the end.

    Attributes:
        mechanism: The mechanism; it has a frequency.
        place: Dotted place of the number that is varied.
        scale: Magnitude of the number, in its unit, for differences.
        periods: Drive periods after which the motion repeats; odd, if mirrored.
        mirrored: Whether half a period is followed and the end taken with changed signs.
        single: The map of which this is two passages; None if it was not doubled.
    """

    mechanism: Mechanism
    place: str
    scale: float
    periods: int = 1
    mirrored: bool = False
    single: MechanismMap | None = None

    @property
    def doublings(self) -> int:
        """How often the passage was doubled."""
        return 0 if self.single is None else self.single.doublings + 1

    def doubled(self) -> MechanismMap:
        """Return the map of two passages; that of a mirrored map is a whole period without mirror."""
        periods = self.periods if self.mirrored else 2 * self.periods
        return replace(self, periods=periods, mirrored=False, single=self)

    @cached_property
    def size(self) -> int:
        """Number of states."""
        return ExactFlow.returning(self.mechanism).size

    def flow(self, value: float) -> ExactFlow:
        """Return the motion of the mechanism with a value of the number.

        Raises:
            MechanismError: if the number cannot have that value.
        """
        known = self._flows
        if value not in known:
            if len(known) > 3:
                known.pop(next(iter(known)))
            known[value] = ExactFlow.returning(self.mechanism.with_value(self.place, value))
        return known[value]

    @cached_property
    def _flows(self) -> dict[float, ExactFlow]:
        return {}

    def passage(self, value: float, state: Reals) -> MechanismPassage:
        """Follow the motion from a state over the periods.

        What is in contact or sticks at the end does so at the beginning too: a state that is not known to
        the last digit does not say it by itself.

        Raises:
            UnsupportedMotionError: if the motion cannot be followed.
            MechanismError: if the number cannot have that value.
        """
        flow = self.flow(value)
        return MechanismPassage(self, value, flow, *self.followed(flow, state))

    def followed(self, flow: ExactFlow, state: Reals, duration: float = 0.0) -> tuple[Instant, Course]:
        """Return the motion from a state, for a duration, s, if that is given, and the instant it begins at.

        Raises:
            UnsupportedMotionError: if the motion cannot be followed.
        """
        # Where in a direction along which no force changes an orbit lies does not matter: leaders are at 0.
        state = flow.reduced(state)
        begin = flow.at(state)
        course = self.course(flow, begin, duration)
        final = self.returned(flow, course.end)
        if final.statuses == begin.statuses:
            return begin, course
        return self._repeated(flow, state, final, duration) or (begin, course)

    def _repeated(
        self, flow: ExactFlow, state: Reals, final: Instant, duration: float
    ) -> tuple[Instant, Course] | None:
        """Return the motion that begins with the statuses of an end, if it ends with them again."""
        begin = flow.at(state, like=final)
        try:
            course = self.course(flow, begin, duration)
        except UnsupportedMotionError:
            return None
        return (begin, course) if self.returned(flow, course.end).statuses == final.statuses else None

    def restarted(self, value: float, state: Reals) -> tuple[MechanismMap, Reals]:
        """Return the map and the state to go on with from an orbit: the drive says where it begins."""
        return self, state

    def phases(self, value: float, state: Reals) -> list[Reals]:
        """Return the states of an orbit at which a passage may begin: the one that is known."""
        return [state]

    def neighbour(self, value: float) -> tuple[float, Mechanism]:
        """Return a value a little off, and the mechanism with that value.

        Raises:
            MechanismError: if the number can have neither of the neighbouring values.
        """
        step = DIFFERENCE * self.scale
        try:
            return value + step, self.mechanism.with_value(self.place, value + step)
        except MechanismError:
            return value - step, self.mechanism.with_value(self.place, value - step)

    def course(self, flow: ExactFlow, begin: Instant, duration: float = 0.0) -> Course:
        """Follow the motion from an instant over the periods, or for a duration, s, where one is given.

        Raises:
            UnsupportedMotionError: if the motion cannot be followed.
        """
        if duration:
            course = flow.timed(begin, duration, MOST_STEPS)
        elif self.mirrored:
            course = flow.timed(begin, 0.5 * self.periods * flow.period, MOST_STEPS)
        else:
            course = flow.course(begin, self.periods, MOST_STEPS)
        if course.ending is not Ending.REACHED_END:
            raise UnsupportedMotionError(
                f"the motion ends after {course.duration:.6g} s: {course.ending.value}"
            )
        return course

    def returned(self, flow: ExactFlow, end: Instant) -> Instant:
        """Return an end as the beginning of the next passage."""
        if not self.mirrored:
            return end
        contacts = len(flow.modes.machine.stiffness)
        statuses = tuple(
            (MIRRORED_CONTACT if part < contacts else MIRRORED_FRICTION).get(status, status)
            for part, status in enumerate(end.statuses)
        )
        return replace(end, state=-end.state, statuses=statuses)


@dataclass(frozen=True, eq=False)
class MechanismPassage:
    """The motion of a mechanism from a state over its periods.

    Attributes:
        map: The map.
        value: Value of the number that is varied.
        flow: The motion of the mechanism.
        begin: The instant at which it begins.
        course: The motion.
    """

    map: MechanismMap
    value: float
    flow: ExactFlow
    begin: Instant
    course: Course

    @property
    def sign(self) -> float:
        """Return what the end is multiplied by."""
        return -1.0 if self.map.mirrored else 1.0

    @property
    def end(self) -> Reals:
        """State at the end, shape (n,)."""
        return self.sign * self.course.end.state

    @cached_property
    def jacobian(self) -> Reals:
        """Derivative of the end by the state, n x n."""
        return self.sign * self.course.monodromy

    @property
    def monodromy(self) -> Reals:
        """The matrix whose eigenvalues are the multipliers, n x n."""
        return self.jacobian

    @cached_property
    def sizes(self) -> Reals:
        """Largest magnitude of each entry at events and at equal times, shape (n,)."""
        times = np.linspace(0.0, self.course.duration, 64)
        states = np.vstack([self.course.states(times), self.course.log.state])
        return np.asarray(abs(states).max(axis=0)[: len(self.course.end.state)])

    @cached_property
    def signature(self) -> Signature:
        """The phases that begin in it."""
        layout, log = self.flow.modes.layout, self.course.log
        names = (*layout.contacts, *layout.frictions)
        begun: Counter[tuple[str, Phase]] = Counter()
        for row in np.flatnonzero((log.kind == CONTACT_MADE) | (log.kind == STICK_BEGUN)).tolist():
            part = int(log.part[row])
            begun[names[part], self._phase(row, part)] += 1
        return begun

    def _phase(self, row: int, part: int) -> Phase:
        """Return what begins with a row of the log.

        What leaves half a period at its end comes in at its beginning on the other side, so that of a
        mirrored motion the sides are not told apart.
        """
        log = self.course.log
        if log.kind[row] == STICK_BEGUN:
            return Phase.STICK
        if self.map.mirrored:
            return Phase.EITHER
        status = self.flow.modes[int(log.mode[row])].statuses[part]
        return Phase.UPPER if status == PLUS else Phase.LOWER

    def shortest(self, part: str, phase: Phase) -> float:
        """Return how long the shortest phase of a kind lasts, or pauses, s.

        Only what begins and ends within the passage counts, and what lasts longer than rounding can tell.
        """
        layout, log = self.flow.modes.layout, self.course.log
        number = (*layout.contacts, *layout.frictions).index(part)
        statuses = self.course.modes.tables.statuses[log.mode, number]
        inside = np.isin(statuses, STATUSES[phase]).astype(np.int64)
        lengths = np.diff(log.start[np.flatnonzero(np.diff(inside)) + 1])
        return float(lengths[lengths > 0.0].min(initial=np.inf))

    @property
    def events(self) -> int:
        """Number of events."""
        return len(self.course.events)

    @cached_property
    def middle(self) -> Reals | None:
        """End of the first half, if the map was doubled, shape (n,); None otherwise."""
        if self.map.single is None:
            return None
        (state,) = self.course.states(np.array([0.5 * self.course.duration]))
        sign = -1.0 if self.map.single.mirrored else 1.0
        return np.asarray(sign * state[: self.flow.size])

    @cached_property
    def _rate(self) -> Reals:
        neighbour = self.map.neighbour(self.value)
        step = neighbour[0] - self.value
        machine, layout = machine_of(neighbour[1], frame_of(neighbour[1]))
        own = self.flow.modes.layout
        alike = (layout.size, layout.contacts, layout.frictions) == (own.size, own.contacts, own.frictions)
        if not alike or (layout.frame.leaders != own.frame.leaders).any():
            return self._difference(neighbour[1], step)
        longer = self.course.duration * (layout.period / own.period - 1.0) / step if own.period else 0.0
        return self.sign * ValueChange(self.course, machine, step, longer).rate()

    def _difference(self, mechanism: Mechanism, step: float) -> Reals:
        """Return the derivative by a difference, where a part appears or vanishes with the number."""
        flow = ExactFlow.returning(mechanism)
        duration = 0.0 if flow.period else self.course.duration
        end = self.map.course(flow, flow.at(self.begin.state), duration).end
        return np.asarray(self.sign * (end.state - self.course.end.state) / step)

    def rate(self) -> Reals:
        """Return the derivative of the end by the number that is varied, shape (n,).

        Raises:
            UnsupportedMotionError: if the neighbouring motion cannot be followed.
        """
        return self._rate
