"""The peaks that chapter 3 tabulates, as printed, and the bins of a spectrum on which they lie."""

from __future__ import annotations

from fractions import Fraction

from report.claim import Confirmation, Part, Slip, Verdict
from report.comparisons.digits import CloseNumbers, PrintedDigits

SAMPLE_RATE, FRAMES, DURATION, RESOLUTION = "20000", "2000", "0.1", "10"
"""Camera of the experiment (section 3.1): Hz, frames, s, Hz."""
FRAMES_OF_TABLES = 2001
"""Number of samples whose bins the tables hold: 0 to 0.1 s with both ends."""
BIN = Fraction(SAMPLE_RATE) / FRAMES_OF_TABLES
"""Distance of those bins, Hz."""
TABLE_1 = {1: "109.945", 3: "329.835", 5: "559.725"}
"""Table 3.1, Hz, by harmonic."""
DIFFERENCE = "219.890"
"""Both differences of table 3.1, Hz."""
TABLE_2 = {
    "M1": ("109.945", "219.890", "339.830", "439.780", "559.720"),
    "M2": ("109.450", "229.885", "339.830", "449.775", "549.725"),
    "M3": ("109.450", "229.885", "339.830", "439.780", "549.725"),
}
"""Table 3.2, Hz: harmonics 1 to 5 of each measurement."""
QUOTED = {
    "section 3.2": "109.845",
    "footnote 7 of section 5.2.1": "109.845",
    "appendix A.9": "109.845",
}
"""Other values of the measured drive frequency that are quoted, Hz."""
DRIVE_BIN = 11


def tabulated() -> tuple[str, ...]:
    """Return every frequency of the two tables, as printed."""
    return (*TABLE_1.values(), *(cell for row in TABLE_2.values() for cell in row))


def nearest_bin(frequency: float | str, samples: int = FRAMES_OF_TABLES) -> int:
    """Return the number of the bin nearest to a frequency (Hz)."""
    return round(Fraction(frequency) * samples / Fraction(SAMPLE_RATE))


def on_a_bin(printed: str, samples: int = FRAMES_OF_TABLES) -> bool:
    """Tell whether a bin rounds to the printed digits."""
    centre = nearest_bin(printed, samples) * Fraction(SAMPLE_RATE) / samples
    return PrintedDigits(printed, centre).compare().agrees


def drive_part(label: str, printed: str) -> Part:
    """Return a part on the drive's frequency as it is quoted, held against the bin of the first harmonic."""
    drive = DRIVE_BIN * BIN
    return Part(
        label,
        PrintedDigits(printed, drive, "Hz"),
        Confirmation(
            "a third of the third harmonic in table 3.1",
            CloseNumbers(float(TABLE_1[3]) / 3, float(drive), 1e-6),
        ),
        Slip("the digits after the point are cut off", Fraction(int(drive)), Verdict.EXPLAINED),
    )


def common_drive(bins: dict[int, int], within: Fraction) -> tuple[float, float]:
    """Return the lowest and the highest drive frequency whose harmonics lie near the bins, Hz.

    Args:
        bins: Bin of each harmonic.
        within: Greatest distance of a harmonic from its bin, in bins. Where there is no such frequency the
            lowest is above the highest.
    """
    low = max((place - within) / harmonic for harmonic, place in bins.items())
    high = min((place + within) / harmonic for harmonic, place in bins.items())
    return float(low * BIN), float(high * BIN)
