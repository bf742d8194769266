"""Peaks of a spectrum, found between the bins."""

from __future__ import annotations

import math
from dataclasses import dataclass
from functools import partial
from typing import TYPE_CHECKING, NamedTuple

import numpy as np

from trimmer.arguments import real_number, require_instance, whole_number
from trimmer.showing.shown import Record
from trimmer.signals.signal import SignalError
from trimmer.spectra.noise import NEIGHBOURHOOD, noise_threshold
from trimmer.spectra.spectrum import Spectrum
from trimmer.spectra.window import Window

if TYPE_CHECKING:
    from trimmer.arrays import Complexes, Flags, Places, Reals

MOST_PEAKS = 200
"""Most peaks that are looked for, the largest; it bounds the time."""

_LARGEST_OFFSET = 0.75
_STEP = 1e-4
_FIRST_STEPS = 6
_BATCH = 0.3
_SWEEPS = 30
_SETTLED = 1e-12
_SKIRT = 64
"""Bins on either side of a line in which its leakage may hide a smaller one."""
_STRIDE = 3
"""Of how many bins around a peak one is taken to tell the noise."""


class _Loss(NamedTuple):
    """Standard deviations of the fit to three bins over the Cramér-Rao bounds, measured in white noise."""

    frequency: float
    amplitude: float


_LOSSES = {
    Window.RECTANGULAR: _Loss(1.155, 1.10),
    Window.HANN: _Loss(1.90, 1.35),
    Window.BLACKMAN_HARRIS: _Loss(2.75, 1.50),
    Window.FLAT_TOP: _Loss(8.3, 1.85),
}


@dataclass(frozen=True)
class Peak(Record):
    """A peak of a spectrum, as the sine amplitude * cos(2 pi frequency t + phase) from the first sample on.

    Attributes:
        frequency: Frequency, Hz.
        amplitude: Amplitude, in the signal's unit.
        phase: Phase, rad, in (-pi, pi].
        frequency_uncertainty: Standard deviation of the frequency, Hz, in white noise of the level that is
            found around the peak: the Cramér-Rao bound times what the fit loses with the window. NaN if it is
            not known.
        amplitude_uncertainty: The same of the amplitude, in the signal's unit.
    """

    frequency: float
    amplitude: float
    phase: float
    frequency_uncertainty: float = math.nan
    amplitude_uncertainty: float = math.nan


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
    than noise is leakage and no peak. What is left then shows lines that the leakage of larger ones hid.

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
    threshold = _threshold(spectrum, smallest, false_alarm)
    candidates = _maxima(spectrum, threshold)
    lines = _Lines(np.empty(0, np.intp), np.empty(0), np.empty(0, np.complex128))
    while lines.bins.size < MOST_PEAKS:
        left = _left(spectrum, lines, candidates)
        new = _new_bins(spectrum, lines, candidates, left, threshold)
        if new.size == 0:
            break
        chosen = new[left[new] > _BATCH * left[new].max()]
        lines = _relaxed(spectrum, _added(spectrum, lines, chosen))
    order = np.argsort(-np.abs(lines.amplitudes), kind="stable")[:limit]
    noise = np.array([_noise(spectrum, lines, place) for place in lines.places[order]])
    return tuple(map(partial(_peak, spectrum), lines.places[order], lines.amplitudes[order], noise))


def _peak(spectrum: Spectrum, place: float, amplitude: complex, noise: float) -> Peak:
    """Describe a line among white noise of some standard deviation per sample.

    The Cramér-Rao bounds are sqrt(6)/pi noise/(amplitude sqrt(N)) bins and noise sqrt(2/N) (Rife and
    Boorstyn, 1974).
    """
    size = float(abs(amplitude))
    share = noise / math.sqrt(spectrum.samples)
    loss = _LOSSES[spectrum.window]
    return Peak(
        frequency=float(place * spectrum.bin_width),
        amplitude=size,
        phase=float(np.angle(amplitude)),
        frequency_uncertainty=loss.frequency * math.sqrt(6.0) / math.pi * share / size * spectrum.bin_width,
        amplitude_uncertainty=loss.amplitude * math.sqrt(2.0) * share,
    )


def _check(limit: int | None, smallest: float, false_alarm: float) -> None:
    if limit is not None and whole_number("limit", limit) < 1:
        raise SignalError(f"limit is {limit}: ask for one peak or more")
    if not 0 <= real_number("smallest", smallest) < 1:
        raise SignalError(f"smallest is {smallest}: it is relative to the largest bin, 0 <= smallest < 1")
    if not 0 < real_number("false_alarm", false_alarm) < 1:
        raise SignalError(f"false_alarm is {false_alarm}: it is a probability, 0 < false_alarm < 1")


def _threshold(spectrum: Spectrum, smallest: float, false_alarm: float) -> Reals:
    """Find what each bin must exceed."""
    amplitude = spectrum.amplitude
    floor = smallest * amplitude[1:].max(initial=0.0)
    shape = spectrum.noise_shape
    return np.asarray(np.maximum(shape * noise_threshold(amplitude / shape, false_alarm), floor))


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


def _left(spectrum: Spectrum, lines: _Lines, candidates: Places) -> Reals:
    """Take the lines off the amplitudes at and beside candidates and lines; shape of all bins."""
    left = spectrum.amplitude.copy()
    near = np.concatenate([_near(lines.bins, _SKIRT + 1).ravel(), _near(candidates, 2).ravel()])
    near = np.unique(near[(near >= 0) & (near < left.size)])
    left[near] = np.abs(spectrum.lines[near] - _leakage(spectrum, lines, near))
    return left


def _new_bins(spectrum: Spectrum, lines: _Lines, candidates: Places, left: Reals, threshold: Reals) -> Places:
    """Find bins where more is left than noise: at candidates, and where the leakage of a line hid a line.

    A peak that is no sine, as of a vibration that dies out, leaves something beside it too. So what was
    hidden must be larger than what the fit of the line beside it leaves at that line.
    """
    at_candidates = _inside(spectrum, _near(candidates, 1).ravel())
    beside = np.abs(np.subtract.outer(at_candidates, lines.bins)).min(axis=1, initial=_SKIRT)
    at_candidates = at_candidates[beside > 1]
    hidden = _inside(spectrum, _near(lines.bins, _SKIRT).ravel())
    distance = np.abs(np.subtract.outer(hidden, lines.bins))
    # Within the lobe of a line nothing is larger than its misfit.
    lobe = np.minimum(_near(lines.bins, spectrum.window.half_width), left.size - 1)
    misfit = np.where(distance <= _SKIRT, left[lobe].max(axis=1, initial=0.0), 0.0).max(axis=1, initial=0.0)
    hidden = hidden[left[hidden] > misfit]
    bins = np.unique(np.concatenate([at_candidates, hidden]))
    return np.asarray(bins[_is_maximum(left, bins) & (left[bins] > threshold[bins])])


def _noise(spectrum: Spectrum, lines: _Lines, place: float) -> float:
    """Standard deviation of white noise, per sample, that leaves as much as is left around a place.

    The bins of the spectrum of such noise have a Rayleigh distribution; see ``trimmer.spectra.noise``.
    """
    bins = round(place) + np.arange(-NEIGHBOURHOOD // 2, NEIGHBOURHOOD // 2, _STRIDE)
    bins = np.unique(np.clip(bins, 1, spectrum.lines.size - 2))
    apart = np.abs(np.subtract.outer(bins, lines.bins)).min(axis=1) > spectrum.window.half_width
    bins = bins[apart] if apart.any() else bins
    left = np.abs(spectrum.lines[bins] - _leakage(spectrum, lines, bins)) / spectrum.noise_shape[bins]
    median = float(np.median(left)) * float(spectrum.noise_shape[round(place)])
    return median * math.sqrt(spectrum.samples / (4.0 * math.log(2.0) * spectrum.window.noise_bandwidth))


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
    around = _near(bins, 1)
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
    around = _near(lines.bins, 1)
    for _ in range(_SWEEPS):
        itself = lines.amplitudes[:, None] * window.transform(around - lines.places[:, None], count)
        left = spectrum.lines[around] - _leakage(spectrum, lines, around) + itself
        before, lines = lines, _fitted(spectrum, lines, left)
        if np.abs(lines.places - before.places).max() < _SETTLED:
            break
    return lines


def _near(bins: Places, reach: int) -> Places:
    """List each bin with those within a reach of it, shape (number, 2 reach + 1)."""
    return np.asarray(bins[:, None] + np.arange(-reach, reach + 1))


def _fitted(spectrum: Spectrum, lines: _Lines, left: Complexes) -> _Lines:
    """Take a Gauss-Newton step of the least-squares fit of each line to its bins.

    Args:
        spectrum: The spectrum.
        lines: Lines as they are now.
        left: What each line alone shows around its bin, shape (number, 3).
    """
    bins = _near(lines.bins, 1)
    shape, ahead, behind = _shape(spectrum, bins, np.add.outer([0.0, _STEP, -_STEP], lines.places))
    slope = (ahead - behind) / (2.0 * _STEP)
    amplitudes = _product(shape, left) / _product(shape, shape)
    # The amplitude is free, so only the part of the slope that it cannot make up for determines the place.
    slope = slope - shape * (_product(shape, slope) / _product(shape, shape))[:, None]
    slope = slope * amplitudes[:, None]
    # What the shape makes up of the bins is orthogonal to this slope, and need not be taken off.
    steps = _product(slope, left).real / _product(slope, slope).real
    places = np.clip(lines.places + steps, lines.bins - _LARGEST_OFFSET, lines.bins + _LARGEST_OFFSET)
    shape = _shape(spectrum, bins, places)
    return _Lines(lines.bins, places, _product(shape, left) / _product(shape, shape))


def _shape(spectrum: Spectrum, bins: Places, places: Reals) -> Complexes:
    return spectrum.window.transform(bins - places[..., None], spectrum.samples)


def _product(first: Complexes, second: Complexes) -> Complexes:
    return np.asarray((first.conj() * second).sum(axis=1))
