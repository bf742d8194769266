"""Claims of section 2.2.1 on the state space (equations 2.10 to 2.14)."""

from __future__ import annotations

import sympy

from derivations.state_space import output_row
from derivations.symbols import (
    c1,
    c2,
    c3,
    c4,
    coordinates,
    k1,
    k2,
    k3,
    k4,
    k5,
    m1,
    m2,
    m3,
    m4,
    u,
    u_dot,
    velocities,
)
from report.chapters.chapter_2.claims import trimmer_printed
from report.claim import Claim, Confirmation, Mathematics, Part
from report.comparisons.expression import SameExpression, SameMatrix
from report.comparisons.printed import over, product, total
from report.evidence import Evidence

SOURCE = "derivations/state_space.py"
STATE = sympy.ImmutableMatrix([*coordinates, *velocities])
INPUT = sympy.ImmutableMatrix([u, u_dot])


def claims(evidence: Evidence) -> tuple[Claim, ...]:
    """Return the claims in thesis order."""
    return (
        _general_form(evidence),
        _first_order_equations(evidence),
        _state_matrix(evidence),
        _input_matrix(evidence),
        _output_matrix(),
    )


def _newton_rates(evidence: Evidence) -> sympy.ImmutableMatrix:
    return sympy.ImmutableMatrix([*velocities, *evidence.derivation.newton])


def _general_form(evidence: Evidence) -> Claim:
    space = evidence.derivation.space
    output = output_row(of=1, relative_to=3, size=len(coordinates))
    feedthrough = sympy.zeros(1, INPUT.rows)
    form = Mathematics("\\dot q(t) = A q(t) + B u(t), \\quad y(t) = C q(t) + D u(t)")
    return Claim(
        id="eq-2.10",
        parts=(
            Part(
                "$A q + B u$ with the derived matrices",
                SameMatrix(space.a * STATE + space.b * INPUT, _newton_rates(evidence)),
                printed_form=form,
                derived_form=form,
            ),
            Part(
                "$C q + D u$ with the row of cutter and guard",
                SameExpression(
                    (output * STATE)[0] + (feedthrough * INPUT)[0], coordinates[1] - coordinates[3]
                ),
                printed_form=form,
                derived_form=form,
            ),
        ),
        explanation=(
            "With $A$ and $B$ of the trimmer the printed form gives back the velocities and the "
            "accelerations of Newton's law. The letter $q$ now stands for all eight states; until here it "
            "stood for the four displacements."
        ),
        source=SOURCE,
    )


def _minus(coefficient: sympy.Expr, state: sympy.Symbol) -> sympy.Expr:
    """Return minus a coefficient times a state, the coefficient kept in its brackets."""
    return product(-1, coefficient, state)


def _first_order_equations(evidence: Evidence) -> Claim:
    x = sympy.symbols("x_1:9", real=True)
    x1, x2, x3, x4, x5, x6, x7, x8 = x
    printed = (
        *(x5, x6, x7, x8),
        over(total(_minus(c1 + c2, x5), c2 * x6, _minus(k1 + k2, x1), k2 * x2, -k2 * u, -c2 * u_dot), m1),
        over(total(c2 * x5, -c2 * x6, k2 * x1, _minus(k2 + k5, x2), k5 * x3, k2 * u, c2 * u_dot), m2),
        over(total(_minus(c3 + c4, x7), c4 * x8, k5 * x2, _minus(k3 + k4 + k5, x3), k4 * x4), m3),
        over(total(c4 * x7, -c4 * x8, k4 * x3, -k4 * x4), m4),
    )
    named = dict(zip(STATE, x, strict=True))
    derived = [rate.subs(named) for rate in (*velocities, *evidence.derivation.accelerations)]
    newton = _newton_rates(evidence).subs(named)
    return Claim(
        id="eq-2.11",
        parts=tuple(
            Part(
                f"$\\dot x_{index + 1}$",
                SameExpression(printed[index], derived[index], left=rf"\dot{{x}}_{{{index + 1}}}"),
                Confirmation("Newton's second law", SameExpression(newton[index], derived[index])),
            )
            for index in range(len(x))
        ),
        explanation="All eight lines follow from equation 2.9 with the states as numbered.",
        source=SOURCE,
    )


def _state_matrix(evidence: Evidence) -> Claim:
    derived = evidence.derivation.space.a
    return Claim(
        id="eq-2.12",
        parts=(
            Part(
                "",
                SameMatrix(trimmer_printed.state_matrix(), derived, left=sympy.Symbol("A")),
                Confirmation(
                    "the slopes of Newton's accelerations",
                    SameMatrix(_newton_rates(evidence).jacobian(STATE), derived),
                ),
            ),
        ),
        explanation="All 64 entries are right.",
        source=SOURCE,
    )


def _input_matrix(evidence: Evidence) -> Claim:
    derived = evidence.derivation.space.b
    return Claim(
        id="eq-2.13",
        parts=(
            Part(
                "",
                SameMatrix(trimmer_printed.input_matrix(), derived, left=sympy.Symbol("B")),
                Confirmation(
                    "the slopes of Newton's accelerations",
                    SameMatrix(_newton_rates(evidence).jacobian(INPUT), derived),
                ),
            ),
        ),
        explanation=(
            "Both columns are right. There are two because the damper $c_2$ sits on the pin; dampers "
            "elsewhere would not ask for a velocity input."
        ),
        source=SOURCE,
    )


def _output_matrix() -> Claim:
    return Claim(
        id="eq-2.14",
        parts=(
            Part(
                "cutter relative to guard, $q_2 - q_4$",
                SameMatrix(
                    trimmer_printed.output_matrix(),
                    output_row(of=1, relative_to=3, size=len(coordinates)),
                    left=sympy.Symbol("C"),
                ),
            ),
        ),
        explanation=(
            "The row gives the displacement of the cutter relative to the guard, $q_2 - q_4$. Section 3.1 "
            "writes the output with the opposite sign, $x_4 - x_2$. Without feedback magnitudes and "
            "frequencies are the same; in the closed loop the sign matters (see that section)."
        ),
        source=SOURCE,
    )
