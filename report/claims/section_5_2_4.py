"""Claims of sections 5.2.4 and 5.2.5 on Coulomb friction and the equivalent nonlinearity (5.12 to 5.14)."""

from __future__ import annotations

import math

import numpy as np
import sympy

from derivations.friction import FORCE, friction_waveform, relay_waveform
from derivations.symbols import A, omega, s
from derivations.waveform import THETA, describing_function
from report.claim import Claim, Confirmation, Impact, Part, Slip, Verdict
from report.claims.quadrature import coefficient, confirm
from report.claims.section_2_4 import printed_backlash_part
from report.comparisons.assertion import Assertion
from report.comparisons.digits import PrintedDigits
from report.comparisons.expression import SameExpression
from report.evidence import Evidence
from report.numbers.linear_numbers import LinearNumbers
from trimmer import frequency_response, real_axis_crossings

SOURCE = "derivations/friction.py"
VALUES = {FORCE: sympy.Rational(3, 5), A: sympy.Rational(7, 4)}
RELAY = describing_function(relay_waveform(), A)
FRICTION = describing_function(friction_waveform(), A)
PRINTED_TERM = -sympy.I * 4 * FORCE / (omega * A * sympy.pi)


def claims(evidence: Evidence) -> tuple[Claim, ...]:
    """Return the claims in thesis order."""
    return (
        _limit_of_response(evidence),
        _inverse(),
        _equivalent(),
        _no_crossing(evidence),
        _coulomb_term(),
        _large_frequency(),
        _without_force(),
        _difference(),
    )


def _friction_by_quadrature() -> complex:
    wave = friction_waveform()
    sine, cosine = (coefficient(wave, weight(THETA), VALUES) for weight in (sympy.sin, sympy.cos))
    return (sine + 1j * cosine) / float(VALUES[A])


def _limit_of_response(evidence: Evidence) -> Claim:
    above, below = (
        sympy.Poly([sympy.Rational(c.numerator, c.denominator) for c in coefficients], s).as_expr()
        for coefficients in (evidence.numbers.numerator, evidence.numbers.denominator)
    )
    return Claim(
        id="eq-5.12",
        parts=(
            Part(
                "", SameExpression(sympy.Integer(0), sympy.limit(above / below, s, sympy.oo), left=r"\lim G")
            ),
        ),
        explanation=(
            "The transfer function has two poles more than zeros, so it tends to zero, and along the "
            "negative real axis from below. It does not spiral: its phase tends to -180 degrees."
        ),
        source="derivations/transfer_function.py",
    )


def _inverse() -> Claim:
    printed = -A * sympy.pi / (4 * FORCE)
    return Claim(
        id="eq-5.13",
        parts=(
            Part(
                "for a relay on the loop's signal", SameExpression(printed, -1 / RELAY, left=r"-\frac{1}{N}")
            ),
            Part(
                "for friction, in a loop whose signal is a displacement",
                SameExpression(printed, sympy.simplify(-1 / FRICTION), left=r"-\frac{1}{N}"),
                confirm(sympy.simplify(-1 / FRICTION), -1 / _friction_by_quadrature(), VALUES),
                Slip("the phase between velocity and displacement is dropped", -1 / RELAY, Verdict.ERRATUM),
            ),
        ),
        explanation=(
            "The algebra is right for equation 2.52. In this loop the signal is a displacement, and for "
            "friction $-1/N = j\\,\\pi A/(4F_c)$. A larger $F_c$ does not shorten the curve: amplitudes run "
            "to infinity, and it is the same half axis for every force."
        ),
        consequence=(
            "The picture of the section, and the high-frequency limit cycle expected from it, concern a "
            "relay that no part of the trimmer is."
        ),
        impact=Impact.DOWNSTREAM,
        source=SOURCE,
    )


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


def _no_crossing(evidence: Evidence) -> Claim:
    system = evidence.numbers.displacement_only
    crossings = real_axis_crossings(system)
    on_the_axis = _on_the_imaginary_axis(evidence.numbers)
    highest = float(np.angle(frequency_response(system, np.geomspace(1.0, 1e6, 20000))).max())
    return Claim(
        id="txt-5.2.4-no-crossing",
        parts=(
            Part(
                "crossings of the negative real axis",
                PrintedDigits("0", sum(crossing.value < 0 for crossing in crossings)),
            ),
            Part(
                "what follows for friction",
                Assertion(
                    statement="harmonic balance predicts no limit cycle from Coulomb friction",
                    derived=max(on_the_axis) < 0,
                    evidence=(
                        "with the right operator $G$ would have to cross the positive imaginary axis; where "
                        "it is imaginary, at "
                        f"{len(on_the_axis)} frequencies, it lies on the negative one"
                    ),
                    method="all roots of the real part, from exact coefficients",
                ),
                Confirmation(
                    "the phase on a grid",
                    Assertion(
                        statement="$G$ stays off the positive imaginary axis",
                        derived=highest < math.pi / 2,
                        evidence=f"its phase rises to {math.degrees(highest):.1f} degrees",
                        method=f"phase of the response, at most {math.degrees(highest):.1f} degrees",
                    ),
                ),
            ),
        ),
        explanation=(
            f"$G$ meets the real axis at {len(crossings)} frequencies, always on its positive side. The "
            "reason given looks at the wrong axis, but the conclusion stands: friction between parts at rest "
            "otherwise only takes energy, so it cannot keep anything moving."
        ),
        source="trimmer/crossings.py",
    )


def _on_the_imaginary_axis(numbers: LinearNumbers) -> list[float]:
    """Return Im G, up to a positive factor, at every frequency above zero where Re G(jω) is zero."""
    frequency = sympy.Symbol("omega", real=True)
    above, below = (
        sympy.Poly([sympy.Rational(c.numerator, c.denominator) for c in coefficients], s).as_expr()
        for coefficients in (numbers.numerator, numbers.denominator)
    )
    product = sympy.expand((above * below.subs(s, -s)).subs(s, sympy.I * frequency))
    real_part = sympy.Poly(sympy.re(product), frequency)
    imaginary_part = sympy.Poly(sympy.im(product), frequency)
    return [float(imaginary_part.eval(root)) for root in real_part.nroots(n=30) if root.is_real and root > 0]


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
        parts=(Part("arithmetic", PrintedDigits("0.5705", difference, "%")),),
        explanation=(
            "The quotient of the two printed frequencies is right. What it compares rests on the wrong "
            "friction term."
        ),
        source="report/claims/section_5_2_4.py",
    )
