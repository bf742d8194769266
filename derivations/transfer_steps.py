"""The transfer function of the trimmer step by step: how it is solved for, and all its coefficients."""

import sympy

from derivations.latex import latex
from derivations.linear_trimmer import LinearTrimmer
from derivations.step import Formula, NarrativeStep
from derivations.transfer_function import numerator_of_force, transfer_functions

CUTTER, GUARD = 1, 3


def transfer_function_step(derivation: LinearTrimmer) -> NarrativeStep:
    """Return the step from the matrices to the transfer functions of both inputs."""
    size = len(derivation.mechanism.bodies)
    return NarrativeStep(
        "transfer-function",
        "Transfer function",
        "With $\\dot q = s q$ the equations of motion become algebraic. Cramer's rule solves them: the "
        "column of $q_i$ in the dynamic stiffness is replaced by the force of the pin, and the determinants "
        "are divided. The determinants are worked out in a ring of polynomials, in which no quotient has to "
        "be simplified.",
        (
            Formula(r"\left(M s^2 + C s + K\right) Q = f_u U"),
            Formula(
                r"\frac{Q_i}{U} = \frac{\det\left(M s^2 + C s + K\right)_{\text{column } i \,\to\, f_u}}"
                r"{\det\left(M s^2 + C s + K\right)}"
            ),
            Formula(
                rf"G_1(s) = \frac{{Q_2 - Q_4}}{{U}} = \frac{{b_6 s^6 + b_5 s^5 + \dots + b_0}}"
                rf"{{s^{2 * size} + a_7 s^7 + \dots + a_0}}",
                "2.21",
                "Both polynomials are divided by $\\det M = m_1 m_2 m_3 m_4$, so that $s^8$ has the "
                "coefficient 1.",
            ),
            Formula(
                r"G(s) = \left(1 + \frac{c_2}{k_2} s\right) G_1(s)",
                words="The pin's velocity acts through $c_2$ as its displacement acts through $k_2$, "
                "$f_v/c_2 = f_u/k_2$, and $\\dot u$ is $s U$. So both inputs together differ from the first "
                "alone by one factor.",
            ),
        ),
        code=(transfer_functions,),
    )


def coefficients_step(derivation: LinearTrimmer) -> NarrativeStep:
    """Return the step with every coefficient of the transfer function from the pin to q2 − q4."""
    return NarrativeStep(
        "coefficients",
        "All coefficients of the transfer function",
        "Each coefficient is a sum of products of as many parameters as its unit asks for, over the product "
        "of the masses. In those of the denominator every term is positive.",
        (*_named("b", output_numerator(derivation)), *_named("a", list(derivation.transfer.denominator))),
        code=(transfer_functions, output_numerator),
        long=True,
    )


def output_numerator(derivation: LinearTrimmer) -> list[sympy.Expr]:
    """Return the coefficients of the numerator for q2 − q4 from the pin's displacement, highest first."""
    rows = derivation.transfer.from_displacement
    return [sympy.factor(cutter - guard) for cutter, guard in zip(rows[CUTTER], rows[GUARD], strict=True)]


def rubbing_numerator(derivation: LinearTrimmer) -> list[sympy.Expr]:
    """Return the coefficients for q2 − q4 from a force on the cutter and its reaction on the guard."""
    pair = [{CUTTER: 1, GUARD: -1}.get(body, 0) for body in range(len(derivation.mechanism.bodies))]
    return list(numerator_of_force(derivation.matrices, pair))


def _named(name: str, coefficients: list[sympy.Expr]) -> tuple[Formula, ...]:
    """Return the coefficients by their powers, without the leading one of the denominator."""
    return tuple(
        Formula(f"{name}_{{{power}}} = {latex(coefficient)}")
        for power, coefficient in zip(range(len(coefficients) - 1, -1, -1), coefficients, strict=True)
        if coefficient != 1
    )
