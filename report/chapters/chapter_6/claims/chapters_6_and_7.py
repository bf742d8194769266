"""Claims of chapters 6 and 7 that rest on the linear model and on harmonic balance."""

from __future__ import annotations

import math

from report.claim import Claim, Confirmation, Impact, Part
from report.comparisons.assertion import Assertion
from report.comparisons.digits import CloseNumbers, PrintedDigits
from report.comparisons.printed import power
from report.evidence import Evidence
from report.numbers.exact_response import gain
from report.numbers.light_damping import lightly_damped
from report.numbers.linear_numbers import DRIVE_FREQUENCY, LinearNumbers
from trimmer import InputChannels, asymptotic_roll_off, resonance_peaks, transfer_function

HIGH_OMEGA = 1e8
GAPS_QUOTED = {"section 3.2": "200e-6", "chapter 6": "200e-6", "section 6.4": "100e-6"}


def claims(evidence: Evidence) -> tuple[Claim, ...]:
    """Return the claims in thesis order."""
    numbers = evidence.numbers
    return (_gap(), _filter_order(numbers), _damping(numbers), _operating_frequency(numbers))


def _gap() -> Claim:
    different = sorted(set(GAPS_QUOTED.values()))
    return Claim(
        id="txt-6-gap-quoted",
        parts=(
            Part(
                "",
                Assertion(
                    statement="the gap of the experiment is quoted alike everywhere",
                    derived=len(different) == 1,
                    evidence=", ".join(f"{power(gap)} m in {place}" for place, gap in GAPS_QUOTED.items()),
                    method="read in the three places",
                ),
            ),
        ),
        explanation=(
            "Section 6.4 gives half of what section 3.2 and chapter 6 give. One may be the total gap and the "
            "other half of it, but neither place says so."
        ),
        consequence="Any amplitude predicted for the experiment is uncertain by a factor of two.",
        impact=Impact.LOCAL,
        source="report/chapters/chapter_6/claims/chapters_6_and_7.py",
    )


def _filter_order(numbers: LinearNumbers) -> Claim:
    order = -asymptotic_roll_off(numbers.displacement_only) / 20
    slope = 20 * math.log10(float(gain(numbers, 10 * HIGH_OMEGA) / gain(numbers, HIGH_OMEGA)))
    return Claim(
        id="txt-6.2-filter-order",
        parts=(
            Part(
                "",
                PrintedDigits("1", order),
                Confirmation(
                    "the slope of the exact gain at $10^{8}$ rad/s", CloseNumbers(-slope / 20, order, 1e-6)
                ),
            ),
        ),
        explanation=(
            "The order is two, see section 5.1.2. So the transfer function is not on the edge of filtering "
            "because of its order; where the hypothesis fails, it fails because of the resonances."
        ),
        consequence="The caution that the chapter draws from order one has the wrong ground.",
        impact=Impact.DOWNSTREAM,
        source="trimmer/low_pass.py",
    )


def _damping(numbers: LinearNumbers) -> Claim:
    light = transfer_function(lightly_damped(numbers.parameters), channels=InputChannels.DISPLACEMENT_ONLY)
    with_damping = max(peak.magnitude for peak in resonance_peaks(numbers.displacement_only))
    without = max(peak.magnitude for peak in resonance_peaks(light))
    exact = max(float(gain(numbers, peak.omega)) for peak in resonance_peaks(numbers.displacement_only))
    return Claim(
        id="txt-7-damping",
        parts=(
            Part(
                "",
                Assertion(
                    statement="damping increases the magnitude of the resonances",
                    derived=with_damping > without,
                    evidence=(
                        f"the highest peak is {with_damping:.1f} with damping and {without:.0f} with a "
                        "thousandth of it"
                    ),
                    method="all local maxima of the gain for both dampings",
                ),
                Confirmation("exact coefficients, 40 digits", CloseNumbers(exact, with_damping)),
            ),
        ),
        explanation=(
            "Damping lowers every resonance, as section 5.1.3 itself says. The answer to the first research "
            "question states the opposite."
        ),
        consequence=(
            "The answer has to read: damping lowers the resonances, and moves them by two percent at most."
        ),
        impact=Impact.LOCAL,
        source="trimmer/extrema.py",
    )


def _operating_frequency(numbers: LinearNumbers) -> Claim:
    lowest = min(mode.frequency for mode in numbers.modes)
    undamped = min(mode.omega for mode in numbers.undamped) / (2 * math.pi)
    return Claim(
        id="txt-7-operating-frequency",
        parts=(
            Part(
                "",
                Assertion(
                    statement="the resonances lie below the operating frequency",
                    derived=lowest < DRIVE_FREQUENCY,
                    evidence=f"the lowest is at {lowest:.2f} Hz, the drive at {DRIVE_FREQUENCY:.0f} Hz",
                    method="eigenvalues",
                ),
                Confirmation("the undamped eigenvalue problem", CloseNumbers(undamped, lowest, 1e-3)),
            ),
        ),
        explanation=(
            "It is the other way round: all resonances lie above the operating frequency, as section 5.1.3 "
            "says. That does not make them irrelevant, because the harmonics of the drive reach them."
        ),
        consequence="None on numbers; the answer to the first research question contradicts chapter 5.",
        impact=Impact.LOCAL,
        source="trimmer/modal_analysis.py",
    )
