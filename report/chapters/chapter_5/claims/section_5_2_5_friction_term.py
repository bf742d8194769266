"""Claims of section 5.2.5 on the friction term of the equivalent nonlinearity (equation 5.14)."""

from __future__ import annotations

from fractions import Fraction

import sympy

from derivations.friction import FORCE
from derivations.symbols import A, omega
from report.chapters.chapter_2.claims.section_2_4 import printed_backlash_part
from report.chapters.chapter_5.claims.section_5_2_4 import FRICTION, RELAY, SOURCE
from report.claim import Claim, Confirmation, Impact, Part, Slip, Verdict
from report.comparisons.digits import CloseNumbers, PrintedDigits
from report.comparisons.expression import SameExpression
from report.evidence import Evidence

PRINTED_TERM = -sympy.I * 4 * FORCE / (omega * A * sympy.pi)


def claims(_: Evidence) -> tuple[Claim, ...]:
    """Return the claims in thesis order."""
    return (_equivalent(), _coulomb_term(), _large_frequency(), _without_force(), _difference())


def _equivalent() -> Claim:
    return Claim(
        id="eq-5.14",
        parts=(printed_backlash_part("backlash term"), coulomb_part()),
        explanation=(
            "The backlash part lacks the factor $A/\\pi$, as in equation 2.59. The friction part has the "
            "wrong sign and divides by a frequency that drops out; and besides it is printed inside a "
            "bracket that is divided by $A$ once more."
        ),
        consequence=(
            "Figures 5.21 to 5.24 come from Listing A.6, which has the first part right and the second wrong."
        ),
        impact=Impact.DOWNSTREAM,
        source=SOURCE,
    )


def coulomb_part() -> Part:
    """Return the part on the friction term, whose slip equation 5.14 and the contours of 5.2.5 share."""
    return Part(
        "Coulomb term",
        SameExpression(PRINTED_TERM, FRICTION),
        Confirmation(
            "$j\\omega$ times the gain for an amplitude of velocity $\\omega A$",
            SameExpression(sympy.simplify(sympy.I * omega * RELAY.subs(A, omega * A)), FRICTION),
        ),
        Slip(
            "the gain for a displacement is divided by $j\\omega$", RELAY / (sympy.I * omega), Verdict.ERRATUM
        ),
    )


def _coulomb_term() -> Claim:
    return Claim(
        id="txt-5.2.5-coulomb-term",
        parts=(coulomb_part(),),
        explanation=(
            "With $G_g = 1/s$ the factor $1/G_g$ is $j\\omega$, not $1/(j\\omega)$, and friction sees the "
            "amplitude $\\omega A$ of the velocity. Together $j\\omega \\cdot 4F_c/(\\pi\\omega A) = "
            "j\\,4F_c/(\\pi A)$: positive sign, no frequency, in N/m. Printed is $-j\\,4F_c/(\\omega "
            "A\\pi)$, in N s/m."
        ),
        consequence=(
            "The sign makes friction feed the oscillation where it damps it, and the factor $1/\\omega$ "
            "makes it weak where it is strong. No contour of section 5.2.5 stands."
        ),
        impact=Impact.DOWNSTREAM,
        source=SOURCE,
    )


def _large_frequency() -> Claim:
    printed_limit = sympy.limit(PRINTED_TERM, omega, sympy.oo)
    right_limit = sympy.limit(FRICTION, omega, sympy.oo)
    return Claim(
        id="txt-5.2.5-omega-limit",
        parts=(
            Part(
                "limit of the Coulomb term",
                SameExpression(printed_limit, right_limit),
                Confirmation(
                    "the term does not contain $\\omega$",
                    SameExpression(FRICTION.diff(omega), sympy.Integer(0)),
                ),
                Slip(
                    "the term is divided by $\\omega$",
                    sympy.limit(PRINTED_TERM, omega, sympy.oo),
                    Verdict.ERRATUM,
                ),
            ),
        ),
        explanation=(
            "The printed term vanishes at high frequency because of its wrong factor. The right one does not "
            "depend on frequency: the share of friction is the same at every speed and falls with the "
            "amplitude."
        ),
        consequence=(
            "Figure 5.21a, and what chapter 7 says about low and high frequency, describe the factor and not "
            "friction."
        ),
        impact=Impact.DOWNSTREAM,
        source=SOURCE,
    )


def _without_force() -> Claim:
    return Claim(
        id="txt-5.2.5-zero-fc",
        parts=(
            Part("Coulomb term for $F_c = 0$", SameExpression(sympy.Integer(0), FRICTION.subs(FORCE, 0))),
        ),
        explanation=(
            "Without force the friction term is zero, right or wrong, and friction-controlled backlash is "
            "left. The shorter path is the range of amplitudes drawn."
        ),
        source=SOURCE,
    )


def _difference() -> Claim:
    difference = 100 * abs(737.514 - 733.33) / 733.33
    return Claim(
        id="txt-5.2.5-difference",
        parts=(
            Part(
                "arithmetic",
                PrintedDigits("0.5705", difference, "%"),
                Confirmation(
                    "exact fractions",
                    CloseNumbers(float(100 * (Fraction("737.514") / Fraction("733.33") - 1)), difference),
                ),
            ),
        ),
        explanation=(
            "The quotient of the two printed frequencies is right. What it compares rests on the wrong "
            "friction term."
        ),
        source="report/chapters/chapter_5/claims/section_5_2_4.py",
    )
