"""Maps of kinds of motion over two numbers."""

from __future__ import annotations

from typing import TYPE_CHECKING

import numpy as np

from report.design.quantities import place_words, scale_for
from report.pages.drawing.style import new_figure
from trimmer.drawing.cells import draw_cells
from trimmer.drawing.look import plain_label
from trimmer.drawing.mechanisms.kinds import categories, category, legend_of

if TYPE_CHECKING:
    from matplotlib.figure import Figure

    from trimmer.design.kept_map import DesignMap
    from trimmer.design.varied_places import Varied


def kind_map(drawn: DesignMap) -> Figure:
    """Draw the kinds of motion as areas, and the working point."""
    result = drawn.result
    names = [category(cell.motions[0]) for cell in result.cells]
    legend = [each for each in categories() if each in names]
    numbers = np.array([legend.index(each) for each in names]).reshape(result.shape)
    first, second = (
        scale_for(values, each.unit) for values, each in zip(result.values, _sides(drawn), strict=True)
    )
    figure = new_figure(3.5)
    axes = figure.add_subplot()
    colours = {number: each.colour for number, each in enumerate(legend)}
    hatches = {number: each.hatch for number, each in enumerate(legend)}
    across, up = (values / scale.factor for values, scale in zip(result.values, (first, second), strict=True))
    draw_cells(axes, across, up, numbers, colours, hatches)
    axes.plot(
        drawn.first.value / first.factor, drawn.second.value / second.factor, "o",
        color="white", markeredgecolor="black", markersize=7, clip_on=False,
    )  # fmt: skip
    axes.set(
        xlabel=f"{plain_label(place_words(drawn.first.place))} [{first.unit}]",
        ylabel=f"{plain_label(place_words(drawn.second.place))} [{second.unit}]",
    )
    axes.grid(visible=False)
    axes.legend(
        handles=legend_of(legend, result.inputs.settings.most_periods),
        loc="upper left",
        bbox_to_anchor=(1.01, 1.0),
    )
    return figure


def _sides(drawn: DesignMap) -> tuple[Varied, Varied]:
    return drawn.first, drawn.second
