"""Peaks of a spectrum, found between the bins."""

from __future__ import annotations

from dataclasses import dataclass
from typing import TYPE_CHECKING

import numpy as np

from trimmer.arguments import real_number, require_instance, whole_number
from trimmer.signals.signal import SignalError
from trimmer.spectra.noise import noise_threshold
from trimmer.spectra.spectrum import Spectrum

if TYPE_CHECKING:
    from trimmer.arrays import Complexes, Places, Reals

MOST_PEAKS = 200
"""Most peaks that are looked for, the largest; it bounds the time."""

_LARGEST_OFFSET = 0.75
_STEP = 1e-4
_FIRST_STEPS = 6
_BATCH = 0.3
_SWEEPS = 30
_SETTLED = 1e-12


@dataclass(frozen=True)
class Peak:
    """A peak of a spectrum, as the sine amplitude * cos(2 pi frequency t + phase) from the first sample on.

    Attributes:
        frequency: Frequency, Hz.
        amplitude: Amplitude, in the signal's unit.
        phase: Phase, rad, in (-pi, pi].
    """

    frequency: float
    amplitude: float
    phase: float


@dataclass(frozen=True, eq=False)
class _Lines:
    """Sines that add up to a spectrum: bin of each, place in bins, complex amplitude; shape (number,)."""

    bins: Places
    places: Reals
    amplitudes: Complexes


def peaks(
    spectrum: Spectrum,
    limit: int | None = None,
    smallest: float = 1e-4,
    false_alarm: float = 0.01,
) -> tuple[Peak, ...]:
    """Find the peaks of a spectrum, with frequencies and amplitudes between the bins.

    A sine between two bins shows with the window's transform around it, which is known in closed form: place
    and complex amplitude are fitted to the largest bin and its neighbours by least squares. What other
    peaks, and each peak's mirror image at negative frequency, add to those bins is subtracted, in turns until
    nothing changes (the RELAX method of Li and Stoica, 1996). A local maximum of which that leaves no more
    than noise is leakage and no peak.

    Accuracy, as the tests hold it: sines of like size 3 bins apart (5 with the Blackman-Harris window, 6 with
    flat-top), without noise, to 1e-9 bins and 1e-9 of the amplitude; closer ones may show as one, between
    them. With white noise of standard deviation s, a sine of amplitude a in N samples has its frequency to a
    standard deviation of c s/(a sqrt(N)) bins, c = 0.9 (rectangular), 1.5 (Hann), 2.1 (Blackman-Harris) and
    6.5 (flat-top); no method can do better than 0.78. What is not a sine, such as a vibration that dies out,
    is shown by the sine that fits best. Without a window the leakage of large peaks counts as noise, so small
    peaks are missed unless the record is a whole number of periods.

    Args:
        spectrum: The spectrum.
        limit: Return this many, the largest; all if not given.
        smallest: Smallest amplitude, relative to the largest bin.
        false_alarm: Probability that white noise alone gives a peak (``trimmer.spectra.noise``).

    Returns:
        Peaks by falling amplitude. None is looked for in the lowest bins, within the window's main lobe of
        0 Hz, where the mean was subtracted.

    Raises:
        SignalError: if limit, smallest or false_alarm is out of its range.
    """
    require_instance("spectrum", spectrum, Spectrum, "a trimmer.Spectrum")
    _check(limit, smallest, false_alarm)
    candidates, thresholds = _candidates(spectrum, smallest, false_alarm)
    lines = _Lines(np.empty(0, np.intp), np.empty(0), np.empty(0, np.complex128))
    while candidates.size:
        left = np.abs(spectrum.lines[candidates] - _leakage(spectrum, lines, candidates))
        real = left > thresholds
        if not real.any():
            break
        chosen = real & (left > _BATCH * left[real].max())
        lines = _relaxed(spectrum, _added(spectrum, lines, candidates[chosen]))
        candidates, thresholds = candidates[~chosen], thresholds[~chosen]
    found = (
        Peak(float(place * spectrum.bin_width), float(abs(amplitude)), float(np.angle(amplitude)))
        for place, amplitude in zip(lines.places, lines.amplitudes, strict=True)
    )
    return tuple(sorted(found, key=lambda peak: -peak.amplitude)[:limit])


def _check(limit: int | None, smallest: float, false_alarm: float) -> None:
    if limit is not None and whole_number("limit", limit) < 1:
        raise SignalError(f"limit is {limit}: ask for one peak or more")
    if not 0 <= real_number("smallest", smallest) < 1:
        raise SignalError(f"smallest is {smallest}: it is relative to the largest bin, 0 <= smallest < 1")
    if not 0 < real_number("false_alarm", false_alarm) < 1:
        raise SignalError(f"false_alarm is {false_alarm}: it is a probability, 0 < false_alarm < 1")


def _candidates(spectrum: Spectrum, smallest: float, false_alarm: float) -> tuple[Places, Reals]:
    """Find local maxima above the noise, the largest first, and the threshold of each."""
    amplitude = spectrum.amplitude
    first, last = spectrum.window.half_width + 1, amplitude.size - 2
    if last <= first or not amplitude.any():
        return np.empty(0, np.intp), np.empty(0)
    inside = amplitude[first:last]
    maxima = (inside > amplitude[first - 1 : last - 1]) & (inside >= amplitude[first + 1 : last + 1])
    bins = first + np.flatnonzero(maxima)
    threshold = np.maximum(noise_threshold(amplitude, false_alarm), smallest * amplitude[1:].max())
    bins = bins[amplitude[bins] > threshold[bins]]
    bins = bins[np.argsort(-amplitude[bins], kind="stable")][:MOST_PEAKS]
    return bins, threshold[bins]


def _leakage(spectrum: Spectrum, lines: _Lines, bins: Places) -> Complexes:
    """Add up what lines show at bins of any shape, with their mirror images at negative frequency."""
    if lines.bins.size == 0:
        return np.zeros(bins.shape, np.complex128)
    return np.asarray(_shown(spectrum, lines, bins[..., None]).sum(axis=-1))


def _shown(spectrum: Spectrum, lines: _Lines, bins: Places) -> Complexes:
    window, count = spectrum.window, spectrum.samples
    itself = lines.amplitudes * window.transform(bins - lines.places, count)
    return itself + lines.amplitudes.conj() * window.transform(bins + lines.places, count)


def _added(spectrum: Spectrum, lines: _Lines, bins: Places) -> _Lines:
    """Add lines at bins, fitted to what is left there when the others are taken off."""
    around = _around(bins)
    left = spectrum.lines[around] - _leakage(spectrum, lines, around)
    new = _Lines(bins, bins.astype(float), spectrum.lines[bins])
    for _ in range(_FIRST_STEPS):
        new = _fitted(spectrum, new, left)
    return _Lines(
        np.concatenate([lines.bins, new.bins]),
        np.concatenate([lines.places, new.places]),
        np.concatenate([lines.amplitudes, new.amplitudes]),
    )


def _relaxed(spectrum: Spectrum, lines: _Lines) -> _Lines:
    """Fit each line again without the others and its own mirror image, until all stay where they are."""
    window, count = spectrum.window, spectrum.samples
    around = _around(lines.bins)
    for _ in range(_SWEEPS):
        itself = lines.amplitudes[:, None] * window.transform(around - lines.places[:, None], count)
        left = spectrum.lines[around] - _leakage(spectrum, lines, around) + itself
        before, lines = lines, _fitted(spectrum, lines, left)
        if np.abs(lines.places - before.places).max() < _SETTLED:
            break
    return lines


def _around(bins: Places) -> Places:
    """List each bin with its two neighbours, shape (number, 3)."""
    return np.asarray(bins[:, None] + np.arange(-1, 2))


def _fitted(spectrum: Spectrum, lines: _Lines, left: Complexes) -> _Lines:
    """Take a Gauss-Newton step of the least-squares fit of each line to its bins.

    Args:
        spectrum: The spectrum.
        lines: Lines as they are now.
        left: What each line alone shows around its bin, shape (number, 3).
    """
    bins = _around(lines.bins)
    shape, ahead, behind = _shape(spectrum, bins, np.add.outer([0.0, _STEP, -_STEP], lines.places))
    slope = (ahead - behind) / (2.0 * _STEP)
    amplitudes = _product(shape, left) / _product(shape, shape)
    # The amplitude is free, so only the part of the slope that it cannot make up for determines the place.
    slope = slope - shape * (_product(shape, slope) / _product(shape, shape))[:, None]
    slope = slope * amplitudes[:, None]
    rest = left - amplitudes[:, None] * shape
    steps = _product(slope, rest).real / _product(slope, slope).real
    places = np.clip(lines.places + steps, lines.bins - _LARGEST_OFFSET, lines.bins + _LARGEST_OFFSET)
    shape = _shape(spectrum, bins, places)
    return _Lines(lines.bins, places, _product(shape, left) / _product(shape, shape))


def _shape(spectrum: Spectrum, bins: Places, places: Reals) -> Complexes:
    return spectrum.window.transform(bins - places[..., None], spectrum.samples)


def _product(first: Complexes, second: Complexes) -> Complexes:
    return np.asarray((first.conj() * second).sum(axis=1))
