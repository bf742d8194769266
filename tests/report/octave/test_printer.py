"""Code from expressions: variables, element-wise operators, line breaks, shared subexpressions."""

import re

import pytest
import sympy
from hypothesis import given
from hypothesis import strategies as st

from report.octave.printer import CONTINUATION, LINE_LENGTH, CodePrinter, UnnamedSymbolError, broken, comment

x, y, z = sympy.symbols("x_1 y z")
PRINTER = CodePrinter({x: "first", y: "second"})


def test_symbols_become_variables_and_operators_element_wise():
    assert PRINTER.expression(x * y / (1 + y**2)) == "first.*second./(second.^2 + 1)"


def test_a_symbol_without_a_variable_is_named():
    with pytest.raises(UnnamedSymbolError, match=r"no variable stands for z in"):
        PRINTER.expression(x + z)


def test_cases_are_printed_in_one_line():
    cases = sympy.Piecewise((x, y < 1), (x**2, y < 2), (x**3, True))
    assert PRINTER.expression(cases) == (
        "((second < 1).*(first) + (~(second < 1)).*( (second < 2).*(first.^2) + (~(second < 2)).*(first.^3)))"
    )


def test_a_matrix_has_one_line_for_each_row():
    matrix = sympy.Matrix([[x, -y], [0, x - y]])
    assert PRINTER.matrix("M", matrix) == "    M = [first, -second;\n         0, first - second];"


def test_polynomials_define_shared_terms_before_they_use_them():
    code = PRINTER.polynomials({"p": [(x + y) ** 2, (x + y) ** 3], "q": [sympy.Integer(1)]})
    assert code.splitlines() == [
        "    shared0 = first + second;",
        "    p(1) = shared0.^2;",
        "    p(2) = shared0.^3;",
        "    q(1) = 1;",
    ]


TERMS = st.lists(st.sampled_from(["a", "b.*c", "sin(d + e)", "(f - g.*(h + 1))./2", "k" * 60]), min_size=1)


@given(terms=TERMS, signs=st.lists(st.sampled_from([" + ", " - "]), min_size=40, max_size=40))
def test_breaking_changes_nothing_but_the_lines(terms, signs):
    code = terms[0] + "".join(sign + term for sign, term in zip(signs, terms[1:], strict=False))
    lines = broken(f"v = {code};").splitlines()
    joined = " ".join(line.removesuffix(CONTINUATION).strip() for line in lines)
    assert joined == f"v = {code};"
    assert max(map(len, lines)) <= LINE_LENGTH
    assert all(line.endswith(CONTINUATION) for line in lines[:-1])
    assert all(re.match(r" {8}[+-] ", line) for line in lines[1:])


def test_breaks_stand_outside_of_parentheses_where_they_can():
    inner = f"({'i' * 20} + {'j' * 20})"
    code = f"v = {'a' * 30} + {inner}.*{inner};"
    assert broken(code).splitlines()[0] == f"    v = {'a' * 30}{CONTINUATION}"


def test_comments_are_wrapped():
    lines = comment("word " * 60, "%   - ", "%     ").splitlines()
    assert lines[0].startswith("%   - word")
    assert all(line.startswith("%     word") for line in lines[1:])
    assert max(map(len, lines)) <= LINE_LENGTH
