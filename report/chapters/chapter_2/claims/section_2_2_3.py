"""Claims of section 2.2.3: eigenvalues, argument principle, closed loop (2.22 to 2.24, figure 2.4)."""

import sympy
from sympy.polys.matrices import DomainMatrix

from derivations.algebra import stability
from report.judging.claim import ClaimPart
from report.judging.comparisons.digits import PrintedDigits
from report.judging.parts import assertion, close, digits, equal, expression, lost_in_the_copy
from report.judging.record import Record, claim, text
from report.numbers.evidence import Evidence
from report.numbers.independent import examples
from report.numbers.linear_numbers import exact_values


@claim("eq-2.22")
def eigenvalue_problem(known: Evidence) -> Record:
    eigenvalue = sympy.Symbol("lambda")
    state_matrix = known.derivation.space.a.subs(exact_values(known.numbers.parameters))
    shifted = DomainMatrix.from_Matrix(state_matrix - eigenvalue * sympy.eye(state_matrix.rows))
    determinant = sympy.expand(shifted.domain.to_sympy(shifted.det()))
    dynamics = sympy.Poly([sympy.Rational(c) for c in known.numbers.denominator], eigenvalue).as_expr()
    form = r"\det(A - \lambda I) = 0"
    yield expression(r"$\det(A - \lambda I)$ of the trimmer", determinant, dynamics, form=form)
    yield text(r"""
        In exact arithmetic the printed determinant of the trimmer equals $\det(M\lambda^2 + C\lambda +
        K)/\det M$. Where that is zero there is a motion $q\,e^{\lambda t}$ without input.
    """)


@claim("txt-2.2.3-corollary")
def corollary(_: Evidence) -> Record:
    norm = stability.exponential_norm(stability.double_integrator())
    (time,) = norm.free_symbols
    growth, late = examples.growth_of_double_integrator(1000.0), float(norm.subs(time, 1000))
    yield assertion(
        "",
        r"""
        if every $\mathrm{Re}\,\lambda_k \le 0$, then $\lVert e^{At}\rVert \le K e^{-\gamma t}$ for some
        $\gamma \ge 0$
        """,
        sympy.limit(norm, time, sympy.oo) < sympy.oo,
        rf"""
        the double integrator has $\lambda_{{1,2}} = 0$ and $\lVert e^{{At}}\rVert = {sympy.latex(norm)}$,
        which no $K$ bounds. With $\mathrm{{Re}}\,\lambda_k < 0$ for every $k$ there is a bound with some
        $\gamma > 0$
        """,
        method="counterexample with its matrix exponential in closed form",
        second=close("SciPy's matrix exponential after 1000 s", growth, late),
    )
    yield text(r"""
        Both signs have to be strict; the sentence before the corollary asks for negative real parts. With
        eigenvalues on the imaginary axis the solution may grow, as that of the double integrator does, and
        $\gamma = 0$ would not be decay.

        None for the trimmer: all its eigenvalues have negative real parts, so the strict form applies.
    """)


@claim("eq-2.23")
def argument_principle(_: Evidence) -> Record:
    printed = stability.NUMBER_OF_ZEROS - stability.NUMBER_OF_POLES
    yield expression("", printed, stability.encirclements_of_origin(), sympy.Symbol("N"))
    yield text("""
        The residues of the logarithmic derivative add up to zeros less poles. With the contour upwards along
        the imaginary axis, as in the text, $N$ counts clockwise turns. The text calls encirclements points;
        the turns about the origin are meant.
    """)


def closed_loop_part() -> ClaimPart:
    """Return the part on the closed loop, which equation 2.24 and figure 2.4 share."""
    linear, nonlinear = stability.LINEAR_PART, stability.NONLINEAR_PART
    in_feedback = stability.closed_loop(feedback=nonlinear, forward=linear)
    printed = linear / (1 + linear * nonlinear)
    form = r"M(s) = \frac{G(s)}{1 + G(s)N(s)}"
    return expression("$N$ in the feedback path", printed, in_feedback, form=form)


@claim("eq-2.24")
def closed_loop_fraction(_: Evidence) -> Record:
    yield closed_loop_part()
    yield text("""
        Solving the loop gives the printed fraction when $N$ sits in the feedback path. In figure 2.5 it sits
        before $G$, and the numerator becomes $GN$. The poles, and so the condition $1 + GN = 0$, stay the
        same.
    """)


@claim("fig-2.4")
def closed_loop_diagram(known: Evidence) -> Record:
    yield closed_loop_part()
    yield text("The text reads the diagram as [equation 2.24](#eq-2.24), and so it is solved.")


@claim("txt-2.2.3-nyquist-statement")
def nyquist_statement(_: Evidence) -> Record:
    critical, example = examples.critical_point(), examples.unstable_plant()
    yield digits(
        "real part of the critical point",
        "1",
        critical,
        second=equal("a loop with one unstable pole", example.points_that_agree(), [critical]),
        copy_fault=lost_in_the_copy("the minus sign before the 1", PrintedDigits("-1", critical)),
    )
    stability = "stable" if example.stable_in_loop else "unstable"
    yield text(f"""
        The critical point solves $1 + GN = 0$: it is $(-1, j0)$, as the observation before the statement and
        all later sections have it. An example decides: $G = 2/(s - 1)$ with unit feedback has one open-loop
        pole in the right half plane and is {stability} in closed loop. Its locus turns {example.turns[-1]}
        time counter-clockwise about $-1$, as the criterion asks, and {example.turns[1]} times about $+1$.
    """)
