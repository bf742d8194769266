"""The picture of harmonic balance: G(j omega) and -1/N in the complex plane, limit cycles marked."""

from __future__ import annotations

from typing import TYPE_CHECKING

import numpy as np

from trimmer.drawing.along import Along
from trimmer.drawing.axes import add_legend, axes_for
from trimmer.drawing.frequencies import telling_frequencies
from trimmer.drawing.look import line
from trimmer.drawing.marks import critical_point, limit_cycle
from trimmer.drawing.plane import element_locus, system_locus
from trimmer.linear.frequency_response import response_at
from trimmer.linear.zero_pole_gain import ZeroPoleGain

if TYPE_CHECKING:
    from matplotlib.axes import Axes

    from trimmer.arrays import Complexes, Reals
    from trimmer.balance.limit_cycle import HarmonicBalance, LimitCycle
    from trimmer.elements.element import Element
    from trimmer.motion.loops import ClosedLoop

LARGEST_RATIO = 1e6
"""Stands for an infinite domain of u = amplitude_scale/amplitude."""
SHARES = np.concatenate([np.geomspace(1e-6, 0.5, 600), 1.0 - np.geomspace(0.5, 1e-9, 1200)[1:]])
"""Shares of the largest u, close together at both ends."""
FAR = 4.0
"""How far out a locus is shown that goes to infinity, in sizes of what is of interest."""


def draw_balance(balance: HarmonicBalance, ax: Axes | None = None) -> Axes:
    """Draw G and -1/N, and mark the limit cycles; see ``HarmonicBalance.plot``.

    An element that depends on frequency has one curve per limit cycle, at its frequency.
    """
    if balance.loop is None:
        raise ValueError("the result has no loop, so there is nothing to draw: make it with harmonic_balance")
    axes, loop = axes_for(ax), balance.loop
    factored = ZeroPoleGain.of(loop.system)
    omega = telling_frequencies(factored, balance.certificate.omegas)
    system_locus(axes, loop.system, omega, label="G(jω)", **line(0))
    for number, (label, at) in enumerate(_frequencies(balance), start=1):
        draw_element_curve(axes, loop.element, at, label, number)
    places = [complex(response_at(loop.system, cycle.omega)) for cycle in balance.limit_cycles]
    for cycle, place in zip(balance.limit_cycles, places, strict=True):
        limit_cycle(axes, place, stable=cycle.stable, label=_words(cycle))
    critical_point(axes)
    _frame(axes, response_at(loop.system, omega), places, factored)
    axes.set_xlabel("real part")
    axes.set_ylabel("imaginary part")
    axes.grid(alpha=0.3)
    add_legend(axes)
    return axes


def draw_element_curve(axes: Axes, element: Element, omega: float | None, label: str, number: int) -> None:
    """Draw -1/N over the whole domain, with the amplitude along it, as the line of a number."""
    ratios = ratios_of(element, omega)
    along = Along("A", "", element.amplitude_scale / ratios)
    element_locus(axes, element, ratios, along, omega, label=label, **line(number))


def ratios_of(element: Element, omega: float | None) -> Reals:
    """Return u = amplitude_scale/amplitude over the domain of an element, close together at both ends."""
    return min(float(element.domain(omega)), LARGEST_RATIO) * SHARES


def _frequencies(balance: HarmonicBalance) -> list[tuple[str, float | None]]:
    """Return the curves of -1/N: label, and omega where it depends on that."""
    loop: ClosedLoop | None = balance.loop
    assert loop is not None
    if not loop.element.depends_on_frequency:
        return [("−1/N(A)", None)]
    found = [cycle.omega for cycle in balance.limit_cycles]
    omegas = found or [float(np.sqrt(balance.certificate.omegas[0]) * np.sqrt(balance.certificate.omegas[1]))]
    return [(f"−1/N(A), {omega / (2 * np.pi):.5g} Hz", omega) for omega in omegas]


def _words(cycle: LimitCycle) -> str:
    kind = "stable" if cycle.stable else "unstable"
    return f"{kind}: {cycle.frequency:.5g} Hz,\nA = {cycle.amplitude:.4g}"


def _frame(axes: Axes, response: Complexes, places: list[complex], factored: ZeroPoleGain) -> None:
    """Show G, -1 and the limit cycles, whatever -1/N does outside; of an infinite G what is near them."""
    shown = response
    if (factored.roots.real[factored.exponents < 0] == 0).any():
        size = FAR * max([1.0, *map(abs, places)])
        shown = response[abs(response) <= size]
    shown = np.concatenate([shown, places, [-1.0]])
    for parts, set_limits in ((shown.real, axes.set_xlim), (shown.imag, axes.set_ylim)):
        lowest, highest = float(parts.min()), float(parts.max())
        margin = 0.06 * (highest - lowest or 1.0)
        set_limits(lowest - margin, highest + margin)
