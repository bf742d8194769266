"""The series that numeric elements evaluate for small arguments are those of what they stand for."""

import pytest
import sympy
from sympy import cos, exp, sin

from tests.quick import quick
from trimmer.elements import small_arguments

X = sympy.Symbol("x")


@pytest.mark.parametrize(
    ("coefficients", "function", "power"),
    quick(
        [
            (small_arguments.SINE, (X - sin(X)) / X**3, 2),
            (small_arguments.COSINE, (cos(X) - 1 + X**2 / 2) / X**4, 2),
            (small_arguments.DECAY, (exp(-X) - 1 + X) / X**2, 1),
            (small_arguments.DECAY_INTEGRAL, (1 - exp(-X) - X + X**2 / 2) / X**3, 1),
        ],
        1,
        2,
    ),
)
def test_series_for_small_arguments_are_those_of_the_definitions(coefficients, function, power):
    order = power * (len(coefficients) - 1) + 1
    series = sympy.series(function, X, 0, order).removeO()
    expected = [float(series.coeff(X, power * index)) for index in range(len(coefficients))]
    assert coefficients == pytest.approx(expected, rel=1e-15, abs=0.0)
    assert all(series.coeff(X, each) == 0 for each in range(order) if each % power)
