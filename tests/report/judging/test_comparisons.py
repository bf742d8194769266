"""Comparisons: their tolerance, and what they show."""

import re
from decimal import Decimal
from fractions import Fraction

import pytest
import sympy
from hypothesis import assume, given, settings
from hypothesis import strategies as st

from report.judging.comparisons.digits import CloseNumbers, PrintedDigits
from report.judging.comparisons.expression import SameExpression, SameMatrix

x, y, z = sympy.symbols("x y z", positive=True)


@pytest.mark.parametrize(
    ("printed", "derived", "agrees"),
    [
        ("4.6329e+03", 4632.88, True),
        ("4.6329e+03", 4632.84, False),
        ("0.0015", 0.00149852, True),
        ("222.35", 222.34847, True),
        ("222.35", 222.3449, False),
        ("3453.172", 3453.1720240, True),
        ("-20", -20.4, True),
        ("-20", 20.0, False),
        ("8", 8, True),
        ("1.5", Fraction(31, 20), True),
        ("1.5", Fraction(3101, 2000), False),
    ],
)
def test_printed_digits_carry_the_tolerance(printed, derived, agrees):
    assert PrintedDigits(printed, derived).compare().agrees is agrees


def test_trailing_zero_is_a_digit():
    assert PrintedDigits("1.5", 1.52).compare().agrees
    assert not PrintedDigits("1.50", 1.52).compare().agrees


@given(
    st.floats(min_value=-1e9, max_value=1e9).filter(lambda value: abs(value) > 1e-9),
    st.integers(min_value=1, max_value=8),
)
@settings(deadline=None, derandomize=True)
def test_a_rounded_number_agrees_and_its_neighbours_do_not(value, digits):
    printed = f"{value:.{digits - 1}e}"
    exponent = Decimal(printed).as_tuple().exponent
    assume(
        abs(Fraction(value) - Fraction(Decimal(printed))) != Fraction(10) ** exponent / 2
    )  # a tie rounds either way
    assert PrintedDigits(printed, value).compare().agrees
    for neighbour in (Decimal(printed) + Decimal(10) ** exponent, Decimal(printed) - Decimal(10) ** exponent):
        assert not PrintedDigits(str(neighbour), value).compare().agrees
    assert not PrintedDigits(printed, -value).compare().agrees


@pytest.mark.parametrize(
    ("printed", "derived", "shown"),
    [("8", 8, "8"), ("4.63e3", 4632.884, "4632.88"), ("1.0e17", 1.655e17, "1.65500e+17")],
)
def test_derived_numbers_show_more_digits_than_were_printed(printed, derived, shown):
    assert str(PrintedDigits(printed, derived).derived_shown) == shown


def test_close_numbers_is_relative():
    assert CloseNumbers(1e-12, 1.0000000001e-12).compare().agrees
    assert not CloseNumbers(1e-12, 2e-12).compare().agrees
    assert not CloseNumbers(1 + 1j, 1 - 1j).compare().agrees


def test_same_expression_sees_through_form_and_shows_the_printed_one():
    printed = sympy.Add(y, x, evaluate=False)
    comparison = SameExpression(printed, x + y, left=z)
    assert comparison.compare().agrees
    assert str(comparison.printed_shown) == "z = y + x"


def test_same_matrix():
    matrix = sympy.ImmutableMatrix([[x, 0], [-y, 1]])
    comparison = SameMatrix(matrix, matrix, left=sympy.Symbol("A"))
    assert comparison.compare().agrees
    assert not SameMatrix(matrix, sympy.ImmutableMatrix([[x, 0]])).compare().agrees
    swapped = sympy.ImmutableMatrix([[x, 0], [1, -y]])
    assert not SameMatrix(swapped, matrix).compare().agrees


def test_a_point_where_the_sides_differ_is_set_as_mathematics():
    gamma, phi = sympy.symbols("gamma phi_c", positive=True)
    method = SameExpression(gamma * phi, gamma + phi).compare().method
    assert re.fullmatch(r"the sides differ at \$\\gamma = [\d/]+\$, \$\\phi_\{c\} = [\d/]+\$", method)
