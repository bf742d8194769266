"""The picture of a measured motion over a simulated one: spectra, and waveforms over a period."""

from __future__ import annotations

from typing import TYPE_CHECKING

import numpy as np
from matplotlib.figure import Figure

from trimmer.drawing.content import content_of
from trimmer.spectra.spectrum import amplitude_spectrum

if TYPE_CHECKING:
    from matplotlib.axes import Axes

    from trimmer.spectra.comparison import Comparison

_SIZE = (6.4, 6.4)
_POINTS = 4000
_SAMPLES = 2000
_MEASURED, _SIMULATED = "0.45", "C3"


def draw_comparison(comparison: Comparison, file_format: str) -> bytes:
    """Draw spectra over each other and waveforms aligned in time, and return the content of the file.

    Args:
        comparison: The two motions.
        file_format: ``svg``, ``png`` or ``pdf``.
    """
    figure = Figure(figsize=_SIZE, layout="constrained")
    above, below = figure.subplots(2, 1)
    _draw_spectra(above, comparison)
    _draw_waveforms(below, comparison)
    return content_of(figure, file_format)


def _draw_spectra(axes: Axes, comparison: Comparison) -> None:
    signal = comparison.signal
    spectrum = amplitude_spectrum(signal.values, signal.sample_rate)
    last = min(spectrum.frequency.size - 1, int(1.1 * comparison.frequencies[-1] / spectrum.bin_width) + 8)
    block = -(-last // _POINTS)
    begins = np.arange(1, last + 1, block)
    tops = np.maximum.reduceat(spectrum.amplitude[: last + 1], begins)
    axes.semilogy(spectrum.frequency[begins], tops, color=_MEASURED, linewidth=0.9, label="measured")
    axes.semilogy(
        comparison.frequencies, np.abs(comparison.measured), "o", color="k", markersize=4, label="its lines"
    )
    axes.semilogy(
        comparison.frequencies,
        np.abs(comparison.simulated),
        "x",
        color=_SIMULATED,
        markersize=6,
        label="simulated lines",
    )
    axes.set_ylim(bottom=max(0.3 * float(np.median(tops)), 1e-7 * float(tops.max()) or 1e-30))
    axes.set_xlabel("frequency, Hz")
    axes.set_ylabel(f"amplitude, {signal.unit}")
    axes.grid(alpha=0.3)
    axes.legend(fontsize="small")


def _draw_waveforms(axes: Axes, comparison: Comparison) -> None:
    signal = comparison.signal
    times, measured, simulated = comparison.waveforms()
    places = np.linspace(0, signal.values.size - 1, min(_SAMPLES, signal.values.size)).astype(int)
    folded = np.mod(places / signal.sample_rate, comparison.period)
    mean = float(signal.values.mean())
    axes.plot(1e3 * folded, signal.values[places] - mean, ".", color="0.75", markersize=2, label="samples")
    axes.plot(1e3 * times, measured, color="k", linewidth=1.2, label="measured lines")
    axes.plot(1e3 * times, simulated, "--", color=_SIMULATED, linewidth=1.4, label="simulated, shifted")
    axes.set_xlabel("time in the period, ms")
    axes.set_ylabel(f"{signal.quantity.word} about its mean, {signal.unit}")
    axes.set_title(
        f"shifted by {1e3 * comparison.shift:.4g} ms; difference {100 * comparison.residual:.3g} % rms",
        fontsize="small",
    )
    axes.grid(alpha=0.3)
    axes.legend(fontsize="small")
