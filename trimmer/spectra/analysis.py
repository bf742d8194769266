"""The analysis of one signal: spectrum, harmonics and classified peaks, collected in one record."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass

from trimmer.signals.signal import Signal
from trimmer.spectra.classification import ClassifiedPeak, classify
from trimmer.spectra.harmonics import HarmonicFit, fit_harmonics
from trimmer.spectra.peaks import peaks
from trimmer.spectra.spectrum import Spectrum, amplitude_spectrum
from trimmer.spectra.window import Window

USUAL_LIMIT = 20
"""Number of peaks that are kept if none is given."""


@dataclass(frozen=True, eq=False)
class SpectrumAnalysis:
    """Results of the analysis of a signal.

    Attributes:
        signal: The signal.
        spectrum: Its amplitude spectrum, in its unit.
        harmonics: Harmonics of its drive; None without one.
        peaks: Peaks by falling amplitude, each with what it may be.
    """

    signal: Signal
    spectrum: Spectrum
    harmonics: HarmonicFit | None
    peaks: tuple[ClassifiedPeak, ...]


def analyse_signal(
    signal: Signal,
    drive: float | None = None,
    natural_frequencies: Sequence[float] = (),
    limit_cycles: Sequence[float] = (),
    window: Window = Window.HANN,
    limit: int = USUAL_LIMIT,
) -> SpectrumAnalysis:
    """Compute the spectrum of a signal, find its peaks and say what they may be.

    Args:
        signal: The signal.
        drive: Frequency of the drive, Hz; None without one.
        natural_frequencies: Frequencies of the natural modes, Hz.
        limit_cycles: Frequencies of the limit cycles, Hz.
        window: Window function of the spectrum.
        limit: Number of peaks, the largest.

    Raises:
        SignalError: see ``amplitude_spectrum``, ``fit_harmonics``, ``peaks`` and ``classify``.
    """
    spectrum = amplitude_spectrum(signal.values, signal.sample_rate, window)
    return SpectrumAnalysis(
        signal=signal,
        spectrum=spectrum,
        harmonics=None if drive is None else _harmonics(signal, drive),
        peaks=classify(peaks(spectrum, limit), spectrum.bin_width, drive, natural_frequencies, limit_cycles),
    )


def _harmonics(signal: Signal, drive: float) -> HarmonicFit:
    """Fit the harmonics so that other lines, which are what is looked for, hardly leak into them."""
    return fit_harmonics(signal.values, signal.sample_rate, drive, window=Window.HANN)
