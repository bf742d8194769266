"""Bins of a spectrum as NumPy has them, and searches for samples and drives that fit tabulated peaks."""

from collections.abc import Mapping, Sequence

import numpy as np

from trimmer.arrays import Reals

HALF_DIGIT = 0.0005 * (1 + 1e-9)  # Half a unit of the third decimal, Hz


def bins(samples: int, rate: float) -> Reals:
    """Return the bins of a spectrum of so many samples at a rate (Hz), Hz."""
    return np.asarray(np.fft.rfftfreq(samples, 1 / rate))


def fitting_samples(cells: Sequence[str], rate: float, fewest: int, most: int) -> list[int]:
    """Return the numbers of samples, at a rate (Hz), with a bin at every frequency (Hz, three decimals)."""
    samples = np.arange(fewest, most)
    frequencies = np.array(cells, dtype=float)[:, np.newaxis]
    spacing = rate / samples
    miss = np.abs(np.round(frequencies / spacing) * spacing - frequencies)
    return [int(each) for each in samples[(miss <= HALF_DIGIT).all(axis=0)]]


def a_drive_fits(places: Mapping[int, int], spacing: float) -> bool:
    """Tell whether the harmonics of a drive from 100 to 120 Hz lie within a bin of their peaks.

    ``places`` has the bin of each harmonic, ``spacing`` is the distance of bins, Hz.
    """
    drives = np.arange(100_000, 120_000) / 1e3
    distances = [abs(order * drives - number * spacing) for order, number in places.items()]
    return bool((np.max(distances, axis=0) <= spacing).any())
