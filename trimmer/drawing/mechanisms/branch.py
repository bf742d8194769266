"""The picture of a branch: peak to peak over the number that is varied, with stability and special points.

A colour stands for a number of drive periods, so that an asymmetric branch has that of the symmetric one.
"""

import itertools
from collections.abc import Callable

from matplotlib.axes import Axes
from matplotlib.figure import Figure

from trimmer.branches import FollowedBranch, FollowedOrbit, SpecialKind, SpecialPoint
from trimmer.drawing.axes import finish
from trimmer.drawing.content import new_figure
from trimmer.drawing.dispatch import draw
from trimmer.drawing.look import BLACK, FAINT, STABLE, UNSTABLE, colour
from trimmer.errors import MechanismError
from trimmer.mechanism.place_text import unit_of
from trimmer.messages import near_or_all
from trimmer.motion.chosen import chosen_measure
from trimmer.response.flows import flow_of

WIDTH, HEIGHT = 7.2, 3.4
MARKERS = {
    SpecialKind.GRAZING: "o",
    SpecialKind.STICK: "s",
    SpecialKind.FOLD: "v",
    SpecialKind.PERIOD_DOUBLING: "D",
    SpecialKind.TORUS: "P",
    SpecialKind.SYMMETRY_BREAKING: "X",
}


def branch_figure(branch: FollowedBranch, measure: str | None = None, target: float | None = None) -> Figure:
    """Draw a branch that has points and those that part from it, one panel per output, or a measure."""
    names = _outputs(branch) if measure is None else (None,)
    figure = new_figure(WIDTH, HEIGHT * len(names))
    for name, axes in zip(names, figure.subplots(len(names), squeeze=False)[:, 0], strict=True):
        draw_branch(branch, axes, name, measure, target)
    return figure


@draw.register(FollowedBranch)
def draw_branch(
    branch: FollowedBranch,
    axes: Axes,
    output: str | None = None,
    measure: str | None = None,
    target: float | None = None,
) -> None:
    """Draw peak to peak of an output, or a measure, over the number that is varied."""
    if measure is None:
        name = _chosen(branch, output)
        up = f"{name}, peak to peak", branch.units[name]
    else:
        up = measure, chosen_measure(flow_of(branch.map.subject), measure).unit

    def of(point: FollowedOrbit) -> float:
        return point.outputs[name].peak_to_peak if measure is None else point.measure(measure)

    def at(each: FollowedBranch, special: SpecialPoint) -> float:
        if measure is None:
            return each.outputs_at(special)[name].peak_to_peak
        return each.measure_at(special, measure)

    shown = [each for each in branch.all() if each.points]
    periods = sorted({each.periods for each in shown})
    for each in shown:
        _draw_line(axes, each, of, colour(periods.index(each.periods)))
        _draw_special(axes, each, at)
    if target is not None:
        axes.axhline(target, label="target", **FAINT)
    place = branch.map.place
    across = place, unit_of(branch.map.subject.places, place)
    finish(axes, across, up)


def _outputs(branch: FollowedBranch) -> list[str]:
    names = list(branch.units)
    if not names:
        raise MechanismError("the mechanism has no output, so there is no stroke: give it one ([outputs])")
    return names


def _chosen(branch: FollowedBranch, output: str | None) -> str:
    names = _outputs(branch)
    if output is not None and output not in names:
        raise MechanismError(f"no output is called {output!r}; {near_or_all(output, names)}")
    return names[0] if output is None else output


def _draw_line(axes: Axes, branch: FollowedBranch, of: Callable[[FollowedOrbit], float], look: str) -> None:
    """Draw stable stretches solid, unstable ones dashed."""
    values = [point.value for point in branch.points]
    strokes = [of(point) for point in branch.points]
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
    if branch.finds_period:
        return "own period" if branch.periods == 1 else f"period doubled to {branch.periods}"
    return f"period {branch.periods}"


def _draw_special(
    axes: Axes, branch: FollowedBranch, at: Callable[[FollowedBranch, SpecialPoint], float]
) -> None:
    for special in branch.special:
        axes.plot(
            special.value,
            at(branch, special),
            MARKERS[special.kind],
            color=BLACK,
            fillstyle="none",
            markersize=5,
            linestyle="none",
            label=special.kind.word,
        )
