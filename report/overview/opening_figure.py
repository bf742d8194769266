"""The figure of the first screen: which motion a trimmer has over gap and friction."""

from typing import Final

import numpy as np
from matplotlib.figure import Figure as Drawing

from report.numbers.evidence import Evidence
from report.pages.drawing.drawn import drawn
from report.pages.drawing.style import new_figure
from report.pages.figure import Figure
from trimmer.drawing.cells import draw_cells

NAME: Final = "opening-map"
TITLE: Final = "What play does to the motion at 110 Hz"
SIZE: Final = (1.9, 4.6)  # Height and width, inches: narrow enough for a telephone
COLOURS: Final = ("#dbe9f6", "#e69f00", "#7a1f1f")
NAMES: Final = ("repeats with the drive", "repeats later", "does not repeat")


def opening_figure(known: Evidence) -> Figure:
    """Draw the map over gap and friction in three colours; the chapter on the trimmer has it in full."""
    words = (
        "A map over gap and friction. Up to about a tenth of a millimetre the motion repeats with the drive; "
        "beyond it mostly does not repeat, but for an island around 0.2 mm and 1 to 2 newtons."
    )
    caption = "From rest. Circle: 40 µm and 0.5 N; square: 0.2 mm and 2 N."
    return drawn(NAME, TITLE, caption, words, lambda: _map(known))


def _map(known: Evidence) -> Drawing:
    from matplotlib.patches import Patch

    numbers = known.twin.friction
    canvas = new_figure(*SIZE)
    axes = canvas.subplots()
    count = numbers.kept.period_count
    cells = np.where(count == 1, 0, np.where(count > 1, 1, 2))
    draw_cells(axes, 1e3 * numbers.first, numbers.second, cells, dict(enumerate(COLOURS)))
    for gap, friction, marker in ((0.04, 0.5, "o"), (0.2, 2.0, "s")):
        axes.plot(gap, friction, marker, color="white", markeredgecolor="black", markersize=6)
    axes.grid(visible=False)
    axes.set(xlabel="gap [mm]", ylabel="friction [N]")
    handles = [
        Patch(facecolor=colour, edgecolor="0.4", label=name)
        for colour, name in zip(COLOURS, NAMES, strict=True)
    ]
    canvas.legend(handles=handles, loc="outside lower center", ncols=len(handles), handlelength=1.2)
    return canvas
