"""A branch of exact periodic motions of a mechanism: what ``follow`` gives."""

from __future__ import annotations

from collections.abc import Callable, Iterator, Mapping
from dataclasses import dataclass
from typing import TYPE_CHECKING

import numpy as np

from trimmer.arrays import Complexes, Reals
from trimmer.branches.balanced import BalancedOrbit, balanced_beside
from trimmer.branches.branch import BranchEnd, BranchPoint
from trimmer.branches.endless_period import EndlessPeriod
from trimmer.branches.outputs import OutputMeasure, output_measures
from trimmer.branches.period_maps.driven_map import DrivenMap
from trimmer.branches.period_maps.driven_passage import DrivenPassage
from trimmer.branches.period_maps.self_excited_map import SelfExcitedMap, with_trivial
from trimmer.branches.special import SpecialPoint
from trimmer.errors import UnsupportedMotionError
from trimmer.kept_property import cached_property
from trimmer.mechanism.mechanism import Mechanism
from trimmer.mechanism.place_text import parse_place, place_text, unit_of
from trimmer.motion.chosen import chosen_measure
from trimmer.motion.measures import Measures
from trimmer.response.flows import flow_of
from trimmer.response.periodic.orbit import with_shifts
from trimmer.response.periodic.pace import periods_of
from trimmer.showing.drawn import Drawn, drawn
from trimmer.showing.shown import Shown, Tabular, counted
from trimmer.showing.table import Column, Table

if TYPE_CHECKING:
    from matplotlib.axes import Axes


@dataclass(frozen=True, eq=False, repr=False)
class FollowedOrbit(Shown):
    """An exact periodic motion on a branch.

    Attributes:
        point: The orbit on the branch: value, state, multipliers, stability.
        map: The map of its whole period.
    """

    point: BranchPoint
    map: DrivenMap

    @property
    def value(self) -> float:
        """Value of the number that is varied, in its unit."""
        return self.point.value

    @property
    def state(self) -> Reals:
        """State at the start of a drive period, (n,); without a drive any, and the period last, (n + 1,).

        The period is that before it doubled, if it did.
        """
        return self.point.state

    @property
    def stable(self) -> bool:
        """Whether neighbouring motions approach it."""
        return self.point.stable

    @property
    def multipliers(self) -> Complexes:
        """Floquet multipliers by falling modulus, (n,).

        Without a drive one of them is 1, since the motion may be shifted in time, and one is for each
        direction in which bodies may be shifted without a change of any force; ``stable`` leaves them out.
        """
        multipliers = self.point.multipliers
        if isinstance(self.map, SelfExcitedMap):
            multipliers = with_trivial(multipliers)
        return with_shifts(self.map.flow(self.value), multipliers, np.zeros(len(multipliers)))[0]

    @property
    def largest_multiplier(self) -> float:
        """Largest modulus of the multipliers, without the one of a shift in time."""
        return float(abs(self.point.multipliers).max(initial=0.0))

    @property
    def periods(self) -> int:
        """Drive periods after which it repeats; without a drive 1, and 2, 4, … where periods have doubled."""
        return self.map.periods

    @property
    def period(self) -> float:
        """Time after which it repeats, s."""
        if isinstance(self.map, SelfExcitedMap):
            return self.periods * float(self.point.state[-1])
        return self.periods * self.map.flow(self.value).period

    @property
    def events_per_period(self) -> float:
        """Events in a drive period, the mean over the orbit; without a drive over its period."""
        return self.point.events / (1 if isinstance(self.map, SelfExcitedMap) else self.periods)

    @cached_property
    def passage(self) -> DrivenPassage:
        """The motion over its period."""
        return self.map.passage(self.point.value, self.point.state)

    @cached_property
    def outputs(self) -> Mapping[str, OutputMeasure]:
        """Peak to peak and harmonics of each output."""
        return _outputs(self.passage)

    def measure(self, key: str) -> float:
        """Return a measure by its key, SI units; see ``trimmer.motion.chosen``.

        Raises:
            ChoiceError: if there is none.
        """
        return _measure(self.map, self.passage, key)

    def balanced(self, harmonics: int) -> BalancedOrbit:
        """Balance the forces harmonic by harmonic from the orbit on, and say how far the result is from it.

        Args:
            harmonics: Harmonics of the drive up to which the forces balance.

        Raises:
            UnsupportedMotionError: if a spring leans on a pin that moves on, or there is no drive.
        """
        if isinstance(self.map, SelfExcitedMap):
            raise UnsupportedMotionError(
                "harmonic balance runs beside driven motions only, and the mechanism has no frequency"
            )
        mechanism = self.passage.flow.subject
        if not isinstance(mechanism, Mechanism):
            raise UnsupportedMotionError("harmonic balance runs beside motions of mechanisms only")
        return balanced_beside(self.passage.course, mechanism, self.periods, harmonics)

    def _told(self) -> str:
        kind = "stable" if self.stable else "not stable"
        return f"{self.map.place} = {self.value:.9g}, {kind}, {periods_of(self.map.subject, self.periods)}"


@dataclass(frozen=True, eq=False, repr=False)
class FollowedBranch(Tabular, Drawn):
    """A branch of exact periodic motions of a mechanism over one of its numbers.

    Attributes:
        map: The map of the whole period of its motions, with the mechanism and the place of the number.
        points: The motions, in the order in which they were followed.
        special: The special points, in the same order.
        reason: Why the branch ends.
        message: The same as a sentence.
        branches: Branches that part from this one at period doubling and symmetry breaking, and those that
            it joins there.
        parted: The special point at which this one parts from another; None if it was begun by itself.
        endless: Where its period grows without bound, if it ends for that reason.
    """

    map: DrivenMap
    points: tuple[FollowedOrbit, ...]
    special: tuple[SpecialPoint, ...]
    reason: BranchEnd
    message: str
    branches: tuple[FollowedBranch, ...] = ()
    parted: SpecialPoint | None = None
    endless: EndlessPeriod | None = None

    @property
    def periods(self) -> int:
        """Drive periods after which the motions repeat."""
        return self.map.periods

    @property
    def finds_period(self) -> bool:
        """Whether its orbits have a period of their own, which neither a drive nor samples give."""
        return isinstance(self.map, SelfExcitedMap)

    @property
    def unit(self) -> str:
        """SI unit of the number that is varied; Hz for a frequency."""
        return self.map.subject.places[place_text(parse_place(self.map.place))]

    @property
    def units(self) -> Mapping[str, str]:
        """Unit of each output, empty for a number."""
        return {name: each.unit for name, each in flow_of(self.map.subject).outputs.items()}

    def outputs_at(self, special: SpecialPoint) -> Mapping[str, OutputMeasure]:
        """Return peak to peak and harmonics of each output at a special point of the branch."""
        return _outputs(self.map.passage(special.value, special.state))

    def measure_at(self, special: SpecialPoint, key: str) -> float:
        """Return a measure at a special point of the branch, as ``FollowedOrbit.measure``."""
        return _measure(self.map, self.map.passage(special.value, special.state), key)

    def all(self) -> Iterator[FollowedBranch]:
        """Yield the branch, then those that part from it, each before those that part from that."""
        yield self
        for other in self.branches:
            yield from other.all()

    def plot(
        self,
        ax: Axes | None = None,
        output: str | None = None,
        measure: str | None = None,
        target: float | None = None,
    ) -> Axes:
        """Draw peak to peak of an output, m, over the number that is varied, with those that part from it.

        Stable stretches are solid, others dashed; special points have marks.

        Args:
            ax: Where to draw; new axes if not given.
            output: Name of the output; the first one if not given.
            measure: Key of a measure that is drawn in its place; see ``trimmer.motion.chosen``.
            target: Its target, SI units.

        Raises:
            WrongTypeError: if ``ax`` is no Matplotlib axes.
            MechanismError: if the mechanism has no such output, or none at all.
            ChoiceError: if there is no such measure.
        """
        return drawn(self, ax, output=output, measure=measure, target=target)

    def _told(self) -> str:
        others = len(list(self.all())) - 1
        found = [counted(len(self.points), "orbit"), counted(len(self.special), "special point")]
        found += [f"{others} more branches" if others > 1 else "one more branch"] if others else []
        return f"over {self.map.place}, {', '.join(found)}; {self.message}"

    def _table(self) -> Table:
        items = [(number, point) for number, each in enumerate(self.all()) for point in each.points]
        outputs = (
            Column(f"outputs.{name}.peak_to_peak", unit, _stroke(name)) for name, unit in self.units.items()
        )
        columns = (
            Column("branch", "", lambda item: item[0]),
            Column("value", unit_of(self.map.subject.places, self.map.place), lambda item: item[1].value),
            Column("stable", "", lambda item: item[1].stable),
            Column("period", "s", lambda item: item[1].period),
            Column("period_count", "", lambda item: item[1].periods),
            Column("largest_multiplier", "", lambda item: item[1].largest_multiplier),
            Column("events_per_period", "", lambda item: item[1].events_per_period),
            *outputs,
        )
        return Table(f"Orbits over {self.map.place}; branch 0 is this one", items, columns)

    @property
    def searched(self) -> str:
        """Where special points were looked for, and where not, in a sentence."""
        return (
            f"special points were looked for between neighbours of {counted(len(self.points), 'orbit')}; a "
            "contact or a phase of stick that comes and goes between the same two is not seen"
        )

    @property
    def success(self) -> bool:
        """Whether it was followed to an end of the interval, around, or to one that it joins."""
        return self.reason.is_success


def _measure(map: DrivenMap, passage: DrivenPassage, key: str) -> float:
    flow, course = passage.flow.travelling(passage.course)
    count = 1 if isinstance(map, SelfExcitedMap) else map.periods
    return chosen_measure(flow, key).of(Measures(course, flow, count, count))


def _outputs(passage: DrivenPassage) -> Mapping[str, OutputMeasure]:
    flow, course = passage.flow.travelling(passage.course)
    return output_measures(flow, course)


def _stroke(name: str) -> Callable[[tuple[int, FollowedOrbit]], float]:
    """Return what gives peak to peak of an output, m, of an orbit beside the number of its branch."""
    return lambda item: item[1].outputs[name].peak_to_peak
