"""The exact motion of a mechanism or a loop, of which everything else is asked."""

from __future__ import annotations

from abc import ABC, abstractmethod
from collections.abc import Callable, Mapping
from dataclasses import replace
from typing import Any

import numpy as np

from trimmer.arguments import LARGEST_COUNT
from trimmer.arrays import Complexes, Reals
from trimmer.hybrid.advance import MOST_STEPS, advance
from trimmer.hybrid.clock import TICKED
from trimmer.hybrid.stretch import Ending, Instant
from trimmer.hybrid.system import ModeEquations, System
from trimmer.hybrid.tables import Modes
from trimmer.hybrid.work import Log
from trimmer.motion.course import Course, Strobe
from trimmer.motion.part import Part
from trimmer.motion.part_measures import ContactMeasures, FrictionMeasures
from trimmer.motion.signals import Readout, Signal, Steady
from trimmer.motion.subject import Subject
from trimmer.motion.units import Units

ROUNDING = 8 * float(np.finfo(float).eps)  # Share of a time that is lost where it is the sum of several
BLOCK = 100_000  # Steps that periods followed in one call of the compiled code may take: no interrupt ends it


MADE_AGAIN = ("outputs", "accelerations", "parts")


class Flow(ABC):
    """The exact motion of a mechanism or a loop, of which everything else is asked.

    What differs between them is below: where a motion begins, what its states and parts are, and what is
    measured of it. The state of n entries holds what the system itself moves; what forces it is not in it.
    """

    def __getstate__(self) -> dict[str, Any]:
        """Return what is pickled: what is read of a motion is made again."""
        return {name: value for name, value in vars(self).items() if name not in MADE_AGAIN}

    @property
    @abstractmethod
    def subject(self) -> Subject:
        """What moves, as data."""

    @property
    @abstractmethod
    def modes(self) -> Modes[Any]:
        """The modes that were met so far, with their ``system``."""

    @property
    @abstractmethod
    def names(self) -> tuple[str, ...]:
        """What the states are, such as ``motor`` and ``motor'``."""

    @property
    @abstractmethod
    def parts(self) -> tuple[Part, ...]:
        """The parts whose statuses make a mode, in their order."""

    @property
    @abstractmethod
    def outputs(self) -> Mapping[str, Readout]:
        """What is read of the motion, by name."""

    @property
    def units(self) -> Units:
        """Units of what is measured."""
        return Units("m")

    def units_of_body(self, body: str) -> Units:
        """Return the units of a body, or of what else has an acceleration, by its name."""
        return self.units

    def units_of_part(self, part: str) -> Units:
        """Return the units of what is measured of a contact or friction, by its name."""
        return self.units

    def force_unit(self, part: str) -> str:
        """Return the unit of what a part gives, as ``forces`` has it; empty for a number."""
        return self.units_of_part(part).force

    @property
    @abstractmethod
    def accelerations(self) -> Mapping[str, Signal]:
        """Acceleration of each body, m/s² or rad/s²; none where there are no bodies."""

    @property
    @abstractmethod
    def mirrored_states(self) -> Reals:
        """Factors, 1 or -1, that make of a state that of the mirror image of a motion, (n,)."""

    @property
    @abstractmethod
    def is_mirror_symmetric(self) -> bool:
        """Whether with x(t) also its mirror image is a motion, half a period of the drive later if any."""

    @property
    @abstractmethod
    def is_bounded(self) -> bool:
        """Whether it is known that no motion can grow without bound."""

    @property
    def only_loses_energy(self) -> bool:
        """Whether it is known that a motion loses energy until it rests, or for ever."""
        return False

    @abstractmethod
    def rest(self, start: Mapping[str, tuple[float, ...]] | None = None) -> Instant:
        """Return the instant t = 0 at rest, or where the subject's own start, or another one, puts it."""

    def near(self, start: Mapping[str, tuple[float, ...]]) -> Instant:
        """Return the same, or where that cannot be the nearest instant that can."""
        return self.rest(start)

    @abstractmethod
    def at(
        self, state: Reals, phase: float = 0.0, stretched: bool = True, like: Instant | None = None
    ) -> Instant:
        """Return the instant at which the system is in a given state.

        Args:
            state: The states, (n,).
            phase: Time since the start of a period of the drive, s.
            stretched: Whether also those states are given that follow from the others in a new motion.
            like: An instant of a neighbouring motion, whose statuses hold in this one too; the state is made
                to fit.
        """

    @property
    @abstractmethod
    def axes(self) -> Mapping[str, tuple[int, ...]]:
        """Places in the state of what a start may give, by name."""

    @property
    @abstractmethod
    def axis_units(self) -> Mapping[str, tuple[str, ...]]:
        """Units of what a start may give, by name, empty for numbers."""

    @abstractmethod
    def at_other(self, subject: Subject) -> Flow:
        """Return the motion of another subject of the same kind, as of one with another number."""

    @abstractmethod
    def between(self, middle: Flow, last: Flow) -> Callable[[Callable[[], Subject], float], System] | None:
        """Return what gives a subject's equations at a share of the way from this to the last motion.

        None if something but the equations of the states changes with the number, or not evenly; the
        motion midway tells.
        """

    @abstractmethod
    def with_modes(self, subject: Callable[[], Subject], modes: Modes[Any]) -> Flow:
        """Return the motion of another subject of the same kind, whose modes are known."""

    @abstractmethod
    def damping(self, mode: ModeEquations, states: Complexes, rates: Complexes, margins: Reals) -> Reals:
        """Return the real parts of rates, (r,), of free motions, (n, r), 1/s; zero where nothing damps."""

    def without_rounding(self, sizes: Reals) -> Reals:
        """Return sizes of states, (n,), 0 for what is rounding beside others of its kind."""
        return sizes

    def is_alike(self, other: Flow) -> bool:
        """Say whether another motion of the same kind has the same states and parts."""
        return self.names == other.names and [each.name for each in self.parts] == [
            each.name for each in other.parts
        ]

    def set_free(self, begin: Instant, change: Reals) -> tuple[int, ...]:
        """Return the statuses at an instant, with what a change of the state, (n,), sets free."""
        return begin.statuses

    @property
    @abstractmethod
    def rubbing(self) -> tuple[str, ...]:
        """Names of the dry frictions, those without a force among them."""

    @abstractmethod
    def impact_speeds(self, course: Course) -> Reals:
        """Return how fast the sides of contacts meet at each impact of a motion, (impacts,)."""

    def grazed(self, course: Course) -> tuple[str, ...]:
        """Return the rigid walls, by name, that a motion touches without speed, as near as can be told."""
        return ()

    @abstractmethod
    def contacts(self, course: Course, periods: int) -> Mapping[str, ContactMeasures]:
        """Return what parts that touch do over a motion that spans some periods."""

    @abstractmethod
    def frictions(self, course: Course, periods: int) -> Mapping[str, FrictionMeasures]:
        """Return what dry frictions do over a motion that spans some periods."""

    @abstractmethod
    def positions(self, course: Course) -> Mapping[str, float]:
        """Return where what rests stands, by name, in a motion in which nothing moves."""

    @abstractmethod
    def forces(self, course: Course, times: Reals) -> Mapping[str, Reals]:
        """Return the force of each part at times, s, that do not decrease."""

    @property
    def size(self) -> int:
        """Number n of states."""
        size: int = self.modes.system.layout.state_count
        return size

    @property
    def period(self) -> float:
        """Period of the drive, s; 0 without one."""
        period: float = self.modes.system.layout.period
        return period

    @property
    def shifts(self) -> int:
        """Number of directions along which states may be shifted without a change of what moves them."""
        return 0

    def advances(self, sizes: Reals) -> bool:
        """Say whether the frame of the states moves on, beside a motion with the sizes of states, (n,)."""
        return False

    def reduced(self, states: Reals) -> Reals:
        """Return states, (..., n), shifted back along all directions in which nothing changes."""
        return states

    def grounded(self) -> Flow:
        """Return the same in the frame of the ground."""
        return self

    def moving(self, mean: Reals) -> Flow:
        """Return the same in a frame that moves evenly, at mean velocities of the states that lead."""
        return self

    def travelling(self, course: Course) -> tuple[Flow, Course]:
        """Return a motion in the frame that moves on evenly with it, and its flow."""
        return self, course

    def watched(self, instant: Instant, periods: int) -> Flow:
        """Return the motion in the frame that moves on as it does in the mean over some periods."""
        return self

    def strobe(self, instant: Instant, periods: int, most_steps: int = MOST_STEPS) -> Strobe:
        """Go on for a number of drive periods, at least 1, and keep the state between them."""
        # What moves on for ever forces each period in a way of its own.
        portions = ([1] * periods if self.modes.system.layout.drifts else []) or [periods]
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

    def timed(
        self,
        instant: Instant,
        duration: float,
        most_steps: int = MOST_STEPS,
        most_events: int = LARGEST_COUNT,
    ) -> Course:
        """Go on for a duration, s, and keep the motion; without a drive there are no periods."""
        begin, end, ending, logs = 0.0, instant, Ending.REACHED_END, list[Log]()
        for until in (*self._breaks(instant, duration), duration):
            most = most_steps, most_events - _events(logs)
            parts, end, ending = self._until(end, until - begin, *most)
            logs += [each._replace(start=each.start + begin) for each in parts] if begin else parts
            begin = until
            if ending is not Ending.REACHED_END:
                break
        course = self._joined(instant, end, ending, logs, duration)
        return course if len(logs) == 1 else self._on_the_clock(course)

    def _on_the_clock(self, course: Course) -> Course:
        """Return a motion from t = 0 whose samples have their times to the last digit, also behind breaks."""
        clockwork, log = self.modes.system.clockwork, course.log
        if clockwork is None or course.begin.periods or course.begin.phase:
            return course
        times, places = np.unique(log.start, return_inverse=True)
        ticks = np.isin(times, log.start[log.function <= TICKED])
        for each in clockwork.samplers:
            for delay in (0.0, each.delay):
                exact = np.round((times - delay) / each.sample) * each.sample + delay
                times = np.where(ticks & (abs(exact - times) <= ROUNDING * times), exact, times)
        return replace(course, log=log._replace(start=times[places]))

    def _breaks(self, instant: Instant, duration: float) -> list[float]:
        """Return the times from an instant on, s, at which what forces the states changes its course."""
        now = instant.periods * self.period + instant.phase
        times = (each - now for each in self.modes.system.layout.breaks)
        return [each for each in times if 0.0 < each < duration]

    def _until(
        self, instant: Instant, duration: float, most_steps: int, most_events: int
    ) -> tuple[list[Log], Instant, Ending]:
        """Go on for a duration, s, in which what forces the states keeps its course."""
        system = self.modes.system
        if not self.period or (system.clockwork is not None and not len(system.layout.orders)):
            stretch = advance(self.modes, instant, 1, duration, True, most_steps, most_events=most_events)
            return [stretch.log], stretch.end, stretch.ending
        whole = int(duration / self.period)
        parts, end, ending = self._periods(instant, whole, most_steps, most_events)
        rest = duration - whole * self.period
        if ending is Ending.REACHED_END and rest > 0:
            left = most_events - _events(parts)
            stretch = advance(self.modes, end, 1, rest, True, most_steps, most_events=left)
            parts.append(stretch.log._replace(start=stretch.log.start + whole * self.period))
            end, ending = stretch.end, stretch.ending
        return parts, end, ending

    def _periods(
        self, instant: Instant, periods: int, most_steps: int, most_events: int = LARGEST_COUNT
    ) -> tuple[list[Log], Instant, Ending]:
        """Go on for whole periods; returns the logs of the motion, its end, and why it ends."""
        logs, end, ending, left = list[Log](), instant, Ending.REACHED_END, most_events
        done, count = 0, 1
        while done < periods and ending is Ending.REACHED_END:
            # What moves on for ever forces each period in a way of its own.
            count = 1 if self.modes.system.layout.drifts else min(count, periods - done)
            stretch = advance(self.modes, end, count, self.period, True, most_steps, done, most_events=left)
            logs.append(stretch.log)
            left -= _events(logs[-1:])
            end, ending, done = stretch.end, stretch.ending, done + count
            count = max(min(2 * count, count * BLOCK // max(stretch.steps, 1)), 1)
        return logs, end, ending

    def _joined(
        self, begin: Instant, end: Instant, ending: Ending, parts: list[Log], duration: float | None = None
    ) -> Course:
        log = parts[0] if len(parts) == 1 else Log(*map(np.concatenate, zip(*parts, strict=True)))
        if duration is None or ending is not Ending.REACHED_END:
            duration = (end.periods - begin.periods) * self.period + end.phase - begin.phase
        return Course(self.modes, begin, end, ending, float(duration), log)


def _events(logs: list[Log]) -> int:
    """Return how many events some logs have, without the start of each."""
    return sum(len(each.start) - 1 for each in logs)


def signals_of(flow: Flow) -> Mapping[str, Readout]:
    """Return what is shown of a motion: its outputs, or the bodies of a mechanism that has none."""
    if flow.outputs:
        return flow.outputs
    size = flow.modes.system.layout.size
    return {
        name: Readout(Steady(np.eye(1, size, places[0])[0]), flow.axis_units[name][0])
        for name, places in flow.axes.items()
    }
