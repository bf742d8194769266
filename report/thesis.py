"""Values that the thesis uses in more than one place, each here once, in SI units."""

from __future__ import annotations

import math
from typing import Final

TURN: Final = 2 * math.pi
"""rad."""
DRIVE_FREQUENCY: Final = 100.0
"""Of the models of chapters 4 and 5, Hz."""
DRIVE_OMEGA: Final = TURN * DRIVE_FREQUENCY
MEASURED_DRIVE_FREQUENCY: Final = 109.945
"""Of the experiment, chapter 3, Hz."""
DRIVE_AMPLITUDE: Final = 0.0015
SMALL_GAP: Final = 4e-6
LARGE_GAP: Final = 4e-5
"""The two gaps of section 5.2.1."""
EXPERIMENT_GAP: Final = 2e-4
"""Gap of the experiment and the simulations with play of chapter 3."""
LISTING_NUMERATOR: Final = ("1e07", "1.233e10", "5.939e14", "1.65e17", "4.065e21", "3.667e23", "5.714e27")
LISTING_DENOMINATOR: Final = (
    *("1", "1378", "7.076e07", "3.878e10", "1.069e15"),
    *("2.676e17", "4.889e21", "4.595e23", "5.971e27"),
)
"""Coefficients of Listing A.9, lines 18 to 20, highest power first, as printed."""
PLOT_OFFSET: Final = 1e-6
"""How far above half of the gap the locus of Listing A.9 begins."""
ROUNDED: Final = "the coefficients of Listing A.9, rounded to four digits, are used"
"""The slip that most predictions of section 5.2 repeat."""
