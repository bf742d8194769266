"""``make maps``: compute the maps, branches and searches that are kept with the code.

Each map is written cell by cell into a folder of ``build/maps``, and a run that was interrupted goes on from
there. The folder is named after the code that computes cells, so that nothing goes on from what other code
has computed. The files of ``report/data/twin`` are written at the end, from whole maps only.
"""

from __future__ import annotations

import sys
from argparse import ArgumentParser
from collections.abc import Sequence
from functools import partial
from pathlib import Path

from report.cache.source_closure import SourceTree
from report.numbers.future_work.all import ANSWERS
from report.numbers.twin.advice import LINES, climbed, search, write_advice
from report.numbers.twin.closed_loop import FILE as LOOP_FILE
from report.numbers.twin.closed_loop import LOOP_COURSES, without_friction
from report.numbers.twin.grids import COURSES, GRIDS, Grid, KeptCourse
from report.numbers.twin.kept_branch import FILE, settings_of, write_branches
from report.numbers.twin.kept_files import FOLDER
from report.numbers.twin.kept_map import write_map
from trimmer import FollowedBranch, follow
from trimmer.arrays import Reals
from trimmer.command_line.parser import INTERRUPTED
from trimmer.errors import MapFileError
from trimmer.maps.cells import CellResult
from trimmer.maps.inputs import MapInputs
from trimmer.maps.motion_map import MapInterruptedError, motion_map

WORK = Path("build") / "maps"
COMPUTES = "trimmer.maps.motion_map"
"""What computes cells."""
SHORT = 12
"""Digits of its digest that name a folder."""


def work_folder() -> Path:
    """Return the folder of the maps that are under way with the code as it is now."""
    return WORK / SourceTree.read().digest([COMPUTES])[:SHORT]


def make(work: Path, folder: Path = FOLDER, grids: Sequence[Grid] = GRIDS) -> None:
    """Compute the maps that are not there yet in a folder of work, and write the kept files into theirs.

    Raises:
        MapInterruptedError: after an interrupt; the next call goes on.
        FileWriteError: if a file cannot be written.
    """
    work.mkdir(parents=True, exist_ok=True)
    folder.mkdir(parents=True, exist_ok=True)
    for grid in grids:
        print(f"map {grid.name}: {grid.inputs.count} cells", file=sys.stderr)
        cells = _cells(grid.inputs, work / f"{grid.name}.map")
        beside = _cells(grid.beside, work / f"{grid.name}-beside.map")
        write_map(grid, cells, beside, folder)


def make_branches() -> None:
    """Follow the branches and write their files; they take seconds, so nothing of them is resumed."""
    write_branches([(each, _followed(each)) for each in COURSES], FILE)
    write_branches([(each, _followed(each, without_friction(each))) for each in LOOP_COURSES], LOOP_FILE)


def make_advice() -> None:
    """Search the boxes of the advice; it takes minutes, and nothing of it is resumed."""
    found = []
    for line in LINES:
        print(f"advice {line.id}", file=sys.stderr)
        found.append(climbed(search(line)))
    write_advice(found)


def make_answers() -> None:
    """Compute what the answers to section 6.4 rest on; it takes minutes, and nothing of it is resumed."""
    for answer in ANSWERS:
        print(f"answer {answer.name}", file=sys.stderr)
        answer.write()


def _followed(course: KeptCourse, state: Reals | None = None) -> FollowedBranch:
    print(f"branch {course.name}", file=sys.stderr)
    interval = course.place, course.start, course.stop
    return follow(course.subject, *interval, state=state, settings=settings_of(course))


def _cells(inputs: MapInputs, file: Path) -> list[CellResult]:
    values = dict(zip(inputs.places, inputs.values, strict=True))
    settings = inputs.settings
    made = partial(
        motion_map,
        inputs.mechanism,
        values,
        most_periods=settings.most_periods,
        starts=settings.starts,
        seed=settings.seed,
        file=file,
    )
    try:
        return list(made(resume=file.is_file()).cells)
    except MapFileError:  # it was begun with other inputs
        return list(made(overwrite=True).cells)


def main() -> int:
    """Make all; return the exit code."""
    try:
        make(work_folder())
        make_branches()
        make_advice()
        make_answers()
    except MapInterruptedError as interrupt:
        print(f"{str(interrupt).partition(';')[0]}; `make maps` goes on", file=sys.stderr)
        return INTERRUPTED
    return 0


if __name__ == "__main__":
    ArgumentParser(description=__doc__).parse_args()
    sys.exit(main())
