"""The branch through the working point over one number, with its special points."""

from __future__ import annotations

import itertools
from typing import TYPE_CHECKING

import numpy as np

from report.design.quantities import place_words, scale_for
from report.pages.drawing.style import BLACK, LINES, panels
from trimmer.branches.special import SpecialKind
from trimmer.drawing.look import plain_label

if TYPE_CHECKING:
    from matplotlib.axes import Axes
    from matplotlib.figure import Figure

    from report.design.quantities import Scale
    from trimmer.design.paths import NumberPath, Side

MARKERS = {
    SpecialKind.GRAZING: ("o", "grazing"),
    SpecialKind.STICK: ("s", "stick begins or ends"),
    SpecialKind.FOLD: ("v", "fold"),
    SpecialKind.PERIOD_DOUBLING: ("D", "period doubling"),
    SpecialKind.TORUS: ("P", "torus"),
    SpecialKind.SYMMETRY_BREAKING: ("X", "loss of symmetry"),
}
BLUE = LINES[0]["color"]


def branch(path: NumberPath, output: str) -> Figure:
    """Draw peak to peak of an output along a branch: stable orbits solid, unstable ones dashed."""
    sides = [side for side in (path.down, path.up) if side is not None]
    strokes = np.concatenate([side.stroke[output] for side in sides])
    values = np.concatenate([side.values for side in sides])
    across, up = scale_for(values, path.varied.unit), scale_for(strokes, "m")
    figure, axes = panels(3.1)
    for side in sides:
        _line(axes, side, output, across, up)
    seen: set[SpecialKind] = set()
    for side in sides:
        _special(axes, side, output, across, up, seen)
    begin = sides[0].stroke[output][0]
    axes.plot(
        path.varied.value / across.factor,
        begin / up.factor,
        "o",
        color=BLACK,
        markersize=6,
        label="as in the file",
    )
    axes.set(
        xlabel=f"{plain_label(place_words(path.varied.place))} [{across.unit}]",
        ylabel=f"{plain_label(output)}, peak to peak [{up.unit}]",
    )
    axes.legend(loc="upper left", bbox_to_anchor=(1.01, 1.0))
    return figure


def _line(axes: Axes, side: Side, output: str, across: Scale, up: Scale) -> None:
    values, strokes = side.values / across.factor, side.stroke[output] / up.factor
    for stable, group in itertools.groupby(range(len(values)), key=lambda at: bool(side.stable[at])):
        places = list(group)
        part = slice(max(places[0] - 1, 0), places[-1] + 1)
        style, width = ("solid", 1.6) if stable else ("dashed", 0.9)
        axes.plot(values[part], strokes[part], color=BLUE, linestyle=style, linewidth=width)


def _special(axes: Axes, side: Side, output: str, across: Scale, up: Scale, seen: set[SpecialKind]) -> None:
    for each in side.special:
        mark, name = MARKERS[each.kind]
        label = None if each.kind in seen else name
        seen.add(each.kind)
        axes.plot(
            each.value / across.factor, each.stroke[output] / up.factor, mark,
            color=BLACK, markerfacecolor="white", markersize=5, markeredgewidth=0.9, linestyle="none",
            label=label,
        )  # fmt: skip
