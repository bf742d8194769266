"""The amplitude spectrum of a sampled signal."""

from dataclasses import dataclass
from functools import cached_property

import numpy as np
from numpy.typing import ArrayLike

from trimmer.arrays import Complexes, Reals
from trimmer.showing.drawn import Drawn
from trimmer.showing.shown import Tabular
from trimmer.showing.table import Table, arrays
from trimmer.signals.signal import SignalError, checked_rate, checked_samples
from trimmer.spectra.window import Window

IN_UNIT_OF_SIGNAL = "unit of the signal"  # Stands for the unit of an amplitude where it is not known
FEWEST_SAMPLES = 16
"""Fewest samples of which a spectrum is made: the main lobe of the widest window has 10 bins."""


@dataclass(frozen=True, eq=False, repr=False)
class Spectrum(Tabular, Drawn):
    """An amplitude spectrum, single-sided: a sine of amplitude a shows a, at a bin that it falls on.

    ``plot`` draws the amplitude, in the signal's unit, over frequency, Hz.

    Attributes:
        lines: Complex amplitudes, in the signal's unit, shape (samples // 2 + 1,): c of
            Re(c exp(j omega t)) with t = 0 at the first sample, so the angle of c is the phase of a cosine.
        window: The window that the signal was multiplied with; its sum is divided out.
        sample_rate: Sample rate of the signal, Hz.
        samples: Number of samples of the signal.
        mean: Mean of the signal, in its unit, which was subtracted before windowing.
        colour: Power of the frequency with which noise is taken to grow: 0 for white noise, -2 where an
            acceleration with white noise was integrated twice.
    """

    lines: Complexes
    window: Window
    sample_rate: float
    samples: int
    mean: float
    colour: int = 0

    @property
    def bin_width(self) -> float:
        """Distance of neighbouring bins, Hz: sample rate over number of samples."""
        return self.sample_rate / self.samples

    @cached_property
    def frequency(self) -> Reals:
        """Frequency of each bin, Hz, from 0 to half the sample rate, in the shape of ``lines``."""
        return np.asarray(np.arange(self.lines.size) * self.bin_width)

    @cached_property
    def noise_shape(self) -> Reals:
        """Amplitude of noise at each bin beside others, in the shape of ``lines``."""
        bins = np.maximum(np.arange(self.lines.size, dtype=np.float64), 1.0)
        return np.asarray(bins**self.colour)

    @cached_property
    def amplitude(self) -> Reals:
        """Amplitude at each bin, in the signal's unit, in the shape of ``lines``."""
        return np.asarray(np.abs(self.lines))

    def _told(self) -> str:
        word = self.window.word
        return f"{self.lines.size} bins {self.bin_width:.6g} Hz apart, {word} window, mean {self.mean:.6g}"

    def _table(self) -> Table:
        columns = arrays(
            frequency=("Hz", self.frequency),
            amplitude=(IN_UNIT_OF_SIGNAL, self.amplitude),
            phase=("rad", np.angle(self.lines)),
        )
        return Table("Amplitude spectrum; phases of cosines", range(self.lines.size), columns)


def amplitude_spectrum(signal: ArrayLike, sample_rate: float, window: Window | str = Window.HANN) -> Spectrum:
    """Compute the amplitude spectrum of a signal without its mean.

    Args:
        signal: Samples, shape (n,), n >= ``FEWEST_SAMPLES``, in any unit.
        sample_rate: Samples per second, Hz.
        window: Window function, a member or its word, such as ``hann``.

    Raises:
        ChoiceError: if there is no such window.
        SignalError: if samples or sample rate cannot be used, or there are too few samples.
    """
    values = checked_samples(signal)
    rate = checked_rate(sample_rate)
    window = Window.chosen(window, "window")
    if values.size < FEWEST_SAMPLES:
        raise SignalError(
            f"{values.size} samples are too few for a spectrum; {FEWEST_SAMPLES} or more are needed"
        )
    scale = float(np.abs(values).max()) or 1.0  # keeps sums of large samples finite
    relative = values / scale
    mean = float(relative.mean())
    weights = window.samples(values.size)
    lines = np.fft.rfft((relative - mean) * weights) * (2.0 / weights.sum())
    lines[0] /= 2.0  # 0 Hz, and half the sample rate, are there once and not at negative frequencies too
    if values.size % 2 == 0:
        lines[-1] /= 2.0
    return Spectrum(lines * scale, window, rate, values.size, scale * mean)
