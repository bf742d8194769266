"""Claim of appendix A.6: the describing function of viscous-controlled backlash (Listing A.5)."""

from __future__ import annotations

import sympy

from derivations.backlash import (
    CONTACT,
    GAMMA,
    SEPARATION,
    contact_ratio,
    separation_angle,
)
from report.chapters.appendix_a.claims.elements import BACKLASH
from report.chapters.chapter_2.claims.section_2_3_4_viscous import (
    general_describing_function,
    in_phase_part,
    quadrature_part,
)
from report.claim import Claim, Confirmation, Impact, Part, Slip, Verdict
from report.comparisons.expression import SameExpression
from report.evidence import Evidence


def claims(_: Evidence) -> tuple[Claim, ...]:
    """Return the claim."""
    return (_viscous(),)


def _viscous() -> Claim:
    root = sympy.sqrt(1 + GAMMA**2)
    flight = GAMMA**2 / root * sympy.exp((separation_angle() - CONTACT) / GAMMA)
    printed = sympy.sqrt(1 - GAMMA**2) - sympy.sin(CONTACT) - flight
    derived = contact_ratio().subs(SEPARATION, separation_angle())
    general = general_describing_function()
    return Claim(
        id="lst-A.5",
        parts=(
            Part(
                "line 6, contact angle",
                SameExpression(printed, derived, left=r"\beta", assume=sympy.Lt(GAMMA, 1)),
                Confirmation("the right form", SameExpression(root - sympy.sin(CONTACT) - flight, derived)),
                Slip(
                    "the sign under the root is minus instead of plus",
                    derived - root + sympy.sqrt(1 - GAMMA**2),
                    Verdict.ERRATUM,
                ),
            ),
            in_phase_part("lines 11 to 14, np", general),
            quadrature_part("lines 16 to 19, nq", general),
        ),
        explanation=(
            "Lines 11 to 19 are right, brackets included. Line 6 repeats the sign of equation 2.46, so the "
            "angle that is put into them is wrong; for $\\gamma > 1$ it is complex."
        ),
        consequence=(
            "The contours of figure 5.16, drawn for $1 < \\gamma < 3/2$, and what section 5.2.3 concludes "
            "from them, rest on this line."
        ),
        impact=Impact.DOWNSTREAM,
        source=BACKLASH,
    )
