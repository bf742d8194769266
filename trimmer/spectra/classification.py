"""Classification of the peaks of a spectrum by frequency: harmonic, natural mode, limit cycle or hum."""

import math
from collections.abc import Iterable, Iterator, Sequence
from dataclasses import dataclass
from operator import attrgetter
from typing import final

from trimmer.arguments import real_number, require_instance, require_instances, shown, truth_value
from trimmer.errors import WrongTypeError
from trimmer.signals.signal import SignalError
from trimmer.spectra.peaks import Peak

OPEN_LOOP = (
    "limit cycles are left out: under a drive the pin's motion is given, so that nothing feeds the output "
    "back and no limit cycle can sustain itself; say that the loop is closed (--closed-loop) if the pin "
    "follows the output as well"
)
"""Why a driven trimmer is not said to have a limit cycle."""

TOLERANCE_BINS = 1.0  # How far from its frequency a peak may be, in bins: the resolution of a record

MODEL_TOLERANCE = 0.01  # How far a frequency that a model predicts may be off, relative

DENOMINATORS = range(2, 7)  # Denominators of the fractions of the drive that are looked for

FRACTION_BINS = 0.1
"""Share of the tolerance in bins for fractions, which lie so close that any peak is near one."""

ODD_ORDERS = (1, 3, 5)  # Harmonics of a limit cycle that are looked for: an odd element has odd ones only


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
class DriveFraction:
    """A line between the harmonics: a multiple of a fraction of the drive, reduced, so that 2/6 is 1/3.

    Attributes:
        numerator, denominator: p and q of p/q, without a common factor, q from 2 on.
        frequency: Frequency, Hz.
    """

    numerator: int
    denominator: int
    frequency: float

    @property
    def label(self) -> str:
        """Text for tables: the fraction."""
        return f"{self.numerator}/{self.denominator} of the drive"


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
    """A line at the frequency of a limit cycle that harmonic balance predicts.

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


@final
@dataclass(frozen=True)
class OwnMultiple:
    """A multiple of the frequency with which a motion without a drive repeats.

    Attributes:
        order: The multiple, 1 for that frequency.
        frequency: Frequency of the line, Hz.
    """

    order: int
    frequency: float

    @property
    def label(self) -> str:
        """Text for tables: the multiple, and of what."""
        return f"{self.order} x {self.frequency / self.order:.6g} Hz"


@final
@dataclass(frozen=True)
class MainsHum:
    """A multiple of the frequency of the mains.

    Attributes:
        order: The multiple.
        frequency: Frequency of the line, Hz.
    """

    order: int
    frequency: float

    @property
    def label(self) -> str:
        """Text for tables: the multiple, and of what."""
        return f"hum of the mains, {self.order} x {self.frequency / self.order:g} Hz"


Origin = Harmonic | DriveFraction | NaturalMode | LimitCycleLine | OwnMultiple | MainsHum


@final
@dataclass(frozen=True)
class Match:
    """A possible origin of a peak, with its distance from the peak.

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

    @property
    def share(self) -> float:
        """Its distance as a share of what it may be."""
        return abs(self.distance) / self.tolerance


@final
@dataclass(frozen=True)
class ClassifiedPeak:
    """A peak and what it may be.

    Attributes:
        peak: The peak.
        candidates: The nearest harmonic, a fraction of the drive that fits, the nearest natural mode and
            limit cycle, as far as there are any, the one first whose distance is the smallest part of its
            tolerance.
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


def match_of(peak: Peak, origin: Origin, bin_width: float, tolerance: float) -> Match:
    """Return how well a peak fits an origin; bin width in Hz, tolerance in bins."""
    return Match(origin, (peak.frequency - origin.frequency) / bin_width, tolerance)


def classified(peak: Peak, candidates: Iterable[Match]) -> ClassifiedPeak:
    """Return a peak with its candidates, the best one first."""
    return ClassifiedPeak(peak, tuple(sorted(candidates, key=attrgetter("share"))))


def require_positive(name: str, value: float) -> None:
    """Check that a frequency is positive and finite."""
    if not 0 < real_number(f"the {name}", value) < math.inf:
        raise SignalError(f"the {name} must be positive and finite, not {value!r}")


@final
@dataclass(frozen=True)
class Tolerance:
    """How far a peak may be from a candidate; the larger of the two counts.

    Attributes:
        bins: What the record cannot tell apart, in bins, > 0.
        model: How far off modes and limit cycles may be predicted, relative, from 0 on and below 1.

    Raises:
        SignalError: if one is out of its range.
        WrongTypeError: if one is no number.
    """

    bins: float = TOLERANCE_BINS
    model: float = MODEL_TOLERANCE

    def __post_init__(self) -> None:
        require_positive("tolerance in bins", self.bins)
        if not 0 <= real_number("the model tolerance", self.model) < 1:
            raise SignalError(f"the model tolerance must be 0 <= tolerance < 1, not {self.model!r}")


USUAL_TOLERANCE = Tolerance()


def classify(
    peaks: Sequence[Peak],
    bin_width: float,
    drive_frequency: float | None = None,
    natural_frequencies: Sequence[float] = (),
    limit_cycle_frequencies: Sequence[float] = (),
    *,
    closed_loop: bool = False,
    tolerance: Tolerance = USUAL_TOLERANCE,
) -> tuple[ClassifiedPeak, ...]:
    """Find for each peak whether it may be a harmonic of the drive, a natural mode or a limit cycle.

    A frequency shows what a peak may be, not what it is: where several candidates fit, all are given.

    Args:
        peaks: Peaks, frequencies in Hz.
        bin_width: Bin width of their spectrum, Hz.
        drive_frequency: Frequency of the drive, Hz; None without one.
        natural_frequencies: Frequencies of the natural modes, Hz; those that are not positive, of overdamped
            modes, are left out, and the others keep their numbers.
        limit_cycle_frequencies: Frequencies of the limit cycles, Hz. With a drive they are no candidates,
            unless the loop is closed: a limit cycle needs feedback from the output to the pin.
        closed_loop: Whether the pin follows the output although there is a drive.
        tolerance: How far a peak may be from a candidate.

    Returns:
        The peaks in their order.

    Raises:
        SignalError: if a frequency or the bin width is out of its range.
        WrongTypeError: if an argument is of another type.
    """
    _check(peaks, bin_width, drive_frequency, natural_frequencies, limit_cycle_frequencies)
    closed_loop = truth_value("closed_loop", closed_loop)
    require_instance("tolerance", tolerance, Tolerance, "a trimmer.spectra.Tolerance")
    modes = _modes(natural_frequencies)
    lines = _lines(limit_cycle_frequencies if drive_frequency is None or closed_loop else (), ODD_ORDERS)

    def candidates(peak: Peak) -> Iterator[Match]:
        if drive_frequency is not None:
            order = max(1, round(peak.frequency / drive_frequency))
            harmonic = match_of(peak, Harmonic(order, order * drive_frequency), bin_width, tolerance.bins)
            yield harmonic
            if not harmonic.fits:
                yield from _fractions(peak, drive_frequency, bin_width, FRACTION_BINS * tolerance.bins)
        for origins in filter(None, (modes, lines)):
            nearest = min(origins, key=lambda origin: abs(origin.frequency - peak.frequency))
            allowed = max(tolerance.bins, tolerance.model * nearest.frequency / bin_width)
            yield match_of(peak, nearest, bin_width, allowed)

    return tuple(classified(peak, candidates(peak)) for peak in peaks)


def _fractions(peak: Peak, drive: float, bin_width: float, tolerance: float) -> Iterator[Match]:
    """Yield the fraction of the drive with the least denominator that a peak may be, if any."""
    for denominator in DENOMINATORS:
        numerator = round(peak.frequency / drive * denominator)
        origin = DriveFraction(numerator, denominator, numerator * drive / denominator)
        match = match_of(peak, origin, bin_width, tolerance)
        if numerator and math.gcd(numerator, denominator) == 1 and match.fits:
            yield match
            return


def fundamentals(
    drive_frequency: float | None,
    natural_frequencies: Sequence[float],
    limit_cycle_frequencies: Sequence[float],
) -> tuple[Origin, ...]:
    """List what a peak may be but for the higher harmonics; arguments are those of ``classify``."""
    drive = [] if drive_frequency is None else [Harmonic(1, drive_frequency)]
    return (*drive, *_modes(natural_frequencies), *_lines(limit_cycle_frequencies, (1,)))


def _modes(frequencies: Sequence[float]) -> list[Origin]:
    return [NaturalMode(number, each) for number, each in enumerate(frequencies, start=1) if each > 0]


def _lines(frequencies: Sequence[float], orders: Sequence[int]) -> list[Origin]:
    return [
        LimitCycleLine(number, order, order * each)
        for number, each in enumerate(frequencies, start=1)
        for order in orders
    ]


def frequencies_of(name: str, values: Sequence[float]) -> tuple[float, ...]:
    """Return frequencies, Hz, as floats."""
    if isinstance(values, str | bytes) or not hasattr(type(values), "__iter__"):
        raise WrongTypeError(f"{name} must be a sequence of frequencies (Hz), not {shown(values)}")
    given = tuple(real_number(f"{name}[{place}]", value, "Hz") for place, value in enumerate(values))
    for place, value in enumerate(given):
        if not math.isfinite(value):
            raise SignalError(f"{name}[{place}] must be finite (Hz), not {value!r}")
    return given


def _check(
    peaks: Sequence[Peak],
    bin_width: float,
    drive_frequency: float | None,
    natural_frequencies: Sequence[float],
    limit_cycle_frequencies: Sequence[float],
) -> None:
    require_instances("peaks", peaks, Peak, "a trimmer.spectra.Peak")
    require_positive("bin width", bin_width)
    if drive_frequency is not None:
        require_positive("frequency of the drive", drive_frequency)
    frequencies_of("natural_frequencies", natural_frequencies)
    for frequency in frequencies_of("limit_cycle_frequencies", limit_cycle_frequencies):
        require_positive("frequency of a limit cycle", frequency)
