"""What the kept maps say: shares of kinds, how far the drive's period lasts, where even harmonics are."""

from collections.abc import Mapping
from dataclasses import dataclass

import numpy as np

from report.numbers.twin.kept_map import KeptMap
from trimmer.arrays import Reals

Cells = np.ndarray[tuple[int, int], np.dtype[np.bool_]]
SEEN = 1e-6  # Second harmonic from which a motion counts as not symmetric, m
TOLERANCE = 1e-9  # Distance from a grid value at which a limit still includes it, relative to the limit


@dataclass(frozen=True, eq=False)
class MapNumbers:
    """A kept map, and what it says."""

    kept: KeptMap  # The map

    @property
    def cells(self) -> int:
        """Number of cells."""
        return len(self.kept.cells)

    @property
    def first(self) -> Reals:
        """Values of the place that varies along a row."""
        return self.kept.values[0]

    @property
    def second(self) -> Reals:
        """Values of the other place."""
        return self.kept.values[1]

    @property
    def single(self) -> Cells:
        """Where the motion repeats with the drive."""
        return np.asarray(self.kept.period_count == 1)

    @property
    def chaotic(self) -> Cells:
        """Where it is chaotic."""
        return np.asarray(self.kept.kind == "c")

    @property
    def shares(self) -> Mapping[str, float]:
        """Share of cells by kind: ``one``, ``three``, ``other`` periods, ``torus``, ``chaotic``, ``open``."""
        kind, count = self.kept.kind, self.kept.period_count
        kinds = {
            "one": count == 1,
            "three": count == 3,
            "other": (count == 2) | (count > 3),
            "torus": kind == "t",
            "chaotic": kind == "c",
            "open": kind == "u",
        }
        return {name: float(cells.mean()) for name, cells in kinds.items()}

    @property
    def by_rounding(self) -> float:
        """Share of cells in which a start next to rest led to another motion."""
        return float(1 - self.kept.settled.mean())

    @property
    def several(self) -> float:
        """Share of cells in which the starts led to several motions."""
        return float((self.kept.motion_count > 1).mean())

    def row(self, second: float) -> int:
        """Return the row nearest to a value of the second place."""
        return int(abs(self.second - second).argmin())

    def column(self, first: float) -> int:
        """Return the column nearest to a value of the first place."""
        return int(abs(self.first - first).argmin())

    def reach(self, second: float) -> float:
        """Return the largest value of the first place up to which a row repeats with the drive throughout.

        NaN if not even the first cell does.
        """
        return float(self.reaches[self.row(second)])

    @property
    def reaches(self) -> Reals:
        """The same of all rows, (n2,)."""
        lasting = np.logical_and.accumulate(self.single, axis=1).sum(axis=1)
        return np.array([self.first[count - 1] if count else np.nan for count in lasting])

    @property
    def common_reach(self) -> float:
        """The largest value of the first place up to which every row repeats with the drive."""
        return float(np.min(self.reaches))

    def from_where_on(self, first: float) -> float:
        """Return the smallest value of the second place from which a column repeats with the drive.

        It does so in every cell from there to the end; infinity if not even in the last one.
        """
        single = self.single[::-1, self.column(first)]
        lasting = int(np.logical_and.accumulate(single).sum())
        return float(self.second[::-1][lasting - 1]) if lasting else float("inf")

    def within(self, first: tuple[float, float], second: tuple[float, float]) -> Cells:
        """Return the cells between limits of both places, limits included."""
        columns, rows = (
            (values >= low - TOLERANCE * high) & (values <= high * (1 + TOLERANCE))
            for values, (low, high) in ((self.first, first), (self.second, second))
        )
        return np.asarray(rows[:, None] & columns[None, :])

    @property
    def asymmetric(self) -> Cells:
        """Where the motion repeats with the drive, and has even harmonics."""
        return np.asarray(self.single & (np.nan_to_num(self.kept.measure("second")) > SEEN))

    @property
    def largest_second(self) -> tuple[float, float, float]:
        """Largest second harmonic of a motion that repeats with the drive, m, and the values of its cell."""
        second = np.where(self.single, np.nan_to_num(self.kept.measure("second")), 0.0)
        row, column = np.unravel_index(int(second.argmax()), second.shape)
        return float(second[row, column]), float(self.first[column]), float(self.second[row])

    def largest(self, measure: str, cells: Cells | None = None) -> float:
        """Return the largest of a measure, of some cells or of all."""
        values = self.kept.measure(measure)
        return float(np.nanmax(values if cells is None else values[cells]))
