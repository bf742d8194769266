"""Motion, contact force and spectrum of three settings in both models."""

import numpy as np
from matplotlib.axes import Axes
from matplotlib.figure import Figure

from report.data.figures import figure
from report.numbers.evidence import Evidence
from report.numbers.twin.cases import HIGHEST_ORDER, PHASES, SHOWN
from report.numbers.twin_numbers import BothModels
from report.pages.drawing.style import FAINT, LINES, panels

THINNED = 32
TOGETHER = 4
SMALLEST = 0.03  # Amplitude at which the spectra end, µm
NAMES = ("40 µm, 0.5 N", "0.2 mm, 0.5 N", "0.2 mm, 2 N")


def _cases(known: Evidence) -> tuple[BothModels, ...]:
    return known.twin.small, known.twin.experiment, known.twin.main


@figure("twin-motions")
def motions(known: Evidence) -> Figure:
    """Draw what is left of the stroke, and the force, over three periods."""
    time = np.arange(SHOWN * PHASES)[::THINNED] / PHASES
    drawn, rows = panels(4.6, 3, 2, sharex=True)
    for (stroke, force), case, name in zip(rows, _cases(known), NAMES, strict=True):
        frozen = case.repeated(case.frozen.stroke), case.repeated(case.frozen.tension)
        twin = case.twin.stretch.stroke, case.twin.stretch.tension
        for label, signals, line in zip(("thesis", "twin"), (frozen, twin), LINES, strict=False):
            stroke.plot(time, 1e3 * _without_first(signals[0])[::THINNED], label=label, **line)
            force.plot(time, signals[1][::THINNED], label=label, **line)
        stroke.set(ylabel="remainder [mm]", title=name)
        force.set(ylabel="force [N]", title=name)
    for axes in rows[-1]:
        axes.set_xlabel("drive periods")
    rows[0][1].legend(loc="upper right", ncols=2)
    rows[0][1].set_ylim(top=7)
    return drawn


def _without_first(signal: np.ndarray) -> np.ndarray:
    waves = np.fft.rfft(signal)
    waves[[0, SHOWN]] = 0
    return np.asarray(np.fft.irfft(waves, len(signal)))


@figure("twin-spectra")
def spectra(known: Evidence) -> Figure:
    """Draw the lines of all settings."""
    drawn, rows = panels(4.5, 3, 1, sharex=True)
    for axes, case, name in zip(rows, _cases(known), NAMES, strict=True):
        _lines(axes, case)
        axes.set(ylabel="amplitude [µm]", title=name, ylim=(SMALLEST, 5e3), xlim=(0, HIGHEST_ORDER))
        axes.set_xticks(range(HIGHEST_ORDER + 1))
    rows[0].legend(loc="upper right", ncols=2)
    rows[-1].set_xlabel("order of the drive")
    return drawn


def _highest(spectrum: np.ndarray) -> tuple[np.ndarray, np.ndarray]:
    """Return the highest of every ``TOGETHER`` bins and where it is, so that no line is lost."""
    bins = spectrum[: len(spectrum) // TOGETHER * TOGETHER].reshape(-1, TOGETHER, 2)
    highest = bins[np.arange(len(bins)), bins[:, :, 1].argmax(axis=1)]
    return highest[:, 0], highest[:, 1]


def _lines(axes: Axes, case: BothModels) -> None:
    orders, amplitudes = case.twin.lines.T
    seen = (1e6 * amplitudes > SMALLEST) & (orders <= HIGHEST_ORDER)
    axes.set_yscale("log")
    if len(case.twin.spectrum):
        places, heights = _highest(case.twin.spectrum[1:])
        axes.plot(places, 1e6 * heights, linewidth=0.7, color=LINES[1]["color"], label="twin")
    else:
        axes.vlines(orders[seen], SMALLEST, 1e6 * amplitudes[seen], color=LINES[1]["color"], label="twin")
    harmonics = 1e6 * case.frozen.harmonics[: HIGHEST_ORDER + 1]
    places = np.flatnonzero(harmonics > SMALLEST)
    places = places[places > 0]
    axes.plot(places, harmonics[places], "o", color=LINES[0]["color"], markersize=4, label="thesis")
    for order in (1 / 3, 2 / 3):
        axes.axvline(order, **FAINT)
