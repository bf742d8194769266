"""The picture of a branch: peak to peak over the number that is varied, with stability and special points.

A colour stands for a number of drive periods, so that an asymmetric branch has that of the symmetric one.
"""

from __future__ import annotations

import itertools

from matplotlib.axes import Axes
from matplotlib.figure import Figure

from trimmer.branches.followed import FollowedBranch
from trimmer.branches.special import SpecialKind
from trimmer.drawing.axes import finish
from trimmer.drawing.content import new_figure
from trimmer.drawing.dispatch import draw
from trimmer.drawing.look import BLACK, STABLE, UNSTABLE, colour
from trimmer.errors import MechanismError
from trimmer.mechanism.place_text import unit_of
from trimmer.messages import listed

WIDTH, HEIGHT = 7.2, 3.4
MARKERS = {
    SpecialKind.GRAZING: "o",
    SpecialKind.STICK: "s",
    SpecialKind.FOLD: "v",
    SpecialKind.PERIOD_DOUBLING: "D",
    SpecialKind.TORUS: "P",
    SpecialKind.SYMMETRY_BREAKING: "X",
}


def branch_figure(branch: FollowedBranch) -> Figure:
    """Draw a branch that has points and those that part from it, one panel per output."""
    names = _outputs(branch)
    figure = new_figure(WIDTH, HEIGHT * len(names))
    for name, axes in zip(names, figure.subplots(len(names), squeeze=False)[:, 0], strict=True):
        draw_branch(branch, axes, name)
    return figure


@draw.register(FollowedBranch)
def draw_branch(branch: FollowedBranch, axes: Axes, output: str | None = None) -> None:
    """Draw peak to peak of an output over the number that is varied."""
    name = _chosen(branch, output)
    shown = [each for each in branch.all() if each.points]
    periods = sorted({each.periods for each in shown})
    for each in shown:
        _draw_line(axes, each, name, colour(periods.index(each.periods)))
        _draw_special(axes, each, name)
    place = branch.map.place
    across = place, unit_of(branch.map.subject.places, place)
    finish(axes, across, (f"{name}, peak to peak", branch.units[name]))


def _outputs(branch: FollowedBranch) -> list[str]:
    names = list(branch.units)
    if not names:
        raise MechanismError("the mechanism has no output, so there is no stroke: give it one ([outputs])")
    return names


def _chosen(branch: FollowedBranch, output: str | None) -> str:
    names = _outputs(branch)
    if output is not None and output not in names:
        raise MechanismError(f"no output is called {output!r}; there are {listed(names)}")
    return names[0] if output is None else output


def _draw_line(axes: Axes, branch: FollowedBranch, name: str, look: str) -> None:
    """Draw stable stretches solid, unstable ones dashed."""
    values = [point.value for point in branch.points]
    strokes = [point.outputs[name].peak_to_peak for point in branch.points]
    for stable, group in itertools.groupby(range(len(values)), key=lambda at: branch.points[at].stable):
        places = list(group)
        part = slice(max(places[0] - 1, 0), places[-1] + 1)
        axes.plot(
            values[part],
            strokes[part],
            linestyle=STABLE if stable else UNSTABLE,
            color=look,
            linewidth=1.4 if stable else 1.0,
            marker="." if len(values) == 1 else "",
            label=f"{'stable' if stable else 'unstable'}, {_period(branch)}",
        )


def _period(branch: FollowedBranch) -> str:
    if branch.map.subject.frequency is None:
        return "own period" if branch.periods == 1 else f"period doubled to {branch.periods}"
    return f"period {branch.periods}"


def _draw_special(axes: Axes, branch: FollowedBranch, name: str) -> None:
    for special in branch.special:
        measures = branch.outputs_at(special)
        axes.plot(
            special.value,
            measures[name].peak_to_peak,
            MARKERS[special.kind],
            color=BLACK,
            fillstyle="none",
            markersize=5,
            linestyle="none",
            label=special.kind.word,
        )
