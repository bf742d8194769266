"""An exact periodic motion of a switched loop: period, amplitude, harmonics, stability."""

from __future__ import annotations

from dataclasses import dataclass
from functools import cached_property
from typing import TYPE_CHECKING

import numpy as np

from trimmer.motion.loop_signal import LoopSignal, row_in_modes
from trimmer.orbits.edge import TOLD, one_sided
from trimmer.orbits.measures import harmonics
from trimmer.orbits.orbit_measures import ImpactEvent, harmonics_by_quadrature, impacts, stroke
from trimmer.orbits.return_map import arcs
from trimmer.orbits.shooting import CLOSED
from trimmer.showing.drawn import Drawn
from trimmer.showing.shown import Tabular
from trimmer.showing.table import Table, arrays, attributes

if TYPE_CHECKING:
    from trimmer.arrays import Complexes, Reals
    from trimmer.balance.limit_cycle import LimitCycle
    from trimmer.displacement import Displacement
    from trimmer.motion.loops import Drive
    from trimmer.motion.motion import Motion


NEUTRAL = 1e-6
"""Distance from 1 that rounding can give a multiplier; a double one is exact to the root of rounding."""


ORBIT_COLUMNS = attributes(
    amplitude="m",
    period="s",
    frequency="Hz",
    stable="",
    largest_multiplier="",
    residual="",
    amplitude_error="",
    frequency_error="",
)


@dataclass(frozen=True, eq=False, repr=False)
class PeriodicOrbit(Tabular, Drawn):
    """A periodic solution of a closed or driven loop, exact to rounding.

    ``plot`` draws it in the phase plane of the element's input: its rate, m/s, over itself, m.

    Attributes:
        period: Period, s.
        amplitude: Half of peak to peak of the nonlinear element's input, m.
        multipliers: Floquet multipliers by falling modulus: one for each state of the linear system, one for
            the position of each load and, if it keeps its velocity for a while, one for that. Those of a load
            are zero if it is in contact once in a period. Without drive one multiplier is 1: it belongs to a
            shift along the orbit.
        driven: Whether a drive sets the period.
        residual: Largest miss of the state after one return, each entry relative to its size.
        motion: The motion over one period; its events are the switching times.
        prediction: The limit cycle of harmonic balance it was found from, if any.
    """

    period: float
    amplitude: float
    multipliers: Complexes
    driven: bool
    residual: float
    motion: Motion
    prediction: LimitCycle | None

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
        if self.driven:  # The closed form has no answer there: the drive turns with omega itself.
            return self.harmonics_of(LoopSignal.ELEMENT_INPUT)
        return harmonics(self.motion.loop.modes, arcs(self.motion.loop.modes, self.motion.log, self.period))

    @property
    def nontrivial_multipliers(self) -> Complexes:
        """The multipliers without the one that belongs to a shift along the orbit."""
        if self.driven:
            return self.multipliers
        return np.delete(self.multipliers, int(np.argmin(abs(self.multipliers - 1.0))))

    @property
    def stable(self) -> bool:
        """Whether neighbouring motions approach it: all multipliers but the trivial one have |z| < 1.

        A multiplier that is 1 to rounding neither grows nor decays; with one the answer is False.
        """
        return bool((abs(self.nontrivial_multipliers) < 1.0 - NEUTRAL).all())

    @property
    def neutral(self) -> bool:
        """Whether neighbouring motions neither leave it nor all approach it, to rounding."""
        return not self.stable and self.largest_multiplier <= 1.0 + NEUTRAL

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

    @cached_property
    def one_sided(self) -> bool:
        """Whether its multipliers hold for disturbances to one side only, as where events coincide."""
        return self.success and one_sided(self.motion)

    @property
    def success(self) -> bool:
        """Whether the state returns to rounding, as that of every orbit does that a search gives."""
        return self.residual <= CLOSED

    @property
    def message(self) -> str:
        """What came out, in words."""
        returns = f"returns after {self.period:.6g} s" if self.success else "does not return"
        told = f"the state {returns}, with a miss of {self.residual:.1e} of its size; {self.steadiness}"
        return f"{told}; {TOLD}" if self.one_sided else told

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
        """The drive, with its amplitude in m; None without one."""
        return self.motion.loop.modes.system.interconnection.drive

    def stroke_of(self, signal: LoopSignal | Displacement = LoopSignal.OUTPUT) -> float:
        """Return peak to peak of a signal, in its unit, such as m.

        Args:
            signal: The output y, input or output of the element, or any displacement of a trimmer.

        Raises:
            UnsupportedMotionError: for a displacement, if the loop's linear system has not the states of a
                trimmer.
        """
        return stroke(self.motion, row_in_modes(self.motion.loop, signal))

    def harmonics_of(self, signal: LoopSignal | Displacement = LoopSignal.OUTPUT) -> Complexes:
        """Return the complex amplitudes of a signal at 1, 2, 3 ... times the frequency, shape (15,).

        The signal is Im Σ c_n exp(j n omega t) + constant, with t counted from the start of ``motion``.
        Argument and errors are those of ``stroke_of``.
        """
        return harmonics_by_quadrature(self.motion, row_in_modes(self.motion.loop, signal))

    def phase_of(self, signal: LoopSignal | Displacement = LoopSignal.OUTPUT) -> float:
        """Return by how much the first harmonic of a signal leads the drive, rad, in (-pi, pi].

        Argument and errors are those of ``stroke_of``.

        Raises:
            ValueError: if there is no drive.
        """
        if self.drive is None:
            raise ValueError("without a drive there is nothing that a phase would be relative to")
        turn = np.exp(-1j * self.drive.phase)
        return float(np.angle(self.harmonics_of(signal)[0] * turn))

    @cached_property
    def impacts(self) -> tuple[ImpactEvent, ...]:
        """All impacts of a period, with the speeds at which pin and load meet, in order of time."""
        return tuple(impacts(self.motion))

    @property
    def impact_speeds(self) -> Reals:
        """Speeds of the impacts of a period, m/s, in order of time."""
        return np.array([impact.speed for impact in self.impacts])

    def _told(self) -> str:
        return f"amplitude {self.amplitude:.6g} m, {self.frequency:.6g} Hz, {self.steadiness}"

    def _table(self) -> Table:
        orders = np.arange(1, len(self.harmonics) + 1)
        columns = arrays(
            order=("", orders),
            frequency=("Hz", self.frequency * orders),
            amplitude=("m", np.abs(self.harmonics)),
            phase=("rad", np.angle(self.harmonics)),
        )
        return Table("Harmonics of the element's input", range(len(orders)), columns)
