"""Motions that coexist: each exact orbit of a map is tried as a start in the cells beside its own.

A branch that no start of the map leads to in one cell may be reached in the next. From there it is carried on
from cell to cell, until no cell beside has a motion that is new.
"""

from collections.abc import Callable, Iterator
from dataclasses import dataclass

import numpy as np

from trimmer.arguments import require_instance, whole_number
from trimmer.maps.cell_motion import CellMotion, alike, same_motion
from trimmer.maps.cells import Cell, CellResult, CellWork
from trimmer.maps.motion_map import FEW
from trimmer.maps.result import MotionMap, place_columns
from trimmer.progress import progress_bar
from trimmer.response.results.response import MotionKind
from trimmer.runners import ProcessRunner, Runner, SerialRunner
from trimmer.showing.shown import Tabular, counted
from trimmer.showing.table import Column, Table

CONTINUED = 0.1
"""Difference of two orbits, relative to their sizes, up to which one is taken for the other carried on."""


@dataclass(frozen=True, eq=False, repr=False)
class Coexistence(Tabular):
    """A map with the motions that were found from those of neighbouring cells.

    Attributes:
        result: The map; each cell has all its motions.
        tried: How many starts were tried.
        rounds: How often motions went on to the cells beside.
        complete: Whether the last round found nothing new; otherwise the number of rounds ended the search.
    """

    result: MotionMap
    tried: int
    rounds: int
    complete: bool

    @property
    def several(self) -> tuple[tuple[int, int], ...]:
        """Row and column of each cell in which several motions coexist."""
        return tuple((int(row), int(column)) for row, column in np.argwhere(self.result.motion_count > 1))

    def _told(self) -> str:
        return f"{len(self.several)} of {len(self.result.cells)} cells have several motions"

    def _table(self) -> Table:
        items = [
            (number, at, motion)
            for number, cell in enumerate(self.result.cells)
            for at, motion in enumerate(cell.motions, start=1)
        ]
        places = (Column(place.name, place.unit, _of_cell(place)) for place in place_columns(self.result))
        columns = (
            *places,
            Column("motion", "", lambda item: item[1]),
            Column("kind", "", lambda item: item[2].kind),
            Column("period_count", "", lambda item: item[2].period_count),
            Column("largest_multiplier", "", lambda item: item[2].largest_multiplier),
        )
        return Table("Motions of the cells", items, columns)

    @property
    def searched(self) -> str:
        """What was searched, in a sentence."""
        starts, cells = self.result.inputs.settings.starts, self.result.cells
        several, rounds = len(self.several), counted(self.rounds, "round")
        have = f"{counted(several, 'cell')} {'has' if several == 1 else 'have'} several motions"
        end = "until no cell had a new one" if self.complete else "and the search ended before it was done"
        return (
            f"{counted(len(cells), 'cell')} from {counted(starts, 'start')} each; then the stable "
            "orbits of a cell were tried in the 8 cells around it, unless they looked like a motion there "
            f"carried on (to {CONTINUED:.0%} of its size): {counted(self.tried, 'start')} in {rounds}, "
            f"{end}. {have}. One that no start and no neighbour "
            "leads to was not looked for."
        )


def _of_cell(column: Column) -> Callable[[tuple[int, int, CellMotion]], object]:
    """Return what gives the value of a column for a motion beside the numbers of its cell and itself."""
    return lambda item: column.of(item[0])


def coexisting_motions(
    result: MotionMap, *, most_rounds: int = 200, runner: Runner | None = None, quiet: bool = False
) -> Coexistence:
    """Look for motions that coexist with those of a map, from the orbits of the cells around.

    Args:
        result: The map.
        most_rounds: How often motions may go on to the cells beside.
        runner: Who does the work; by default processes on all cores, for a few cells this one.
        quiet: Show no progress bar.

    Returns:
        The map with all motions, and what was searched.

    Raises:
        WrongTypeError, ValueError: if an argument cannot be used.
    """
    require_instance("result", result, MotionMap, "a MotionMap")
    whole_number("most_rounds", most_rounds, 1)
    motions = [cell.motions for cell in result.cells]
    fresh = {number: each for number, each in enumerate(motions)}
    tried = rounds = 0
    while fresh and rounds < most_rounds:
        cells = list(_candidates(result, motions, fresh))
        tried += sum(len(cell.orbits) for cell in cells)
        fresh = {}
        if not cells:
            break
        rounds += 1
        for found in _tried(result, cells, runner, rounds, quiet):
            new = _new(motions[found.number], found.motions)
            if new:
                motions[found.number] = (*motions[found.number], *new)
                fresh[found.number] = new
    cells_now = tuple(CellResult(number, those) for number, those in enumerate(motions))
    return Coexistence(MotionMap(result.inputs, cells_now), tried, rounds, not fresh)


def _tried(
    result: MotionMap, cells: list[Cell], runner: Runner | None, number: int, quiet: bool
) -> Iterator[CellResult]:
    """Yield what the starts of some cells lead to, behind a progress bar, in the order of the cells."""
    inputs = result.inputs
    if runner is None:
        runner = ProcessRunner() if len(cells) > FEW else SerialRunner()
    results = runner.results(CellWork(inputs.subject, inputs.places, inputs.settings), cells)
    bar = progress_bar(results, f"round {number}", quiet=quiet, total=len(cells))
    yield from sorted(bar, key=lambda found: found.number)


def _candidates(
    result: MotionMap, motions: list[tuple[CellMotion, ...]], fresh: dict[int, tuple[CellMotion, ...]]
) -> Iterator[Cell]:
    """Yield cells with the orbits of those around that are new there."""
    starts: dict[int, list[CellMotion]] = {}
    for number, each in fresh.items():
        orbits = [motion for motion in each if motion.kind is MotionKind.PERIODIC]
        for beside in _around(number, result.shape):
            known = starts.setdefault(beside, [])
            for orbit in orbits:
                if not any(_is_carried_on(orbit, other) for other in (*motions[beside], *known)):
                    known.append(orbit)
    for number in sorted(starts):
        if starts[number]:
            states = tuple(orbit.states for orbit in starts[number])
            yield Cell(number, result.inputs.cell_values(number), states)


def _around(number: int, shape: tuple[int, int]) -> Iterator[int]:
    row, column = divmod(number, shape[1])
    for beside_row in range(max(row - 1, 0), min(row + 2, shape[0])):
        for beside_column in range(max(column - 1, 0), min(column + 2, shape[1])):
            if (beside_row, beside_column) != (row, column):
                yield beside_row * shape[1] + beside_column


def _is_carried_on(orbit: CellMotion, other: CellMotion) -> bool:
    """Return whether two orbits of neighbouring cells look like one that is carried on."""
    return other.kind is MotionKind.PERIODIC and alike(orbit, other, CONTINUED)


def _new(known: tuple[CellMotion, ...], found: tuple[CellMotion, ...]) -> tuple[CellMotion, ...]:
    """Return which motions are none of those known; only orbits are known well enough to be new."""
    return tuple(
        motion
        for motion in found
        if motion.kind is MotionKind.PERIODIC and not any(same_motion(motion, other) for other in known)
    )
