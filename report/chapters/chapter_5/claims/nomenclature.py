"""Claim on the symbols for predicted and simulated amplitude, which the nomenclature has exchanged."""

from __future__ import annotations

from report.claim import Claim, Confirmation, Impact, Part
from report.comparisons.assertion import Assertion
from report.comparisons.digits import CloseNumbers, PrintedDigits
from report.comparisons.printed import power, power_of
from report.evidence import Evidence
from report.numbers.limit_cycle_numbers import LISTING_DENOMINATOR, LISTING_NUMERATOR, friction_by_newton

GAP = 4e-6
"""Gap of the example in section 5.2.1, m."""
UNDER_THE_SYMBOL, FROM_THE_LOCUS = "3.2995e-5", "3.3138e-5"
"""Values of A_lcs and A_lch there, m."""
READINGS = (3.303e-5, -3.2961e-5)
"""What is read from the simulated time response there, m."""


def claims(evidence: Evidence) -> tuple[Claim, ...]:
    """Return the claim."""
    return (_symbols(evidence),)


def _symbols(evidence: Evidence) -> Claim:
    by_newton, _ = friction_by_newton(
        LISTING_NUMERATOR, LISTING_DENOMINATOR, evidence.cycles.friction_listing.stable
    )
    predicted, simulated = evidence.cycles.friction_listing.stable.amplitude * GAP, float(UNDER_THE_SYMBOL)
    return Claim(
        id="txt-5.2.1-amplitude-symbols",
        parts=(
            Part(
                "nomenclature: the value that section 5.2.1 calls $A_{lcs}$",
                Assertion(
                    statement="it is the one predicted by the condition for harmonic balance",
                    derived=PrintedDigits(UNDER_THE_SYMBOL, predicted).compare().agrees,
                    evidence=(
                        f"{power(UNDER_THE_SYMBOL)} m is half of the distance of two readings from a "
                        f"simulation; harmonic balance gives {power_of(predicted, 4)} m, which is called "
                        "$A_{lch}$"
                    ),
                    method="both values of section 5.2.1 against harmonic balance with Listing A.9",
                ),
                Confirmation(
                    "half of the distance of the two readings",
                    CloseNumbers((READINGS[0] - READINGS[1]) / 2, float(UNDER_THE_SYMBOL), 2e-5),
                ),
            ),
            Part(
                "footnote 4: $A_{lch}$ is the predicted one",
                PrintedDigits(FROM_THE_LOCUS, predicted, "m"),
                Confirmation("Newton's method in 30 digits", CloseNumbers(GAP * by_newton, predicted)),
            ),
        ),
        explanation=(
            "The nomenclature gives $A_{lcs}$ as the amplitude predicted by the condition for harmonic "
            "balance. Footnotes 4 and 5 and the numbers of section 5.2.1 have it the other way round: s "
            "stands for the simulation, h for harmonic balance. Section 5.2.5 writes $f_{lcs}$ for both, a "
            "frequency read from an intersection and one from a spectrum."
        ),
        consequence=(
            "Read with the nomenclature, the error of section 5.2.1 would be relative to the prediction, "
            f"{100 * (predicted - simulated) / predicted:.4f} % instead of "
            f"{100 * (predicted - simulated) / simulated:.4f} %."
        ),
        impact=Impact.NOTATION,
        source="report/chapters/chapter_5/claims/nomenclature.py",
    )
