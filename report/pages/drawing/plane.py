"""What figures of G with -1/N share: the plane of G, its locus, curves of -1/N, and marked limit cycles."""

import math
from collections.abc import Iterable, Sequence
from typing import Any, Final

import control
import numpy as np
from matplotlib.axes import Axes

from report.pages.drawing.marks import beside, limit_cycle
from report.pages.drawing.style import LINES, Look
from trimmer import response_at
from trimmer.arrays import Complexes, Reals
from trimmer.balance.limit_cycle import LimitCycle
from trimmer.drawing.marks import critical_point as critical_point
from trimmer.drawing.plane import Along, element_locus, system_locus
from trimmer.drawing.plane import inverse as inverse_gain
from trimmer.elements.element import Element

OMEGA: Final = 2 * math.pi * np.concatenate([np.linspace(60, 1200, 2500), np.geomspace(1200, 6000, 200)])
SHARES: Final = np.concatenate([np.geomspace(1e-7, 0.5, 160), 1 - np.geomspace(0.5, 1e-5, 280)[1:]])
"""Shares of the largest gap/amplitude, close together at both ends of the domain."""
LEADER: Final[dict[str, Any]] = {"arrowstyle": "-", "linewidth": 0.6, "shrinkA": 1, "shrinkB": 4}
"""Thin line from a text to what it names: a text stands beside the curves, never on one."""
_NEAR: Final = 12.0  # Offset of a text, in points, up to which it needs no such line


def locus(axes: Axes, system: control.lti.LTI) -> None:
    """Draw G for rising frequency."""
    system_locus(axes, system, OMEGA, label="$G$", **LINES[0])
    critical_point(axes)


def inverse(element: Element) -> Complexes:
    """Return -1/N of an element with a gap, over its domain, from large amplitudes on."""
    return inverse_gain(element, _ratios(element))


def element_curve(axes: Axes, element: Element, label: str, line: Look) -> None:
    """Draw -1/N of an element with a gap, over its domain; the page reads amplitudes in gaps off it."""
    ratios = _ratios(element)
    element_locus(axes, element, ratios, Along("A", "gaps", 1 / ratios), label=label, **line)


def _ratios(element: Element) -> Reals:
    return SHARES * float(element.domain(1.0))


def curve(axes: Axes, points: Complexes, label: str, line: Look) -> None:
    """Draw a curve in the plane of G."""
    axes.plot(points.real, points.imag, label=label, **line)


def frame(
    axes: Axes, title: str, real: tuple[float, float], imaginary: tuple[float, float], left: bool = True
) -> None:
    """Set title, labels and limits; only what stands at the left names the imaginary part."""
    axes.set(title=title, xlabel="real part", xlim=real, ylim=imaginary)
    if left:
        axes.set_ylabel("imaginary part")


def mark(
    axes: Axes,
    system: control.lti.LTI,
    cycles: Iterable[LimitCycle],
    texts: Sequence[str],
    offsets: Sequence[tuple[float, float]],
) -> None:
    """Mark limit cycles on G, full where stable and open where not, each with its text beside it."""
    for cycle, text, offset in zip(cycles, texts, offsets, strict=True):
        point = complex(response_at(system, cycle.omega))
        limit_cycle(axes, point, stable=cycle.stable)
        if text:
            side = "left" if offset[0] > 0 else "right"
            leader = LEADER if math.hypot(*offset) > _NEAR else None
            beside(axes, text, point, offset, ha=side, fontsize=8, arrowprops=leader)
