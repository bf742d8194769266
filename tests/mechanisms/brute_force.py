"""Any mechanism integrated by SciPy's DOP853, mode by mode: slow, and independent of the exact engine.

Written from the definition alone. The flow is a Runge-Kutta method's, events are found in its dense output
and polished with steps of its own, and what happens at an event is found by trying all combinations of modes.
"""

from collections.abc import Callable
from dataclasses import dataclass, field
from enum import Enum

import numpy as np
from scipy.integrate import DOP853

from tests.mechanisms.crossing import Step, Watch, watch
from tests.mechanisms.decision import Judge, NoModeFoundError
from tests.mechanisms.dynamics import Mode, System
from trimmer import Mechanism

MOST_EVENTS = 200_000
MOST_AT_ONCE = 40
SLOW = 1e-3
"""Speed of an impact, in usual ones, below which it may be that of a chatter: there the motion ends."""


class EventKind(Enum):
    """What is counted."""

    CONTACT_MADE = "contact made"
    CONTACT_BROKEN = "contact broken"
    SLIDING_REVERSED = "sliding reversed"
    STICK_BEGUN = "stick begun"
    STICK_ENDED = "stick ended"
    IMPACT = "impact"


@dataclass(frozen=True)
class Event:
    """What happened to one part."""

    time: float
    part: str
    kind: EventKind


@dataclass(frozen=True)
class Piece:
    """One step of the integrator in one mode; ``interpolated`` gives y at times, as columns."""

    begin: float
    end: float
    mode: Mode
    interpolated: Callable[[np.ndarray], np.ndarray]


@dataclass
class BruteMotion:
    """A motion."""

    system: System  # What moved
    pieces: list[Piece] = field(default_factory=list)
    events: list[Event] = field(default_factory=list)  # In order of time
    # State at the end: displacements, velocities, z
    final: np.ndarray = field(default_factory=lambda: np.zeros(0))
    # Times at which the definition leaves open what happens
    ambiguous: list[float] = field(default_factory=list)

    def states(self, times: np.ndarray) -> np.ndarray:
        """State at times, one row each: displacements, velocities, z."""
        return self._extended(times)[:, : self.system.rows.state_size]

    def accelerations(self, times: np.ndarray) -> np.ndarray:
        """Of the bodies, one row per time."""
        count = len(self.system.masses)
        return np.array(
            [
                self.system.dynamics(self._piece(time).mode).rates[count : 2 * count] @ y
                for time, y in zip(times, self._extended(times), strict=True)
            ]
        )

    def mode(self, time: float) -> Mode:
        return self._piece(time).mode

    def _extended(self, times: np.ndarray) -> np.ndarray:
        """y at times, one row each."""
        return np.array([self._piece(time).interpolated(np.array([time]))[:, 0] for time in times])

    def _piece(self, time: float) -> Piece:
        begins = self._begins()
        return self.pieces[max(int(np.searchsorted(begins, time, side="right")) - 1, 0)]

    def _begins(self) -> np.ndarray:
        return np.array([piece.begin for piece in self.pieces])


@dataclass(frozen=True)
class BruteForce:
    """The integrator."""

    # Relative tolerance of DOP853; that of displacements is also absolute, for their usual size
    tolerance: float = 1e-12

    def from_rest(self, mechanism: Mechanism, duration: float) -> BruteMotion:
        """Integrate from the mechanism's own start, by default rest."""
        system = System(mechanism)
        return self.run(system, start_state(system), 0.0, duration)

    def run(self, system: System, state: np.ndarray, begin: float, end: float) -> BruteMotion:
        """Integrate from a state, (displacements, velocities, z), at one time to another."""
        motion = BruteMotion(system, final=np.array(state, dtype=float))
        judge = Judge(
            system, near=max(1e-11, 10 * self.tolerance), derivative_near=max(1e-9, 1e3 * self.tolerance)
        )
        time, mode, at_once = begin, None, 0
        while True:
            if not self._strike(motion, time):
                motion.ambiguous.append(time - 1e-6 / system.usual_rate)
                return motion
            y = extend(system, motion.final, time)
            try:
                decided = judge.decide(y, mode)
            except NoModeFoundError:
                if not system.walls:
                    raise
                motion.ambiguous.append(time - 1e-6 / system.usual_rate)
                return motion  # Something rests on a wall.
            if decided.others:
                motion.ambiguous.append(time)
            if mode is not None:
                motion.events += changes(system, time, mode, decided.mode)
            mode = decided.mode
            motion.final = settle(system, mode, motion.final, time)
            if time >= end:
                return motion
            reached = self._until_event(motion, judge, mode, time, end)
            at_once = at_once + 1 if reached - time < 1e-12 * (end - begin) else 0
            if at_once > MOST_AT_ONCE or len(motion.events) > MOST_EVENTS:
                raise RuntimeError(f"events accumulate at {time}")
            time = reached

    def _strike(self, motion: BruteMotion, time: float) -> bool:
        """Let walls that are reached act in turn until none closes; say whether all are left fast enough."""
        system, count = motion.system, len(motion.system.masses)
        size = system.usual[: system.rows.state_size]
        reached = []
        for wall in system.walls:
            y = extend(system, motion.final, time)
            if abs(wall.beyond @ y) <= 1e-9 * size[0] and wall.velocity @ y > 0:
                reached.append(wall)
        while any(wall.velocity @ extend(system, motion.final, time) > 0 for wall in reached):
            for wall in reached:
                y = extend(system, motion.final, time)
                if wall.velocity @ y > 0:
                    motion.final = wall.struck(motion.final, y, system.mass)
                    motion.events.append(Event(time, wall.name, EventKind.IMPACT))
        y = extend(system, motion.final, time)
        return all(wall.velocity @ y < -SLOW * size[count] for wall in reached)

    def _until_event(self, motion: BruteMotion, judge: Judge, mode: Mode, time: float, end: float) -> float:
        """Add steps until a guard turns negative or the end, and return the time reached."""
        system = motion.system
        dynamics, size = system.dynamics(mode), system.rows.state_size
        matrix, drive = dynamics.rates[:size, :size], dynamics.rates[:size, size:]
        functions = system.rows.functions_of_time

        def rates(t: float, x: np.ndarray) -> np.ndarray:
            return matrix @ x + drive @ functions(t)

        def solver(begin: float, x: np.ndarray, until: float, first: float | None = None) -> DOP853:
            return DOP853(
                rates,
                begin,
                x,
                until,
                rtol=self.tolerance,
                atol=self._absolute(system),
                first_step=first,
                max_step=longest_step(system),
            )

        guards, guard_rates = dynamics.guards, dynamics.guards @ dynamics.rates
        armed = np.zeros(len(dynamics.guards), dtype=bool)
        running = solver(time, motion.final, end)
        while running.status == "running":
            x_before = running.y.copy()
            running.step()
            if running.status == "failed":
                raise RuntimeError(f"the integrator fails at {running.t}")
            step = self._step(system, running, x_before, solver)
            y = extend(system, running.y, running.t)
            positive = judge.near * judge.size(guards, y)
            seen = watch(step, Watch(guards, guard_rates, positive), armed)
            armed = seen.armed
            reached = step.end if seen.crossing is None else seen.crossing
            motion.pieces.append(Piece(step.begin, reached, mode, step.interpolated))
            motion.final = running.y if seen.crossing is None else step.exactly(reached)[:size]
            if seen.crossing is not None:
                motion.final = settle(system, mode, motion.final, reached)
                return reached
        motion.final = settle(system, mode, motion.final, end)
        return end

    def _step(
        self, system: System, running: DOP853, before: np.ndarray, solver: Callable[..., DOP853]
    ) -> Step:
        begin, dense = running.t_old, running.dense_output()

        def interpolated(times: np.ndarray) -> np.ndarray:
            return np.vstack([dense(times), system.rows.functions_of_time(times)])

        def exactly(time: float) -> np.ndarray:
            if time <= begin:
                return extend(system, before, begin)
            again = solver(begin, before, time, time - begin)
            while again.status == "running":
                again.step()
            return extend(system, again.y, time)

        return Step(begin, running.t, interpolated, exactly)

    def _absolute(self, system: System) -> np.ndarray:
        return self.tolerance * 1e-3 * system.usual[: system.rows.state_size]


def longest_step(system: System) -> float:
    omega = max(system.rows.orders, default=1) * system.rows.omega
    return np.pi / (8 * omega) if omega else np.inf


def extend(system: System, state: np.ndarray, time: float) -> np.ndarray:
    """Return y."""
    return np.concatenate([state, system.rows.functions_of_time(time)])


def start_state(system: System) -> np.ndarray:
    """Displacements, velocities and z at t = 0."""
    bodies = system.rows.bodies
    moved = [system.mechanism.start.get(name, (0.0, 0.0)) for name in bodies]
    state = np.zeros(system.rows.state_size)
    state[: 2 * len(bodies)] = np.transpose(moved).ravel()
    y = extend(system, state, 0.0)
    stretched = []
    for contact in system.contacts:
        if contact.has_state:
            beyond = [max(float(contact.beyond(side) @ y), 0.0) * side for side in contact.sides]
            stretched.append(sum(beyond))
    state[2 * len(bodies) :] = stretched
    return state


def settle(system: System, mode: Mode, state: np.ndarray, time: float) -> np.ndarray:
    """Take rounding out of what a mode holds fixed: velocities in stick, z in contact."""
    state, count = state.copy(), len(system.masses)
    dynamics = system.dynamics(mode)
    if dynamics.sticking is not None:
        y = extend(system, state, time)
        slip = np.array([system.frictions[place].velocity @ y for place in dynamics.sticking_places])
        factor = np.linalg.cholesky(system.mass)
        directions = np.linalg.solve(factor, dynamics.sticking.directions.T).T
        change = np.linalg.lstsq(directions, slip, rcond=1e-9)[0]
        state[count : 2 * count] -= np.linalg.solve(factor.T, change)
    y = extend(system, state, time)
    for contact, its in zip(system.contacts, mode.contacts, strict=True):
        if contact.has_state and its.touching:
            place = 2 * count + system.rows.relaxing.index(contact.name)
            state[place] = its.side * (contact.beyond(its.side) @ y)
    return state


def changes(system: System, time: float, before: Mode, after: Mode) -> list[Event]:
    """The events that are counted where one mode follows another."""
    events = []
    for contact, old, new in zip(system.contacts, before.contacts, after.contacts, strict=True):
        if contact.is_link:
            continue
        if old != new and old.touching:
            events.append(Event(time, contact.name, EventKind.CONTACT_BROKEN))
        if old != new and new.touching:
            events.append(Event(time, contact.name, EventKind.CONTACT_MADE))
    for friction, old, new in zip(system.frictions, before.frictions, after.frictions, strict=True):
        if old != new:
            events.append(Event(time, friction.name, _change(old, new)))
    return events


def _change(old: int, new: int) -> EventKind:
    if new == 0:
        return EventKind.STICK_BEGUN
    return EventKind.STICK_ENDED if old == 0 else EventKind.SLIDING_REVERSED
