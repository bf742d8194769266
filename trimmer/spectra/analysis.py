"""The analysis of one signal: spectrum, harmonics and classified peaks, collected in one record."""

import warnings
from collections.abc import Sequence
from dataclasses import dataclass, replace
from operator import attrgetter

from trimmer.arguments import real_number, require_instance, truth_value
from trimmer.errors import SignalWarning
from trimmer.showing.drawn import Drawn
from trimmer.showing.shown import Tabular, counted
from trimmer.showing.table import Column, Table
from trimmer.signals.band import EVERYWHERE
from trimmer.signals.signal import Signal
from trimmer.spectra.classification import (
    OPEN_LOOP,
    ClassifiedPeak,
    classify,
    frequencies_of,
    fundamentals,
    require_positive,
)
from trimmer.spectra.doubts import band_doubts, crowding_doubts, doubts, unsteady_doubts
from trimmer.spectra.harmonics import HarmonicFit, fit_harmonics
from trimmer.spectra.peaks import Peak, peaks
from trimmer.spectra.spectrum import Spectrum, amplitude_spectrum
from trimmer.spectra.window import Window

USUAL_LIMIT = 20  # Number of peaks that are kept if none is given


@dataclass(frozen=True, eq=False, repr=False)
class SpectrumAnalysis(Tabular, Drawn):
    """Results of the analysis of a signal.

    ``plot`` draws the spectrum up to a little above its highest peak, with what each peak may be.

    Attributes:
        signal: The signal.
        spectrum: Its amplitude spectrum, in its unit.
        harmonics: Harmonics of its drive; None without one.
        peaks: Peaks by falling amplitude, each with what it may be.
        doubts: What makes it doubtful, in sentences without a full stop.
        notes: What is left out and why, in sentences without a full stop.
    """

    signal: Signal
    spectrum: Spectrum
    harmonics: HarmonicFit | None
    peaks: tuple[ClassifiedPeak, ...]
    doubts: tuple[str, ...] = ()
    notes: tuple[str, ...] = ()

    def _told(self) -> str:
        known = sum(each.explanation is not None for each in self.peaks)
        peaks = f"{counted(len(self.peaks), 'peak')}, {known} explained"
        return f"{self.signal.heading}: {peaks}, bins {self.spectrum.bin_width:.6g} Hz apart"

    def _table(self) -> Table:
        unit = self.signal.unit
        of_peak = {"frequency": "Hz", "amplitude": unit, "phase": "rad"}
        of_peak |= {"frequency_uncertainty": "Hz", "amplitude_uncertainty": unit}
        columns = (
            *(Column(name, unit, attrgetter(f"peak.{name}")) for name, unit in of_peak.items()),
            Column("explanation", "", lambda each: each.explanation and each.explanation.origin.label),
            Column("distance_bins", "", lambda each: each.explanation and each.explanation.distance),
            Column("ambiguous", "", attrgetter("ambiguous")),
            Column("resolved", "", attrgetter("peak.resolved")),
        )
        return Table("Peaks by amplitude", self.peaks, columns)


def analyse_signal(
    signal: Signal,
    drive_frequency: float | None = None,
    natural_frequencies: Sequence[float] = (),
    limit_cycle_frequencies: Sequence[float] = (),
    window: Window | str = Window.HANN,
    limit: int = USUAL_LIMIT,
    *,
    closed_loop: bool = False,
) -> SpectrumAnalysis:
    """Compute the spectrum of a signal, find its peaks and say what they may be.

    Args:
        signal: The signal.
        drive_frequency: Frequency of the drive, Hz; None without one.
        natural_frequencies: Frequencies of the natural modes, Hz.
        limit_cycle_frequencies: Frequencies of the limit cycles, Hz. With a drive they are no candidates,
            unless the loop is closed.
        window: Window function of the spectrum, a member or its word, such as ``hann``.
        limit: Number of peaks, the largest.
        closed_loop: Whether the pin follows the output although there is a drive.

    Warns:
        SignalWarning: if the record has a fault, such as clipping, or peaks where it is not to be trusted; if
            it is too short to tell the harmonics of the drive, or what peaks may be, from one another; if no
            steady sine explains a peak; or if more peaks are close to each other than are fitted together.

    Raises:
        ChoiceError: if there is no such window.
        SignalError: see ``amplitude_spectrum``, ``fit_harmonics``, ``peaks`` and ``classify``.
        WrongTypeError: if an argument is of another type.
    """
    require_instance("signal", signal, Signal, "a trimmer.Signal")
    predicted = frequencies_of("limit_cycle_frequencies", limit_cycle_frequencies)
    known = frequencies_of("natural_frequencies", natural_frequencies)
    if drive_frequency is not None:
        drive_frequency = real_number("drive_frequency", drive_frequency, "Hz")
        require_positive("frequency of the drive", drive_frequency)
    closed_loop = truth_value("closed_loop", closed_loop)
    left_out = drive_frequency is not None and not closed_loop and len(predicted) > 0
    spectrum = replace(amplitude_spectrum(signal.values, signal.sample_rate, window), colour=signal.converted)
    origins = fundamentals(drive_frequency, known, () if left_out else predicted)
    found = _trusted_peaks(signal, spectrum, limit)
    doubtful = (
        *doubts(signal, spectrum, drive_frequency, origins),
        *band_doubts(signal.trusted, found),
        *unsteady_doubts(found),
        *crowding_doubts(spectrum, found),
    )
    for doubt in doubtful:
        warnings.warn(doubt, SignalWarning, stacklevel=2)
    return SpectrumAnalysis(
        signal=signal,
        spectrum=spectrum,
        harmonics=None if drive_frequency is None else _harmonics(signal, drive_frequency),
        peaks=classify(
            found,
            spectrum.bin_width,
            drive_frequency,
            natural_frequencies,
            limit_cycle_frequencies,
            closed_loop=closed_loop,
        ),
        doubts=doubtful,
        notes=(OPEN_LOOP,) if left_out else (),
    )


def _trusted_peaks(signal: Signal, spectrum: Spectrum, limit: int) -> tuple[Peak, ...]:
    """Find peaks; of a converted signal none outside its band, in whose flanks parts of lines are left."""
    return peaks(spectrum, limit, band=signal.trusted if signal.converted else EVERYWHERE)


def _harmonics(signal: Signal, drive_frequency: float) -> HarmonicFit:
    """Fit the harmonics so that other lines, which are what is looked for, hardly leak into them."""
    return fit_harmonics(signal.values, signal.sample_rate, drive_frequency, window=Window.HANN)
