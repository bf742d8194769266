"""An exact periodic motion, stable or not."""

from dataclasses import dataclass, field
from typing import cast

import numpy as np

from trimmer.arrays import Complexes, Integers, Reals
from trimmer.hybrid.stretch import Ending, Instant
from trimmer.kept_property import cached_property
from trimmer.mechanism.mechanism import Mechanism
from trimmer.motion.course import Course
from trimmer.motion.flow import Flow
from trimmer.motion.measures import Measures
from trimmer.motion.subject import Subject
from trimmer.one_orbit import SAME
from trimmer.response.periodic.edge import Edge
from trimmer.response.periodic.multipliers import multipliers_of, with_place
from trimmer.response.periodic.pace import period_word, periods_of
from trimmer.response.periodic.shooting import CLOSED, LATER, Shot
from trimmer.showing.drawn import Drawn
from trimmer.showing.shown import Tabular
from trimmer.showing.table import Column, Table, arrays

STILL = 1e-8  # Change of states as a share of their sizes that is none
NEUTRAL = 1e-6
"""Distance from 1 within which a multiplier makes the step of a branch from an orbit ill-determined."""
INSTANTS = 8  # At which a motion without events is looked at for any change
RETURNS = 64  # Returns over which the growth of small distances is followed


@dataclass(frozen=True, eq=False, repr=False)
class Orbit(Tabular, Drawn):
    """A motion that repeats, or repeats up to an advance along which no force changes.

    ``plot`` draws the first output in the phase plane: its rate, m/s, over itself, m. A dot marks the start
    of each drive period. Without outputs it is the first body that is drawn.

    Attributes:
        flow: What moves, in the frame that advances evenly with the motion, if it does.
        periods: Number of drive periods after which it was to return; 0 without a drive.
        period_count: The smallest number of drive periods after which it returns, a divisor of ``periods``;
            1 without a drive.
        course: The motion over ``periods``.
        sizes: Scale of each state, (n,).
        multipliers: Floquet multipliers over ``periods``, largest modulus first, (n,). Zeros where stick or
            contact takes a dimension away. Without a drive one of them is 1, and so is one for each
            direction in which bodies may be shifted without a change of any force.
        residual: Largest distance between end and start as a share of the sizes.
        about: What else is to be said if it was found.
        margins: Rounding of each multiplier, (n,): its condition times that of the derivative of the return,
            in which what is left of the residual counts too, and what the place of the orbit adds where a
            multiplier near 1 leaves it open. Empty for none.
    """

    flow: Flow
    periods: int
    period_count: int
    course: Course
    sizes: Reals
    multipliers: Complexes
    residual: float
    about: str = ""
    margins: Reals = field(default_factory=lambda: np.zeros(0))

    @property
    def subject(self) -> Subject:
        """What moves."""
        return self.flow.subject

    @property
    def success(self) -> bool:
        """Whether it returns."""
        return self.residual <= CLOSED

    @property
    def message(self) -> str:
        """What was found, in a sentence without a full stop, with what is known where it rests on an edge."""
        return self.sentence if self.edge is None else f"{self.sentence}; {self.edge.told}"

    @cached_property
    def sentence(self) -> str:
        """What was found, without what is known of an edge."""
        if not self.success:
            time = periods_of(self.subject, self.periods) if self.periods else f"{self.period:.6g} s"
            return (
                f"no motion that returns after {time} was found; the closest misses by "
                f"{self.residual:.1e} of its size. Begin elsewhere, or with another number of periods"
            )
        kind = "a stable" if self.stable else "a neutral" if self.neutral else "an unstable"
        if not self.periods:
            told = f"{kind} motion that repeats after {self.period:.9g} s"
        elif self.period_count < self.periods:
            count = self._periods(self.period_count)
            told = f"{kind} motion that repeats after {count} already, not {self.periods}"
        else:
            told = f"{kind} motion that repeats after {self._periods(self.periods)}"
        if self.advances:
            told += ", up to an advance"
        return f"{told}; {self.about}" if self.about else told

    def _periods(self, count: int) -> str:
        word = period_word(self.subject)
        return f"one {word}" if count == 1 else periods_of(self.subject, count)

    @property
    def instant(self) -> Instant:
        """The instant at which it begins, the start of a drive period."""
        return self.course.begin

    @property
    def period(self) -> float:
        """Time after which it returns, s: that of ``periods``, or without a drive its own period."""
        return self.course.duration

    @property
    def advances(self) -> bool:
        """Whether it repeats up to an advance: see ``OutputMeasures.advance``."""
        return self.flow.advances(self.sizes)

    @property
    def nontrivial_multipliers(self) -> Complexes:
        """The multipliers without those that are 1 because the motion may be shifted, in time or in place."""
        return np.delete(self.multipliers, self._trivial)

    @cached_property
    def _trivial(self) -> Integers:
        """Places of the multipliers that are 1 because the motion may be shifted."""
        in_time = not self.periods and self._changes
        nearest = np.argsort(abs(self.multipliers - 1), kind="stable")
        return np.asarray(nearest[: self.flow.shifts + in_time], dtype=np.int64)

    @property
    def _changes(self) -> bool:
        """Whether states change, in the frame that advances: else a shift in time is one in place."""
        if self.course.events or not self.flow.shifts:
            return True
        states = self.course.states(np.linspace(0.0, self.course.duration, INSTANTS))[:, : self.flow.size]
        return bool((np.ptp(self.flow.reduced(states), axis=0) > STILL * self.sizes).any())

    @property
    def stable(self) -> bool:
        """Whether it was found, and small disturbances die out: each modulus is below 1 by its margin."""
        return self.success and bool((self._growth_of_each < -self._judged(self.margins)).all())

    @property
    def neutral(self) -> bool:
        """Whether it was found, and no small disturbance grows, but one stays, as where friction holds.

        Then a modulus is 1 within its margin; it is never so of a stable motion.
        """
        grows = bool((self._growth_of_each > self._judged(self.margins)).any())
        return self.success and not self.stable and not grows

    @property
    def _growth_of_each(self) -> Reals:
        return np.asarray(abs(self.nontrivial_multipliers) - 1)

    def _judged(self, values: Reals) -> Reals:
        """Return those of one value for each multiplier that belong to the nontrivial ones; 0 for none."""
        if not len(values):
            return np.zeros(1)
        return np.delete(values, self._trivial)

    @property
    def events_per_period(self) -> float:
        """Number of events per drive period, the mean over the motion; without a drive per its own period."""
        return len(self.course.events) / max(self.periods, 1)

    @cached_property
    def monodromy(self) -> Reals:
        """What becomes of small distances over ``periods``, as shares of the sizes, (n, n).

        Shifts along which no force changes are left out.
        """
        change = self.flow.reduced(self.course.monodromy.T).T
        matrix: Reals = change * self.sizes / self.sizes[:, None]
        return matrix

    @cached_property
    def growth(self) -> float:
        """By how much a small distance grows at most before it dies out."""
        power, largest = np.eye(len(self.sizes)), 1.0
        for _ in range(RETURNS):
            power = self.monodromy @ power
            size = float(abs(power).sum(axis=1).max())
            largest = max(largest, size)
            if size < 0.1:
                break
        return largest

    @cached_property
    def edge(self) -> Edge | None:
        """What is known of the other side, where it rests on an edge; None where it does not."""
        from trimmer.response.periodic.edge import edge_of

        found = self.flow, self.course, self.sizes, self.multipliers, len(self._trivial)
        return edge_of(*found) if self.success else None

    @property
    def one_sided(self) -> bool:
        """Whether its multipliers hold for disturbances to one side only, as where a contact just touches."""
        return self.edge is not None

    @cached_property
    def strobed(self) -> Reals:
        """States at the start of each drive period, (periods, n), shifted so that leaders are at 0."""
        if not self.periods:
            return self.flow.reduced(self.instant.state[None])
        states = self.course.states(np.arange(self.periods, dtype=np.float64) * self.flow.period)
        return self.flow.reduced(states[:, : self.flow.size])

    @cached_property
    def measures(self) -> Measures:
        """What its outputs, bodies, contacts and frictions do."""
        from trimmer.motion.measures import Measures

        return Measures(self.course, self.flow, max(self.period_count, 1), self.periods or 1)

    def _told(self) -> str:
        return f"{self.subject.title}, {self.message}"

    def _table(self) -> Table:
        outputs = self.measures.outputs
        orders = np.arange(1, 1 + max((len(each.harmonics) for each in outputs.values()), default=0))
        own = self.course.duration / max(self.periods, 1)
        columns = arrays(order=("", orders), frequency=("Hz", orders / own))
        columns += tuple(
            Column(f"outputs.{name}", self.flow.outputs[name].unit, each.harmonics.__getitem__)
            for name, each in outputs.items()
        )
        return Table("Harmonics of the outputs", range(len(orders)), columns)


@dataclass(frozen=True, eq=False, repr=False)
class MechanismOrbit(Orbit):
    """An orbit of a mechanism."""

    @property
    def mechanism(self) -> Mechanism:
        """The mechanism."""
        return cast("Mechanism", self.flow.subject)


def orbit_of(flow: Flow, shot: Shot, periods: int, about: str = "") -> Orbit:
    """Return the orbit that a solved return gives; one that misses is marked as not found.

    Args:
        flow: What moves.
        shot: The motion.
        periods: Number of drive periods that it spans; 0 without a drive.
        about: What else is to be said if it was found.
    """
    solved, miss = shot.calm or shot, shot.miss
    if miss <= CLOSED and not _goes_on(flow, shot):
        miss = np.inf
    success = miss <= CLOSED
    multipliers, margins = multipliers_of(solved)
    if success:
        margins = with_place(flow, solved, periods, multipliers, margins)
    multipliers, margins = with_shifts(flow, multipliers, margins)
    count = _smallest(flow, shot, periods) if success else max(periods, 1)
    seen, course = flow.travelling(shot.course) if success else (flow, shot.course)
    kind = _kind_of(flow)
    if kind is not MechanismOrbit:  # A double multiplier is exact to the root of rounding.
        margins = np.maximum(margins, 1e-6)
    return kind(seen, periods, count, course, shot.sizes, multipliers, miss, about, margins)


def _goes_on(flow: Flow, shot: Shot) -> bool:
    """Say whether a motion that returns to its state goes on from there as it began.

    Where its parts do, it does; a relay with hysteresis may be on either side of it at one state.
    """
    course = shot.course
    if shot.signs is not None or course.end.statuses == course.begin.statuses:
        return True
    further = flow.timed(course.end, LATER[-1] * course.duration)
    return further.ending is Ending.REACHED_END and shot.is_like(further, 0.0, course.duration)


def _kind_of(flow: Flow) -> type[Orbit]:
    """Return what an orbit of a mechanism or of a loop is, with what can be asked of that alone."""
    if isinstance(flow.subject, Mechanism):
        return MechanismOrbit
    from trimmer.orbits.periodic_orbit import PeriodicOrbit

    return PeriodicOrbit


def with_shifts(flow: Flow, multipliers: Complexes, margins: Reals) -> tuple[Complexes, Reals]:
    """Return multipliers by falling modulus, each 0 that stands for a shift as the 1 that it has.

    A shift along which no force changes stays as it is; in the frame that follows the shifted bodies, where
    motions are computed, nothing is left of it.

    Args:
        flow: What moves.
        multipliers: Of that frame, by falling modulus, (n,).
        margins: Their rounding, (n,).
    """
    if not flow.shifts:
        return multipliers, margins
    found: Complexes = np.append(multipliers[: -flow.shifts], np.ones(flow.shifts, dtype=np.complex128))
    known = np.append(margins[: -flow.shifts], np.zeros(flow.shifts))
    order = np.argsort(-abs(found), kind="stable")
    return found[order], known[order]


def _smallest(flow: Flow, shot: Shot, periods: int) -> int:
    """Return the smallest number of drive periods after which a motion returns."""
    if periods <= 1:
        return 1
    strobed = shot.course.states(np.arange(periods, dtype=np.float64) * flow.period)[:, : flow.size]
    apart = abs((strobed - strobed[0]) / shot.sizes).max(axis=1)
    together = flow.modes.system.layout.recurrence
    divisors = (each for each in range(together, periods + 1, together) if periods % each == 0)
    return next(
        each
        for each in divisors
        if each == periods or (apart[each] < SAME and shot.goes_on_alike(each * flow.period))
    )
