"""Output over input: backlash and Coulomb friction (thesis, figures 2.8 and 2.12), drawn again."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any, Final

import numpy as np

from report.drawing.style import LINES, new_figure, style
from report.drawing.ticks import few_ticks
from trimmer.elements.coulomb_friction import CoulombFriction
from trimmer.elements.friction_backlash import FrictionBacklash

if TYPE_CHECKING:
    from matplotlib.axes import Axes
    from matplotlib.figure import Figure

AMPLITUDES: Final = (2.0, 3.5)
"""Amplitudes of the two loops of figure 2.8, in half gaps b."""
_ARROW: Final[dict[str, Any]] = {"arrowstyle": "-|>", "color": "black", "mutation_scale": 11}
_SPAN: Final[dict[str, Any]] = {"arrowstyle": "<->", "shrinkA": 0, "shrinkB": 0}


def backlash_characteristic() -> Figure:
    """Draw the first rise from rest and the closed path, for two amplitudes (thesis, figure 2.8)."""
    phases = np.linspace(0, 2 * np.pi, 721)
    small, large = AMPLITUDES
    with style():
        figure = new_figure(4.4, 5.6)
        axes = figure.subplots()
        for amplitude, line in ((large, 0), (small, 1)):
            path = FrictionBacklash(2.0).waveform(phases, amplitude)
            axes.plot(
                amplitude * np.sin(phases), path, label=f"$A = {amplitude:g}\\,b$", **LINES[line].keywords
            )
        axes.plot([0, 1, large], [0, 0, large - 1], label="first rise, $OAB$", **LINES[3].keywords)
        _corners(axes, large)
        _spans(axes, large)
        axes.set(xlabel="input, $x/b$", ylabel="output, $y/b$", xlim=(-4.2, 4.6), ylim=(-3.2, 3.5))
        axes.set_aspect("equal")
        few_ticks(axes.xaxis, axes.yaxis, intervals=8)
        axes.legend(loc="upper left")
    return figure


def _corners(axes: Axes, amplitude: float) -> None:
    """Name the points of the path and put arrows of rising time on it."""
    top, back = amplitude - 1, amplitude - 2
    points = {
        "O": ((0.0, 0.0), (-12, 4)),
        "A": ((1.0, 0.0), (3, -13)),
        "B": ((amplitude, top), (5, 2)),
        "C": ((back, top), (-12, 4)),
        "D": ((-amplitude, -top), (-14, -8)),
        "E": ((-back, -top), (4, -13)),
    }
    for letter, (place, beside) in points.items():
        axes.plot(*place, "o", color="black", markersize=3.5)
        axes.annotate(f"${letter}$", place, beside, textcoords="offset points")
    middle = ((2.6, top), (0.0, 1.0), (-2.6, -top), (0.4, -0.6))
    steps = ((-0.15, 0.0), (-0.1, -0.1), (0.15, 0.0), (0.1, 0.1))
    for (x, y), (dx, dy) in zip(middle, steps, strict=True):
        axes.annotate("", (x + dx, y + dy), (x, y), arrowprops=_ARROW)


def _spans(axes: Axes, amplitude: float) -> None:
    """Show the width 2b and the height A - b."""
    top = amplitude - 1
    axes.annotate("", (amplitude - 2, top + 0.3), (amplitude, top + 0.3), arrowprops=_SPAN)
    axes.text(amplitude - 1, top + 0.35, "$2b$", ha="center", va="bottom")
    axes.annotate("", (amplitude + 0.35, 0), (amplitude + 0.35, top), arrowprops=_SPAN)
    axes.text(amplitude + 0.4, top / 2, "$A - b$", ha="left", va="center")


def coulomb_friction() -> Figure:
    """Draw friction over velocity, over displacement and over time (thesis, figure 2.12)."""
    phases = np.linspace(0, 2 * np.pi, 721)
    force = CoulombFriction(1.0).waveform(phases, 1.0)
    with style():
        figure = new_figure(2.7)
        by_velocity, by_displacement, by_time = figure.subplots(1, 3, sharey=True)
        for side in (-1.0, 1.0):
            by_velocity.plot([0, side], [side, side], **LINES[0].keywords)
        by_velocity.plot([0, 0], [-1, 1], color=LINES[0].colour, linestyle=":")
        by_displacement.plot([-1, 1, 1, -1, -1], [1, 1, -1, -1, 1], **LINES[0].keywords)
        for start, end in (((-0.1, 1.0), (0.2, 1.0)), ((0.1, -1.0), (-0.2, -1.0))):
            by_displacement.annotate("", end, start, arrowprops=_ARROW)
        by_time.plot(phases, np.sin(phases), label="displacement$/A$", **LINES[2].keywords)
        by_time.plot(phases, np.cos(phases), label=r"velocity$/(\omega A)$", **LINES[1].keywords)
        by_time.plot(phases, force, label="force$/F_c$", **LINES[0].keywords)
        _friction_axes(by_velocity, by_displacement, by_time)
        figure.legend(*by_time.get_legend_handles_labels(), loc="outside lower center", ncols=3)
    return figure


def _friction_axes(by_velocity: Axes, by_displacement: Axes, by_time: Axes) -> None:
    by_velocity.set(title="velocity: a relay", ylabel="force, $F/F_c$")
    by_velocity.set_xlabel(r"velocity, $\dot x/(\omega A)$")
    by_displacement.set(title="displacement: a loop", xlabel="displacement, $x/A$")
    by_time.set(title="over a period", xlabel=r"phase, $\omega t$", ylim=(-1.3, 1.3))
    few_ticks(by_velocity.xaxis, by_velocity.yaxis, by_displacement.xaxis)
    quarters = np.pi / 2 * np.arange(5)
    by_time.set_xticks(quarters, ("$0$", r"$\pi/2$", r"$\pi$", r"$3\pi/2$", r"$2\pi$"))
