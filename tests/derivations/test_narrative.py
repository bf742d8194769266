"""The derivation step by step, and the LaTeX document that `trimmer derive` writes."""

import pytest
import sympy

from derivations.latex import latex
from derivations.latex_document import latex_document
from derivations.linear_trimmer import derive_linear_trimmer
from derivations.step import Formula, NarrativeStep
from derivations.symbols import c2, k2, q1, t, u_dot


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
