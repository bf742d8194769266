"""The loop of section 5.2 over time and in spectra (figures 5.7, 5.9 to 5.12 and 5.14)."""

from typing import Final

import numpy as np
from matplotlib.axes import Axes
from matplotlib.figure import Figure

from report.data.figures import figure
from report.numbers.drive_amplitudes import RECORD, SAMPLE_RATE, SETTLING, AmplitudeRun
from report.numbers.evidence import Evidence
from report.numbers.impulse_response import GAPS, SHOWN
from report.numbers.record import Record, line_amplitudes
from report.numbers.thesis import DRIVE_AMPLITUDE, DRIVE_FREQUENCY, DRIVE_OMEGA, LARGE_GAP, SMALL_GAP
from report.numbers.timed_block import RECORD as SHORT
from report.pages.drawing import plane
from report.pages.drawing.marks import beside
from report.pages.drawing.style import DOTTED, LINES, new_figure, panels
from trimmer import FrictionBacklash
from trimmer.arrays import Reals
from trimmer.orbits.periodic_orbit import PeriodicOrbit
from trimmer.spectra import Window, amplitude_spectrum

READING: Final = 33.03  # Printed reading of the crest in figure 5.9a, µm
CREST: Final = 0.025  # Time to either side of the crest that is shown, over the period
WINDOW: Final = 1.5e-3
"""Time over which smallest and largest value make one point of a band, s: more than a period."""
SHOWN_PERIODS: Final = 4
NEAR_PEAK: Final = (690.0, 780.0)  # Frequencies of figure 5.9b, Hz
RECORDS: Final = (Record(1.0, 20_001), Record(0.1, 20_001))
HIGHEST: Final = 1200.0  # Highest frequency that is shown, Hz
FLOOR: Final = 0.1  # Smallest line that is shown, µm


@figure("fig-5.7")
def three_gaps(known: Evidence) -> Figure:
    figure, grid = panels(3.9, len(GAPS), len(SHOWN), sharex=True, sharey=True)
    for run in known.motion.closed.impulses.runs:
        axes = grid[GAPS.index(run.gap), SHOWN.index(run.impulse)]
        _band(axes, run.times, 1e9 * run.output)
        goes_on = run.amplitude > run.gap / 2
        text = f"goes on with {1e9 * run.amplitude:.1f} nm" if goes_on else "dies out"
        axes.text(0.97, 0.5, text, transform=axes.transAxes, va="center" if goes_on else "bottom", ha="right")
    for row, gap in zip(grid, GAPS, strict=True):
        row[0].set_ylabel(f"$b$ = {1e9 * gap:.0f} nm\n$y$ [nm]")
    for column, impulse in zip(grid.T, SHOWN, strict=True):
        column[0].set_title(f"impulse {1e12 * impulse:.0f}·10$^{{-12}}$ m s")
        column[-1].set(xlabel="time [ms]", xlim=(0, 160), ylim=(-330, 330))
    return figure


def _band(axes: Axes, times: Reals, values: Reals) -> None:
    """Draw how far a fast oscillation reaches, as a band between its smallest and largest values."""
    parts = np.array_split(np.arange(times.size), round(times[-1] / WINDOW))
    middles = 1e3 * np.array([times[part].mean() for part in parts])
    low, high = (np.array([extreme(values[part]) for part in parts]) for extreme in (np.min, np.max))
    axes.fill_between(middles, low, high, color=LINES[0]["color"], alpha=0.35, linewidth=0)
    for edge in (low, high):
        axes.plot(middles, edge, linewidth=1, **LINES[0])


@figure("fig-5.9")
def small_gap(known: Evidence) -> Figure:
    orbit, rounded = known.orbits.friction.stable, known.orbits.friction_listing.stable
    figure = new_figure(5.4)
    grid = figure.add_gridspec(2, 2, width_ratios=(3, 2), height_ratios=(4, 5))
    upper, crest, lower = (figure.add_subplot(place) for place in (grid[0, 0], grid[0, 1], grid[1, :]))
    times = np.linspace(0, SHOWN_PERIODS * orbit.period, 1601)
    upper.plot(1e3 * times, 1e6 * SMALL_GAP * periodic(orbit, times), **LINES[0])
    upper.set(title="settled output", xlabel="time [ms]", ylabel="$y$ [µm]")
    upper.set(xlim=(0, 1e3 * times[-1]), ylim=(-40, 40))
    for each, name, line in zip((orbit, rounded), ("exact", "rounded"), LINES, strict=False):
        phases, values = _crest(each)
        crest.plot(phases, 1e6 * SMALL_GAP * values, label=name, **line)
    crest.axhline(READING, label="reading", **DOTTED)
    crest.set(title="its crest", xlabel="time around it over the period", ylabel="$y$ [µm]")
    crest.set(xlim=(-CREST, CREST), ylim=(32.6, 33.45))
    crest.legend(loc="upper right", fontsize=8, ncols=3, handlelength=1.6, columnspacing=0.8)
    for record, line, marker, size in zip(RECORDS, LINES, "os", (2.5, 5), strict=False):
        times = np.linspace(0, record.duration, record.samples)
        lines = 1e6 * SMALL_GAP * line_amplitudes(periodic(orbit, times))
        frequencies = record.bin_width * np.arange(lines.size)
        near = (frequencies > NEAR_PEAK[0]) & (frequencies < NEAR_PEAK[1])
        label = f"{record.duration:g} s, highest bin {frequencies[np.argmax(lines)]:.0f} Hz"
        lower.plot(frequencies[near], lines[near], marker=marker, markersize=size, label=label, **line)
    lower.axvline(orbit.frequency, **DOTTED)
    lower.set(title="spectrum", xlabel="frequency [Hz]", ylabel="amplitude [µm]")
    lower.set(xlim=NEAR_PEAK, ylim=(0, None))
    lower.legend(loc="upper right")
    return figure


def _crest(orbit: PeriodicOrbit) -> tuple[Reals, Reals]:
    """Return time over the period, from the crest of an orbit on, and the output around it."""
    period = np.linspace(0, 1, 4001)
    highest = period[np.argmax(periodic(orbit, period * orbit.period))]
    around = np.linspace(-CREST, CREST, 201)
    return around, periodic(orbit, (highest + around) * orbit.period)


@figure("fig-5.10")
def larger_gap(known: Evidence) -> Figure:
    system, pair = known.numbers.displacement_only, known.cycles.friction
    figure, ((whole, near), (start, settled)) = panels(6.4, 2, 2, height_ratios=(5, 4))
    for axes, cycle, offset in ((whole, pair.unstable, (24, 8)), (near, pair.stable, (-7, 10))):
        plane.locus(axes, system)
        plane.element_curve(axes, FrictionBacklash(LARGE_GAP), "$-1/N$, $b$ = 40 µm", LINES[1])
        size = f"{1e6 * LARGE_GAP * cycle.amplitude:.1f} µm, {cycle.frequency:.1f} Hz"
        text = f"{size}\n{'stable' if cycle.stable else 'unstable'}"
        plane.mark(axes, system, (cycle,), (text,), (offset,))
    plane.frame(whole, "both intersections", (-9, 3), (-20, 6))
    plane.frame(near, "the outer one, near $-1$", (-1.15, -0.9), (-0.16, 0.02), left=False)
    whole.legend(loc="upper left")
    run = known.motion.closed.impulses.runs[0]  # scaled by the gap it is the motion for any gap
    _band(start, run.times, 1e3 * LARGE_GAP / run.gap * run.output)
    start.set_title(f"after an impulse of {1e3 * run.impulse / run.gap:g} ms times $b$")
    start.set(xlabel="time [ms]", ylabel="$y$ [mm]", xlim=(0, 120))
    orbit = known.orbits.friction.stable
    times = np.linspace(0, SHOWN_PERIODS * orbit.period, 801)
    settled.plot(1e3 * times, 1e3 * LARGE_GAP * periodic(orbit, times), **LINES[0])
    settled.set_title(f"settled, {1e6 * LARGE_GAP * orbit.amplitude:.1f} µm at {orbit.frequency:.1f} Hz")
    settled.set(xlabel="time [ms]", xlim=(0, 1e3 * times[-1]))
    return figure


def periodic(orbit: PeriodicOrbit, times: Reals) -> Reals:
    """Return the output of an orbit at any times, for a gap of one metre."""
    return orbit.motion.output(np.mod(times, orbit.period))


@figure("fig-5.11")
def time_responses(known: Evidence) -> Figure:
    opened, closed = _open_loop(known), known.motion.closed.reference.from_rest.motion
    times = np.linspace(0, 2 / DRIVE_FREQUENCY, opened.output.size, endpoint=False)
    bridge = FrictionBacklash(LARGE_GAP).waveform(opened.phases, DRIVE_AMPLITUDE, DRIVE_OMEGA)
    later = SETTLING + times
    figure, (upper, lower) = panels(4.6, 2, sharex=True, sharey=True)
    for axes, output, load in (
        (upper, opened.output, bridge),
        (lower, closed.output(later), closed.element_output(later)),
    ):
        axes.plot(1e3 * times, 1e3 * output, label="output $y$", **LINES[0])
        axes.plot(1e3 * times, 1e3 * load, label="bridge, behind the play", **LINES[1])
        axes.axhline(1.0, **DOTTED)
        axes.axhline(-1.0, **DOTTED)
        axes.set_ylabel("displacement [mm]")
    upper.set(title="open loop, as the caption has it", ylim=(-1.7, 2.4))
    upper.legend(loc="upper right", ncols=2)
    lower.set(title="output fed back, the drive as reference", xlabel="time [ms]", xlim=(0, 1e3 * times[-1]))
    return figure


@figure("fig-5.12")
def spectra(known: Evidence) -> Figure:
    orbit, closed, run = known.orbits.friction.stable, known.motion.closed, _open_loop(known)
    figure, (top, middle, bottom) = panels(5.2, 3, sharex=True)
    sizes = 1e6 * SMALL_GAP * abs(orbit.harmonics)
    _stems(top, orbit.frequency * np.arange(1, sizes.size + 1), sizes)
    top.set_title("closed loop without drive, $b$ = 4 µm")
    _stems(middle, DRIVE_FREQUENCY * np.arange(run.harmonics.size), 1e6 * run.harmonics)
    middle.set_title("open loop, $b$ = 40 µm")
    times = SETTLING + np.arange(round(RECORD * SAMPLE_RATE)) / SAMPLE_RATE
    record = closed.reference.from_rest.motion.output(times)
    spectrum = amplitude_spectrum(record, SAMPLE_RATE, Window.BLACKMAN_HARRIS)
    bottom.plot(spectrum.frequency, 1e6 * spectrum.amplitude, **LINES[0])
    bottom.set_title("output fed back, the drive as reference, $b$ = 40 µm")
    for axes in (top, middle, bottom):
        axes.axvline(orbit.frequency, **DOTTED)
        axes.set_yscale("log")
        axes.set(ylabel="amplitude [µm]", ylim=(FLOOR, 5e3))
    bottom.set(xlabel="frequency [Hz]", xlim=(0, HIGHEST))
    return figure


def _open_loop(known: Evidence) -> AmplitudeRun:
    return next(run for run in known.motion.drive_amplitudes if run.amplitude == DRIVE_AMPLITUDE)


def _stems(axes: Axes, frequencies: np.ndarray, sizes: np.ndarray) -> None:
    shown = (sizes > FLOOR) & (frequencies > 0) & (frequencies < HIGHEST)
    axes.vlines(frequencies[shown], FLOOR, sizes[shown], color=LINES[0]["color"])
    axes.plot(frequencies[shown], sizes[shown], "o", color=LINES[0]["color"], markersize=4)


@figure("fig-5.14")
def inertia(known: Evidence) -> Figure:
    block = known.motion.closed.timed_block
    frequency, size = block.largest_other_line
    shown = block.times <= 0.03
    figure, grid = panels(4.8, 2, 2, sharex="col", sharey="col")
    rows = ((block.open_loop, "open loop"), (block.block_in_loop, "Listing A.8 in the loop"))
    for (motion, axes), (output, name) in zip(grid, rows, strict=True):
        motion.plot(1e3 * block.times[shown], 1e3 * output[shown], **LINES[0])
        motion.set(ylabel="$y$ [mm]", title=f"{name}, from rest")
        sizes = 1e6 * line_amplitudes(output)
        frequencies = SHORT.bin_width * np.arange(sizes.size)
        near = (frequencies > 0) & (frequencies < HIGHEST)
        axes.plot(frequencies[near], sizes[near], **LINES[0])
        multiples = DRIVE_FREQUENCY * np.arange(1, HIGHEST // DRIVE_FREQUENCY)
        places = np.round(multiples / SHORT.bin_width).astype(int)
        look = {"color": LINES[1]["color"], "markersize": 3.5, "label": "multiples of 100 Hz"}
        axes.plot(frequencies[places], sizes[places], "o", **look)
        axes.axvline(frequency, **DOTTED)
        axes.set_yscale("log")
        axes.set(ylabel="amplitude [µm]", title=f"{name}, spectrum", ylim=(FLOOR, 5e3))
    look = {"ha": "right", "fontsize": 8, "arrowprops": {"arrowstyle": "-"}}
    beside(grid[1, 1], f"{frequency:.1f} Hz", (frequency, 1e6 * size), (-8, 22), **look)
    grid[0, 1].legend(loc="upper right", handletextpad=0.2)
    grid[1, 0].set(xlabel="time [ms]", xlim=(0, 30))
    grid[1, 1].set(xlabel="frequency [Hz]", xlim=(0, HIGHEST))
    return figure
