"""Claims of appendix A.1 and A.2: transfer function, four integrals, and the listing of the linear model."""

from __future__ import annotations

import math

import control
import mpmath
import sympy

from derivations.latex import latex
from derivations.state_space import output_row
from derivations.symbols import A, coordinates, s, u, u_dot, velocities
from report.chapters.chapter_2.claims import trimmer_printed
from report.chapters.chapter_2.claims.section_2_2_2 import transfer_formula
from report.chapters.chapter_5.claims.section_5_1_2_low_pass import LIMIT_CYCLE_OMEGA
from report.claim import Claim, Confirmation, Impact, Mathematics, Part
from report.comparisons.assertion import Assertion
from report.comparisons.digits import CloseNumbers
from report.comparisons.expression import SameExpression, SameMatrix
from report.comparisons.printed import product
from report.evidence import Evidence
from report.numbers.linear_numbers import LinearNumbers
from trimmer import frequency_response

LAPLACE = "derivations/laplace.py"
b = sympy.Symbol("b", positive=True)
tau = sympy.Symbol("t", real=True)


def claims(evidence: Evidence) -> tuple[Claim, ...]:
    """Return the claims in thesis order."""
    return (_states(evidence), _output(evidence), *_integrals(), _listing(evidence))


def _states(evidence: Evidence) -> Claim:
    system, solved = evidence.general, evidence.transformed
    states, right_side = solved.state, system.b * system.input_transform
    factored = s * sympy.eye(system.a.rows) - system.a
    forms = (
        (s * states - system.a * states, right_side, "sQ(s) - AQ(s) = BU(s)"),
        (factored * states, right_side, "(sI - A)Q(s) = BU(s)"),
        (factored.inv() * right_side, states, "Q(s) = (sI - A)^{-1}BU(s)"),
    )
    return Claim(
        id="eq-A.1",
        parts=tuple(
            Part(
                f"line {line}",
                SameMatrix(sympy.ImmutableMatrix(left), sympy.ImmutableMatrix(right)),
                printed_form=Mathematics(form),
                derived_form=Mathematics(form),
            )
            for line, (left, right, form) in enumerate(forms, start=1)
        ),
        explanation="All three lines hold for a general system of two states that starts at rest.",
        source=LAPLACE,
    )


def _output(evidence: Evidence) -> Claim:
    system, solved = evidence.general, evidence.transformed
    resolvent = (s * sympy.eye(system.a.rows) - system.a).inv()
    first = (system.c * (resolvent * system.b * system.input_transform))[
        0
    ] + system.d * system.input_transform
    second = transfer_formula(evidence) * system.input_transform
    forms = (
        (first, "Y(s) = C[(sI - A)^{-1}BU(s)] + DU(s)"),
        (second, "Y(s) = (C(sI - A)^{-1}B + D)U(s)"),
    )
    return Claim(
        id="eq-A.2",
        parts=tuple(
            Part(
                f"line {line}",
                SameExpression(printed, solved.output),
                printed_form=Mathematics(form),
                derived_form=Mathematics(form),
            )
            for line, (printed, form) in enumerate(forms, start=1)
        ),
        explanation="Both lines equal the output that solving the equations one by one gives.",
        source=LAPLACE,
    )


def _integrals() -> tuple[Claim, ...]:
    contact = sympy.asin(1 - 2 * b / A)
    pi = sympy.pi
    hold = 2 * b * (b - A) / A
    rows = (
        ("eq-A.1.1", (A - b) * sympy.cos(tau), pi / 2, pi - contact, hold),
        ("eq-A.1.2", (A * sympy.sin(tau) + b) * sympy.cos(tau), pi - contact, 3 * pi / 2, 0),
        ("eq-A.1.3", product(-1, A - b, sympy.cos(tau)), 3 * pi / 2, 2 * pi - contact, hold),
        ("eq-A.1.4", (A * sympy.sin(tau) - b) * sympy.cos(tau), 2 * pi - contact, 5 * pi / 2, 0),
    )
    return tuple(_integral(*row) for row in rows)


def _integral(
    claim_id: str,
    integrand: sympy.Expr,
    lower: sympy.Expr,
    upper: sympy.Expr,
    printed: sympy.Expr,
) -> Claim:
    derived = sympy.simplify(sympy.integrate(integrand, (tau, lower, upper)))
    left = latex(sympy.Integral(integrand, (tau, lower, upper)))
    return Claim(
        id=claim_id,
        parts=(
            Part(
                "",
                SameExpression(sympy.sympify(printed), derived, left=left, assume=sympy.Gt(A, b)),
                _quadrature(integrand, lower, upper, derived),
            ),
        ),
        explanation=(
            "The integral has the printed value for every $A > b$; $b$ is half of the total gap here. It "
            "belongs to equation B.1, where the describing function of backlash is derived, not below the "
            "transfer function."
        ),
        source="report/chapters/appendix_a/claims/listings.py",
    )


def _quadrature(
    integrand: sympy.Expr, lower: sympy.Expr, upper: sympy.Expr, derived: sympy.Expr
) -> Confirmation:
    """Integrate numerically at one amplitude and gap, offset by one so that zero can be compared."""
    values = {A: sympy.Rational(17, 10), b: sympy.Rational(3, 7)}
    function = sympy.lambdify(tau, integrand.subs(values), "mpmath")
    with mpmath.workdps(30):
        limits = [mpmath.mpf(limit.subs(values).evalf(30)) for limit in (lower, upper)]
        number = complex(mpmath.quad(function, limits))
    return Confirmation("quadrature", CloseNumbers(1 + number, 1 + complex(derived.subs(values)), 1e-12))


def _matrix(
    label: str,
    printed: sympy.ImmutableMatrix,
    derived: sympy.ImmutableMatrix,
    rates: tuple[sympy.Expr, ...],
    variables: tuple[sympy.Expr, ...],
) -> Part:
    """Compare a matrix, and confirm it by the derivatives of what Newton's law gives."""
    by_newton = sympy.ImmutableMatrix(sympy.Matrix(rates).jacobian(variables)).expand()
    return Part(
        label,
        SameMatrix(printed, derived),
        Confirmation("the forces on each body", SameMatrix(by_newton, derived.expand())),
    )


def _listing(evidence: Evidence) -> Claim:
    space, newton, numbers = evidence.derivation.space, evidence.derivation.newton, evidence.numbers
    states = (*coordinates, *velocities)
    margins = [control.margin(system)[1] for system in (numbers.displacement_only, numbers.both_channels)]
    return Claim(
        id="lst-A.1",
        parts=(
            _matrix(
                "A, lines 30 to 37", trimmer_printed.state_matrix(), space.a, (*velocities, *newton), states
            ),
            _matrix(
                "B, lines 39 to 46",
                trimmer_printed.input_matrix(),
                space.b,
                (*velocities, *newton),
                (u, u_dot),
            ),
            _matrix(
                "C, line 50",
                trimmer_printed.output_matrix(),
                output_row(1, 3, 4),
                (coordinates[1] - coordinates[3],),
                states,
            ),
            _first_input(numbers),
        ),
        explanation=(
            "The matrices are typed correctly, and the parameters give the eigenvalues of equation 5.2. Line "
            "58 keeps the first input alone. The text gives the choice of output as the reason, but an "
            "output cannot decide which inputs act: they are displacement and velocity of the pin, not a "
            "relative motion of the trimmer. Section 5.1.1 calls the model single-input for the same reason."
        ),
        consequence=(
            "Every later prediction uses the pin's displacement alone. The neglected factor $1 + "
            f"s\\,c_2/k_2$ adds phase: at unit gain the loop's phase margin is {margins[0]:.2f} degrees "
            f"without it and {margins[1]:.2f} with it. The predicted limit cycles depend on this margin."
        ),
        impact=Impact.DOWNSTREAM,
        source="trimmer/linear.py",
    )


def _first_input(numbers: LinearNumbers) -> Part:
    kept, whole = (
        complex(frequency_response(system, LIMIT_CYCLE_OMEGA))
        for system in (numbers.displacement_only, numbers.both_channels)
    )
    lead = math.degrees(math.atan2((whole / kept).imag, (whole / kept).real))
    same = abs(whole - kept) <= 1e-6 * abs(kept)
    ratio = numbers.parameters.c2 / numbers.parameters.k2
    return Part(
        "G = G(1), line 58",
        Assertion(
            statement=(
                "because the output is a displacement, the first of the two transfer functions is "
                "the response to the pin"
            ),
            derived=same,
            evidence=(
                "the pin moves with a velocity too, so the response is $G_1 + sG_2$; at "
                f"{LIMIT_CYCLE_OMEGA} rad/s it is {100 * (abs(whole / kept) - 1):.2f} % larger than "
                f"$G_1$ and leads it by {lead:.2f} degrees"
            ),
            method="both transfer functions evaluated",
        ),
        Confirmation(
            "$G_1 + sG_2 = (1 + s\\,c_2/k_2)\\,G_1$",
            CloseNumbers(kept * (1 + 1j * LIMIT_CYCLE_OMEGA * ratio), whole),
        ),
    )
