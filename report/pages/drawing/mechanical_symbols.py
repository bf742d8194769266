"""Symbols for drawings of mechanisms, on a canvas in inches: bodies, springs, dampers, surroundings."""

from typing import Any, Final

import numpy as np
from matplotlib.axes import Axes
from matplotlib.figure import Figure

from report.pages.drawing.marks import arrow
from report.pages.drawing.style import BLACK, new_figure

LINE: Final[dict[str, Any]] = {"color": BLACK, "linestyle": "solid", "linewidth": 1.1}
MOTOR: Final = "#d6e6f2"
BRIDGE: Final = "#f7dfc8"
HOUSING: Final = "#d9ead9"
GUARD: Final = "#eadbe7"
PIN: Final = "#bbbbbb"
_COILS: Final = 6
_HALF_WIDTH: Final = 0.09


def canvas(width: float, height: float) -> tuple[Figure, Axes]:
    """Return a figure whose one unit of data is one inch."""
    figure = new_figure(height, width)
    figure.set_layout_engine("none")
    axes = figure.add_axes((0.0, 0.0, 1.0, 1.0))
    axes.set_axis_off()
    axes.set(xlim=(0.0, width), ylim=(0.0, height))
    return figure, axes


def body(axes: Axes, corner: tuple[float, float], size: tuple[float, float], text: str, fill: str) -> None:
    """Draw a rectangle from its lower left corner, with text in its middle."""
    from matplotlib.patches import Rectangle

    axes.add_patch(Rectangle(corner, *size, facecolor=fill, edgecolor=BLACK, linewidth=1.1, zorder=2))
    axes.text(corner[0] + size[0] / 2, corner[1] + size[1] / 2, text, ha="center", va="center", zorder=3)


def spring(axes: Axes, left: float, right: float, y: float, text: str) -> None:
    """Draw a horizontal spring as a zigzag, with its name above and as the line's label."""
    lead = 0.15 * (right - left)
    xs = np.linspace(left + lead, right - lead, 2 * _COILS + 1)
    ys = np.full(xs.size, y)
    ys[1:-1] += _HALF_WIDTH * np.where(np.arange(xs.size - 2) % 2, -1, 1)
    axes.plot([left, *xs, right], [y, *ys, y], label=text, **LINE)
    axes.text((left + right) / 2, y + _HALF_WIDTH + 0.04, text, ha="center", va="bottom")


def damper(axes: Axes, left: float, right: float, y: float, text: str) -> None:
    """Draw a horizontal damper as a piston in a cup, with its name below and as the rods' label."""
    middle, half, top, bottom = (left + right) / 2, 0.14 * (right - left), y + _HALF_WIDTH, y - _HALF_WIDTH
    start, end = middle - half, middle + half
    axes.plot([left, start], [y, y], label=text, **LINE)
    axes.plot([end, start, start, end], [top, top, bottom, bottom], **LINE)
    axes.plot([middle, middle], [y - 0.7 * _HALF_WIDTH, y + 0.7 * _HALF_WIDTH], **LINE)
    axes.plot([middle, right], [y, y], label=text, **LINE)
    axes.text(middle, bottom - 0.04, text, ha="center", va="top")


def wall(axes: Axes, x: float, bottom: float, top: float, behind: float) -> None:
    """Draw a vertical fixed wall; the hatching lies on the side of ``behind`` (-1 left, 1 right)."""
    axes.plot([x, x], [bottom, top], **(LINE | {"linewidth": 1.6}))
    for y in np.arange(bottom, top - 0.05, 0.12):
        axes.plot([x, x + behind * 0.1], [y + 0.1, y], **(LINE | {"linewidth": 0.7}))


def displacement(axes: Axes, x: float, y: float, text: str) -> None:
    """Draw the arrow of a positive displacement from a short mark, with its name behind the head."""
    axes.plot([x, x], [y - 0.08, y + 0.08], **LINE)
    arrow(axes, (x, y), (x + 0.4, y), shrinkA=0, shrinkB=0, mutation_scale=10)
    axes.text(x + 0.44, y, text, ha="left", va="center")


def called(axes: Axes, text: str, at: tuple[float, float], place: tuple[float, float]) -> None:
    """Write a name beside a part and lead a thin line to it."""
    axes.annotate(text, at, place, ha="center", va="center", arrowprops={"arrowstyle": "-", "linewidth": 0.7})
