"""Claims of section 2.3.5: the describing function of Coulomb friction (equations 2.48 to 2.52)."""

from __future__ import annotations

import sympy

from derivations.friction import FORCE, friction_waveform, relay_waveform
from derivations.symbols import A
from derivations.waveform import THETA, describing_function, segment_integral
from report.claim import Claim, Confirmation, Impact, Mathematics, Part, Slip, Verdict
from report.comparisons.assertion import Assertion
from report.comparisons.digits import CloseNumbers
from report.comparisons.expression import SameExpression
from report.comparisons.printed import total
from report.comparisons.quadrature import coefficient, confirm
from report.evidence import Evidence

SOURCE = "derivations/friction.py"
SINE, COSINE = sympy.sin(THETA), sympy.cos(THETA)
VALUES = {FORCE: sympy.Rational(3, 5), A: sympy.Rational(7, 4)}
SPEED = sympy.Symbol("v", real=True)
RELAY = relay_waveform()
FRICTION = friction_waveform()


def claims(_: Evidence) -> tuple[Claim, ...]:
    """Return the claims in thesis order."""
    return (
        _law(),
        _pieces(),
        _cosine_coefficient(),
        _sine_coefficient(),
        _describing_function(),
        _input_choice(),
        _locus(),
    )


def _law() -> Claim:
    power = FORCE * sympy.sign(SPEED) * SPEED
    return Claim(
        id="eq-2.48",
        parts=(
            Part(
                "power lost by a body that feels $-F$",
                SameExpression(power, FORCE * sympy.Abs(SPEED)),
                printed_form=Mathematics(r"F(\dot x) = F_c \operatorname{sign}(\dot x)"),
                derived_form=Mathematics(r"F(\dot x)\,\dot x = F_c |\dot x| \ge 0"),
            ),
        ),
        explanation=(
            "A force of constant size against the motion takes the power $F_c|\\dot x|$, so the printed law "
            "dissipates. It is the force that the body exerts; on the body acts its negative."
        ),
        source=SOURCE,
    )


def _pieces() -> Claim:
    printed = sympy.Piecewise((FORCE, SPEED > 0), (0, sympy.Eq(SPEED, 0)), (-FORCE, True))
    rows = (("$\\dot x > 0$", 2), ("$\\dot x = 0$", 0), ("$\\dot x < 0$", -3))
    return Claim(
        id="eq-2.49",
        parts=tuple(
            Part(
                label,
                SameExpression(printed.subs(SPEED, value), FORCE * sympy.sign(value), left=sympy.Symbol("F")),
            )
            for label, value in rows
        ),
        explanation=(
            "The three cases are those of the sign function. At rest a real contact carries any force up to "
            "$F_c$, not zero; a describing function does not see the difference, a simulation does."
        ),
        source=SOURCE,
    )


def _cosine_coefficient() -> Claim:
    parts = [
        Part(
            f"integral over {label}",
            SameExpression(sympy.Integer(0), segment_integral(segment, COSINE)),
        )
        for label, segment in zip(("the first half", "the second half"), RELAY.segments, strict=True)
    ]
    derived = RELAY.cosine_coefficient()
    return Claim(
        id="eq-2.50",
        parts=(
            *parts,
            Part(
                "$a_1$, switched by its own input",
                SameExpression(sympy.Integer(0), derived, left=sympy.Symbol("a_1")),
                confirm(derived, coefficient(RELAY, COSINE, VALUES), VALUES),
            ),
        ),
        explanation=(
            "Right for a relay that its own sinusoidal input switches; for friction that input is the "
            "velocity. With the displacement as input the output is switched a quarter period earlier; then "
            "$b_1 = 0$ and $a_1 = 4F_c/\\pi$, see the statement on the choice of input."
        ),
        source=SOURCE,
    )


def _sine_coefficient() -> Claim:
    derived = RELAY.sine_coefficient()
    printed_bracket = total(-sympy.cos(sympy.pi, evaluate=False), -sympy.cos(0, evaluate=False))
    primitive = sympy.integrate(SINE, THETA)
    bracket = primitive.subs(THETA, sympy.pi) - primitive.subs(THETA, 0)
    numeric = coefficient(RELAY, SINE, VALUES)
    return Claim(
        id="eq-2.51",
        parts=(
            Part(
                "second line, the bracket",
                SameExpression(printed_bracket.doit(), bracket),
                confirm(bracket, 2.0 * numeric / float(4 * VALUES[FORCE] / sympy.pi), VALUES),
                Slip("the lower limit is added instead of subtracted", bracket - 2, Verdict.ERRATUM),
                Mathematics(r"[-\cos(\pi) - \cos(0)]"),
                Mathematics(r"[-\cos(\pi) + \cos(0)]"),
            ),
            Part(
                "third line, $b_1$",
                SameExpression(4 * FORCE / sympy.pi, derived, left=sympy.Symbol("b_1")),
                confirm(derived, numeric, VALUES),
            ),
        ),
        explanation=(
            "The bracket of the second line, taken as printed, is zero; the lower limit has to be "
            "subtracted, which gives two. The third line is right."
        ),
        consequence="None: the result in the third line is right.",
        impact=Impact.NOTATION,
        source=SOURCE,
    )


def _describing_function() -> Claim:
    derived = describing_function(RELAY, A)
    numeric = coefficient(RELAY, SINE, VALUES) / float(VALUES[A])
    return Claim(
        id="eq-2.52",
        parts=(
            Part(
                "switched by its own input of amplitude $A$",
                SameExpression(4 * FORCE / (A * sympy.pi), derived, left=sympy.Symbol("N")),
                confirm(derived, numeric, VALUES),
            ),
        ),
        explanation=(
            "The describing function of an ideal relay. For friction the input is the velocity, so $A$ is an "
            "amplitude of velocity here, and the unit is N s/m. Section 5.2.4 uses it with an amplitude of "
            "displacement."
        ),
        source=SOURCE,
    )


def _input_choice() -> Claim:
    by_velocity, by_displacement = describing_function(RELAY, A), describing_function(FRICTION, A)
    numeric = (coefficient(FRICTION, SINE, VALUES) + 1j * coefficient(FRICTION, COSINE, VALUES)) / float(
        VALUES[A]
    )
    return Claim(
        id="txt-2.3.5-input-choice",
        parts=(
            Part(
                "friction with the displacement as input",
                SameExpression(by_velocity, by_displacement, left=sympy.Symbol("N")),
                confirm(by_displacement, numeric, VALUES),
                Slip("the phase between velocity and displacement is dropped", by_velocity, Verdict.ERRATUM),
            ),
        ),
        explanation=(
            "Friction follows the velocity, which leads the displacement by a quarter period. For a "
            "displacement $A\\sin\\omega t$ it is $F_c\\,\\mathrm{sign}(\\cos\\omega t)$, and $N = "
            "j\\,4F_c/(\\pi A)$: the same size, turned by 90 degrees. No scaling removes a phase."
        ),
        consequence=(
            "Section 5.2.4 puts the real value into a loop whose signal is a displacement. That makes "
            "friction a switching spring, which stores energy, where it is a damper, which takes it."
        ),
        impact=Impact.DOWNSTREAM,
        source=SOURCE,
    )


def _locus() -> Claim:
    inverse = sympy.simplify(-1 / describing_function(FRICTION, A))
    relay = sympy.simplify(-1 / describing_function(RELAY, A))
    return Claim(
        id="txt-2.3.5-coulomb-locus",
        parts=(
            Part(
                "with the velocity as input",
                Assertion(
                    statement="$-1/N$ lies on the negative real axis",
                    derived=relay.is_negative is True,
                    evidence=f"$-1/N = {sympy.latex(relay)}$",
                    method="sign of the derived expression for every positive amplitude",
                ),
                confirm(relay, -float(VALUES[A]) / coefficient(RELAY, SINE, VALUES), VALUES),
            ),
            Part(
                "with the displacement as input, as in section 5.2.4",
                Assertion(
                    statement="$-1/N$ lies on the negative real axis",
                    derived=inverse.is_negative is True,
                    evidence="$-1/N = j\\,\\pi A/(4F_c)$ lies on the positive imaginary axis",
                    method="sign of the derived expression for every positive amplitude",
                ),
                Confirmation(
                    "$1/j = -j$",
                    CloseNumbers(
                        complex(inverse.subs(VALUES)), complex(-1 / (4j * 0.6 / (sympy.pi.evalf() * 1.75)))
                    ),
                ),
            ),
        ),
        explanation=(
            "True for a loop in the velocity. In a loop whose signal is the displacement, as the thesis's "
            "is, the locus is the positive imaginary axis, so the crossing to look for is another one."
        ),
        consequence="The conclusion of section 5.2.4 is drawn from the wrong axis; it is judged there.",
        impact=Impact.DOWNSTREAM,
        source=SOURCE,
    )
