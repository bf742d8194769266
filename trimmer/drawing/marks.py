"""Marks in the complex plane, and arrows."""

from typing import Any, Final

from matplotlib.axes import Axes

from trimmer.drawing.look import BLACK

PlanePoint = tuple[float, float] | complex

STABLE: Final = "_stable limit cycle"
UNSTABLE: Final = "_unstable limit cycle"  # Labels of the marks of limit cycles; no legend shows them


def limit_cycle(axes: Axes, place: PlanePoint, *, stable: bool, label: str | None = None) -> None:
    """Mark a limit cycle as in all pictures: full where it is stable, open where it is not."""
    x, y = as_pair(place)
    fill, usual = (BLACK, STABLE) if stable else ("white", UNSTABLE)
    # A mark without a line, so that its legend shows none either.
    axes.plot(
        [x], [y], "o", label=label or usual, color=BLACK, markersize=5.0, markerfacecolor=fill, zorder=4
    )


def critical_point(axes: Axes) -> None:
    """Mark -1, the point that the Nyquist criterion is about."""
    axes.plot([-1], [0], "+", color=BLACK, markersize=9, markeredgewidth=1.6)


def arrow(axes: Axes, start: PlanePoint, end: PlanePoint, **look: Any) -> None:
    """Draw an arrow, such as one of rising time on a curve; ``look`` are properties of arrows."""
    properties = {"arrowstyle": "-|>", "color": BLACK, "mutation_scale": 11} | look
    axes.annotate("", as_pair(end), as_pair(start), arrowprops=properties)


def as_pair(place: PlanePoint) -> tuple[float, float]:
    """Return a place as two numbers."""
    return (place.real, place.imag) if isinstance(place, complex) else place
