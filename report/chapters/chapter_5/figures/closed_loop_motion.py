"""The closed loop without drive (thesis, figures 5.7, 5.9, 5.10b and 5.23b), drawn again."""

from __future__ import annotations

from typing import TYPE_CHECKING, Final

import numpy as np

from report.chapters.chapter_5.claims.section_5_2_5 import PEAKS
from report.drawing.style import BLACK, LINES, LineStyle, new_figure, style
from report.evidence import Evidence
from report.numbers.impulse_response import GAPS, SHOWN
from report.numbers.record import Record, line_amplitudes
from report.numbers.released_bodies import RECORD
from report.thesis import LARGE_GAP, SMALL_GAP

if TYPE_CHECKING:
    from matplotlib.axes import Axes
    from matplotlib.figure import Figure
    from numpy.typing import NDArray

    from trimmer.orbits.periodic_orbit import PeriodicOrbit

    Reals = NDArray[np.float64]

READINGS = (33.03, -32.961)
"""Printed readings of figure 5.9a, µm."""
WINDOW: Final = 1.5e-3
"""Time over which smallest and largest value make one point of a band, s: more than a period."""
SHOWN_PERIODS: Final = 4
NEAR_PEAK: Final = (690.0, 780.0)
"""Frequencies of figure 5.9b, Hz."""
NEAR_MODES: Final = (150.0, 850.0)
"""Frequencies of figure 5.23b, Hz."""
RECORDS: Final = (Record(1.0, 20_001), Record(0.1, 20_001))


def three_gaps(evidence: Evidence) -> Figure:
    """Draw the loop with three gaps after a strong and a weak impulse (thesis, figure 5.7)."""
    runs = evidence.motion.closed.impulses.runs
    with style():
        figure = new_figure(4.8)
        grid = figure.subplots(len(GAPS), len(SHOWN), sharex=True, sharey=True)
        for run in runs:
            axes = grid[GAPS.index(run.gap), SHOWN.index(run.impulse)]
            _band(axes, run.times, 1e9 * run.output, LINES[0])
            axes.text(
                0.97,
                0.5,
                _outcome(run.amplitude, run.gap),
                transform=axes.transAxes,
                va="center" if run.amplitude > run.gap / 2 else "bottom",
                ha="right",
            )
        for row, gap in zip(grid, GAPS, strict=True):
            row[0].set_ylabel(f"$b$ = {1e9 * gap:.0f} nm\n$y$ [nm]")
        for column, impulse in zip(grid.T, SHOWN, strict=True):
            column[0].set_title(f"impulse {1e12 * impulse:.0f}·10$^{{-12}}$ m s")
            column[-1].set(xlabel="time [ms]", xlim=(0, 160), ylim=(-330, 330))
    return figure


def _outcome(amplitude: float, gap: float) -> str:
    return f"goes on with {1e9 * amplitude:.1f} nm" if amplitude > gap / 2 else "dies out"


def _band(axes: Axes, times: Reals, values: Reals, line: LineStyle, scale: float = 1e3) -> None:
    """Draw how far a fast oscillation reaches, as a band between its smallest and largest values."""
    count = round(times[-1] / WINDOW)
    parts = np.array_split(np.arange(times.size), count)
    middles = scale * np.array([times[part].mean() for part in parts])
    low, high = (np.array([extreme(values[part]) for part in parts]) for extreme in (np.min, np.max))
    axes.fill_between(middles, low, high, color=line.colour, alpha=0.35, linewidth=0)
    for edge in (low, high):
        axes.plot(middles, edge, linewidth=1, **line.keywords)


def small_gap(evidence: Evidence) -> Figure:
    """Draw the settled oscillation for 4 µm, its peaks with the readings, and its spectrum (figure 5.9)."""
    orbits = evidence.motion.closed.orbits
    orbit, rounded = orbits.friction.stable, orbits.friction_listing.stable
    with style():
        figure = new_figure(5.2)
        upper, lower = figure.subplots(2, 1)
        times = np.linspace(0, SHOWN_PERIODS * orbit.period, 1601)
        upper.plot(1e3 * times, 1e6 * SMALL_GAP * periodic(orbit, times), **LINES[0].keywords)
        for reading in READINGS:
            upper.axhline(reading, color=BLACK, linestyle=":", linewidth=0.9)
        upper.annotate(
            f"exact ±{1e6 * SMALL_GAP * orbit.amplitude:.2f} µm, rounded coefficients "
            f"±{1e6 * SMALL_GAP * rounded.amplitude:.2f} µm; dotted: readings {READINGS[0]} and "
            f"−{-READINGS[1]} µm",
            (0.5, 1.02),
            xycoords="axes fraction",
            ha="center",
            fontsize=9,
        )
        upper.set(xlabel="a: time [ms]", ylabel="$y$ [µm]", xlim=(0, 1e3 * times[-1]), ylim=(-40, 40))
        _peak(lower, orbit)
    return figure


def _peak(axes: Axes, orbit: PeriodicOrbit) -> None:
    """Draw the spectrum near its peak, for a record of one second and one of a tenth."""
    for record, line, marker in zip(RECORDS, LINES, ("o", "s"), strict=False):
        times = np.linspace(0, record.duration, record.samples)
        sizes = 1e6 * SMALL_GAP * line_amplitudes(periodic(orbit, times))
        frequencies = record.bin_width * np.arange(sizes.size)
        near = (frequencies > NEAR_PEAK[0]) & (frequencies < NEAR_PEAK[1])
        highest = frequencies[np.argmax(sizes)]
        axes.plot(
            frequencies[near],
            sizes[near],
            marker=marker,
            markersize=2.5 if record.duration == 1.0 else 5,
            label=f"{record.duration:g} s, highest bin {highest:.0f} Hz",
            **line.keywords,
        )
    axes.axvline(orbit.frequency, color=BLACK, linestyle=":", linewidth=0.9)
    axes.set(xlabel="b: frequency [Hz]", ylabel="amplitude [µm]", xlim=NEAR_PEAK, ylim=(0, None))
    axes.legend(loc="upper right")


def periodic(orbit: PeriodicOrbit, times: Reals) -> Reals:
    """Return the output of an orbit at any times, for a gap of one metre."""
    return orbit.motion.output(np.mod(times, orbit.period))


def larger_gap_over_time(start: Axes, settled: Axes, evidence: Evidence) -> None:
    """Draw the loop with 40 µm after an impulse, and settled (thesis, figure 5.10b)."""
    closed = evidence.motion.closed
    run = closed.impulses.runs[0]  # scaled by the gap it is the motion for any gap
    _band(start, run.times, 1e3 * LARGE_GAP / run.gap * run.output, LINES[0])
    start.set(
        title=f"b: after an impulse of {1e3 * run.impulse / run.gap:g} ms times $b$",
        xlabel="time [ms]",
        ylabel="$y$ [mm]",
        xlim=(0, 120),
    )
    orbit = closed.orbits.friction.stable
    times = np.linspace(0, SHOWN_PERIODS * orbit.period, 801)
    settled.plot(1e3 * times, 1e3 * LARGE_GAP * periodic(orbit, times), **LINES[0].keywords)
    settled.set(
        title=f"b: settled, {1e6 * LARGE_GAP * orbit.amplitude:.1f} µm at {orbit.frequency:.1f} Hz",
        xlabel="time [ms]",
        xlim=(0, 1e3 * times[-1]),
    )


def released_spectrum(axes: Axes, evidence: Evidence) -> None:
    """Draw the spectrum of the loop with 0.6 N, all bodies released alike (thesis, figure 5.23b)."""
    numbers = evidence.motion.closed.released_bodies
    for run, line in zip(numbers.runs, LINES, strict=False):
        sizes = line_amplitudes(run.output) / run.displacement
        frequencies = RECORD.bin_width * np.arange(sizes.size)
        near = (frequencies > NEAR_MODES[0]) & (frequencies < NEAR_MODES[1])
        axes.plot(frequencies[near], 1e3 * sizes[near], label=f"{run.displacement:g} m", **line.keywords)
    for frequency, printed in zip(numbers.modes, PEAKS, strict=False):
        axes.axvline(frequency, color=BLACK, linestyle=":", linewidth=0.9)
        axes.annotate(
            f"{frequency:.2f} Hz\n(printed {printed})",
            (frequency, 0.97),
            (5, 0),
            textcoords="offset points",
            xycoords=("data", "axes fraction"),
            va="top",
            fontsize=8,
        )
    axes.set(
        title="b: free vibration after all bodies were displaced alike",
        xlabel="frequency [Hz]",
        ylabel="line over start [10$^{-3}$]",
        xlim=NEAR_MODES,
        ylim=(0, 22),
    )
    axes.legend(loc="center right", title="displaced by")
