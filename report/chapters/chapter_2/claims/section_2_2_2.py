"""Claims of section 2.2.2: frequency response and transfer function (equations 2.15 to 2.21, figure 2.3)."""

from __future__ import annotations

import cmath
import math

import mpmath
import numpy as np
import sympy

from derivations.dimensions import dimension_of
from derivations.laplace import transform_of_derivative
from derivations.symbols import DIMENSIONS, s, t, u
from report.claim import Claim, Confirmation, Impact, Mathematics, Part
from report.comparisons.assertion import Assertion
from report.comparisons.digits import CloseNumbers
from report.comparisons.expression import SameExpression, SameMatrix
from report.evidence import Evidence
from report.numbers.exact_response import response as exact_response
from report.numbers.linear_numbers import DRIVE_FREQUENCY, LinearNumbers
from trimmer import InputChannels, frequency_response, linear_model, pin_model, time_response

SOURCE = "derivations/laplace.py"
SETTLING_TIME = 0.6
SAMPLES_PER_PERIOD = 400


def claims(evidence: Evidence) -> tuple[Claim, ...]:
    """Return the claims in thesis order."""
    settled = _settled_gain(evidence.numbers)
    response = complex(frequency_response(evidence.numbers.displacement_only, 2 * math.pi * DRIVE_FREQUENCY))
    exact = complex(exact_response(evidence.numbers, 2 * math.pi * DRIVE_FREQUENCY))
    return (
        _magnitude(abs(response), settled, exact),
        _phase(response, settled, exact),
        _output_in_laplace_domain(evidence),
        _laplace_integral("eq-2.18", "Y", "y"),
        _laplace_integral("eq-2.19", "U", "u"),
        transformed_state_space(evidence, "eq-2.20"),
        _transfer_function(evidence),
        _block_diagram(evidence),
    )


def _settled_gain(numbers: LinearNumbers) -> complex:
    """Fit a sine to the last period of a simulation and return output over input as a complex number."""
    system = pin_model(numbers.parameters, channels=InputChannels.DISPLACEMENT_ONLY)
    omega = 2 * math.pi * DRIVE_FREQUENCY
    times = np.arange(0, SETTLING_TIME, 1 / (DRIVE_FREQUENCY * SAMPLES_PER_PERIOD))
    output = time_response(system, np.sin(omega * times), times).output[-SAMPLES_PER_PERIOD:]
    turning = np.exp(-1j * omega * times[-SAMPLES_PER_PERIOD:])
    return complex(2j * np.mean(output * turning))


def _magnitude(gain: float, settled: complex, exact: complex) -> Claim:
    form = Mathematics("\\left|\\frac{A_y}{A_u}\\right| = |G(j\\omega)|")
    return Claim(
        id="eq-2.15",
        parts=(
            Part(
                f"at 100 Hz: the gain is {gain:.5f}, a simulation gives {abs(settled):.5f}",
                CloseNumbers(gain, abs(settled), 1e-4),
                Confirmation("exact coefficients, 40 digits", CloseNumbers(abs(exact), gain)),
                printed_form=form,
                derived_form=form,
            ),
        ),
        explanation=(
            "The trimmer, simulated until its transients are gone, answers a sine with a sine whose "
            "amplitude is $|G(j\\omega)|$ times the input's. The ratio of amplitudes is positive, so the "
            "bars on the left are not needed."
        ),
        source="trimmer/time_domain.py",
    )


def _phase(response: complex, settled: complex, exact: complex) -> Claim:
    phase, simulated = cmath.phase(response), cmath.phase(settled)
    form = Mathematics("\\angle G(j\\omega) = \\phi(j\\omega) = \\phi")
    return Claim(
        id="eq-2.16",
        parts=(
            Part(
                f"at 100 Hz: the phase is {phase:.6f} rad, a simulation gives {simulated:.6f} rad",
                CloseNumbers(phase, simulated, 1e-3),
                Confirmation("exact coefficients, 40 digits", CloseNumbers(cmath.phase(exact), phase)),
                printed_form=form,
                derived_form=form,
            ),
        ),
        explanation=(
            "The same simulation shows the phase of $G(j\\omega)$ between input and output. The symbol "
            "$\\phi$ stands for a function of $\\omega$ and for its value at once; nothing depends on it."
        ),
        source="trimmer/time_domain.py",
    )


def transfer_formula(evidence: Evidence) -> sympy.Expr:
    """Return C (s I − A)⁻¹ B + D of the general system, the inverse written out."""
    system = evidence.general
    resolvent = (s * sympy.eye(system.a.rows) - system.a).inv()
    return (system.c * resolvent * system.b)[0] + system.d


def _output_in_laplace_domain(evidence: Evidence) -> Claim:
    comparison = SameExpression(
        transfer_formula(evidence) * evidence.general.input_transform, evidence.transformed.output
    )
    form = Mathematics("Y(s) = G(s)U(s)")
    return Claim(
        id="eq-2.17",
        parts=(Part("", comparison, printed_form=form, derived_form=form),),
        explanation=(
            "For a general system of two states the output's transform is $G(s)U(s)$. The trimmer has two "
            "inputs and so two such terms, $Y = G_1 U + G_2 V$ with the transform $V$ of the pin's velocity. "
            "Since $V = sU$, they become $Y = (G_1 + s G_2) U$."
        ),
        source=SOURCE,
    )


def _laplace_integral(claim_id: str, capital: str, small: str) -> Claim:
    integrand = u * sympy.exp(-s * t)
    transform_unit = DIMENSIONS[u] / DIMENSIONS[s]
    printed = rf"{capital}(s) = \int_0^\infty {small}(t)e^{{-st}}"
    return Claim(
        id=claim_id,
        parts=(
            Part(
                "",
                Assertion(
                    statement="what stands under the integral sign has the unit of the transform",
                    derived=dimension_of(integrand, DIMENSIONS) == transform_unit,
                    evidence=f"the transform is in {transform_unit}, the printed integrand alone is not",
                    method="dimension check",
                ),
                _with_its_differential(),
                printed_form=Mathematics(printed),
                derived_form=Mathematics(rf"{printed}\,dt"),
            ),
        ),
        explanation=(
            f"The printed integral lacks $dt$. With it, the transform has the unit of ${small}$ times a "
            "second, as equation 2.20 needs."
        ),
        consequence="None: the later equations use the transform with its $dt$.",
        impact=Impact.NOTATION,
        source=SOURCE,
    )


def _with_its_differential() -> Confirmation:
    """Hold the integral with dt, by quadrature, against SymPy's transform of a function."""
    function, place = sympy.exp(-2 * t) * sympy.sin(t), 3
    listed = sympy.laplace_transform(function, t, s, noconds=True).subs(s, place)
    integrand = sympy.lambdify(t, function * sympy.exp(-place * t), "mpmath")
    return Confirmation(
        "quadrature of the integral with $dt$, which gives SymPy's transform of $e^{-2t}\\sin t$",
        CloseNumbers(float(mpmath.quad(integrand, [0, mpmath.inf])), float(listed)),
    )


def transformed_state_space(evidence: Evidence, claim_id: str) -> Claim:
    """Return the claim of equation 2.20, which appendix D prints again."""
    system, solved = evidence.general, evidence.transformed
    right_side = system.a * solved.state + system.b * system.input_transform
    transform_of_rate = transform_of_derivative(sympy.Integer(0))
    output = (system.c * solved.state)[0] + system.d * system.input_transform
    first, second = Mathematics("sQ(s) = AQ(s) + BU(s)"), Mathematics("Y(s) = CQ(s) + DU(s)")
    return Claim(
        id=claim_id,
        parts=(
            Part(
                "transform of $\\dot q$ from rest", SameExpression(s * sympy.Symbol("Q"), transform_of_rate)
            ),
            Part(
                "state equation",
                SameMatrix(sympy.ImmutableMatrix(right_side), s * solved.state),
                printed_form=first,
                derived_form=first,
            ),
            Part(
                "output equation",
                SameExpression(output, solved.output),
                printed_form=second,
                derived_form=second,
            ),
        ),
        explanation=(
            "The transform of $\\dot q$ is $sQ - q(0)$, so the printed form holds for a system that starts "
            "at rest, which is what a transfer function assumes. Checked on a general system of two states."
        ),
        source=SOURCE,
    )


def _transfer_function(evidence: Evidence) -> Claim:
    form = Mathematics("G(s) = \\frac{Y(s)}{U(s)} = C(sI - A)^{-1}B + D")
    comparison = SameExpression(
        transfer_formula(evidence), evidence.transformed.output / evidence.general.input_transform
    )
    return Claim(
        id="eq-2.21",
        parts=(
            Part(
                "",
                comparison,
                Confirmation("Cramer's rule on the equations of motion", _trimmer_instance(evidence)),
                printed_form=form,
                derived_form=form,
            ),
        ),
        explanation=(
            "The matrix formula gives what solving the transformed equations one by one gives. With the two "
            "columns of $B$ it is a row of two transfer functions, of which the thesis keeps the first. The "
            "text sends the reader to appendix D for the rest of the derivation; it is in appendix A.1."
        ),
        source=SOURCE,
    )


def _trimmer_instance(evidence: Evidence) -> CloseNumbers:
    """Compare the matrix formula, in numbers, with the derived coefficients of the trimmer at one s."""
    point = 300 + 2000j
    numbers = evidence.numbers
    model = linear_model(numbers.parameters)[0, 0]
    formula = (model.C @ np.linalg.solve(point * np.eye(8) - model.A, model.B))[0, 0]
    numerator, denominator = (
        np.polyval([float(coefficient) for coefficient in polynomial], point)
        for polynomial in (numbers.numerator, numbers.denominator)
    )
    return CloseNumbers(complex(formula), complex(numerator / denominator))


def _block_diagram(evidence: Evidence) -> Claim:
    block, signal = sympy.symbols("G U")
    system = evidence.general
    named = {block: transfer_formula(evidence), signal: system.input_transform}
    form = Mathematics("Y = G\\,U")
    comparison = SameExpression((block * signal).subs(named), evidence.transformed.output)
    return Claim(
        id="fig-2.3",
        parts=(Part("", comparison, printed_form=form, derived_form=form),),
        explanation=(
            "The diagram stands for equation 2.17: one block that multiplies the input's transform by "
            "$G(s)$. It is redrawn from the text, which is all that was at hand."
        ),
        source=SOURCE,
    )
