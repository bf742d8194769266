"""A map of motions as it is kept: kinds and measures of each cell, and which of them rounding can change."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass
from functools import cached_property
from pathlib import Path
from typing import Any, Final

import numpy as np

from report.numbers.twin.grids import Grid
from report.numbers.twin.kept_files import DIGITS, FOLDER, read_kept, rounded, write_kept
from report.numbers.twin.mechanism import BLADE, CUTTER, MOTOR, STROKE
from trimmer import MotionKind
from trimmer.arrays import Integers, Reals
from trimmer.contact.flow import MechanismFlow
from trimmer.maps.cell_motion import CellMotion
from trimmer.maps.cells import CellResult
from trimmer.maps.inputs import MapInputs, varied
from trimmer.motion.fourier import fourier
from trimmer.motion.signals import read

CellKinds = np.ndarray[tuple[int, int], np.dtype[np.str_]]
LETTERS: Final = {
    MotionKind.PERIODIC: "p",
    MotionKind.REST: "r",
    MotionKind.TORUS: "t",
    MotionKind.CHAOTIC: "c",
    MotionKind.DIVERGING: "d",
    MotionKind.UNDECIDED: "u",
}
"""What stands for a kind of motion in a file."""
MEASURES: Final = ("stroke", "motor", "cutter", "wear", "impacts", "impact_speed", "second")
"""Measures that are kept: peak to peak, m; root mean square acceleration of motor and cutter, m/s²; power
lost in the blade's friction, W; contacts made per drive period; their largest speed, m/s; second harmonic of
a stroke that repeats, m."""
VANISHING: Final = 1e-12
"""Second harmonic that is only rounding, m."""
FEW_DIGITS: Final = 4
"""Significant digits of what does not repeat, and is measured over a window."""
SAME: Final = 1e-7
"""Relative difference of two measures of one orbit."""


@dataclass(frozen=True)
class KeptCell:
    """What is kept of one motion.

    Attributes:
        kind: Letter of its kind.
        period_count: Drive periods after which it repeats, 0 if it does not.
        measures: In the order of ``MEASURES``; None where the motion failed.
    """

    kind: str
    period_count: int
    measures: tuple[float | None, ...]

    @property
    def words(self) -> str:
        """What it is, in words."""
        if self.kind == LETTERS[MotionKind.PERIODIC]:
            return f"a motion that repeats after {self.period_count} drive periods"
        names = {"r": "rest", "t": "a torus", "c": "a chaotic motion", "d": "a motion that grows"}
        return names.get(self.kind, "a motion that has not settled")

    def agrees(self, other: KeptCell) -> bool:
        """Return whether it is the same motion as far as that can be told.

        Two periodic motions are compared in all their measures; of others only the kind is.
        """
        if (self.kind, self.period_count) != (other.kind, other.period_count):
            return False
        if self.kind != LETTERS[MotionKind.PERIODIC]:
            return True
        pairs = zip(self.measures, other.measures, strict=True)
        return all(_same(first, second) for first, second in pairs)


def _same(first: float | None, second: float | None) -> bool:
    if first is None or second is None:  # one of them was not measured
        return True
    return abs(first - second) <= SAME * max(abs(first), abs(second), 1e-6)


def kept_cell(inputs: MapInputs, result: CellResult, *, whole: bool = True) -> KeptCell:
    """Return what is kept of the motion from rest in a cell; without the second harmonic if not ``whole``."""
    motion = result.motions[0]
    found = motion.measures
    measures: tuple[float | None, ...] = (None,) * len(MEASURES)
    if found is not None:
        measures = (
            found.peak_to_peak[STROKE],
            found.rms_acceleration[MOTOR],
            found.rms_acceleration[CUTTER],
            found.wear_power[BLADE],
            found.impacts,
            found.impact_speed,
            _second_harmonic(inputs, result.number, motion) if whole else None,
        )
    digits = DIGITS if motion.kind is MotionKind.PERIODIC else FEW_DIGITS
    return KeptCell(
        LETTERS[motion.kind], motion.period_count, tuple(rounded(each, digits) for each in measures)
    )


def _second_harmonic(inputs: MapInputs, number: int, motion: CellMotion) -> float | None:
    """Return the amplitude of twice the drive in the stroke of a motion that repeats, m."""
    if motion.kind is not MotionKind.PERIODIC:
        return None
    flow = MechanismFlow.returning(varied(inputs.mechanism, inputs.places, inputs.cell_values(number)))
    course = flow.course(flow.at(np.array(motion.states[0])), motion.period_count)
    nodes, omega = course.nodes, flow.modes.system.layout.omega
    stroke = read(course, [flow.outputs[STROKE]], nodes.rows, nodes.states)
    second = abs(fourier(course, stroke, 2 * omega, 1)[0, 0])
    return float(second) if second > VANISHING else 0.0


@dataclass(frozen=True, eq=False)
class KeptMap:
    """A map as it is kept. Arrays have the shape (n2, n1); the first place varies along a row.

    Attributes:
        grid: What it is made from.
        cells: The motion from rest in each cell, row by row.
        beside: What ``grids.ASIDE`` beside rest led to, by the number of the cell, where that is another.
        motions: Number of motions found in each cell from all starts of the grid, row by row.
    """

    grid: Grid
    cells: tuple[KeptCell, ...]
    beside: Mapping[int, KeptCell]
    motions: tuple[int, ...]

    @cached_property
    def values(self) -> tuple[Reals, Reals]:
        """Values of both places, SI units."""
        first, second = (np.array(each) for each in self.grid.inputs.values)
        return first, second

    @property
    def shape(self) -> tuple[int, int]:
        """(n2, n1)."""
        first, second = self.values
        return len(second), len(first)

    @cached_property
    def kind(self) -> CellKinds:
        """Letters of the kinds."""
        return np.array([cell.kind for cell in self.cells]).reshape(self.shape)

    @cached_property
    def period_count(self) -> Integers:
        """Drive periods after which a motion repeats, 0 where it does not."""
        return np.array([cell.period_count for cell in self.cells], dtype=np.int64).reshape(self.shape)

    @cached_property
    def settled(self) -> np.ndarray[tuple[int, int], np.dtype[np.bool_]]:
        """Where rest and a start beside it led to the same motion."""
        return np.array([number not in self.beside for number in range(len(self.cells))]).reshape(self.shape)

    @cached_property
    def motion_count(self) -> Integers:
        """Number of motions found."""
        return np.array(self.motions, dtype=np.int64).reshape(self.shape)

    def measure(self, name: str) -> Reals:
        """Return one of ``MEASURES``; NaN where a motion failed, or has no second harmonic of its own."""
        return self._measures[MEASURES.index(name)]

    @cached_property
    def _measures(self) -> Reals:
        rows = [[np.nan if each is None else each for each in cell.measures] for cell in self.cells]
        return np.array(rows, dtype=float).T.reshape(len(MEASURES), *self.shape)


def write_map(grid: Grid, cells: list[CellResult], beside: list[CellResult], folder: Path) -> None:
    """Keep a map; ``beside`` are its cells from a start next to rest."""
    inputs = grid.inputs
    kept = [kept_cell(inputs, cell) for cell in cells]
    others = [kept_cell(inputs, cell, whole=False) for cell in beside]
    content = {"made from": grid.inputs.header["mechanism"], **_tables(kept, len(inputs.values[0]))}
    content["beside"] = [
        [number, other.kind, other.period_count, *other.measures]
        for number, (cell, other) in enumerate(zip(kept, others, strict=True))
        if not cell.agrees(other)
    ]
    content["motions"] = [len(cell.motions) for cell in cells]
    write_kept(path_of(grid, folder), inputs_of(grid), content)


def read_map(grid: Grid, folder: Path = FOLDER) -> KeptMap:
    """Return a map that is kept.

    Raises:
        KeptDataError: if its file is not there, was made from something else, or has been changed since.
    """
    content = read_kept(path_of(grid, folder), inputs_of(grid))
    beside = {
        number: KeptCell(kind, count, tuple(measures)) for number, kind, count, *measures in content["beside"]
    }
    return KeptMap(grid, _cells(content), beside, tuple(content["motions"]))


def path_of(grid: Grid, folder: Path = FOLDER) -> Path:
    """Return the file of a map."""
    return folder / f"{grid.name}.json"


def inputs_of(grid: Grid) -> str:
    """Return the SHA-256 of mechanism, places, values and settings."""
    return str(grid.inputs.header["inputs"])


def _tables(kept: list[KeptCell], columns: int) -> dict[str, Any]:
    rows = [kept[begin : begin + columns] for begin in range(0, len(kept), columns)]
    return {
        "kind": ["".join(cell.kind for cell in row) for row in rows],
        "period_count": [[cell.period_count for cell in row] for row in rows],
        **{name: [[cell.measures[at] for cell in row] for row in rows] for at, name in enumerate(MEASURES)},
    }


def _cells(tables: Mapping[str, Any]) -> tuple[KeptCell, ...]:
    kinds = "".join(tables["kind"])
    counts = [count for row in tables["period_count"] for count in row]
    measures = zip(*([value for row in tables[name] for value in row] for name in MEASURES), strict=True)
    return tuple(map(KeptCell, kinds, counts, measures))
