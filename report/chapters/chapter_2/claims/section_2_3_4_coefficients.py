"""Claims of section 2.3.4 and appendix B.1: coefficients of friction-controlled backlash (2.37 to 2.41).

The thesis's b is half of the total gap in these places.
"""

from collections.abc import Iterator
from dataclasses import dataclass
from typing import final

import numpy as np
import sympy

from derivations.elements.waveform import THETA, Segment, segment_integral
from derivations.symbols import A
from report.chapters.chapter_2.claims.section_2_3_4_friction import (
    COSINE,
    INPUT,
    LIMITS,
    LINES,
    MOVING,
    REACHED,
    SINE,
    VALUES,
    WAVEFORM,
    b,
)
from report.chapters.second_ways import by_quadrature
from report.judging.claim import ClaimPart, Confirmation
from report.judging.comparisons.printed import product, total
from report.judging.parts import close, expression, repeated
from report.judging.record import Record, claim, text
from report.numbers.evidence import Evidence
from report.numbers.independent.waveforms import coefficient, integral
from trimmer import FrictionBacklash

COSINE_ITEM = "4b/π (b/A − 1), a₁ of friction-controlled backlash"
SINE_ITEM = "A/π (π/2 − …), b₁ of friction-controlled backlash"
EXCHANGED_ITEM = "signs of the two resting integrands, a₁ of friction-controlled backlash"
"""Printed things that several parts judge."""
REPEATED = "the exchanged signs of equation 2.36 are repeated"
RATIO = r"\left(\frac{2b}{A} - 1\right)"
BRACKET = rf"\frac{{\pi}}{{2}} - \sin^{{-1}}{RATIO} - {RATIO} \sqrt{{1 - {RATIO}^2}}"
"""What equations 2.40, 2.41 and 2.59 share, as TeX in the thesis's order."""
ROOT_FORM = r"\sqrt{\frac{b(A - b)}{A^2}}"


@final
@dataclass(frozen=True)
class Term:
    """A printed term: what it is, and its TeX in the thesis's order."""

    value: sympy.Expr
    tex: str


def printed_sine_terms() -> tuple[sympy.Expr, ...]:
    """Return the terms in the bracket that equations 2.40, 2.41, 2.59 and 5.14 share."""
    ratio = total(2 * b / A, sympy.Integer(-1))
    root = sympy.sqrt(total(sympy.Integer(1), product(-1, sympy.Pow(ratio, 2))))
    return sympy.pi / 2, product(-1, sympy.asin(ratio, evaluate=False)), product(-1, ratio, root)


def integrands(weight: sympy.Expr, *, exchanged: bool) -> tuple[Term, ...]:
    """Return what is integrated over each piece, with the resting pieces exchanged or not."""
    resting = Term(product(A - b, weight), "(A - b)"), Term(product(-1, A - b, weight), "-(A - b)")
    first, third = reversed(resting) if exchanged else resting
    second, fourth = (
        Term(product(total(INPUT, offset), weight), f"({tex})")
        for offset, tex in zip((b, -b), MOVING, strict=True)
    )
    return first, second, third, fourth


def integrals(
    weight: sympy.Expr, held: Term, moving: Term, *, exchanged: bool = False
) -> Iterator[ClaimPart]:
    """Yield the parts on integrand and value of each piece, with the values of a held and a moving one."""
    printed, right = integrands(weight, exchanged=exchanged), integrands(weight, exchanged=False)
    pieces = zip(LINES, printed, right, (held, moving) * 2, WAVEFORM.segments, strict=True)
    for index, (line, term, right_term, value, segment) in enumerate(pieces):
        derived = segment.value * weight
        yield expression(
            f"{line} integrand",
            term.value,
            derived,
            assume=REACHED,
            second=by_element(segment, weight, derived),
            slip=repeated(REPEATED, -derived),
            printed_form=integral_form(index, term.tex, weight),
            derived_form=integral_form(index, right_term.tex, weight),
            item=EXCHANGED_ITEM if term != right_term else "",
        )
        area = sympy.simplify(segment_integral(segment, weight))
        second = by_quadrature(area, integral(segment, weight, VALUES), VALUES)
        yield expression(f"{line} value", value.value, area, assume=REACHED, second=second, form=value.tex)


def by_element(segment: Segment, weight: sympy.Expr, derived: sympy.Expr) -> Confirmation:
    """Confirm an integrand by the numeric element in the middle of its piece."""
    middle = float(((segment.start + segment.end) / 2).subs(VALUES))
    (output,) = FrictionBacklash(2 * float(VALUES[b])).waveform(np.array([middle]), float(VALUES[A]))
    by_numbers, in_symbols = (
        float(each.subs({**VALUES, THETA: middle})) for each in (float(output) * weight, derived)
    )
    return close("the numeric element in the middle of the piece", by_numbers, in_symbols)


def integral_form(index: int, term: str, weight: sympy.Expr) -> str:
    """Return TeX of the integral over a piece, counted from zero."""
    start, end = LIMITS[index : index + 2]
    name = r"\cos" if weight == COSINE else r"\sin"
    return rf"\int_{{{start}}}^{{{end}}} {term} {name}(\omega t)\,d(\omega t)"


def cosine_values() -> tuple[Term, Term]:
    """Return the values of a held and a moving piece of a1, as equations 2.37 and B.1 print them."""
    return Term(2 * b * (b - A) / A, r"\frac{2b(b - A)}{A}"), Term(sympy.Integer(0), "0")


@claim("eq-2.37")
def cosine_integrals(_: Evidence) -> Record:
    yield from integrals(COSINE, *cosine_values(), exchanged=True)
    yield text("""
        The first and the third integrand repeat the exchanged signs of [equation 2.36](#eq-2.36). The values
        under the braces are those of the right integrands, so these two lines do not give what is printed
        below them. [Appendix B.1](#eq-B.1) has the right signs.

        None: [equation 2.38](#eq-2.38) uses the values.
    """)


@claim("eq-B.1")
def appendix_integrals(_: Evidence) -> Record:
    yield from integrals(COSINE, *cosine_values())
    yield text("""
        Integrands and values are right, with the signs that [equation 2.37](#eq-2.37) has exchanged.
    """)


@claim("eq-2.39")
def sine_integrals(_: Evidence) -> Record:
    root, angle = sympy.sqrt(b * (A - b) / A**2), sympy.asin(1 - 2 * b / A)
    bracket = rf"-4{ROOT_FORM} + 2\sin^{{-1}}\left(1 - \frac{{2b}}{{A}}\right) + \pi"
    held = Term(2 * (A - b) * root, f"2(A - b){ROOT_FORM}")
    moving = Term(A / 4 * (-4 * root + 2 * angle + sympy.pi), rf"\frac{{1}}{{4}} A \left({bracket}\right)")
    yield from integrals(SINE, held, moving)
    yield text("""
        All integrands and values are right. The resting pieces have their right signs here, unlike in
        equations [2.36](#eq-2.36) and [2.37](#eq-2.37).
    """)


def cosine_part(label: str) -> ClaimPart:
    """Return the part on a1."""
    derived = sympy.simplify(WAVEFORM.cosine_coefficient())
    return expression(
        label,
        4 * b / sympy.pi * (b / A - 1),
        derived,
        assume=REACHED,
        second=by_quadrature(derived, coefficient(WAVEFORM, COSINE, VALUES), VALUES),
        form=r"a_1 = \frac{4b}{\pi} \left(\frac{b}{A} - 1\right)",
        item=COSINE_ITEM,
    )


def sine_part(label: str) -> ClaimPart:
    """Return the part on b1."""
    derived = sympy.simplify(WAVEFORM.sine_coefficient())
    return expression(
        label,
        product(A / sympy.pi, total(*printed_sine_terms())),
        derived,
        assume=REACHED,
        second=by_quadrature(derived, coefficient(WAVEFORM, SINE, VALUES), VALUES),
        form=rf"b_1 = \frac{{A}}{{\pi}} \left[{BRACKET}\right]",
        item=SINE_ITEM,
    )


@claim("eq-2.38")
def cosine_coefficient(_: Evidence) -> Record:
    yield cosine_part("")
    yield text("""
        It is the coefficient of the right waveform, with $b$ half of the total gap, and negative for $A > b$.
    """)


@claim("eq-B.2")
def appendix_coefficient(_: Evidence) -> Record:
    yield cosine_part("")
    yield text("It is the coefficient of [equation 2.38](#eq-2.38), and right.")


@claim("eq-2.40")
def sine_coefficient(_: Evidence) -> Record:
    yield sine_part("")
    yield text("It is the coefficient of the right waveform, with $b$ half of the total gap.")


@claim("eq-2.41")
def describing_function(_: Evidence) -> Record:
    yield cosine_part("$a_1$")
    yield sine_part("$b_1$")
    yield text("""
        The coefficients of equations [2.38](#eq-2.38) and [2.40](#eq-2.40) are right when $b$ is half of the
        total gap, as here. The listings use the same letter for the total gap. Whoever mixes the two is wrong
        by a factor of two in the amplitude.
    """)
