"""The pictures of spectra: amplitude over frequency, with peaks and what they may be; harmonics."""

from collections.abc import Sequence
from typing import Any

import numpy as np
from matplotlib.axes import Axes

from trimmer.arrays import Reals
from trimmer.drawing.axes import add_legend, label
from trimmer.drawing.dispatch import draw
from trimmer.drawing.look import BLACK, colour
from trimmer.spectra.analysis import SpectrumAnalysis
from trimmer.spectra.averaged import AveragedSpectrum
from trimmer.spectra.classification import (
    ClassifiedPeak,
    DriveFraction,
    Harmonic,
    LimitCycleLine,
    MainsHum,
    NaturalMode,
    OwnMultiple,
)
from trimmer.spectra.harmonics import HarmonicFit
from trimmer.spectra.peaks import Peak
from trimmer.spectra.spectrum import Spectrum

POINTS = 4000
LABELLED = 6  # Peaks with their frequency written beside them, the largest
APART = 0.06  # Share of the axes' width by which two such peaks must be apart, lest their texts overlap
DYNAMIC_RANGE = 1e-7
MARKERS = {
    Harmonic: ("o", "harmonic of the drive"),
    NaturalMode: ("s", "natural mode"),
    LimitCycleLine: ("^", "limit cycle"),
    type(None): ("x", "unexplained"),
    DriveFraction: ("D", "fraction of the drive"),
    OwnMultiple: ("v", "multiple of its own frequency"),
    MainsHum: ("P", "hum of the mains"),
}


@draw.register(Spectrum)
def draw_spectrum(spectrum: Spectrum, axes: Axes, unit: str = "", highest: float = np.inf) -> None:
    """Draw the amplitude over frequency, Hz, a little further than the highest."""
    axes.semilogy(*outline(spectrum, highest), linewidth=0.9, color="0.4")
    label(axes, "frequency, Hz", f"amplitude, {unit}" if unit else "amplitude")
    axes.set_title(f"{spectrum.window.word} window, bins {spectrum.bin_width:.4g} Hz apart", fontsize="small")


@draw.register(SpectrumAnalysis)
def draw_analysis(analysis: SpectrumAnalysis, axes: Axes) -> None:
    """Draw a spectrum with its peaks, marked by their best explanation."""
    highest = max((each.peak.frequency for each in analysis.peaks), default=np.inf)
    draw_spectrum(analysis.spectrum, axes, analysis.signal.unit, highest)
    axes.margins(x=0.01, y=0.12)
    for number, (kind, (marker, meaning)) in enumerate(MARKERS.items()):
        found = [each.peak for each in analysis.peaks if type(_origin(each)) is kind]
        if found:
            places = [peak.frequency for peak in found], [peak.amplitude for peak in found]
            axes.plot(*places, marker, linestyle="none", color=colour(number), label=meaning)
    _mark_unsteady(axes, [each.peak for each in analysis.peaks if not each.peak.resolved])
    _write_frequencies(axes, analysis)
    add_legend(axes)


def _mark_unsteady(axes: Axes, peaks: Sequence[Peak]) -> None:
    """Draw how wide the frequencies are that no single steady sine explains, Hz."""
    if peaks:
        places, wide = [peak.frequency for peak in peaks], [peak.frequency_uncertainty for peak in peaks]
        axes.errorbar(
            places,
            [peak.amplitude for peak in peaks],
            xerr=wide,
            fmt="none",
            ecolor=BLACK,
            elinewidth=1.0,
            capsize=3.0,
            label="no single steady sine",
        )


def _write_frequencies(axes: Axes, analysis: SpectrumAnalysis) -> None:
    """Write the frequency, Hz, above the largest peaks that are far enough apart."""
    low, high = axes.get_xlim()
    written: list[float] = []
    for classified in analysis.peaks:
        place = classified.peak.frequency, classified.peak.amplitude
        near = any(abs(place[0] - other) < APART * (high - low) for other in written)
        if len(written) < LABELLED and not near:
            written.append(place[0])
            look: dict[str, Any] = {"fontsize": "x-small", "ha": "center", "textcoords": "offset points"}
            axes.annotate(f"{place[0]:.6g}", place, (0, 7), **look)


def _origin(classified: ClassifiedPeak) -> object:
    return classified.explanation.origin if classified.explanation else None


@draw.register(HarmonicFit)
def draw_harmonics(fit: HarmonicFit, axes: Axes) -> None:
    """Draw the amplitude of each harmonic over its order."""
    orders, amplitudes = np.array(fit.orders), fit.amplitudes
    floor = DYNAMIC_RANGE * (float(amplitudes.max()) or 1.0)
    seen = amplitudes > floor
    axes.set_yscale("log")
    axes.vlines(orders[seen], floor, amplitudes[seen], color=colour(0), linewidth=1.2)
    axes.plot(orders[seen], amplitudes[seen], "o", color=BLACK, markersize=4, linestyle="none")
    label(axes, f"order of the drive, {fit.frequency:.6g} Hz", "amplitude, unit of the signal")
    axes.locator_params(axis="x", integer=True)


@draw.register(AveragedSpectrum)
def draw_averaged(spectrum: AveragedSpectrum, axes: Axes) -> None:
    """Draw the power density over frequency, with its confidence."""
    frequency, density = spectrum.frequency[1:], spectrum.density[1:]
    low, high = (factor * density for factor in spectrum.interval)
    axes.fill_between(frequency, low, high, color="0.85", linewidth=0, label="interval of 95 %, of noise")
    axes.semilogy(frequency, density, color=colour(0), linewidth=0.9, label="density")
    label(axes, "frequency, Hz", "density, unit² of the signal/Hz")


def outline(spectrum: Spectrum, highest_peak: float) -> tuple[Reals, Reals]:
    """Return frequency, Hz, and amplitude of at most ``POINTS`` points, largest of each block of bins."""
    drawn = slice(1, _last_bin(spectrum, highest_peak) + 1)
    frequency, amplitude = spectrum.frequency[drawn], spectrum.amplitude[drawn]
    amplitude = np.maximum(amplitude, DYNAMIC_RANGE * (float(amplitude.max()) or 1.0))
    block = -(-amplitude.size // POINTS)
    begins = np.arange(0, amplitude.size, block)
    return np.asarray(frequency[begins]), np.asarray(np.maximum.reduceat(amplitude, begins))


def _last_bin(spectrum: Spectrum, highest_peak: float) -> int:
    whole = spectrum.frequency.size - 1
    return whole if np.isinf(highest_peak) else min(whole, int(1.25 * highest_peak / spectrum.bin_width) + 8)
