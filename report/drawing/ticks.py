"""Few and plain tick labels: readable in a small panel, and quick to set."""

from __future__ import annotations

from typing import TYPE_CHECKING

if TYPE_CHECKING:
    from matplotlib.axis import Axis


def few_ticks(*axis: Axis, intervals: int = 4) -> None:
    """Give an axis, or several, few ticks with plain numbers instead of mathematics."""
    from matplotlib.ticker import MaxNLocator, StrMethodFormatter

    for each in axis:
        each.set_major_locator(MaxNLocator(intervals, steps=[1, 2, 5, 10]))
        each.set_major_formatter(StrMethodFormatter("{x:g}"))
