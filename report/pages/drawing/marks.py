"""What figures put on their axes besides curves: names beside places, arrows, lengths, few ticks."""

from collections.abc import Sequence
from typing import Any

from matplotlib.axes import Axes
from matplotlib.axis import Axis
from matplotlib.ticker import FixedFormatter

from trimmer.drawing.marks import STABLE as STABLE
from trimmer.drawing.marks import UNSTABLE as UNSTABLE
from trimmer.drawing.marks import PlanePoint, as_pair
from trimmer.drawing.marks import arrow as arrow
from trimmer.drawing.marks import limit_cycle as limit_cycle


def beside(axes: Axes, text: str, place: PlanePoint, offset: tuple[float, float], **keywords: Any) -> None:
    """Write a text beside a place; the offset is in points."""
    axes.annotate(text, as_pair(place), offset, textcoords="offset points", **keywords)


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
