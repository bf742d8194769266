"""Sines that add up to a spectrum: what they show, what they leave, and their fit bin by bin."""

import math
from dataclasses import dataclass

import numpy as np
from scipy.ndimage import median_filter

from trimmer.arrays import ArrayRecord, Complexes, Flags, Places, Reals
from trimmer.spectra.spectrum import Spectrum

NEIGHBOURHOOD = 401  # Number of bins over which noise is taken as white


def noise_threshold(amplitude: Reals, false_alarm: float) -> Reals:
    """Find the amplitude, (m,), that noise alone exceeds with a given probability, in any of m bins.

    The amplitude of Gaussian noise in a bin has a Rayleigh distribution with median s sqrt(2 ln 2), and
    exceeds a with probability exp(-(a/s)**2/2). The median is taken over the ``NEIGHBOURHOOD`` of each
    bin, so that noise may change along the spectrum; a few lines among the bins hardly move it. It is
    uncertain itself, which makes false alarms somewhat more frequent: 1.5 % where 1 % is asked for, in
    1000 bins.
    """
    median = median_filter(amplitude, min(NEIGHBOURHOOD, amplitude.size), mode="reflect")
    return np.asarray(median * math.sqrt(math.log(amplitude.size / false_alarm) / math.log(2.0)))


_LARGEST_OFFSET = 0.75
_STEP = 1e-4
_FIRST_STEPS = 6
_SWEEPS = 30
_SETTLED = 1e-12
_STRIDE = 3  # Of how many bins around a peak one is taken to tell the noise


@dataclass(frozen=True, eq=False)
class Lines(ArrayRecord):
    """Sines that add up to a spectrum: bin of each, place in bins, complex amplitude; shape (number,)."""

    bins: Places
    places: Reals
    amplitudes: Complexes


def noise_beside(spectrum: Spectrum, lines: Lines, place: float) -> float:
    """Standard deviation of white noise, per sample, that leaves as much as is left around a place.

    The bins of the spectrum of such noise have a Rayleigh distribution; see ``noise_threshold``.
    """
    bins = round(place) + np.arange(-NEIGHBOURHOOD // 2, NEIGHBOURHOOD // 2, _STRIDE)
    bins = np.unique(np.clip(bins, 1, spectrum.lines.size - 2))
    apart = np.abs(np.subtract.outer(bins, lines.bins)).min(axis=1) > spectrum.window.half_width
    bins = bins[apart] if apart.any() else bins
    left = np.abs(spectrum.lines[bins] - leakage(spectrum, lines, bins)) / spectrum.noise_shape[bins]
    median = float(np.median(left)) * float(spectrum.noise_shape[round(place)])
    return median * math.sqrt(spectrum.samples / (4.0 * math.log(2.0) * spectrum.window.noise_bandwidth))


def leakage(spectrum: Spectrum, lines: Lines, bins: Places) -> Complexes:
    """Add up what lines show at bins of any shape, with their mirror images at negative frequency."""
    if lines.bins.size == 0:
        return np.zeros(bins.shape, np.complex128)
    return np.asarray(_shown(spectrum, lines, bins[..., None]).sum(axis=-1))


def _shown(spectrum: Spectrum, lines: Lines, bins: Places) -> Complexes:
    window, count = spectrum.window, spectrum.samples
    itself = lines.amplitudes * window.transform(bins - lines.places, count)
    return itself + lines.amplitudes.conj() * window.transform(bins + lines.places, count)


def added(spectrum: Spectrum, lines: Lines, bins: Places) -> Lines:
    """Add lines at bins, fitted to what is left there when the others are taken off."""
    around = bins_near(bins, 1)
    left = spectrum.lines[around] - leakage(spectrum, lines, around)
    new = Lines(bins, bins.astype(float), spectrum.lines[bins])
    for _ in range(_FIRST_STEPS):
        new = _fitted(spectrum, new, left)
    return Lines.joined([lines, new])


def relaxed(spectrum: Spectrum, lines: Lines, moving: Flags | None = None) -> Lines:
    """Fit each line again without the others and its own mirror image, until all stay where they are."""
    window, count = spectrum.window, spectrum.samples
    around = bins_near(lines.bins, 1)
    for _ in range(_SWEEPS):
        itself = lines.amplitudes[:, None] * window.transform(around - lines.places[:, None], count)
        left = spectrum.lines[around] - leakage(spectrum, lines, around) + itself
        before, lines = lines, _fitted(spectrum, lines, left)
        if moving is not None:
            lines = Lines(
                lines.bins,
                np.where(moving, lines.places, before.places),
                np.where(moving, lines.amplitudes, before.amplitudes),
            )
        if np.abs(lines.places - before.places).max() < _SETTLED:
            break
    return lines


def bins_near(bins: Places, reach: int) -> Places:
    """List each bin with those within a reach of it, shape (number, 2 reach + 1)."""
    return np.asarray(bins[:, None] + np.arange(-reach, reach + 1))


def _fitted(spectrum: Spectrum, lines: Lines, left: Complexes) -> Lines:
    """Take a Gauss-Newton step of the fit of each line to what it alone shows around its bin, (number, 3)."""
    bins = bins_near(lines.bins, 1)
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
    return Lines(lines.bins, places, _product(shape, left) / _product(shape, shape))


def _shape(spectrum: Spectrum, bins: Places, places: Reals) -> Complexes:
    return spectrum.window.transform(bins - places[..., None], spectrum.samples)


def _product(first: Complexes, second: Complexes) -> Complexes:
    return np.asarray((first.conj() * second).sum(axis=1))


NONE = Lines(np.empty(0, np.intp), np.empty(0), np.empty(0, np.complex128))  # No lines
