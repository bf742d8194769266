"""The spectrum of a signal as text for people and as JSON for machines."""

import math
from collections.abc import Iterable, Iterator, Mapping
from dataclasses import dataclass
from pathlib import Path
from types import MappingProxyType
from typing import Any

import numpy as np

from trimmer.command_line.json_values import document, picked
from trimmer.command_line.signals.averaged_text import averaged_json, averaged_text
from trimmer.command_line.signals.overlay_text import line_json, line_rows
from trimmer.command_line.signals.recording_text import notes_of, recording_json, signal_json, wrapped
from trimmer.command_line.signals.signal_options import ChosenRecording
from trimmer.command_line.table import table
from trimmer.motion.units import with_unit
from trimmer.showing.shown import counted
from trimmer.signals.wav import WavFile
from trimmer.spectra import AveragedSpectrum, HarmonicFit, MotionComparison, SpectrumAnalysis
from trimmer.spectra.classification import (
    MODEL_TOLERANCE,
    TOLERANCE_BINS,
    ClassifiedPeak,
    DriveFraction,
    Harmonic,
    LimitCycleLine,
    MainsHum,
    Match,
    NaturalMode,
    Origin,
    OwnMultiple,
)

LEVELS: Mapping[str, float] = MappingProxyType({"m/s²": 1e-6, "m/s": 1e-9, "m": 1e-12})
"""Reference rms of the level of a vibration, by its unit: ISO 1683:2015."""
_KINDS: Mapping[type[Origin], str] = MappingProxyType(
    {
        Harmonic: "harmonic",
        DriveFraction: "fraction of the drive",
        NaturalMode: "natural mode",
        LimitCycleLine: "limit cycle",
        OwnMultiple: "multiple of its own frequency",
        MainsHum: "hum of the mains",
    }
)
_SMALLEST_HARMONIC = 1e-4
"""Harmonics that are a smaller part of the largest are left out of the table; JSON has them all."""


@dataclass(frozen=True)
class PredictedFrequencies:
    """Frequencies that the model predicts."""

    source: str  # Name of the trimmer: that of the thesis, or a parameter file
    # Frequencies of the natural modes, Hz; 0 for an overdamped one; None of a measured response
    natural_frequencies: tuple[float, ...] | None
    element: str | None  # What closes the loop, in words; None if no limit cycles were asked for
    limit_cycles: tuple[float, ...]  # Frequencies of the stable limit cycles, Hz
    # That with which a mechanism without a drive repeats, in the measurement, Hz
    own_frequency: float | None = None


@dataclass(frozen=True)
class ShownSignal:
    """What is shown of a signal."""

    file: Path  # Name of its file
    analysis: SpectrumAnalysis  # Its spectrum
    predictions: PredictedFrequencies  # Frequencies that the model predicts
    chosen: ChosenRecording  # Its recording, and what is wrong with it
    averaged: AveragedSpectrum | None  # Averaged spectrum of all stretches; None if it was not asked for
    wav: WavFile | None  # What was written as sound; None if nothing was
    against: MotionComparison | None = None  # It beside the motion of a mechanism; None without one


def as_text(shown: ShownSignal) -> str:
    """Return spectrum, harmonics and peaks as short tables: Hz, degrees, the unit of the signal."""
    analysis, predictions = shown.analysis, shown.predictions
    sections = [list(_head(shown))]
    if analysis.harmonics is not None:
        sections.append(list(_harmonics(analysis.harmonics, analysis.signal.unit)))
    sections.append(list(_peaks(analysis)))
    if shown.averaged is not None:
        sections.append(list(averaged_text(shown.averaged, analysis.signal.unit)))
    sections.append(list(_candidates(analysis, predictions)))
    if shown.against is not None:
        sections.append(list(line_rows(shown.against)))
    if shown.wav is not None:
        sections.append([_wav_line(shown.wav, analysis)])
    return "\n\n".join("\n".join(lines) for lines in sections)


def as_json(shown: ShownSignal) -> str:
    """Return spectrum, harmonics and peaks as JSON: full precision, Hz, rad, the unit of the signal.

    Phases are those of cosines.
    """
    analysis, predictions, wav = shown.analysis, shown.predictions, shown.wav
    spectrum, fit = analysis.spectrum, analysis.harmonics
    content = {
        "file": shown.file,
        "signal": signal_json(analysis.signal),
        **recording_json(shown.chosen),
        "spectrum": picked(spectrum, "window", "bin_width", "mean"),
        "harmonics": None if fit is None else _fit(fit),
        "natural_frequencies": predictions.natural_frequencies,
        "limit_cycles": None if predictions.element is None else predictions.limit_cycles,
        "limit_cycle_frequencies": None if predictions.element is None else predictions.limit_cycles,
        "peaks": [_peak(classified, analysis) for classified in analysis.peaks],
        "against": None if shown.against is None else _against(shown.against),
        "averaged": None if shown.averaged is None else averaged_json(shown.averaged),
        "notes": [*notes_of(shown.chosen, analysis.signal, analysis.doubts), *analysis.notes],
        "wav": None if wav is None else vars(wav) | {"bit_depth": wav.bit_depth.value},
    }
    return document(content)


def _head(shown: ShownSignal) -> Iterator[str]:
    signal, spectrum = shown.analysis.signal, shown.analysis.spectrum
    yield (
        f"{signal.heading} of {shown.file}: {signal.values.size} samples at {signal.sample_rate:.9g} Hz, "
        f"{signal.duration:.6g} s"
    )
    yield (
        f"bins {spectrum.bin_width:.6g} Hz apart, {spectrum.window.word} window, mean {spectrum.mean:.6g} "
        "taken off"
    )
    if signal.interpolated:
        were = "was missing and is" if signal.interpolated == 1 else "were missing and are"
        yield f"{counted(signal.interpolated, 'sample')} {were} interpolated"
    for note in notes_of(shown.chosen, signal, shown.analysis.doubts):
        yield from wrapped(f"note: {note}", "", "  ")


def _harmonics(fit: HarmonicFit, unit: str) -> Iterator[str]:
    largest = float(fit.amplitudes.max())
    rows = [
        (str(order), f"{order * fit.frequency:.6g}", f"{amplitude:.6g}", f"{np.angle(c, deg=True):.1f}")
        for order, amplitude, c in zip(fit.orders, fit.amplitudes, fit.coefficients, strict=True)
        if amplitude > _SMALLEST_HARMONIC * largest
    ]
    yield f"Harmonics of the drive at {fit.frequency:.9g} Hz, by least squares with Hann weights"
    yield from table(("order", "Hz", with_unit("amplitude", unit), "phase, deg"), rows)
    yield f"  they explain {100 * fit.explained:.4g} % of the variance; {fit.residual:.3g} rms is left"


def _peaks(analysis: SpectrumAnalysis) -> Iterator[str]:
    amplitude = with_unit("amplitude", analysis.signal.unit)
    reference, drive = LEVELS.get(analysis.signal.unit), analysis.harmonics
    level = () if reference is None else (f"dB re {reference:g} {analysis.signal.unit}",)
    order = () if drive is None else ("order",)
    heads = ("Hz", *order, "+/-", amplitude, "+/-", *level, "may be", "bins off", "or also", "bins off")
    rows = [
        (
            f"{classified.peak.frequency:.6g}",
            *([] if drive is None else [f"{classified.peak.frequency / drive.frequency:.4g}"]),
            f"{classified.peak.frequency_uncertainty:.2g}",
            f"{classified.peak.amplitude:.6g}",
            f"{classified.peak.amplitude_uncertainty:.2g}",
            *([] if reference is None else [f"{_level(classified.peak.amplitude, reference):.1f}"]),
            *_match_cells(classified.explanation, "unexplained"),
            *_second_cells(classified),
        )
        for classified in analysis.peaks
    ]
    yield "Peaks, placed between bins, with standard deviations as in white noise, by amplitude"
    yield from table(heads, rows)


def _level(amplitude: float, reference: float) -> float:
    """Return the level of a line, dB: of its rms over a reference."""
    return 20.0 * math.log10(amplitude / math.sqrt(2.0) / reference) if amplitude > 0 else -math.inf


def _candidates(analysis: SpectrumAnalysis, predictions: PredictedFrequencies) -> Iterator[str]:
    yield "Candidates"
    if analysis.harmonics is not None:
        yield f"  harmonics of {analysis.harmonics.frequency:.9g} Hz"
    if predictions.natural_frequencies is not None:
        listed = _listed(frequency for frequency in predictions.natural_frequencies if frequency > 0)
        yield f"  natural modes of {predictions.source}: {listed}"
    if predictions.element is not None:
        listed = _listed(predictions.limit_cycles)
        yield f"  stable limit cycles with {predictions.element} (harmonic balance): {listed}"
    if predictions.own_frequency is not None:
        yield f"  multiples of {predictions.own_frequency:.9g} Hz, with which the mechanism repeats by itself"
    yield (
        f"  a peak may be what is within {TOLERANCE_BINS:g} bin of it, or {100 * MODEL_TOLERANCE:g} % for "
        "modes and limit cycles"
    )
    for note in analysis.notes:
        yield from wrapped(note, "  ", "  ")


def _wav_line(wav: WavFile, analysis: SpectrumAnalysis) -> str:
    rate = analysis.signal.sample_rate
    resampled = "" if rate == wav.sample_rate else f", resampled from {rate:.9g} Hz"
    full_scale = f"{wav.full_scale:.6g} {analysis.signal.unit}".rstrip()
    return (
        f"Sound: {wav.samples} samples at {wav.sample_rate} Hz{resampled}, {wav.bit_depth.value} bits; "
        f"full scale is {full_scale}"
    )


def _against(comparison: MotionComparison) -> dict[str, Any]:
    return {
        **picked(comparison, "period_count", "simulated_frequency"),
        "lines": [line_json(comparison, place) for place in range(comparison.measured.size)],
    }


def _fit(fit: HarmonicFit) -> dict[str, Any]:
    return {
        "drive": fit.frequency,
        **picked(fit, "frequency", "amplitudes"),
        "phases": np.angle(fit.coefficients),
        **picked(fit, "residual", "explained"),
    }


def _peak(classified: ClassifiedPeak, analysis: SpectrumAnalysis) -> dict[str, Any]:
    explanation, peak = classified.explanation, classified.peak
    reference, drive = LEVELS.get(analysis.signal.unit), analysis.harmonics
    return {
        **vars(peak),
        "order": None if drive is None else peak.frequency / drive.frequency,
        "level": None if reference is None else _level(peak.amplitude, reference),
        "explanation": None if explanation is None else _origin(explanation.origin),
        "ambiguous": classified.ambiguous,
        "candidates": [
            {
                **_origin(match.origin),
                "distance_bins": match.distance,
                "tolerance_bins": match.tolerance,
                "fits": match.fits,
            }
            for match in classified.candidates
        ],
    }


def _origin(origin: Origin) -> dict[str, Any]:
    odd = {"odd": origin.odd} if isinstance(origin, Harmonic) else {}
    return {"kind": _KINDS[type(origin)], **vars(origin), **odd}


def _match_cells(match: Match | None, otherwise: str) -> tuple[str, str]:
    return (
        (otherwise, "") if match is None else (match.origin.label, f"{round(match.distance, 2) + 0.0:+.2f}")
    )


def _second_cells(classified: ClassifiedPeak) -> tuple[str, str]:
    """Return the second explanation; for an unexplained peak the nearest candidate, though it is too far."""
    if classified.explanation is not None or not classified.candidates:
        return _match_cells(classified.second, "")
    label, distance = _match_cells(min(classified.candidates, key=lambda match: abs(match.distance)), "")
    return f"nearest: {label}", distance


def _listed(frequencies: Iterable[float]) -> str:
    return ", ".join(f"{frequency:.6g} Hz" for frequency in frequencies) or "none"
