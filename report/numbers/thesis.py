"""Values that the thesis uses in more than one place, each here once, in SI units; strings are as printed."""

import math
from typing import Final

TURN: Final = 2 * math.pi  # A full turn, rad
DRIVE_FREQUENCY: Final = 100.0  # Of the models of chapters 4 and 5, Hz
DRIVE_OMEGA: Final = TURN * DRIVE_FREQUENCY
MEASURED_DRIVE_FREQUENCY: Final = 109.945  # Of the experiment, chapter 3, Hz
MEASURED_DRIVE_OMEGA: Final = TURN * MEASURED_DRIVE_FREQUENCY
DRIVE_AMPLITUDE: Final = 0.0015
SMALL_GAP: Final = 4e-6
LARGE_GAP: Final = 4e-5  # The two gaps of section 5.2.1
TIMED_GAP: Final = 4e-4  # Gap of the blocks over time, section 4.2 and Listing A.8
LISTED_CONTACT, LISTED_OFFSET = "0.00190662", "0.0049"
"""Constants of Listing A.8: time of contact (line 8), s, and offset of line 12, m."""
EXPERIMENT_GAP: Final = 2e-4  # Gap of the experiment and the simulations with play of chapter 3
TIME_CONSTANT: Final = 1 / 99  # M/D of section 4.2.3, s
RELAY_LEVEL: Final = 0.015
"""Coulomb force, or level of a relay, of figures 5.18 and 5.19; the thesis gives no unit."""
LARGER_GAP, LARGEST_GAP = 2e-3, 2e-2  # The two other gaps that chapter 3 simulates
SAMPLE_RATE: Final = 20_000  # Of the experiment's camera, Hz
FRAMES_OF_TABLES: Final = 2001
"""Number of samples whose bins the tables of chapter 3 hold: 0 to 0.1 s with both ends."""
TABLE_2: Final = {
    "M1": ("109.945", "219.890", "339.830", "439.780", "559.720"),
    "M2": ("109.450", "229.885", "339.830", "449.775", "549.725"),
    "M3": ("109.450", "229.885", "339.830", "439.780", "549.725"),
}
"""Table 3.2, Hz: harmonics 1 to 5 of each measurement."""
OPEN_LOOP_PEAK: Final = "365.999"  # Peak of figure 3.8 that is no harmonic, Hz
LIMIT_CYCLE_OMEGA: Final = 4607.7
"""Angular frequency of the limit cycle that table 5.1 predicts at 733.33 Hz, rad/s."""
RELEASED_PEAKS: Final = ("221.989", "369.996", "736.993")
"""Peaks of the loop with friction (section 5.2.5), Hz."""
LISTING_NUMERATOR: Final = ("1e07", "1.233e10", "5.939e14", "1.65e17", "4.065e21", "3.667e23", "5.714e27")
LISTING_DENOMINATOR: Final = (
    *("1", "1378", "7.076e07", "3.878e10", "1.069e15"),
    *("2.676e17", "4.889e21", "4.595e23", "5.971e27"),
)
"""Coefficients of Listing A.9, lines 18 to 20, highest power first."""
PLOT_OFFSET: Final = 1e-6  # How far above half of the gap the locus of Listing A.9 begins
ROUNDED: Final = "the coefficients of Listing A.9, rounded to four digits, are used"
"""The slip that most predictions of section 5.2 repeat."""
