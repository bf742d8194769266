"""The explorable of the thesis's trimmer: its sliders, its panels, its formulas, and a picture for print."""

import math
from functools import partial
from typing import Final

import numpy as np
from matplotlib.axes import Axes
from matplotlib.figure import Figure as Canvas

from report.document.extras import Explorable
from report.explorable.formulas import functions
from report.explorable.script import script
from report.judging.text import one_line
from report.numbers.evidence import Evidence
from report.numbers.linear_numbers import exact_values
from report.pages.drawing.drawn import drawn
from report.pages.drawing.plane import OMEGA, critical_point, inverse
from report.pages.drawing.style import BLACK, LINES, panels
from report.pages.explorable import Panel, Slider
from report.pages.figure import Figure
from trimmer import LimitCycle, ViscousBacklash, limit_cycles, response_at

GAP: Final = 2e-4  # Gap of the first view and of the picture, m: that of the driven simulations of the thesis
TIME_CONSTANT: Final = 1e-3  # M/D of the first view and of the picture, s
ELEMENT: Final = ViscousBacklash(GAP, TIME_CONSTANT)
WHOLE: Final = (-9.0, 9.0, -17.0, 2.0)
NEAR: Final = (-1.6, 0.2, -0.6, 0.3)
THINNED: Final = 4  # Of so many points of a curve one is drawn: the picture is small
PERIOD: Final = (0.0, 2 * math.pi, -1.25, 1.25)


def explorable(known: Evidence) -> Explorable:
    """Return everything that the explorable shows."""
    parameters = known.numbers.parameters
    printed = script(functions(known.derivation, exact_values(parameters)))
    return Explorable(printed, _sliders(parameters.c2), _panels(), _still(known))


def _sliders(damping: float) -> tuple[Slider, ...]:
    """Return what can be moved; the damping is c2 of the thesis's trimmer, N s/m."""
    return (
        Slider("gap", "Gap g, the total clearance", -6.0, -3.0, math.log10(GAP), True, 1e6, "µm"),
        Slider("load", "Load behind the play, M/D", -6.0, -1.0, math.log10(TIME_CONSTANT), True, 1e3, "ms"),
        Slider("damping", "Damping c₂ of the driving bridge", 0.0, 4 * damping, damping, False, 1.0, "N s/m"),
        Slider("force", "Dry friction between cutter and guard", 0.0, 2.0, 0.0, False, 1.0, "N"),
        Slider("share", "Share of the pin’s velocity (0: thesis)", 0.0, 1.0, 0.0, False, 100.0, "%"),
    )


def _panels() -> tuple[Panel, ...]:
    curves = "Locus of G, contour of minus one over N, and their intersections"
    return (
        Panel(f"{curves}; the cross is −1.", WHOLE, f"{curves}, in the complex plane"),
        Panel("The same near −1.", NEAR, f"{curves}, near minus one"),
        Panel(
            "Pin (dotted) and load (solid) over one period, over A; phase in rad.",
            PERIOD,
            "Position of pin and load over one period",
        ),
    )


def picture(known: Evidence) -> Canvas:
    """Draw the planes and the motion of the first view."""
    cycles = _cycles(known)
    stable = _stable(cycles)
    figure, (whole, near, motion) = panels(2.5, columns=3)
    for axes, limits in ((whole, WHOLE), (near, NEAR)):
        _plane(axes, known, stable, cycles)
        axes.set(xlim=limits[:2], ylim=limits[2:], xlabel="real part")
    whole.set_ylabel("imaginary part")
    _motion(motion, stable)
    return figure


def _cycles(known: Evidence) -> tuple[LimitCycle, ...]:
    return limit_cycles(known.numbers.displacement_only, ELEMENT)


def _stable(cycles: tuple[LimitCycle, ...]) -> LimitCycle:
    return next(cycle for cycle in cycles if cycle.stable)


def _still(known: Evidence) -> Figure:
    frequency = _stable(_cycles(known)).frequency
    words = one_line(
        """Three panels: the locus of G with the contour of -1/N and their intersections, the same near -1,
        and the position of pin and load over one period."""
    )
    caption = one_line(f"""
        What the page shows for a gap of {1e6 * GAP:.0f} µm, $M/D$ = {1e3 * TIME_CONSTANT:.0f} ms, no friction
        and the pin's displacement alone: the locus of $G$ (solid), the contour of $-1/N$ (dashed) at the
        frequency of the stable limit cycle, {frequency:.2f} Hz; the same near $-1$; pin (dotted) and
        load (solid) over one period. In the HTML report sliders move all of it.
    """)
    return drawn(
        "explorable-still",
        "Limit cycle of the thesis's loop, as the sliders begin",
        caption,
        words,
        partial(picture, known),
    )


def _plane(axes: Axes, known: Evidence, stable: LimitCycle, cycles: tuple[LimitCycle, ...]) -> None:
    system = known.numbers.displacement_only
    response, contour = response_at(system, OMEGA[::THINNED]), inverse(ELEMENT.at(stable.omega))[::THINNED]
    axes.plot(response.real, response.imag, **LINES[0])
    axes.plot(contour.real, contour.imag, **LINES[1])
    critical_point(axes)
    for cycle in cycles:
        place = complex(response_at(system, cycle.omega))
        face = BLACK if cycle.stable else "white"
        axes.plot(place.real, place.imag, "o", color=BLACK, markerfacecolor=face, markersize=5)


def _motion(axes: Axes, stable: LimitCycle) -> None:
    phases = np.linspace(0, 2 * np.pi, 401)
    load = ELEMENT.waveform(phases, stable.amplitude, stable.omega) / stable.amplitude
    axes.plot(phases, np.sin(phases), color=BLACK, linestyle=":")
    axes.plot(phases, load, **LINES[0])
    axes.set(xlabel="phase, rad", ylabel="position over $A$", xlim=PERIOD[:2])
