"""Measures over a number that nobody knows."""

from __future__ import annotations

from typing import TYPE_CHECKING

import numpy as np

from report.design.quantities import place_words, scale_for
from report.pages.drawing.style import FAINT, LINES, panels
from trimmer.drawing.look import plain_label

if TYPE_CHECKING:
    from collections.abc import Mapping, Sequence

    from matplotlib.figure import Figure

    from trimmer.design.design_file import OpenRange
    from trimmer.design.ranges import RangeStudy
    from trimmer.design.targets import Target
    from trimmer.design.trial import Asked


def over_range(
    study: RangeStudy,
    of: OpenRange,
    asked: Sequence[tuple[Asked, str]],
    bounds: Mapping[Asked, float],
    targets: tuple[Target, ...],
) -> Figure:
    """Draw measures at the points of a study over one of its numbers."""
    at = study.ranges.index(of)
    values = np.array([trial.values[at] for trial in study.trials])
    met = np.array([not targets or trial.meets(targets) for trial in study.trials])
    across = scale_for(values, of.unit)
    rows = -(-len(asked) // 2)
    figure, all_axes = panels(0.4 + 1.7 * rows, rows, min(len(asked), 2), squeeze=False)
    flat = list(all_axes.flat)
    for axes, (each, name) in zip(flat, asked, strict=False):
        found = np.array([trial.value(each.measure, each.part) for trial in study.trials])
        up = scale_for([*found, bounds.get(each, 0.0)], each.measure.value)
        colour = LINES[0]["color"]
        for chosen, face in ((met, colour), (~met, "white")):
            axes.plot(
                values[chosen] / across.factor, found[chosen] / up.factor, "o",
                color=colour, markerfacecolor=face, markersize=4, linestyle="none",
            )  # fmt: skip
        if each in bounds:
            axes.axhline(bounds[each] / up.factor, **FAINT)
        axes.set(xlabel=f"{plain_label(place_words(of.place))} [{across.unit}]", ylabel=f"[{up.unit}]")
        axes.set_title(plain_label(name))
    for axes in flat[len(asked) :]:
        axes.set_axis_off()
    return figure
