"""Claims of section 2.2.1 on the state space (equations 2.10 to 2.14)."""

import sympy

from derivations import assumed
from derivations.state_space import output_row
from derivations.symbols import coordinates, masses, u, u_dot, velocities
from report.chapters.chapter_2.claims import trimmer_printed
from report.chapters.chapter_2.claims.trimmer_printed import c1, c2, c3, c4, k1, k2, k3, k4, k5
from report.judging.claim import Confirmation
from report.judging.comparisons.printed import over, product, total
from report.judging.parts import expression, matrix, same
from report.judging.record import Record, claim, text
from report.numbers.evidence import Evidence

STATE = sympy.ImmutableMatrix([*coordinates, *velocities])
INPUT = sympy.ImmutableMatrix([u, u_dot])
OUTPUT = output_row(of=1, relative_to=3, size=len(coordinates))
RATES, READ_OUT = r"\dot q(t) = A q(t) + B u(t)", "y(t) = C q(t) + D u(t)"  # The two lines of equation 2.10
FIRST_ORDER = (
    *("x_5", "x_6", "x_7", "x_8"),
    r"\frac{1}{m_1} [-(c_1 + c_2)x_5 + c_2x_6 - (k_1 + k_2)x_1 + k_2x_2 - k_2u - c_2\dot u]",
    r"\frac{1}{m_2} [c_2x_5 - c_2x_6 + k_2x_1 - (k_2 + k_5)x_2 + k_5x_3 + k_2u + c_2\dot u]",
    r"\frac{1}{m_3} [-(c_3 + c_4)x_7 + c_4x_8 + k_5x_2 - (k_3 + k_4 + k_5)x_3 + k_4x_4]",
    r"\frac{1}{m_4} [c_4x_7 - c_4x_8 + k_4x_3 - k_4x_4]",
)
"""The right sides of equation 2.11 as TeX, in the thesis's order."""


def newton_rates(known: Evidence) -> sympy.ImmutableMatrix:
    """Return the rates of the eight states by Newton's second law."""
    return sympy.ImmutableMatrix([*velocities, *known.derivation.newton])


def by_slopes(known: Evidence, variables: sympy.MatrixBase, derived: sympy.MatrixBase) -> Confirmation:
    """Confirm a matrix of the state equation by derivatives."""
    slopes = newton_rates(known).jacobian(variables)
    return same("the slopes of Newton's accelerations", slopes, derived)


@claim("eq-2.10")
def general_form(known: Evidence) -> Record:
    space = known.derivation.space
    rates = space.a * STATE + space.b * INPUT
    output = (OUTPUT * STATE)[0] + (sympy.zeros(1, INPUT.rows) * INPUT)[0]
    relative = coordinates[1] - coordinates[3]
    yield matrix("$A q + B u$ with the derived matrices", rates, newton_rates(known), form=RATES)
    yield expression("$C q + D u$ with the row of cutter and guard", output, relative, form=READ_OUT)
    yield text("""
        With $A$ and $B$ of the trimmer the printed form gives back the velocities and the accelerations of
        Newton's law. The letter $q$ now stands for all eight states; until here it stood for the four
        displacements.
    """)


@claim("eq-2.11")
def first_order_equations(known: Evidence) -> Record:
    x1, x2, x3, x4, x5, x6, x7, x8 = states = assumed.real("x_1:9")
    m1, m2, m3, m4 = masses

    def minus(coefficient: sympy.Expr, state: sympy.Symbol) -> sympy.Expr:
        return product(-1, coefficient, state)

    printed = (
        *(x5, x6, x7, x8),
        over(total(minus(c1 + c2, x5), c2 * x6, minus(k1 + k2, x1), k2 * x2, -k2 * u, -c2 * u_dot), m1),
        over(total(c2 * x5, -c2 * x6, k2 * x1, minus(k2 + k5, x2), k5 * x3, k2 * u, c2 * u_dot), m2),
        over(total(minus(c3 + c4, x7), c4 * x8, k5 * x2, minus(k3 + k4 + k5, x3), k4 * x4), m3),
        over(total(c4 * x7, -c4 * x8, k4 * x3, -k4 * x4), m4),
    )
    named = dict(zip(STATE, states, strict=True))
    derived = [rate.subs(named) for rate in (*velocities, *known.derivation.accelerations)]
    lines = zip(printed, derived, newton_rates(known).subs(named), FIRST_ORDER, strict=True)
    for index, (line, rate, newton, shown) in enumerate(lines, start=1):
        second, form = same("Newton's second law", newton, rate), rf"\dot{{x}}_{{{index}}} = {shown}"
        yield expression(rf"$\dot x_{index}$", line, rate, second=second, form=form)
    yield text("All lines follow from [equation 2.9](#eq-2.9) with the states as numbered.")


@claim("eq-2.12")
def state_matrix(known: Evidence) -> Record:
    derived, printed = known.derivation.space.a, trimmer_printed.state_matrix()
    yield matrix("", printed, derived, sympy.Symbol("A"), second=by_slopes(known, STATE, derived))
    yield text("Every entry is right.")


@claim("eq-2.13")
def input_matrix(known: Evidence) -> Record:
    derived, printed = known.derivation.space.b, trimmer_printed.input_matrix()
    yield matrix("", printed, derived, sympy.Symbol("B"), second=by_slopes(known, INPUT, derived))
    yield text("""
        Both columns are right. There are two because the damper $c_2$ is driven by the pin's velocity; the
        other dampers ask for no such input.
    """)


@claim("eq-2.14")
def output_matrix(_: Evidence) -> Record:
    printed = trimmer_printed.output_matrix()
    yield matrix("cutter relative to guard, $q_2 - q_4$", printed, OUTPUT, sympy.Symbol("C"))
    yield text("""
        The row gives the displacement of the cutter relative to the guard, $q_2 - q_4$. Section 3.1 writes
        the output with the opposite sign, $x_4 - x_2$. Without feedback magnitudes and frequencies stay the
        same; [in the closed loop the sign matters](#txt-3.1-output-sign).
    """)
