"""Claims of appendices A.3 to A.5, A.7 and A.11: listings of describing functions (A.2 to A.4, A.6, A.10)."""

from __future__ import annotations

import numpy as np
import sympy
from scipy.optimize import brentq

from derivations.backlash import (
    CONTACT,
    GAP,
    friction_waveform,
    inertia_contact_ratio,
    inertia_waveform,
)
from derivations.friction import FORCE
from derivations.friction import friction_waveform as coulomb_waveform
from derivations.symbols import A, omega
from derivations.waveform import THETA, describing_function, simplified_describing_function
from report.claim import Claim, Confirmation, Impact, Part, Slip, Verdict
from report.comparisons.assertion import Assertion
from report.comparisons.digits import CloseNumbers
from report.comparisons.expression import SameExpression
from report.comparisons.quadrature import coefficient, confirm
from report.evidence import Evidence

BACKLASH = "derivations/backlash.py"
REACHED = sympy.Gt(A, GAP / 2)
FRICTION = friction_waveform()
VALUES = {A: sympy.Rational(17, 10), GAP: sympy.Rational(6, 7)}


def claims(_: Evidence) -> tuple[Claim, ...]:
    """Return the claims in thesis order."""
    return (
        _friction(
            "lst-A.2",
            "The second version, Listing A.3, is the same but for lines 9 and 10: see appendix A.3 on names.",
        ),
        _friction(
            "lst-A.3",
            "The text before it describes another function, with an input wave and a previous output: "
            "Listing A.7.",
        ),
        _inertia("lst-A.4"),
        _equivalent(),
        _inertia("lst-A.10"),
    )


def friction_listing(amplitude: complex, width: float) -> complex:
    """Return what Listing A.3 returns: its last line overwrites the zeros that its sixth line has set."""
    ratio = np.complex128(1 - width / amplitude)
    real = 0.5 + ratio * np.sqrt(1 - ratio**2) / np.pi + np.arcsin(ratio) / np.pi
    return complex(real - 1j * (1 - ratio**2) / np.pi)


def friction_expression() -> sympy.Expr:
    """Return N of Listings A.2, A.3 and, but for friction, A.6, with the gap for its b."""
    ratio = 1 - GAP / A
    real = sympy.Rational(1, 2) + ratio * sympy.sqrt(1 - ratio**2) / sympy.pi + sympy.asin(ratio) / sympy.pi
    return real - sympy.I * (1 - ratio**2) / sympy.pi


def _formula_part() -> Part:
    derived = simplified_describing_function(FRICTION, A)
    sine, cosine = (coefficient(FRICTION, weight(THETA), VALUES) for weight in (sympy.sin, sympy.cos))
    return Part(
        "formula, with $b$ the total gap",
        SameExpression(friction_expression(), derived, left=sympy.Symbol("N"), assume=REACHED),
        confirm(derived, (sine + 1j * cosine) / float(VALUES[A]), VALUES),
    )


def _friction(claim_id: str, remark: str) -> Claim:
    inside = friction_listing(0.25, 1.0)
    return Claim(
        id=claim_id,
        parts=(
            _formula_part(),
            Part(
                "amplitudes inside the dead band",
                Assertion(
                    statement="the function returns zero where the pin does not reach the bridge",
                    derived=abs(inside) < 1e-12,
                    evidence=(
                        "the zeros of line 6 are overwritten by line 12; at a quarter of the gap the value "
                        f"is {inside.real:.2f} {inside.imag:+.2f} j"
                    ),
                    method="the listing, repeated line by line",
                ),
                Confirmation(
                    "the square root of a negative number",
                    CloseNumbers(complex(friction_expression().subs({A: 0.25, GAP: 1.0})), inside),
                ),
            ),
        ),
        explanation=(
            "The formula is right when $b$ is the total gap; equations 2.36 to 2.41 use half of it for the "
            "same letter. "
            "The guard of line 6 asks for $A < b$ where $A < b/2$ is meant, and has no effect. " + remark
        ),
        consequence=(
            "The plots start above $b/2$, so no figure shows it. A search that strays below $b/2$ gets "
            "complex numbers that mean nothing."
        ),
        impact=Impact.LOCAL,
        source=BACKLASH,
    )


def inertia_listing(ratio: float, scale: float) -> complex:
    """Return what Listing A.4 returns for its arguments Beta and w, with the root of its equation."""
    return _inertia_formula(brentq(lambda x: scale * x - ratio - np.sin(scale * x), 0.0, 10.0 / scale), ratio)


def _inertia_formula(angle: float, ratio: float) -> complex:
    """Return what the lines of Listing A.4 after its search make of the root that it found."""
    nested = np.sin(angle) + ratio
    real = (np.pi + 2 * np.sin(nested) - angle - np.sin(nested) * np.cos(nested)) / np.pi
    return complex(real, -((1 - np.cos(nested)) ** 2) / np.pi)


def _inertia(claim_id: str) -> Claim:
    ratio = inertia_contact_ratio()
    nested = sympy.sin(CONTACT) + ratio
    printed = (
        sympy.pi + 2 * sympy.sin(nested) - CONTACT - sympy.sin(nested) * sympy.cos(nested)
    ) / sympy.pi - sympy.I * (1 - sympy.cos(nested)) ** 2 / sympy.pi
    derived = simplified_describing_function(inertia_waveform(), A, (GAP, A * ratio))
    one, two = inertia_listing(1.0, 1.0), inertia_listing(1.0, 2.0)
    angle = float(sympy.nsolve(CONTACT - sympy.sin(CONTACT) - 1, 1.9))
    right = complex(derived.subs(CONTACT, angle))
    return Claim(
        id=claim_id,
        parts=(
            Part(
                "with $w = 1$",
                SameExpression(printed, derived, left=sympy.Symbol("N")),
                Confirmation("the listing, repeated, at Beta = 1", CloseNumbers(one, right)),
            ),
            _second_argument(one, two, angle),
        ),
        explanation=(
            "Line 3 scales the unknown by $w$, so its root is the contact angle divided by $w$, which the "
            "formula then takes for the angle itself. For $w = 1$ everything is right; the describing "
            "function has no frequency, and the argument should not be there."
        ),
        consequence=(
            "Whether figure 5.13 suffers depends on the $w$ it was called with, which is not given. The "
            "prediction near 5120 rad/s in section 5.2.2 tells."
        ),
        impact=Impact.LOCAL,
        source=BACKLASH,
    )


def _second_argument(one: complex, two: complex, angle: float) -> Part:
    return Part(
        "with another $w$",
        Assertion(
            statement="the result does not depend on the second argument",
            derived=abs(two - one) < 1e-9,
            evidence=(
                f"at Beta = 1 it is {one.real:.4f} {one.imag:+.4f} j for $w = 1$ and {two.real:.4f} "
                f"{two.imag:+.4f} j for $w = 2$"
            ),
            method="the listing, repeated line by line",
        ),
        Confirmation(
            "its formula at half of the contact angle, the root of line 3 for $w = 2$",
            CloseNumbers(_inertia_formula(angle / 2, 1.0), two),
        ),
    )


def _equivalent() -> Claim:
    relay = 4 * FORCE / (sympy.pi * A)
    printed = relay / (sympy.I * omega)
    derived = sympy.simplify(sympy.I * omega * relay.subs(A, omega * A))
    by_displacement = describing_function(coulomb_waveform(), A)
    return Claim(
        id="lst-A.6",
        parts=(
            _formula_part(),
            Part(
                "friction term, line 18",
                SameExpression(printed, derived),
                Confirmation(
                    "the Fourier coefficients of friction under a displacement",
                    SameExpression(by_displacement, derived),
                ),
                Slip(
                    "the relay's gain for a displacement is divided by $j\\omega$ instead of that for a "
                    "velocity multiplied by it",
                    relay / (sympy.I * omega),
                    Verdict.ERRATUM,
                ),
            ),
        ),
        explanation=(
            "The backlash part is that of Listing A.3. The friction part divides by $j\\omega$ what has to "
            "be multiplied by it, and uses the amplitude of the displacement for that of the velocity. The "
            "right term is $j\\,4F_c/(\\pi A)$: other sign, no frequency, and in N/m."
        ),
        consequence=(
            "All contours of section 5.2.5 contain it. The caption calls the listing viscous-controlled, "
            "which it is not."
        ),
        impact=Impact.DOWNSTREAM,
        source="derivations/friction.py",
    )
