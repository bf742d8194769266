"""Graphical harmonic balance on two textbook loops (figures 2.13 and 2.14).

The thesis's own pictures name neither plant nor element, so two loops are taken whose answers are known.
"""

from typing import Final

import numpy as np
from matplotlib.axes import Axes
from matplotlib.figure import Figure

from report.data.figures import figure
from report.numbers.evidence import Evidence
from report.numbers.textbook_loops import STARTS, TextbookLoop, backlash_history, backlash_loop, relay_loop
from report.pages.drawing.marks import arrow, beside, few_ticks, limit_cycle
from report.pages.drawing.plane import critical_point
from report.pages.drawing.read_out import Along, plot_along
from report.pages.drawing.style import BLACK, FAINT, LINES, Look, new_figure, panels
from trimmer import response_at
from trimmer.arrays import Complexes, Reals

STEPS: Final = (1.15, 2.0)
"""Factors from each limit cycle's amplitude to those of the operating points beside it."""


@figure("fig-2.13")
def one_limit_cycle(_: Evidence) -> Figure:
    loop = relay_loop()
    (cycle,) = loop.limit_cycles()
    omega, amplitude = np.geomspace(0.5, 8, 300), np.linspace(0.05, 0.6, 111)
    figure, (plane, equations) = panels(3.3, 1, 2)
    _both(plane, loop, omega, np.linspace(0.001, 0.7, 200))
    meeting = complex(loop.inverse_element(cycle.amplitude))
    limit_cycle(plane, meeting, stable=cycle.stable)
    beside(plane, "$K$", meeting, (-13, 6))
    plane.set(xlabel="real part", ylabel="imaginary part", xlim=(-0.55, 0.1), ylim=(-0.45, 0.25))
    plane.set_title("graphical: $G = -1/N$")
    plane.legend(loc="lower right")
    few_ticks(plane.xaxis, plane.yaxis, equations.xaxis, equations.yaxis)
    gain = loop.element.describing_function(amplitude)
    balance = 1 + np.outer(gain, response_at(loop.plant, omega))
    for part, line in ((balance.real, LINES[2]), (balance.imag, LINES[3])):
        equations.contour(omega, amplitude, part, [0.0], colors=line["color"], linestyles=[line["linestyle"]])
    equations.plot([], [], label="real part of $1 + NG$ is zero", **LINES[2])
    equations.plot([], [], label="imaginary part is zero", **LINES[3])
    equations.set(xlabel=r"$\omega$ [rad/s]", ylabel="amplitude $A$", xlim=(0.8, 2.2), ylim=(0.05, 0.6))
    equations.set_title("algebraic: two equations")
    equations.legend(loc="upper right", frameon=True, facecolor="white", edgecolor="none", framealpha=1.0)
    limit_cycle(equations, (cycle.omega, cycle.amplitude), stable=cycle.stable)
    name = f"$K$: $\\omega = {cycle.omega:.4f}$,\n$A = {cycle.amplitude:.4f}$"
    beside(equations, name, (cycle.omega, cycle.amplitude), (10, 12))
    return figure


@figure("fig-2.14")
def two_limit_cycles(_: Evidence) -> Figure:
    loop = backlash_loop()
    figure = new_figure(5.6)
    whole, near, motion = figure.subplot_mosaic([[0, 1], [2, 2]], height_ratios=(1.4, 1)).values()
    for index, axes, omega, amplitude in (
        (0, whole, np.geomspace(0.45, 6, 200), np.geomspace(0.55, 6, 200)),
        (1, near, np.geomspace(1.2, 2.2, 100), np.geomspace(2, 400, 200)),
    ):
        response = response_at(loop.plant, np.geomspace(0.05, 60, 400))
        closed = np.concatenate([response, response[::-1].conj()])
        axes.fill(closed.real, closed.imag, color="#e4e4e4", linewidth=0, label="encircled by $G$")
        _both(axes, loop, omega, amplitude)
        _operating_points(axes, loop, index)
        critical_point(axes)
        axes.set_xlabel("real part")
        few_ticks(axes.xaxis, axes.yaxis)
    whole.set(ylabel="imaginary part", xlim=(-3.3, 0.7), ylim=(-3.4, 0.6), title="both limit cycles")
    near.set(xlim=(-1.14, -0.86), ylim=(-0.24, 0.09), title="near the second one, $L_2$")
    whole.legend(loc="upper left", borderaxespad=0.0)
    history = backlash_history()
    for factor, amplitudes, line in zip(STARTS, history.amplitudes.T, LINES, strict=False):
        label = f"started at {factor:g} $A_1$"
        motion.plot(history.times, amplitudes, label=label, marker="o", markersize=2.5, **line)
    for cycle, name in zip(loop.limit_cycles(), ("$A_1$", "$A_2$"), strict=True):
        motion.axhline(cycle.amplitude, **FAINT)
        motion.text(history.times[-1], cycle.amplitude + 0.12, name, ha="right", va="bottom")
    motion.set(xlabel="time [s]", ylabel="amplitude in gaps", ylim=(-0.2, 8.2), title="simulated")
    motion.legend(loc="center right")
    few_ticks(motion.xaxis, motion.yaxis, intervals=8)
    return figure


def _operating_points(axes: Axes, loop: TextbookLoop, index: int) -> None:
    """Mark a limit cycle, and the points on -1/N at a larger and a smaller amplitude."""
    cycle = loop.limit_cycles()[index]
    name, kind = f"L_{index + 1}", "stable" if cycle.stable else "unstable"
    for factor, text, marker in (
        (STEPS[index], f"${name}'$", "^"),
        (1.0, f"${name}$, {kind}", ""),
        (1 / STEPS[index], f"${name}''$", "v"),
    ):
        point = complex(loop.inverse_element(factor * cycle.amplitude))
        if marker:
            axes.plot([point.real], [point.imag], marker, color=BLACK, markersize=5.5)
        else:
            limit_cycle(axes, point, stable=cycle.stable)
        beside(axes, text, point, (8, -4))


def _both(axes: Axes, loop: TextbookLoop, omega: Reals, amplitude: Reals) -> None:
    """Draw G for rising frequency and -1/N for rising amplitude."""
    response, inverse = response_at(loop.plant, omega), loop.inverse_element(amplitude)
    _directed(axes, response, Along("ω", "rad/s", omega), r"$G(j\omega)$", LINES[0])
    _directed(axes, inverse, Along("A", "", amplitude), "$-1/N(A)$", LINES[1])


def _directed(axes: Axes, curve: Complexes, along: Along, label: str, line: Look) -> None:
    """Draw a curve with arrows of rising parameter, each a sixth of its samples after the one before."""
    plot_along(axes, curve, along, label=label, **line)
    for place in range(len(curve) // 12, len(curve) - 2, len(curve) // 6):
        arrow(axes, curve[place], curve[place + 2], color=line["color"], mutation_scale=12)
