"""Peaks of a spectrum, found between the bins."""

import math
from dataclasses import dataclass

import numpy as np
from scipy.ndimage import uniform_filter1d

from trimmer.arguments import real_number, require_instance, whole_number
from trimmer.arrays import Flags, Places, Reals
from trimmer.showing.shown import ShownFields
from trimmer.signals.band import EVERYWHERE, Band
from trimmer.signals.signal import SignalError
from trimmer.spectra.close_lines import SpectralLine
from trimmer.spectra.line_groups import resolved_lines
from trimmer.spectra.lines import (
    NEIGHBOURHOOD,
    NONE,
    Lines,
    added,
    bins_near,
    leakage,
    noise_threshold,
    relaxed,
)
from trimmer.spectra.spectrum import Spectrum

MOST_PEAKS = 200  # Most peaks that are looked for, the largest; it bounds the time

_BATCH = 0.3
_CROWDED = 0.25
"""Share of the bins in main lobes of lines from which on noise is judged by what the lines leave."""
_SKIRT = 64  # Bins on either side of a line in which its leakage may hide a smaller one


@dataclass(frozen=True)
class Peak(ShownFields):
    """A peak of a spectrum, as the sine amplitude * cos(2 pi frequency t + phase) from the first sample on.

    Attributes:
        frequency: Frequency, Hz.
        amplitude: Amplitude, in the signal's unit.
        phase: Phase, rad, in (-pi, pi].
        frequency_uncertainty: Standard deviation of the frequency, Hz, in white noise of the level that is
            found around the peak: the Cramér-Rao bound, for a line with none near it times what the fit to
            three bins loses with the window. It holds what another line may move it by that is possible but
            not certain, and of a peak that is not ``resolved`` what one sine leaves. NaN if it is not known.
        amplitude_uncertainty: The same of the amplitude, in the signal's unit.
        resolved: Whether it is one steady sine as far as the noise lets see. Otherwise it is several lines
            that are too close for this record, or one that changes in the course of it.
    """

    frequency: float
    amplitude: float
    phase: float
    frequency_uncertainty: float = math.nan
    amplitude_uncertainty: float = math.nan
    resolved: bool = True


def peaks(
    spectrum: Spectrum,
    limit: int | None = None,
    smallest: float = 1e-4,
    false_alarm: float = 0.01,
    band: Band = EVERYWHERE,
) -> tuple[Peak, ...]:
    """Find the peaks of a spectrum, with frequencies and amplitudes between the bins.

    A sine between two bins shows with the window's transform around it, which is known in closed form: place
    and complex amplitude are fitted to the largest bin and its neighbours by least squares. What other
    peaks, and each peak's mirror image at negative frequency, add to those bins is subtracted, in turns until
    nothing changes (the RELAX method of Li and Stoica, 1996). A local maximum of which that leaves no more
    than noise is leakage and no peak. What is left then shows lines that the leakage of larger ones hid.

    Then each line is held against all bins around it (``trimmer.spectra.close_lines``): where one sine does
    not explain them two or more are fitted together, and where these do not either, or are less than a bin
    apart, one peak is shown that is not ``resolved``, with uncertainties that hold what it leaves.

    Accuracy, as the tests hold it: sines of like size 3 bins apart (5 with the Blackman-Harris window, 6 with
    flat-top), without noise, to 1e-9 bins and 1e-9 of the amplitude; closer ones, down to one bin, as far as
    the noise lets, as stated by their uncertainties. With white noise of standard deviation s, a sine of
    amplitude a in N samples has its frequency to a standard deviation of c s/(a sqrt(N)) bins, c = 0.9
    (rectangular), 1.5 (Hann), 2.1 (Blackman-Harris) and 6.5 (flat-top); no method can do better than 0.78.
    What is not a sine, such as a vibration that dies out, is shown by the sine that fits best. Without a
    window the leakage of large peaks counts as noise, so small peaks are missed unless the record is a whole
    number of periods.

    Args:
        spectrum: The spectrum.
        limit: Return this many, the largest; all if not given.
        smallest: Smallest amplitude, relative to the largest bin.
        false_alarm: Probability that white noise alone gives a peak (``trimmer.spectra.lines``).
        band: Frequencies in which peaks are given; others are only taken off.

    Returns:
        Peaks by falling amplitude. None is looked for in the lowest bins, within the window's main lobe of
        0 Hz, where the mean was subtracted.

    Raises:
        SignalError: if limit, smallest or false_alarm is out of its range.
    """
    require_instance("spectrum", spectrum, Spectrum, "a trimmer.spectra.Spectrum")
    _check(limit, smallest, false_alarm)
    require_instance("band", band, Band, "a trimmer.signals.Band")
    threshold = _threshold(spectrum, spectrum.amplitude, smallest, false_alarm)
    lines = _lines_above(threshold, spectrum, NONE)
    while lines.bins.size and (crowded := _crowded(spectrum, lines)).any():
        noise = _noise_beside(spectrum, lines)
        lower = np.minimum(threshold, _threshold(spectrum, noise, smallest, false_alarm))
        threshold, before = np.where(crowded, lower, threshold), lines
        lines = _lines_above(threshold, spectrum, before)
        if lines.bins.size == before.bins.size:
            break
    found = resolved_lines(spectrum, lines, threshold, band, limit)
    return tuple(_peak(spectrum, line) for line in found[:limit])


def _peak(spectrum: Spectrum, line: SpectralLine) -> Peak:
    return Peak(
        frequency=line.place * spectrum.bin_width,
        amplitude=abs(line.amplitude),
        phase=float(np.angle(line.amplitude)),
        frequency_uncertainty=line.spread * spectrum.bin_width,
        amplitude_uncertainty=line.amplitude_spread,
        resolved=line.resolved,
    )


def _check(limit: int | None, smallest: float, false_alarm: float) -> None:
    if limit is not None and whole_number("limit", limit) < 1:
        raise SignalError(f"limit is {limit}: ask for one peak or more")
    if not 0 <= real_number("smallest", smallest) < 1:
        raise SignalError(f"smallest is {smallest}: it is relative to the largest bin, 0 <= smallest < 1")
    if not 0 < real_number("false_alarm", false_alarm) < 1:
        raise SignalError(f"false_alarm is {false_alarm}: it is a probability, 0 < false_alarm < 1")


def _threshold(spectrum: Spectrum, left: Reals, smallest: float, false_alarm: float) -> Reals:
    """Find what each bin must exceed, by the noise in what lines leave of the amplitudes."""
    floor = smallest * spectrum.amplitude[1:].max(initial=0.0)
    shape = spectrum.noise_shape
    return np.asarray(np.maximum(shape * noise_threshold(left / shape, false_alarm), floor))


def _noise_beside(spectrum: Spectrum, lines: Lines) -> Reals:
    """Return what lines leave at each bin, and at those to which they are fitted what was there of noise.

    A place and a complex amplitude take half of the noise of three complex values.
    """
    left = np.abs(spectrum.lines - leakage(spectrum, lines, np.arange(spectrum.lines.size)))
    left[np.unique(bins_near(lines.bins, 1))] *= math.sqrt(2.0)
    return np.asarray(left)


def _crowded(spectrum: Spectrum, lines: Lines) -> Flags:
    """Say around which bins lines are so many that the median amplitude is theirs rather than the noise's."""
    near = np.zeros(spectrum.lines.size)
    near[np.minimum(bins_near(lines.bins, spectrum.window.half_width - 1), near.size - 1)] = 1.0
    return np.asarray(uniform_filter1d(near, min(NEIGHBOURHOOD, near.size), mode="reflect") > _CROWDED)


def _lines_above(threshold: Reals, spectrum: Spectrum, lines: Lines) -> Lines:
    """Add the lines that what is left shows above a threshold at each bin, the largest first."""
    candidates = _maxima(spectrum, threshold)
    while lines.bins.size < MOST_PEAKS:
        left = _left(spectrum, lines, candidates)
        new = _new_bins(spectrum, lines, candidates, left, threshold)
        if new.size == 0:
            break
        chosen = new[left[new] > _BATCH * left[new].max()]
        lines = relaxed(spectrum, added(spectrum, lines, chosen))
    return lines


def _maxima(spectrum: Spectrum, threshold: Reals) -> Places:
    """Find the local maxima above the threshold, the largest first."""
    amplitude = spectrum.amplitude
    bins = _inside(spectrum, np.arange(amplitude.size))
    bins = bins[_is_maximum(amplitude, bins) & (amplitude[bins] > threshold[bins])]
    return bins[np.argsort(-amplitude[bins], kind="stable")][:MOST_PEAKS]


def _inside(spectrum: Spectrum, bins: Places) -> Places:
    """Keep the bins in which peaks are looked for."""
    first, last = spectrum.window.half_width + 1, spectrum.amplitude.size - 2
    return np.unique(bins[(bins >= first) & (bins < last)])


def _is_maximum(amplitude: Reals, bins: Places) -> Flags:
    return np.asarray((amplitude[bins] > amplitude[bins - 1]) & (amplitude[bins] >= amplitude[bins + 1]))


def _left(spectrum: Spectrum, lines: Lines, candidates: Places) -> Reals:
    """Take the lines off the amplitudes at and beside candidates and lines; shape of all bins."""
    left = spectrum.amplitude.copy()
    near = np.concatenate([bins_near(lines.bins, _SKIRT + 1).ravel(), bins_near(candidates, 2).ravel()])
    near = np.unique(near[(near >= 0) & (near < left.size)])
    left[near] = np.abs(spectrum.lines[near] - leakage(spectrum, lines, near))
    return left


def _new_bins(spectrum: Spectrum, lines: Lines, candidates: Places, left: Reals, threshold: Reals) -> Places:
    """Find bins where more is left than noise: at candidates, and where the leakage of a line hid a line.

    A peak that is no sine, as of a vibration that dies out, leaves something beside it too. So what was
    hidden must be larger than what the fit of the line beside it leaves at that line.
    """
    at_candidates = _inside(spectrum, bins_near(candidates, 1).ravel())
    beside = np.abs(np.subtract.outer(at_candidates, lines.bins)).min(axis=1, initial=_SKIRT)
    at_candidates = at_candidates[beside > 1]
    hidden = _inside(spectrum, bins_near(lines.bins, _SKIRT).ravel())
    distance = np.abs(np.subtract.outer(hidden, lines.bins))
    # Within the lobe of a line nothing is larger than its misfit.
    lobe = np.minimum(bins_near(lines.bins, spectrum.window.half_width), left.size - 1)
    misfit = np.where(distance <= _SKIRT, left[lobe].max(axis=1, initial=0.0), 0.0).max(axis=1, initial=0.0)
    hidden = hidden[left[hidden] > misfit]
    bins = np.unique(np.concatenate([at_candidates, hidden]))
    return np.asarray(bins[_is_maximum(left, bins) & (left[bins] > threshold[bins])])
