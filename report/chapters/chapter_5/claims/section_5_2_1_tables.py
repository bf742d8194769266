"""Claims of section 5.2.1 on tables 5.1 and 5.2."""

from __future__ import annotations

import math

from report.chapters.chapter_5.claims.section_5_2_1 import (
    LARGE_GAP,
    ROUNDED,
    SOURCE,
    SecondWay,
    misread,
    predicted_amplitude,
    predicted_frequency,
)
from report.claim import Claim, Confirmation, Impact, Part, Slip, Verdict
from report.comparisons.digits import CloseNumbers, PrintedDigits
from report.comparisons.printed import power
from report.evidence import Evidence
from report.numbers.limit_cycle_numbers import LimitCycleNumbers, Pair

TABLE_GAPS = ("1e-4", "2e-4", "3e-4", "4e-4", "5e-4", "6e-4", "7e-4", "8e-4", "9e-4", "1e-3")
TABLE_AMPLITUDES = (
    *("0.00083", "0.0017", "0.0025", "0.0033", "0.0041"),
    *("0.0050", "0.0058", "0.0066", "0.0075", "0.0083"),
)


def claims(evidence: Evidence) -> tuple[Claim, ...]:
    """Return the claims in thesis order."""
    cycles = evidence.cycles
    second = SecondWay(evidence)
    return (_two_limit_cycles(cycles, second), _ten_gaps(cycles, second))


def _two_limit_cycles(cycles: LimitCycleNumbers, second: SecondWay) -> Claim:
    right, listing = cycles.friction, cycles.friction_listing
    ratio, omega = second.stable
    other_ratio, other_omega = second.unstable
    wrong = listing.unstable
    first = predicted_amplitude("3.3138e-4", LARGE_GAP, right.stable, listing.stable, ratio)
    other = predicted_amplitude("2.1089e-5", LARGE_GAP, right.unstable, wrong, other_ratio)
    return Claim(
        id="tab-5.1",
        parts=(
            _labelled("first: ", first),
            _first_frequency(listing, right, omega),
            _labelled("second: ", other),
            Part(
                "second: frequency",
                PrintedDigits("533.22", right.unstable.frequency, "Hz"),
                Confirmation("Newton's method in 30 digits", CloseNumbers(other_omega, right.unstable.omega)),
                Slip(
                    f"{ROUNDED}, and the second digit is written 3 instead of 5",
                    misread(wrong.frequency),
                    Verdict.ERRATUM,
                ),
            ),
        ),
        explanation=(
            f"With exact coefficients the second limit cycle lies at {right.unstable.frequency:.2f} Hz, with "
            f"those of Listing A.9 at {wrong.frequency:.2f} Hz; the printed 533.22 Hz has one digit wrong. "
            "The other cells come out with the rounded coefficients. Only 733.33 Hz takes a second slip, a "
            "number cut off: the percent error of the section has it rounded, as 733.34 Hz."
        ),
        consequence=(
            "The text repeats 533.22 Hz. The first limit cycle, on which the comparisons rest, is not "
            "touched."
        ),
        impact=Impact.LOCAL,
        source=SOURCE,
    )


def _first_frequency(listing: Pair, right: Pair, omega: float) -> Part:
    return Part(
        "first: frequency",
        PrintedDigits("733.33", right.stable.frequency, "Hz"),
        Confirmation("Newton's method in 30 digits", CloseNumbers(omega, right.stable.omega)),
        Slip(
            f"{ROUNDED}, and the {listing.stable.frequency:.4f} Hz that follow are cut off, not rounded",
            math.floor(100 * listing.stable.frequency) / 100,
            Verdict.EXPLAINED,
        ),
    )


def _labelled(prefix: str, part: Part) -> Part:
    return Part(f"{prefix}{part.label}", part.comparison, part.confirmation, part.slip)


def _ten_gaps(cycles: LimitCycleNumbers, second: SecondWay) -> Claim:
    right, listing = cycles.friction.stable, cycles.friction_listing.stable
    ratio, omega = second.stable
    parts = []
    for gap, printed in zip(TABLE_GAPS, TABLE_AMPLITUDES, strict=True):
        prefix = f"$b$ = {power(gap)} m, "
        row = (
            predicted_amplitude(printed, float(gap), right, listing, ratio),
            predicted_frequency("angular frequency", "4.6e3", right, listing, omega, "rad/s"),
            predicted_frequency("frequency", "733", right, listing, omega, "Hz"),
        )
        parts += [_labelled(prefix, part) for part in row]
    return Claim(
        id="tab-5.2",
        parts=tuple(parts),
        explanation=(
            f"Every amplitude is {right.amplitude:.4f} times the gap and every frequency "
            f"{right.frequency:.2f} Hz, in any row. With the rounded coefficients of Listing A.9 they are "
            f"{listing.amplitude:.4f} and {listing.frequency:.2f} Hz, which gives all printed cells; with "
            "exact ones the rows for $5\\times10^{-4}$ m and $8\\times10^{-4}$ m and all frequencies round "
            "to another last digit."
        ),
        consequence=(
            "None beyond the last digit. The ten rows hold one result, since nothing but the scale changes."
        ),
        impact=Impact.LOCAL,
        source=SOURCE,
    )
