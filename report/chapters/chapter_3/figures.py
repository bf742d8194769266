"""The trimmer over time and in spectra, driven (figures 3.1 to 3.8) and released (figure 3.9).

The experiment's data and parameters are confidential, so all are drawn with the parameters of Listing A.1.
"""

from typing import Any, Final

import numpy as np
from matplotlib.axes import Axes
from matplotlib.figure import Figure

from report.data.figures import figure
from report.numbers.driven_motion import FORCES, DrivenRun, transient_spectrum
from report.numbers.evidence import Evidence
from report.numbers.released_motion import FORCES_OF_FIGURE, INSIDE, OUTSIDE, ReleasedRun, released_spectrum
from report.numbers.thesis import (
    EXPERIMENT_GAP,
    FRAMES_OF_TABLES,
    LARGER_GAP,
    LARGEST_GAP,
    MEASURED_DRIVE_FREQUENCY,
    OPEN_LOOP_PEAK,
    SAMPLE_RATE,
    TABLE_2,
)
from report.pages.drawing.marks import beside, name_places
from report.pages.drawing.style import BLACK, FAINT, LINES, panels
from trimmer.arrays import Reals
from trimmer.spectra import Spectrum, Window, amplitude_spectrum

SHOWN_FORCE: Final = FORCES[1]  # Friction in the figures that stand for the experiment, N
SHOWN_TIME, FROM_REST = 0.05, 0.03  # Time that is shown of the settled motions, and of those from rest, s
WHOLE_PERIODS: Final = 6003
"""Samples in 33 periods of the drive, to 1e-6: nothing leaks from one harmonic to another."""
SET_APART: Final = 0.2  # Distance between the bars of two frictions, in distances between two harmonics
IN_A_ROW: Final[dict[str, Any]] = {"ncols": 3, "fontsize": 8, "handlelength": 1.7, "columnspacing": 1.0}


@figure("fig-3.1")
def motions_without_play(known: Evidence) -> Figure:
    return _motions(known, "without play")


@figure("fig-3.3")
def motions_with_play(known: Evidence) -> Figure:
    return _motions(known, "with play")


def _motions(known: Evidence, shown: str) -> Figure:
    """Draw stroke and guard with and without play over each other, the one that is shown on top."""
    gaps = {"without play": 0.0, "with play": EXPERIMENT_GAP}
    figure, (stroke, guard) = panels(3.6, 2, sharex=True)
    for (name, gap), line in zip(gaps.items(), LINES, strict=False):
        run = known.motion.driven.run(gap, SHOWN_FORCE)
        part = run.last(int(SHOWN_TIME * SAMPLE_RATE) + 1)
        times = 1e3 * (run.times[part] - run.times[part.start])
        look = line | ({"zorder": 3, "linewidth": 1.6} if name == shown else {"linewidth": 0.9})
        stroke.plot(times, 1e3 * run.output[part], label=name, **look)
        guard.plot(times, 1e6 * run.guard[part], **look)
    stroke.set(ylabel="$q_2 - q_4$ [mm]", ylim=(-1.9, 2.6))
    stroke.legend(loc="upper left", ncols=2)
    guard.set(ylabel="guard, $q_4$ [µm]", xlabel="time [ms]", xlim=(0, 1e3 * SHOWN_TIME))
    return figure


@figure("fig-3.2")
def spectrum_without_play(known: Evidence) -> Figure:
    return _spectra({"without play": _settled(known.motion.driven.run(0.0, SHOWN_FORCE))})


@figure("fig-3.4")
def spectrum_with_play(known: Evidence) -> Figure:
    gaps = {"play of 0.2 mm": EXPERIMENT_GAP, "without play": 0.0}
    return _spectra({name: _settled(known.motion.driven.run(gap, SHOWN_FORCE)) for name, gap in gaps.items()})


def _settled(run: DrivenRun, samples: int = FRAMES_OF_TABLES) -> Spectrum:
    return amplitude_spectrum(run.output[run.last(samples)], SAMPLE_RATE, Window.RECTANGULAR)


def _spectra(spectra: dict[str, Spectrum]) -> Figure:
    figure, axes = panels(2.9)
    for (name, spectrum), line, marker in zip(spectra.items(), LINES, "os", strict=False):
        look = {"marker": marker, "markersize": 4, "linewidth": 1.0} | line
        axes.semilogy(spectrum.frequency, 1e6 * spectrum.amplitude, label=name, **look)
    axes.set(xlabel="frequency [Hz]", ylabel="amplitude [µm]", xlim=(0, 1050), ylim=(0.3, 2e4))
    for order in range(1, 10, 2):
        axes.annotate(f"$f_{order}$", (order * MEASURED_DRIVE_FREQUENCY, 6e3), ha="center")
    axes.legend(loc="upper right", bbox_to_anchor=(1.0, 0.86))
    return figure


@figure("fig-3.5")
def enlarged_spectrum(known: Evidence) -> Figure:
    spectrum = _settled(known.motion.driven.run(EXPERIMENT_GAP, SHOWN_FORCE))
    frequency, amplitude = spectrum.frequency, 1e6 * spectrum.amplitude
    height = float(amplitude[frequency > 200].max())
    figure, (model, rug) = panels(3.8, 2, sharex=True, height_ratios=(3, 1))
    model.plot(frequency, amplitude, marker=".", **LINES[0])
    for row, (cells, line) in enumerate(zip(TABLE_2.values(), LINES[1:], strict=False)):
        places = [float(cell) for cell in cells[1:]]
        rug.plot(places, [row] * len(places), "|", color=line["color"], markersize=13, markeredgewidth=2)
    name_places(rug.yaxis, list(TABLE_2))
    rug.grid(visible=False)
    for order in range(2, 10):
        for axes in (model, rug):
            axes.axvline(order * MEASURED_DRIVE_FREQUENCY, **FAINT)
        _name_harmonic(model, order, 1.08 * height, (3, 0))
    model.set(title="model", ylabel="amplitude [µm]", ylim=(0, 1.25 * height))
    rug.set(title="measured peaks", ylim=(len(TABLE_2) - 0.4, -0.6))
    rug.set(xlabel="frequency [Hz]", xlim=(200, 1000))
    return figure


@figure("fig-3.6")
def open_loop_with_small_gap(known: Evidence) -> Figure:
    runs = [known.motion.driven.run(EXPERIMENT_GAP, force) for force in FORCES]
    orders = np.arange(3, 10, 2)
    figure, (over_time, harmonics) = panels(3.2, 1, 2)
    for index, (run, line, marker) in enumerate(zip(runs, LINES, "os^", strict=False)):
        _from_rest(over_time, run, line)
        places = np.arange(orders.size) + SET_APART * (index - 1)
        heights = 1e6 * run.harmonics[orders]
        harmonics.vlines(places, 0, heights, colors=line["color"], linestyles=[line["linestyle"]])
        look = {"color": line["color"], "markersize": 5, "label": f"{run.force:.2f} N"}
        harmonics.plot(places, heights, marker, **look)
    names = [f"$f_{order}$\n{order * MEASURED_DRIVE_FREQUENCY:.0f} Hz" for order in orders]
    name_places(harmonics.xaxis, names)
    over_time.set(title="from rest", ylim=(-1.8, 2.5))
    over_time.legend(loc="upper right", **IN_A_ROW)
    harmonics.set(xlabel="harmonic of the drive", ylabel="amplitude [µm]")
    harmonics.set(xlim=(-0.5, orders.size - 0.5), ylim=(0, 330), title="settled, above the drive")
    harmonics.legend(loc="upper right")
    return figure


@figure("fig-3.7")
def open_loop_with_large_gap(known: Evidence) -> Figure:
    still = known.motion.driven.run(LARGEST_GAP, SHOWN_FORCE)
    part = slice(0, int(FROM_REST * SAMPLE_RATE) + 1)
    times = 1e3 * still.times[part]
    figure, (printed, smaller) = panels(3.2, 1, 2)
    printed.fill_between(times, -500 * LARGEST_GAP, 500 * LARGEST_GAP, color="#e4e4e4", label="play")
    printed.plot(times, 1e3 * still.pin[part], label="pin", **LINES[1])
    printed.plot(times, 1e3 * still.output[part], label="$q_2 - q_4$", **LINES[0])
    printed.set(xlabel="time [ms]", ylabel="displacement [mm]", title="$b$ = 20 mm, as printed")
    printed.set(xlim=(0, 1e3 * FROM_REST), ylim=(-12, 17))
    printed.legend(loc="upper right", ncols=3)
    for force, line in zip(FORCES, LINES, strict=False):
        _from_rest(smaller, known.motion.driven.run(LARGER_GAP, force), line)
    smaller.set(title="$b$ = 2 mm", ylim=(-1.7, 2.4))
    smaller.legend(loc="upper right", **IN_A_ROW)
    return figure


def _from_rest(axes: Axes, run: DrivenRun, keywords: dict[str, Any]) -> None:
    part = slice(0, int(FROM_REST * SAMPLE_RATE) + 1)
    axes.plot(1e3 * run.times[part], 1e3 * run.output[part], label=f"{run.force:.2f} N", **keywords)
    axes.set(xlabel="time [ms]", ylabel="$q_2 - q_4$ [mm]", xlim=(0, 1e3 * FROM_REST))


def _name_harmonic(axes: Axes, order: int, height: float, offset: tuple[float, float] = (6, 4)) -> None:
    beside(axes, f"$f_{order}$", (order * MEASURED_DRIVE_FREQUENCY, height), offset)


@figure("fig-3.8")
def open_loop_spectrum_with_large_gap(known: Evidence) -> Figure:
    run = known.motion.driven.run(LARGER_GAP, FORCES[0])
    started = amplitude_spectrum(run.output[:WHOLE_PERIODS], SAMPLE_RATE, Window.RECTANGULAR)
    settled = _settled(run, WHOLE_PERIODS)
    figure, (both, dying) = panels(3.4, 1, 2)
    for spectrum, name, line in ((started, "first 0.3 s", LINES[1]), (settled, "last 0.3 s", LINES[0])):
        amplitude = 1e6 * np.maximum(spectrum.amplitude, 1e-12)
        both.semilogy(spectrum.frequency, amplitude, label=name, **line)
    both.set(xlabel="frequency [Hz]", ylabel="amplitude [µm]", xlim=(80, 700), ylim=(1e-2, 2e4))
    both.set_title("record with and without the start")
    both.legend(loc="upper right", ncols=2)
    for order in (1, 3, 5):
        _name_harmonic(both, order, 1e6 * float(run.harmonics[order]))
    frequency, modulus = transient_spectrum(run)
    inside = (frequency > 80) & (frequency < 700)
    height = float(1e6 * modulus[inside].max())
    dying.plot(frequency[inside], 1e6 * modulus[inside], **LINES[1])
    for mode in known.numbers.modes[:3]:
        dying.axvline(mode.frequency, **FAINT)
        beside(dying, f"{mode.frequency:.0f} Hz", (mode.frequency, 1.25 * height), (-3, 0), ha="right")
    peak = float(OPEN_LOOP_PEAK)
    dying.plot([peak], [1.06 * height], "v", color=BLACK, markersize=6)
    place = (peak + 12, 1.06 * height)
    dying.annotate(f"{OPEN_LOOP_PEAK} Hz\nin the thesis", place, va="top", fontsize=9)
    dying.set(xlabel="frequency [Hz]", ylabel="modulus [µm s]", title="what dies out")
    dying.set(xlim=(80, 700), ylim=(0, 1.35 * height))
    return figure


@figure("fig-3.9")
def closed_loop_spectra(known: Evidence) -> Figure:
    second, third = (mode.frequency for mode in known.numbers.modes[1:3])
    figure, grid = panels(4.8, 2, 2, sharex=True, sharey="col")
    for row, gap in zip(grid, (EXPERIMENT_GAP, LARGEST_GAP), strict=True):
        for axes, start in zip(row, (INSIDE, OUTSIDE), strict=True):
            for force, line in zip(FORCES_OF_FIGURE, LINES, strict=False):
                run = known.motion.released.released(gap, force, start)
                frequency, amplitude = _released_spectrum(run)
                shown = (frequency > 100) & (frequency < 900)
                label = f"$F_c$ = {force:g} N"
                axes.plot(frequency[shown], amplitude[shown] / gap, label=label, **line)
            axes.axvline(second, **FAINT)
            axes.set_xlim(100, 900)
        row[0].set_ylabel(f"$b$ = {1e3 * gap:g} mm\namplitude$/b$")
    inside, outside = grid[0]
    inside.set(title="released inside of the play, 0.4 gaps", ylim=(0, 0.017))
    outside.set(title="released outside, 4 gaps", ylim=(0, 6))
    for axes in grid[1]:
        axes.set_xlabel("frequency [Hz]")
    for axes in (inside, outside):
        beside(axes, f"{second:.1f} Hz", (second, 0.9 * axes.get_ylim()[1]), (-4, 0), ha="right")
    inside.annotate(f"{third:.0f} Hz", (third, 0.0145), ha="center")
    cycle = known.motion.released.released(EXPERIMENT_GAP, FORCES_OF_FIGURE[0], OUTSIDE)
    outside.annotate(f"limit cycle,\n{cycle.frequency:.0f} Hz", (cycle.frequency, 4.65), ha="center")
    figure.legend(*grid[1, 1].get_legend_handles_labels(), loc="outside lower center", ncols=3)
    return figure


def _released_spectrum(run: ReleasedRun) -> tuple[Reals, Reals]:
    """Return a spectrum; that of an oscillation that goes on with the window that shows amplitudes."""
    if not run.goes_on:
        return released_spectrum(run)
    spectrum = amplitude_spectrum(run.output, SAMPLE_RATE, Window.FLAT_TOP)
    return spectrum.frequency, spectrum.amplitude
