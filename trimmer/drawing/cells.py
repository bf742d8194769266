"""Cells of a map as areas, one path for each colour."""

from collections.abc import Mapping
from types import MappingProxyType
from typing import Any

import numpy as np
from matplotlib.axes import Axes
from matplotlib.patches import PathPatch
from matplotlib.path import Path

from trimmer.arrays import Integers, Reals

INK = "#404040"
"""Colour of hatching."""
NO_HATCHES: Mapping[int, str] = MappingProxyType({})
SQUARE = np.array([(0.0, 0.0), (1.0, 0.0), (1.0, 1.0), (0.0, 1.0), (0.0, 0.0)])


def draw_cells(
    axes: Axes,
    first: Reals,
    second: Reals,
    cells: Integers,
    colours: Mapping[int, str],
    hatches: Mapping[int, str] = NO_HATCHES,
) -> None:
    """Draw cells, (n2, n1), as areas over values, (n1,) and (n2,), one path for each colour.

    So they change with the colours of a page. A cell reaches half way to the next value; values may come
    in any order.
    """
    columns, rows = np.argsort(first), np.argsort(second)
    across, up = edges(first[columns]), edges(second[rows])
    corners: dict[int, list[Path]] = {}
    for row, numbers in enumerate(cells[np.ix_(rows, columns)]):
        changes = np.flatnonzero(np.diff(numbers)) + 1
        for begin, end in zip([0, *changes], [*changes, len(numbers)], strict=True):
            corner, size = (across[begin], up[row]), (across[end] - across[begin], up[row + 1] - up[row])
            corners.setdefault(int(numbers[begin]), []).append(Path(corner + SQUARE * size, closed=True))
    for number, places in sorted(corners.items()):
        path = Path.make_compound_path(*places)
        colour = colours[number]
        axes.add_patch(PathPatch(path, facecolor=colour, edgecolor=colour, linewidth=0.6))  # no seams
        if hatches.get(number):
            axes.add_patch(PathPatch(path, fill=False, linewidth=0, edgecolor=INK, hatch=hatches[number]))
    axes.set(xlim=(across[0], across[-1]), ylim=(up[0], up[-1]))


def draw_values(
    axes: Axes, first: Reals, second: Reals, values: Reals, label: str, colours: Mapping[str, Any]
) -> None:
    """Draw values, (n2, n1), over rising ones, (n1,) and (n2,), in colours of Matplotlib, with a bar of them.

    What is not a number stays blank.
    """
    mesh = axes.pcolormesh(edges(first), edges(second), values, rasterized=True, **colours)
    figure = axes.get_figure(root=True)
    assert figure is not None
    figure.colorbar(mesh, ax=axes, label=label)


def edges(values: Reals) -> Reals:
    """Return where cells begin and end around rising values, (n + 1,)."""
    if len(values) == 1:
        half = abs(values[0]) / 2 or 0.5
        return np.array([values[0] - half, values[0] + half])
    middles = (values[:-1] + values[1:]) / 2
    first, last = 2 * values[0] - middles[0], 2 * values[-1] - middles[-1]
    return np.concatenate([[first], middles, [last]])
