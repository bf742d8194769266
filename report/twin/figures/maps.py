"""Maps of kinds of motion, and branches over the gap above what the trimmer settles to from rest."""

import numpy as np
from matplotlib.axes import Axes
from matplotlib.figure import Figure

from report.data.figures import figure
from report.numbers.evidence import Evidence
from report.numbers.twin.grids import BRANCH_FORCE, COURSES
from report.numbers.twin.kept_branch import KeptBranch
from report.numbers.twin.map_numbers import MapNumbers
from report.pages.drawing.style import LINES, new_figure, panels
from trimmer.arrays import Integers
from trimmer.drawing.cells import draw_cells
from trimmer.drawing.mechanisms.kinds import LONGER_COLOUR, OTHER_COLOURS, PERIOD_COLOURS

LONGER = len(PERIOD_COLOURS)
NAMES = {
    **{count: (f"period {count}", colour) for count, colour in enumerate(PERIOD_COLOURS, start=1)},
    LONGER + 1: (f"period {LONGER + 1} or more", LONGER_COLOUR),
    LONGER + 2: ("torus", OTHER_COLOURS["torus"]),
    LONGER + 3: ("chaotic", OTHER_COLOURS["chaotic"]),
    LONGER + 4: ("not settled", OTHER_COLOURS["not settled"]),
}
"""What a motion is called and its colour, by a number."""
COLOURS = {number: colour for number, (_, colour) in NAMES.items()}
KINDS = {"t": LONGER + 2, "c": LONGER + 3, "u": LONGER + 4}


@figure("twin-map-friction")
def friction_map(known: Evidence) -> Figure:
    """Draw the map over gap and friction."""
    drawn, axes = _map(known.twin.friction)
    axes.plot(40, 0.5, "o", color="white", markeredgecolor="black", markersize=6)
    axes.plot(200, 2.0, "s", color="white", markeredgecolor="black", markersize=6)
    axes.set(xlabel="gap [µm]", ylabel="friction [N]")
    return drawn


@figure("twin-map-speed")
def speed_map(known: Evidence) -> Figure:
    """Draw the map over gap and speed."""
    drawn, axes = _map(known.twin.speed)
    axes.plot(40, 110.0, "o", color="white", markeredgecolor="black", markersize=6)
    axes.set(xlabel="gap [µm]", ylabel="drive [Hz]")
    return drawn


def numbers_of(numbers: MapNumbers) -> Integers:
    """Return the number in ``NAMES`` of each cell, (n2, n1)."""
    kind, count = numbers.kept.kind, numbers.kept.period_count
    periodic = np.where(count > LONGER, LONGER + 1, count)
    others = np.vectorize(lambda letter: KINDS.get(letter, 0))(kind)
    return np.where(count > 0, periodic, others)


def _map(numbers: MapNumbers) -> tuple[Figure, Axes]:
    from matplotlib.patches import Patch

    drawn = new_figure(3.9)
    axes = drawn.subplots()
    cells = numbers_of(numbers)
    gaps = 1e6 * numbers.first
    draw_cells(axes, gaps, numbers.second, cells, COLOURS)
    rows, columns = np.nonzero(numbers.asymmetric)
    axes.plot(gaps[columns], numbers.second[rows], ".", color="white", markersize=1.6, linestyle="none")
    axes.grid(visible=False)
    there = [NAMES[number] for number in sorted(set(cells.ravel().tolist()))]
    handles = [Patch(facecolor=colour, edgecolor="0.4", label=name) for name, colour in there]
    drawn.legend(handles=handles, loc="outside lower center", ncols=5)
    return drawn, axes


MARKS = {"torus": "o", "symmetry-breaking": "D", "period-doubling": "s", "fold": "^"}
"""Marks of the special points that change stability."""


@figure("twin-branches")
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
