"""The blocks of backlash under a sine (thesis, figures 4.1 to 4.3), drawn again."""

from __future__ import annotations

from typing import TYPE_CHECKING

import numpy as np

from report.chapters.chapter_4.claims import (
    GAPS,
    built_in_block,
    exact_inertia,
    listing_a8,
    own_block,
    phases,
)
from report.drawing.style import LINES, new_figure, style
from report.numbers.independent.listed_blocks import DRIVE_GAP
from report.thesis import DRIVE_AMPLITUDE, DRIVE_OMEGA

if TYPE_CHECKING:
    from matplotlib.figure import Figure

EVERY = 67
"""Samples between the markers of the second block."""


def two_friction_blocks() -> Figure:
    """Draw the outputs of the built-in and the own block, and their difference (thesis, figure 4.1)."""
    times, built_in, own = 1e3 * phases() / DRIVE_OMEGA, built_in_block(), own_block()
    with style():
        figure = new_figure(3.8)
        outputs, difference = figure.subplots(2, 1, sharex=True, height_ratios=(2.4, 1))
        outputs.plot(times, 1e3 * DRIVE_AMPLITUDE * np.sin(phases()), label="input", **LINES[1].keywords)
        outputs.plot(times, 1e3 * built_in, label="python-control's block", **LINES[0].keywords)
        outputs.plot(
            times[::EVERY],
            1e3 * own[::EVERY],
            "o",
            color="black",
            markersize=4,
            fillstyle="none",
            label="Listing A.7",
        )
        outputs.set(ylabel="displacement [mm]", ylim=(-1.7, 2.3))
        outputs.legend(loc="upper right", ncols=3)
        difference.plot(times, 1e9 * (own - built_in), **LINES[2].keywords)
        difference.set(xlabel="time [ms]", ylabel="difference [nm]", xlim=(0, times[-1]), ylim=(-1, 1))
    return figure


def inertia_block_over_time() -> Figure:
    """Draw input and output of Listing A.8, and its distance from the exact waveform (thesis, figure 4.2)."""
    times, output, exact = 1e3 * phases() / DRIVE_OMEGA, listing_a8(), exact_inertia(DRIVE_GAP)
    with style():
        figure = new_figure(3.8)
        waves, difference = figure.subplots(2, 1, sharex=True, height_ratios=(2.4, 1))
        waves.plot(times, 1e3 * DRIVE_AMPLITUDE * np.sin(phases()), label="input", **LINES[1].keywords)
        waves.plot(times, 1e3 * output, label="output of Listing A.8", **LINES[0].keywords)
        waves.set(ylabel="displacement [mm]", ylim=(-1.9, 2.5))
        waves.legend(loc="upper right", ncols=2)
        difference.plot(times, 1e6 * (output - exact), **LINES[2].keywords)
        difference.set(xlabel="time [ms]", ylabel="off by [µm]", xlim=(0, times[-1]), ylim=(-15, 5))
    return figure


def inertia_waveforms() -> Figure:
    """Draw the exact waveform for several gaps (thesis, figure 4.3)."""
    times = 1e3 * phases() / DRIVE_OMEGA
    with style():
        figure = new_figure(3.4)
        axes = figure.subplots()
        for gap, line in zip(GAPS, LINES, strict=False):
            label = f"$b$ = {1e3 * gap:g} mm" if gap else "$b$ = 0, the input"
            axes.plot(times, 1e3 * exact_inertia(gap), label=label, **line.keywords)
        axes.set(xlabel="time [ms]", ylabel="displacement [mm]", xlim=(0, times[-1]), ylim=(-2.6, 4.0))
        axes.legend(loc="upper right", ncols=3)
    return figure
