import json
import re

import pytest
import sympy
import typst
from hypothesis import given, settings
from hypothesis import strategies as st

from report.pages.formulas.latex import Role, atoms, width
from report.pages.formulas.line_breaking import fit
from tests.quick import examples
from tests.report.pages.conversion import converted
from tests.report.rendering.sample_formulas import (
    CASES,
    DOTS,
    INTEGRAL,
    KINETIC_ENERGY,
    NESTED,
    long_coefficient,
)

FORMULAS = (CASES, DOTS, INTEGRAL, KINETIC_ENERGY, NESTED, long_coefficient(), r"1.2345678 \times 10^{-5}")
LINE = 30.0
SYMBOLS = sympy.symbols("m1:4 k1:4 omega_1:3 x y")


def bare(latex: str) -> str:
    """Return LaTeX without what line breaking may add or take away: alignment, braces, sizes, spaces."""
    return re.sub(r"\\begin\{aligned\}|\\end\{aligned\}|\\quad|\\left|\\right|\\\\|[{}&\s]", "", latex)


def lines_of(latex: str) -> list[str]:
    inside = latex.removeprefix(r"\begin{aligned}").removesuffix(r"\end{aligned}")
    return [line.replace("&", "").strip() for line in inside.split(r"\\")]


@st.composite
def polynomials(draw: st.DrawFn) -> sympy.Expr:
    """Sums of products, some of them with a bracketed sum as a factor."""
    monomials = st.lists(st.sampled_from(SYMBOLS), min_size=1, max_size=4).map(lambda each: sympy.Mul(*each))
    sums = st.lists(monomials, min_size=1, max_size=12).map(lambda terms: sympy.Add(*terms))
    return draw(sums) * draw(st.sampled_from(SYMBOLS)) + draw(sums) - draw(sums) ** 2


def test_estimated_widths_are_close_to_those_typst_measures() -> None:
    source = '#show math.equation: set text(font: "New Computer Modern Math")\n#set text(10pt)\n'
    for formula in FORMULAS:
        equation = converted(f"$${formula}$$", "typst").strip()
        source += f"#context [#metadata(measure([{equation}]).width.pt() / 10) <width>]\n"
    measured = json.loads(typst.query({"main": source.encode()}, "<width>", field="value"))
    assert [width(formula) for formula in FORMULAS] == pytest.approx(measured, rel=0.15)


def test_relations_and_signs_are_distinguished_from_the_rest() -> None:
    roles = [atom.role for atom in atoms(r"a_{1} = - b \leq \frac{1 + c}{2}")]
    ordinary = Role.ORDINARY
    assert roles == [ordinary, Role.RELATION, Role.SIGN, ordinary, Role.RELATION, ordinary]


@pytest.mark.parametrize("formula", FORMULAS)
def test_atoms_hold_all_of_a_formula(formula: str) -> None:
    assert bare("".join(atom.latex for atom in atoms(formula))) == bare(formula)


@pytest.mark.parametrize("formula", [CASES, NESTED, "x = 1"])
def test_what_fits_is_left_as_it_is(formula: str) -> None:
    assert fit(formula, LINE) == formula


def test_a_long_sum_is_broken_before_its_signs_and_words_keep_their_spaces() -> None:
    lines = lines_of(fit(long_coefficient(), LINE))
    assert len(lines) > 3
    assert lines[0].startswith("a_{4}  =")
    assert all(line.startswith(r"\quad +") for line in lines[1:])
    assert r"\text{for all } x" in fit(rf"{long_coefficient()} + \text{{for all }} x", LINE)


def test_a_fraction_is_not_broken() -> None:
    formula = rf"x = \frac{{{long_coefficient().partition('=')[2]}}}{{2}}"
    assert r"\\" not in fit(formula, LINE)


def test_a_bracket_that_fits_only_without_its_sign_is_broken() -> None:
    """Found among random polynomials: with the minus before it and the indent it was wider than the line."""
    symbols = ["m_{1}", "m_{2}", "m_{3}"]
    products = ["m_{1}^{2}", "m_{1} m_{2} m_{3}", "m_{1} m_{2}", "m_{1} m_{3}"]
    inside = " + ".join(["k_{1} m_{1}", "k_{1}", *products, *symbols])
    formula = rf"p = m_{{1}}^{{2}} + m_{{1}} - \left({inside}\right)^{{2}}"
    assert max(width(line) for line in lines_of(fit(formula, LINE))) <= LINE


def test_only_the_wider_of_two_brackets_is_opened() -> None:
    wide = " + ".join(f"m_{{{number}}} k_{{{number}}}" for number in range(12))
    lines = lines_of(fit(rf"p = \left(x + y\right) \left({wide}\right)", LINE))
    assert len(lines) == 2
    assert r"\left(x+y \right)" in lines[0]


@settings(max_examples=examples(20, 60), deadline=None)
@given(polynomials())
def test_breaking_loses_nothing_and_every_line_fits(expression: sympy.Expr) -> None:
    formula = f"p = {sympy.latex(expression)}"
    broken = fit(formula, LINE)
    assert bare(broken) == bare(formula)
    assert fit(broken, LINE) == broken
    if r"\frac" not in formula:
        assert max(width(line) for line in lines_of(broken)) <= LINE
