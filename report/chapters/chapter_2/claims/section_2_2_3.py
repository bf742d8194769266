"""Claims of section 2.2.3: eigenvalues, argument principle, closed loop (2.22 to 2.24, figure 2.4)."""

from __future__ import annotations

import control
import numpy as np
import sympy
from scipy.linalg import expm
from sympy.polys.matrices import DomainMatrix

from derivations.stability import (
    LINEAR_PART,
    NONLINEAR_PART,
    NUMBER_OF_POLES,
    NUMBER_OF_ZEROS,
    closed_loop,
    double_integrator,
    encirclements_of_origin,
    exponential_norm,
)
from report.claim import Claim, Confirmation, Impact, Mathematics, Part, Slip, Verdict
from report.comparisons.assertion import Assertion
from report.comparisons.digits import CloseNumbers, PrintedDigits
from report.comparisons.expression import SameExpression
from report.evidence import Evidence
from report.numbers.linear_numbers import exact_values
from trimmer import encirclements

SOURCE = "derivations/stability.py"


def claims(evidence: Evidence) -> tuple[Claim, ...]:
    """Return the claims in thesis order."""
    return (
        _eigenvalue_problem(evidence),
        _corollary(),
        _argument_principle(),
        _closed_loop("eq-2.24"),
        _nyquist_statement(),
        _closed_loop("fig-2.4"),
    )


def _eigenvalue_problem(evidence: Evidence) -> Claim:
    eigenvalue = sympy.Symbol("lambda")
    values = exact_values(evidence.numbers.parameters)
    state_matrix = evidence.derivation.space.a.subs(values)
    shifted = DomainMatrix.from_Matrix(state_matrix - eigenvalue * sympy.eye(state_matrix.rows))
    determinant = shifted.domain.to_sympy(shifted.det())
    dynamics = sympy.Poly([sympy.Rational(c) for c in evidence.numbers.denominator], eigenvalue)
    form = Mathematics("\\det(A - \\lambda I) = 0")
    return Claim(
        id="eq-2.22",
        parts=(
            Part(
                "$\\det(A - \\lambda I)$ of the trimmer",
                SameExpression(sympy.expand(determinant), dynamics.as_expr()),
                printed_form=form,
                derived_form=form,
            ),
        ),
        explanation=(
            "For the trimmer the printed determinant equals $\\det(M\\lambda^2 + C\\lambda + K)/\\det M$, "
            "the condition for a motion $q\\,e^{\\lambda t}$ without input, in exact arithmetic."
        ),
        source="derivations/transfer_function.py",
    )


def _corollary() -> Claim:
    norm = exponential_norm(double_integrator())
    time = next(iter(norm.free_symbols))
    bounded = sympy.limit(norm, time, sympy.oo) < sympy.oo
    return Claim(
        id="txt-2.2.3-corollary",
        parts=(
            Part(
                "",
                Assertion(
                    statement=(
                        "if every $\\mathrm{Re}\\,\\lambda_k \\le 0$, then $\\lVert e^{At}\\rVert \\le K "
                        "e^{-\\gamma t}$ for some $\\gamma \\ge 0$"
                    ),
                    derived=bool(bounded),
                    evidence=(
                        "the double integrator has $\\lambda_{1,2} = 0$ and $\\lVert e^{At}\\rVert = "
                        f"{sympy.latex(norm)}$, which no $K$ bounds. True is: $\\mathrm{{Re}}\\,\\lambda_k < "
                        "0$ for every $k$ if and only if such a bound holds with some $\\gamma > 0$"
                    ),
                    method="counterexample with its matrix exponential in closed form",
                ),
                Confirmation(
                    "SciPy's matrix exponential after 1000 s",
                    CloseNumbers(
                        float(np.linalg.norm(expm(1000.0 * np.array([[0.0, 1.0], [0.0, 0.0]])))),
                        float(norm.subs(time, 1000)),
                    ),
                ),
            ),
        ),
        explanation=(
            "The condition has to be strict. With eigenvalues on the imaginary axis the solution may grow, "
            "as the double integrator does, and $\\gamma \\ge 0$ would allow no decay at all."
        ),
        consequence=(
            "None for the trimmer: all its eigenvalues have negative real parts, so the strict form applies "
            "and it is stable."
        ),
        impact=Impact.LOCAL,
        source=SOURCE,
    )


def _argument_principle() -> Claim:
    printed = NUMBER_OF_ZEROS - NUMBER_OF_POLES
    return Claim(
        id="eq-2.23",
        parts=(Part("", SameExpression(printed, encirclements_of_origin(), left=sympy.Symbol("N"))),),
        explanation=(
            "The residues of the logarithmic derivative add up to zeros less poles. With the contour upwards "
            "along the imaginary axis, as in the text, $N$ counts clockwise turns. The sentence that calls "
            "encirclements points, poles or zeros is muddled; the equation is right."
        ),
        source=SOURCE,
    )


def _closed_loop(claim_id: str) -> Claim:
    printed = LINEAR_PART / (1 + LINEAR_PART * NONLINEAR_PART)
    in_feedback = closed_loop(feedback=NONLINEAR_PART, forward=LINEAR_PART)
    return Claim(
        id=claim_id,
        parts=(
            Part("$N$ in the feedback path", SameExpression(printed, in_feedback, left=sympy.Symbol("M"))),
        ),
        explanation=(
            "Solving the loop gives the printed fraction when $N$ sits in the feedback path. In figure 2.5 "
            "it sits before $G$; then the numerator is $GN$. The poles, and so the condition $1 + GN = 0$, "
            "are the same."
        ),
        source=SOURCE,
    )


def _nyquist_statement() -> Claim:
    loop = sympy.Symbol("L")
    critical_point = int(sympy.solve(1 + loop, loop)[0])
    plant = control.tf([2], [1, -1])
    turns = {point: -encirclements(plant, point) for point in (-1, 1)}
    unstable_poles = sum(pole.real > 0 for pole in plant.poles())
    stable = all(pole.real < 0 for pole in control.feedback(plant, 1).poles())
    (right_point,) = [point for point, count in turns.items() if (count == unstable_poles) == stable]
    return Claim(
        id="txt-2.2.3-nyquist-statement",
        parts=(
            Part(
                "real part of the critical point",
                PrintedDigits("1", critical_point),
                Confirmation("a loop with one unstable pole", CloseNumbers(right_point, critical_point)),
                Slip("the minus sign is lost", -critical_point, Verdict.ERRATUM),
            ),
        ),
        explanation=(
            "The critical point solves $1 + GN = 0$: it is $(-1, j0)$, as the sentence before says. Example: "
            "$G = 2/(s - 1)$ with unit feedback has one open-loop pole in the right half plane and is "
            f"{'stable' if stable else 'unstable'} in closed loop. Its locus turns {turns[-1]} time "
            f"counter-clockwise about $-1$, as the criterion asks, and {turns[1]} times about $+1$."
        ),
        consequence="None: section 5.1.2 and all later sections use $(-1, j0)$.",
        impact=Impact.LOCAL,
        source="trimmer/nyquist.py",
    )
