"""Claim of section 5.2.2 on the peak at 659 Hz."""

from __future__ import annotations

import math

import numpy as np

from report.chapters.chapter_5.claims.driven_open_loop import LOOP_CLOSED
from report.claim import Claim, Confirmation, Impact, Part, Slip, Verdict
from report.comparisons.assertion import Assertion
from report.comparisons.digits import CloseNumbers, PrintedDigits
from report.comparisons.printed import power_of
from report.evidence import Evidence
from report.numbers.linear_numbers import DRIVE_AMPLITUDE, DRIVE_FREQUENCY
from report.numbers.record import largest_peaks, line_amplitudes
from report.numbers.timed_block import GAP, RECORD, TimedBlockNumbers
from trimmer import frequency_response
from trimmer.elements.inertia_backlash import InertiaBacklash

PEAK = "659"
MOST = 40
"""Peaks among which the largest is sought that is no multiple of the drive's frequency."""
SETTLED = 1e-6
BIN = 10.0
"""Width of a bin over 0.1 s, Hz."""


def claims(evidence: Evidence) -> tuple[Claim, ...]:
    """Return the claim."""
    return (_peak(evidence),)


def largest_other_line(numbers: TimedBlockNumbers) -> tuple[float, float]:
    """Return frequency (Hz) and amplitude (m) of the largest line of Listing A.8's block in the loop.

    Multiples of the drive's frequency do not count.
    """
    amplitudes = line_amplitudes(numbers.block_in_loop)
    bins_of_drive = round(DRIVE_FREQUENCY * RECORD.duration)
    other = next(number for number in largest_peaks(amplitudes, MOST) if number % bins_of_drive)
    return RECORD.frequency(other), float(amplitudes[other])


def peak_parts(evidence: Evidence) -> tuple[Part, ...]:
    """Return the parts on the peak at 659 Hz and its reading."""
    closed = evidence.motion.closed
    exact, block = closed.orbits.inertia.stable.frequency, closed.timed_block
    read, _ = largest_other_line(block)
    return (
        _open_loop(evidence),
        Part(
            "frequency of the limit cycle of inertia-controlled backlash",
            PrintedDigits(PEAK, exact, "Hz"),
            Confirmation(
                "the state at the impact and two durations, solved for with SciPy's matrix exponential",
                CloseNumbers(closed.orbits.inertia_by_durations, exact),
            ),
            Slip(
                f"{LOOP_CLOSED}; the bridge is the block of Listing A.8, a function of time; the record of "
                "0.1 s begins at rest; the digits after the point are cut off",
                math.floor(read),
                Verdict.ERRATUM,
            ),
        ),
    )


def _open_loop(evidence: Evidence) -> Part:
    block, peak = evidence.motion.closed.timed_block, float(PEAK)
    modes = [mode.frequency for mode in evidence.numbers.modes]
    nearest = min(modes, key=lambda frequency: abs(frequency - peak))
    multiple = DRIVE_FREQUENCY * round(peak / DRIVE_FREQUENCY)
    gain = InertiaBacklash(GAP).describing_function(DRIVE_AMPLITUDE, harmonic=7)
    response = frequency_response(evidence.numbers.displacement_only, 2 * math.pi * 7 * DRIVE_FREQUENCY)
    even = float(np.max(block.harmonics[2::2])) / float(block.harmonics[1])
    return Part(
        f"a line at {PEAK} Hz in open loop",
        Assertion(
            statement="the open loop driven at 100 Hz has one",
            derived=block.repeat > SETTLED or min(abs(multiple - peak), abs(nearest - peak)) < BIN,
            evidence=(
                f"odd multiples of 100 Hz stay, the nearest at {multiple:.0f} Hz with "
                f"{1e6 * block.harmonics[7]:.1f} µm (even ones are below {power_of(even)} of the first); "
                f"what dies out has the natural frequencies, the nearest at {nearest:.1f} Hz"
            ),
            method="periodic input of a stable linear system; exact simulation, gap 0.4 mm",
        ),
        Confirmation(
            "harmonic 7 by describing function and frequency response",
            CloseNumbers(DRIVE_AMPLITUDE * abs(complex(gain * response)), float(block.harmonics[7]), 1e-4),
        ),
    )


def _peak(evidence: Evidence) -> Claim:
    closed = evidence.motion.closed
    read, size = largest_other_line(closed.timed_block)
    frequency, decay = floquet_line(closed.timed_block)
    orbit = closed.orbits.inertia.stable
    return Claim(
        id="txt-5.2.2-open-loop-659",
        parts=peak_parts(evidence),
        explanation=(
            "No open loop holds a limit cycle, and this one no line at 659 Hz. With Listing A.8's block in "
            f"the loop and the drive as reference, 0.1 s from rest, the largest line beside multiples of "
            f"100 Hz is in the bin at {read:.1f} Hz ({1e6 * size:.0f} µm): a free motion of {frequency:.2f} "
            f"Hz that dies out with {decay:.0f}/s, of a loop whose feedback the block switches off while the "
            f"bridge flies. The limit cycle of inertia-controlled backlash is at {orbit.frequency:.2f} Hz. "
            "659 Hz is also six times 109.845 Hz, but at that drive the fifth harmonic would stand out."
        ),
        consequence=(
            "The 23.47 % that the section tries to explain by higher harmonics compare a prediction with an "
            "artefact of the block."
        ),
        impact=Impact.DOWNSTREAM,
        source="report/numbers/timed_block.py",
    )


def floquet_line(numbers: TimedBlockNumbers) -> tuple[float, float]:
    """Return frequency (Hz) and decay (1/s) of the Floquet exponent that shows nearest to the peak.

    An exponent is known up to multiples of the drive's frequency, and shows at all of them.
    """
    turns = numbers.exponents.imag / (2 * math.pi)
    shown = turns + DRIVE_FREQUENCY * np.round((float(PEAK) - turns) / DRIVE_FREQUENCY)
    slow = np.flatnonzero(np.abs(numbers.exponents.real) < 100)
    best = min(slow, key=lambda each: abs(shown[each] - float(PEAK)))
    return float(shown[best]), float(-numbers.exponents[best].real)
