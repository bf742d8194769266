"""The block diagrams (figures 2.3 to 2.6 and 2.15), on a canvas in inches."""

from typing import Final

from matplotlib.axes import Axes
from matplotlib.figure import Figure

from report.data.figures import figure
from report.numbers.evidence import Evidence
from report.pages.drawing.marks import arrow
from report.pages.drawing.mechanical_symbols import LINE, canvas
from report.pages.drawing.style import BLACK

Place = tuple[float, float]

BLOCK: Final = (1.5, 0.9)
FLAT: Final = (1.5, 0.6)
RADIUS: Final = 0.2


@figure("fig-2.3")
def linear_system(_: Evidence) -> Figure:
    figure, axes = canvas(5.5, 1.3)
    _blocks(axes, {"$G(s)$": (2.75, 0.65)})
    _along(axes, 0.65, (0.3, 2.0), (3.5, 5.2))
    _labels(axes, {"$u(t)$": (0.8, 0.65), "$y(t)$": (4.5, 0.65)})
    return figure


@figure("fig-2.4")
def feedback_system(_: Evidence) -> Figure:
    figure, axes = canvas(6.5, 2.6)
    _blocks(axes, {"$G(s)$": (3.4, 1.9), "$N(s)$": (3.4, 0.6)})
    _junction(axes, 1.5, 1.9)
    _along(axes, 1.9, (0.3, 1.3), (1.7, 2.65), (4.15, 6.2))
    _arrow(axes, (5.1, 1.9), (5.1, 0.6), (4.15, 0.6))
    _arrow(axes, (2.65, 0.6), (1.5, 0.6), (1.5, 1.7))
    _branch(axes, 5.1, 1.9)
    _labels(axes, {"$U(s)$": (0.7, 1.9), "$Y(s)$": (5.7, 1.9)})
    _signs(axes, 1.5, 1.9)
    return figure


@figure("fig-2.5")
def loop_without_reference(_: Evidence) -> Figure:
    figure, axes = canvas(6.5, 2.2)
    _blocks(axes, {r"$N(A,\omega)$": (2.7, 1.5), r"$G(j\omega)$": (4.8, 1.5)})
    _junction(axes, 1.3, 1.5)
    _along(axes, 1.5, (0.1, 1.1), (1.5, 1.95), (3.45, 4.05), (5.55, 6.4))
    _arrow(axes, (5.9, 1.5), (5.9, 0.4), (1.3, 0.4), (1.3, 1.3))
    _branch(axes, 5.9, 1.5)
    _labels(axes, {"$r(t) = 0$": (0.55, 1.5), "$e$": (1.72, 1.5), "$u$": (3.75, 1.5), "$y$": (6.15, 1.5)})
    _signs(axes, 1.3, 1.5)
    return figure


@figure("fig-2.6")
def describing_function_block(_: Evidence) -> Figure:
    figure, axes = canvas(6.5, 1.3)
    _blocks(axes, {r"$N(A,\omega)$": (3.0, 0.65)})
    _along(axes, 0.65, (0.2, 2.25), (3.75, 6.3))
    _labels(
        axes, {r"$A\,\sin\omega t$": (1.2, 0.65), r"$M\,\sin(\omega t + \varphi) + \ldots$": (5.05, 0.65)}
    )
    axes.text(5.05, 0.55, "higher harmonics", ha="center", va="top", fontsize=9)
    return figure


@figure("fig-2.15")
def parallel_nonlinearities(_: Evidence) -> Figure:
    figure, axes = canvas(6.5, 5.6)
    axes.text(0.1, 5.4, "(a)", va="center")
    _junction(axes, 1.1, 4.9)
    _blocks(
        axes, {"$G_m(s)$": (2.6, 4.9), "$G_g(s)$": (4.8, 4.9), "$N_f$": (2.6, 4.1), "$N_r$": (3.7, 3.3)}, FLAT
    )
    _along(axes, 4.9, (1.3, 1.85), (3.35, 4.05))
    _arrow(axes, (3.7, 4.9), (3.7, 4.1), (3.35, 4.1))
    _arrow(axes, (1.85, 4.1), (1.1, 4.1), (1.1, 4.7))
    _arrow(axes, (5.55, 4.9), (6.1, 4.9), (6.1, 3.3), (4.45, 3.3))
    _arrow(axes, (2.95, 3.3), (0.4, 3.3), (0.4, 4.9), (0.9, 4.9))
    _branch(axes, 3.7, 4.9)
    _labels(axes, {"$v$": (3.7, 4.9), "$x$": (6.1, 4.9)})
    _minus(axes, 1.1, 4.9)
    axes.text(0.82, 4.98, "$-$", ha="right", va="bottom")
    axes.text(0.1, 2.6, "(b)", va="center")
    _blocks(axes, {r"$G_m(s)\,G_g(s)$": (3.2, 2.2)}, (2.0, 0.6))
    _blocks(axes, {"$N_r$": (3.2, 1.3), "$N_f$": (2.4, 0.4), "$1/G_g(s)$": (4.4, 0.4)}, FLAT)
    _junction(axes, 1.1, 1.3)
    _arrow(axes, (4.2, 2.2), (6.1, 2.2), (6.1, 0.4), (5.15, 0.4))
    _along(axes, 1.3, (6.1, 3.95))
    _along(axes, 0.4, (3.65, 3.15))
    _along(axes, 1.3, (2.45, 1.3))
    _arrow(axes, (1.65, 0.4), (1.1, 0.4), (1.1, 1.1))
    _arrow(axes, (0.9, 1.3), (0.5, 1.3), (0.5, 2.2), (2.2, 2.2))
    _branch(axes, 6.1, 1.3)
    _labels(axes, {"$x$": (5.1, 2.2), "$v$": (3.4, 0.4)})
    _minus(axes, 1.1, 1.3)
    axes.text(1.38, 1.38, "$-$", ha="left", va="bottom")
    return figure


def _blocks(axes: Axes, middles: dict[str, Place], size: Place = BLOCK) -> None:
    from matplotlib.patches import Rectangle

    for text, (x, y) in middles.items():
        corner = (x - size[0] / 2, y - size[1] / 2)
        axes.add_patch(Rectangle(corner, *size, fill=False, linewidth=LINE["linewidth"]))
        axes.text(x, y, text, ha="center", va="center", fontsize=13)


def _junction(axes: Axes, x: float, y: float) -> None:
    """Draw a summing junction."""
    from matplotlib.patches import Circle

    axes.add_patch(Circle((x, y), RADIUS, fill=False, linewidth=LINE["linewidth"]))


def _branch(axes: Axes, x: float, y: float) -> None:
    """Draw the point where a signal goes two ways."""
    axes.plot([x], [y], marker="o", markersize=4, color=BLACK)


def _signs(axes: Axes, x: float, y: float) -> None:
    """Write the signs of a summing junction with a reference from the left and feedback from below."""
    axes.text(x - RADIUS - 0.08, y - 0.12, "$+$", ha="right", va="top")
    _minus(axes, x, y)


def _minus(axes: Axes, x: float, y: float) -> None:
    """Write a minus sign beside the arrow that enters a summing junction from below."""
    axes.text(x + 0.08, y - RADIUS - 0.08, "$-$", ha="left", va="top")


def _labels(axes: Axes, places: dict[str, Place]) -> None:
    for text, (x, y) in places.items():
        axes.text(x, y + 0.08, text, ha="center", va="bottom", fontsize=12)


def _along(axes: Axes, y: float, *ends: Place) -> None:
    """Draw arrows at one height, each from one place to the next."""
    for start, end in ends:
        _arrow(axes, (start, y), (end, y))


def _arrow(axes: Axes, *points: Place) -> None:
    """Draw a line through the points with a head at the last."""
    xs, ys = zip(*points[:-1], strict=True)
    axes.plot(xs, ys, **LINE)
    arrow(axes, *points[-2:], linewidth=LINE["linewidth"], shrinkA=0, shrinkB=0, mutation_scale=12)
