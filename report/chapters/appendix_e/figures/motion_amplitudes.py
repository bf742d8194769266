"""The open loop for drives of very different amplitude (thesis, figure E.2), drawn again."""

from __future__ import annotations

import math
from typing import TYPE_CHECKING

import numpy as np

from report.drawing.style import LINES, new_figure, style
from report.evidence import Evidence
from report.numbers.drive_amplitudes import GAP, AmplitudeRun

if TYPE_CHECKING:
    from matplotlib.axes import Axes
    from matplotlib.figure import Figure
    from numpy.typing import NDArray


def drive_amplitudes(evidence: Evidence) -> Figure:
    """Draw input and output for five amplitudes of the drive, and their ripples (thesis, figure E.2)."""
    runs = evidence.motion.drive_amplitudes
    with style():
        figure = new_figure(5.4)
        grid = figure.subplots(3, 2, sharex=True)
        for axes, run in zip(grid.flat, runs, strict=False):
            _input_and_output(axes, run)
        _ripples(grid[2, 1], runs[1:])
        for axes in grid[-1]:
            axes.set_xlabel("phase of the pin [turns]")
        grid[0, 0].legend(loc="upper right", ncols=2)
    return figure


def _turns(run: AmplitudeRun) -> NDArray[np.float64]:
    return run.phases / (2 * math.pi)


def _length(metres: float) -> str:
    return f"{1e6 * metres:g} µm" if metres < GAP else f"{1e3 * metres:g} mm"


def _input_and_output(axes: Axes, run: AmplitudeRun) -> None:
    """Draw input and output over the amplitude of the input."""
    axes.plot(_turns(run), np.sin(run.phases), label="input", **LINES[1].keywords)
    axes.plot(_turns(run), run.output / run.amplitude, label="output", **LINES[0].keywords)
    axes.set(title=f"$A$ = {_length(run.amplitude)}", xlim=(0, 2), ylim=(-1.3, 1.9))
    axes.set_ylabel("displacement$/A$")


def _ripples(axes: Axes, runs: tuple[AmplitudeRun, ...]) -> None:
    """Draw the outputs without their first harmonic."""
    for run, line in zip(runs, LINES[2:], strict=False):
        lines = np.fft.rfft(run.output)
        lines[2] = 0.0  # two periods: the first harmonic
        ripple = 1e6 * np.fft.irfft(lines, run.output.size)
        axes.plot(_turns(run), ripple, label=_length(run.amplitude), **line.keywords)
    axes.set(title="output without first harmonic", ylabel="[µm]", ylim=(-45, 100))
    axes.legend(loc="upper right", ncols=2)
