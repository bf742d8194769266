"""Claims of appendices A.1 and A.2: transfer function, four integrals, and Listing A.1, the linear model."""

import math
from dataclasses import dataclass, replace

import control
import numpy as np
import sympy

from derivations import assumed
from derivations.elements.waveform import THETA, Segment
from derivations.state_space import output_row
from derivations.symbols import A, c2, coordinates, s, u, u_dot, velocities
from report.chapters.chapter_2.claims import trimmer_printed
from report.chapters.chapter_2.claims.section_2_2_2 import transfer_formula
from report.chapters.second_ways import by_quadrature
from report.judging.comparisons.printed import product
from report.judging.parts import assertion, close, expression, matrix, same, small
from report.judging.record import ClaimRecord, Record, claim, text
from report.numbers.evidence import Evidence
from report.numbers.independent.waveforms import integral as quadrature_integral
from report.numbers.thesis import LIMIT_CYCLE_OMEGA
from trimmer import linear_model, response_at

b = assumed.positive("b")
tau = assumed.real("t")
VALUES = {A: sympy.Rational(17, 10), b: sympy.Rational(3, 7)}  # Where the integrals are found numerically too


@claim("eq-A.1")
def states(known: Evidence) -> Record:
    system, state = known.general, known.transformed.state
    right_side = system.b * system.input_transform
    factored = s * sympy.eye(system.a.rows) - system.a
    rows = (
        (s * state - system.a * state, right_side, "sQ(s) - AQ(s) = BU(s)"),
        (factored * state, right_side, "(sI - A)Q(s) = BU(s)"),
        (factored.inv() * right_side, state, "Q(s) = (sI - A)^{-1}BU(s)"),
    )
    for line, (*sides, words) in enumerate(rows, start=1):
        left, right = (sympy.ImmutableMatrix(side) for side in sides)
        form = words
        yield matrix(f"line {line}", left, right, form=form)
    yield text("All three lines hold for a general system of two states that starts at rest.")


@claim("eq-A.2")
def output(known: Evidence) -> Record:
    system = known.general
    resolvent = (s * sympy.eye(system.a.rows) - system.a).inv()
    (by_states,) = system.c * (resolvent * system.b * system.input_transform)
    rows = (
        (by_states + system.d * system.input_transform, "Y(s) = C[(sI - A)^{-1}BU(s)] + DU(s)"),
        (transfer_formula(known) * system.input_transform, "Y(s) = (C(sI - A)^{-1}B + D)U(s)"),
    )
    for line, (printed, words) in enumerate(rows, start=1):
        form = words
        derived = known.transformed.output
        yield expression(f"line {line}", printed, derived, form=form)
    yield text("Both lines equal the output that solving the equations one by one gives.")


@dataclass(frozen=True)
class Integral:
    """One of the four integrals: limits and integrand, and both as the thesis prints them, in TeX."""

    integrand: sympy.Expr
    lower: sympy.Expr
    upper: sympy.Expr
    form: str
    value: sympy.Expr
    value_form: str


def integral(number: int, printed: Integral) -> ClaimRecord:
    """Return the claim on one of the four integrals."""

    @claim(f"eq-A.1.{number}")
    def record(_: Evidence) -> Record:
        lower, upper, integrand = printed.lower, printed.upper, printed.integrand
        derived = sympy.simplify(sympy.integrate(integrand, (tau, lower, upper)))
        segment = Segment(lower, upper, integrand.subs(tau, THETA))
        numeric = quadrature_integral(segment, sympy.Integer(1), VALUES)
        yield expression(
            "",
            printed.value,
            derived,
            left=printed.form,
            assume=sympy.Gt(A, b),
            printed_form=f"{printed.form} = {printed.value_form}",
            second=by_quadrature(derived, numeric, VALUES),
        )
        yield text("""
        The integral has the printed value for every $A > b$; $b$ is half of the total gap here. It belongs to
        equation B.1, where the describing function of backlash is derived, not below the transfer function.
    """)

    return record


PI, CONTACT = sympy.pi, sympy.asin(1 - 2 * b / A)
HOLD, HOLD_FORM, ZERO = 2 * b * (b - A) / A, r"\frac{2b(b - A)}{A}", sympy.Integer(0)
ARCSINE = r"\sin^{-1}\left(1 - \frac{2b}{A}\right)"
UPPER, LOWER = (A * sympy.sin(tau) + b) * sympy.cos(tau), (A * sympy.sin(tau) - b) * sympy.cos(tau)
FRONT, BACK = (A - b) * sympy.cos(tau), product(-1, A - b, sympy.cos(tau))
FRONT_FORM = rf"\int_{{\frac{{\pi}}{{2}}}}^{{\pi - {ARCSINE}}} (A - b)\cos(t)\,dt"
UPPER_FORM = rf"\int_{{\pi - {ARCSINE}}}^{{\frac{{3\pi}}{{2}}}} (A\sin(t) + b)\cos(t)\,dt"
BACK_FORM = rf"\int_{{\frac{{3\pi}}{{2}}}}^{{2\pi - {ARCSINE}}} -(A - b)\cos(t)\,dt"
LOWER_FORM = rf"\int_{{2\pi - {ARCSINE}}}^{{\frac{{5\pi}}{{2}}}} (A\sin(t) - b)\cos(t)\,dt"
first_integral = integral(1, Integral(FRONT, PI / 2, PI - CONTACT, FRONT_FORM, HOLD, HOLD_FORM))
second_integral = integral(2, Integral(UPPER, PI - CONTACT, 3 * PI / 2, UPPER_FORM, ZERO, "0"))
third_integral = integral(3, Integral(BACK, 3 * PI / 2, 2 * PI - CONTACT, BACK_FORM, HOLD, HOLD_FORM))
fourth_integral = integral(4, Integral(LOWER, 2 * PI - CONTACT, 5 * PI / 2, LOWER_FORM, ZERO, "0"))


@claim("lst-A.1")
def linear_listing(known: Evidence) -> Record:
    space, numbers = known.derivation.space, known.numbers
    states, rates = (*coordinates, *velocities), (*velocities, *known.derivation.newton)
    relative = (coordinates[1] - coordinates[3],)
    rows = (
        ("A, lines 30 to 37", trimmer_printed.state_matrix(), space.a, rates, states),
        ("B, lines 39 to 46", trimmer_printed.input_matrix(), space.b, rates, (u, u_dot)),
        ("C, line 50", trimmer_printed.output_matrix(), output_row(1, 3, 4), relative, states),
    )
    for label, printed, derived, forces, variables in rows:
        by_newton = sympy.ImmutableMatrix(sympy.Matrix(forces).jacobian(variables)).expand()
        second = same("the forces on each body", by_newton, derived.expand())
        yield matrix(label, printed, derived, second=second)
    systems = (numbers.displacement_only, numbers.both_channels)
    kept, whole = (complex(response_at(system, LIMIT_CYCLE_OMEGA)) for system in systems)
    ratio = numbers.parameters.c2 / numbers.parameters.k2
    by_factor = kept * (1 + 1j * LIMIT_CYCLE_OMEGA * ratio)
    lead = math.degrees(math.atan2((whole / kept).imag, (whole / kept).real))
    yield assertion(
        "G = G(1), line 58",
        """
        because the output is a displacement, the first of the two transfer functions is the response to the
        pin
        """,
        abs(whole - kept) <= 1e-6 * abs(kept),
        f"""
        the pin moves with a velocity too, so the response is $G_1 + sG_2$; at {LIMIT_CYCLE_OMEGA} rad/s it is
        {100 * (abs(whole / kept) - 1):.2f} % larger than $G_1$ and leads it by {lead:.2f} degrees
        """,
        method="both transfer functions evaluated",
        second=close(r"$G_1 + sG_2 = (1 + s\,c_2/k_2)\,G_1$", by_factor, whole),
    )
    without, with_it = (control.margin(system)[1] for system in systems)
    yield text(rf"""
        The matrices are typed correctly, and the parameters give the eigenvalues of [equation 5.2](#eq-5.2).
        Line 58 keeps the first input alone, and the text gives the choice of output as the reason. An output
        cannot decide which inputs act: they are displacement and velocity of the pin, and a pin that moves
        has both.

        Every later prediction uses the pin's displacement alone. The neglected factor $1 + s\,c_2/k_2$ adds
        phase: at unit gain the loop's phase margin is {without:.2f} degrees without it and {with_it:.2f} with
        it, on which the predicted limit cycles depend.
    """)


@claim("txt-A.2-two-columns")
def two_columns(known: Evidence) -> Record:
    velocity = known.derivation.space.b[:, 1].subs(c2, 0)
    dissipation = known.derivation.rayleigh_function.subs(c2, 0)
    without = linear_model(replace(known.numbers.parameters, c2=0.0))
    largest = float(np.abs(np.asarray(without.B)[:, 1]).max())
    yield assertion(
        "",
        "a second input, of velocity, follows from the system's dissipation",
        dissipation == 0 or not velocity.is_zero_matrix,
        "with $c_2 = 0$ the second column is zero, while $c_1$, $c_3$ and $c_4$ go on to dissipate",
        method="derived input matrix and dissipation function",
        second=small("the numeric model without $c_2$", largest),
    )
    yield text("""
        Read as said of any dissipation, the reason is wrong: one damper alone brings the pin's velocity in,
        $c_2$ between pin and bridge. Read as said of that damper it is right. The two columns belong to
        displacement and velocity of the pin, which are one motion, not to relative motions of the trimmer, as
        the text calls them.

        None by itself. [Line 58 of Listing A.1](#lst-A.1), which drops the second column, leaves out $c_2$ at
        the pin.
    """)
