"""The result of a simulation: events, and the exact state at any time."""

from __future__ import annotations

from collections.abc import Iterator, Mapping
from dataclasses import dataclass, field, replace
from enum import Enum
from functools import cached_property
from typing import TYPE_CHECKING, Any

import numpy as np

from trimmer.hybrid.nodes import sample
from trimmer.loops.components.relay_component import HELD, RelayComponent
from trimmer.loops.components.switched_component import EventKind
from trimmer.loops.integration import renumbered, visited
from trimmer.loops.loop_signal import LoopSignal, row_in_modes
from trimmer.loops.system import KINDS
from trimmer.motion.motion import EventTable, Motion, ordered
from trimmer.showing.shown import ShownFields
from trimmer.showing.table import Column, Table, attributes

if TYPE_CHECKING:
    from numpy.typing import ArrayLike

    from trimmer.arrays import Reals
    from trimmer.hybrid.work import Log
    from trimmer.loops.energy import EnergyBalance
    from trimmer.loops.loops import Loop
    from trimmer.motion.signals import Signal


class Outcome(Enum):
    """How a simulation ended.

    CHATTERING: the events accumulate (Zeno), as under a relay and friction that bring a body to rest by ever
    shorter swings. UNRESOLVED ends a motion at the event where a pin is farther than 1e13 gaps from zero. For
    no backlash at all leave the element out.
    """

    COMPLETED = "reached the end"
    CHATTERING = "events accumulate at one instant: the motion cannot be continued beyond it"
    UNRESOLVED = "a pin has gone farther than 1e13 gaps: double precision does not tell their sides apart"
    EVENT_LIMIT = "reached the greatest number of events"
    DIVERGED = "a state grew beyond 1e150: the loop is unstable, and the motion is not followed further"
    INTERRUPTED = "interrupted"
    STEP_LIMIT = "reached the greatest number of steps: the fastest mode is too fast for the duration"


KINDS_BY_NUMBER = {number: kind for kind, number in KINDS.items()}
EVENT_COLUMNS = (
    *attributes(time="s"),
    Column("kind", "", lambda event: event.kind.value),
    *attributes(component="", mode=""),
)


@dataclass(frozen=True)
class Event(ShownFields):
    """A change of mode.

    Attributes:
        time: Time since the start of the motion, s.
        kind: Kind of the event.
        component: Label of the component that changes its mode.
        mode: Name of its mode afterwards.
    """

    time: float
    kind: EventKind
    component: str
    mode: str


class Events(EventTable[Event]):
    """Events in order of time, which are a table too."""

    __slots__ = ()

    def _table(self) -> Table:
        return Table("Events", self, EVENT_COLUMNS)


@dataclass(frozen=True, eq=False, repr=False)
class LoopMotion(Motion):
    """A simulated motion, exact between and at its events.

    ``plot`` draws the output, and input and output of the element, over time, with contact and stick marked.

    Attributes:
        loop: The loop that moved.
        duration: End of the motion, s; less than asked for if ``outcome`` is not COMPLETED.
        outcome: How the simulation ended.
        log: The segments between events, as the compiled integration wrote them.
    """

    loop: Loop
    duration: float
    outcome: Outcome
    log: Log = field(repr=False)

    @cached_property
    def events(self) -> Events:
        """All events in order of time; simultaneous ones in the order in which they take effect.

        What a friction or relay does at one instant is one event, if it is in another mode afterwards. That a
        load in the gap has come to rest, to rounding, is no event.
        """
        listed: list[_Listed] = []
        at_instant = 0
        for segment in range(1, len(self.log.start)):
            if self.log.start[segment] > self.log.start[segment - 1]:
                at_instant = len(listed)
            for change in self._changes(segment):
                _list(listed, at_instant, change)
        modes = self.loop.modes
        return Events(
            Event(
                time=each.time,
                kind=each.kind,
                component=modes.system.interconnection.labels[each.component],
                mode=modes.system.interconnection.components[each.component].mode_names[each.after],
            )
            for each in listed
        )

    @cached_property
    def energy(self) -> EnergyBalance:
        """The energy balance of a trimmer from start to end.

        Raises:
            UnsupportedMotionError: if it is the motion of another loop.
        """
        from trimmer.loops.energy import balance_of

        return balance_of(self)

    @property
    def event_times(self) -> Reals:
        """Times of ``events``, s, shape (number of events,)."""
        return np.array([event.time for event in self.events])

    @property
    def success(self) -> bool:
        """Whether the motion reached the end that was asked for."""
        return self.outcome is Outcome.COMPLETED

    def __getstate__(self) -> dict[str, Any]:
        """Return what is pickled: the numbers of modes mean something to their loop alone."""
        return {**vars(self), "visited": visited(self.log, self.loop.modes)}

    def __setstate__(self, state: dict[str, Any]) -> None:
        """Take what was pickled, and tabulate again the modes that the motion goes through."""
        log = renumbered(state["log"], state.pop("visited"), state["loop"].modes)
        vars(self).update(state, log=log)

    @property
    def touches(self) -> int:
        """How many times an event function came to zero, to rounding, without crossing (grazing contact)."""
        return int(self.log.touches.sum())

    def state(self, times: ArrayLike) -> Reals:
        """Return the states of the linear system, of shape (n,) + shape of the times (s).

        Raises:
            ValueError: see ``values``.
        """
        layout = self.loop.modes.system.layout
        rows = np.eye(layout.order, layout.size)
        return self.values(times, lambda mode: rows)

    def output(self, times: ArrayLike) -> Reals:
        """Return the output y of the linear system, its first one, in the shape of the times (s).

        Raises:
            ValueError: see ``values``.
        """
        return self._values(row_in_modes(self.loop, LoopSignal.OUTPUT), times)

    def element_input(self, times: ArrayLike) -> Reals:
        """Return the input of the nonlinear element, the first one, in the shape of the times (s).

        Raises:
            ValueError: see ``values``.
        """
        return self._values(row_in_modes(self.loop, LoopSignal.ELEMENT_INPUT), times)

    def element_output(self, times: ArrayLike) -> Reals:
        """Return the output of the nonlinear element, the first one, in the shape of the times (s).

        Raises:
            ValueError: see ``values``.
        """
        return self._values(row_in_modes(self.loop, LoopSignal.ELEMENT_OUTPUT), times)

    def component_outputs(self, times: ArrayLike) -> Reals:
        """Return the output of every component, in the order of ``loop.interconnection().labels``.

        For friction this is its force, also while it sticks, where the force is what holding needs. Where
        several stick and the motion does not determine how they share the force, it is the share within the
        limits that ``trimmer.hybrid.dry_friction.admissible_split`` gives. Shape (components,) +
        shape of the times (s).

        Raises:
            ValueError: see ``values``.
        """
        modes = self.loop.modes
        values = self.values(times, lambda mode: np.array([each.output for each in modes[mode].signals]))
        coupled = modes.system.coupled
        if coupled.members:
            flat, instants = values.reshape(len(values), -1), np.ravel(np.asarray(times, dtype=float))
            segments = np.searchsorted(self.log.start, instants, side="right") - 1
            for place, number in enumerate(self.log.mode[segments]):
                flat[:, place] = coupled.shared(modes.statuses[int(number)], flat[:, place])
        return values

    def values(self, times: ArrayLike, rows_of: Signal) -> Reals:
        """Return rows of the extended state, which may differ from mode to mode, at times (s).

        At an event they are those just after it.

        Args:
            times: Instants, s, of any shape and order, from 0 to ``duration``.
            rows_of: Function from the number of a mode to its rows, an array (p, n).

        Returns:
            Array of shape (p,) + shape of the times.

        Raises:
            ValueError: if a time lies outside the motion, or is NaN.
        """
        instants, rising, order = ordered(times, self.duration)
        states = sample(self.loop.modes.tables, self.log, rising)
        visited = self.log.mode[np.searchsorted(self.log.start, rising, side="right") - 1]
        rows = {number: rows_of(number) for number in np.unique(self.log.mode).tolist()}
        values = np.empty((len(next(iter(rows.values()))), order.size))
        for number, of_mode in rows.items():
            values[:, order[visited == number]] = of_mode @ states[visited == number].T
        shaped: Reals = values.reshape(len(values), *instants.shape)
        return shaped

    @property
    def signals(self) -> Mapping[str, str]:
        """The unit of output, and of input and output of the element; empty where it is not known."""
        return dict.fromkeys(self.loop.signal_rows(), self.loop.length)

    def _read(self, name: str, times: ArrayLike) -> Reals:
        return self._values(self.loop.signal_rows()[name], times)

    def _values(self, row: Signal, times: ArrayLike) -> Reals:
        values: Reals
        (values,) = self.values(times, lambda mode: row(mode)[None])
        return values

    def _changes(self, segment: int) -> Iterator[_Listed]:
        """Yield what began a segment: each component that changed its mode."""
        log, system = self.log, self.loop.modes.system
        before, after = (self.loop.modes[int(log.mode[each])].statuses for each in (segment - 1, segment))
        for k, component in enumerate(system.interconnection.components):
            if before[k] != after[k]:
                relay = isinstance(component, RelayComponent)
                kind = _kind(before[k], after[k]) if relay else KINDS_BY_NUMBER[int(log.kind[segment])]
                yield _Listed(float(log.start[segment]), k, before[k], after[k], kind, relay)


@dataclass(frozen=True)
class _Listed:
    """An event, with the mode of its component before and after; ``relay``: a relay or friction."""

    time: float
    component: int
    before: int
    after: int
    kind: EventKind
    relay: bool


def _list(listed: list[_Listed], at_instant: int, change: _Listed) -> None:
    """Add a change to a list, or merge it with what the same relay did before at the same instant."""
    if change.kind is EventKind.REST:
        return
    for place in range(len(listed) - 1, at_instant - 1, -1):
        earlier = listed[place]
        if change.relay and earlier.component == change.component:
            if earlier.before == change.after:
                del listed[place]
            else:
                kind = _kind(earlier.before, change.after)
                listed[place] = replace(earlier, after=change.after, kind=kind)
            return
    listed.append(change)


def _kind(before: int, after: int) -> EventKind:
    """Return what it is called when the mode of a relay changes."""
    if after == HELD:
        return EventKind.STICK
    return EventKind.SLIP if before == HELD else EventKind.SWITCH
