"""An averaged spectrum as text and as JSON."""

from __future__ import annotations

from collections.abc import Iterator
from typing import TYPE_CHECKING, Any

from trimmer.command_line.json_values import picked
from trimmer.command_line.signals.recording_text import wrapped
from trimmer.command_line.table import table
from trimmer.showing.shown import counted

if TYPE_CHECKING:
    from trimmer.spectra.averaged import AveragedSpectrum

_LINES = 20


def averaged_text(averaged: AveragedSpectrum, unit: str) -> Iterator[str]:
    """Tell how was averaged, and list the lines: Hz, amplitudes in the unit of the signal."""
    low, high = averaged.interval
    spectra = "1 spectrum" if averaged.averages == 1 else f"{averaged.averages} spectra"
    yield (f"Average of {spectra} (Welch), segments of {averaged.segment} samples that overlap by half")
    told = [
        f"bins {averaged.bin_width:.6g} Hz apart, noise bandwidth {averaged.noise_bandwidth:.6g} Hz "
        f"({averaged.window.word} window): lines closer than {averaged.resolution:.4g} Hz show as one",
        f"noise scatters as in {averaged.equivalent_averages:.3g} independent spectra: its density is "
        f"{low:.3g} to {high:.3g} times what is shown (95 %)",
    ]
    if averaged.left_out:
        left = counted(averaged.left_out, "sample")
        are = "is" if averaged.left_out == 1 else "are"
        told.append(f"{left} {are} in stretches shorter than a segment and {are} left out")
    for sentence in told:
        yield from wrapped(sentence, "  ", "  ")
    amplitude = f"amplitude, {unit}" if unit else "amplitude"
    rows = [
        (
            f"{line.frequency:.6g}",
            f"{line.amplitude:.6g}",
            f"{line.interval[0]:.6g} to {line.interval[1]:.6g}",
        )
        for line in averaged.lines(_LINES)
    ]
    yield from table(("Hz", amplitude, "95 %, a steady sine in noise"), rows)


def averaged_json(averaged: AveragedSpectrum) -> dict[str, Any]:
    """Describe an averaged spectrum for JSON: Hz, the unit of the signal."""
    how = ("window", "segment", "averages", "equivalent_averages", "left_out", "bin_width")
    return {
        **picked(averaged, *how, "noise_bandwidth", "resolution"),
        "density_interval": averaged.interval,
        "lines": [vars(line) for line in averaged.lines(_LINES)],
        "frequencies": averaged.frequency,
        "densities": averaged.density,
    }
