"""The analysis of one signal: spectrum, harmonics and classified peaks, collected in one record."""

from __future__ import annotations

import warnings
from collections.abc import Sequence
from dataclasses import dataclass

from trimmer.errors import SignalWarning
from trimmer.signals.signal import Signal
from trimmer.spectra.classification import ClassifiedPeak, classify, fundamentals
from trimmer.spectra.doubts import doubts
from trimmer.spectra.harmonics import HarmonicFit, fit_harmonics
from trimmer.spectra.peaks import peaks
from trimmer.spectra.spectrum import Spectrum, amplitude_spectrum
from trimmer.spectra.window import Window

USUAL_LIMIT = 20
"""Number of peaks that are kept if none is given."""


@dataclass(frozen=True, eq=False)
class SpectrumAnalysis:
    """Spectrum of a signal, harmonics of its drive (None without one), and peaks by falling amplitude.

    ``doubts`` says in sentences without a full stop what makes it doubtful.
    """

    signal: Signal
    spectrum: Spectrum
    harmonics: HarmonicFit | None
    peaks: tuple[ClassifiedPeak, ...]
    doubts: tuple[str, ...] = ()


def analyse_signal(
    signal: Signal,
    drive: float | None = None,
    natural_frequencies: Sequence[float] = (),
    limit_cycles: Sequence[float] = (),
    window: Window | str = Window.HANN,
    limit: int = USUAL_LIMIT,
) -> SpectrumAnalysis:
    """Compute the spectrum of a signal, find its peaks and say what they may be.

    Args:
        signal: The signal.
        drive: Frequency of the drive, Hz; None without one.
        natural_frequencies: Frequencies of the natural modes, Hz.
        limit_cycles: Frequencies of the limit cycles, Hz.
        window: Window function of the spectrum, a member or its word, such as ``hann``.
        limit: Number of peaks, the largest.

    Warns:
        SignalWarning: if many samples have the extreme value, as in a clipped record; or if the record is too
            short to tell the harmonics of the drive, or what peaks may be, from one another.

    Raises:
        ChoiceError: if there is no such window.
        SignalError: see ``amplitude_spectrum``, ``fit_harmonics``, ``peaks`` and ``classify``.
    """
    spectrum = amplitude_spectrum(signal.values, signal.sample_rate, window)
    origins = fundamentals(drive, natural_frequencies, limit_cycles)
    doubtful = doubts(signal.values, spectrum, drive, origins)
    for doubt in doubtful:
        warnings.warn(doubt, SignalWarning, stacklevel=2)
    return SpectrumAnalysis(
        signal=signal,
        spectrum=spectrum,
        harmonics=None if drive is None else _harmonics(signal, drive),
        peaks=classify(peaks(spectrum, limit), spectrum.bin_width, drive, natural_frequencies, limit_cycles),
        doubts=doubtful,
    )


def _harmonics(signal: Signal, drive: float) -> HarmonicFit:
    """Fit the harmonics so that other lines, which are what is looked for, hardly leak into them."""
    return fit_harmonics(signal.values, signal.sample_rate, drive, window=Window.HANN)
