"""A map: the motions of all cells, and arrays of what they have in common."""

from __future__ import annotations

from collections import Counter
from collections.abc import Callable, Iterable, Iterator, Mapping
from dataclasses import dataclass
from functools import cached_property
from typing import TYPE_CHECKING

import numpy as np

from trimmer.errors import MapError
from trimmer.maps.cell_motion import described, waited_for
from trimmer.mechanism.place_text import parse_place, unit_of
from trimmer.motion.chosen import chosen_measure
from trimmer.response.flows import called, flow_of, is_silent, searched
from trimmer.response.results.response import MotionKind
from trimmer.showing.drawn import Drawn, drawn
from trimmer.showing.shown import Tabular, counted
from trimmer.showing.table import Column, Table

if TYPE_CHECKING:
    from matplotlib.axes import Axes
    from numpy.typing import ArrayLike

    from trimmer.arrays import Integers, Reals
    from trimmer.maps.cell_motion import CellMotion
    from trimmer.maps.cells import CellResult
    from trimmer.maps.inputs import MapInputs
    from trimmer.motion.flow import Flow
    from trimmer.motion.units import Units


@dataclass(frozen=True, eq=False, repr=False)
class MotionMap(Tabular, Drawn):
    """Which motion where. Arrays have the shape (n2, n1): the first place varies along a row.

    With one place n2 is 1. All arrays are of the first motion of each cell, which is that from rest, or from
    the mechanism's own start; ``cells`` has the others. Measures of cells that failed or diverge are NaN.

    Attributes:
        inputs: Mechanism, places, values and settings.
        cells: The result of each cell, row by row.
    """

    inputs: MapInputs
    cells: tuple[CellResult, ...]

    @property
    def places(self) -> tuple[str, ...]:
        """What is varied, as dotted places."""
        return self.inputs.places

    @property
    def values(self) -> tuple[Reals, ...]:
        """Values of each place, in SI units."""
        return tuple(np.array(values) for values in self.inputs.values)

    @property
    def shape(self) -> tuple[int, int]:
        """(n2, n1)."""
        columns = len(self.inputs.values[0])
        return self.inputs.count // columns, columns

    def _of_each(self, measure: Callable[[CellMotion], float | None]) -> Reals:
        return np.array([measure(cell.motions[0]) for cell in self.cells], dtype=float).reshape(self.shape)

    def _measure(self, name: str, key: str | None = None) -> Reals:
        def value(motion: CellMotion) -> float:
            if motion.measures is None:
                return float("nan")
            found = getattr(motion.measures, name)
            return float(found if key is None else found[key])

        return self._of_each(value)

    @cached_property
    def kind(self) -> np.ndarray[tuple[int, int], np.dtype[np.object_]]:
        """Kinds of motion, ``MotionKind``, (n2, n1); chaos is that over ``periods``, and may be transient."""
        kinds = np.empty(len(self.cells), dtype=object)
        kinds[:] = [cell.motions[0].kind for cell in self.cells]
        return kinds.reshape(self.shape)

    @cached_property
    def period_count(self) -> Integers:
        """Drive periods after which the motion repeats, 0 where it does not, (n2, n1)."""
        return self._of_each(lambda motion: motion.period_count).astype(np.int64)

    @cached_property
    def periods(self) -> Integers:
        """Drive periods that were waited, (n2, n1)."""
        return self._of_each(lambda motion: motion.periods).astype(np.int64)

    @cached_property
    def motion_count(self) -> Integers:
        """Distinct motions that were found in each cell, (n2, n1)."""
        return np.array([len(cell.motions) for cell in self.cells], dtype=np.int64).reshape(self.shape)

    @cached_property
    def lyapunov(self) -> Reals:
        """Growth of small distances per drive period, or s without a drive, as a logarithm, (n2, n1).

        NaN where it was not measured.
        """
        return self._of_each(lambda motion: motion.lyapunov)

    @cached_property
    def largest_multiplier(self) -> Reals:
        """Largest modulus of the Floquet multipliers, NaN without an exact orbit, (n2, n1)."""
        return self._of_each(lambda motion: motion.largest_multiplier)

    @cached_property
    def stroke(self) -> Reals:
        """Peak to peak of the first output, in its unit, (n2, n1).

        Raises:
            MapError: if the mechanism has no output.
        """
        if not self.outputs:
            raise MapError("the mechanism has no output, so there is no stroke: give it one ([outputs])")
        return next(iter(self.peak_to_peak.values()))

    @cached_property
    def peak_to_peak(self) -> Mapping[str, Reals]:
        """Of each output, in its unit, (n2, n1)."""
        return {name: self._measure("peak_to_peak", name) for name in self.outputs}

    @cached_property
    def outputs(self) -> Mapping[str, str]:
        """Unit of each output, empty for a number."""
        return {name: each.unit for name, each in self._flow.outputs.items()}

    @property
    def measured_in(self) -> Units:
        """Units of what is measured beside the outputs."""
        return self._flow.units

    def acceleration_unit(self, body: str) -> str:
        """Return the unit of the acceleration of a body, by its name."""
        return self._flow.units_of_body(body).acceleration

    @cached_property
    def _flow(self) -> Flow:
        return flow_of(self.inputs.subject)

    @cached_property
    def rms_acceleration(self) -> Mapping[str, Reals]:
        """Of each body, m/s² or rad/s², (n2, n1)."""
        return {name: self._measure("rms_acceleration", name) for name in self._flow.accelerations}

    @cached_property
    def wear_power(self) -> Mapping[str, Reals]:
        """Mean power of each dry friction, W, or in 1/s where nothing has units, (n2, n1)."""
        return {name: self._measure("wear_power", name) for name in self._flow.rubbing}

    @cached_property
    def events(self) -> Reals:
        """Events per drive period, (n2, n1)."""
        return self._measure("events")

    @cached_property
    def impacts(self) -> Reals:
        """Contacts made per drive period, (n2, n1)."""
        return self._measure("impacts")

    @cached_property
    def impact_speed(self) -> Reals:
        """Largest speed at which the sides of a contact meet, m/s, or in 1/s, (n2, n1)."""
        return self._measure("impact_speed")

    @cached_property
    def chosen(self) -> Mapping[str, Reals]:
        """Measures that were asked for, by their keys, SI units, (n2, n1)."""
        return {key: self._measure("chosen", key) for key in self.inputs.settings.measures}

    @property
    def chosen_units(self) -> Mapping[str, str]:
        """Their units, empty for a number."""
        return {key: chosen_measure(self._flow, key).unit for key in self.inputs.settings.measures}

    @property
    def failures(self) -> Mapping[tuple[int, int], str]:
        """Why motions ended before their time, by row and column."""
        columns = self.shape[1]
        return {
            divmod(cell.number, columns): motion.failure
            for cell in self.cells
            for motion in cell.motions[:1]
            if motion.failure
        }

    @property
    def counts(self) -> Mapping[str, int]:
        """Cells by what their first motion is in words, such as ``period 3``, the most frequent first."""
        kinds = Counter(described(cell.motions[0]) for cell in self.cells)
        waited = self.inputs.over
        return {waited_for(name, waited): count for name, count in kinds.most_common()}

    @property
    def searched(self) -> str:
        """What was looked at, in a sentence."""
        return _searched(self)

    @property
    def passing(self) -> str:
        """What may still change in chaotic cells, in a sentence without a full stop; empty without any."""
        chaotic = int((self.kind == MotionKind.CHAOTIC).sum())
        if not chaotic:
            return ""
        cells = "1 cell is" if chaotic == 1 else f"{chaotic} cells are"
        return (
            f"{cells} chaotic over the {self.inputs.over} that were waited: such chaos may be transient "
            "and end in a motion that repeats"
        )

    @property
    def units(self) -> tuple[str, ...]:
        """SI unit of each place, empty for a number; Hz for a frequency."""
        known = self.inputs.subject.places
        return tuple(unit_of(known, place) for place in self.places)

    def plot(
        self,
        ax: Axes | None = None,
        curves: Iterable[tuple[str, ArrayLike]] = (),
        measure: str | None = None,
        target: float | None = None,
    ) -> Axes:
        """Draw the kinds of motion as areas; a map over one place as its stroke, in the same colours.

        With a measure, one of ``chosen``, it is drawn in their place, with a contour at the target.

        Args:
            ax: Where to draw; new axes if not given.
            measure: Key of a measure.
            target: Its target, SI units.
            curves: Curves over it with what they are, such as ``SpecialCurves.drawn``: values of the two
                places, SI units, (points, 2). Curves of one name share a line of the legend.

        Raises:
            WrongTypeError: if ``ax`` is no Matplotlib axes.
        """
        return drawn(self, ax, curves=curves, measure=measure, target=target)

    def _told(self) -> str:
        found = ", ".join(f"{count} {name}" for name, count in self.counts.items())
        size = " x ".join(str(len(values)) for values in self.inputs.values)
        return f"{size} cells over {' and '.join(self.places)}: {found}"

    def _table(self) -> Table:
        columns = (*place_columns(self), *_cells(self))
        return Table("Cells, each with its first motion", range(len(self.cells)), columns)


def place_columns(result: MotionMap) -> tuple[Column, ...]:
    """Return columns of the values of a map's places, for rows numbered as its cells."""
    grid = np.meshgrid(*result.values)
    return tuple(
        Column(place, unit, values.ravel().__getitem__)
        for place, unit, values in zip(result.places, result.units, grid, strict=True)
    )


def _cells(result: MotionMap) -> Iterator[Column]:
    """Yield columns of what is measured, with the names of the JSON."""
    for name, unit, values in (
        ("kind", "", result.kind),
        ("period_count", "", result.period_count),
        ("drive_periods", "", result.periods),
        ("motion_count", "", result.motion_count),
        ("largest_multiplier", "", result.largest_multiplier),
        ("lyapunov", "", result.lyapunov),
        ("events_per_period", "", result.events),
        ("impacts_per_period", "", result.impacts),
        ("impact_speed", result.measured_in.speed, result.impact_speed),
    ):
        yield Column(name, unit, np.ravel(values).__getitem__)
    for section, measure, unit_of_part, by_name in (
        ("outputs", "peak_to_peak", result.outputs.__getitem__, result.peak_to_peak),
        ("bodies", "rms_acceleration", result.acceleration_unit, result.rms_acceleration),
        ("frictions", "wear_power", lambda _: result.measured_in.power, result.wear_power),
    ):
        for part, values in by_name.items():
            yield Column(f"{section}.{part}.{measure}", unit_of_part(part), np.ravel(values).__getitem__)
    for key, values in result.chosen.items():
        yield Column(f"measures.{key}", result.chosen_units[key], np.ravel(values).__getitem__)


def _searched(result: MotionMap) -> str:
    settings, count = result.inputs.settings, len(result.cells)
    subject = result.inputs.subject
    own = f"the {called(subject)}'s own start" if getattr(subject, "start", None) else "rest"
    own = "a start of its own" if any(parse_place(each)[0] == "start" for each in result.places) else own
    if is_silent(subject):
        return f"{counted(count, 'cell')}, in each {searched(subject)}"
    several = int((result.motion_count > 1).sum())
    begun = f"{counted(count, 'cell')}, each from {own}"
    if settings.starts > 1:
        begun += f" and from {counted(settings.starts - 1, 'random state')} (seed {settings.seed})"
    begun += f", for at most {result.inputs.waited}"
    if settings.starts == 1:
        return f"{begun}; other motions were not looked for"
    told = f"{begun}; {several} of them have several motions among those found"
    return f"{told}, where all of a cell that do not repeat count as one of each kind"
