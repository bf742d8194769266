"""The picture of harmonic balance: G(j omega) and -1/N in the complex plane, intersections marked."""

from __future__ import annotations

from typing import TYPE_CHECKING

import numpy as np
from matplotlib.figure import Figure

from trimmer.drawing.content import content_of
from trimmer.linear.frequency_response import response_at

if TYPE_CHECKING:
    from matplotlib.axes import Axes

    from trimmer.arrays import Complexes
    from trimmer.balance.limit_cycle import HarmonicBalance
    from trimmer.elements.element import Element
    from trimmer.motion.loops import ClosedLoop

_POINTS = 4000
_POINTS_INTEGRATED = 120
_SIZE = (6.4, 5.0)


def draw_loci(loop: ClosedLoop, balance: HarmonicBalance, file_format: str) -> bytes:
    """Draw G and -1/N, mark the limit cycles, and return the content of the file.

    An element that depends on frequency has one curve per limit cycle, at its frequency.

    Args:
        loop: The closed loop.
        balance: Limit cycles; its certificate gives the range of frequencies, rad/s.
        file_format: ``svg``, ``png`` or ``pdf``.
    """
    figure = Figure(figsize=_SIZE, layout="constrained")
    axes = figure.add_subplot()
    omega = np.geomspace(*balance.certificate.omegas, _POINTS)
    response = response_at(loop.system, omega)
    axes.plot(response.real, response.imag, label="G(jω)")
    for label, curve in _element_curves(loop.element, balance):
        axes.plot(curve.real, curve.imag, label=label)
    for cycle in balance.limit_cycles:
        point = complex(response_at(loop.system, cycle.omega))
        kind = "stable" if cycle.stable else "unstable"
        text = f"{cycle.frequency:.4g} Hz, {cycle.amplitude:.4g} ({kind})"
        axes.plot(
            point.real,
            point.imag,
            "o",
            color="black",
            fillstyle="full" if cycle.stable else "none",
            label=text,
        )
    _frame(axes, response)
    axes.set_xlabel("real part")
    axes.set_ylabel("imaginary part")
    axes.grid(alpha=0.3)
    axes.legend(fontsize="small")
    return content_of(figure, file_format)


def _element_curves(element: Element, balance: HarmonicBalance) -> list[tuple[str, Complexes]]:
    """Return the curves -1/N over amplitude, down to the smallest of the domain, with their labels."""
    if not element.depends_on_frequency:
        return [("-1/N(A)", _inverse(element, None))]
    omegas = [cycle.omega for cycle in balance.limit_cycles] or [np.sqrt(np.prod(balance.certificate.omegas))]
    return [(f"-1/N(A) at {omega:.5g} rad/s", _inverse(element, omega)) for omega in omegas]


def _inverse(element: Element, omega: float | None) -> Complexes:
    largest = min(float(element.domain(omega)), element.constant_from, 1e6)
    # Without a closed form each point is integrated.
    points = _POINTS if element.has_bounds else _POINTS_INTEGRATED
    u = largest * np.concatenate([np.geomspace(1e-6, 0.5, points), 1.0 - np.geomspace(0.5, 1e-9, points)])
    gain = element.describing_function(element.amplitude_scale / u, omega)
    return np.asarray(-1.0 / gain[gain != 0])


def _frame(axes: Axes, response: Complexes) -> None:
    """Show G, whatever -1/N does outside."""
    for parts, set_limits in ((response.real, axes.set_xlim), (response.imag, axes.set_ylim)):
        lowest, highest = float(parts.min()), float(parts.max())
        margin = 0.06 * (highest - lowest or 1.0)
        set_limits(lowest - margin, highest + margin)
