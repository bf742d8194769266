"""An exact periodic motion of a switched loop: period, amplitude, harmonics, stability."""

from dataclasses import dataclass, fields, replace
from functools import cached_property
from typing import Any, cast

import numpy as np

from trimmer.arrays import Complexes, Reals
from trimmer.balance.limit_cycle import LimitCycle
from trimmer.displacement import Displacement
from trimmer.loops import Drive, LoopMotion, Outcome
from trimmer.loops.flow import LoopFlow
from trimmer.loops.integration import renumbered, visited
from trimmer.loops.loop_signal import LoopSignal, row_in_modes
from trimmer.loops.loops import Loop
from trimmer.motion.extremes import extremes
from trimmer.motion.fourier import fourier
from trimmer.motion.signals import Signal, Steady, along
from trimmer.orbits.orbit_measures import ImpactEvent, impacts
from trimmer.response.periodic.orbit import Orbit
from trimmer.showing.table import Table, attributes, of_harmonics

NEUTRAL = 1e-6
"""Distance from 1 that rounding can give a multiplier; a double one is exact to the root of rounding."""


HARMONICS = 15  # Number of harmonics that an orbit of a loop gives
ORBIT_COLUMNS = attributes(
    period="s",
    frequency="Hz",
    stable="",
    largest_multiplier="",
    residual="",
    amplitude_error="",
    frequency_error="",
)


@dataclass(frozen=True, eq=False)
class Given:
    """A loop as it was given, where its orbits are computed in other states, in which less is lost.

    ``plot`` draws it in the phase plane of the element's input: its rate, m/s, over itself, m.
    """

    loop: Loop  # The loop
    states: Reals  # Matrix T of its states T z of the linear system, n x n, with the other states z

    def motion(self, orbit: Orbit) -> LoopMotion:
        """Return the motion of an orbit in the states that were given."""
        course, order = orbit.course, len(self.states)
        log = renumbered(course.log, visited(course.log, orbit.flow.modes), self.loop.modes)
        states = np.hstack([log.state[:, :order] @ self.states.T, log.state[:, order:]])
        return LoopMotion(self.loop, course.duration, Outcome.COMPLETED, log._replace(state=states))

    def row(self, row: Reals) -> Reals:
        """Return a functional of the given extended state, (N,), as one of that with the other states."""
        order = len(self.states)
        return np.concatenate([row[:order] @ self.states, row[order:]])


@dataclass(frozen=True, eq=False, repr=False)
class PeriodicOrbit(Orbit):
    """An orbit of a loop, exact to rounding.

    Its multipliers are one for each state of the linear system, one for the position of each load and, if it
    keeps its velocity for a while, one for that. Those of a load are zero if it is in contact once in a
    period. Without drive one multiplier is 1: it belongs to a shift along the orbit.

    Attributes:
        prediction: The limit cycle of harmonic balance it was found from, if any.
        given: The loop as it was given, if the orbit is that of the same loop in other states.
    """

    prediction: LimitCycle | None = None
    given: Given | None = None

    def __getstate__(self) -> dict[str, Any]:
        """Return what is pickled: the numbers of modes mean something to their loop alone."""
        own = {each.name: getattr(self, each.name) for each in fields(self)}
        statuses = visited(self.course.log, self.course.modes)
        return {**own, "course": replace(self.course, modes=cast("Any", None)), "visited": statuses}

    def __setstate__(self, state: dict[str, Any]) -> None:
        """Take what was pickled, and tabulate again the modes that the orbit goes through."""
        statuses, course, modes = state.pop("visited"), state.pop("course"), state["flow"].modes
        state["course"] = replace(course, modes=modes, log=renumbered(course.log, statuses, modes))
        vars(self).update(state)

    @property
    def loop(self) -> Loop:
        """The loop."""
        return self._computed if self.given is None else self.given.loop

    @property
    def _computed(self) -> Loop:
        return cast("Loop", self.flow.subject)

    @property
    def subject(self) -> Loop:
        """What moves: the loop."""
        return self.loop

    @cached_property
    def motion(self) -> LoopMotion:
        """The motion over one period, in the states of the loop; its events are the switching times."""
        if self.given is not None:
            return self.given.motion(self)
        return LoopMotion(self.loop, self.period, Outcome.COMPLETED, self.course.log)

    @cached_property
    def amplitude(self) -> float:
        """Half of peak to peak of the input of the nonlinear element, the first one, in its unit."""
        lowest, highest = extremes(self.course, self._row(LoopSignal.ELEMENT_INPUT))
        return 0.5 * (highest - lowest)

    @property
    def unit(self) -> str:
        """Unit of the element's input, empty where it is not known."""
        return self.loop.length

    @property
    def driven(self) -> bool:
        """Whether a drive sets the period."""
        return bool(self.periods)

    @property
    def frequency(self) -> float:
        """Frequency, 1 / period, Hz."""
        return 1.0 / self.period

    @property
    def omega(self) -> float:
        """Angular frequency, 2 π / period, rad/s."""
        return 2.0 * np.pi / self.period

    @cached_property
    def harmonics(self) -> Complexes:
        """Complex amplitudes of the element's input e at 1, 2, 3 ... times the frequency, m, shape (15,).

        e = Im Σ harmonics[n-1] exp(j n omega t), with t counted from the start of ``motion``.
        """
        return self.harmonics_of(LoopSignal.ELEMENT_INPUT)

    @property
    def has_neighbours(self) -> bool:
        """Whether it seems to be of a continuum of orbits: a second multiplier is 1 to rounding."""
        return bool((abs(self.nontrivial_multipliers - 1.0) <= NEUTRAL).any())

    @property
    def steadiness(self) -> str:
        """``stable``, ``neutral`` or ``not stable``."""
        return "stable" if self.stable else "neutral" if self.neutral else "not stable"

    @property
    def largest_multiplier(self) -> float:
        """Largest modulus of the multipliers but the trivial one: what one period leaves of a disturbance."""
        return float(abs(self.nontrivial_multipliers).max(initial=0.0))

    @property
    def switching_times(self) -> Reals:
        """Times of the events within one period, s, from the start of ``motion``."""
        return self.motion.event_times

    @property
    def amplitude_error(self) -> float:
        """Error of the predicted amplitude relative to the exact one, a number; NaN without prediction."""
        if self.prediction is None:
            return float("nan")
        return self.prediction.amplitude / self.amplitude - 1.0

    @property
    def frequency_error(self) -> float:
        """Error of the predicted frequency relative to the exact one, a number; NaN without prediction."""
        if self.prediction is None:
            return float("nan")
        return self.prediction.frequency / self.frequency - 1.0

    @property
    def drive(self) -> Drive | None:
        """The drive, the first one of several; None without one."""
        return next(iter(self.loop.driving), None)

    def stroke_of(self, signal: LoopSignal | Displacement | str = LoopSignal.OUTPUT) -> float:
        """Return peak to peak of a signal, in its unit, such as m.

        Args:
            signal: The output y, input or output of the element, a signal by name, or any displacement of
                a trimmer.

        Raises:
            UnsupportedMotionError: for a displacement, if the loop's linear system has not the states of a
                trimmer.
        """
        lowest, highest = extremes(self.course, self._row(signal))
        return highest - lowest

    def harmonics_of(self, signal: LoopSignal | Displacement | str = LoopSignal.OUTPUT) -> Complexes:
        """Return the complex amplitudes of a signal at 1, 2, 3 ... times the frequency, shape (15,).

        The signal is Im Σ c_n exp(j n omega t) + constant, with t counted from the start of ``motion``.
        Argument and errors are those of ``stroke_of``.
        """
        nodes, row = self.course.nodes, self._row(signal)
        values = along(self.course, row, nodes.rows, nodes.states)
        return np.asarray(1j * fourier(self.course, values[:, None], self.omega, HARMONICS)[:, 0])

    def _row(self, signal: LoopSignal | Displacement | str) -> Signal:
        if self.given is not None and isinstance(signal, Displacement):
            row = row_in_modes(self.given.loop, signal)(int(self.motion.log.mode[0]))
            return Steady(self.given.row(row))
        return row_in_modes(self._computed, signal)

    @cached_property
    def impacts(self) -> tuple[ImpactEvent, ...]:
        """All impacts of a period, with the speeds at which pin and load meet, in order of time."""
        return tuple(impacts(self.motion))

    @property
    def impact_speeds(self) -> Reals:
        """Speeds of the impacts of a period, m/s, in order of time."""
        return np.array([impact.speed for impact in self.impacts])

    def _told(self) -> str:
        unit = f" {self.unit}" if self.unit else ""
        return f"amplitude {self.amplitude:.6g}{unit}, {self.frequency:.6g} Hz, {self.steadiness}"

    def _table(self) -> Table:
        orders = np.arange(1, len(self.harmonics) + 1)
        return of_harmonics(
            "Harmonics of the element's input", self.frequency, self.unit, orders, self.harmonics
        )


def in_other_loop(orbit: PeriodicOrbit, loop: Loop) -> PeriodicOrbit:
    """Return an orbit as that of another loop of the same equations, states and components."""
    if orbit.given is not None:
        return replace(orbit, given=replace(orbit.given, loop=loop))
    log = renumbered(orbit.course.log, visited(orbit.course.log, orbit.course.modes), loop.modes)
    return replace(orbit, flow=LoopFlow(loop), course=replace(orbit.course, modes=loop.modes, log=log))
