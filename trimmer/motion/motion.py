"""A simulated motion of whatever moves: its events, and its signals by name."""

from __future__ import annotations

from abc import abstractmethod
from typing import TYPE_CHECKING, Any, Protocol, TypeVar

import numpy as np

from trimmer.arguments import real_values, whole_number
from trimmer.arrays import Places, Reals
from trimmer.messages import near_or_all
from trimmer.showing.drawn import Drawn
from trimmer.showing.shown import Tabular, counted
from trimmer.showing.table import Table, over_time, to_frame

if TYPE_CHECKING:
    from collections.abc import Mapping

    import pandas
    from numpy.typing import ArrayLike

AnyEvent = TypeVar("AnyEvent", covariant=True)
POINTS = 1000  # Instants that are evenly spread, if no number is given


def moments(duration: float, events: Reals, points: int) -> Reals:
    """Return instants that are evenly spread over a motion, and those of its events, s, in their order."""
    even = np.linspace(0.0, duration, whole_number("points", points, 2))
    return np.union1d(even, events)


def ordered(times: ArrayLike, duration: float) -> tuple[Reals, Reals, Places]:
    """Return times, s, as an array, then flat and rising, and the places of these in it.

    Raises:
        ValueError: if a time lies outside a motion of a duration, s, or is NaN.
    """
    instants = real_values("times", times)
    if not ((instants >= 0) & (instants <= duration)).all():
        raise ValueError(f"times must lie between 0 and the end of the motion, {duration!r} s")
    flat = instants.ravel()
    order = np.argsort(flat, kind="stable")
    return instants, np.array(flat[order], dtype=np.float64), order


class EventTable(tuple[AnyEvent, ...], Tabular):
    """Events in order of time, which are a table too."""

    __slots__ = ()

    def _told(self) -> str:
        return counted(len(self), "event")


class Energy(Protocol):
    """What the energy balances of a mechanism and of a loop have in common, J."""

    @property
    def kinetic(self) -> tuple[float, float]:
        """Kinetic energy at start and end."""

    @property
    def stored(self) -> tuple[float, float]:
        """Energy of springs at start and end."""

    @property
    def work(self) -> float:
        """Work of pins and forces together."""

    @property
    def loss(self) -> float:
        """All losses together."""

    @property
    def residual(self) -> float:
        """What does not close, as a share of the largest term."""


class Motion(Tabular, Drawn):
    """A simulated motion of a mechanism or a loop, exact between and at its events."""

    duration: Any
    """End of the motion, s; less than asked for if it ended early."""

    @property
    @abstractmethod
    def success(self) -> bool:
        """Whether it reached the end that was asked for."""

    outcome: Any
    """How it ended; its value are words."""

    @property
    def message(self) -> str:
        """How it ended, in words."""
        return str(self.outcome.value)

    @property
    @abstractmethod
    def events(self) -> EventTable[Any]:
        """All events in order of time."""

    @property
    @abstractmethod
    def energy(self) -> Energy:
        """The energy balance from start to end.

        Raises:
            UnsupportedMotionError: of a loop that is no trimmer, whose bodies are not known.
        """

    @property
    @abstractmethod
    def event_times(self) -> Reals:
        """Times of its events, s, (events,)."""

    @property
    @abstractmethod
    def signals(self) -> Mapping[str, str]:
        """The unit of each signal, by its name; empty for a number."""

    def _told(self) -> str:
        return f"{self.duration:.6g} s, {counted(len(self.events), 'event')}, {self.message}"

    def _table(self) -> Table:
        return self.events._table()

    @abstractmethod
    def _read(self, name: str, times: ArrayLike) -> Reals:
        """Return a signal that there is, in the shape of the times, s."""

    def signal(self, name: str, times: ArrayLike) -> Reals:
        """Return a signal, in its unit, in the shape of the times, s; at an event it is that just after it.

        Args:
            name: One of ``signals``: an output of a mechanism, or a body if there are none; of a loop
                ``output``, ``element_input`` or ``element_output``.
            times: From 0 to ``duration``, s, of any shape and order.

        Raises:
            ValueError: if there is no such signal, or a time lies outside the motion.
        """
        if name not in self.signals:
            raise ValueError(f"no signal is called {name!r}; {near_or_all(name, self.signals)}")
        return self._read(name, times)

    def to_dataframe(self, points: int = POINTS) -> pandas.DataFrame:
        """Return the signals over time as a data frame of pandas.

        Units are in ``attrs["units"]``. Rows are instants that are evenly spread, and those of the events,
        with the values just after each. The events themselves are in ``events.to_dataframe()``.

        Args:
            points: Instants that are evenly spread, at least 2.

        Raises:
            MissingPackageError: if pandas is not installed.
            WrongTypeError, ValueError: if ``points`` cannot be used.
        """
        times = moments(self.duration, self.event_times, points)
        signals = {name: (unit, self._read(name, times)) for name, unit in self.signals.items()}
        return to_frame(over_time("Signals over time", times, signals))
