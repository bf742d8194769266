"""Records as the thesis takes them, and their spectra."""

from dataclasses import dataclass

import numpy as np

from report.numbers.thesis import SAMPLE_RATE
from trimmer.arrays import Reals

PADDED = 2**17  # Samples of a record with zeros added: a finer grid of frequencies, not a finer resolution


@dataclass(frozen=True)
class Record:
    """Samples at equal distances over a time, both of whose ends belong to them.

    The sample rate is then (samples - 1) / duration and a bin slightly narrower than 1 / duration, which
    shows in the digits of the thesis's peaks.
    """

    duration: float  # s
    samples: int  # Number of samples

    @property
    def bin_width(self) -> float:
        """Distance of two bins, Hz."""
        return (self.samples - 1) / (self.duration * self.samples)

    def frequency(self, number: int) -> float:
        """Return the frequency of a bin, Hz."""
        return number * self.bin_width

    def nearest(self, frequency: float) -> float:
        """Return the frequency (Hz) of the bin nearest to a frequency (Hz)."""
        return self.frequency(round(frequency / self.bin_width))


def line_amplitudes(output: Reals) -> Reals:
    """Return the amplitude at each bin of the spectrum of a record, without window."""
    return np.asarray(2 * np.abs(np.fft.rfft(output)) / output.size)


def harmonics(period: Reals) -> Reals:
    """Return the amplitudes of the harmonics 0, 1, 2 ... of a period that is sampled evenly."""
    amplitudes = line_amplitudes(period)
    amplitudes[0] /= 2
    return amplitudes


def change(before: Reals, after: Reals) -> float:
    """Return the largest difference of two records, such as periods, over the largest of the second."""
    difference = np.abs(after - before).max()
    return float(difference / np.abs(after).max()) if difference else 0.0


def padded_spectrum(output: Reals) -> tuple[Reals, Reals]:
    """Return frequencies (Hz) and modulus of the transform of samples at ``SAMPLE_RATE``, on a finer grid."""
    frequencies = np.fft.rfftfreq(PADDED, 1 / SAMPLE_RATE)
    return np.asarray(frequencies, dtype=np.float64), np.abs(np.fft.rfft(output, PADDED))


def largest_peaks(amplitudes: Reals, count: int) -> tuple[int, ...]:
    """Return the bins of the largest local maxima, the largest first."""
    inside = amplitudes[1:-1]
    peaks = 1 + np.flatnonzero((inside > amplitudes[:-2]) & (inside >= amplitudes[2:]))
    return tuple(int(each) for each in peaks[np.argsort(-amplitudes[peaks])][:count])
