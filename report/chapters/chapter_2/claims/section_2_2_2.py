"""Claims of section 2.2.2: frequency response and transfer function (equations 2.15 to 2.21, figure 2.3)."""

import cmath

import numpy as np
import sympy

from derivations.algebra.laplace import transform_of_derivative
from derivations.dimensions import dimension_of
from derivations.symbols import DIMENSIONS, s, t, u
from report.chapters.second_ways import EXACTLY
from report.judging.claim import ClaimPart
from report.judging.comparisons.digits import CloseNumbers
from report.judging.parts import assertion, close, expression, matrix, part
from report.judging.record import Record, claim, text
from report.judging.verdict import Certainty
from report.numbers.evidence import Evidence
from report.numbers.independent.exact_response import response as exact_response
from report.numbers.independent.linear_trimmer import matrix_formula, settled_gain
from report.numbers.independent.symbolic import laplace_integral
from report.numbers.thesis import DRIVE_FREQUENCY, DRIVE_OMEGA
from trimmer import response_at

STATE_ITEM = "sQ = AQ + BU, state equation in the Laplace domain"
OUTPUT_ITEM = "Y = CQ + DU, output equation in the Laplace domain"
"""Printed things that appendix D prints again."""


def responses(known: Evidence) -> tuple[complex, complex, complex]:
    """Return G at the drive from the model, from a simulation, and from the exact coefficients."""
    exact = complex(exact_response(known.numbers, DRIVE_OMEGA))
    response = complex(response_at(known.numbers.displacement_only, DRIVE_OMEGA))
    return response, settled_gain(known.numbers.parameters), exact


@claim("eq-2.15")
def magnitude(known: Evidence) -> Record:
    gain, settled, exact = (abs(each) for each in responses(known))
    yield part(
        f"at {DRIVE_FREQUENCY:.0f} Hz: the gain is {gain:.5f}, a simulation gives {settled:.5f}",
        CloseNumbers(gain, settled, 1e-4),
        second=close(EXACTLY, exact, gain),
        form=r"\left|\frac{A_y}{A_u}\right| = |G(j\omega)|",
    )
    yield text(r"""
        The trimmer, simulated until its transients are gone, answers a sine with a sine whose amplitude is
        $|G(j\omega)|$ times the input's.
    """)


@claim("eq-2.16")
def phase(known: Evidence) -> Record:
    angle, settled, exact = (cmath.phase(each) for each in responses(known))
    yield part(
        f"at {DRIVE_FREQUENCY:.0f} Hz: the phase is {angle:.6f} rad, a simulation gives {settled:.6f} rad",
        CloseNumbers(angle, settled, 1e-3),
        second=close(EXACTLY, exact, angle),
        form=r"\angle G(j\omega) = \phi(j\omega) = \phi",
    )
    yield text(r"""
        The simulation of [equation 2.15](#eq-2.15) shows the phase of $G(j\omega)$ between input and output.
    """)


def transfer_formula(known: Evidence) -> sympy.Expr:
    """Return C (s I − A)⁻¹ B + D of the general system, the inverse written out."""
    system = known.general
    resolvent = (s * sympy.eye(system.a.rows) - system.a).inv()
    return (system.c * resolvent * system.b)[0] + system.d


@claim("eq-2.17")
def output_in_laplace_domain(known: Evidence) -> Record:
    printed = transfer_formula(known) * known.general.input_transform
    yield expression("", printed, known.transformed.output, form="Y(s) = G(s)U(s)")
    yield text("""
        For a general system of two states the output's transform is $G(s)U(s)$. The trimmer has two inputs
        and so two such terms, $Y = G_1 U + G_2 V$ with the transform $V$ of the pin's velocity. Since $V =
        sU$, they become $Y = (G_1 + s G_2) U$.
    """)


def transform_integral(capital: str, small: str, prose: str) -> Record:
    """Yield what the claims on the transforms of output and input consist of."""
    unit = DIMENSIONS[u] / DIMENSIONS[s]
    printed = rf"{capital}(s) = \int_0^\infty {small}(t)e^{{-st}}"
    function, place = sympy.exp(-2 * t) * sympy.sin(t), 3
    listed = sympy.laplace_transform(function, t, s, noconds=True).subs(s, place)
    means = r"quadrature of the integral with $dt$, which gives SymPy's transform of $e^{-2t}\sin t$"
    yield assertion(
        "",
        "what stands under the integral sign has the unit of the transform",
        dimension_of(u * sympy.exp(-s * t), DIMENSIONS) == unit,
        f"the transform is in {unit}, the printed integrand alone is not",
        method="dimension check",
        certainty=Certainty.PROVEN,
        second=close(means, laplace_integral(function, place), float(listed)),
        printed_form=printed,
        derived_form=rf"{printed}\,dt",
    )
    yield text(prose)


@claim("eq-2.18")
def transform_of_output(_: Evidence) -> Record:
    return transform_integral(
        "Y",
        "y",
        """
        The printed integral lacks $dt$. With it, the transform has the unit of $y$ times a second, as
        equation 2.20 needs. Equation 2.19 lacks it too, and every other integral in the copy has its
        differential, so this is hardly a fault of the copy.

        None: the later equations use the transform with its $dt$.
        """,
    )


@claim("eq-2.19")
def transform_of_input(_: Evidence) -> Record:
    return transform_integral(
        "U",
        "u",
        """
        As in [equation 2.18](#eq-2.18), the integral lacks $dt$.

        None: the later equations use the transform with its $dt$.
        """,
    )


def transformed_state_space(known: Evidence) -> tuple[ClaimPart, ClaimPart, ClaimPart]:
    """Return the parts on the transformed state space, which section 2.2.2 and appendix D print alike."""
    system, solved = known.general, known.transformed
    right_side = sympy.ImmutableMatrix(system.a * solved.state + system.b * system.input_transform)
    rate, transform_of_rate = s * sympy.Symbol("Q"), transform_of_derivative(sympy.Integer(0))
    output = (system.c * solved.state)[0] + system.d * system.input_transform
    states, reads = "sQ(s) = AQ(s) + BU(s)", "Y(s) = CQ(s) + DU(s)"
    return (
        expression(
            r"transform of $\dot q$ from rest", rate, transform_of_rate, form="sQ(s)", item=STATE_ITEM
        ),
        matrix("state equation", right_side, s * solved.state, form=states, item=STATE_ITEM),
        expression("output equation", output, solved.output, form=reads, item=OUTPUT_ITEM),
    )


@claim("eq-2.20")
def state_space_in_laplace_domain(known: Evidence) -> Record:
    yield from transformed_state_space(known)
    yield text(r"""
        The transform of $\dot q$ is $sQ - q(0)$, so the printed form holds for a system that starts at rest,
        which is what a transfer function assumes. It was checked on a general system of two states.
    """)


@claim("eq-2.21")
def transfer_function(known: Evidence) -> Record:
    point, numbers = 300 + 2000j, known.numbers
    numerator, denominator = (
        np.polyval([float(coefficient) for coefficient in polynomial], point)
        for polynomial in (numbers.numerator, numbers.denominator)
    )
    by_rule, formula = complex(numerator / denominator), matrix_formula(numbers.parameters, point)
    yield expression(
        "",
        transfer_formula(known),
        known.transformed.output / known.general.input_transform,
        second=close("Cramer's rule on the equations of motion", formula, by_rule),
        form=r"G(s) = \frac{Y(s)}{U(s)} = C(sI - A)^{-1}B + D",
    )
    yield text("""
        The matrix formula gives what solving the transformed equations one by one gives. With the two columns
        of $B$ it is a row of two transfer functions, of which the thesis keeps the first. The text sends the
        reader to appendix D for the full derivation; its steps stand in appendix A.1.
    """)


@claim("fig-2.3")
def block_diagram(known: Evidence) -> Record:
    block, signal = sympy.symbols("G U")
    named = {block: transfer_formula(known), signal: known.general.input_transform}
    yield expression("", (block * signal).subs(named), known.transformed.output, form=r"Y = G\,U")
    yield text("""
        The diagram stands for [equation 2.17](#eq-2.17): one block that multiplies the input's transform by
        $G(s)$.
    """)
