"""The block diagrams of the thesis (figures 2.3 and 2.4), drawn again."""

from __future__ import annotations

from collections.abc import Sequence
from typing import TYPE_CHECKING, Final

from report.figures.style import new_figure, style

if TYPE_CHECKING:
    from matplotlib.axes import Axes
    from matplotlib.figure import Figure

_BLOCK: Final = (1.5, 0.9)
_RADIUS: Final = 0.2
_LINE_WIDTH: Final = 1.1


def linear_system() -> Figure:
    """Draw an input u(t), a block G(s) and its output y(t) (thesis, figure 2.3)."""
    with style():
        figure, axes = _canvas(5.5, 1.3)
        _block(axes, 2.75, 0.65, "$G(s)$")
        _arrow(axes, ((0.3, 0.65), (2.0, 0.65)))
        _arrow(axes, ((3.5, 0.65), (5.2, 0.65)))
        _label(axes, 0.8, 0.65, "$u(t)$")
        _label(axes, 4.5, 0.65, "$y(t)$")
    return figure


def feedback_system() -> Figure:
    """Draw the loop with G(s) ahead and N(s) in the feedback path (thesis, figure 2.4).

    The feedback is subtracted, so that the closed loop is M = G / (1 + G N) (thesis, equation 2.24).
    """
    with style():
        figure, axes = _canvas(6.5, 2.6)
        _block(axes, 3.4, 1.9, "$G(s)$")
        _block(axes, 3.4, 0.6, "$N(s)$")
        _summing_junction(axes, 1.5, 1.9)
        _arrow(axes, ((0.3, 1.9), (1.5 - _RADIUS, 1.9)))
        _arrow(axes, ((1.5 + _RADIUS, 1.9), (2.65, 1.9)))
        _arrow(axes, ((4.15, 1.9), (6.2, 1.9)))
        _arrow(axes, ((5.1, 1.9), (5.1, 0.6), (4.15, 0.6)))
        _arrow(axes, ((2.65, 0.6), (1.5, 0.6), (1.5, 1.9 - _RADIUS)))
        axes.plot([5.1], [1.9], marker="o", markersize=4, color="black")
        _label(axes, 0.7, 1.9, "$U(s)$")
        _label(axes, 5.7, 1.9, "$Y(s)$")
        axes.text(1.5 - _RADIUS - 0.08, 1.9 - 0.12, "$+$", ha="right", va="top")
        axes.text(1.5 + 0.08, 1.9 - _RADIUS - 0.08, "$-$", ha="left", va="top")
    return figure


def _canvas(width: float, height: float) -> tuple[Figure, Axes]:
    """Return a figure whose one unit of data is one inch."""
    figure = new_figure(height, width)
    figure.set_layout_engine("none")
    axes = figure.add_axes((0.0, 0.0, 1.0, 1.0))
    axes.set_axis_off()
    axes.set(xlim=(0.0, width), ylim=(0.0, height))
    return figure, axes


def _block(axes: Axes, x: float, y: float, text: str) -> None:
    from matplotlib.patches import Rectangle

    width, height = _BLOCK
    axes.add_patch(
        Rectangle((x - width / 2, y - height / 2), width, height, fill=False, linewidth=_LINE_WIDTH)
    )
    axes.text(x, y, text, ha="center", va="center", fontsize=13)


def _summing_junction(axes: Axes, x: float, y: float) -> None:
    from matplotlib.patches import Circle

    axes.add_patch(Circle((x, y), _RADIUS, fill=False, linewidth=_LINE_WIDTH))


def _label(axes: Axes, x: float, y: float, text: str) -> None:
    axes.text(x, y + 0.08, text, ha="center", va="bottom", fontsize=12)


def _arrow(axes: Axes, points: Sequence[tuple[float, float]]) -> None:
    """Draw a line through the points with a head at the last."""
    *_, tail, head = points
    xs, ys = zip(*points, strict=True)
    axes.plot(xs[:-1], ys[:-1], color="black", linestyle="solid", linewidth=_LINE_WIDTH)
    axes.annotate(
        "",
        head,
        tail,
        arrowprops={
            "arrowstyle": "-|>",
            "color": "black",
            "linewidth": _LINE_WIDTH,
            "shrinkA": 0,
            "shrinkB": 0,
            "mutation_scale": 12,
        },
    )
