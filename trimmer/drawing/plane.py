"""The plane of G and -1/N: loci of linear systems and of elements, with omega or amplitude along them."""

from dataclasses import dataclass
from typing import Any, final

import control
import numpy as np
from matplotlib.axes import Axes
from matplotlib.lines import Line2D

from trimmer.arrays import Complexes, Reals
from trimmer.elements.element import Element
from trimmer.linear.measured_response import MeasuredResponse, response_of

MARGIN = 0.08  # Free room around what is shown, as a share of it


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


def show(axes: Axes, places: Complexes, least: float) -> None:
    """Show some places with a margin around them, whatever lies outside; ``least`` where they are one."""
    for parts, set_limits in ((places.real, axes.set_xlim), (places.imag, axes.set_ylim)):
        lowest, highest = float(parts.min()), float(parts.max())
        margin = MARGIN * (highest - lowest) or least
        set_limits(lowest - margin, highest + margin)


def system_locus(axes: Axes, system: control.lti.LTI | MeasuredResponse, omega: Reals, **look: Any) -> None:
    """Draw G(j omega); ``look`` are keywords of ``Axes.plot``."""
    plot_along(axes, response_of(system, omega), Along("ω", "rad/s", omega), **look)


def inverse(element: Element, ratios: Reals, omega: float | None = None) -> Complexes:
    """Return -1/N at u = amplitude_scale/amplitude, (n,), and omega, rad/s, if N depends on it."""
    gain = element.describing_function(element.amplitude_scale / ratios, omega)
    with np.errstate(divide="ignore", invalid="ignore"):
        return np.asarray(-1.0 / gain)


def element_locus(
    axes: Axes, element: Element, ratios: Reals, along: Along, omega: float | None = None, **look: Any
) -> None:
    """Draw -1/N over u; ``along`` is what can be read off it, ``look`` are keywords of ``Axes.plot``."""
    plot_along(axes, inverse(element, ratios, omega), along, **look)
