"""G with -1/N of backlash: figures 5.5, 5.10, 5.15 and 5.16 of the thesis, drawn again."""

from __future__ import annotations

from collections.abc import Sequence
from typing import TYPE_CHECKING, Final

import control
import numpy as np

from report.chapters.chapter_5.figures.closed_loop_motion import larger_gap_over_time
from report.drawing.plane import curve, element_curve, frame, inverse, locus, mark
from report.drawing.style import BLACK, LINES, new_figure, style
from report.evidence import Evidence
from report.numbers.independent.listed_describing_functions import friction_listing
from report.numbers.viscous_listing import listing_contour
from trimmer import frequency_response
from trimmer.balance.solve import limit_cycles
from trimmer.elements.friction_backlash import FrictionBacklash
from trimmer.elements.inertia_backlash import InertiaBacklash
from trimmer.elements.viscous_backlash import ViscousBacklash

if TYPE_CHECKING:
    from matplotlib.axes import Axes
    from matplotlib.figure import Figure
    from numpy.typing import NDArray

    from trimmer.balance.limit_cycle import LimitCycle

LIBRARY_GAP: Final = 1e-4
LARGER_GAP: Final = 4e-5
GAMMAS: Final = (1.05, 1.25, 1.45)
BAND: Final = (4.6e3, 5.38e3)
"""Ends of the band of stable limit cycles that the thesis draws, rad/s."""
VIEW: Final = ((-1.45, -0.35), (-0.65, 0.35))
"""Part of the plane of figure 5.15: limits of the real and of the imaginary part."""


def second_implementation(evidence: Evidence) -> Figure:
    """Draw -1/N of Listing A.3 and of python-control, and both N over the amplitude (thesis, figure 5.5)."""
    library = control.friction_backlash_nonlinearity(LIBRARY_GAP)
    amplitudes = LIBRARY_GAP * (0.5 + np.geomspace(1e-3, 25, 400))
    listing = np.array([-1 / friction_listing(a, LIBRARY_GAP) for a in amplitudes])
    sparse = LIBRARY_GAP * np.array([0.51, 0.515, 0.52, 0.53, 0.545, 0.57, 0.62, 0.7, 0.9, 1.5, 5])
    theirs = np.array([-1 / library.describing_function(a) for a in sparse])
    with style():
        figure = new_figure(3.6)
        plane, sizes = figure.subplots(1, 2)
        locus(plane, evidence.numbers.displacement_only)
        curve(plane, listing, "$-1/N$, listing", LINES[1])
        plane.plot(theirs.real, theirs.imag, "s", color=BLACK, markersize=4, label="python-control")
        frame(plane, "both curves, $b$ = 0.1 mm", (-9, 3), (-20, 7))
        plane.legend(loc="upper left")
        _over_amplitude(sizes, library)
    return figure


def _over_amplitude(axes: Axes, library: control.DescribingFunctionNonlinearity) -> None:
    gaps = np.concatenate([np.linspace(0.2, 0.5, 120), np.linspace(0.5, 2, 200)[1:]])
    ours = [abs(friction_listing(a * LIBRARY_GAP, LIBRARY_GAP)) for a in gaps]
    theirs = [abs(library.describing_function(a * LIBRARY_GAP)) for a in gaps[::8]]
    axes.plot(gaps, ours, **LINES[1].keywords)
    axes.plot(gaps[::8], theirs, "s", color=BLACK, markersize=4)
    axes.axvspan(0.2, 0.5, color="#eeeeee")
    axes.annotate("shaded: inside\nof the dead band", (0.53, 1.2), fontsize=8)
    axes.set(
        xlabel="amplitude over gap",
        ylabel="$|N|$",
        title="what they return",
        xlim=(0.2, 2),
        ylim=(-0.05, 1.4),
    )


def larger_gap(evidence: Evidence) -> Figure:
    """Draw G with -1/N of friction-controlled backlash for 40 µm, and the loop in time (figure 5.10)."""
    system = evidence.numbers.displacement_only
    element = FrictionBacklash(LARGER_GAP)
    inner, outer = limit_cycles(system, element)
    with style():
        figure = new_figure(6.4)
        (whole, near), (start, settled) = figure.subplots(2, 2, height_ratios=(5, 4))
        larger_gap_over_time(start, settled, evidence)
        for axes in (whole, near):
            locus(axes, system)
            element_curve(axes, element, "$-1/N$, $b$ = 40 µm", LINES[1])
        mark(whole, system, (inner,), (_named(inner),), ((24, 8),))
        mark(near, system, (outer,), (_named(outer),), ((-7, 10),))
        frame(whole, "a: both intersections", (-9, 3), (-20, 6))
        frame(near, "a: the outer one, near $-1$", (-1.15, -0.9), (-0.16, 0.02), left=False)
        whole.legend(loc="upper left")
    return figure


def _named(cycle: LimitCycle) -> str:
    kind = "stable" if cycle.stable else "unstable"
    return f"{1e6 * cycle.amplitude:.1f} µm, {cycle.frequency:.1f} Hz\n{kind}"


def higher_harmonics(evidence: Evidence) -> Figure:
    """Draw what thickness of -1/N the thesis's band of frequencies would need (thesis, figure 5.15)."""
    system = evidence.numbers.displacement_only
    points = inverse(InertiaBacklash(1.0))
    cycle = evidence.cycles.inertia.stable
    ends = frequency_response(system, np.array(BAND))
    with style():
        figure = new_figure(3.8, 5.6)
        axes = figure.subplots()
        _thick(axes, points, float(max(np.abs(points - end).min() for end in ends)))
        locus(axes, system)
        element_curve(axes, InertiaBacklash(1.0), "$-1/N$, inertia-controlled", LINES[1])
        axes.plot(ends.real, ends.imag, "D", color=BLACK, markersize=5, label="ends of the band")
        for omega, end, side in zip(BAND, ends, ("right", "left"), strict=True):
            text = f"{omega:.0f} rad/s"
            axes.annotate(
                text, (end.real, end.imag), (0, -14), textcoords="offset points", fontsize=8, ha=side
            )
        mark(axes, system, (cycle,), (f"{cycle.omega:.0f} rad/s",), ((6, 9),))
        frame(axes, "near $-1$", *VIEW)
        axes.set_aspect("equal")
        figure.legend(loc="outside lower center", ncols=2)
    return figure


def _thick(axes: Axes, points: NDArray[np.complex128], radius: float) -> None:
    """Shade what is nearer to a curve than a radius."""
    real, imaginary = (np.linspace(*limits, 100) for limits in VIEW)
    place = real[np.newaxis, :] + 1j * imaginary[:, np.newaxis]
    distance = np.abs(place[..., np.newaxis] - points).min(axis=-1)
    axes.contourf(real, imaginary, distance, [0, radius], colors=[LINES[3].colour], alpha=0.15)
    axes.contour(real, imaginary, distance, [radius], colors=[LINES[3].colour], linestyles=[LINES[3].dashes])
    axes.plot([], [], label=f"{radius:.2f} around it, which the band needs", **LINES[3].keywords)


def viscous_contours(evidence: Evidence) -> Figure:
    """Draw viscous contours as they are and as Listing A.5 computes them (thesis, figure 5.16)."""
    system = evidence.numbers.displacement_only
    with style():
        figure = new_figure(6.4)
        grid = figure.subplots(2, 2)
        for row, title in zip(
            grid, ("right contact angle", "Listing A.5, complex contact angle"), strict=True
        ):
            _viscous_row(row, system, title)
        for axes in grid[0]:
            for gamma, line in zip(GAMMAS, LINES[2:], strict=False):
                element_curve(axes, ViscousBacklash(1.0, gamma).at(1.0), f"$\\gamma$ = {gamma}", line)
        for axes in grid[1]:
            for gamma, line in zip(GAMMAS, LINES[2:], strict=False):
                curve(axes, listing_contour(gamma), f"$\\gamma$ = {gamma}", line)
        for gamma in GAMMAS:
            inner, outer = limit_cycles(system, ViscousBacklash(1.0, gamma).at(1.0))
            mark(grid[0, 0], system, (inner,), ("",), ((1, 1),))
            mark(grid[0, 1], system, (outer,), ("",), ((1, 1),))
        handles, labels = grid[0, 0].get_legend_handles_labels()
        grid[1, 1].legend(handles, labels, loc="lower center")
    return figure


def _viscous_row(row: Sequence[Axes], system: control.TransferFunction, title: str) -> None:
    """Draw what both rows share: G and the two limits of the load, in two parts of the plane."""
    views = (((-5, 7), (-7, 1.5)), ((-1.08, -0.88), (-0.16, 0.02)))
    for axes, name, view in zip(row, (title, "the same near $-1$"), views, strict=True):
        locus(axes, system)
        element_curve(axes, FrictionBacklash(1.0), "friction", LINES[1])
        element_curve(axes, InertiaBacklash(1.0), "inertia", LINES[5])
        frame(axes, name, *view, left=axes is row[0])
