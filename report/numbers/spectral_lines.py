"""Lines of spectra that several places of the report name."""

from __future__ import annotations

from typing import Final

from report.numbers.record import largest_peaks, line_amplitudes
from report.numbers.timed_block import FREQUENCY, RECORD, TimedBlockNumbers

MOST: Final = 40
"""Peaks among which the largest is sought that is no multiple of the drive's frequency."""


def largest_other_line(numbers: TimedBlockNumbers) -> tuple[float, float]:
    """Return frequency (Hz) and amplitude (m) of the largest line of Listing A.8's block in the loop.

    Multiples of the drive's frequency do not count.
    """
    amplitudes = line_amplitudes(numbers.block_in_loop)
    bins_of_drive = round(FREQUENCY * RECORD.duration)
    other = next(number for number in largest_peaks(amplitudes, MOST) if number % bins_of_drive)
    return RECORD.frequency(other), float(amplitudes[other])
