"""The picture of a spectrum: amplitude over frequency, with its peaks and what they may be."""

from __future__ import annotations

from typing import TYPE_CHECKING

import numpy as np
from matplotlib.figure import Figure

from trimmer.drawing.content import content_of
from trimmer.spectra.classification import ClassifiedPeak, Harmonic, LimitCycleLine, NaturalMode

if TYPE_CHECKING:
    from trimmer.arrays import Reals
    from trimmer.spectra.analysis import SpectrumAnalysis
    from trimmer.spectra.spectrum import Spectrum

_SIZE = (6.4, 4.0)
_POINTS = 4000
_LABELLED = 6
_DYNAMIC_RANGE = 1e-7
_MARKERS = {
    Harmonic: ("o", "harmonic of the drive"),
    NaturalMode: ("s", "natural mode"),
    LimitCycleLine: ("^", "limit cycle"),
    type(None): ("x", "unexplained"),
}


def draw_spectrum(analysis: SpectrumAnalysis, file_format: str) -> bytes:
    """Draw a spectrum up to a little above its highest peak, and return the content of the file.

    Peaks are marked by their best explanation; the largest have their frequency, Hz, written beside them.

    Args:
        analysis: The spectrum and its classified peaks.
        file_format: ``svg``, ``png`` or ``pdf``.
    """
    figure = Figure(figsize=_SIZE, layout="constrained")
    axes = figure.add_subplot()
    frequency, amplitude = _outline(analysis)
    axes.semilogy(frequency, amplitude, linewidth=0.9, color="0.4")
    for kind, (marker, label) in _MARKERS.items():
        found = [classified.peak for classified in analysis.peaks if type(_origin(classified)) is kind]
        if found:
            heights = [peak.amplitude for peak in found]
            axes.plot([peak.frequency for peak in found], heights, marker, linestyle="none", label=label)
    for classified in analysis.peaks[:_LABELLED]:
        place = (classified.peak.frequency, classified.peak.amplitude)
        axes.annotate(f"{place[0]:.6g}", place, (4, 3), textcoords="offset points", fontsize="x-small")
    axes.set_xlabel("frequency, Hz")
    unit = analysis.signal.unit
    axes.set_ylabel(f"amplitude, {unit}" if unit else "amplitude", parse_math=False)
    axes.set_title(
        f"{analysis.spectrum.window.word} window, bins {analysis.spectrum.bin_width:.4g} Hz apart",
        fontsize="small",
    )
    axes.grid(alpha=0.3)
    if analysis.peaks:
        axes.legend(fontsize="small")
    return content_of(figure, file_format)


def _origin(classified: ClassifiedPeak) -> object:
    return classified.explanation.origin if classified.explanation else None


def _outline(analysis: SpectrumAnalysis) -> tuple[Reals, Reals]:
    """Return frequency, Hz, and amplitude of at most ``_POINTS`` points, largest of each block of bins."""
    spectrum = analysis.spectrum
    last = _last_bin(spectrum, max((each.peak.frequency for each in analysis.peaks), default=np.inf))
    frequency, amplitude = spectrum.frequency[1 : last + 1], spectrum.amplitude[1 : last + 1]
    amplitude = np.maximum(amplitude, _DYNAMIC_RANGE * (float(amplitude.max()) or 1.0))
    block = -(-amplitude.size // _POINTS)
    begins = np.arange(0, amplitude.size, block)
    return np.asarray(frequency[begins]), np.asarray(np.maximum.reduceat(amplitude, begins))


def _last_bin(spectrum: Spectrum, highest_peak: float) -> int:
    whole = spectrum.frequency.size - 1
    return whole if np.isinf(highest_peak) else min(whole, int(1.25 * highest_peak / spectrum.bin_width) + 8)
