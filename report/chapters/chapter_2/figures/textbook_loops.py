"""Graphical harmonic balance on two textbook loops (thesis, figures 2.13 and 2.14).

The thesis's own pictures name neither plant nor element, so two loops are taken whose answers are known.
"""

from __future__ import annotations

from typing import TYPE_CHECKING, Final

import numpy as np

from report.drawing.read_out import Along, plot_along
from report.drawing.style import BLACK, LINES, new_figure, style
from report.drawing.ticks import few_ticks
from report.numbers.textbook_loops import STARTS, Loop, backlash_history, backlash_loop, relay_loop
from trimmer import frequency_response

if TYPE_CHECKING:
    from matplotlib.axes import Axes
    from matplotlib.figure import Figure
    from numpy.typing import NDArray

STEPS: Final = (1.15, 2.0)
"""Factors from each limit cycle's amplitude to those of the operating points beside it."""


def one_limit_cycle() -> Figure:
    """Draw a relay loop in the plane of G, and its two equations over frequency (thesis, figure 2.13)."""
    loop = relay_loop()
    (cycle,) = loop.limit_cycles()
    omega = np.geomspace(0.5, 8, 300)
    with style():
        figure = new_figure(3.3)
        plane, equations = figure.subplots(1, 2)
        _locus(plane, loop, omega)
        _element(plane, loop, np.linspace(0.001, 0.7, 200))
        meeting = complex(loop.inverse_element(cycle.amplitude))
        plane.plot([meeting.real], [meeting.imag], "o", color=BLACK, markersize=5)
        plane.annotate("$K$", (meeting.real, meeting.imag), (-13, 6), textcoords="offset points")
        plane.set(xlabel="real part", ylabel="imaginary part", xlim=(-0.55, 0.1), ylim=(-0.45, 0.25))
        plane.set_title("graphical: $G = -1/N$")
        plane.legend(loc="lower right")
        few_ticks(plane.xaxis, plane.yaxis, equations.xaxis, equations.yaxis)
        _equations(equations, loop, omega)
        equations.plot([cycle.omega], [cycle.amplitude], "o", color=BLACK, markersize=5)
        equations.annotate(
            f"$K$: $\\omega = {cycle.omega:.4f}$,\n$A = {cycle.amplitude:.4f}$",
            (cycle.omega, cycle.amplitude),
            (10, 12),
            textcoords="offset points",
        )
    return figure


def _equations(axes: Axes, loop: Loop, omega: NDArray[np.float64]) -> None:
    """Draw where the real part and where the imaginary part of 1 + N G is zero."""
    amplitude = np.linspace(0.05, 0.6, 111)
    response = frequency_response(loop.plant, omega)
    balance = 1 + np.outer(loop.element.describing_function(amplitude), response)
    for part, line in ((balance.real, LINES[2]), (balance.imag, LINES[3])):
        axes.contour(omega, amplitude, part, [0.0], colors=line.colour, linestyles=[line.dashes])
    axes.plot([], [], label="real part of $1 + NG$ is zero", **LINES[2].keywords)
    axes.plot([], [], label="imaginary part is zero", **LINES[3].keywords)
    axes.set(xlabel=r"$\omega$ [rad/s]", ylabel="amplitude $A$", xlim=(0.8, 2.2), ylim=(0.05, 0.6))
    axes.set_title("algebraic: two equations")
    axes.legend(loc="upper right", frameon=True, facecolor="white", edgecolor="none", framealpha=1.0)


def two_limit_cycles() -> Figure:
    """Draw a loop with backlash in the plane of G, and what it does over time (thesis, figure 2.14)."""
    loop = backlash_loop()
    with style():
        figure = new_figure(5.6)
        grid = figure.add_gridspec(2, 2, height_ratios=(1.4, 1))
        whole, near = (figure.add_subplot(grid[0, column]) for column in range(2))
        for index, axes, omega, amplitude in (
            (0, whole, np.geomspace(0.45, 6, 200), np.geomspace(0.55, 6, 200)),
            (1, near, np.geomspace(1.2, 2.2, 100), np.geomspace(2, 400, 200)),
        ):
            _encircled(axes, loop)
            _locus(axes, loop, omega)
            _element(axes, loop, amplitude)
            _operating_points(axes, loop, index)
            axes.plot([-1], [0], "+", color=BLACK, markersize=9, markeredgewidth=1.6)
            axes.set_xlabel("real part")
            few_ticks(axes.xaxis, axes.yaxis)
        whole.set(ylabel="imaginary part", xlim=(-3.3, 0.7), ylim=(-3.4, 0.6), title="both limit cycles")
        near.set(xlim=(-1.14, -0.86), ylim=(-0.24, 0.09), title="near the second one, $L_2$")
        whole.legend(loc="upper left", borderaxespad=0.0)
        _history(figure.add_subplot(grid[1, :]), loop)
    return figure


def _encircled(axes: Axes, loop: Loop) -> None:
    """Shade what the closed locus of G encircles."""
    response = frequency_response(loop.plant, np.geomspace(0.05, 60, 400))
    closed = np.concatenate([response, response[::-1].conj()])
    axes.fill(closed.real, closed.imag, color="#e4e4e4", linewidth=0, label="encircled by $G$")


def _operating_points(axes: Axes, loop: Loop, index: int) -> None:
    """Mark a limit cycle, and the points on -1/N at a larger and a smaller amplitude."""
    cycle = loop.limit_cycles()[index]
    name, kind = f"L_{index + 1}", "stable" if cycle.stable else "unstable"
    for factor, prime, marker in ((STEPS[index], "'", "^"), (1.0, "", "o"), (1 / STEPS[index], "''", "v")):
        point = complex(loop.inverse_element(factor * cycle.amplitude))
        axes.plot([point.real], [point.imag], marker, color=BLACK, markersize=5.5)
        text = f"${name}{prime}$" if prime else f"${name}$, {kind}"
        axes.annotate(text, (point.real, point.imag), (8, -4), textcoords="offset points")


def _history(axes: Axes, loop: Loop) -> None:
    """Draw the simulated amplitude over time, from below and above the first limit cycle, and from far up."""
    first, second = loop.limit_cycles()
    history = backlash_history()
    for factor, amplitudes, line in zip(STARTS, history.amplitudes.T, LINES, strict=False):
        label = f"started at {factor:g} $A_1$"
        axes.plot(history.times, amplitudes, label=label, marker="o", markersize=2.5, **line.keywords)
    for cycle, name in ((first, "A_1"), (second, "A_2")):
        axes.axhline(cycle.amplitude, color="#555555", linestyle=":", linewidth=1.0)
        axes.text(history.times[-1], cycle.amplitude + 0.12, f"${name}$", ha="right", va="bottom")
    axes.set(xlabel="time [s]", ylabel="amplitude in gaps", ylim=(-0.2, 8.2), title="simulated")
    axes.legend(loc="center right")
    few_ticks(axes.xaxis, axes.yaxis, intervals=8)


def _locus(axes: Axes, loop: Loop, omega: NDArray[np.float64]) -> None:
    response = frequency_response(loop.plant, omega)
    plot_along(axes, response, Along("ω", "rad/s", omega), label=r"$G(j\omega)$", **LINES[0].keywords)
    _arrows(axes, response, LINES[0].colour)


def _element(axes: Axes, loop: Loop, amplitude: NDArray[np.float64]) -> None:
    inverse = loop.inverse_element(amplitude)
    plot_along(axes, inverse, Along("A", "", amplitude), label="$-1/N(A)$", **LINES[1].keywords)
    _arrows(axes, inverse, LINES[1].colour)


def _arrows(axes: Axes, curve: NDArray[np.complex128], colour: str) -> None:
    """Put arrows of rising parameter on a curve, each a sixth of its samples after the one before."""
    for place in range(len(curve) // 12, len(curve) - 2, len(curve) // 6):
        start, end = curve[place], curve[place + 2]
        axes.annotate(
            "",
            (end.real, end.imag),
            (start.real, start.imag),
            arrowprops={"arrowstyle": "-|>", "color": colour, "mutation_scale": 12},
            annotation_clip=True,
        )
