"""A simulated motion of a mechanism: events, exact signals at any time, forces, energy balance."""

from collections.abc import Callable, Collection, Mapping
from dataclasses import dataclass
from functools import cached_property

import numpy as np
from numpy.typing import ArrayLike

from trimmer.arrays import Integers, Reals
from trimmer.choices import Choice
from trimmer.contact.flow import MechanismFlow
from trimmer.contact.machine import statuses
from trimmer.contact.readouts.curve_forces import curve_forces
from trimmer.contact.readouts.friction_forces import dry_forces, undetermined
from trimmer.contact.readouts.outputs import contact_force
from trimmer.contact.readouts.readouts import event_rates
from trimmer.contact.state.rows import EndRows
from trimmer.errors import MechanismError
from trimmer.hybrid import system
from trimmer.hybrid.stretch import Ending
from trimmer.mechanism.mechanism import Mechanism
from trimmer.messages import near_or_all
from trimmer.motion.course import Course
from trimmer.motion.flow import signals_of
from trimmer.motion.motion import EventTable, Motion, ordered
from trimmer.motion.signals import Readout, Signal, Steady, along
from trimmer.response.simulation.closings import Closing, closings
from trimmer.response.simulation.energy import MechanismEnergy, energy_of
from trimmer.response.without_events.rest import Rest
from trimmer.showing.table import Table, attributes


class MechanismEventKind(Choice):
    """What happens to a play, a stop or a friction."""

    CONTACT_MADE = "contact made"
    CONTACT_BROKEN = "contact broken"
    REVERSED = "sliding reversed"
    STICK_BEGUN = "stick begun"
    STICK_ENDED = "stick ended"
    IMPACT = "impact"
    CHATTER_COMPLETED = "chatter completed"
    REST_BEGUN = "rest begun"
    REST_ENDED = "rest ended"


KINDS = {
    statuses.CONTACT_MADE: MechanismEventKind.CONTACT_MADE,
    statuses.CONTACT_BROKEN: MechanismEventKind.CONTACT_BROKEN,
    system.REVERSED: MechanismEventKind.REVERSED,
    system.HOLD_BEGUN: MechanismEventKind.STICK_BEGUN,
    system.HOLD_ENDED: MechanismEventKind.STICK_ENDED,
    statuses.IMPACT: MechanismEventKind.IMPACT,
    statuses.COMPLETED: MechanismEventKind.CHATTER_COMPLETED,
    statuses.TOGETHER: MechanismEventKind.IMPACT,
}
KINDS_OF_WALLS = {
    **KINDS,
    system.HOLD_BEGUN: MechanismEventKind.REST_BEGUN,
    system.HOLD_ENDED: MechanismEventKind.REST_ENDED,
}

MEETINGS = (MechanismEventKind.CONTACT_MADE, MechanismEventKind.IMPACT, MechanismEventKind.CHATTER_COMPLETED)
"""Events at which the sides of a contact meet."""


@dataclass(frozen=True)
class MechanismEvent:
    """An event."""

    time: float  # Time since the start of the motion, s
    part: str  # Name of the play, stop or friction
    kind: MechanismEventKind  # What happens to it
    # Of its end less that of its start, m/s, just before an impulse; 0 where friction is held or turns back
    rate: float = 0.0
    impulse: float | None = None  # That of a wall, N s; None of what gives none
    unit: str = "m/s"  # Unit of the rate, rad/s of rotations

    @property
    def speed(self) -> float:
        """How fast its ends meet or part, m/s: the modulus of the rate."""
        return abs(self.rate)


class MechanismEvents(EventTable[MechanismEvent]):
    """Events in order of time, which are a table too."""

    __slots__ = ()

    def _table(self) -> Table:
        units = {each.unit for each in self} or {"m/s"}
        speed = units.pop() if len(units) == 1 else ""
        impulse = {"m/s": "N s", "rad/s": "N m s"}.get(speed, "")
        return Table("Events", self, attributes(time="s", kind="", part="", speed=speed, impulse=impulse))


@dataclass(frozen=True, eq=False, repr=False)
class MechanismMotion(Motion):
    """A simulated motion of a mechanism, exact between and at its events.

    ``plot`` draws the outputs, m, or the bodies if there are none, over time, with contact and stick marked.

    Attributes:
        flow: The motion of the mechanism.
        course: The motion itself.
    """

    flow: MechanismFlow
    course: Course

    @property
    def mechanism(self) -> Mechanism:
        """The mechanism."""
        return self.flow.mechanism

    @property
    def duration(self) -> float:
        """End of the motion, s; less than asked for if it ended early."""
        return self.course.duration

    @property
    def outcome(self) -> Ending:
        """Why it ends there."""
        return self.course.ending

    @property
    def success(self) -> bool:
        """Whether it reached the end that was asked for."""
        return self.outcome is Ending.REACHED_END

    @cached_property
    def events(self) -> MechanismEvents:
        """All events in order of time."""
        parts = [part.name for part in self.flow.parts]
        units = [self.flow.units_of_part(name).speed for name in parts]
        walls = len(parts) - len(self.mechanism.walls)
        events = zip(self.course.events, event_rates(self.course), strict=True)
        return MechanismEvents(
            MechanismEvent(
                *(time, parts[part], (KINDS if part < walls else KINDS_OF_WALLS)[kind], rate, impulse),
                unit=units[part],
            )
            for (time, part, kind), (rate, impulse) in events
        )

    @property
    def chatter_completed(self) -> bool:
        """Whether an infinite chatter on a wall was cut short once no time was left of it."""
        return bool((self.course.log.kind == statuses.COMPLETED).any())

    @property
    def walls_together(self) -> bool:
        """Whether walls acted together, without rebound, since their impacts would not have ended."""
        return bool((self.course.log.kind == statuses.TOGETHER).any())

    @cached_property
    def energy(self) -> MechanismEnergy:
        """The energy balance from start to end, with each loss named."""
        return energy_of(self.mechanism, self.course)

    def states(self, times: ArrayLike) -> Reals:
        """Return displacements, m, velocities, m/s, and stretches of relaxing springs, m, at times.

        Args:
            times: s, from 0 to ``duration``, of any shape and order.

        Returns:
            Array of shape (n,) + shape of the times; ``flow.names`` names the rows.

        Raises:
            ValueError: if a time lies outside the motion.
        """
        rows = np.eye(self.flow.size, self.flow.modes.system.layout.size)
        return np.array([self._signal(Steady(row), times) for row in rows])

    def output(self, name: str, times: ArrayLike) -> Reals:
        """Return an output, m, in the shape of the times, s.

        Raises:
            MechanismError: if there is no such output.
            ValueError: if a time lies outside the motion.
        """
        _require("output", name, self.flow.outputs)
        return self._read_out(self.flow.outputs[name], times)

    def displacement(self, name: str, times: ArrayLike) -> Reals:
        """Return the displacement of a body or a pin, m, in the shape of the times, s.

        Raises:
            MechanismError: if there is no such body or pin.
            ValueError: if a time lies outside the motion.
        """
        row = self._rows(name)[0]
        return self._read_out(Readout(Steady(row), "m", self.course.modes.system.layout.speeds[name]), times)

    def velocity(self, name: str, times: ArrayLike) -> Reals:
        """Return the velocity of a body or a pin, m/s, in the shape of the times, s.

        Raises:
            MechanismError: if there is no such body or pin.
            ValueError: if a time lies outside the motion.
        """
        return self._signal(Steady(self._rows(name)[1]), times)

    def contact_force(self, name: str, times: ArrayLike) -> Reals:
        """Return the force of a play or a stop, N, positive where it pulls its ends together.

        At an event it is that just after it.

        Raises:
            MechanismError: if there is no such play or stop, or it exerts no force.
            ValueError: if a time lies outside the motion.
        """
        contacts = self.course.modes.system.layout.contacts
        _require("play or stop", name, contacts)
        return self._signal(contact_force(self.course.modes, contacts.index(name)), times)

    def friction_force(self, name: str, times: ArrayLike) -> Reals:
        """Return the dry force of a friction, N, positive against an end that moves forward.

        In stick it is what holds. Of ``undetermined_frictions`` the motion gives only the sum on each body;
        their share is that with the least sum of squares relative to the static forces, none of which it
        exceeds. At an event it is the force just after it.

        Raises:
            MechanismError: if there is no such friction, or it exerts no force.
            ValueError: if a time lies outside the motion.
        """
        frictions = self.course.modes.system.layout.frictions
        _require("friction", name, frictions)
        number = frictions.index(name)
        return self._at(
            times,
            lambda rows, states: (
                dry_forces(self.course, rows, states)[:, number]
                + curve_forces(self.course, "frictions", name, rows, states)
            ),
        )

    @property
    def final(self) -> Mapping[str, tuple[float, ...]]:
        """Displacement, m, and velocity, m/s, of each body at its end."""
        state = self.course.end.state
        return {name: tuple(state[list(places)].tolist()) for name, places in self.flow.axes.items()}

    @property
    def closings(self) -> Mapping[str, Closing]:
        """How contacts close whose sides meet: when, bouncing for how long, how hard, with which force."""
        met: dict[str, list[tuple[float, float]]] = {}
        for event in self.events:
            if event.kind in MEETINGS:
                met.setdefault(event.part, []).append((event.time, event.speed))
        return closings(self.flow, self.course, met)

    @cached_property
    def rest(self) -> Rest | None:
        """Where it rests, with the forces of all parts, if it has come to rest at its end; else None."""
        from trimmer.response.settling.solved import rest_after

        return rest_after(self.flow, self.course) if self.success else None

    @cached_property
    def undetermined_frictions(self) -> tuple[str, ...]:
        """Names of the frictions that stick at some time without their force being determined by the motion.

        So it is where several hold the same bodies; see ``friction_force``.
        """
        return undetermined(self.course)

    @property
    def event_times(self) -> Reals:
        """Times at which its mode changes, s, (changes,)."""
        return self.course.times

    @property
    def signals(self) -> Mapping[str, str]:
        """The unit of each output, or body if there is no output."""
        return {name: each.unit for name, each in signals_of(self.flow).items()}

    def _read(self, name: str, times: ArrayLike) -> Reals:
        return self._read_out(signals_of(self.flow)[name], times)

    def _told(self) -> str:
        return f"{self.mechanism.title}, {super()._told()}"

    def _rows(self, name: str) -> tuple[Reals, Reals]:
        layout = self.course.modes.system.layout
        _require("body or pin", name, layout.ends)
        rows = EndRows(self.mechanism, layout)
        return rows.displacement(name), rows.velocity(name)

    def _read_out(self, readout: Readout, times: ArrayLike) -> Reals:
        """Return a readout, with what a pin that nothing leans on goes on by."""
        values = self._signal(readout.signal, times)
        return values + readout.speed * np.asarray(times) if readout.speed else values

    def _signal(self, signal: Signal, times: ArrayLike) -> Reals:
        return self._at(times, lambda rows, states: along(self.course, signal, rows, states))

    def _at(self, times: ArrayLike, values_at: Callable[[Integers, Reals], Reals]) -> Reals:
        """Return what rows of the log and extended states in them give, in the shape of the times, s."""
        instants, rising, order = ordered(times, self.duration)
        values = np.empty(len(rising))
        values[order] = values_at(*self.course.at(rising))
        return values.reshape(instants.shape)


def _require(kind: str, name: str, known: Collection[str]) -> None:
    if name not in known:
        raise MechanismError(f"no {kind} is called {name!r}; {near_or_all(name, known)}")
