"""The blocks of backlash under a sine (figures 4.1 to 4.3)."""

import numpy as np
from matplotlib.figure import Figure

from report.data.figures import figure
from report.numbers import listed_blocks as blocks
from report.numbers.evidence import Evidence
from report.numbers.thesis import DRIVE_AMPLITUDE, DRIVE_OMEGA, TIMED_GAP
from report.pages.drawing.style import BLACK, LINES, panels

EVERY = 67  # Samples between the markers of the second block
TIMES = 1e3 * blocks.phases() / DRIVE_OMEGA  # Instants of the samples, ms
INPUT = 1e3 * DRIVE_AMPLITUDE * np.sin(blocks.phases())  # Displacement of the pin, mm


@figure("fig-4.1")
def two_friction_blocks(_: Evidence) -> Figure:
    built_in, own = blocks.built_in_block(), blocks.own_block()
    figure, (outputs, difference) = panels(3.8, 2, sharex=True, height_ratios=(2.4, 1))
    outputs.plot(TIMES, INPUT, label="input", **LINES[1])
    outputs.plot(TIMES, 1e3 * built_in, label="python-control's block", **LINES[0])
    look = {"color": BLACK, "markersize": 4, "fillstyle": "none", "label": "Listing A.7"}
    outputs.plot(TIMES[::EVERY], 1e3 * own[::EVERY], "o", **look)
    outputs.set(ylabel="displacement [mm]", ylim=(-1.7, 2.3))
    outputs.legend(loc="upper right", ncols=3)
    difference.plot(TIMES, 1e9 * (own - built_in), **LINES[2])
    difference.set(xlabel="time [ms]", ylabel="difference [nm]", xlim=(0, TIMES[-1]), ylim=(-1, 1))
    return figure


@figure("fig-4.2")
def inertia_block_over_time(_: Evidence) -> Figure:
    output, exact = blocks.listing_a8(), blocks.exact_inertia(TIMED_GAP)
    figure, (waves, difference) = panels(3.8, 2, sharex=True, height_ratios=(2.4, 1))
    waves.plot(TIMES, INPUT, label="input", **LINES[1])
    waves.plot(TIMES, 1e3 * output, label="output of Listing A.8", **LINES[0])
    waves.set(ylabel="displacement [mm]", ylim=(-1.9, 2.5))
    waves.legend(loc="upper right", ncols=2)
    difference.plot(TIMES, 1e6 * (output - exact), **LINES[2])
    difference.set(xlabel="time [ms]", ylabel="off by [µm]", xlim=(0, TIMES[-1]), ylim=(-15, 5))
    return figure


@figure("fig-4.3")
def inertia_waveforms(_: Evidence) -> Figure:
    figure, axes = panels(3.4)
    for gap, line in zip(blocks.GAPS, LINES, strict=False):
        label = f"$b$ = {1e3 * gap:g} mm" if gap else "$b$ = 0, the input"
        axes.plot(TIMES, 1e3 * blocks.exact_inertia(gap), label=label, **line)
    axes.set(xlabel="time [ms]", ylabel="displacement [mm]", xlim=(0, TIMES[-1]), ylim=(-2.6, 4.0))
    axes.legend(loc="upper right", ncols=3)
    return figure
