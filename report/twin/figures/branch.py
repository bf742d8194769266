"""Branches over the gap, above what the trimmer settles to from rest."""

from __future__ import annotations

from typing import TYPE_CHECKING

import numpy as np

from report.judging.record import figure
from report.numbers.evidence import Evidence
from report.numbers.twin.grids import BRANCH_FORCE, COURSES
from report.numbers.twin.kept_branch import KeptBranch
from report.pages.drawing.style import LINES, panels
from report.twin.figures.maps import COLOURS, numbers_of
from trimmer.drawing.cells import draw_cells

if TYPE_CHECKING:
    from matplotlib.axes import Axes
    from matplotlib.figure import Figure

MARKS = {"torus": "o", "symmetry-breaking": "D", "period-doubling": "s", "fold": "^"}
"""Marks of the special points that change stability."""


@figure(
    "twin-branches",
    "Periodic motions over the gap",
    caption="""Stroke of all periodic motions that were followed, 2 N at 110 Hz: solid where stable, dotted
    where not. Marks: torus, symmetry breaking, period doubling, fold. Below: what the trimmer settles to
    from rest, in the colours of the maps.""",
    alternative_text="""Curves of stroke over gap from 20 to 300 micrometres. One falls from 2.85 to 2.46
    millimetres and rises again, stable up to 0.11 mm; closed curves of three periods lie above it between
    0.16 and 0.25 mm, stable in pieces. A strip below is of period one up to 0.11 mm, then changes often.""",
)
def branches_over_gap(known: Evidence) -> Figure:
    """Draw the branches, and the row of the map."""
    drawn, (axes, strip) = panels(4.0, 2, 1, sharex=True, height_ratios=(9, 1))
    for course, line, name in zip(
        COURSES, LINES, ("the drive's period", "three drive periods"), strict=False
    ):
        for branch in known.twin.branches:
            if branch.course.name == course.name:
                _branch(axes, branch, str(line["color"]))
        axes.plot([], [], color=line["color"], linestyle="-", label=name)
    for kind, mark in MARKS.items():
        axes.plot([], [], mark, color="black", markersize=4, linestyle="none", label=kind.replace("-", " "))
    axes.set(ylabel="stroke, peak to peak [mm]")
    axes.legend(loc="lower left", ncols=1)
    _strip(strip, known)
    return drawn


def _branch(axes: Axes, branch: KeptBranch, colour: str) -> None:
    gaps, strokes = 1e6 * branch.values, 1e3 * branch.strokes
    axes.plot(gaps, strokes, color=colour, linestyle=":", linewidth=0.9)
    stable = branch.stable
    joined = stable | np.concatenate([stable[1:], [False]]) & stable
    axes.plot(np.where(joined, gaps, np.nan), strokes, color=colour, linestyle="-", linewidth=1.8)
    for special in branch.special:
        if special.kind in MARKS:
            at = int(abs(branch.values - special.value).argmin())
            axes.plot(1e6 * special.value, strokes[at], MARKS[special.kind], color="black", markersize=3)


def _strip(axes: Axes, known: Evidence) -> None:
    numbers = known.twin.friction
    row = numbers_of(numbers)[numbers.row(BRANCH_FORCE)]
    draw_cells(axes, 1e6 * numbers.first, np.array([0.0, 1.0]), np.array([row, row]), COLOURS)
    axes.set(xlabel="gap [µm]", xlim=(15, 305), yticks=[], ylabel="rest")
    axes.grid(visible=False)
