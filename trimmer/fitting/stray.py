"""Lines of a measurement that are not at multiples of the drive: fractions of it, and others."""

import math
from dataclasses import dataclass

import numpy as np

from trimmer.arrays import Complexes, Reals

MOST_PERIODS = 8  # Largest number of drive periods after which a measured motion is taken to repeat
NEAR, NEAREST = 0.4, 0.05
"""Distances in bins within which a line is that of a fraction: of a faint one, and of a strong one."""


@dataclass(frozen=True)
class StrayLine:
    """A line between the harmonics of the drive."""

    output: str  # Name of the output
    frequency: float  # Hz
    amplitude: float  # In the unit of the signal
    ratio: float  # Its power over that of the noise around it
    fraction: tuple[int, int] | None  # (p, q) if it is at p/q of the drive, q up to 8; None for another


def fraction_of(frequency: float, drive: float, within: float) -> tuple[int, int] | None:
    """Return the fraction of a drive, Hz, of least denominator within some Hz of a frequency, if any."""
    for periods in range(2, MOST_PERIODS + 1):
        order = round(frequency * periods / drive)
        near = abs(frequency - order * drive / periods) <= within
        if near and order >= 1 and math.gcd(order, periods) == 1:
            return order, periods
    return None


def tolerance(ratio: float) -> float:
    """Return how far from its place a line may be found, in bins, by the ratio of its power to the noise."""
    return min(NEAR, NEAREST + 2.0 / math.sqrt(ratio))


def repeats_after(strays: tuple[StrayLine, ...]) -> int:
    """Return the number of drive periods after which a motion with such lines repeats, at most 8; else 1."""
    periods = 1
    for each in strays:
        together = math.lcm(periods, each.fraction[1] if each.fraction else 1)
        periods = together if together <= MOST_PERIODS else periods
    return periods


def place_of(amplitudes: Complexes, peak: int) -> float:
    """Return the place of a line between bins, from its two largest bins with a Hann window.

    Rife and Boorstyn (1974), Bell System Technical Journal 55, 197-228: a ratio r of them puts the line
    (2 r - 1) / (r + 1) bins from the larger one.
    """
    sign = 1 if abs(amplitudes[peak + 1]) > abs(amplitudes[peak - 1]) else -1
    ratio = float(abs(amplitudes[peak + sign]) / abs(amplitudes[peak]))
    return peak + sign * (2.0 * ratio - 1.0) / (ratio + 1.0)


def peaks_of(power: Reals, limit: float) -> list[int]:
    """Return the places of local maxima of powers, (n,), above a limit."""
    inside = power[1:-1]
    rising = (inside > limit) & (inside >= power[:-2]) & (inside > power[2:])
    return [int(place) + 1 for place in np.flatnonzero(rising)]


def in_words(count: int, what: str = "drive") -> str:
    """Return a number of periods of the drive, or of what else, in words."""
    return f"one {what} period" if count == 1 else f"{count} {what} periods"
