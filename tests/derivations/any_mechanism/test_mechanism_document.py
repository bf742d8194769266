"""How the derivation of a mechanism is told, and the LaTeX document of it."""

import pypandoc
import pytest
import sympy

from derivations.any_mechanism.checks import mechanism_checks
from derivations.any_mechanism.derivation import derive_mechanism
from derivations.any_mechanism.narrative import mechanism_narrative
from derivations.dimension_checks import require_consistent
from derivations.dimensions import DimensionError
from derivations.latex import escaped, latex_prose, latex_text
from derivations.latex_document import ValuedQuantity, mechanism_document
from derivations.mechanism import Mechanism
from derivations.parts import ContactLaw, Damper, Spring
from derivations.symbols import (
    KILOGRAM,
    METRE,
    METRE_PER_SECOND,
    NEWTON,
    NEWTON_PER_METRE,
    NEWTON_SECOND_PER_METRE,
    ONE,
    Quantity,
)
from tests.derivations.symbolic_parts import GROUND, body, force, friction, pin, play, positive, stop

UNITS = {
    **{"m": KILOGRAM, "q": METRE, "u": METRE, "k": NEWTON_PER_METRE, "c": NEWTON_SECOND_PER_METRE},
    **{"g": METRE, "s": METRE, "z": METRE, "T": NEWTON, "F": NEWTON, "H": NEWTON, "f": NEWTON, "P": NEWTON},
    **{"d": NEWTON_SECOND_PER_METRE, "v": METRE_PER_SECOND, "sigma": ONE},
}


@pytest.fixture(scope="module")
def derivation():
    first, second = body(1), body(2)
    driven = pin("u", first)
    return derive_mechanism(
        Mechanism(
            (first, second),
            (Spring(positive("k"), GROUND, first),),
            (Damper(positive("c"), GROUND, first), Damper(positive("c_2"), GROUND, second)),
            (driven,),
            (play("a", second, driven), stop("b", first, second, ContactLaw.TRUNCATED)),
            (friction("a", first, second),),
            (force("P", second),),
        )
    )


@pytest.fixture(scope="module")
def quantities(derivation):
    """What occurs, each with the unit that its letter has."""
    held = {value for kind in vars(derivation.mechanism).values() for p in kind for value in vars(p).values()}
    symbols = {each for each in held if isinstance(each, sympy.Expr) and each != 0}
    return tuple(
        Quantity(each, f"meaning of {each}", UNITS[str(each).split("_")[0].split("(")[0]]) for each in symbols
    )


def test_the_story_has_all_steps_and_each_law(derivation):
    steps = mechanism_narrative(derivation)
    assert [step.id for step in steps] == [
        *("parts", "energies", "virtual-work", "motion", "matrices", "closed-contact", "state-space"),
        *("contact-T_a", "contact-T_b", "friction-f_a", "checks"),
    ]
    assert all(step.text and step.formulas for step in steps)


def test_a_linear_mechanism_has_no_step_of_contact():
    block = body(1)
    steps = mechanism_narrative(
        derive_mechanism(Mechanism((block,), (Spring(positive("k"), GROUND, block),), ()))
    )
    assert [step.id for step in steps] == ["parts", "energies", "motion", "matrices", "state-space", "checks"]


def test_every_expression_is_consistent_in_its_dimensions(derivation, quantities):
    checks = mechanism_checks(derivation, quantities)
    assert len(checks) > 20
    require_consistent(checks)


@pytest.mark.parametrize("symbol", ["k_a", "c_b", "F_a", "d_a", "g_a", "T_a(t)", "m_2"])
def test_a_symbol_of_another_dimension_is_noticed(derivation, quantities, symbol):
    wrong = tuple(Quantity(q.symbol, q.meaning, ONE) if str(q.symbol) == symbol else q for q in quantities)
    with pytest.raises(DimensionError):
        require_consistent(mechanism_checks(derivation, wrong))


def test_document_is_balanced_and_lists_all_symbols(derivation, quantities):
    valued = tuple(ValuedQuantity(each, 1.5e-5) for each in quantities)
    text = mechanism_document(derivation, "A & B {50 %}", valued)
    assert text.startswith(r"\documentclass")
    assert text.rstrip().endswith(r"\end{document}")
    assert r"\title{A \& B \{50 \%\}: derivation}" in text
    unescaped = text.replace(r"\{", "").replace(r"\}", "")
    assert unescaped.count("{") == unescaped.count("}")
    for environment in ("dmath*", "longtable", "cases", "matrix"):
        assert text.count(rf"\begin{{{environment}}}") == text.count(rf"\end{{{environment}}}") > 0
    for each in quantities:
        assert f"& meaning of {each.symbol}".replace("_", r"\_") in text
    assert r"$1.5 \cdot 10^{-5}$" in text


def test_every_formula_is_mathematics_that_pandoc_understands(derivation):
    """An independent reader of TeX; what it does not understand it leaves as TeX and warns."""
    formulas = [formula.latex for step in mechanism_narrative(derivation) for formula in step.formulas]
    markdown = "\n\n".join(f"$${formula}$$" for formula in formulas)
    mathml = pypandoc.convert_text(markdown, "html", "markdown", extra_args=["--mathml"])
    assert mathml.count("<math") == len(formulas)
    assert mathml.count('class="math') == 0


def test_prose_of_a_step_becomes_latex():
    name = r"a_b `c` $d$ \e 5%"
    shown = latex_text(name)
    assert latex_prose(escaped(name)) == shown
    assert latex_prose(f"The body {escaped(name)} ($q_1\\,\\delta$) and `x`.") == (
        f"The body {shown} ($q_1\\,\\delta$) and \\texttt{{x}}."
    )
