"""The lines of a measured motion at multiples of its drive, and the noise between them.

All lines together are the waveform averaged over the periods of the motion (Parseval), so that a fit to them
is one to the waveform with the noise of each frequency as its weight; nothing is counted twice.
"""

import math
from collections.abc import Mapping
from dataclasses import dataclass

import numpy as np

from trimmer.arrays import Complexes, Flags, Reals
from trimmer.fitting.stray import StrayLine, fraction_of, peaks_of, place_of, repeats_after, tolerance
from trimmer.signals import MotionQuantity, Signal, SignalError
from trimmer.spectra.comparison import SimulatedLines, found_frequency, sought
from trimmer.spectra.harmonics import MOST_HARMONICS, HarmonicFit, fit_harmonics
from trimmer.spectra.window import Window

MOST_ORDERS = 40  # Multiples of the drive that are looked at
MOST_SOUGHT = 60  # Lines at fractions and multiples of the drive by which its frequency is found
FEWEST_PERIODS = 12  # Periods of the motion in a record; with fewer no noise is seen between the lines
FEWEST_BINS = 60
"""Bins between lines from which the noise of a line is taken at least, as far as there are so many."""
GUARD = 2.5  # Bins beside a line that are not noise: the half width of the window's main lobe, and some
RARE = 1e-3  # Probability with which noise alone makes a line somewhere
SMALLEST_NOISE = 1e-7  # Noise, as a share of an output's largest line, below which more is not asked of a fit
WINDOW_SHARE = 1.944  # Bins of a Hann window that scatter as one: 1 + 2 (4/9 + 1/36)
SLOPE = 18.7  # Variance of a phase's slope over the record with a Hann window, over that of the phase with it
SOUGHT_TO = 1e-5  # Bins to which a frequency is sought
_BLOCK = 8192


@dataclass(frozen=True, eq=False)
class MeasuredLines:
    """A measured motion as lines."""

    signals: Mapping[str, Signal]  # The record of each output, SI, all with the same times
    frequency: float  # That of the drive, Hz
    found: bool  # Whether it was found in the measurement; else it was given
    period_count: int  # Drive periods k after which the motion repeats
    # Complex amplitudes at p/k of the drive, p = 1 ... m, with t = 0 at the first sample, in the units of the
    # signals, (m, outputs).
    lines: Complexes
    factors: Complexes  # Cholesky factors of the covariance of real or imaginary parts, (m, outputs, outputs)
    freedom: float  # Degrees of freedom of the noise that is estimated for a line
    strays: tuple[StrayLine, ...]  # Lines at no multiple of 1/k of the drive, largest first
    noiseless: bool  # Whether the noise was so small that ``SMALLEST_NOISE`` stands for it
    # Whether there is no drive: then what is told of it is meant of the vibration, and its frequency is a
    # datum too
    by_itself: bool = False

    @property
    def outputs(self) -> tuple[str, ...]:
        """Names of the outputs."""
        return tuple(self.signals)

    @property
    def derivatives(self) -> tuple[int, ...]:
        """How often each output is differentiated in its signal."""
        quantities = (each.quantity for each in self.signals.values())
        return tuple(0 if each is MotionQuantity.OTHER else each.derivatives for each in quantities)

    @property
    def deviations(self) -> Reals:
        """Standard deviation of the real or imaginary part of each line, (m, outputs)."""
        return np.asarray(np.sqrt(np.einsum("pij,pij->pi", self.factors, self.factors.conj()).real))

    @property
    def frequencies(self) -> Reals:
        """Frequency of each line, Hz, (m,)."""
        return np.asarray(np.arange(1, len(self.lines) + 1) * (self.frequency / self.period_count))

    @property
    def periods(self) -> float:
        """Drive periods in the record."""
        return next(iter(self.signals.values())).duration * self.frequency

    @property
    def frequency_deviation(self) -> float:
        """Standard deviation of the frequency as it is found in the record, Hz.

        Each harmonic tells it in proportion to its order and its size over the noise (Rife and Boorstyn 1974,
        with the window's loss).
        """
        orders = np.arange(1, len(self.lines) + 1)[:, None]
        told = float(np.sum(orders**2 * abs(self.whitened(self.lines)) ** 2)) / self.period_count**2
        duration = next(iter(self.signals.values())).duration
        return math.hypot(math.sqrt(SLOPE / told) / math.tau, SOUGHT_TO) / duration

    def whitened(self, lines: Complexes) -> Complexes:
        """Return lines, (m, outputs), in coordinates in which each part of the noise has variance 1."""
        return np.asarray(np.linalg.solve(self.factors, lines[..., None])[..., 0])


def measure_lines(
    signals: Mapping[str, Signal],
    near: float,
    drive_frequency: float | None = None,
    plain: Mapping[str, str] | None = None,
    by_itself: bool = False,
) -> MeasuredLines:
    """Take the lines of a steady motion out of its record, whose outputs have the same times.

    The drive is looked for near a frequency, Hz, unless it is known; what moves by itself, about the
    largest line. Outputs that are ``plain`` are no motion: their signals are taken as they are in this
    unit.
    """
    plain = plain or {}
    taken = {name for name, unit in plain.items() if name in signals and signals[name].unit == unit}
    for name in signals.keys() & {name for name, unit in plain.items() if unit} - taken:
        raise SignalError(f"{name}: the output is in {plain[name]}; give its signal so (--unit)")
    signals = {name: each if name in taken else _motion(each) for name, each in signals.items()}
    first = next(iter(signals.values()))
    if len({(each.values.size, each.sample_rate, each.start) for each in signals.values()}) > 1:
        raise SignalError("the signals have unlike times: give one record of all outputs, without gaps")
    found = drive_frequency is None
    frequency = drive_near(first, near, 1, by_itself) if drive_frequency is None else drive_frequency
    measured = _MeasuredRecord(signals, frequency, found, 1, by_itself).measured()
    periods = repeats_after(measured.strays)
    if periods > 1 and measured.periods >= FEWEST_PERIODS * periods:
        # The lines at fractions spoil a little what was found without them.
        frequency = drive_near(first, frequency, periods) if found else frequency
        return _MeasuredRecord(signals, frequency, found, periods, by_itself).measured()
    return measured


def drive_near(signal: Signal, near: float, periods: int, by_itself: bool = False) -> float:
    """Return the frequency of the drive of a motion that repeats after some periods of it, Hz."""
    count = min(MOST_HARMONICS * periods, MOST_SOUGHT)
    return found_frequency(signal, SimulatedLines(np.ones(count, complex), near, periods, "", by_itself))


def _motion(signal: Signal) -> Signal:
    if signal.quantity is MotionQuantity.OTHER:
        raise SignalError(
            f"{signal.name}: the unit {signal.unit!r} does not tell whether it is a displacement, a "
            "velocity or an acceleration; say what it is (--unit)"
        )
    return signal.in_si()


@dataclass(frozen=True, eq=False)
class _MeasuredRecord:
    """A record, and the frequency of its lines; attributes as of ``MeasuredLines``."""

    signals: Mapping[str, Signal]
    frequency: float
    found: bool
    period_count: int
    by_itself: bool

    @property
    def first(self) -> Signal:
        return next(iter(self.signals.values()))

    @property
    def step(self) -> float:
        return self.frequency / self.period_count

    @property
    def bin_width(self) -> float:
        return 1.0 / self.first.duration

    def measured(self) -> MeasuredLines:
        count = self._count()
        fits = [
            fit_harmonics(each.values, each.sample_rate, self.step, count, Window.HANN)
            for each in self.signals.values()
        ]
        lines = np.array([fit.coefficients for fit in fits]).T
        rests = np.array([_rest(*each) for each in zip(self.signals.values(), fits, strict=True)])
        between, strays = self._between(lines, rests)
        covariances, freedom, smallest = self._noise(lines, rests, between)
        seen = (abs(lines) ** 2 > 2 * math.log(lines.size / RARE) * _diagonals(covariances)).any(axis=1)
        if not seen.any():
            what, how = sought(self.by_itself)
            raise SignalError(
                f"no multiple of the {what} at {self.frequency:.6g} Hz stands out of the noise; say at which "
                f"frequency {how} (--drive)"
            )
        last = int(np.flatnonzero(seen)[-1]) + 1
        kept = min(count, max(math.ceil(1.25 * last) + 2 * self.period_count, 3 * self.period_count))
        return MeasuredLines(
            self.signals,
            self.frequency,
            self.found,
            self.period_count,
            lines[:kept],
            np.asarray(np.linalg.cholesky(covariances[:kept]), dtype=np.complex128),
            freedom,
            strays,
            bool(smallest),
            self.by_itself,
        )

    def _count(self) -> int:
        """Return how many lines the record shows."""
        rate, samples, (what, _) = self.first.sample_rate, self.first.values.size, sought(self.by_itself)
        if self.first.duration * self.step < FEWEST_PERIODS:
            raise SignalError(
                f"the record holds {self.first.duration * self.frequency:.3g} periods of the {what} at "
                f"{self.frequency:.6g} Hz; {FEWEST_PERIODS * self.period_count} or more are needed, so that "
                "noise is seen between the lines: measure longer"
            )
        highest = 0.5 * rate * (1.0 - 2 * Window.HANN.half_width / samples)
        highest = min(highest, *(each.trusted.highest for each in self.signals.values()))
        count = min(math.floor(highest / self.step), MOST_ORDERS * self.period_count, (samples - 1) // 2)
        if count < self.period_count:
            raise SignalError(f"samples at {rate:g} Hz show no {what} at {self.frequency:g} Hz")
        return count

    def _between(self, lines: Complexes, rests: Complexes) -> tuple[Flags, tuple[StrayLine, ...]]:
        """Return which bins hold noise alone, (bins,), and the lines that stand out of it."""
        frequencies = np.arange(rests.shape[1]) * self.bin_width
        apart = abs(frequencies - self.step * np.rint(frequencies / self.step))
        free = (apart > GUARD * self.bin_width) & (frequencies > GUARD * self.bin_width)
        free &= frequencies < (len(lines) + 0.5) * self.step  # higher harmonics are still in the rest
        free[-1] = False
        strays: list[StrayLine] = []
        for place, (name, rest) in enumerate(zip(self.signals, rests, strict=True)):
            power = 0.5 * abs(rest) ** 2
            least = (SMALLEST_NOISE * float(abs(lines[:, place]).max())) ** 2
            ratio = np.where(free, power / np.maximum(_floor(power, free), least), 0.0)
            for peak in peaks_of(ratio, math.log(free.sum() / RARE)):
                free[max(peak - 3, 0) : peak + 4] = False
                at = place_of(rest, peak) * self.bin_width
                within = tolerance(float(ratio[peak])) * self.bin_width
                fraction = fraction_of(at, self.frequency, within)
                strays.append(StrayLine(name, at, float(abs(rest[peak])), float(ratio[peak]), fraction))
        return free, tuple(sorted(strays, key=lambda each: -each.ratio))

    def _noise(self, lines: Complexes, rests: Complexes, between: Flags) -> tuple[Complexes, float, bool]:
        """Return the covariance of each line's parts, its freedom, and whether it was too small."""
        places = np.flatnonzero(between)
        centres = np.arange(1, len(lines) + 1) * self.step / self.bin_width
        outputs, used = len(rests), min(FEWEST_BINS, len(places))
        if used < 4 * outputs:
            raise SignalError("the record is too short to see noise between its lines: measure longer")
        covariances = np.empty((len(lines), outputs, outputs), dtype=complex)
        counts = []
        for row, centre in enumerate(centres):
            distances = abs(places - centre)
            reach = max(0.5 * self.frequency / self.bin_width, np.partition(distances, used - 1)[used - 1])
            near = rests[:, places[distances <= reach]]
            covariances[row] = 0.5 * near @ near.conj().T / near.shape[1]
            counts.append(near.shape[1])
        least = (SMALLEST_NOISE * abs(lines).max(axis=0)) ** 2
        small = _diagonals(covariances) < least
        covariances += np.where(small, least, 0.0)[:, :, None] * np.eye(outputs)
        return covariances, 2 * float(np.median(counts)) / WINDOW_SHARE, bool(small.any())


def _diagonals(covariances: Complexes) -> Reals:
    return np.asarray(np.einsum("pii->pi", covariances).real)


def _rest(signal: Signal, fit: HarmonicFit) -> Complexes:
    """Return the amplitudes with a Hann window of what the lines leave, (bins,)."""
    values = signal.values.copy()
    for begin in range(0, values.size, _BLOCK):
        block = slice(begin, min(begin + _BLOCK, values.size))
        values[block] -= fit.at(np.arange(block.start, block.stop) / signal.sample_rate)
    weights = Window.HANN.samples(values.size)
    return np.asarray(2.0 * np.fft.rfft(values * weights) / weights.sum())


def _floor(power: Reals, free: Flags) -> Reals:
    """Return the mean power of noise around each bin, from medians over stretches of free bins, (bins,)."""
    places = np.flatnonzero(free)
    pieces = np.array_split(places, max(1, len(places) // FEWEST_BINS))
    centres = np.array([piece.mean() for piece in pieces])
    levels = np.array([np.median(power[piece]) for piece in pieces]) / math.log(2.0)
    return np.asarray(np.interp(np.arange(power.size), centres, levels))
