"""The closed loop released without drive (thesis, figures 3.9 and E.1), drawn again."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any, Final

from report.drawing.style import LINES, new_figure, style
from report.evidence import Evidence
from report.numbers.driven_motion import GAP, LARGEST_GAP, SAMPLE_RATE
from report.numbers.released_motion import FORCES_OF_FIGURE, INSIDE, OUTSIDE, ReleasedRun, released_spectrum
from trimmer.spectra.spectrum import amplitude_spectrum
from trimmer.spectra.window import Window

if TYPE_CHECKING:
    import numpy as np
    from matplotlib.axes import Axes
    from matplotlib.figure import Figure
    from numpy.typing import NDArray

    Reals = NDArray[np.float64]

LAST: Final = 0.012
"""Time that is shown of the settled motions, s."""
_MODE: Final[dict[str, Any]] = {"color": "#555555", "linestyle": ":", "linewidth": 1.0}


def closed_loop_spectra(evidence: Evidence) -> Figure:
    """Draw spectra for two gaps, three frictions and two starts (thesis, figure 3.9)."""
    with style():
        figure = new_figure(4.8)
        grid = figure.subplots(2, 2, sharex=True, sharey="col")
        for row, gap in zip(grid, (GAP, LARGEST_GAP), strict=True):
            for axes, start in zip(row, (INSIDE, OUTSIDE), strict=True):
                _spectra(axes, evidence, gap, start)
            row[0].set_ylabel(f"$b$ = {1e3 * gap:g} mm\namplitude$/b$")
        grid[0, 0].set_title("released inside of the play, 0.4 gaps")
        grid[0, 1].set_title("released outside, 4 gaps")
        for axes in grid[1]:
            axes.set_xlabel("frequency [Hz]")
        grid[0, 0].set_ylim(0, 0.017)
        grid[0, 1].set_ylim(0, 5.5)
        _names(grid[0, 0], grid[0, 1], evidence)
        figure.legend(*grid[1, 1].get_legend_handles_labels(), loc="outside lower center", ncols=3)
    return figure


def _spectra(axes: Axes, evidence: Evidence, gap: float, start: float) -> None:
    for force, line in zip(FORCES_OF_FIGURE, LINES, strict=False):
        run = evidence.motion.released.released(gap, force, start)
        frequency, amplitude = _lasting(run) if run.goes_on else released_spectrum(run)
        shown = (frequency > 100) & (frequency < 900)
        axes.plot(frequency[shown], amplitude[shown] / gap, label=f"$F_c$ = {force:g} N", **line.keywords)
    axes.axvline(evidence.numbers.modes[1].frequency, **_MODE)
    axes.set_xlim(100, 900)


def _lasting(run: ReleasedRun) -> tuple[Reals, Reals]:
    """Return the spectrum of an oscillation that goes on, with the window that shows amplitudes."""
    spectrum = amplitude_spectrum(run.output, SAMPLE_RATE, Window.FLAT_TOP)
    return spectrum.frequency, spectrum.amplitude


def _names(inside: Axes, outside: Axes, evidence: Evidence) -> None:
    """Name the natural modes and the limit cycle."""
    for axes in (inside, outside):
        frequency = evidence.numbers.modes[1].frequency
        top = axes.get_ylim()[1]
        axes.annotate(
            f"{frequency:.1f} Hz", (frequency, 0.9 * top), (-4, 0), textcoords="offset points", ha="right"
        )
    third = evidence.numbers.modes[2].frequency
    inside.annotate(f"{third:.0f} Hz", (third, 0.0145), ha="center")
    cycle = evidence.motion.released.released(GAP, FORCES_OF_FIGURE[0], OUTSIDE)
    outside.annotate(f"limit cycle,\n{cycle.frequency:.0f} Hz", (cycle.frequency, 4.5), ha="center")


def closed_loop_for_four_gaps(evidence: Evidence) -> Figure:
    """Draw the settled output for four gaps (thesis, figure E.1)."""
    runs = evidence.motion.released.appendix
    with style():
        figure = new_figure(5.2)
        for axes, run in zip(figure.subplots(len(runs), 1, sharex=True, sharey=True), runs, strict=True):
            shown = run.times > run.times[-1] - LAST
            times = 1e3 * (run.times[shown] - run.times[shown][0])
            axes.plot(times, 1e3 * run.output[shown], **LINES[0].keywords)
            for side in (-1, 1):
                axes.axhline(1e3 * side * run.amplitude, **_MODE)
            axes.set_title(
                f"$b$ = {1e3 * run.gap:g} mm: amplitude {1e3 * run.amplitude:.3f} mm, {run.frequency:.2f} Hz",
                loc="left",
            )
            axes.set_ylabel("$q_2 - q_4$ [mm]")
        axes.set(xlabel="time [ms]", xlim=(0, 1e3 * LAST), ylim=(-5.8, 5.8))
    return figure
