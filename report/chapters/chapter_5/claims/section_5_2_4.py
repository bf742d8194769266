"""Claims of section 5.2.4 on Coulomb friction alone (equations 5.12 and 5.13)."""

from __future__ import annotations

import math

import numpy as np
import sympy

from derivations.friction import FORCE, friction_waveform, relay_waveform
from derivations.symbols import A, s
from derivations.waveform import THETA, describing_function
from report.claim import Claim, Impact, Part, Slip, Verdict
from report.comparisons.assertion import Assertion
from report.comparisons.digits import PrintedDigits
from report.comparisons.expression import SameExpression
from report.comparisons.quadrature import coefficient, confirm
from report.comparisons.second_ways import by_grid, second_way
from report.evidence import Evidence
from report.numbers.linear_numbers import LinearNumbers
from trimmer import frequency_response, real_axis_crossings

SOURCE = "derivations/friction.py"
VALUES = {FORCE: sympy.Rational(3, 5), A: sympy.Rational(7, 4)}
RELAY = describing_function(relay_waveform(), A)
FRICTION = describing_function(friction_waveform(), A)


def claims(evidence: Evidence) -> tuple[Claim, ...]:
    """Return the claims in thesis order."""
    return (_limit_of_response(evidence), _inverse(), _no_crossing(evidence))


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


def _no_crossing(evidence: Evidence) -> Claim:
    system = evidence.numbers.displacement_only
    crossings = real_axis_crossings(system)
    negative = sum(crossing.value < 0 for crossing in crossings)
    on_the_axis = on_the_imaginary_axis(evidence.numbers)
    highest = float(np.angle(frequency_response(system, np.geomspace(1.0, 1e6, 20000))).max())
    return Claim(
        id="txt-5.2.4-no-crossing",
        parts=(
            Part(
                "crossings of the negative real axis",
                PrintedDigits("0", negative),
                by_grid(system, negative),
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
                second_way(
                    f"the phase on a grid, which rises to {math.degrees(highest):.1f} degrees",
                    highest < math.pi / 2,
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


def on_the_imaginary_axis(numbers: LinearNumbers) -> list[float]:
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
