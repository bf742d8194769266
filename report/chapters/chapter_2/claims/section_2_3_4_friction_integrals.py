"""Claims on the Fourier integrals of friction-controlled backlash (2.37 to 2.41, B.1, B.2).

The thesis's b is half of the total gap in these places.
"""

from __future__ import annotations

import numpy as np
import sympy

from derivations.symbols import A
from derivations.waveform import THETA, Segment, segment_integral
from report.chapters.chapter_2.claims.section_2_3_4_friction import (
    COSINE,
    LINES,
    REACHED,
    SINE,
    SOURCE,
    VALUES,
    WAVEFORM,
    b,
)
from report.claim import Claim, Confirmation, Impact, Part, Slip, Verdict
from report.comparisons.digits import CloseNumbers
from report.comparisons.expression import SameExpression
from report.comparisons.printed import product, total
from report.comparisons.quadrature import coefficient, confirm, integral
from report.evidence import Evidence
from trimmer.elements.friction_backlash import FrictionBacklash


def claims(_: Evidence) -> tuple[Claim, ...]:
    """Return the claims in thesis order."""
    return (
        _cosine_integrals(),
        _cosine_coefficient("eq-2.38"),
        _sine_integrals(),
        _sine_coefficient(),
        _describing_function(),
        _appendix_integrals(),
        _cosine_coefficient("eq-B.2"),
    )


def printed_cosine_coefficient() -> sympy.Expr:
    """Return a1 of equations 2.38, 2.41 and B.2."""
    return 4 * b / sympy.pi * (b / A - 1)


def printed_sine_coefficient() -> sympy.Expr:
    """Return b1 of equations 2.40 and 2.41."""
    return product(A / sympy.pi, total(*printed_sine_terms()))


def printed_sine_terms() -> tuple[sympy.Expr, ...]:
    """Return the terms in the bracket that equations 2.40, 2.41, 2.59 and 5.14 share."""
    ratio = total(2 * b / A, sympy.Integer(-1))
    root = sympy.sqrt(total(sympy.Integer(1), product(-1, sympy.Pow(ratio, 2))))
    return sympy.pi / 2, product(-1, sympy.asin(ratio, evaluate=False)), product(-1, ratio, root)


def _by_element(segment: Segment, weight: sympy.Expr) -> Confirmation:
    """Confirm an integrand in the middle of its piece by the numeric element."""
    middle = float(((segment.start + segment.end) / 2).subs(VALUES))
    (output,) = FrictionBacklash(2 * float(VALUES[b])).waveform(np.array([middle]), float(VALUES[A]))
    at_middle = {**VALUES, THETA: middle}
    return Confirmation(
        "the numeric element in the middle of the piece",
        CloseNumbers(
            float(output) * float(weight.subs(at_middle)), float((segment.value * weight).subs(at_middle))
        ),
    )


def _integral_parts(
    integrands: tuple[sympy.Expr, ...], values: tuple[sympy.Expr, ...], weight: sympy.Expr, slip: str
) -> list[Part]:
    parts = []
    for line, integrand, value, segment in zip(LINES, integrands, values, WAVEFORM.segments, strict=True):
        parts.append(
            Part(
                f"{line} integrand",
                SameExpression(integrand, segment.value * weight, assume=REACHED),
                _by_element(segment, weight),
                Slip(slip, -segment.value * weight, Verdict.ERRATUM),
            )
        )
        derived = sympy.simplify(segment_integral(segment, weight))
        numeric = integral(segment, weight, VALUES)
        parts.append(
            Part(
                f"{line} value",
                SameExpression(sympy.sympify(value), derived, assume=REACHED),
                confirm(derived, numeric, VALUES),
            )
        )
    return parts


def _held_value() -> sympy.Expr:
    return 2 * b * (b - A) / A


def _cosine_integrals() -> Claim:
    integrands = (
        product(-1, A - b, COSINE),
        product(total(A * SINE, b), COSINE),
        product(A - b, COSINE),
        product(total(A * SINE, -b), COSINE),
    )
    values = (_held_value(), 0, _held_value(), 0)
    slip = "the signs of the two constant pieces are exchanged"
    return Claim(
        id="eq-2.37",
        parts=tuple(_integral_parts(integrands, values, COSINE, slip)),
        explanation=(
            "The first and the third integrand have the exchanged signs of equation 2.36. The values under "
            "the braces are those of the right integrands, so two lines do not give what is printed below "
            "them; appendix B.1 has the right signs."
        ),
        consequence="None: the coefficient in equation 2.38 uses the values.",
        impact=Impact.LOCAL,
        source=SOURCE,
    )


def _appendix_integrals() -> Claim:
    integrands = (
        product(A - b, COSINE),
        product(total(A * SINE, b), COSINE),
        product(-1, A - b, COSINE),
        product(total(A * SINE, -b), COSINE),
    )
    values = (_held_value(), 0, _held_value(), 0)
    return Claim(
        id="eq-B.1",
        parts=tuple(_integral_parts(integrands, values, COSINE, "sign")),
        explanation="Integrands and values are right, with the signs that equation 2.37 has exchanged.",
        source=SOURCE,
    )


def _cosine_coefficient(claim_id: str) -> Claim:
    derived = sympy.simplify(WAVEFORM.cosine_coefficient())
    numeric = coefficient(WAVEFORM, COSINE, VALUES)
    return Claim(
        id=claim_id,
        parts=(
            Part(
                "",
                SameExpression(
                    printed_cosine_coefficient(), derived, left=sympy.Symbol("a_1"), assume=REACHED
                ),
                confirm(derived, numeric, VALUES),
            ),
        ),
        explanation=(
            "The coefficient of the right waveform, with $b$ half of the total gap. It is negative for $A > "
            "b$."
        ),
        source=SOURCE,
    )


def _sine_integrals() -> Claim:
    integrands = (
        product(A - b, SINE),
        product(total(A * SINE, b), SINE),
        product(-1, A - b, SINE),
        product(total(A * SINE, -b), SINE),
    )
    root = sympy.sqrt(b * (A - b) / A**2)
    held = 2 * (A - b) * root
    moving = A / 4 * (-4 * root + 2 * sympy.asin(1 - 2 * b / A) + sympy.pi)
    return Claim(
        id="eq-2.39",
        parts=tuple(_integral_parts(integrands, (held, moving, held, moving), SINE, "sign")),
        explanation=(
            "All four integrands and values are right. The signs of the constant pieces are the right ones "
            "here, other than in equations 2.36 and 2.37."
        ),
        source=SOURCE,
    )


def _sine_coefficient() -> Claim:
    derived = sympy.simplify(WAVEFORM.sine_coefficient())
    numeric = coefficient(WAVEFORM, SINE, VALUES)
    return Claim(
        id="eq-2.40",
        parts=(
            Part(
                "",
                SameExpression(printed_sine_coefficient(), derived, left=sympy.Symbol("b_1"), assume=REACHED),
                confirm(derived, numeric, VALUES),
            ),
        ),
        explanation="The coefficient of the right waveform, with $b$ half of the total gap.",
        source=SOURCE,
    )


def _describing_function() -> Claim:
    parts = []
    rows = (
        ("a_1", printed_cosine_coefficient(), WAVEFORM.cosine_coefficient(), COSINE),
        ("b_1", printed_sine_coefficient(), WAVEFORM.sine_coefficient(), SINE),
    )
    for name, printed, derived, weight in rows:
        numeric = coefficient(WAVEFORM, weight, VALUES)
        parts.append(
            Part(
                f"${name}$",
                SameExpression(printed, sympy.simplify(derived), left=sympy.Symbol(name), assume=REACHED),
                confirm(derived, numeric, VALUES),
            )
        )
    return Claim(
        id="eq-2.41",
        parts=tuple(parts),
        explanation=(
            "Both coefficients are right when $b$ is half of the total gap, as here. The listings use the "
            "same letter for the total gap; whoever mixes the two is wrong by a factor of two in the "
            "amplitude."
        ),
        source=SOURCE,
    )
