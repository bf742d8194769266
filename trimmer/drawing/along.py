"""Curves in the complex plane with a quantity along them, such as omega along a Nyquist locus."""

from __future__ import annotations

from dataclasses import dataclass
from typing import TYPE_CHECKING, Any, final

from matplotlib.lines import Line2D

if TYPE_CHECKING:
    from matplotlib.axes import Axes

    from trimmer.arrays import Complexes, Reals


@dataclass(frozen=True)
class Along:
    """A quantity along a curve, such as omega along a Nyquist locus: symbol, unit, a value for each point."""

    quantity: str
    unit: str
    values: Reals


@final
class CurveAlong(Line2D):
    """A line with a quantity for each of its points."""

    def __init__(self, points: Complexes, along: Along, **keywords: Any) -> None:
        super().__init__(points.real, points.imag, **keywords)
        self.along = along


def plot_along(axes: Axes, points: Complexes, along: Along, **keywords: Any) -> None:
    """Draw a curve in the complex plane with a quantity along it; keywords are those of ``Axes.plot``."""
    axes.add_line(CurveAlong(points, along, **keywords))
    axes.autoscale_view()
