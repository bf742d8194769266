"""The block diagrams of the thesis (figures 2.3 to 2.6 and 2.15), drawn again."""

from __future__ import annotations

from collections.abc import Sequence
from typing import TYPE_CHECKING, Final

from report.drawing.style import new_figure, style

if TYPE_CHECKING:
    from matplotlib.axes import Axes
    from matplotlib.figure import Figure

_BLOCK: Final = (1.5, 0.9)
_FLAT: Final = (1.5, 0.6)
_RADIUS: Final = 0.2
_LINE_WIDTH: Final = 1.1


def linear_system() -> Figure:
    """Draw an input u(t), a block G(s) and its output y(t) (thesis, figure 2.3)."""
    with style():
        figure, axes = canvas(5.5, 1.3)
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
        figure, axes = canvas(6.5, 2.6)
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
        _signs(axes, 1.5, 1.9)
    return figure


def loop_without_reference() -> Figure:
    """Draw the loop of N and G whose reference is zero (thesis, figure 2.5)."""
    with style():
        figure, axes = canvas(6.5, 2.2)
        _block(axes, 2.7, 1.5, r"$N(A,\omega)$")
        _block(axes, 4.8, 1.5, r"$G(j\omega)$")
        _summing_junction(axes, 1.3, 1.5)
        _arrow(axes, ((0.1, 1.5), (1.3 - _RADIUS, 1.5)))
        _arrow(axes, ((1.3 + _RADIUS, 1.5), (1.95, 1.5)))
        _arrow(axes, ((3.45, 1.5), (4.05, 1.5)))
        _arrow(axes, ((5.55, 1.5), (6.4, 1.5)))
        _arrow(axes, ((5.9, 1.5), (5.9, 0.4), (1.3, 0.4), (1.3, 1.5 - _RADIUS)))
        axes.plot([5.9], [1.5], marker="o", markersize=4, color="black")
        _label(axes, 0.55, 1.5, "$r(t) = 0$")
        _label(axes, 1.72, 1.5, "$e$")
        _label(axes, 3.75, 1.5, "$u$")
        _label(axes, 6.15, 1.5, "$y$")
        _signs(axes, 1.3, 1.5)
    return figure


def describing_function_block() -> Figure:
    """Draw the element as a block from a sine to the first harmonic of its output (thesis, figure 2.6)."""
    with style():
        figure, axes = canvas(6.5, 1.3)
        _block(axes, 3.0, 0.65, r"$N(A,\omega)$")
        _arrow(axes, ((0.2, 0.65), (2.25, 0.65)))
        _arrow(axes, ((3.75, 0.65), (6.3, 0.65)))
        _label(axes, 1.2, 0.65, r"$A\,\sin\omega t$")
        _label(axes, 5.05, 0.65, r"$M\,\sin(\omega t + \varphi) + \ldots$")
        axes.text(5.05, 0.55, "higher harmonics", ha="center", va="top", fontsize=9)
    return figure


def parallel_nonlinearities() -> Figure:
    """Draw friction and backlash fed back apart, and their equivalent in parallel (thesis, figure 2.15)."""
    with style():
        figure, axes = canvas(6.5, 5.6)
        _fed_back_apart(axes)
        _in_parallel(axes)
    return figure


def _fed_back_apart(axes: Axes) -> None:
    """Draw part (a): friction is fed back from the velocity v, backlash from x, which is v after G_g."""
    axes.text(0.1, 5.4, "(a)", va="center")
    _summing_junction(axes, 1.1, 4.9)
    _block(axes, 2.6, 4.9, "$G_m(s)$", _FLAT)
    _block(axes, 4.8, 4.9, "$G_g(s)$", _FLAT)
    _block(axes, 2.6, 4.1, "$N_f$", _FLAT)
    _block(axes, 3.7, 3.3, "$N_r$", _FLAT)
    _arrow(axes, ((1.1 + _RADIUS, 4.9), (1.85, 4.9)))
    _arrow(axes, ((3.35, 4.9), (4.05, 4.9)))
    _arrow(axes, ((3.7, 4.9), (3.7, 4.1), (3.35, 4.1)))
    _arrow(axes, ((1.85, 4.1), (1.1, 4.1), (1.1, 4.9 - _RADIUS)))
    _arrow(axes, ((5.55, 4.9), (6.1, 4.9), (6.1, 3.3), (4.45, 3.3)))
    _arrow(axes, ((2.95, 3.3), (0.4, 3.3), (0.4, 4.9), (1.1 - _RADIUS, 4.9)))
    axes.plot([3.7], [4.9], marker="o", markersize=4, color="black")
    _label(axes, 3.7, 4.9, "$v$")
    _label(axes, 6.1, 4.9, "$x$")
    _minus(axes, 1.1, 4.9)
    axes.text(1.1 - _RADIUS - 0.08, 4.98, "$-$", ha="right", va="bottom")


def _in_parallel(axes: Axes) -> None:
    """Draw part (b): both have the input x, friction behind the inverse of G_g."""
    axes.text(0.1, 2.6, "(b)", va="center")
    _block(axes, 3.2, 2.2, "$G_m(s)\\,G_g(s)$", (2.0, 0.6))
    _block(axes, 3.2, 1.3, "$N_r$", _FLAT)
    _block(axes, 2.4, 0.4, "$N_f$", _FLAT)
    _block(axes, 4.4, 0.4, "$1/G_g(s)$", _FLAT)
    _summing_junction(axes, 1.1, 1.3)
    _arrow(axes, ((4.2, 2.2), (6.1, 2.2), (6.1, 0.4), (5.15, 0.4)))
    _arrow(axes, ((6.1, 1.3), (3.95, 1.3)))
    _arrow(axes, ((3.65, 0.4), (3.15, 0.4)))
    _arrow(axes, ((2.45, 1.3), (1.1 + _RADIUS, 1.3)))
    _arrow(axes, ((1.65, 0.4), (1.1, 0.4), (1.1, 1.3 - _RADIUS)))
    _arrow(axes, ((1.1 - _RADIUS, 1.3), (0.5, 1.3), (0.5, 2.2), (2.2, 2.2)))
    axes.plot([6.1], [1.3], marker="o", markersize=4, color="black")
    _label(axes, 5.1, 2.2, "$x$")
    _label(axes, 3.4, 0.4, "$v$")
    _minus(axes, 1.1, 1.3)
    axes.text(1.1 + _RADIUS + 0.08, 1.38, "$-$", ha="left", va="bottom")


def _signs(axes: Axes, x: float, y: float) -> None:
    """Write the signs of a summing junction with a reference from the left and feedback from below."""
    axes.text(x - _RADIUS - 0.08, y - 0.12, "$+$", ha="right", va="top")
    _minus(axes, x, y)


def _minus(axes: Axes, x: float, y: float) -> None:
    """Write a minus sign beside the arrow that enters a summing junction from below."""
    axes.text(x + 0.08, y - _RADIUS - 0.08, "$-$", ha="left", va="top")


def canvas(width: float, height: float) -> tuple[Figure, Axes]:
    """Return a figure whose one unit of data is one inch."""
    figure = new_figure(height, width)
    figure.set_layout_engine("none")
    axes = figure.add_axes((0.0, 0.0, 1.0, 1.0))
    axes.set_axis_off()
    axes.set(xlim=(0.0, width), ylim=(0.0, height))
    return figure, axes


def _block(axes: Axes, x: float, y: float, text: str, size: tuple[float, float] = _BLOCK) -> None:
    from matplotlib.patches import Rectangle

    width, height = size
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
