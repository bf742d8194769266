"""Claims on the figures of section 5.2.5: contours of the equivalent nonlinearity (5.21 to 5.24)."""

from __future__ import annotations

import math

import numpy as np
import sympy

from derivations.backlash import GAP as TOTAL_GAP
from derivations.backlash import friction_waveform
from derivations.friction import FORCE as COULOMB
from derivations.symbols import A, omega
from derivations.waveform import simplified_describing_function
from report.chapters.appendix_a.claims.elements import REACHED, friction_expression
from report.chapters.chapter_5.claims.section_5_2_1 import ROUNDED
from report.chapters.chapter_5.claims.section_5_2_1_scaling import PLOT_OFFSET
from report.chapters.chapter_5.claims.section_5_2_5 import (
    LINE_18,
    at_the_merger,
    frequency_part,
    intersections_part,
)
from report.chapters.chapter_5.claims.section_5_2_5_friction_term import coulomb_part
from report.chapters.chapter_5.claims.section_5_2_5_simulated import peak_parts
from report.claim import Claim, Confirmation, Impact, Part, Slip, Verdict
from report.comparisons.assertion import Assertion
from report.comparisons.digits import CloseNumbers, PrintedDigits
from report.comparisons.expression import SameExpression
from report.comparisons.second_ways import by_matching_real_parts
from report.evidence import Evidence
from report.numbers.equivalent_nonlinearity import (
    FORCE,
    FORCES,
    GAP,
    OMEGA,
    OTHER_FORCE,
    OTHER_GAP,
    listing_element,
)
from report.numbers.limit_cycle_numbers import friction_exactly

SOURCE = "report/numbers/equivalent_nonlinearity.py"
LISTING = friction_expression() - sympy.I * 4 * COULOMB / (sympy.pi * A * omega)
"""What Listing A.6 computes."""
TURN = 2 * math.pi


def claims(evidence: Evidence) -> tuple[Claim, ...]:
    """Return the claims in thesis order."""
    return (_three_panels(evidence), _without_force(evidence), _one_force(evidence), _forces(evidence))


def _three_panels(evidence: Evidence) -> Claim:
    numbers = evidence.cycles.equivalent
    inner, outer = numbers.other_gap
    return Claim(
        id="fig-5.21",
        parts=(
            coulomb_part(),
            _one_family(),
            Part(
                f"for $F_c$ = {OTHER_FORCE}, $b$ = $200\\times10^{{-5}}$ and the drive's frequency",
                Assertion(
                    statement="there is more than one intersection",
                    derived=len(numbers.other_gap) > 1,
                    evidence=(
                        f"at {inner.frequency:.1f} Hz, unstable, and at {outer.frequency:.1f} Hz, stable"
                    ),
                    method="all solutions of harmonic balance with the listing's function",
                ),
                by_matching_real_parts(
                    evidence.numbers.displacement_only,
                    -OTHER_FORCE / OMEGA / OTHER_GAP,
                    len(numbers.other_gap),
                ),
            ),
        ),
        explanation=(
            "The contours are those of Listing A.6, whose friction term has the wrong sign and a factor "
            "$1/\\omega$ that does not belong there; equation 5.14 would give others. With the right term "
            "there is one family too, with $F_c/(k_2 b)$ in place of $F_c/(\\omega b)$ and bent the other "
            "way, and frequency has no part in it. For this force and gap friction hardly counts: "
            f"$F_c/(k_2 b)$ is {OTHER_FORCE / OTHER_GAP / evidence.numbers.parameters.k2:.4f}."
        ),
        consequence=(
            "The dependence on frequency is that of the wrong factor. The likeness to viscous-controlled "
            "backlash comes from the wrong sign, which makes friction a lag, as inertia is."
        ),
        impact=Impact.DOWNSTREAM,
        source=SOURCE,
    )


def _one_family() -> Part:
    gaps, load = sympy.symbols("a phi", positive=True)
    scaled = LISTING.subs(A, gaps * TOTAL_GAP).subs(COULOMB, load * omega * TOTAL_GAP)
    return Part(
        "the three panels",
        Assertion(
            statement="changing $\\omega$, $F_c$ or $b$ gives three families of contours",
            derived=not scaled.free_symbols <= {gaps, load},
            evidence=(
                "with $A$ in gaps the listing's function contains $F_c/(\\omega b)$ alone, so the "
                "panels show one family three times"
            ),
            method="the listing's function with $A = ab$ and $F_c = \\varphi\\omega b$",
        ),
        Confirmation(
            "the numeric element for another gap, force and frequency with the same quotient",
            CloseNumbers(
                complex(listing_element(0.15, 2e-3, 600.0).describing_function(4e-3)),
                complex(listing_element(0.6, 4e-3, 1200.0).describing_function(8e-3)),
            ),
        ),
    )


def _without_force(evidence: Evidence) -> Claim:
    unstable = evidence.cycles.friction.unstable
    return Claim(
        id="fig-5.22",
        parts=(
            Part(
                "Listing A.6 for $F_c = 0$",
                SameExpression(
                    LISTING.subs(COULOMB, 0),
                    simplified_describing_function(friction_waveform(), A),
                    left="N",
                    assume=REACHED,
                ),
            ),
            *_prediction_without_force(evidence),
        ),
        explanation=(
            "Without force the listing's function is that of backlash, and the intersections are those of "
            "figure 5.8, as the text says. Equation 5.14 for $F_c = 0$ is something else, because its real "
            "part lacks the factor $A/\\pi$. The shorter path is the range of amplitudes that was drawn: the "
            f"second intersection, at {1e6 * GAP * unstable.amplitude:.2f} µm, lies below $b/2 + "
            f"{1e6 * PLOT_OFFSET:.0f}$ µm."
        ),
        consequence="See the prediction in section 5.2.1; equation 5.14 cannot have drawn this figure.",
        impact=Impact.LOCAL,
        source=SOURCE,
    )


def _prediction_without_force(evidence: Evidence) -> tuple[Part, ...]:
    friction, rounded = evidence.cycles.friction, evidence.cycles.friction_listing.stable
    ratio, turning = friction_exactly(evidence.numbers, friction.stable)
    return (
        Part(
            "amplitude",
            PrintedDigits("3.313e-5", GAP * friction.stable.amplitude, "m"),
            Confirmation(
                "Newton's method in 30 digits", CloseNumbers(GAP * ratio, GAP * friction.stable.amplitude)
            ),
            Slip(
                f"{ROUNDED}, and the last digit is cut off",
                math.floor(1e8 * GAP * rounded.amplitude) / 1e8,
                Verdict.EXPLAINED,
            ),
        ),
        Part(
            "frequency",
            PrintedDigits("733.3", friction.stable.frequency, "Hz"),
            Confirmation(
                "Newton's method in 30 digits", CloseNumbers(turning / TURN, friction.stable.frequency)
            ),
            Slip(ROUNDED, rounded.frequency, Verdict.EXPLAINED),
        ),
    )


def _one_force(evidence: Evidence) -> Claim:
    numbers = evidence.cycles.equivalent
    return Claim(
        id="fig-5.23",
        parts=(
            intersections_part(numbers),
            Part(
                "the same in the loop with both channels of the pin",
                PrintedDigits("1", len(numbers.over_stiffness_both_channels)),
                Confirmation(
                    "friction between cutter and guard in its own place",
                    CloseNumbers(
                        numbers.in_place_both_channels.limit_cycles(FORCE / GAP),
                        len(numbers.over_stiffness_both_channels),
                    ),
                ),
                Slip(LINE_18, len(numbers.listing_both_channels), Verdict.ERRATUM),
            ),
            Part(
                "limit cycles by Listing A.6 with the sign of line 18 turned",
                PrintedDigits("1", len(numbers.sign_turned)),
                by_matching_real_parts(
                    evidence.numbers.displacement_only, FORCE / OMEGA / GAP, len(numbers.sign_turned)
                ),
                Slip(LINE_18, len(numbers.listing), Verdict.ERRATUM),
            ),
            frequency_part(numbers),
            *peak_parts(evidence, "b: "),
        ),
        explanation=(
            "The one intersection is an effect of line 18: its sign alone decides. With friction that takes "
            "energy there is none. For a gap of $4\\times10^{-6}$ m a limit cycle bears at most "
            f"{numbers.force_of_merger:.4f} N between cutter and guard; the force in the caption is "
            f"{FORCE / numbers.force_of_merger:.0f} times as large."
        ),
        consequence=(
            "The peaks of part b are free vibrations of the loop, which is linear for a start much larger "
            "than the gap: see the peaks of section 5.2.5."
        ),
        impact=Impact.DOWNSTREAM,
        source=SOURCE,
    )


def _forces(evidence: Evidence) -> Claim:
    numbers, friction = evidence.cycles.equivalent, evidence.cycles.friction.stable
    listing = [friction.frequency, *(cycle.frequency for cycle in numbers.by_force)]
    right = numbers.in_place.stable.frequency
    return Claim(
        id="fig-5.24",
        parts=(
            Part(
                "stable intersection",
                Assertion(
                    statement="more friction moves it to a higher frequency",
                    derived=bool(np.all(np.diff(right) > 0)),
                    evidence=(
                        f"from {right[0]:.2f} Hz without friction it falls to {right[-1]:.2f} Hz at the "
                        "largest force that has a limit cycle"
                    ),
                    method="all solutions of harmonic balance, friction between cutter and guard",
                ),
                at_the_merger(evidence),
                Slip(LINE_18, bool(np.all(np.diff(listing) > 0)), Verdict.ERRATUM),
            ),
        ),
        explanation=(
            "The listing's contours move the intersection up, from "
            f"{listing[0]:.2f} to {listing[-1]:.2f} Hz at {FORCES[-1]} N, and hardly further for any force: "
            "the limit is where the real part of $1/G$ is $-1$, in which neither gap nor force takes part. "
            "With the right term the frequency falls as the force grows, and the amplitude with it."
        ),
        consequence="The explanation of the 0.57 % by friction has the wrong direction.",
        impact=Impact.DOWNSTREAM,
        source="report/numbers/friction_in_place.py",
    )
