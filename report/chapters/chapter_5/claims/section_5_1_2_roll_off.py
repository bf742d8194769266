"""Claims of section 5.1.2 on the low-pass filter: its cutoff, its roll-off and its order."""

from __future__ import annotations

import math

import numpy as np

from report.chapters.chapter_5.claims.section_5_1_2_low_pass import LIMIT_CYCLE_OMEGA, SOURCE
from report.claim import Claim, Confirmation, Impact, Part, Slip, Verdict
from report.comparisons.digits import CloseNumbers, PrintedDigits
from report.evidence import Evidence
from report.numbers.exact_response import gain, gain_crossing
from report.numbers.linear_numbers import LinearNumbers
from trimmer import (
    asymptotic_roll_off,
    bandwidth_crossings,
    gain_crossings,
    local_slope,
)

ROLL_OFF_FROM = 4700.0
"""Angular frequency above which the slope of the gain is examined, rad/s."""
HIGH_OMEGA = 1e8


def claims(evidence: Evidence) -> tuple[Claim, ...]:
    """Return the claims in thesis order."""
    return (_cutoff(evidence.numbers), _roll_off(evidence.numbers))


def _cutoff(numbers: LinearNumbers) -> Claim:
    system = numbers.displacement_only
    unity = gain_crossings(system)[-1]
    crossings = bandwidth_crossings(system)
    level = float(gain(numbers, 0)) * 10 ** (-3 / 20)
    slip = Slip("the highest frequency with |G| = 1 (0 dB) is taken", unity, Verdict.EXPLAINED)
    labels = {"first -3 dB frequency": crossings[0], "last -3 dB frequency": crossings[-1]}
    return Claim(
        id="txt-5.1.2-cutoff",
        parts=tuple(
            Part(
                label,
                PrintedDigits("4.6329e+03", omega, "rad/s"),
                Confirmation(
                    "a root search on exact coefficients",
                    CloseNumbers(gain_crossing(numbers, level, omega), omega),
                ),
                slip,
            )
            for label, omega in labels.items()
        ),
        explanation=(
            f"The printed number is the highest frequency at which $|G| = 1$, {unity:.2f} rad/s, not a "
            "cutoff. The cutoff is where the gain is 3 dB below its static value: first at "
            f"{crossings[0]:.1f} rad/s, in the valley between two resonances, and for good at "
            f"{crossings[-1]:.1f} rad/s, beyond the last one."
        ),
        consequence=(
            f"The number is not used again. It lies {100 * (unity / LIMIT_CYCLE_OMEGA - 1):.1f} % above the "
            "predicted limit cycle, and not by accident: where the play is small beside the amplitude, $|N|$ "
            "and so $|G|$ are close to one."
        ),
        impact=Impact.LOCAL,
        source=SOURCE,
    )


def _roll_off(numbers: LinearNumbers) -> Claim:
    system = numbers.displacement_only
    slope = asymptotic_roll_off(system)
    chord = 20 * math.log10(float(gain(numbers, 1e4) / gain(numbers, 1e3)))
    least_steep = float(local_slope(system, np.geomspace(ROLL_OFF_FROM, HIGH_OMEGA, 4000)).max())
    both = numbers.both_channels
    corner = numbers.parameters.k2 / numbers.parameters.c2
    far = Confirmation(
        "the slope of the exact gain at $10^{8}$ rad/s",
        CloseNumbers(
            20 * math.log10(float(gain(numbers, 10 * HIGH_OMEGA) / gain(numbers, HIGH_OMEGA))), slope, 1e-6
        ),
    )
    return Claim(
        id="txt-5.1.2-roll-off",
        parts=(
            Part(
                "roll-off",
                PrintedDigits("-20", slope, "dB/decade"),
                far,
                Slip(
                    "the fall over the decade from $10^{3}$ to $10^{4}$ rad/s is read as the slope",
                    chord,
                    Verdict.ERRATUM,
                ),
            ),
            _order(numbers, slope, chord),
        ),
        explanation=(
            f"There are two poles more than zeros, so the gain falls by {-slope:.0f} dB per decade in the "
            f"end, and above {ROLL_OFF_FROM:.0f} rad/s nowhere by less than {-least_steep:.1f}. From $10^3$ "
            f"to $10^4$ rad/s the curve as a whole drops by {-chord:.1f} dB, which may have been read as the "
            "slope."
        ),
        consequence=(
            "The linear part filters better than the thesis says: section 6.2 calls it on the edge of "
            "filtering, with order 1. With the pin's velocity as second input the slope is "
            f"{asymptotic_roll_off(both):.0f} dB per decade, but only far above {corner:.0f} rad/s."
        ),
        impact=Impact.DOWNSTREAM,
        source=SOURCE,
    )


def _order(numbers: LinearNumbers, slope: float, chord: float) -> Part:
    order = -slope / 20
    return Part(
        "filter order",
        PrintedDigits("1", order),
        Confirmation(
            "the degrees of the polynomials",
            CloseNumbers(len(numbers.denominator) - len(numbers.numerator), order),
        ),
        Slip(
            "the fall over the decade from $10^{3}$ to $10^{4}$ rad/s is read as the slope",
            -chord / 20,
            Verdict.ERRATUM,
        ),
    )
