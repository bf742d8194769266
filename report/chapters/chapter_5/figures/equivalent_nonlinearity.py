"""G with -1/N of backlash and friction together: figures 5.21 to 5.24 of the thesis, drawn again."""

from __future__ import annotations

from typing import TYPE_CHECKING, Final

import numpy as np

from report.chapters.chapter_5.figures.closed_loop_motion import released_spectrum
from report.drawing.plane import curve, element_curve, frame, locus, mark
from report.drawing.style import LINES, new_figure, style
from report.evidence import Evidence
from report.numbers.equivalent_nonlinearity import (
    FORCE,
    FORCES,
    GAP,
    OMEGA,
    OTHER_FORCE,
    OTHER_GAP,
    listing_element,
    printed_function,
    right_element,
)
from report.numbers.friction_in_place import FrictionBranch
from trimmer.elements.friction_backlash import FrictionBacklash

if TYPE_CHECKING:
    from matplotlib.axes import Axes
    from matplotlib.figure import Figure

    from trimmer.elements.element import Element

PANEL_OMEGAS: Final = (30.0, OMEGA, 6000.0)
PANEL_FORCES: Final = (0.03, OTHER_FORCE, 0.6)
PANEL_GAPS: Final = (5e-4, OTHER_GAP, 1e-2)
LOADS: Final = (0.15, 0.25, 0.5)
"""F_c/(k2 b) of the right contours: friction ends the limit cycles at 0.27."""


def three_panels(evidence: Evidence) -> Figure:
    """Draw contours of Listing A.6 over ω, F_c and b, and the right ones (thesis, figure 5.21)."""
    k2 = evidence.numbers.parameters.k2
    families: tuple[tuple[str, list[tuple[str, Element]]], ...] = (
        (
            "a: Listing A.6, change in $\\omega$",
            [(f"{w:.0f} rad/s", listing_element(OTHER_FORCE, OTHER_GAP, w)) for w in PANEL_OMEGAS],
        ),
        (
            "b: Listing A.6, change in $F_c$",
            [(f"{force:g} N", listing_element(force, OTHER_GAP)) for force in PANEL_FORCES],
        ),
        (
            "c: Listing A.6, change in $b$",
            [(f"{1e3 * gap:g} mm", listing_element(OTHER_FORCE, gap)) for gap in PANEL_GAPS],
        ),
        (
            "right term, change in $F_c/(k_2 b)$",
            [(f"{load:g}", right_element(load * k2, k2, 1.0)) for load in LOADS],
        ),
    )
    with style():
        figure = new_figure(6.4)
        for place, (axes, (title, family)) in enumerate(
            zip(figure.subplots(2, 2).flat, families, strict=True)
        ):
            locus(axes, evidence.numbers.displacement_only)
            element_curve(axes, FrictionBacklash(1.0), "no friction", LINES[5])
            for line, (name, element) in zip((LINES[1], LINES[2], LINES[3]), family, strict=True):
                element_curve(axes, element, name, line)
            frame(axes, title, (-6, 3), (-9, 9), left=place % 2 == 0)
            axes.legend(loc="upper left", ncols=2)
    return figure


def without_force(evidence: Evidence) -> Figure:
    """Draw Listing A.6 and equation 5.14 for F_c = 0 (thesis, figure 5.22)."""
    friction = evidence.cycles.friction
    amplitudes = GAP + np.geomspace(1e-9, 40, 500)
    printed = np.array([-1 / printed_function(float(a), 0.0) for a in amplitudes])
    with style():
        figure = new_figure(3.6)
        whole, near = figure.subplots(1, 2)
        for axes in (whole, near):
            locus(axes, evidence.numbers.displacement_only)
            element_curve(axes, FrictionBacklash(GAP), "$-1/N$, Listing A.6", LINES[1])
            curve(axes, printed, "$-1/N$, equation 5.14", LINES[2])
            mark(
                axes,
                evidence.numbers.displacement_only,
                (friction.unstable, friction.stable),
                tuple(
                    f"{1e6 * GAP * each.amplitude:.2f} µm" for each in (friction.unstable, friction.stable)
                ),
                ((9, 6), (7, -14)),
            )
        frame(whole, "$b$ = 4 µm, $F_c$ = 0", (-9, 3), (-20, 8))
        frame(near, "near $-1$", (-1.15, -0.9), (-0.16, 0.02), left=False)
        whole.legend(loc="upper left")
    return figure


def one_force(evidence: Evidence) -> Figure:
    """Draw Listing A.6 and the right function at 0.6 N, and the loop's peaks (thesis, figure 5.23)."""
    numbers, system = evidence.cycles.equivalent, evidence.numbers.displacement_only
    right = right_element(FORCE, evidence.numbers.parameters.k2)
    (cycle,) = numbers.listing
    with style():
        figure = new_figure(6.2)
        grid = figure.add_gridspec(2, 2, height_ratios=(5, 4))
        whole, near = (figure.add_subplot(grid[0, column]) for column in range(2))
        released_spectrum(figure.add_subplot(grid[1, :]), evidence)
        for axes in (whole, near):
            locus(axes, system)
            element_curve(axes, listing_element(FORCE), "$-1/N$, Listing A.6", LINES[1])
            element_curve(axes, right, "$-1/N$, right term over $k_2$", LINES[2])
        text = f"{cycle.frequency:.2f} Hz\n{1e3 * cycle.amplitude:.1f} mm"
        mark(near, system, (cycle,), (text,), ((9, -24),))
        frame(whole, f"a: $b$ = 4 µm, $F_c$ = {FORCE} N", (-2, 1), (-1.5, 2.2))
        frame(near, "a: near $-1$", (-1.1, -0.9), (-0.13, 0.05), left=False)
        whole.legend(loc="upper left")
    return figure


def several_forces(evidence: Evidence) -> Figure:
    """Draw Listing A.6 for several forces, and what friction in its place does (thesis, figure 5.24)."""
    numbers, system = evidence.cycles.equivalent, evidence.numbers.displacement_only
    with style():
        figure = new_figure(3.8)
        near, branch = figure.subplots(1, 2)
        locus(near, system)
        element_curve(near, FrictionBacklash(GAP), "no friction", LINES[5])
        for force, line in zip(FORCES, LINES[1:], strict=False):
            element_curve(near, listing_element(force), f"{force:g} N", line)
        mark(near, system, numbers.by_force, [""] * len(FORCES), [(1, 1)] * len(FORCES))
        frame(near, "Listing A.6, $b$ = 4 µm", (-1.06, -0.94), (-0.16, 0.06))
        near.legend(loc="upper right", ncols=2)
        _branches(branch, numbers.in_place, numbers.in_place_both_channels)
    return figure


def _branches(axes: Axes, thesis: FrictionBranch, both: FrictionBranch) -> None:
    """Draw amplitude over force for friction between cutter and guard."""
    rows = ((thesis, "thesis's loop", LINES[0]), (both, "both channels of the pin", LINES[2]))
    for branch, name, line in rows:
        axes.plot(branch.stable.force_per_gap / 1e3, branch.stable.amplitude, label=name, **line.keywords)
        axes.plot(
            branch.unstable.force_per_gap / 1e3,
            branch.unstable.amplitude,
            color=line.colour,
            linestyle=":",
        )
        axes.plot([branch.merger.force_per_gap / 1e3], [branch.merger.amplitude], "ko", markersize=5)
    axes.plot([], [], color="black", linestyle=":", label="unstable")
    axes.set(
        title="friction between cutter and guard",
        xlabel="$F_c/b$ [kN/m]",
        ylabel="amplitude over gap",
        xlim=(0, 9),
        ylim=(0, 9),
    )
    axes.legend(loc="upper right")
