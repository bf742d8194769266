"""Which number changes a measure by how much, as bars with signs."""

from __future__ import annotations

from typing import TYPE_CHECKING

from report.design.quantities import place_words
from report.pages.drawing.style import BLACK, LINES, panels
from trimmer.drawing.look import plain_label

if TYPE_CHECKING:
    from collections.abc import Sequence

    from matplotlib.figure import Figure

    from trimmer.design.sensitivity import Sensitivities
    from trimmer.design.trial import Asked

MOST = 7
"""Bars for each measure."""


def influences(sensitivities: Sensitivities, asked: Sequence[tuple[Asked, str]]) -> Figure:
    """Draw the elasticities of some measures, one panel each.

    Args:
        sensitivities: What each number changes.
        asked: The measures, and what they are called.
    """
    rows = -(-len(asked) // 2)
    figure, all_axes = panels(0.5 + 1.75 * rows, rows, min(len(asked), 2), squeeze=False)
    flat = list(all_axes.flat)
    for axes, (each, name) in zip(flat, asked, strict=False):
        ranked = sensitivities.ranked(each)[:MOST]
        values = [entry.of(each).value for entry in ranked]  # type: ignore[union-attr]
        colours = [LINES[0]["color"] if value > 0 else LINES[1]["color"] for value in values]
        axes.barh(range(len(ranked)), values, color=colours, height=0.65)
        axes.set_yticks(range(len(ranked)), [plain_label(place_words(entry.place)) for entry in ranked])
        axes.invert_yaxis()
        axes.axvline(0.0, color=BLACK, linewidth=0.7)
        axes.grid(visible=False, axis="y")
        axes.set_title(plain_label(name))
        axes.set_xlabel("per cent for one per cent")
    for axes in flat[len(asked) :]:
        axes.set_axis_off()
    return figure
