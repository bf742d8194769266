"""Spectra of overlapping segments averaged by Welch's method, with the confidence of what they show."""

import math
from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np

from trimmer.arguments import require_instances, whole_number
from trimmer.arrays import Reals
from trimmer.showing.drawn import Drawn
from trimmer.showing.shown import ShownFields, Tabular, counted
from trimmer.showing.table import Table, arrays
from trimmer.signals.band import EVERYWHERE, Band
from trimmer.signals.signal import Signal, SignalError
from trimmer.spectra.spectrum import FEWEST_SAMPLES, IN_UNIT_OF_SIGNAL
from trimmer.spectra.window import Window

CONFIDENCE = 0.95  # Confidence of all intervals

_NEAR = 40  # Bins on either side of a line from which the noise beside it is taken
_LARGE = 1e4
_FALSE_ALARM = 0.01
_SMALLEST_SQUARED, _LARGEST_SQUARED = 1e-140, 1e140


@dataclass(frozen=True)
class AveragedLine(ShownFields):
    """A line of an averaged spectrum.

    Attributes:
        frequency: Frequency, Hz, between bins.
        amplitude: Amplitude, in the signal's unit, without the noise in its bin.
        interval: Confidence interval of the amplitude, in the signal's unit, of a steady sine in Gaussian
            noise.
    """

    frequency: float
    amplitude: float
    interval: tuple[float, float]


@dataclass(frozen=True, eq=False, repr=False)
class AveragedSpectrum(Tabular, Drawn):
    """An averaged spectrum, single-sided.

    ``plot`` draws the power density over frequency, Hz, with the confidence of a density that is noise.

    Attributes:
        frequency: Frequency of each bin, Hz, shape (m,).
        density: Power density, in the square of the signal's unit over Hz, shape (m,): it adds up to the
            variance.
        window: Window of each segment.
        segment: Number of samples of a segment; half of them are shared with the next.
        averages: Number of segments.
        left_out: Number of samples in stretches that are shorter than a segment.
        equivalent_averages: Number of independent segments that scatter as little (Welch, 1967).
        colour: Power of the frequency with which the amplitude of noise is taken to grow.
        trusted: Frequencies in which lines are looked for.
    """

    frequency: Reals
    density: Reals
    window: Window
    segment: int
    averages: int
    left_out: int
    equivalent_averages: float
    colour: int = 0
    trusted: Band = EVERYWHERE

    @property
    def bin_width(self) -> float:
        """Distance of neighbouring bins, Hz."""
        return float(self.frequency[1])

    @property
    def noise_bandwidth(self) -> float:
        """Equivalent noise bandwidth of a bin, Hz: density times it is the power of a line."""
        return self.bin_width * self.window.noise_bandwidth

    @property
    def resolution(self) -> float:
        """How far two lines of like size must be apart to be seen as two, Hz."""
        return self.bin_width * self.window.parted

    @property
    def amplitude(self) -> Reals:
        """Amplitude of a sine that falls on a bin, noise included, in the signal's unit, shape (m,)."""
        return np.asarray(np.sqrt(2.0 * self.density * self.noise_bandwidth))

    @property
    def interval(self) -> tuple[float, float]:
        """Factors from a density that is noise to the ends of its confidence interval."""
        from scipy.stats import chi2

        freedom = 2.0 * self.equivalent_averages
        outside = 0.5 * (1.0 - CONFIDENCE)
        return freedom / float(chi2.ppf(1.0 - outside, freedom)), freedom / float(chi2.ppf(outside, freedom))

    def _told(self) -> str:
        segments, window = counted(self.averages, "segment"), self.window.word
        return f"{self.density.size} bins {self.bin_width:.6g} Hz apart, {segments}, {window} window"

    def _table(self) -> Table:
        columns = arrays(
            frequency=("Hz", self.frequency),
            density=(f"square of the {IN_UNIT_OF_SIGNAL} over Hz", self.density),
            amplitude=(IN_UNIT_OF_SIGNAL, self.amplitude),
        )
        return Table("Averaged spectrum", range(self.density.size), columns)

    def lines(self, limit: int) -> tuple[AveragedLine, ...]:
        """Find lines above the noise, by falling amplitude.

        A bin counts if noise of the level beside it would exceed it in one of 100 spectra in any bin.

        Args:
            limit: How many, the largest.

        Raises:
            ValueError: if it is no number from 1 on.
        """
        from scipy.stats import chi2

        whole_number("limit", limit, 1)
        freedom = 2.0 * self.equivalent_averages
        inside = np.arange(self.window.half_width, self.density.size - 1)
        at = self.frequency[inside]
        inside = inside[(at >= self.trusted.lowest) & (at <= self.trusted.highest)]
        if not inside.size:
            return ()
        noise = np.array([self._noise(place) for place in inside.tolist()])
        factor = float(chi2.isf(_FALSE_ALARM / inside.size, freedom)) / freedom
        here = self.density[inside]
        highest = (here >= self.density[inside - 1]) & (here > self.density[inside + 1])
        found = inside[highest & (here > factor * noise)]
        lines = [self._line(int(place)) for place in found[np.argsort(self.density[found])[::-1]]]
        return tuple(self._apart(lines)[:limit])

    def _apart(self, lines: Sequence[AveragedLine]) -> list[AveragedLine]:
        """Leave out what is a side lobe of a larger line, or within its main lobe."""
        kept: list[AveragedLine] = []
        for line in lines:
            if all(self._is_apart(line, other) for other in kept):
                kept.append(line)
        return kept

    def _is_apart(self, line: AveragedLine, larger: AveragedLine) -> bool:
        bins = (line.frequency - larger.frequency) / self.bin_width
        if abs(bins) < self.window.half_width:
            return False
        around = np.linspace(bins - 0.5, bins + 0.5, 5)
        leaked = larger.amplitude * float(np.abs(self.window.transform(around, self.segment)).max())
        return line.amplitude > 2.0 * leaked

    def _noise(self, place: int) -> float:
        """Return the density of the noise beside a bin, from the median of its neighbours."""
        width = self.window.half_width
        below = np.arange(max(1, place - _NEAR), max(1, place - width + 1))
        above = np.arange(min(place + width, self.density.size), min(place + _NEAR, self.density.size))
        near = np.concatenate([below, above])
        if not near.size:
            return 0.0
        level = float(np.median(self.density[near] * (place / near) ** (2.0 * self.colour)))
        freedom = 2.0 * self.equivalent_averages
        return level / (1.0 - 2.0 / (9.0 * freedom)) ** 3

    def _line(self, place: int) -> AveragedLine:
        offset, gain = self._between(place)
        power = float(self.density[place]) * self.noise_bandwidth
        noise = min(self._noise(place) * self.noise_bandwidth, power)
        low, high = line_interval(power, noise, self.equivalent_averages)
        scale = math.sqrt(2.0) / gain
        return AveragedLine(
            frequency=float(self.frequency[place]) + offset * self.bin_width,
            amplitude=scale * math.sqrt(max(power - noise, 0.0)),
            interval=(scale * math.sqrt(low), scale * math.sqrt(high)),
        )

    def _between(self, place: int) -> tuple[float, float]:
        """Return how far a line is from its bin, in bins, and what the window leaves of it there.

        The ratio of the larger neighbour to the bin gives the distance, by the window's transform.
        """
        below, here, above = np.sqrt(self.density[place - 1 : place + 2])
        offsets = np.linspace(0.0, 0.5, 501)
        at = np.abs(self.window.transform(offsets, self.segment))
        beside = np.abs(self.window.transform(offsets - 1.0, self.segment))
        nearest = int(np.argmin(np.abs(beside / at - max(below, above) / here)))
        sign = 1.0 if above >= below else -1.0
        return sign * float(offsets[nearest]), float(at[nearest])


def averaged_spectrum(
    signals: Signal | Sequence[Signal], averages: int = 8, window: Window | str = Window.HANN
) -> AveragedSpectrum:
    """Average the spectra of segments that overlap by half (Welch, 1967), each without its mean.

    Averaging makes noise scatter less, not its level lower; what it costs is resolution, since segments are
    shorter than the record.

    Args:
        signals: A signal, or its stretches between gaps, all at one sample rate and in one unit.
        averages: Number of segments wanted; their length is the largest that gives as many.
        window: Window of each segment, a member or its word, such as ``hann``.

    Raises:
        SignalError: if the stretches differ in sample rate or unit, or there are too few samples.
        ChoiceError: if there is no such window.
        WrongTypeError: if an argument is of another type.
        ValueError: if the number of averages is no number from 1 on.
    """
    from scipy.signal import welch

    stretches = (signals,) if isinstance(signals, Signal) else signals
    stretches = require_instances("signals", stretches, Signal, "a trimmer.Signal")
    whole_number("averages", averages, 1)
    window = Window.chosen(window, "window")
    _check_alike(stretches)
    counts = [stretch.values.size for stretch in stretches]
    segment = _segment(counts, averages)
    if segment < FEWEST_SAMPLES:
        raise SignalError(
            f"{sum(counts)} samples are too few for {averages} averages, each of {FEWEST_SAMPLES} or more; "
            "average fewer"
        )
    rate = stretches[0].sample_rate
    scale = max(float(np.abs(stretch.values).max()) for stretch in stretches) or 1.0
    if not _SMALLEST_SQUARED < scale < _LARGEST_SQUARED:
        raise SignalError(f"samples of the size of {scale:g} cannot be squared; use another unit")
    weights = window.samples(segment)
    half = segment // 2
    total, number = np.zeros(half + 1), 0
    for stretch in stretches:
        segments = _segments(stretch.values.size, segment)
        if segments:
            frequency, density = welch(
                stretch.values / scale, rate, weights, noverlap=half, detrend="constant"
            )
            total, number = total + segments * density, number + segments
    return AveragedSpectrum(
        frequency=np.asarray(frequency),
        density=np.asarray(total / number) * scale**2,
        window=window,
        segment=segment,
        averages=number,
        left_out=sum(count for count in counts if count < segment),
        equivalent_averages=_equivalent(weights, number),
        colour=stretches[0].converted,
        trusted=stretches[0].trusted,
    )


def line_interval(power: float, noise: float, averages: float) -> tuple[float, float]:
    """Return the confidence interval of the mean square of a steady sine, given the mean power in its bin.

    2 K P/n of K segments has the noncentral chi-squared distribution with 2 K degrees of freedom and the
    noncentrality 2 K s/n, with the power P, the noise n and the sine s in it. Where that is large, its
    root is normally distributed with variance 1.
    """
    if noise <= 0.0:
        return power, power
    from scipy.special import chdtrc, chndtrinc
    from scipy.stats import norm

    freedom, outside = 2.0 * averages, 0.5 * (1.0 - CONFIDENCE)
    seen = freedom * power / noise
    if seen > _LARGE:
        middle, half = math.sqrt(seen), float(norm.isf(outside))
        ends = [(middle + sign * half) ** 2 - (freedom - 1.0) for sign in (-1.0, 1.0)]
    else:
        # Where noise alone would show as much, or as little, the equation has no solution above 0.
        ends = [
            float(chndtrinc(seen, freedom, share)) if float(chdtrc(freedom, seen)) < 1.0 - share else 0.0
            for share in (1.0 - outside, outside)
        ]
    low, high = (max(0.0, end) * noise / freedom for end in ends)
    return low, high


def _check_alike(stretches: Sequence[Signal]) -> None:
    if not stretches:
        raise SignalError("there is no signal to average")
    kinds = {(stretch.sample_rate, stretch.unit) for stretch in stretches}
    if len(kinds) > 1:
        listed = ", ".join(sorted(f"{rate:g} Hz in {unit or 'no unit'}" for rate, unit in kinds))
        raise SignalError(f"signals of different kinds cannot be averaged: {listed}")


def _segments(samples: int, segment: int) -> int:
    """Return how many segments that overlap by half fit into a stretch."""
    return 0 if samples < segment else (samples - segment) // (segment - segment // 2) + 1


def _segment(counts: Sequence[int], averages: int) -> int:
    """Return the largest length that gives enough segments."""
    low, high = 0, max(counts)
    while low < high:
        middle = (low + high + 1) // 2
        enough = sum(_segments(count, middle) for count in counts) >= averages
        low, high = (middle, high) if enough else (low, middle - 1)
    return low


def _equivalent(weights: Reals, averages: int) -> float:
    """Return the number of independent segments, from what halves that are shared have in common."""
    shift = weights.size - weights.size // 2
    shared = float(weights[shift:] @ weights[: weights.size - shift]) / float(weights @ weights)
    return averages / (1.0 + 2.0 * (1.0 - 1.0 / averages) * shared**2)
