"""Lines that need no drive: multiples of the frequency with which a motion repeats, and hum of the mains."""

from collections.abc import Iterator, Sequence
from dataclasses import replace

from trimmer.spectra.analysis import SpectrumAnalysis
from trimmer.spectra.classification import (
    FRACTION_BINS,
    TOLERANCE_BINS,
    MainsHum,
    Match,
    OwnMultiple,
    classified,
    frequencies_of,
    match_of,
)
from trimmer.spectra.peaks import Peak

HIGHEST = 20  # The largest multiple of a motion's own frequency by which that is told
FEWEST = 3  # How many multiples there are of it at least
MAINS = (50.0, 60.0)  # Frequencies of the mains, Hz
MAINS_ORDERS = 10  # Multiples of these that are looked for: beyond, any peak is near one
MAINS_TOLERANCE = 0.001  # How far the mains may be off, relative: 50 mHz of 50 Hz in normal operation


def with_own_lines(
    analysis: SpectrumAnalysis, own_frequency: float | None = None, mains_frequencies: Sequence[float] = MAINS
) -> SpectrumAnalysis:
    """Return an analysis whose peaks may also be multiples of the motion's own frequency, or hum.

    Args:
        analysis: The analysis of a signal.
        own_frequency: That with which the motion repeats without a drive, Hz, as in a limit cycle; looked for
            among the peaks if not given and the analysis has no drive.
        mains_frequencies: Frequencies of the mains, Hz.

    Raises:
        SignalError: if a frequency is infinite or NaN.
        WrongTypeError: if the frequencies are no numbers.
    """
    width, mains = analysis.spectrum.bin_width, frequencies_of("mains_frequencies", mains_frequencies)
    if own_frequency is None and analysis.harmonics is None:
        own_frequency = repetition([each.peak for each in analysis.peaks], width)
    found = (
        classified(each.peak, (*each.candidates, *_lines(each.peak, own_frequency, mains, width)))
        for each in analysis.peaks
    )
    return replace(analysis, peaks=tuple(found))


def _lines(peak: Peak, own: float | None, mains: Sequence[float], width: float) -> Iterator[Match]:
    """Yield the nearest multiples of a motion's own frequency, and of those of the mains, that fit a peak."""
    if own is not None:
        order = max(1, round(peak.frequency / own))
        match = match_of(peak, OwnMultiple(order, order * own), width, TOLERANCE_BINS)
        yield from [match] if match.fits else []
    for each in mains:
        order = max(1, round(peak.frequency / each))
        allowed = max(TOLERANCE_BINS, MAINS_TOLERANCE * order * each / width)
        match = match_of(peak, MainsHum(order, order * each), width, allowed)
        yield from [match] if match.fits and order <= MAINS_ORDERS else []


def repetition(peaks: Sequence[Peak], bin_width: float) -> float | None:
    """Return the frequency, Hz, of which a motion without a drive is multiples; None if of none.

    It is that of a peak of which two others at least are multiples, with most of the power in all of
    them.
    """
    power = {each.frequency: each.amplitude**2 for each in peaks}
    best, most = None, 0.5 * sum(power.values())
    for base in sorted((each for each in power if each > bin_width), reverse=True):
        lines = _multiples(base, list(power), bin_width)
        explained = sum(power[each] for each in lines)
        if len(set(lines.values())) >= FEWEST and explained > most * (1 + 1e-6):
            best, most = base, explained
    return best


def _multiples(base: float, frequencies: Sequence[float], bin_width: float) -> dict[float, int]:
    """Return the frequencies that are multiples of one, with the multiple, Hz."""
    orders = {each: round(each / base) for each in frequencies}
    return {
        each: order
        for each, order in orders.items()
        if 1 <= order <= HIGHEST
        and abs(each - order * base) <= min(TOLERANCE_BINS, FRACTION_BINS * order) * bin_width
    }
