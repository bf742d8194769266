"""The driven trimmer over time and in spectra (thesis, figures 3.1 to 3.8), drawn again."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any, Final

import numpy as np

from report.chapters.chapter_3.claims.measured_peaks import FRAMES_OF_TABLES, TABLE_2
from report.drawing.style import BLACK, LINES, new_figure, style
from report.evidence import Evidence
from report.numbers.driven_motion import FORCES, GAP, LARGER_GAP, LARGEST_GAP, SAMPLE_RATE, DrivenRun
from report.numbers.linear_numbers import MEASURED_DRIVE_FREQUENCY
from report.numbers.transient_spectrum import transient_spectrum
from trimmer.spectra.spectrum import Spectrum, amplitude_spectrum
from trimmer.spectra.window import Window

if TYPE_CHECKING:
    from matplotlib.axes import Axes
    from matplotlib.figure import Figure

SHOWN_FORCE: Final = FORCES[1]
"""Friction in the figures that stand for the experiment, N."""
SHOWN_TIME: Final = 0.05
"""Time that is shown of the settled motions, s."""
FROM_REST: Final = 0.03
"""Time that is shown of the motions from rest, s."""
WHOLE_PERIODS: Final = 6003
"""Samples in 33 periods of the drive, to 1e-6: nothing leaks from one harmonic to another."""
OPEN_LOOP_PEAK: Final = 365.999
"""Peak of figure 3.8 that the thesis reads as a limit cycle, Hz."""
SET_APART: Final = 16.0
"""Distance between the symbols of two frictions at one harmonic, Hz."""
_MODE: Final[dict[str, Any]] = {"color": "#555555", "linestyle": ":", "linewidth": 1.0}
_IN_A_ROW: Final[dict[str, Any]] = {"ncols": 3, "fontsize": 8, "handlelength": 1.7, "columnspacing": 1.0}


def motions_without_play(evidence: Evidence) -> Figure:
    """Draw cutter, guard and their difference without play (thesis, figure 3.1)."""
    return _motions(evidence.motion.driven.run(0.0, SHOWN_FORCE))


def motions_with_play(evidence: Evidence) -> Figure:
    """Draw cutter, guard and their difference with play (thesis, figure 3.3)."""
    return _motions(evidence.motion.driven.run(GAP, SHOWN_FORCE))


def _motions(run: DrivenRun) -> Figure:
    part = run.last(int(SHOWN_TIME * SAMPLE_RATE) + 1)
    times = 1e3 * (run.times[part] - run.times[part.start])
    rows = (
        ("cutter, $q_2$ [mm]", 1e3 * run.cutter),
        ("guard, $q_4$ [µm]", 1e6 * run.guard),
        ("$q_2 - q_4$ [mm]", 1e3 * run.output),
    )
    with style():
        figure = new_figure(4.4)
        for axes, (label, values), line in zip(figure.subplots(3, 1, sharex=True), rows, LINES, strict=False):
            axes.plot(times, values[part], **line.keywords)
            axes.set_ylabel(label)
        axes.set(xlabel="time [ms]", xlim=(0, 1e3 * SHOWN_TIME))
    return figure


def spectrum_without_play(evidence: Evidence) -> Figure:
    """Draw the spectrum of 2001 samples without play (thesis, figure 3.2)."""
    return _spectra({"without play": _settled(evidence.motion.driven.run(0.0, SHOWN_FORCE))})


def spectrum_with_play(evidence: Evidence) -> Figure:
    """Draw the spectrum of 2001 samples with and without play (thesis, figure 3.4)."""
    driven = evidence.motion.driven
    return _spectra(
        {
            "play of 0.2 mm": _settled(driven.run(GAP, SHOWN_FORCE)),
            "without play": _settled(driven.run(0.0, SHOWN_FORCE)),
        }
    )


def _settled(run: DrivenRun, samples: int = FRAMES_OF_TABLES) -> Spectrum:
    return amplitude_spectrum(run.output[run.last(samples)], SAMPLE_RATE, Window.RECTANGULAR)


def _spectra(spectra: dict[str, Spectrum]) -> Figure:
    with style():
        figure = new_figure(2.9)
        axes = figure.subplots()
        for (name, spectrum), line, marker in zip(spectra.items(), LINES, "os", strict=False):
            axes.semilogy(
                *(spectrum.frequency, 1e6 * spectrum.amplitude),
                marker,
                markersize=4,
                linewidth=1.0,
                label=name,
                **line.keywords,
            )
        axes.set(xlabel="frequency [Hz]", ylabel="amplitude [µm]", xlim=(0, 1050), ylim=(0.3, 2e4))
        for order in range(1, 10, 2):
            place = order * MEASURED_DRIVE_FREQUENCY
            axes.annotate(f"$f_{order}$", (place, 6e3), ha="center")
        axes.legend(loc="upper right", bbox_to_anchor=(1.0, 0.86))
    return figure


def enlarged_spectrum(evidence: Evidence) -> Figure:
    """Draw the spectrum with play from 200 to 1000 Hz, and the measured peaks (thesis, figure 3.5)."""
    spectrum = _settled(evidence.motion.driven.run(GAP, SHOWN_FORCE))
    with style():
        figure = new_figure(3.2)
        axes = figure.subplots()
        axes.plot(
            spectrum.frequency, 1e6 * spectrum.amplitude, label="model", marker=".", **LINES[0].keywords
        )
        height = 1e6 * float(spectrum.amplitude[spectrum.frequency > 200].max())
        for row, ((name, cells), marker) in enumerate(zip(TABLE_2.items(), "v^s", strict=True)):
            places = [float(cell) for cell in cells[1:]]
            axes.plot(
                places,
                [height * (1.1 + 0.1 * row)] * len(places),
                marker,
                color=LINES[row + 1].colour,
                markersize=5,
                label=f"measured, {name}",
            )
        for order in range(2, 10):
            place = order * MEASURED_DRIVE_FREQUENCY
            axes.axvline(place, **_MODE)
            axes.annotate(f"$f_{order}$", (place, 1.42 * height), (3, 0), textcoords="offset points")
        axes.set(xlabel="frequency [Hz]", ylabel="amplitude [µm]", xlim=(200, 1000), ylim=(0, 1.55 * height))
        axes.legend(loc="center right", frameon=True, framealpha=1.0, edgecolor="none")
    return figure


def open_loop_with_small_gap(evidence: Evidence) -> Figure:
    """Draw time response and harmonics for the gap of the experiment (thesis, figure 3.6)."""
    runs = [evidence.motion.driven.run(GAP, force) for force in FORCES]
    with style():
        figure = new_figure(3.2)
        over_time, harmonics = figure.subplots(1, 2)
        for index, (run, line, marker) in enumerate(zip(runs, LINES, "os^", strict=False)):
            _from_rest(over_time, run, line.keywords)
            orders = np.arange(3, 10, 2)
            places = orders * MEASURED_DRIVE_FREQUENCY + SET_APART * (index - 1)
            heights = 1e6 * run.harmonics[orders]
            harmonics.vlines(places, 0, heights, colors=line.colour, linestyles=[line.dashes])
            harmonics.plot(
                places, heights, marker, color=line.colour, markersize=5, label=f"{run.force:.2f} N"
            )
        for order in (3, 5, 7, 9):
            _name_harmonic(harmonics, order, 1e6 * max(float(run.harmonics[order]) for run in runs))
        over_time.set(xlabel="time [ms]", ylabel="$q_2 - q_4$ [mm]", title="(a) from rest")
        over_time.set(xlim=(0, 1e3 * FROM_REST), ylim=(-1.8, 2.5))
        over_time.legend(loc="upper right", **_IN_A_ROW)
        harmonics.set(xlabel="frequency [Hz], forces set apart", ylabel="amplitude [µm]")
        harmonics.set(xlim=(200, 1050), ylim=(0, 330), title="(b) settled, above the drive")
        harmonics.legend(loc="upper right")
    return figure


def _from_rest(axes: Axes, run: DrivenRun, keywords: dict[str, Any]) -> None:
    part = slice(0, int(FROM_REST * SAMPLE_RATE) + 1)
    axes.plot(1e3 * run.times[part], 1e3 * run.output[part], label=f"{run.force:.2f} N", **keywords)


def _name_harmonic(axes: Axes, order: int, height: float) -> None:
    place = order * MEASURED_DRIVE_FREQUENCY
    axes.annotate(f"$f_{order}$", (place, height), (6, 4), textcoords="offset points")


def open_loop_with_large_gap(evidence: Evidence) -> Figure:
    """Draw the pin within the printed gap, and the motion with a tenth of it (thesis, figure 3.7)."""
    still = evidence.motion.driven.run(LARGEST_GAP, SHOWN_FORCE)
    part = slice(0, int(FROM_REST * SAMPLE_RATE) + 1)
    times = 1e3 * still.times[part]
    with style():
        figure = new_figure(3.2)
        printed, smaller = figure.subplots(1, 2)
        printed.fill_between(times, -500 * LARGEST_GAP, 500 * LARGEST_GAP, color="#e4e4e4", label="play")
        printed.plot(times, 1e3 * still.pin[part], label="pin", **LINES[1].keywords)
        printed.plot(times, 1e3 * still.output[part], label="$q_2 - q_4$", **LINES[0].keywords)
        printed.set(xlabel="time [ms]", ylabel="displacement [mm]", title="(a) $b$ = 20 mm, as printed")
        printed.set(xlim=(0, 1e3 * FROM_REST), ylim=(-12, 17))
        printed.legend(loc="upper right", ncols=3)
        for force, line in zip(FORCES, LINES, strict=False):
            _from_rest(smaller, evidence.motion.driven.run(LARGER_GAP, force), line.keywords)
        smaller.set(xlabel="time [ms]", ylabel="$q_2 - q_4$ [mm]", title="(b) $b$ = 2 mm")
        smaller.set(xlim=(0, 1e3 * FROM_REST), ylim=(-1.7, 2.4))
        smaller.legend(loc="upper right", **_IN_A_ROW)
    return figure


def open_loop_spectrum_with_large_gap(evidence: Evidence) -> Figure:
    """Draw spectra with and without the start, and that of what dies out (thesis, figure 3.8)."""
    run = evidence.motion.driven.run(LARGER_GAP, FORCES[0])
    started = amplitude_spectrum(run.output[:WHOLE_PERIODS], SAMPLE_RATE, Window.RECTANGULAR)
    settled = _settled(run, WHOLE_PERIODS)
    frequency, modulus = transient_spectrum(run)
    with style():
        figure = new_figure(3.4)
        both, dying = figure.subplots(1, 2)
        for spectrum, name, line in (
            (started, "first 0.3 s", LINES[1]),
            (settled, "last 0.3 s", LINES[0]),
        ):
            amplitude = 1e6 * np.maximum(spectrum.amplitude, 1e-12)
            both.semilogy(spectrum.frequency, amplitude, label=name, **line.keywords)
        both.set(
            xlabel="frequency [Hz]", ylabel="amplitude [µm]", title="(a) record with and without the start"
        )
        both.set(xlim=(80, 700), ylim=(1e-2, 2e4))
        both.legend(loc="upper right", ncols=2)
        for order in (1, 3, 5):
            _name_harmonic(both, order, 1e6 * float(run.harmonics[order]))
        inside = (frequency > 80) & (frequency < 700)
        dying.plot(frequency[inside], 1e6 * modulus[inside], **LINES[1].keywords)
        _natural_modes(dying, evidence, float(1e6 * modulus[inside].max()))
        dying.set(xlabel="frequency [Hz]", ylabel="modulus [µm s]", title="(b) what dies out")
        dying.set(xlim=(80, 700), ylim=(0, 1.35e6 * float(modulus[inside].max())))
    return figure


def _natural_modes(axes: Axes, evidence: Evidence, height: float) -> None:
    """Mark the natural modes, and the peak of the thesis."""
    for mode in evidence.numbers.modes[:3]:
        axes.axvline(mode.frequency, **_MODE)
        place = (mode.frequency, 1.25 * height)
        axes.annotate(f"{mode.frequency:.0f} Hz", place, (-3, 0), textcoords="offset points", ha="right")
    axes.plot([OPEN_LOOP_PEAK], [1.06 * height], "v", color=BLACK, markersize=6)
    place = (OPEN_LOOP_PEAK + 12, 1.06 * height)
    axes.annotate("365.999 Hz\nin the thesis", place, va="top", fontsize=9)
