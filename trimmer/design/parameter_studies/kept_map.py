"""Maps whose rows are kept as soon as they are whole, so that an interrupted one goes on where it was."""

import math
from collections.abc import Callable
from dataclasses import dataclass
from functools import partial

from trimmer.design.parameter_studies.keeping import Keeper
from trimmer.design.settings import DesignSettings
from trimmer.design.specification.targets import Measure, Target, followers, is_switched
from trimmer.design.trials.trial import MeasureOfPart, TrialWork
from trimmer.design.varied_places import VariedNumber
from trimmer.maps.cell_motion import CellMotion
from trimmer.maps.cells import Cell, CellResult, CellWork
from trimmer.maps.inputs import MapInputs, Settings, checked_inputs
from trimmer.maps.measures import CellMeasures
from trimmer.maps.result import MotionMap
from trimmer.mechanism.mechanism import Mechanism
from trimmer.response.results.response import MotionKind
from trimmer.runners.runner import Runner

Told = Callable[[int, int], None]  # Is told how many rows of how many are done
Row = tuple[CellResult, ...]


@dataclass(frozen=True, eq=False)
class DesignMap:
    """Which motion a mechanism settles to over two numbers.

    Attributes:
        first, second: What varies along a row, and from row to row.
        result: The map.
        targets: Those that are drawn over these numbers; the map has their measures.
    """

    first: VariedNumber
    second: VariedNumber
    result: MotionMap
    targets: tuple[Target, ...] = ()


def design_map(  # noqa: PLR0913 (each is a choice of its own)
    mechanism: Mechanism,
    first: VariedNumber,
    second: VariedNumber,
    settings: DesignSettings,
    runner: Runner,
    keeper: Keeper,
    told: Told,
    targets: tuple[Target, ...] = (),
    *,
    stepped: bool = False,
) -> DesignMap | None:
    """Tell what the mechanism settles to over two numbers, each cell from rest or the file's own start.

    Rows are kept as they come. Where controllers are ``stepped``, cells tell whether all rests or hunts.
    None if the runner left cells out.
    """
    values = {each.place: each.values(settings.cells) for each in (first, second)}
    of_map, asked = Settings(settings.cell_periods, measures=keys_of(targets)), asked_of(targets)
    work: Callable[[Cell], CellResult]
    if stepped and not asked:
        asked = tuple(MeasureOfPart(Measure.HUNTING, name) for name in followers(mechanism))
    if stepped or is_switched(mechanism, (each.measure for each in asked)):
        inputs = MapInputs(mechanism, tuple(values), tuple(map(tuple, values.values())), of_map)
        work = TriedCells(mechanism, inputs.places, asked)
    else:
        inputs = checked_inputs(mechanism, values, of_map)
        work = CellWork(inputs.subject, inputs.places, inputs.settings)
    rows = _rows(inputs, work, runner, keeper, told)
    if rows is None:
        return None
    return DesignMap(first, second, MotionMap(inputs, tuple(cell for row in rows for cell in row)), targets)


def keys_of(targets: tuple[Target, ...]) -> tuple[str, ...]:
    """Return the keys of what targets bound, without that of a period."""
    return tuple(each.column for each in asked_of(targets))


def asked_of(targets: tuple[Target, ...]) -> tuple[MeasureOfPart, ...]:
    """Return what targets bound, without a period."""
    asked = (MeasureOfPart(each.measure, each.part) for each in targets if each.measure is not Measure.PERIOD)
    return tuple(dict.fromkeys(asked))


@dataclass(frozen=True)
class TriedCells:
    """The work of a cell of a map of a machine that switches, or whose controllers follow steps."""

    mechanism: Mechanism
    places: tuple[str, ...]
    asked: tuple[MeasureOfPart, ...]

    def __call__(self, cell: Cell) -> CellResult:
        """Return what it does from its start with the values of a cell."""
        trial = TrialWork(self.mechanism, self.places, self.asked, 0)(cell.values)
        if trial.kind is None:
            return CellResult(cell.number, (CellMotion(MotionKind.UNDECIDED, failure="it has no motion"),))
        found = {each.column: size if math.isfinite(size) else math.nan for each, size in trial.measures}
        measures = CellMeasures({}, {}, {}, 0.0, 0.0, 0.0, chosen=found)
        return CellResult(cell.number, (CellMotion(trial.kind, measures=measures),))


def _rows(
    inputs: MapInputs, work: Callable[[Cell], CellResult], runner: Runner, keeper: Keeper, told: Told
) -> list[Row] | None:
    columns, digest = len(inputs.values[0]), inputs.header["inputs"]
    count = inputs.count // columns
    # They are read now, not looked for again at the end: whoever clears the folder meanwhile spoils nothing.
    kept = {row: keeper.kept("row", (digest, row)) for row in range(count)}
    whole: dict[int, Row] = {row: found for row, found in kept.items() if found is not None}
    missing = [row for row in range(count) if row not in whole]
    done = count - len(missing)
    if missing:
        told(done, count)
    numbers = [row * columns + column for row in missing for column in range(columns)]
    pending: dict[int, dict[int, CellResult]] = {row: {} for row in missing}
    cells = (Cell(number, inputs.cell_values(number)) for number in numbers)
    for result in runner.results(work, cells) if numbers else ():
        row = result.number // columns
        pending[row][result.number] = result
        if len(pending[row]) == columns:
            cells_of_row = pending.pop(row)
            found = tuple(cells_of_row[number] for number in sorted(cells_of_row))
            whole[row] = keeper.made("row", (digest, row), partial(tuple, found))
            done += 1
            told(done, count)
    return [whole[row] for row in range(count)] if len(whole) == count else None
