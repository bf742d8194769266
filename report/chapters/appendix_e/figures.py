"""The closed loop released without drive, and the open loop for very different drives (figures E.1, E.2)."""

from typing import Final

import numpy as np
from matplotlib.figure import Figure

from report.data.figures import figure
from report.numbers.evidence import Evidence
from report.numbers.thesis import LARGE_GAP, TURN
from report.pages.drawing.style import LINES, panels

LAST: Final = 0.006  # Time that is shown of the settled motions, s


@figure("fig-E.1")
def closed_loop_for_four_gaps(known: Evidence) -> Figure:
    runs = known.motion.released.appendix
    figure, (lengths, gaps) = panels(3.6, 1, 2)
    for run, line in zip(runs, LINES, strict=False):
        shown = run.times > run.times[-1] - LAST
        times = 1e3 * (run.times[shown] - run.times[shown][0])
        motion = f"{1e3 * run.amplitude:.3f} mm, {run.frequency:.2f} Hz"
        lengths.plot(times, 1e3 * run.output[shown], label=f"$b$ = {1e3 * run.gap:g} mm: {motion}", **line)
        gaps.plot(times, run.output[shown] / run.gap, **line)
    for axes in (lengths, gaps):
        axes.set(xlabel="time [ms]", xlim=(0, 1e3 * LAST))
    lengths.set(title="in millimetres", ylabel="$q_2 - q_4$ [mm]", ylim=(-5.8, 5.8))
    gaps.set(title="in gaps", ylabel="$(q_2 - q_4)/b$")
    figure.legend(loc="outside lower center", ncols=2)
    return figure


@figure("fig-E.2")
def drive_amplitudes(known: Evidence) -> Figure:
    runs = known.motion.drive_amplitudes
    figure, grid = panels(5.4, 3, 2, sharex=True)
    *single, ripples = grid.flat
    for axes, run in zip(single, runs, strict=True):
        axes.plot(run.phases / TURN, np.sin(run.phases), label="input", **LINES[1])
        axes.plot(run.phases / TURN, run.output / run.amplitude, label="output", **LINES[0])
        axes.set(title=f"$A$ = {_length(run.amplitude)}", ylabel="displacement$/A$")
        axes.set(xlim=(0, 2), ylim=(-1.3, 1.9))
    for run, line in zip(runs[1:], LINES[2:], strict=False):
        lines = np.fft.rfft(run.output)
        lines[2] = 0.0  # two periods: the first harmonic
        ripple = 1e6 * np.fft.irfft(lines, run.output.size)
        ripples.plot(run.phases / TURN, ripple, label=_length(run.amplitude), **line)
    ripples.set(title="output without first harmonic", ylabel="[µm]", ylim=(-45, 100))
    ripples.legend(loc="upper right", ncols=2)
    for axes in grid[-1]:
        axes.set_xlabel("phase of the pin [turns]")
    single[0].legend(loc="upper right", ncols=2)
    return figure


def _length(metres: float) -> str:
    return f"{1e6 * metres:g} µm" if metres < LARGE_GAP else f"{1e3 * metres:g} mm"
