"""Claims of section 2.3.4 and appendix B.2 on N of viscous-controlled backlash (equations 2.47, B.3, B.4)."""

from __future__ import annotations

from functools import cache

import sympy

from derivations.backlash import (
    CONTACT,
    GAMMA,
    GAP,
    SEPARATION,
    contact_ratio,
    general_waveform,
    separation_angle,
)
from derivations.symbols import A
from derivations.waveform import THETA, describing_function
from report.claim import Claim, Impact, Mathematics, Part, Slip, Verdict
from report.comparisons.expression import SameExpression
from report.comparisons.printed import total
from report.comparisons.quadrature import coefficient, confirm
from report.evidence import Evidence

SOURCE = "derivations/backlash.py"
b = sympy.Symbol("b", positive=True)
SINE, COSINE = sympy.sin(CONTACT), sympy.cos(CONTACT)
ROOT = sympy.sqrt(1 + GAMMA**2)
# A flight has to last: contact after separation, within half a turn.
VALUES = {GAMMA: sympy.Rational(5, 4), CONTACT: sympy.Rational(9, 4)}
IN_PHASE = Mathematics(
    r"n_p = \frac{2\gamma^2}{\pi(1+\gamma^2)} \left(\frac{1+\gamma^2}{2\gamma^2} (\phi_s - \phi_c + \pi + "
    r"\sin\phi_c \cos\phi_c) + \frac{1}{2\gamma} + "
    r"\frac{1}{\gamma} \left(\frac{b}{A} - \sqrt{1+\gamma^2}\right) "
    r"\left(\frac{1}{\gamma} \cos\phi_c - \sin\phi_c\right) - \frac{1}{\gamma} \sin^2\phi_c - "
    r"\sin\phi_c \cos\phi_c\right)"
)
FACTOR = r"\frac{-2\gamma^2}{\pi(1+\gamma^2)}"
QUADRATURE = (
    r"1 + \frac{1}{2\gamma^2} + \frac{1-\gamma^2}{2\gamma^2} \sin^2\phi_c",
    r"\frac{1}{\gamma} \left(\frac{b}{A} - \sqrt{1+\gamma^2}\right) \left(\frac{1}{\gamma} \sin\phi_c + "
    r"\cos\phi_c\right) + \frac{1}{\gamma} \sin\phi_c \cos\phi_c",
)


def claims(_: Evidence) -> tuple[Claim, ...]:
    """Return the claims in thesis order."""
    derived = general_describing_function()
    return (_complex_form(derived), _in_phase(derived), _quadrature(derived))


@cache
def general_describing_function() -> sympy.Expr:
    """Return N of the general element as a function of γ and the contact angle alone."""
    ratio = contact_ratio()
    function = describing_function(general_waveform(), A).subs(GAP, A * ratio)
    return sympy.expand(function).subs(SEPARATION, separation_angle())


def _point() -> dict[sympy.Expr, sympy.Expr]:
    angle = separation_angle().subs(VALUES)
    ratio = contact_ratio().subs(SEPARATION, angle).subs(VALUES)
    return {**VALUES, A: sympy.Integer(1), SEPARATION: angle, GAP: ratio}


def _complex_form(derived: sympy.Expr) -> Claim:
    real, imaginary = sympy.re(derived), sympy.im(derived)
    form = Mathematics(r"N(A, \omega) = n_p(A, \omega) + j\,n_q(A, \omega)")
    numeric = _numeric()
    return Claim(
        id="eq-2.47",
        parts=(
            Part(
                "",
                SameExpression(real + sympy.I * imaginary, derived),
                confirm(derived, numeric, _point()),
                printed_form=form,
                derived_form=form,
            ),
        ),
        explanation=(
            "$n_p$ is the part in phase with the input, $n_q$ the part ahead of it by a quarter turn, as in "
            "equation 2.35."
        ),
        source=SOURCE,
    )


@cache
def _numeric() -> complex:
    wave, values = general_waveform(), _point()
    return coefficient(wave, sympy.sin(THETA), values) + 1j * coefficient(wave, sympy.cos(THETA), values)


def gap_over_amplitude() -> sympy.Expr:
    """Return b/A from the derived contact equation."""
    return contact_ratio().subs(SEPARATION, separation_angle())


def in_phase_part(label: str, derived: sympy.Expr) -> Part:
    """Return the part on n_p, which equation B.3 and Listing A.5 print alike."""
    bracket = total(
        (1 + GAMMA**2) / (2 * GAMMA**2) * (separation_angle() - CONTACT + sympy.pi + SINE * COSINE),
        1 / (2 * GAMMA),
        1 / GAMMA * (gap_over_amplitude() - ROOT) * (COSINE / GAMMA - SINE),
        -(SINE**2) / GAMMA,
        -SINE * COSINE,
    )
    printed = 2 * GAMMA**2 / (sympy.pi * (1 + GAMMA**2)) * bracket
    real = sympy.re(derived)
    return Part(
        label,
        SameExpression(printed, real, assume=_flight_lasts()),
        confirm(real, complex(_numeric().real), _point()),
        printed_form=IN_PHASE,
        derived_form=IN_PHASE,
    )


def quadrature_terms() -> tuple[sympy.Expr, sympy.Expr, sympy.Expr]:
    """Return the factor of n_q, the terms that equation B.4 puts behind it, and those it leaves out."""
    factor = -2 * GAMMA**2 / (sympy.pi * (1 + GAMMA**2))
    behind = 1 + 1 / (2 * GAMMA**2) + (1 - GAMMA**2) / (2 * GAMMA**2) * SINE**2
    left_out = 1 / GAMMA * (gap_over_amplitude() - ROOT) * (SINE / GAMMA + COSINE) + SINE * COSINE / GAMMA
    return factor, behind, left_out


def quadrature_part(label: str, derived: sympy.Expr) -> Part:
    """Return the part on n_q as Listing A.5 has it, with the factor before all terms."""
    factor, behind, left_out = quadrature_terms()
    imaginary = sympy.im(derived)
    form = Mathematics(rf"n_q = {FACTOR} \left({QUADRATURE[0]} + {QUADRATURE[1]}\right)")
    return Part(
        label,
        SameExpression(factor * (behind + left_out), imaginary, assume=_flight_lasts()),
        confirm(imaginary, complex(_numeric().imag), _point()),
        printed_form=form,
        derived_form=form,
    )


def _in_phase(derived: sympy.Expr) -> Claim:
    return Claim(
        id="eq-B.3",
        parts=(in_phase_part("with $b/A$ from the contact equation", derived),),
        explanation=(
            "Put together with the right contact equation, the printed expression is the in-phase part of "
            "the derived describing function."
        ),
        source=SOURCE,
    )


def _flight_lasts() -> sympy.Basic:
    return sympy.And(sympy.Gt(CONTACT, separation_angle()), sympy.Lt(CONTACT, separation_angle() + sympy.pi))


def _quadrature(derived: sympy.Expr) -> Claim:
    factor, behind, left_out = quadrature_terms()
    imaginary = sympy.im(derived)
    return Claim(
        id="eq-B.4",
        parts=(
            Part(
                "with $b/A$ from the contact equation",
                SameExpression(factor * behind + left_out, imaginary, assume=_flight_lasts()),
                confirm(imaginary, complex(_numeric().imag), _point()),
                Slip(
                    "the bracket is closed before its last two terms",
                    imaginary - factor * left_out + left_out,
                    Verdict.ERRATUM,
                ),
                Mathematics(rf"n_q = {FACTOR} \left({QUADRATURE[0]}\right) + {QUADRATURE[1]}"),
                Mathematics(rf"n_q = {FACTOR} \left({QUADRATURE[0]} + {QUADRATURE[1]}\right)"),
            ),
        ),
        explanation=(
            "The bracket behind the common factor closes after the term in $\\sin^2\\phi_c$; it has to hold "
            "the last two terms as well. With the bracket around everything, as Listing A.5 has it, the "
            "expression is the derived one."
        ),
        consequence="None: Listing A.5, which computes the contours, has the bracket right.",
        impact=Impact.LOCAL,
        source=SOURCE,
    )
