"""Classification of the peaks of a spectrum by frequency: harmonic, natural mode or limit cycle."""

from __future__ import annotations

import math
from collections.abc import Iterator, Sequence
from dataclasses import dataclass
from typing import final

from trimmer.signals.signal import SignalError
from trimmer.spectra.peaks import Peak

TOLERANCE_BINS = 1.0
"""How far from its frequency a peak may be, in bins: the resolution of a record."""

MODEL_TOLERANCE = 0.01
"""How far a frequency that a model predicts may be off, relative."""

ODD_ORDERS = (1, 3, 5)
"""Harmonics of a limit cycle that are looked for: an odd element has odd ones only."""


@final
@dataclass(frozen=True)
class Harmonic:
    """A harmonic of the drive.

    Attributes:
        order: Number n of the harmonic, 1 for the drive itself.
        frequency: Frequency, Hz.
    """

    order: int
    frequency: float

    @property
    def odd(self) -> bool:
        """Whether the order is odd; an odd element has no even harmonics."""
        return self.order % 2 == 1

    @property
    def label(self) -> str:
        """Text for tables: ``drive``, or number and parity of the harmonic."""
        if self.order == 1:
            return "drive"
        return f"harmonic {self.order} ({'odd' if self.odd else 'even'})"


@final
@dataclass(frozen=True)
class NaturalMode:
    """A natural mode of the linear model.

    Attributes:
        number: Its number, from 1.
        frequency: Frequency, Hz.
    """

    number: int
    frequency: float

    @property
    def label(self) -> str:
        """Text for tables: the number of the mode."""
        return f"natural mode {self.number}"


@final
@dataclass(frozen=True)
class LimitCycleLine:
    """A line of a limit cycle.

    Attributes:
        number: Number of the limit cycle, from 1.
        order: Number of the harmonic, 1 for the fundamental.
        frequency: Frequency of the line, Hz.
    """

    number: int
    order: int
    frequency: float

    @property
    def label(self) -> str:
        """Text for tables: the number of the limit cycle and of the harmonic."""
        harmonic = "" if self.order == 1 else f", harmonic {self.order}"
        return f"limit cycle {self.number}{harmonic}"


Origin = Harmonic | NaturalMode | LimitCycleLine


@final
@dataclass(frozen=True)
class Match:
    """A candidate for a peak.

    Attributes:
        origin: The line that the peak may be.
        distance: Frequency of the peak less that of the origin, in bins.
        tolerance: Largest distance, in bins, at which the peak may be that.
    """

    origin: Origin
    distance: float
    tolerance: float

    @property
    def fits(self) -> bool:
        """Whether the peak may be that."""
        return abs(self.distance) <= self.tolerance


@final
@dataclass(frozen=True)
class ClassifiedPeak:
    """A peak and what it may be.

    Attributes:
        peak: The peak.
        candidates: The nearest harmonic, natural mode and limit cycle, as far as there are any, the one first
            whose distance is the smallest part of its tolerance.
    """

    peak: Peak
    candidates: tuple[Match, ...]

    @property
    def explanation(self) -> Match | None:
        """The best candidate that fits; None for an unexplained peak."""
        return self.candidates[0] if self.candidates and self.candidates[0].fits else None

    @property
    def second(self) -> Match | None:
        """Another candidate that fits, so that frequency alone does not decide between them; None if none."""
        return self.candidates[1] if len(self.candidates) > 1 and self.candidates[1].fits else None

    @property
    def ambiguous(self) -> bool:
        """Whether several candidates fit, so that frequency alone does not decide."""
        return self.second is not None


def classify(
    peaks: Sequence[Peak],
    bin_width: float,
    drive: float | None = None,
    natural_frequencies: Sequence[float] = (),
    limit_cycles: Sequence[float] = (),
    tolerance_bins: float = TOLERANCE_BINS,
    model_tolerance: float = MODEL_TOLERANCE,
) -> tuple[ClassifiedPeak, ...]:
    """Find for each peak whether it may be a harmonic of the drive, a natural mode or a limit cycle.

    A frequency shows what a peak may be, not what it is: where several candidates fit, all are given.

    Args:
        peaks: Peaks, frequencies in Hz.
        bin_width: Bin width of their spectrum, Hz.
        drive: Frequency of the drive, Hz; None without one.
        natural_frequencies: Frequencies of the natural modes, Hz; those that are not positive, of overdamped
            modes, are left out, and the others keep their numbers.
        limit_cycles: Frequencies of the limit cycles, Hz.
        tolerance_bins: How far a peak may be from a candidate, in bins.
        model_tolerance: How far off modes and limit cycles may be predicted, relative; counts if it is more.

    Returns:
        The peaks in their order.

    Raises:
        SignalError: if a frequency, the bin width or a tolerance is out of its range.
    """
    _check(bin_width, drive, limit_cycles, tolerance_bins, model_tolerance)
    modes: list[Origin] = [
        NaturalMode(number, frequency)
        for number, frequency in enumerate(natural_frequencies, start=1)
        if frequency > 0
    ]
    lines: list[Origin] = [
        LimitCycleLine(number, order, order * frequency)
        for number, frequency in enumerate(limit_cycles, start=1)
        for order in ODD_ORDERS
    ]

    def candidates(peak: Peak) -> Iterator[Match]:
        if drive is not None:
            order = max(1, round(peak.frequency / drive))
            yield _match(peak, Harmonic(order, order * drive), bin_width, tolerance_bins)
        for origins in filter(None, (modes, lines)):
            nearest = min(origins, key=lambda origin: abs(origin.frequency - peak.frequency))
            allowed = max(tolerance_bins, model_tolerance * nearest.frequency / bin_width)
            yield _match(peak, nearest, bin_width, allowed)

    return tuple(ClassifiedPeak(peak, tuple(sorted(candidates(peak), key=_share))) for peak in peaks)


def _match(peak: Peak, origin: Origin, bin_width: float, tolerance: float) -> Match:
    return Match(origin, (peak.frequency - origin.frequency) / bin_width, tolerance)


def _share(match: Match) -> float:
    return abs(match.distance) / match.tolerance


def _check(
    bin_width: float,
    drive: float | None,
    limit_cycles: Sequence[float],
    tolerance_bins: float,
    model_tolerance: float,
) -> None:
    named = [("bin width", bin_width), ("tolerance in bins", tolerance_bins)]
    named += [] if drive is None else [("frequency of the drive", drive)]
    named += [("frequency of a limit cycle", frequency) for frequency in limit_cycles]
    for name, value in named:
        if not 0 < value < math.inf:
            raise SignalError(f"the {name} must be positive and finite, not {value!r}")
    if not 0 <= model_tolerance < 1:
        raise SignalError(f"the model tolerance must be 0 <= tolerance < 1, not {model_tolerance!r}")
