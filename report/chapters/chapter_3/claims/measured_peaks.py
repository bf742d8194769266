"""The peaks that chapter 3 tabulates, as printed, and the bins of a spectrum on which they lie."""

from __future__ import annotations

from collections.abc import Mapping
from fractions import Fraction

from report.judging.comparisons.digits import PrintedDigits
from report.numbers.thesis import FRAMES_OF_TABLES, SAMPLE_RATE, TABLE_2

BIN = Fraction(SAMPLE_RATE, FRAMES_OF_TABLES)
"""Distance of those bins, Hz."""
DRIVE_BIN = 11
TABLE_1 = {1: "109.945", 3: "329.835", 5: "559.725"}
"""Table 3.1, Hz, by harmonic."""


def tabulated() -> tuple[str, ...]:
    """Return every frequency of the two tables, as printed."""
    return (*TABLE_1.values(), *(cell for row in TABLE_2.values() for cell in row))


def nearest_bin(frequency: float | str) -> int:
    """Return the number of the bin nearest to a frequency (Hz)."""
    return round(Fraction(frequency) * FRAMES_OF_TABLES / SAMPLE_RATE)


def on_a_bin(printed: str) -> bool:
    """Tell whether a bin rounds to the printed digits."""
    return PrintedDigits(printed, nearest_bin(printed) * BIN).compare().agrees


def common_drive(bins: Mapping[int, int], within: Fraction) -> tuple[float, float]:
    """Return the lowest and the highest drive frequency whose harmonics lie near the bins, Hz.

    Within so many bins of theirs; where there is no such frequency the lowest is above the highest.
    """
    low = max((place - within) / harmonic for harmonic, place in bins.items())
    high = min((place + within) / harmonic for harmonic, place in bins.items())
    return float(low * BIN), float(high * BIN)
