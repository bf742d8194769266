"""The derivation step by step, worked by hand where it is, and the document that `trimmer derive` writes."""

from dataclasses import replace

import pytest
import sympy

from derivations import by_hand
from derivations.algebra.identity import UnprovenError
from derivations.latex import latex
from derivations.latex_document import latex_document
from derivations.linear_trimmer import derive_linear_trimmer
from derivations.step import Formula, NarrativeStep
from derivations.symbols import c2, k2, q1, q2, t, u_dot
from derivations.transfer_steps import output_numerator, transfer_function_step


@pytest.fixture(scope="module")
def derivation():
    return derive_linear_trimmer()


@pytest.mark.parametrize(
    ("expression", "expected"),
    [
        (q1.diff(t), r"\dot{q}_{1}"),
        (q1.diff(t, 2), r"\ddot{q}_{1}"),
        (u_dot, r"\dot{u}"),
        (q1, "q_{1}"),
        (q1**2, "q_{1}^{2}"),
        (q1.diff(t) ** 2, r"\dot{q}_{1}^{2}"),
        (sympy.Add(1, k2, evaluate=False), "1 + k_{2}"),
    ],
)
def test_latex_uses_dots_and_keeps_order(expression, expected):
    assert latex(expression) == expected


def test_document_has_balanced_braces_and_all_coefficients(derivation):
    element = NarrativeStep("df-one", "One", "Text.", (Formula("N_{1} = 1", "2.41"),))
    text = latex_document(derivation, (element,))
    assert text.startswith(r"\documentclass")
    assert text.rstrip().endswith(r"\end{document}")
    assert text.count("{") == text.count("}")
    assert text.count(r"\begin{dmath") == text.count(r"\end{dmath")
    for power in range(8):
        assert f"a_{{{power}}} = " in text
    assert latex(c2) in text
    marks = ("\\part{The linear trimmer}", "\\section{One}", "\\part{The loop}", "Nomenclature")
    places = [text.index(mark) for mark in marks]
    assert places == sorted(places)
    assert text.index("So the unknowns are") < text.index("F(\\ell, \\omega) = N(\\ell)")
    assert "number={2.41}" in text


def test_a_wrong_line_is_not_shown(derivation):
    wrong = replace(derivation, lagrangian=derivation.lagrangian + k2 * q2**2)
    with pytest.raises(UnprovenError, match="force of the springs"):
        by_hand.worked_equation(wrong)
    other = replace(derivation, rayleigh_function=2 * derivation.rayleigh_function)
    with pytest.raises(UnprovenError, match="damper"):
        by_hand.worked_equation(other)


def test_the_velocity_acts_as_the_displacement_does(derivation):
    matrices = derivation.matrices
    assert sympy.simplify(matrices.velocity_force / c2 - matrices.displacement_force / k2).is_zero_matrix
    assert r"1 + \frac{c_2}{k_2} s" in transfer_function_step(derivation).formulas[-1].latex
    assert len(output_numerator(derivation)) == 7
