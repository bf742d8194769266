"""Maps over numbers of a mechanism: the cells that are left are done, kept, and put together."""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Mapping
from pathlib import Path
from typing import TYPE_CHECKING

from trimmer.arguments import file_path, whole_number
from trimmer.errors import MapError
from trimmer.maps import checkpoint
from trimmer.maps.cells import Cell, CellResult, CellWork
from trimmer.maps.inputs import MapInputs, Settings, checked_inputs
from trimmer.maps.result import MotionMap
from trimmer.motion.chosen import chosen_measure
from trimmer.progress import progress_bar
from trimmer.response.by_itself.self_excited import STRETCHES
from trimmer.response.flows import flow_of, require_subject
from trimmer.response.periodic.pace import is_driven, pace_of
from trimmer.runners import ProcessRunner, Runner, SerialRunner

if TYPE_CHECKING:
    from numpy.typing import ArrayLike

    from trimmer.loops.loops import Loop
    from trimmer.mechanism.mechanism import Mechanism

FEW = 12  # Cells up to which other processes are not worth their beginning


class MapInterruptedError(KeyboardInterrupt):
    """A map was interrupted; the message says how many cells are done, and how to go on."""


MOST_PERIODS = 300  # Drive periods that are waited if no number is given


def motion_map(  # noqa: PLR0913 (each is a choice of its own, all but two with a default)
    mechanism: Mechanism | Loop,
    values: Mapping[str, ArrayLike],
    *,
    most_periods: int | None = None,
    starts: int = 1,
    seed: int = 0,
    measures: Iterable[str] = (),
    runner: Runner | None = None,
    file: Path | str | None = None,
    resume: bool = False,
    overwrite: bool = False,
    quiet: bool = False,
) -> MotionMap:
    """Tell over one number of a mechanism or two what it settles to.

    Each cell is followed from rest, or from the mechanism's own start, until it has settled. No cell knows of
    another, so order and processes never matter. A progress bar shows on a terminal. An interrupt leaves the
    file as it is after the last whole cell.

    Args:
        mechanism: The mechanism or loop. Of a loop that has neither a drive nor a start each cell has the
            stable orbits that ``periodic_orbits`` finds.
        values: Values, in SI units, by their dotted places, one place or two; the first runs along a row.
        most_periods: Drive periods to wait at most in each cell, 300 if not given; 16 samples for one, where
            these alone drive. Without a drive periods of the slowest mode, 1700 if not given.
        starts: Starts of each cell; those after the first are random.
        seed: Seed of the random starts; each cell has its own numbers.
        measures: Keys of further measures, such as ``contacts.bridge.impact_speed``: those of the JSON of
            ``trimmer respond``; see ``trimmer.motion.chosen``.
        runner: Who does the work; by default processes on all cores, for a few cells this one.
        file: Where each cell is kept as soon as it is done; see ``trimmer.maps.checkpoint``.
        resume: Go on with that file.
        overwrite: Replace that file.
        quiet: Show no progress bar.

    Returns:
        The map.

    Raises:
        MechanismError: if there is no such place, or a value cannot stand there with any of the others.
        MapError: if there is not one place or two, or no value, or several starts of a loop without a drive.
        ChoiceError: if there is no such measure.
        MapFileError: if the file cannot be gone on with.
        FileWriteError: if the file cannot be written.
        MapInterruptedError: after an interrupt.
    """
    require_subject(mechanism)
    settings = Settings(
        _periods(mechanism, most_periods),
        whole_number("starts", starts, 1),
        whole_number("seed", seed, 0),
        tuple(measures),
    )
    inputs = checked_inputs(mechanism, values, settings)
    for key in settings.measures:
        chosen_measure(flow_of(mechanism), key)
    target = None if file is None else file_path("file", file)
    if target is None and (resume or overwrite):
        raise MapError(f"{'resume' if resume else 'overwrite'} is of a file: name it")
    done: dict[int, CellResult] = {}
    if target is not None and resume:
        done = {result.number: result for result in checkpoint.resumed(target, inputs)}
    elif target is not None:
        checkpoint.begin(target, inputs, overwrite=overwrite)
    for result in _computed(inputs, done, runner, target, quiet):
        done[result.number] = result
    return MotionMap(inputs, tuple(done[number] for number in range(inputs.count)))


def _periods(mechanism: Mechanism | Loop, most_periods: int | None) -> int:
    if most_periods is None and not is_driven(mechanism):
        return sum(STRETCHES)
    most_periods = MOST_PERIODS if most_periods is None else most_periods
    return whole_number("most_periods", most_periods, 2) * pace_of(mechanism)


def _computed(
    inputs: MapInputs, done: Mapping[int, CellResult], runner: Runner | None, target: Path | None, quiet: bool
) -> Iterator[CellResult]:
    """Yield the cells that are left as they come, behind a progress bar, and keep them in the file."""
    left = [number for number in range(inputs.count) if number not in done]
    if not left:
        return
    if runner is None:
        runner = ProcessRunner() if len(left) > FEW else SerialRunner()
    work = CellWork(inputs.subject, inputs.places, inputs.settings)
    cells = (Cell(number, inputs.cell_values(number)) for number in left)
    results = iter(runner.results(work, cells))
    kept = results if target is None else checkpoint.append(target, results)
    finished = len(done)
    bar = progress_bar(description="cells", quiet=quiet, total=inputs.count, initial=finished)
    try:
        with bar:
            for result in kept:
                finished += 1
                bar.update()
                yield result
    except KeyboardInterrupt:
        raise MapInterruptedError(_how_to_go_on(finished, inputs.count, target)) from None


def _how_to_go_on(finished: int, count: int, target: Path | None) -> str:
    begun = f"interrupted after {finished} of {count} cells"
    if target is None:
        return f"{begun}, which are lost; name a file (--output) to be able to go on"
    return f"{begun}, which {target} holds; the same call with resume (--resume) goes on"
