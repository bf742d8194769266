"""Maps drawn: kinds of motion as areas with a legend of plain words, and curves over them."""

from __future__ import annotations

from collections.abc import Iterable, Sequence
from itertools import cycle
from typing import TYPE_CHECKING, Literal

import numpy as np
from matplotlib.colors import ListedColormap
from matplotlib.lines import Line2D
from matplotlib.patches import Patch

from trimmer.drawing.units import name_axis
from trimmer.maps.cells import described

if TYPE_CHECKING:
    from matplotlib.axes import Axes
    from matplotlib.axis import Axis
    from numpy.typing import ArrayLike

    from trimmer.arrays import Integers, Reals
    from trimmer.maps.cells import CellMotion
    from trimmer.maps.result import MotionMap

PERIOD_COLOURS = ("#56B4E9", "#0072B2", "#009E73", "#F0E442", "#E69F00", "#D55E00")
"""Of motions of period 1, 2, ...: the colours of Okabe and Ito, which colour-blind readers tell apart."""
LONGER_COLOUR = "#CC79A7"
OTHER_COLOURS = {"torus": "#777777", "chaotic": "#222222", "not settled": "#CCCCCC", "failed": "#FFFFFF"}
CURVE_STYLES: tuple[Literal["-", "--", "-.", ":"], ...] = ("-", "--", "-.", ":")


def category(motion: CellMotion) -> tuple[str, str]:
    """Return what a motion is in plain words, and its colour."""
    name = described(motion)
    if name in OTHER_COLOURS:
        return name, OTHER_COLOURS[name]
    if motion.period_count <= len(PERIOD_COLOURS):
        return name, PERIOD_COLOURS[motion.period_count - 1]
    return f"period {len(PERIOD_COLOURS) + 1} or more", LONGER_COLOUR


def categories() -> list[tuple[str, str]]:
    """Return all categories with their colours, in the order of the legend."""
    periods = [(f"period {count}", colour) for count, colour in enumerate(PERIOD_COLOURS, start=1)]
    return [*periods, (f"period {len(PERIOD_COLOURS) + 1} or more", LONGER_COLOUR), *OTHER_COLOURS.items()]


def draw_map(axes: Axes, result: MotionMap, curves: Iterable[tuple[str, ArrayLike]] = ()) -> None:
    """Draw the kinds of motion of a map into axes; a map over one place as its stroke, in the same colours.

    Args:
        axes: Where to draw.
        result: The map.
        curves: Curves with what they are, such as ``("fold", points)``: values of the two places in their
            order, SI units, (points, 2). Curves of one name share a line of the legend.
    """
    motions = [cell.motions[0] for cell in result.cells]
    legend = [each for each in categories() if each in {category(motion) for motion in motions}]
    numbers = np.array([legend.index(category(motion)) for motion in motions]).reshape(result.shape)
    if len(result.places) == 1:
        _draw_line(axes, result, numbers[0], legend)
    else:
        draw_areas(axes, result, numbers, legend)
    lines = _draw_curves(axes, curves) if len(result.places) > 1 else []
    handles = [Patch(facecolor=colour, edgecolor="0.4", label=name) for name, colour in legend]
    axes.legend(handles=[*handles, *lines], loc="upper left", bbox_to_anchor=(1.01, 1.0), fontsize="small")


def draw_areas(axes: Axes, result: MotionMap, numbers: Integers, legend: Sequence[tuple[str, str]]) -> None:
    """Draw areas of one colour each, by the numbers of their colours, (n2, n1)."""
    columns, rows = (np.argsort(values) for values in result.values)
    axes.pcolormesh(
        _edges(result.values[0][columns]),
        _edges(result.values[1][rows]),
        numbers[np.ix_(rows, columns)],
        cmap=ListedColormap([colour for _, colour in legend]),
        vmin=-0.5,
        vmax=len(legend) - 0.5,
        rasterized=True,
    )
    _label(axes.xaxis, result, 0)
    _label(axes.yaxis, result, 1)


def _draw_line(axes: Axes, result: MotionMap, numbers: Integers, legend: Sequence[tuple[str, str]]) -> None:
    outputs = result.inputs.mechanism.outputs
    heights = (result.stroke if outputs else result.impacts)[0]
    colours = [legend[number][1] for number in numbers]
    axes.scatter(result.values[0], heights, c=colours, edgecolors="0.4", linewidths=0.4, s=14)
    if outputs:
        name_axis(axes.yaxis, f"{next(iter(outputs))}, peak to peak", "m")
    else:
        name_axis(axes.yaxis, "impacts per drive period", "")
    axes.grid(alpha=0.3)
    _label(axes.xaxis, result, 0)


def _label(axis: Axis, result: MotionMap, number: int) -> None:
    place = result.places[number]
    unit = dict(result.inputs.mechanism.places).get(place, "")
    name_axis(axis, place, "" if unit == "1" else unit)


def _edges(values: Reals) -> Reals:
    """Return where cells begin and end around sorted values, (n + 1,)."""
    if len(values) == 1:
        half = abs(values[0]) / 2 or 0.5
        return np.array([values[0] - half, values[0] + half])
    middles = (values[:-1] + values[1:]) / 2
    first, last = 2 * values[0] - middles[0], 2 * values[-1] - middles[-1]
    return np.concatenate([[first], middles, [last]])


def _draw_curves(axes: Axes, curves: Iterable[tuple[str, ArrayLike]]) -> list[Line2D]:
    """Draw curves with a light border, so that they show on any colour; returns lines for the legend."""
    limits = axes.get_xlim(), axes.get_ylim()
    styles: dict[str, Literal["-", "--", "-.", ":"]] = {}
    rest = cycle(CURVE_STYLES)
    for name, points in curves:
        style = styles.setdefault(name, next(rest)) if name not in styles else styles[name]
        first, second = np.asarray(points, dtype=float).T
        axes.plot(first, second, "-", color="white", linewidth=2.6)
        axes.plot(first, second, style, color="black", linewidth=1.2)
    axes.set_xlim(limits[0])
    axes.set_ylim(limits[1])
    return [Line2D([], [], color="black", linestyle=style, label=name) for name, style in styles.items()]
