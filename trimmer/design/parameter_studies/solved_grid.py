"""Motions solved for on a grid of numbers, with what a page shows of each: a table to look things up in."""

import itertools
import math
from dataclasses import dataclass, replace

import numpy as np

from trimmer.arrays import Reals
from trimmer.design.analysis.found_motion import SEEN
from trimmer.design.parameter_studies.strongest import number_drawn
from trimmer.design.settings import DesignSettings
from trimmer.design.specification.targets import Measure, Target
from trimmer.design.trials.remedies import Remedies
from trimmer.design.trials.trial import MeasureOfPart, measured, measures_of_settled, of_switching
from trimmer.design.varied_places import VariedNumber
from trimmer.errors import TrimmerError
from trimmer.maps.inputs import varied
from trimmer.maps.settle import settle
from trimmer.mechanism import Mechanism, Output, OutputKind
from trimmer.motion.course import Course
from trimmer.motion.flow import Flow
from trimmer.motion.signals import read
from trimmer.response.flows import flow_of
from trimmer.response.periodic.pace import pace_of
from trimmer.response.results.response import MotionKind
from trimmer.response.simulation.switching import switching
from trimmer.runners.runner import Runner

MOST_NUMBERS = 3  # Numbers that can be moved at most
COARSE = 4  # Steps of each number on a first grid, to which those of the last one are added if there is time
POINTS, MOST_POINTS = 128, 192  # Instants at which a curve is kept: of one drive period, and at most
MOST_LINES, SMALLEST = 16, 1e-3
"""Lines that are kept of a curve, the largest, down to this share of the first."""
SHOWN = 2  # Drive periods of a motion that does not repeat of which curves are kept

Line = tuple[int, int, float]


@dataclass(frozen=True, eq=False)
class GridMotion:
    """What a mechanism does with some numbers."""

    kind: MotionKind | None  # What the motion is; None where none was found
    period_count: int | None  # Drive periods after which it repeats; None if it does not
    measures: tuple[float, ...]  # In the order of what was asked; not a number where it has none
    duration: float  # Time that the curves span, s
    curves: Reals  # Of each signal at even instants, in its unit, (signals, points)
    # Of each signal p, k and amplitude of its largest lines, at p/k of the drive
    lines: tuple[tuple[Line, ...], ...]


@dataclass(frozen=True, eq=False)
class SolvedGrid:
    """Motions over a grid of numbers."""

    numbers: tuple[VariedNumber, ...]  # The numbers
    values: tuple[tuple[float, ...], ...]  # Of each the values on the grid, rising
    targets: tuple[Target, ...]  # Those whose measures are taken
    signals: tuple[tuple[str, str], ...]  # Names of the signals, with their units
    motions: tuple[GridMotion, ...]  # By the values, the last number running fastest


@dataclass(frozen=True)
class GridWork:
    """The work of one point of the grid, which a process or a cluster may do."""

    mechanism: Mechanism  # The mechanism; its outputs hold the signals
    places: tuple[str, ...]  # Dotted places of the values
    asked: tuple[MeasureOfPart, ...]  # What is measured
    signals: tuple[str, ...]  # Names of the outputs of which curves are kept
    most_periods: int  # Drive periods to wait at most
    switched: bool  # Whether the motion is looked at from its start until all rests

    def __call__(self, values: tuple[float, ...]) -> tuple[tuple[float, ...], GridMotion]:
        """Return what the mechanism does from its start with these values."""
        try:
            mechanism = varied(self.mechanism, self.places, values)
            found = self._switched(mechanism) if self.switched else self._driven(mechanism)
        except (TrimmerError, ArithmeticError, np.linalg.LinAlgError):
            found = None
        nothing = GridMotion(None, None, (math.nan,) * len(self.asked), 0.0, np.empty((0, 0)), ())
        return values, found or nothing

    def _driven(self, mechanism: Mechanism) -> GridMotion | None:
        flow = flow_of(mechanism)
        settled = settle(flow, flow.rest(), self.most_periods * pace_of(flow.subject))
        measures = measures_of_settled(flow, settled)
        if measures is None:
            return None
        repeats = None if settled.orbit is None else settled.orbit.period_count
        course, spanned = measures.course, measures.periods
        shown = SHOWN if repeats is None else spanned
        return GridMotion(
            settled.kind,
            repeats,
            tuple(measured(measures, each, repeats) for each in self.asked),
            course.duration * shown / spanned,
            self._curves(measures.flow, course, shown / spanned, min(POINTS * shown, MOST_POINTS)),
            tuple(_largest(measures.outputs[name].lines) for name in self.signals),
        )

    def _switched(self, mechanism: Mechanism) -> GridMotion:
        found = switching(mechanism)
        flow, course = found.motion.flow, found.motion.course
        share = min(1.0, SEEN * found.last / course.duration) or 1.0
        return GridMotion(
            MotionKind.UNDECIDED if found.rest is None else MotionKind.REST,
            None,
            tuple(of_switching(found, each) for each in self.asked),
            course.duration * share,
            self._curves(flow, course, share, MOST_POINTS),
            ((),) * len(self.signals),
        )

    def _curves(self, flow: Flow, course: Course, share: float, points: int) -> Reals:
        times = np.linspace(0.0, share * course.duration, points)
        rows = np.maximum(np.searchsorted(course.log.start, times, side="right") - 1, 0)
        readouts = [flow.outputs[name] for name in self.signals]
        return read(course, readouts, rows, course.states(times)).T


def _largest(lines: list[Line]) -> tuple[Line, ...]:
    floor = SMALLEST * max((size for *_, size in lines), default=0.0)
    kept = sorted((each for each in lines if each[2] > floor), key=lambda each: -each[2])[:MOST_LINES]
    return tuple(sorted(kept))


@dataclass(frozen=True)
class MovedNumber:
    """A number that is moved, with values that shall be on the grid beside that of the file."""

    number: VariedNumber
    also: tuple[float, ...] = ()

    def values(self, size: int) -> tuple[float, ...]:
        """Return its values on a grid of some steps, rising."""
        number, own = self.number, {self.number.value, *self.also}
        near = 1e-9 * (number.highest - number.lowest)
        even = [each for each in number.values(size).tolist() if all(abs(each - one) > near for one in own)]
        return tuple(sorted({*own, *even}))


def solved_grid(
    mechanism: Mechanism,
    moved: tuple[MovedNumber, ...],
    targets: tuple[Target, ...],
    shaken: str | None,
    settings: DesignSettings,
    runner: Runner,
    *,
    switched: bool,
) -> SolvedGrid | None:
    """Solve for the motions on a coarse grid, then on a fine one that holds it.

    The acceleration of a body that is ``shaken`` is a signal too; what has ``switched`` is looked at
    until all rests. None if not even the coarse grid is whole, or there is nothing to show.
    """
    whole, signals = with_signals(mechanism, targets, shaken)
    if not signals or not moved:
        return None
    asked = tuple(MeasureOfPart(each.measure, each.part) for each in targets)
    numbers = tuple(each.number for each in moved)
    places = tuple(each.place for each in numbers)
    work = GridWork(whole, places, asked, signals, settings.cell_periods, switched)
    known: dict[tuple[float, ...], GridMotion] = {}
    best = None
    for size in sorted({min(COARSE, settings.grid), settings.grid}):
        values = tuple(each.values(size) for each in moved)
        points = list(itertools.product(*values))
        known |= dict(runner.results(work, [each for each in points if each not in known]))
        if any(each not in known for each in points):
            break
        named = tuple((name, whole.output_units[name]) for name in signals)
        best = SolvedGrid(numbers, values, targets, named, tuple(known[each] for each in points))
    return best


def with_signals(
    mechanism: Mechanism, targets: tuple[Target, ...], shaken: str | None
) -> tuple[Mechanism, tuple[str, ...]]:
    """Return the mechanism with outputs that hold the signals, and their names, two at most.

    The first is an output, of which one is bounded if any is; the second the acceleration of a body, or
    without one another output.
    """
    bounded = [each.part for each in targets if each.measure is Measure.STROKE]
    names = list(dict.fromkeys([*bounded, *mechanism.outputs]))
    if shaken is None:
        return mechanism, tuple(names[:2])
    name = f"acceleration of {shaken}"
    if name not in mechanism.outputs:
        output = Output({shaken: 1.0}, OutputKind.ACCELERATION)
        mechanism = replace(mechanism, outputs={**mechanism.outputs, name: output})
    return mechanism, (*[each for each in names if each != name][:1], name)


def numbers_to_move(
    mechanism: Mechanism,
    varied_ones: tuple[VariedNumber, ...],
    drawn: tuple[VariedNumber, ...],
    found: Remedies | None,
) -> tuple[MovedNumber, ...]:
    """Return the numbers to move.

    Those of the best remedy come first, with what it makes of them; then gap, speed and friction, then those
    that maps are drawn over.
    """
    best = next(iter(found.found), found.nearest) if found is not None else None
    after = {each.place: each.after for each in best.changes} if best is not None else {}
    known = {each.place: each for each in (*varied_ones, *drawn)}
    changed = (known.get(place) or number_drawn(mechanism, place) for place in after)
    first = (_reaching(each, after[each.place]) for each in changed if each is not None)
    wanted: dict[str, VariedNumber] = {}
    for each in (*first, *varied_ones, *drawn):
        wanted.setdefault(each.place, each)
    chosen = list(wanted.values())[:MOST_NUMBERS]
    return tuple(MovedNumber(each, (after[each.place],) if each.place in after else ()) for each in chosen)


def _reaching(number: VariedNumber, value: float) -> VariedNumber:
    return replace(number, lowest=min(number.lowest, value), highest=max(number.highest, value))
