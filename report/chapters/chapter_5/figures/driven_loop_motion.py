"""Drive, play and linear part in open loop, and with the output fed back (figures 5.11, 5.12 and 5.14)."""

from __future__ import annotations

from typing import TYPE_CHECKING, Final

import numpy as np

from report.chapters.chapter_5.claims.driven_open_loop import open_loop
from report.chapters.chapter_5.claims.section_5_2_2 import largest_other_line
from report.drawing.style import BLACK, LINES, new_figure, style
from report.evidence import Evidence
from report.numbers.linear_numbers import DRIVE_AMPLITUDE, DRIVE_FREQUENCY
from report.numbers.record import line_amplitudes
from report.numbers.reference_loop import GAP, RECORD, SAMPLE_RATE, SETTLING
from report.numbers.timed_block import RECORD as SHORT
from report.thesis import SMALL_GAP
from trimmer.elements.friction_backlash import FrictionBacklash
from trimmer.spectra.spectrum import amplitude_spectrum
from trimmer.spectra.window import Window

if TYPE_CHECKING:
    from matplotlib.axes import Axes
    from matplotlib.figure import Figure

PERIODS: Final = 2
HIGHEST: Final = 1200.0
"""Highest frequency that is shown, Hz."""
FLOOR: Final = 0.1
"""Smallest line that is shown, µm."""


def time_responses(evidence: Evidence) -> Figure:
    """Draw output and bridge of the open loop and of the loop with a reference (thesis, figure 5.11)."""
    opened, closed = open_loop(evidence), evidence.motion.closed.reference.from_rest
    times = np.linspace(0, PERIODS / DRIVE_FREQUENCY, opened.output.size, endpoint=False)
    bridge = FrictionBacklash(GAP).waveform(
        np.asarray(opened.phases), DRIVE_AMPLITUDE, 2 * np.pi * DRIVE_FREQUENCY
    )
    later = SETTLING + times
    with style():
        figure = new_figure(4.6)
        upper, lower = figure.subplots(2, 1, sharex=True, sharey=True)
        for axes, output, load in (
            (upper, opened.output, bridge),
            (lower, closed.motion.output(later), closed.motion.element_output(later)),
        ):
            axes.plot(1e3 * times, 1e3 * output, label="output $y$", **LINES[0].keywords)
            axes.plot(1e3 * times, 1e3 * load, label="bridge, behind the play", **LINES[1].keywords)
            axes.axhline(1.0, color=BLACK, linestyle=":", linewidth=0.9)
            axes.axhline(-1.0, color=BLACK, linestyle=":", linewidth=0.9)
            axes.set_ylabel("[mm]")
        upper.set_title("open loop, as the caption has it")
        upper.set_ylim(-1.7, 2.4)
        upper.legend(loc="upper right", ncols=2)
        lower.set_title("output fed back, the drive as reference")
        lower.set(xlabel="time [ms]", xlim=(0, 1e3 * times[-1]))
    return figure


def spectra(evidence: Evidence) -> Figure:
    """Draw the spectra of the closed loop and of both driven ones (thesis, figure 5.12)."""
    orbit, reference = evidence.motion.closed.orbits.friction.stable, evidence.motion.closed.reference
    run = open_loop(evidence)
    with style():
        figure = new_figure(5.2)
        top, middle, bottom = figure.subplots(3, 1, sharex=True)
        sizes = 1e6 * SMALL_GAP * abs(orbit.harmonics)
        _stems(top, orbit.frequency * np.arange(1, sizes.size + 1), sizes)
        top.set_title("a: closed loop without drive, $b$ = 4 µm")
        _stems(middle, DRIVE_FREQUENCY * np.arange(run.harmonics.size), 1e6 * run.harmonics)
        middle.set_title("b: open loop, $b$ = 40 µm")
        record = reference.from_rest.motion.output(
            SETTLING + np.arange(round(RECORD * SAMPLE_RATE)) / SAMPLE_RATE
        )
        spectrum = amplitude_spectrum(record, SAMPLE_RATE, Window.BLACKMAN_HARRIS)
        bottom.plot(spectrum.frequency, 1e6 * spectrum.amplitude, **LINES[0].keywords)
        bottom.set_title("b: output fed back, the drive as reference, $b$ = 40 µm")
        for axes in (top, middle, bottom):
            axes.axvline(orbit.frequency, color=BLACK, linestyle=":", linewidth=0.9)
            axes.set_yscale("log")
            axes.set(ylabel="amplitude [µm]", ylim=(FLOOR, 5e3))
        bottom.set(xlabel="frequency [Hz]", xlim=(0, HIGHEST))
    return figure


def _stems(axes: Axes, frequencies: np.ndarray, sizes: np.ndarray) -> None:
    shown = (sizes > FLOOR) & (frequencies > 0) & (frequencies < HIGHEST)
    axes.vlines(frequencies[shown], FLOOR, sizes[shown], color=LINES[0].colour)
    axes.plot(frequencies[shown], sizes[shown], "o", color=LINES[0].colour, markersize=4)


def inertia(evidence: Evidence) -> Figure:
    """Draw inertia-controlled backlash in open loop and Listing A.8's block in the loop (figure 5.14)."""
    block = evidence.motion.closed.timed_block
    frequency, size = largest_other_line(block)
    with style():
        figure = new_figure(4.8)
        grid = figure.subplots(2, 2, sharex="col", sharey="col")
        rows = ((block.open_loop, "open loop"), (block.block_in_loop, "Listing A.8 in the loop"))
        for (time_axes, axes), (output, name) in zip(grid, rows, strict=True):
            shown = block.times <= 0.03
            time_axes.plot(1e3 * block.times[shown], 1e3 * output[shown], **LINES[0].keywords)
            time_axes.set(ylabel="$y$ [mm]", title=f"a: {name}, from rest")
            sizes = 1e6 * line_amplitudes(output)
            frequencies = SHORT.bin_width * np.arange(sizes.size)
            near = (frequencies > 0) & (frequencies < HIGHEST)
            axes.plot(frequencies[near], sizes[near], **LINES[0].keywords)
            multiples = DRIVE_FREQUENCY * np.arange(1, HIGHEST // DRIVE_FREQUENCY)
            places = np.round(multiples / SHORT.bin_width).astype(int)
            axes.plot(
                *(frequencies[places], sizes[places], "o"),
                color=LINES[1].colour,
                markersize=3.5,
                label="multiples of 100 Hz",
            )
            axes.axvline(frequency, color=BLACK, linestyle=":", linewidth=0.9)
            axes.set_yscale("log")
            axes.set(ylabel="amplitude [µm]", title=f"b: {name}", ylim=(FLOOR, 5e3))
        grid[1, 1].annotate(
            f"{frequency:.1f} Hz",
            (frequency, 1e6 * size),
            (-8, 22),
            textcoords="offset points",
            ha="right",
            fontsize=8,
            arrowprops={"arrowstyle": "-"},
        )
        grid[0, 1].legend(loc="upper right", handletextpad=0.2)
        grid[1, 0].set(xlabel="time [ms]", xlim=(0, 30))
        grid[1, 1].set(xlabel="frequency [Hz]", xlim=(0, HIGHEST))
    return figure
