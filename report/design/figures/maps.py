"""Maps of kinds of motion over two numbers."""

from __future__ import annotations

from typing import TYPE_CHECKING

import numpy as np

from report.design.quantities import place_words, scale_for
from report.drawing.cells import draw_cells
from report.drawing.style import new_figure
from trimmer.maps.drawing import categories, category

if TYPE_CHECKING:
    from matplotlib.figure import Figure

    from trimmer.design.kept_map import DesignMap
    from trimmer.design.varied_places import Varied


def kind_map(drawn: DesignMap) -> Figure:
    """Draw the kinds of motion as areas, and the working point."""
    from matplotlib.patches import Patch

    result = drawn.result
    names = [category(cell.motions[0]) for cell in result.cells]
    legend = [each for each in categories() if each in names]
    numbers = np.array([legend.index(each) for each in names]).reshape(result.shape)
    first, second = (
        scale_for(values, each.unit) for values, each in zip(result.values, _sides(drawn), strict=True)
    )
    figure = new_figure(3.5)
    axes = figure.add_subplot()
    colours = {number: colour for number, (_, colour) in enumerate(legend)}
    draw_cells(axes, result.values[0] / first.factor, result.values[1] / second.factor, numbers, colours)
    axes.plot(
        drawn.first.value / first.factor, drawn.second.value / second.factor, "o",
        color="white", markeredgecolor="black", markersize=7, clip_on=False,
    )  # fmt: skip
    axes.set(
        xlabel=f"{place_words(drawn.first.place)} [{first.unit}]",
        ylabel=f"{place_words(drawn.second.place)} [{second.unit}]",
    )
    axes.grid(visible=False)
    handles = [Patch(facecolor=colour, edgecolor="0.4", label=name) for name, colour in legend]
    axes.legend(handles=handles, loc="upper left", bbox_to_anchor=(1.01, 1.0))
    return figure


def _sides(drawn: DesignMap) -> tuple[Varied, Varied]:
    return drawn.first, drawn.second
