"""G with -1/N of friction- and inertia-controlled backlash (thesis, figures 5.8 and 5.13)."""

from __future__ import annotations

from typing import TYPE_CHECKING

import numpy as np

from report.drawing.read_out import Along, plot_along
from report.drawing.style import LINES, new_figure, style
from report.evidence import Evidence
from report.numbers.limit_cycle_numbers import Pair
from trimmer import frequency_response
from trimmer.elements.friction_backlash import FrictionBacklash
from trimmer.elements.inertia_backlash import InertiaBacklash

if TYPE_CHECKING:
    import control
    from matplotlib.axes import Axes
    from matplotlib.figure import Figure

    from trimmer.elements.element import Element

OMEGA = np.geomspace(500, 2e4, 6000)
RATIOS = np.geomspace(1e-3, 0.9999, 800)
"""Gap over amplitude, as a share of the largest one in the domain."""


def friction_intersections(evidence: Evidence) -> Figure:
    """Draw friction-controlled backlash, for the thesis's loop and with the pin's velocity."""
    cycles, numbers = evidence.cycles, evidence.numbers
    element = FrictionBacklash(1.0)
    with style():
        figure = new_figure(3.6)
        left, right = figure.subplots(1, 2)
        _curves(left, numbers.displacement_only, element, cycles.friction, 0)
        _curves(right, numbers.displacement_only, element, cycles.friction, 0)
        _curves(right, numbers.both_channels, element, cycles.friction_both_channels, 2)
        _named(left, "both limit cycles", (-9, 3), (-17, 3))
        _named(right, "the stable one, with and without velocity", (-1.35, -0.85), (-0.4, 0.05))
        left.set_ylabel("imaginary part")
        left.legend(["$G$", "$-1/N$", "limit cycles"], loc="upper left")
    return figure


def inertia_intersections(evidence: Evidence) -> Figure:
    """Draw inertia-controlled backlash over its whole domain."""
    cycles, numbers = evidence.cycles, evidence.numbers
    with style():
        figure = new_figure(3.6)
        left, right = figure.subplots(1, 2)
        for axes in (left, right):
            _curves(axes, numbers.displacement_only, InertiaBacklash(1.0), cycles.inertia, 0)
        _named(left, "both limit cycles", (-2, 2), (-2, 2))
        _named(right, "the stable one", (-1.1, -0.8), (-0.15, 0.05))
        left.set_ylabel("imaginary part")
        left.legend(["$G$", "$-1/N$", "limit cycles"], loc="upper left")
    return figure


def _named(axes: Axes, title: str, real: tuple[float, float], imaginary: tuple[float, float]) -> None:
    axes.set(title=title, xlabel="real part", xlim=real, ylim=imaginary)


def _curves(axes: Axes, system: control.TransferFunction, element: Element, pair: Pair, line: int) -> None:
    response = frequency_response(system, OMEGA)
    amplitudes = 1 / (RATIOS * float(element.domain(1.0)))
    inverse = -1 / element.describing_function(amplitudes)
    plot_along(axes, response, Along("ω", "rad/s", OMEGA), label="G", **LINES[line].keywords)
    plot_along(axes, inverse, Along("A", "gaps", amplitudes), label="−1/N", **LINES[1].keywords)
    points = frequency_response(system, np.array([pair.unstable.omega, pair.stable.omega]))
    axes.plot(points.real, points.imag, "o", color="black", markersize=5)
    axes.plot([-1], [0], "+", color="black", markersize=9, markeredgewidth=1.6)
    for cycle, point, below in zip((pair.unstable, pair.stable), points, (True, False), strict=True):
        axes.annotate(
            f"{cycle.frequency:.1f} Hz, {cycle.amplitude:.3g} gaps",
            (point.real, point.imag),
            (8, -12) if below else (8, 8),
            textcoords="offset points",
            fontsize=8,
            annotation_clip=True,
            bbox={"facecolor": "white", "edgecolor": "none", "pad": 0.5, "alpha": 0.8},
        )
