"""What a sweep gives: a point for each value, jumps, and where both ways differ."""

from __future__ import annotations

from collections.abc import Callable, Iterator, Mapping
from dataclasses import dataclass
from functools import cached_property
from itertools import groupby
from typing import TYPE_CHECKING, Any

import numpy as np

from trimmer.errors import MapError
from trimmer.hybrid.stretch import Ending
from trimmer.maps.jumps import Jump
from trimmer.maps.plateau import Plateau
from trimmer.mechanism.place_text import unit_of
from trimmer.messages import there_is
from trimmer.motion.chosen import SIZES
from trimmer.response.flows import flow_of
from trimmer.response.periodic.pace import periods_of
from trimmer.response.results.response import MotionKind
from trimmer.showing.drawn import Drawn, drawn
from trimmer.showing.shown import Shown, Tabular, counted
from trimmer.showing.table import Column, Table

if TYPE_CHECKING:
    from matplotlib.axes import Axes

    from trimmer.branches.followed import FollowedBranch
    from trimmer.motion.subject import Subject

APART = 0.05  # Least difference of both ways, as a share of the largest stroke, that is hysteresis


@dataclass(frozen=True, eq=False, repr=False)
class SweepPoint(Shown):
    """The motion at one value.

    Attributes:
        value: Value of the number, in SI units; Hz for a frequency.
        back: Whether it is on the way back.
        motion: What was measured.
    """

    value: float
    back: bool
    motion: Plateau

    def peak_to_peak(self, output: str) -> float:
        """Return peak to peak of an output; NaN where the motion ended before."""
        found = self.motion.outputs.get(output)
        return float("nan") if found is None else found.peak_to_peak

    def _told(self) -> str:
        return f"at {self.value:.6g}: {self.motion.kind.described(self.motion.periods)}"


@dataclass(frozen=True)
class Hysteresis:
    """Neighbouring values at which both ways differ.

    Attributes:
        output: Name of the output.
        lowest, highest: The values at the ends.
        largest: Largest difference of peak to peak, in the unit of the output.
    """

    output: str
    lowest: float
    highest: float
    largest: float


@dataclass(frozen=True, eq=False, repr=False)
class Sweep(Tabular, Drawn):
    """A run-up, and a coast-down if it was asked for.

    Attributes:
        subject: What moves.
        place: The number that is varied.
        steps: Steps from the first to the last value.
        periods: Drive periods at each value, of which the second half is measured. Of what moves by itself
            those of the slowest mode that are waited; None if as many as ``respond`` waits.
        back: Whether it goes back.
        points: The motions, in the order in which they came.
        jumps: Where the motion jumps to another one.
        branch: Exact periodic motions over the same interval, if they were asked for.
    """

    subject: Subject
    place: str
    steps: int
    periods: int | None
    back: bool
    points: tuple[SweepPoint, ...]
    jumps: tuple[Jump, ...]
    branch: FollowedBranch | None = None

    @property
    def unit(self) -> str:
        """SI unit of the number that is varied; Hz for a frequency, empty for a number."""
        return unit_of(self.subject.places, self.place)

    @cached_property
    def units(self) -> Mapping[str, str]:
        """Unit of each output, empty for a number."""
        return {name: each.unit for name, each in flow_of(self.subject).outputs.items()}

    @property
    def by_itself(self) -> bool:
        """Whether it moves without a drive."""
        return not flow_of(self.subject).period

    @property
    def success(self) -> bool:
        """Whether it reached its end."""
        return self.points[-1].motion.ending is Ending.REACHED_END

    @property
    def message(self) -> str:
        """How it ended, and how the motions were measured, in sentences."""
        told = "each value until it rests or repeats, which is measured"
        if any(point.motion.kind is MotionKind.REST for point in self.points):
            told += ". What rests stays so until something moves it: also begin where it moves (state)"
        if not self.by_itself:
            periods = periods_of(self.subject, self.periods or 0)
            told = f"each value for {periods}, of which the second half is measured"
        last = self.points[-1]
        if self.success:
            return f"It reached its end; {told}."
        return f"It ends at {self.place} = {last.value:.10g}, because {last.motion.ending.value}; {told}."

    def legs(self) -> tuple[tuple[SweepPoint, ...], ...]:
        """Return the points of the run-up, and those of the way back with the point where it turns."""
        there = tuple(point for point in self.points if not point.back)
        return (there, (there[-1], *self.points[len(there) :])) if self.back else (there,)

    @cached_property
    def hysteresis(self) -> tuple[Hysteresis, ...]:
        """Where both ways differ, by stretches of neighbouring values."""
        return tuple(each for name in self.units for each in self._differing(name))

    def _differing(self, name: str) -> Iterator[Hysteresis]:
        if not self.back:
            return
        # At the first value what is left of the start is no other motion.
        begun = self.points[:1] if self.points[0].motion.kind is MotionKind.UNDECIDED else ()
        there, again = (
            {point.value: point.peak_to_peak(name) for point in leg if point not in begun}
            for leg in self.legs()
        )
        values = sorted(set(there) & set(again))
        apart = {value: abs(there[value] - again[value]) for value in values}
        least = APART * self._largest(name)
        for differs, group in groupby(values, key=lambda value: apart[value] > least):
            stretch = list(group)
            if differs:
                yield Hysteresis(name, stretch[0], stretch[-1], max(apart[value] for value in stretch))

    def _largest(self, name: str) -> float:
        return float(np.nanmax([0.0, *(point.peak_to_peak(name) for point in self.points)]))

    def output(self, name: str | None = None) -> str:
        """Return the name of an output, the first one if none is given.

        Raises:
            MapError: if there is no such output, or none at all.
        """
        if not self.units:
            raise MapError("there is no output, so that nothing can be drawn: give it one ([outputs])")
        if name is not None and name not in self.units:
            raise MapError(f"no output is called {name!r}; {there_is(self.units)}")
        return next(iter(self.units)) if name is None else name

    def plot(self, ax: Axes | None = None, output: str | None = None) -> Axes:
        """Draw peak to peak of an output over the number, both ways, beside the branch if there is one.

        Args:
            ax: Where to draw; new axes if not given.
            output: Name of the output; the first one if not given.

        Raises:
            WrongTypeError: if ``ax`` is no Matplotlib axes.
            MapError: if there is no such output.
        """
        return drawn(self, ax, output=output)

    def to_json(self) -> dict[str, Any]:
        """Return it as data for JSON, with the keys of ``trimmer sweep --json``."""
        return {
            "place": self.place,
            "unit": self.unit,
            "steps": self.steps,
            "drive_periods": self.periods,
            "back": self.back,
            "success": self.success,
            "message": self.message,
            "points": [_point(each) for each in self.points],
            "jumps": [vars(each) for each in self.jumps],
            "hysteresis": [vars(each) for each in self.hysteresis],
        }

    def _told(self) -> str:
        kinds = [point.motion.kind.described(point.motion.periods) for point in self.points]
        counts = ", ".join(f"{kinds.count(kind)} {kind}" for kind in dict.fromkeys(kinds))
        return f"over {self.place}, {counted(len(self.points), 'value')}: {counts}"

    def _table(self) -> Table:
        columns = (
            Column("value", self.unit, lambda point: point.value),
            Column("back", "", lambda point: point.back),
            Column("kind", "", lambda point: point.motion.kind),
            Column("periods", "", lambda point: point.motion.periods),
            Column("period", "s", lambda point: point.motion.period),
            Column("impact_speed", flow_of(self.subject).units.speed, lambda p: p.motion.impact_speed),
            *(
                Column(f"outputs.{name}.{measure}", unit, _measured(name, measure))
                for name, unit in self.units.items()
                for measure in ("peak_to_peak", "rms", "mean")
            ),
        )
        return Table(f"Motions over {self.place}", self.points, columns)


def _measured(name: str, measure: str) -> Callable[[SweepPoint], float | None]:
    return lambda point: getattr(point.motion.outputs.get(name), measure, None)


def _point(point: SweepPoint) -> dict[str, Any]:
    motion = point.motion
    return {
        "value": point.value,
        "back": point.back,
        "kind": motion.kind.word,
        "periods": motion.periods,
        "period": motion.period,
        "measured_periods": motion.measured,
        "impact_speed": motion.impact_speed,
        "outputs": {
            name: {
                **{size: getattr(each, size) for size in SIZES},
                "lines": [list(line) for line in each.lines],
            }
            for name, each in motion.outputs.items()
        },
    }
