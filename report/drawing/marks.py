"""What figures put on their axes besides curves: names beside places, arrows, lengths, few ticks."""

from __future__ import annotations

from collections.abc import Sequence
from typing import TYPE_CHECKING, Any, Final

from matplotlib.ticker import FixedFormatter

from report.drawing.style import BLACK

if TYPE_CHECKING:
    from matplotlib.axes import Axes
    from matplotlib.axis import Axis

    Place = tuple[float, float] | complex


STABLE: Final = "_stable limit cycle"
UNSTABLE: Final = "_unstable limit cycle"
"""Labels of the marks of limit cycles; no legend shows them, the caption says what full and open mean."""


def limit_cycle(axes: Axes, place: Place, *, stable: bool) -> None:
    """Mark a limit cycle as in all figures: full where it is stable, open where it is not."""
    x, y = _pair(place)
    fill, label = (BLACK, STABLE) if stable else ("white", UNSTABLE)
    axes.plot([x], [y], "o", color=BLACK, markersize=5.0, markerfacecolor=fill, label=label, zorder=4)


def beside(axes: Axes, text: str, place: Place, offset: tuple[float, float], **keywords: Any) -> None:
    """Write a text beside a place; the offset is in points."""
    axes.annotate(text, _pair(place), offset, textcoords="offset points", **keywords)


def arrow(axes: Axes, start: Place, end: Place, **look: Any) -> None:
    """Draw an arrow, such as one of rising time on a curve; ``look`` are properties of arrows."""
    properties = {"arrowstyle": "-|>", "color": BLACK, "mutation_scale": 11} | look
    axes.annotate("", _pair(end), _pair(start), arrowprops=properties)


def span(axes: Axes, start: tuple[float, float], end: tuple[float, float], text: str = "") -> None:
    """Draw a length between two points, with its name above the middle."""
    axes.annotate("", end, start, arrowprops={"arrowstyle": "<->", "shrinkA": 0, "shrinkB": 0})
    axes.text((start[0] + end[0]) / 2, (start[1] + end[1]) / 2 + 0.05, text, ha="center", va="bottom")


class Names(FixedFormatter):
    """Words at the places 0, 1, 2, … of an axis, off which no number can be read."""


def name_places(axis: Axis, names: Sequence[str]) -> None:
    """Give an axis names in place of numbers."""
    axis.set_ticks(range(len(names)))
    axis.set_major_formatter(Names(names))
    axis.grid(visible=False)


def few_ticks(*axis: Axis, intervals: int = 4) -> None:
    """Give an axis, or several, few ticks with plain numbers, which are quicker to set than mathematics."""
    from matplotlib.ticker import MaxNLocator, StrMethodFormatter

    for each in axis:
        each.set_major_locator(MaxNLocator(intervals, steps=[1, 2, 5, 10]))
        each.set_major_formatter(StrMethodFormatter("{x:g}"))


def _pair(place: Place) -> tuple[float, float]:
    return (place.real, place.imag) if isinstance(place, complex) else place
