"""Harmonics of a known drive, fitted to the samples."""

import math
from collections.abc import Iterator
from dataclasses import dataclass

import numpy as np
from numpy.typing import ArrayLike

from trimmer.arguments import real_number, whole_number
from trimmer.arrays import Complexes, Reals
from trimmer.showing.drawn import Drawn
from trimmer.showing.shown import Tabular
from trimmer.showing.table import Table, of_harmonics
from trimmer.signals.signal import SignalError, checked_rate, checked_samples
from trimmer.spectra.spectrum import IN_UNIT_OF_SIGNAL
from trimmer.spectra.window import Window

MOST_HARMONICS = 20  # Highest harmonic that is fitted if no number is given

_BLOCK = 16384


@dataclass(frozen=True, eq=False, repr=False)
class HarmonicFit(Tabular, Drawn):
    """The periodic signal mean + sum(Re(c_n exp(2 pi j n frequency t)), n = 1 .. count) nearest to a record.

    ``plot`` draws the amplitude of each harmonic, in the signal's unit, over its order.

    Attributes:
        frequency: Frequency of the drive, Hz.
        mean: Constant part, in the signal's unit.
        coefficients: Complex amplitudes c_1 to c_count, in the signal's unit, shape (count,), with t = 0 at
            the first sample.
        residual: Root mean square of what the fit leaves, in the signal's unit.
        explained: Share of the signal's variance that the harmonics explain, 0 to 1; 1 for a constant signal.
    """

    frequency: float
    mean: float
    coefficients: Complexes
    residual: float
    explained: float

    @property
    def orders(self) -> range:
        """Order of each coefficient: 1 for the drive itself."""
        return range(1, self.coefficients.size + 1)

    @property
    def amplitudes(self) -> Reals:
        """Amplitude of each harmonic, in the signal's unit, shape (count,)."""
        return np.asarray(np.abs(self.coefficients))

    def _told(self) -> str:
        count, frequency = self.coefficients.size, self.frequency
        return f"{count} of {frequency:.9g} Hz explain {self.explained:.4%} of the variance"

    def _table(self) -> Table:
        orders, title = np.array(self.orders), "Harmonics of the drive; phases of cosines"
        return of_harmonics(title, self.frequency, IN_UNIT_OF_SIGNAL, orders, self.coefficients)

    def at(self, times: ArrayLike) -> Reals:
        """Evaluate the fit at times after the first sample (s), in their shape and in the signal's unit."""
        cycles = self.frequency * np.asarray(times, dtype=np.float64)
        vibration = self.coefficients @ _powers(cycles.ravel(), self.coefficients.size)[1:]
        return np.asarray(self.mean + vibration.real.reshape(cycles.shape))


def fit_harmonics(
    signal: ArrayLike,
    sample_rate: float,
    drive_frequency: float,
    count: int | None = None,
    window: Window | str = Window.RECTANGULAR,
) -> HarmonicFit:
    """Fit mean, drive and harmonics to a record by least squares.

    Nothing leaks from one harmonic to another, whether or not the record is a whole number of periods: for a
    signal that is periodic with the drive the fit is exact. What else the signal contains leaks into the
    harmonics as it does in a spectrum with the same window. Without a window the fit is the best there is in
    white noise; where there are other lines, the Hann window keeps them out better.

    Args:
        signal: Samples, shape (n,), in any unit.
        sample_rate: Samples per second, Hz.
        drive_frequency: Frequency of the drive, Hz; an error of it counts n times at harmonic n.
        count: Number of harmonics. If not given ``MOST_HARMONICS``, or as many as the rate allows.
        window: Weights of the squares, a window or its word; the flat-top window has negative ones and cannot
            be used.

    Raises:
        ChoiceError: if there is no such window.
        SignalError: if samples, rate, drive or window cannot be used; or if the samples do not determine the
            harmonics: the record holds fewer periods of the drive than half the window's main lobe has bins
            (1 rectangular, 2 Hann), or a harmonic is nearer to half the sample rate than half of that. Then
            there are at least as many samples as unknowns.
    """
    values = checked_samples(signal)
    rate = checked_rate(sample_rate)
    drive_frequency = real_number("drive_frequency", drive_frequency, "Hz")
    if count is not None:
        whole_number("count", count, 0)
    window = Window.chosen(window, "window")
    count = _checked_count(values.size, rate, drive_frequency, count, window)
    scale = float(np.abs(values).max()) or 1.0
    relative = values / scale
    coefficients = _least_squares(relative, drive_frequency / rate, count, window)[count:]
    coefficients[1:] *= 2.0  # the real part of twice c stands for c and its conjugate at -n
    squares = sum(
        float(np.sum((relative[block] - (coefficients @ turned).real) ** 2))
        for block, turned in _turned(values.size, drive_frequency / rate, count)
    )
    left, variance = squares / values.size, float(relative.var())
    return HarmonicFit(
        frequency=float(drive_frequency),
        mean=scale * float(coefficients[0].real),
        coefficients=scale * coefficients[1:],
        residual=scale * math.sqrt(left),
        explained=max(0.0, 1.0 - left / variance) if variance > 0 else 1.0,
    )


def _checked_count(samples: int, rate: float, drive: float, count: int | None, window: Window) -> int:
    if window is Window.FLAT_TOP:
        raise SignalError("harmonics cannot be fitted with the flat-top window; use another one")
    if not 0 < drive < math.inf:
        raise SignalError(f"the frequency of the drive must be a positive number of hertz, not {drive!r}")
    if samples * drive < window.half_width * rate:
        raise SignalError(
            f"the record lasts {samples / rate:.6g} s; {window.half_width / drive:.6g} s or more are needed "
            f"for a drive of {drive:g} Hz ({window.word} window)"
        )
    highest = 0.5 * rate * (1.0 - window.half_width / samples)
    most = math.floor(highest / drive)
    if most < 1:
        raise SignalError(
            f"a drive of {drive:g} Hz is not seen in samples at {rate:g} Hz, only what is up to "
            f"{highest:.6g} Hz"
        )
    wanted = min(most, MOST_HARMONICS) if count is None else count
    if not 1 <= wanted <= most:
        raise SignalError(f"{wanted} harmonics of {drive:g} Hz: samples at {rate:g} Hz determine 1 to {most}")
    return wanted


def _least_squares(values: Reals, cycles_per_sample: float, count: int, window: Window) -> Complexes:
    """Solve for the coefficients of exp(j n theta), n = -count .. count, shape (2 count + 1,).

    The normal matrix holds weighted sums of exp(j m theta) over the samples: they depend on the difference m
    of two orders alone, and are the window's transform. Normal equations lose no digits that matter here:
    over a few periods the harmonics are nearly orthogonal.
    """
    bins = np.arange(-2 * count, 2 * count + 1) * (cycles_per_sample * values.size)
    sums = window.transform(-bins, values.size)
    weighted = values * window.samples(values.size) / (window.value[0] * values.size)
    orders = np.arange(2 * count + 1)
    normal = sums[2 * count + orders[None, :] - orders[:, None]]
    projections = np.zeros(count + 1, np.complex128)
    for block, turned in _turned(values.size, cycles_per_sample, count):
        projections += turned.conj() @ weighted[block]
    right = np.concatenate([projections[:0:-1].conj(), projections])
    return np.asarray(np.linalg.lstsq(normal, right, rcond=None)[0])


def _turned(samples: int, cycles_per_sample: float, count: int) -> Iterator[tuple[slice, Complexes]]:
    """Evaluate exp(j n theta), n = 0 .. count, a block of samples at a time, shape (count + 1, block)."""
    for begin in range(0, samples, _BLOCK):
        block = slice(begin, min(begin + _BLOCK, samples))
        yield block, _powers(np.asarray(cycles_per_sample * np.arange(block.start, block.stop)), count)


def _powers(cycles: Reals, count: int) -> Complexes:
    powers = np.empty((count + 1, cycles.size), np.complex128)
    powers[0] = 1.0
    powers[1] = np.exp(2j * np.pi * np.mod(cycles, 1.0))
    for order in range(2, count + 1):
        powers[order] = powers[order - 1] * powers[1]
    return powers
