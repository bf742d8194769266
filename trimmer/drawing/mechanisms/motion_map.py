"""The picture of a map: kinds of motion as areas, or a stroke over one number; and of a basin."""

from collections.abc import Iterable, Sequence
from dataclasses import replace

import numpy as np
from matplotlib.axes import Axes
from matplotlib.lines import Line2D
from numpy.typing import ArrayLike

from trimmer.arrays import Integers
from trimmer.drawing.axes import add_legend
from trimmer.drawing.cells import draw_cells, draw_values
from trimmer.drawing.dispatch import draw
from trimmer.drawing.look import BLACK, FAINT
from trimmer.drawing.mechanisms.curves import add_curves
from trimmer.drawing.mechanisms.kinds import Category, categories, category, legend_of
from trimmer.drawing.units import name_axis
from trimmer.errors import MapError
from trimmer.maps import Basin, MotionMap
from trimmer.motion.units import with_unit
from trimmer.response.results.response import MotionKind

BASIN_COLOURS = ("#0072B2", "#E69F00", "#009E73", "#CC79A7", "#56B4E9", "#D55E00", "#F0E442")
"""Of the motions of a basin in turn: the colours of Okabe and Ito."""
BASIN_HATCHES = ("", "", "//", "..", "\\\\", "xx", "")


@draw.register(MotionMap)
def draw_map(
    result: MotionMap,
    axes: Axes,
    curves: Iterable[tuple[str, ArrayLike]] = (),
    measure: str | None = None,
    target: float | None = None,
) -> None:
    """Draw the kinds of motion of a map, or a measure."""
    if measure is not None and len(result.places) > 1:
        _draw_measure(axes, result, measure, target)
        add_legend(axes, add_curves(axes, curves, hold=True))
        return
    motions = [cell.motions[0] for cell in result.cells]
    found = {category(motion) for motion in motions}
    legend = [each for each in categories() if each in found]
    numbers = np.array([legend.index(category(motion)) for motion in motions]).reshape(result.shape)
    lines: list[Line2D] = []
    if len(result.places) == 1:
        _draw_line(axes, result, numbers[0], legend, measure)
        if target is not None:
            axes.axhline(target, **FAINT)
    else:
        draw_areas(axes, result, numbers, legend)
        lines = add_curves(axes, curves, hold=True)
    add_legend(axes, [*legend_of(legend, result.inputs.over), *lines])


def draw_areas(axes: Axes, result: MotionMap, numbers: Integers, legend: Sequence[Category]) -> None:
    """Draw areas of one colour each, by the numbers of their colours, (n2, n1)."""
    colours = {number: each.colour for number, each in enumerate(legend)}
    hatches = {number: each.hatch for number, each in enumerate(legend)}
    first, second = result.values
    draw_cells(axes, first, second, numbers, colours, hatches)
    _name_axes(axes, result)


def _name_axes(axes: Axes, result: MotionMap) -> None:
    for axis, place, unit in zip((axes.xaxis, axes.yaxis), result.places, result.units, strict=True):
        name_axis(axis, place, unit)


def _draw_measure(axes: Axes, result: MotionMap, measure: str, target: float | None) -> None:
    """Draw a measure over both places in colours, blank where there is none, and a contour at its target."""
    columns, rows = (np.argsort(values) for values in result.values)
    first, second = result.values[0][columns], result.values[1][rows]
    values = result.chosen[measure][np.ix_(rows, columns)]
    label = with_unit(measure, result.chosen_units[measure])
    draw_values(axes, first, second, values, label, {"cmap": "viridis"})
    inside = target is not None and np.nanmin(values) < target < np.nanmax(values)
    if inside and min(values.shape) > 1:
        axes.contour(first, second, values, levels=[target], colors=BLACK, linewidths=1.2)
    _name_axes(axes, result)


def _draw_line(
    axes: Axes, result: MotionMap, numbers: Integers, legend: Sequence[Category], measure: str | None
) -> None:
    outputs = result.outputs
    heights = (result.stroke if outputs else result.impacts)[0]
    heights = heights if measure is None else result.chosen[measure][0]
    colours = [legend[number].colour for number in numbers]
    axes.scatter(result.values[0], heights, c=colours, edgecolors="0.4", linewidths=0.4, s=14)
    if measure is not None:
        name_axis(axes.yaxis, measure, result.chosen_units[measure])
    elif outputs:
        name, unit = next(iter(outputs.items()))
        name_axis(axes.yaxis, f"{name}, peak to peak", unit)
    else:
        name_axis(axes.yaxis, f"impacts per {result.inputs.counted}", "")
    axes.grid(alpha=0.3)
    name_axis(axes.xaxis, result.places[0], result.units[0])


@draw.register(Basin)
def draw_basin(basin: Basin, axes: Axes) -> None:
    """Draw which motion is reached from where."""
    if len(basin.result.places) != 2:
        raise MapError("only a basin over two initial values can be drawn: vary two")
    legend = [_of_basin(basin, number) for number in range(len(basin.motions))]
    draw_areas(axes, basin.result, basin.number, legend)
    add_legend(axes, legend_of(legend, basin.result.inputs.over))


def _of_basin(basin: Basin, number: int) -> Category:
    """Return name, colour and hatching of a motion: of its kind, or of its number if it repeats."""
    motions, name = basin.motions, basin.names[number]
    if motions[number].kind is not MotionKind.PERIODIC:
        return replace(category(motions[number]), name=name)
    before = sum(motion.kind is MotionKind.PERIODIC for motion in motions[:number])
    place = before % len(BASIN_COLOURS)
    return Category(name, BASIN_COLOURS[place], BASIN_HATCHES[place])
