"""G with -1/N of backlash (figures 5.5, 5.8, 5.13, 5.15 and 5.16)."""

from collections.abc import Iterable
from typing import Final

import control
import numpy as np
from matplotlib.axes import Axes
from matplotlib.figure import Figure

from report.data.figures import figure
from report.numbers.evidence import Evidence
from report.numbers.limit_cycle_numbers import Pair, cycles_of_constant_gamma
from report.numbers.listed_functions import friction_listing, listing_contour
from report.pages.drawing import plane
from report.pages.drawing.marks import beside
from report.pages.drawing.read_out import Along, plot_along
from report.pages.drawing.style import BLACK, LINES, Look, panels
from trimmer import FrictionBacklash, InertiaBacklash, ViscousBacklash, response_at
from trimmer.elements.element import Element

Offset = tuple[float, float]
View = tuple[tuple[float, float], tuple[float, float]]

LIBRARY_GAP: Final = 1e-4
GAMMAS: Final = (1.05, 1.25, 1.45)
BAND: Final = (4.6e3, 5.38e3)  # Ends of the band of stable limit cycles that the thesis draws, rad/s
VIEW: Final = ((-1.45, -0.2), (-0.65, 0.35))
"""Part of the plane of figure 5.15: limits of the real and of the imaginary part."""
OMEGA: Final = np.geomspace(500, 2e4, 6000)
RATIOS: Final = np.geomspace(1e-3, 0.9999, 800)
"""Gap over amplitude in figures 5.8 and 5.13, as a share of the largest one in the domain."""


@figure("fig-5.5")
def second_implementation(known: Evidence) -> Figure:
    library = control.friction_backlash_nonlinearity(LIBRARY_GAP)
    amplitudes = LIBRARY_GAP * (0.5 + np.geomspace(1e-3, 25, 400))
    listing = np.array([-1 / friction_listing(a, LIBRARY_GAP) for a in amplitudes])
    sparse = LIBRARY_GAP * np.array([0.51, 0.515, 0.52, 0.53, 0.545, 0.57, 0.62, 0.7, 0.9, 1.5, 5])
    squares = np.array([-1 / library.describing_function(a) for a in sparse])
    figure, (loci, sizes) = panels(3.6, 1, 2)
    plane.locus(loci, known.numbers.displacement_only)
    plane.curve(loci, listing, "$-1/N$, listing", LINES[1])
    loci.plot(squares.real, squares.imag, "s", color=BLACK, markersize=4, label="python-control")
    plane.frame(loci, "both curves, $b$ = 0.1 mm", (-9, 3), (-20, 7))
    loci.legend(loc="upper left")
    gaps = np.concatenate([np.linspace(0.2, 0.5, 120), np.linspace(0.5, 2, 200)[1:]])
    ours = [abs(friction_listing(a * LIBRARY_GAP, LIBRARY_GAP)) for a in gaps]
    theirs = [abs(library.describing_function(a * LIBRARY_GAP)) for a in gaps[::8]]
    sizes.plot(gaps, ours, **LINES[1])
    sizes.plot(gaps[::8], theirs, "s", color=BLACK, markersize=4)
    sizes.axvspan(0.2, 0.5, color="#eeeeee")
    sizes.annotate("shaded: inside\nof the dead band", (0.53, 1.2), fontsize=8)
    sizes.set(xlabel="amplitude over gap", ylabel="$|N|$", title="what they return")
    sizes.set(xlim=(0.2, 2), ylim=(-0.05, 1.4))
    return figure


@figure("fig-5.8")
def friction_intersections(known: Evidence) -> Figure:
    cycles, numbers, element = known.cycles, known.numbers, FrictionBacklash(1.0)
    figure, (left, right) = panels(3.6, 1, 2)
    _crossings(left, numbers.displacement_only, element, cycles.friction, ((12, 10), (-20, 14)))
    _crossings(right, numbers.displacement_only, element, cycles.friction, ((0, 0), (-14, 14)))
    both = "$G$, with the pin's velocity"
    _locus(right, numbers.both_channels, both, LINES[2])
    _marks(right, numbers.both_channels, cycles.friction_both_channels, ((0, 0), (14, -16)))
    plane.frame(left, "both limit cycles", (-9, 3), (-17, 3))
    plane.frame(right, "the stable one, two loops", (-1.35, -0.85), (-0.4, 0.05), left=False)
    figure.legend(*right.get_legend_handles_labels(), loc="outside lower center", ncols=3)
    return figure


@figure("fig-5.13")
def inertia_intersections(known: Evidence) -> Figure:
    figure, (left, right) = panels(3.6, 1, 2)
    for axes, offsets in ((left, ((12, -16), (10, 20))), (right, ((0, 0), (14, 24)))):
        _crossings(axes, known.numbers.displacement_only, InertiaBacklash(1.0), known.cycles.inertia, offsets)
    plane.frame(left, "both limit cycles", (-2, 2), (-2, 2))
    plane.frame(right, "the stable one", (-1.1, -0.8), (-0.15, 0.05), left=False)
    left.legend(loc="upper left")
    return figure


def _crossings(
    axes: Axes, system: control.lti.LTI, element: Element, pair: Pair, offsets: tuple[Offset, Offset]
) -> None:
    """Draw G, -1/N and both limit cycles with frequency and amplitude."""
    amplitudes = 1 / (RATIOS * float(element.domain(1.0)))
    inverse = -1 / element.describing_function(amplitudes)
    _locus(axes, system, "$G$", LINES[0])
    plot_along(axes, inverse, Along("A", "gaps", amplitudes), label="$-1/N$", **LINES[1])
    plane.critical_point(axes)
    _marks(axes, system, pair, offsets)


def _locus(axes: Axes, system: control.lti.LTI, label: str, line: Look) -> None:
    plot_along(axes, response_at(system, OMEGA), Along("ω", "rad/s", OMEGA), label=label, **line)


def _marks(axes: Axes, system: control.lti.LTI, pair: Pair, offsets: tuple[Offset, Offset]) -> None:
    """Mark both limit cycles, the unstable one first; one without an offset has no text."""
    cycles = (pair.unstable, pair.stable)
    texts = [
        f"{cycle.frequency:.1f} Hz, {cycle.amplitude:.3g} gaps" if any(offset) else ""
        for cycle, offset in zip(cycles, offsets, strict=True)
    ]
    plane.mark(axes, system, cycles, texts, offsets)


@figure("fig-5.15")
def higher_harmonics(known: Evidence) -> Figure:
    system, cycle = known.numbers.displacement_only, known.cycles.inertia.stable
    points = plane.inverse(InertiaBacklash(1.0))
    ends = response_at(system, np.array(BAND))
    radius = float(max(np.abs(points - end).min() for end in ends))
    figure, axes = panels(3.8, width=5.6)
    # The band: what is nearer to the curve than the farther one of its ends.
    real, imaginary = (np.linspace(*limits, 100) for limits in VIEW)
    place = real[np.newaxis, :] + 1j * imaginary[:, np.newaxis]
    distance = np.abs(place[..., np.newaxis] - points).min(axis=-1)
    colour, dashes = [LINES[3]["color"]], [LINES[3]["linestyle"]]
    axes.contourf(real, imaginary, distance, [0, radius], colors=colour, alpha=0.15)
    axes.contour(real, imaginary, distance, [radius], colors=colour, linestyles=dashes)
    axes.plot([], [], label=f"{radius:.2f} around it, which the band needs", **LINES[3])
    plane.locus(axes, system)
    plane.element_curve(axes, InertiaBacklash(1.0), "$-1/N$, inertia-controlled", LINES[1])
    axes.plot(ends.real, ends.imag, "D", color=BLACK, markersize=5, label="ends of the band")
    for omega, end, (side, offset) in zip(BAND, ends, (("right", (-4, 6)), ("left", (10, -13))), strict=True):
        beside(axes, f"{omega:.0f} rad/s", end, offset, fontsize=8, ha=side)
    plane.mark(axes, system, (cycle,), (f"{cycle.omega:.0f} rad/s",), ((14, 22),))
    plane.frame(axes, "near $-1$", *VIEW)
    axes.set_aspect("equal")
    figure.legend(loc="outside lower center", ncols=2)
    return figure


@figure("fig-5.16")
def viscous_contours(known: Evidence) -> Figure:
    system = known.numbers.displacement_only
    figure, grid = panels(6.4, 2, 2)
    _limits(grid[0], system, "right contact angle", ((-2.3, 0.9), (-3.1, 0.6)))
    _limits(grid[1], system, "Listing A.5", ((-5, 7), (-7, 1.5)))
    for gamma, line in zip(GAMMAS, LINES[2:], strict=False):
        for right, listing in grid.T:
            plane.element_curve(right, ViscousBacklash(1.0, gamma).at(1.0), f"$\\gamma$ = {gamma}", line)
            plane.curve(listing, listing_contour(gamma), f"$\\gamma$ = {gamma}", line)
    for gamma in GAMMAS:
        for axes, cycle in zip(grid[0], cycles_of_constant_gamma(system, gamma), strict=True):
            plane.mark(axes, system, (cycle,), ("",), ((1, 1),))
    grid[1, 1].set_title("Listing A.5 near $-1$: no contour")
    figure.legend(*grid[0, 0].get_legend_handles_labels(), loc="outside lower center", ncols=6)
    return figure


def _limits(row: Iterable[Axes], system: control.lti.LTI, title: str, view: View) -> None:
    """Draw G and the two limits of the load, in two parts of the plane."""
    whole, near = row
    for axes in (whole, near):
        plane.locus(axes, system)
        plane.element_curve(axes, FrictionBacklash(1.0), "friction", LINES[1])
        plane.element_curve(axes, InertiaBacklash(1.0), "inertia", LINES[5])
    plane.frame(whole, title, *view)
    plane.frame(near, "the same near $-1$", (-1.04, -0.91), (-0.11, 0.01), left=False)
