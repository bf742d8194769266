"""The picture of a branch: peak to peak over the number that is varied, with stability and special points.

A colour stands for a number of drive periods, so that an asymmetric branch has that of the symmetric one.
"""

from __future__ import annotations

import itertools
from collections.abc import Iterator
from typing import TYPE_CHECKING

from matplotlib.figure import Figure

from trimmer.branches.special import SpecialKind
from trimmer.drawing.content import content_of
from trimmer.drawing.units import name_axis

if TYPE_CHECKING:
    from matplotlib.axes import Axes

    from trimmer.branches.followed import FollowedBranch

_WIDTH, _HEIGHT = 6.4, 3.2
_MARKERS = {
    SpecialKind.GRAZING: "o",
    SpecialKind.STICK: "s",
    SpecialKind.FOLD: "v",
    SpecialKind.PERIOD_DOUBLING: "D",
    SpecialKind.TORUS: "P",
    SpecialKind.SYMMETRY_BREAKING: "X",
}


def draw_branch(branch: FollowedBranch, file_format: str) -> bytes:
    """Draw a branch and those that part from it, one panel per output, and return the content of the file.

    Args:
        branch: The branch; it has points.
        file_format: ``svg``, ``png`` or ``pdf``.
    """
    names = list(branch.map.mechanism.outputs)
    figure = Figure(figsize=(_WIDTH, _HEIGHT * max(len(names), 1)), layout="constrained")
    panels = figure.subplots(max(len(names), 1), squeeze=False)[:, 0]
    shown = list(_all(branch))
    periods = sorted({each.periods for each in shown})
    for name, axes in zip(names, panels, strict=False):
        for each in shown:
            _draw_line(axes, each, name, f"C{periods.index(each.periods) % 10}")
            _draw_special(axes, each, name)
        name_axis(axes.xaxis, branch.map.place, "" if branch.unit == "1" else branch.unit)
        name_axis(axes.yaxis, f"{name}, peak to peak", "m")
        axes.grid(alpha=0.3)
        _add_legend(axes)
    return content_of(figure, file_format)


def _all(branch: FollowedBranch) -> Iterator[FollowedBranch]:
    yield branch
    for other in branch.branches:
        yield from _all(other)


def _draw_line(axes: Axes, branch: FollowedBranch, name: str, colour: str) -> None:
    """Draw stable stretches solid, unstable ones dashed."""
    values = [point.value for point in branch.points]
    strokes = [point.outputs[name].peak_to_peak for point in branch.points]
    for stable, group in itertools.groupby(range(len(values)), key=lambda at: branch.points[at].stable):
        places = list(group)
        part = slice(max(places[0] - 1, 0), places[-1] + 1)
        axes.plot(
            values[part],
            strokes[part],
            "-" if stable else "--",
            color=colour,
            linewidth=1.2 if stable else 0.8,
            label=f"{'stable' if stable else 'unstable'}, {_period(branch)}",
        )


def _period(branch: FollowedBranch) -> str:
    if branch.map.mechanism.frequency is None:
        return "own period" if branch.periods == 1 else f"period doubled to {branch.periods}"
    return f"period {branch.periods}"


def _draw_special(axes: Axes, branch: FollowedBranch, name: str) -> None:
    for special in branch.special:
        measures = branch.outputs_at(special)
        axes.plot(
            special.value,
            measures[name].peak_to_peak,
            _MARKERS[special.kind],
            color="black",
            fillstyle="none",
            markersize=5,
            linestyle="none",
            label=special.kind.word,
        )


def _add_legend(axes: Axes) -> None:
    """Add a legend in which each label stands once."""
    handles, labels = axes.get_legend_handles_labels()
    once = dict(zip(labels, handles, strict=True))
    if once:
        axes.legend(once.values(), once.keys(), fontsize="x-small")
