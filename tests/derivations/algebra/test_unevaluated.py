"""Sums and products stay as they are written."""

import sympy

from derivations.algebra.unevaluated import product, total
from derivations.latex import latex

x, y = sympy.symbols("x y")


def test_a_sum_keeps_the_order_of_its_terms_and_leaves_out_zeros():
    assert total(y, 0, -1, x).args == (y, sympy.Integer(-1), x)
    assert total(x, x).args == (x, x)
    assert latex(total(1, -x, 2)) == "1 - x + 2"
    for terms, value in (((), 0), ((0,), 0), ((x,), x), ((0, 3), 3), ((0, x + y, 0.0), x + y)):
        assert total(*terms) == sympy.sympify(value)
        assert type(total(*terms)) is type(sympy.sympify(value))


def test_a_product_keeps_the_order_of_its_factors_and_is_not_multiplied_out():
    assert product(y, 1, 2, x + 1).args == (y, sympy.Integer(2), x + 1)
    assert product(2, x + 1) != 2 * (x + 1) == 2 * x + 2
    assert product(2, 3).args == (2, 3)
    assert product(0, x).args == (0, x)
    for factors, value in (((), 1), ((1,), 1), ((x,), x), ((1, 3), 3), ((1, x + y, 1), x + y)):
        assert product(*factors) == sympy.sympify(value)
        assert type(product(*factors)) is type(sympy.sympify(value))
