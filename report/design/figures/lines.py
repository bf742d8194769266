"""The lines of spectra, marked by what they are."""

from __future__ import annotations

from typing import TYPE_CHECKING, Literal

from report.design.quantities import scale_for
from report.pages.drawing.style import BLACK, panels
from trimmer.design.spectrum import LineKind
from trimmer.drawing.look import plain_label

if TYPE_CHECKING:
    from matplotlib.axes import Axes
    from matplotlib.figure import Figure

    from report.design.quantities import Scale
    from trimmer.design.spectrum import OutputSpectrum

MARKS = {
    LineKind.DRIVE: ("o", "#0072b2", "drive"),
    LineKind.HARMONIC: ("s", "#009e73", "harmonic of the drive"),
    LineKind.FRACTION: ("^", "#d55e00", "fraction of the drive"),
    LineKind.OWN: ("D", "#0072b2", "line of the motion itself"),
}


def line_spectrum(spectra: list[tuple[str, OutputSpectrum]]) -> Figure:
    """Draw the lines of one output, or of an output before and after a change.

    Args:
        spectra: What each is called, and its lines; names are empty for a single one.
    """
    figure, axes = panels(2.9)
    every = [line for _, each in spectra for line in each.lines]
    frequency = scale_for((line.frequency for line in every), "Hz")
    amplitude = scale_for((line.amplitude for line in every), "m")
    for number, (name, each) in enumerate(spectra):
        _stems(axes, each, frequency, amplitude, name, number)
    floor = min((line.amplitude for line in every), default=1.0) / amplitude.factor
    axes.set(yscale="log", xlabel=f"frequency [{frequency.unit}]", ylabel=f"amplitude [{amplitude.unit}]")
    axes.set_ylim(bottom=floor / 3)
    axes.set_xlim(left=0.0)
    axes.legend(loc="upper right")
    return figure


def _stems(
    axes: Axes, spectrum: OutputSpectrum, frequency: Scale, amplitude: Scale, name: str, number: int
) -> None:
    """Draw lines from the bottom; of a second spectrum dashed, with open marks."""
    for kind, (mark, colour, words) in MARKS.items():
        lines = [line for line in spectrum.lines if line.kind is kind]
        if not lines:
            continue
        places = [line.frequency / frequency.factor for line in lines]
        sizes = [line.amplitude / amplitude.factor for line in lines]
        bottom = min(line.amplitude for line in spectrum.lines) / amplitude.factor / 100
        style: Literal["dashed", "solid"] = "dashed" if number else "solid"
        axes.vlines(places, bottom, sizes, color=colour, linewidth=1.1, linestyles=style)
        label = f"{plain_label(name)}: {words}" if name else words
        face = "none" if number else colour
        axes.plot(
            places, sizes, mark, color=colour, markerfacecolor=face, linestyle="none", label=label,
            markersize=6 if number else 4.5, markeredgewidth=1.0 if number else 0.4,
            markeredgecolor=colour if number else BLACK,
        )  # fmt: skip
