"""Peaks of spectra as the thesis prints them, Hz."""

from __future__ import annotations

from typing import Final

FRAMES_OF_TABLES: Final = 2001
"""Number of samples whose bins the tables of chapter 3 hold: 0 to 0.1 s with both ends."""
TABLE_2: Final = {
    "M1": ("109.945", "219.890", "339.830", "439.780", "559.720"),
    "M2": ("109.450", "229.885", "339.830", "449.775", "549.725"),
    "M3": ("109.450", "229.885", "339.830", "439.780", "549.725"),
}
"""Table 3.2: harmonics 1 to 5 of each measurement."""
RELEASED_PEAKS: Final = ("221.989", "369.996", "736.993")
"""Peaks of the loop with friction (section 5.2.5)."""
