"""Zeros in exponentials, found by arithmetic of polynomials."""

import pytest
import sympy
from sympy import I, cos, exp, pi, sin

from derivations.algebra.exponentials import expands_to_zero

x, y, g = sympy.symbols("x y g", positive=True)
n = sympy.Symbol("n", odd=True, positive=True)


@pytest.mark.parametrize(
    "zero",
    [
        sin(x) ** 2 + cos(x) ** 2 - 1,
        sin(x + y) - sin(x) * cos(y) - cos(x) * sin(y),
        exp(x / g) * exp(-(x + y) / g) - exp(-y / g),
        exp(I * x / 2) ** 2 - cos(x) - I * sin(x),
        cos(x - pi / 4) ** 2 - (1 + sin(2 * x)) / 2,
        sin(x + pi / 5) * cos(x + pi / 5) * 2 - sin(2 * x + 2 * pi / 5),
        exp(2 * I * pi / 3) + exp(4 * I * pi / 3) + 1 + x - x * exp(0 * x),
        exp(I * pi / 3 + I * x) - exp(I * x) * exp(I * pi / 3),
        exp(-I * n * (x + pi)) + exp(-I * n * x),
        1 / (1 + I * g) - (1 - I * g) / (1 + g**2),
        (x**2 - y**2) / (x - y) - x - y,
        sin(x) / cos(x) - sin(2 * x) / (1 + cos(2 * x)),
        pi * sin(x + pi) + pi * sin(x),
    ],
)
def test_a_zero_is_found_and_nothing_beside_it(zero):
    assert expands_to_zero(zero)
    assert not expands_to_zero(zero + sympy.Rational(1, 10**30))
    assert not expands_to_zero(zero + I * x)


@pytest.mark.parametrize(
    "other",
    [
        sympy.sqrt(x) ** 2 - x + sympy.sqrt(y),
        sympy.atan(x),
        sin(x) * sympy.Float(1e-30),
        exp(sympy.sqrt(2)) - 4,
    ],
)
def test_what_is_no_such_expression_is_not_taken_for_zero(other):
    assert not expands_to_zero(other)
