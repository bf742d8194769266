"""The picture of harmonic balance: G(j omega) and -1/N in the complex plane, limit cycles marked."""

import numpy as np
from matplotlib.axes import Axes
from matplotlib.figure import Figure

from trimmer.arrays import Complexes, Reals
from trimmer.balance.limit_cycle import HarmonicBalance, LimitCycle
from trimmer.drawing.axes import add_legend
from trimmer.drawing.content import figure_of, new_figure
from trimmer.drawing.dispatch import draw
from trimmer.drawing.frequencies import telling_frequencies
from trimmer.drawing.look import line
from trimmer.drawing.marks import critical_point, limit_cycle
from trimmer.drawing.plane import MARGIN, Along, element_locus, show, system_locus
from trimmer.elements.element import Element
from trimmer.linear.measured_response import MeasuredResponse, response_of
from trimmer.linear.zero_pole_gain import ZeroPoleGain
from trimmer.loops.loops import ClosedLoop
from trimmer.loops.measured_loop import MeasuredLoop

ANY = np.geomspace(1e-6, 1e6, 1800)  # u = amplitude_scale/amplitude where any amplitude will do
SHARES = np.concatenate([np.geomspace(1e-6, 0.5, 600), 1.0 - np.geomspace(0.5, 1e-9, 1200)[1:]])
"""Shares of the largest u, close together at both ends."""
EACH_INTEGRATED = 9
"""One place of so many is shown of an element without closed form, each point of which is integrated."""
CLOSE = 0.25  # Share of the picture, across and up, within which limit cycles are enlarged
FAR = 4.0  # How far out a locus is shown that goes to infinity, in sizes of what is of interest


def balance_figure(balance: HarmonicBalance) -> Figure:
    """Draw G and -1/N; where the limit cycles lie close together for that, a second panel enlarges them."""
    whole, near = _spans(balance)
    if not near.size or (near > CLOSE * whole).any():
        return figure_of(balance.plot)
    figure = new_figure(7.2, 8.2)
    upper, lower = figure.subplots(2)
    draw_balance(balance, upper)
    draw_balance(balance, lower, near=True)
    upper.set_title("all of G(jω)", fontsize="medium")
    lower.set_title("around the limit cycles", fontsize="medium")
    return figure


@draw.register(HarmonicBalance)
def draw_balance(balance: HarmonicBalance, axes: Axes, *, near: bool = False) -> None:
    """Draw G and -1/N, and mark the limit cycles.

    An element that depends on frequency has one curve per limit cycle, at its frequency.
    """
    loop = _loop(balance)
    system_locus(axes, loop.system, _omegas(balance), label="G(jω)", **line(0))
    for number, (label, at) in enumerate(_frequencies(balance), start=1):
        draw_element_curve(axes, loop.element, at, label, number)
    for cycle, place in zip(balance.limit_cycles, _places(balance), strict=True):
        limit_cycle(axes, place, stable=cycle.stable, label=_words(cycle))
    critical_point(axes)
    show(axes, _places(balance, -1.0) if near and balance.limit_cycles else _shown(balance), MARGIN)
    axes.set_xlabel("real part")
    axes.set_ylabel("imaginary part")
    axes.grid(alpha=0.3)
    add_legend(axes, title="A: amplitude in the unit\nof the element's input" if balance.limit_cycles else "")


def _loop(balance: HarmonicBalance) -> ClosedLoop | MeasuredLoop:
    if balance.loop is None:
        raise ValueError("the result has no loop, so there is nothing to draw: make it with harmonic_balance")
    return balance.loop


def _omegas(balance: HarmonicBalance) -> Reals:
    system = _loop(balance).system
    if isinstance(system, MeasuredResponse):
        return system.omega
    return telling_frequencies(ZeroPoleGain.of(system), balance.certificate.omegas)


def _places(balance: HarmonicBalance, *others: complex) -> Complexes:
    """Return where the limit cycles lie on G, and other places."""
    omegas = np.array([cycle.omega for cycle in balance.limit_cycles])
    return np.concatenate([response_of(_loop(balance).system, omegas), others])


def _spans(balance: HarmonicBalance) -> tuple[Reals, Reals]:
    """Return width and height of all that is shown, and of what is around the limit cycles, if any."""
    near = _places(balance, -1.0) if balance.limit_cycles else np.empty(0)
    whole, close = (
        [np.ptp(each.real), np.ptp(each.imag)] if each.size else [] for each in (_shown(balance), near)
    )
    return np.array(whole), np.array(close)


def draw_element_curve(axes: Axes, element: Element, omega: float | None, label: str, number: int) -> None:
    """Draw -1/N over the whole domain, with the amplitude along it, as the line of a number."""
    ratios = ratios_of(element, omega)
    along = Along("A", "", element.amplitude_scale / ratios)
    element_locus(axes, element, ratios, along, omega, label=label, **line(number))


def ratios_of(element: Element, omega: float | None) -> Reals:
    """Return u = amplitude_scale/amplitude over the domain of an element, close together at both ends."""
    # From ``constant_from`` on the curve is one point.
    largest = min(float(element.domain(omega)), element.constant_from)
    ratios = ANY if np.isinf(largest) else largest * SHARES
    return ratios if element.has_bounds else ratios[::EACH_INTEGRATED]


def _frequencies(balance: HarmonicBalance) -> list[tuple[str, float | None]]:
    """Return the curves of -1/N: label, and omega where it depends on that."""
    if not _loop(balance).element.depends_on_frequency:
        return [("−1/N(A)", None)]
    found = [cycle.omega for cycle in balance.limit_cycles]
    omegas = found or [float(np.sqrt(balance.certificate.omegas[0]) * np.sqrt(balance.certificate.omegas[1]))]
    return [(f"−1/N(A), {omega / (2 * np.pi):.5g} Hz", omega) for omega in omegas]


def _words(cycle: LimitCycle) -> str:
    kind = "stable" if cycle.stable else "unstable"
    return f"{kind}: {cycle.frequency:.5g} Hz,\nA = {cycle.amplitude:.4g}"


def _shown(balance: HarmonicBalance) -> Complexes:
    """Return what is to be seen: G, -1 and limit cycles; of a G that goes to infinity what is near them."""
    system = _loop(balance).system
    response, places = response_of(system, _omegas(balance)), _places(balance, -1.0)
    if isinstance(system, MeasuredResponse) or (np.real(ZeroPoleGain.of(system).poles) == 0).any():
        response = response[abs(response) <= FAR * abs(places).max()]
    return np.concatenate([response, places])
