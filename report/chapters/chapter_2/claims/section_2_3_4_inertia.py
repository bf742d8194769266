"""Claims of section 2.3.4 on inertia-controlled backlash (2.42 and 2.43). Here b is the total gap."""

from __future__ import annotations

import control
import sympy

from derivations.backlash import (
    CONTACT,
    GAP,
    friction_waveform,
    inertia_contact_ratio,
    inertia_waveform,
    limits,
)
from derivations.symbols import A
from derivations.waveform import THETA, simplified_describing_function
from report.claim import Claim, Confirmation, Impact, Part, Slip, Verdict
from report.comparisons.assertion import Assertion
from report.comparisons.digits import CloseNumbers
from report.comparisons.expression import SameExpression
from report.comparisons.printed import product, total
from report.comparisons.quadrature import coefficient, confirm
from report.comparisons.second_ways import second_way
from report.evidence import Evidence

SOURCE = "derivations/backlash.py"
b = sympy.Symbol("b", positive=True)
WAVEFORM = inertia_waveform(b)
LINES = ("first", "second", "third", "fourth")
ANGLE = sympy.Rational(8, 5)


def claims(_: Evidence) -> tuple[Claim, ...]:
    """Return the claims in thesis order."""
    return (_waveform(), _contact_equation(), _describing_function(), _imaginary_signs())


def _waveform() -> Claim:
    half, sine = b / 2, sympy.sin(THETA)
    printed = (
        total(A * THETA, -half),
        total(A * sine, half),
        product(-A, THETA - sympy.pi),
        total(A * sine, -half),
    )
    return Claim(
        id="eq-2.42",
        parts=tuple(
            Part(
                f"{line} piece, $\\theta = \\omega t$",
                SameExpression(value, segment.value, left=sympy.Symbol("y")),
                _continuous(index),
                Slip(
                    "the offset b/2 at the start of the piece is lost", segment.value - half, Verdict.ERRATUM
                ),
            )
            for index, (line, value, segment) in enumerate(
                zip(LINES, printed, WAVEFORM.segments, strict=True)
            )
        ),
        explanation=(
            "The third piece begins where the bridge separates at $\\omega t = \\pi$, at $+b/2$; printed it "
            "begins at zero, so the output would jump by $b/2$ twice a period and no longer be odd. The "
            "limits of the pieces mix phases and times: $\\phi$ is an angle, $t$ a time."
        ),
        consequence=(
            "None: Listing A.8 adds the constant $\\pi A + b/2$, which contains the offset, and the "
            "describing function in equation 2.43 is that of the right waveform."
        ),
        impact=Impact.LOCAL,
        source=SOURCE,
    )


def _continuous(index: int) -> Confirmation:
    values = {b: A * inertia_contact_ratio().subs(CONTACT, ANGLE)}
    segment, before = WAVEFORM.segments[index], WAVEFORM.segments[index - 1]
    end, start = (
        complex(piece.value.subs(THETA, phase).subs(values).subs({CONTACT: ANGLE, A: 1}).evalf(20))
        for piece, phase in ((before, before.end), (segment, segment.start))
    )
    return Confirmation("continuity at the start of the piece", CloseNumbers(end, start))


def _contact_equation() -> Claim:
    printed = CONTACT - sympy.sin(CONTACT) - b / A
    meeting = sympy.expand((WAVEFORM.segments[0].value - WAVEFORM.segments[1].value).subs(THETA, CONTACT) / A)
    delay = sympy.Symbol("tau", positive=True)
    limit = limits(sympy.oo).ratio.subs(delay, CONTACT) - b / A
    return Claim(
        id="txt-2.3.4-inertia-contact-equation",
        parts=(
            Part(
                "",
                SameExpression(printed, meeting),
                Confirmation(
                    "the limit of the general element for M/D to infinity", SameExpression(limit, meeting)
                ),
            ),
        ),
        explanation=(
            "Flight and falling wall meet where the printed expression is zero. It is Kepler's equation for "
            "eccentricity one and has no solution in elementary functions, as the text says. It has exactly "
            "one root for $0 < b/A < \\pi$, since its slope $1 - \\cos\\phi$ is positive."
        ),
        source=SOURCE,
    )


def _describing_function() -> Claim:
    angle = CONTACT
    printed = total(
        product(
            1 / sympy.pi,
            total(sympy.pi, 2 * sympy.sin(angle), -angle, product(-1, sympy.sin(angle), sympy.cos(angle))),
        ),
        product(-1, sympy.I / sympy.pi * (1 - sympy.cos(angle)) ** 2),
    )
    derived = simplified_describing_function(inertia_waveform(), A, (GAP, A * inertia_contact_ratio()))
    values = {A: sympy.Integer(1), CONTACT: ANGLE, GAP: inertia_contact_ratio().subs(CONTACT, ANGLE)}
    wave = inertia_waveform()
    numeric = coefficient(wave, sympy.sin(THETA), values) + 1j * coefficient(wave, sympy.cos(THETA), values)
    return Claim(
        id="eq-2.43",
        parts=(
            Part(
                "",
                SameExpression(printed, derived, left=sympy.Symbol("N")),
                confirm(derived, numeric, values),
            ),
        ),
        explanation=(
            "The describing function of the right waveform, with $b$ the total gap. It holds as long as the "
            "bridge is in contact for a part of each half period, that is for $b/A < \\pi$."
        ),
        source=SOURCE,
    )


def _imaginary_signs() -> Claim:
    friction = sympy.simplify(friction_waveform().cosine_coefficient() / A)
    samples = [friction.subs({A: 1, GAP: sympy.Rational(k, 50)}) for k in range(1, 100)]
    limit = friction.subs(GAP, A)
    library = control.friction_backlash_nonlinearity(1.0)
    return Claim(
        id="txt-2.3.4-imaginary-signs",
        parts=(
            Part(
                "",
                Assertion(
                    statement=(
                        "the imaginary part is negative for inertia-controlled, positive for "
                        "friction-controlled backlash"
                    ),
                    derived=all(sample > 0 for sample in samples),
                    evidence=(
                        f"for friction-controlled backlash it is ${sympy.latex(sympy.factor(friction))}$, "
                        f"negative for every $A > g/2$, and ${sympy.latex(limit)}$ where it is largest in "
                        "size"
                    ),
                    method="sign of the derived coefficient over the whole domain",
                ),
                second_way(
                    "python-control's describing function of backlash at five amplitudes",
                    all(library.describing_function(each).imag < 0 for each in (0.51, 0.7, 1.0, 4.0, 90.0)),
                ),
            ),
        ),
        explanation=(
            "Both imaginary parts are negative: a load that lags behind the pin delays the output, whatever "
            "moves it. The thesis's own $a_1 = (4b/\\pi)(b/A - 1)$ is negative for every $A > b$."
        ),
        consequence=(
            "None on numbers; the listings have the right sign. Read as it stands, it would put $-1/N$ above "
            "the real axis."
        ),
        impact=Impact.LOCAL,
        source=SOURCE,
    )
