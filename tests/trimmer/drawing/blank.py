"""Axes without anything on them, and what is asked of axes."""

from __future__ import annotations

from matplotlib.axes import Axes
from matplotlib.figure import Figure


def new_axes() -> Axes:
    return Figure().add_subplot()


def grid(axes: Axes) -> bool:
    return bool(axes.xaxis.get_gridlines()[0].get_visible())
