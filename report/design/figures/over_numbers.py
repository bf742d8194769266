"""What comes out over one number of a mechanism, or over two: branch, range, influences, map."""

import itertools
import textwrap
from collections.abc import Mapping, Sequence

import numpy as np
from matplotlib.axes import Axes
from matplotlib.figure import Figure

from report.design.quantities import Scale, place_words, scale_for
from report.pages.drawing.style import BLACK, FAINT, LINES, new_figure, panels
from trimmer.arrays import Reals
from trimmer.branches.special import SpecialKind
from trimmer.design.parameter_studies.kept_map import DesignMap
from trimmer.design.parameter_studies.paths import NumberPath, PathSide
from trimmer.design.specification.design_file import OpenRange
from trimmer.design.specification.targets import Measure, Target
from trimmer.design.trials.ranges import RangeStudy
from trimmer.design.trials.sensitivity import Sensitivities
from trimmer.design.trials.trial import MeasureOfPart
from trimmer.drawing.cells import draw_cells, edges
from trimmer.drawing.look import plain_label
from trimmer.drawing.mechanisms.kinds import categories, category, legend_of

MARKERS = {
    SpecialKind.GRAZING: ("o", "grazing"),
    SpecialKind.STICK: ("s", "stick begins or ends"),
    SpecialKind.FOLD: ("v", "fold"),
    SpecialKind.PERIOD_DOUBLING: ("D", "period doubling"),
    SpecialKind.TORUS: ("P", "torus"),
    SpecialKind.SYMMETRY_BREAKING: ("X", "loss of symmetry"),
}
BLUE = LINES[0]["color"]


Curve = tuple[MeasureOfPart, str, float | None]  # A measure along a branch, what it is called, and its bound


def branch(path: NumberPath, asked: Sequence[Curve], units: Mapping[MeasureOfPart, str]) -> Figure:
    """Draw measures along a branch, one panel each: stable orbits solid, unstable ones dashed."""
    sides = [side for side in (path.down, path.up) if side is not None]
    across = scale_for(np.concatenate([side.values for side in sides]), path.varied.unit)
    figure, every = panels(0.6 + 2.4 * len(asked), len(asked), 1, sharex=True, squeeze=False)
    for axes, (measure, name, bound) in zip(every[:, 0], asked, strict=True):
        heights = [_heights(side, measure) for side in sides]
        up = scale_for([*np.concatenate(heights), bound or 0.0], units[measure])
        for side, values in zip(sides, heights, strict=True):
            _line(axes, side, values, across, up)
        seen: set[SpecialKind] = set()
        for side, values in zip(sides, heights, strict=True):
            _special(axes, side, values, across, up, seen)
        axes.plot(
            path.varied.value / across.factor, heights[0][0] / up.factor, "o",
            color=BLACK, markersize=6, label="as in the file",
        )  # fmt: skip
        if bound is not None:
            axes.axhline(bound / up.factor, label="wanted", **FAINT)
        axes.set_ylabel(f"{plain_label(name)} [{up.unit}]")
        axes.legend(loc="upper left", bbox_to_anchor=(1.01, 1.0))
    every[-1, 0].set_xlabel(f"{plain_label(place_words(path.varied.place))} [{across.unit}]")
    return figure


def _heights(side: PathSide, asked: MeasureOfPart) -> Reals:
    return side.stroke[asked.part] if asked.measure is Measure.STROKE else side.measures[asked.column]


def _line(axes: Axes, side: PathSide, heights: Reals, across: Scale, up: Scale) -> None:
    values, strokes = side.values / across.factor, heights / up.factor
    for stable, group in itertools.groupby(range(len(values)), key=lambda at: bool(side.stable[at])):
        places = list(group)
        part = slice(max(places[0] - 1, 0), places[-1] + 1)
        style, width = ("solid", 1.6) if stable else ("dashed", 0.9)
        axes.plot(values[part], strokes[part], color=BLUE, linestyle=style, linewidth=width)


def _special(
    axes: Axes, side: PathSide, heights: Reals, across: Scale, up: Scale, seen: set[SpecialKind]
) -> None:
    """Mark special points, at the height of the orbits beside them."""
    for each in side.special:
        mark, name = MARKERS[each.kind]
        label = None if each.kind in seen else name
        seen.add(each.kind)
        height = heights[int(np.argmin(abs(side.values - each.value)))]
        axes.plot(
            each.value / across.factor, height / up.factor, mark,
            color=BLACK, markerfacecolor="white", markersize=5, markeredgewidth=0.9, linestyle="none",
            label=label,
        )  # fmt: skip


def over_range(
    study: RangeStudy,
    of: OpenRange,
    asked: Sequence[tuple[MeasureOfPart, str]],
    bounds: Mapping[MeasureOfPart, float],
    targets: tuple[Target, ...],
    units: Mapping[MeasureOfPart, str],
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
        up = scale_for([*found, bounds.get(each, 0.0)], units[each])
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


MOST = 7  # Bars for each measure
LONGEST_TITLE = 22  # Characters that stand above bars which leave half of a panel to their names


def influences(sensitivities: Sensitivities, asked: Sequence[tuple[MeasureOfPart, str]]) -> Figure:
    """Draw the elasticities of some measures, each with what it is called, one panel each."""
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
        axes.set_title(plain_label("\n".join(textwrap.wrap(name, LONGEST_TITLE))))
        axes.set_xlabel("per cent for one per cent")
    for axes in flat[len(asked) :]:
        axes.set_axis_off()
    return figure


def target_maps(drawn: DesignMap, names: Sequence[str], marks: Sequence[tuple[float, float]]) -> Figure:
    """Draw what each named target bounds over two numbers, with the target as a contour.

    Marks are the values of both numbers that are recommended, SI units.
    """
    rows = -(-len(drawn.targets) // 2)
    wide = min(len(drawn.targets), 2)
    figure, every = panels(0.5 + 2.7 * rows, rows, wide, squeeze=False)
    first, second = scales(drawn)
    flat = list(every.flat)
    for axes, target, name in zip(flat, drawn.targets, names, strict=False):
        _target_map(axes, drawn, target)
        axes.set_title(plain_label(name))
        frame(axes, drawn)
        for across, up in marks:
            axes.plot(
                across / first.factor, up / second.factor, "*",
                color="#F0E442", markeredgecolor="black", markersize=12, clip_on=False,
            )  # fmt: skip
    for axes in flat[len(drawn.targets) :]:
        axes.set_axis_off()
    return figure


def _target_map(axes: Axes, drawn: DesignMap, target: Target) -> None:
    result = drawn.result
    across, up = (values / scale.factor for values, scale in zip(result.values, scales(drawn), strict=True))
    if target.measure is Measure.PERIOD:
        draw_cells(axes, across, up, (result.period_count == 1).astype(np.int64), MET)
        return
    values = result.chosen[MeasureOfPart(target.measure, target.part).column]
    unit = scale_for([*values[np.isfinite(values)], target.bound], target.unit or target.measure.unit)
    shown = values / unit.factor
    mesh = axes.pcolormesh(edges(across), edges(up), shown, cmap="viridis", rasterized=True)
    figure = axes.get_figure(root=True)
    assert figure is not None
    figure.colorbar(mesh, ax=axes, label=f"[{unit.unit}]")
    bound = target.bound / unit.factor
    known = shown[np.isfinite(shown)]  # nothing is, if no contact closes in any cell
    if known.size and known.min() < bound < known.max() and min(shown.shape) > 1:
        axes.contour(across, up, shown, levels=[bound], colors="white", linewidths=3.0)
        axes.contour(across, up, shown, levels=[bound], colors=BLACK, linewidths=1.4)


MET = {0: "#d9d9d9", 1: "#56B4E9"}
"""Colours of cells whose motion does not repeat with the drive, and of those in which it does."""


def kind_map(drawn: DesignMap) -> Figure:
    """Draw the kinds of motion as areas, and the working point."""
    result = drawn.result
    names = [category(cell.motions[0]) for cell in result.cells]
    legend = [each for each in categories() if each in names]
    numbers = np.array([legend.index(each) for each in names]).reshape(result.shape)
    figure = new_figure(3.5)
    axes = figure.add_subplot()
    colours = {number: each.colour for number, each in enumerate(legend)}
    hatches = {number: each.hatch for number, each in enumerate(legend)}
    across, up = (values / scale.factor for values, scale in zip(result.values, scales(drawn), strict=True))
    draw_cells(axes, across, up, numbers, colours, hatches)
    frame(axes, drawn)
    axes.legend(handles=legend_of(legend, result.inputs.waited), loc="upper left", bbox_to_anchor=(1.01, 1.0))
    return figure


def scales(drawn: DesignMap) -> tuple[Scale, Scale]:
    """Return the units of both numbers."""
    first, second = drawn.result.values
    return scale_for(first, drawn.first.unit), scale_for(second, drawn.second.unit)


def frame(axes: Axes, drawn: DesignMap) -> None:
    """Mark the working point, and name the two numbers."""
    first, second = scales(drawn)
    axes.plot(
        drawn.first.value / first.factor, drawn.second.value / second.factor, "o",
        color="white", markeredgecolor="black", markersize=7, clip_on=False,
    )  # fmt: skip
    axes.set(
        xlabel=f"{plain_label(place_words(drawn.first.place))} [{first.unit}]",
        ylabel=f"{plain_label(place_words(drawn.second.place))} [{second.unit}]",
    )
    axes.grid(visible=False)
