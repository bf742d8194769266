"""Cells of a map as areas."""

from __future__ import annotations

from collections.abc import Mapping
from typing import TYPE_CHECKING

import numpy as np

from trimmer.arrays import Integers, Reals

if TYPE_CHECKING:
    from matplotlib.axes import Axes

SQUARE = np.array([(0.0, 0.0), (1.0, 0.0), (1.0, 1.0), (0.0, 1.0), (0.0, 0.0)])


def draw_cells(axes: Axes, first: Reals, second: Reals, cells: Integers, colours: Mapping[int, str]) -> None:
    """Draw cells as areas, one path for each colour, so that they change with the colours of the page.

    Args:
        axes: Where to draw.
        first: Values along a row, evenly spaced, (n1,).
        second: Values of the rows, evenly spaced, (n2,).
        cells: Numbers of colours, (n2, n1).
        colours: By their numbers.
    """
    from matplotlib.patches import PathPatch
    from matplotlib.path import Path

    (left, right, across), (low, high, up) = _ends(first), _ends(second)
    corners: dict[int, list[Path]] = {}
    for row, line in enumerate(cells):
        edges = np.flatnonzero(np.diff(line)) + 1
        for begin, end in zip([0, *edges], [*edges, len(line)], strict=True):
            corner, size = (left + begin * across, low + row * up), ((end - begin) * across, up)
            corners.setdefault(int(line[begin]), []).append(Path(corner + SQUARE * size, closed=True))
    for number, places in sorted(corners.items()):
        colour = colours[number]
        path = Path.make_compound_path(*places)
        axes.add_patch(PathPatch(path, facecolor=colour, edgecolor=colour, linewidth=0.6))  # no seams
    axes.set(xlim=(left, right), ylim=(low, high))


def _ends(values: Reals) -> tuple[float, float, float]:
    """Return where the first cell begins and the last one ends, and how long each is."""
    step = float(values[1] - values[0])
    return float(values[0]) - step / 2, float(values[-1]) + step / 2, step
