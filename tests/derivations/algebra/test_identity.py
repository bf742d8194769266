"""Proof and disproof of identities; sums and products as they are written."""

import pytest
import sympy

from derivations.algebra.identity import UnprovenError, prove_equal, prove_equal_matrices, require_equal
from derivations.algebra.unevaluated import product, total
from derivations.latex import latex
from derivations.symbols import k2, m1, q1, t

x, y = sympy.symbols("x y", positive=True)


@pytest.mark.parametrize(
    ("left", "right"),
    [
        ((x + y) ** 2, x**2 + 2 * x * y + y**2),
        (1 / x + 1 / y, (x + y) / (x * y)),
        (sympy.sin(x) ** 2 + sympy.cos(x) ** 2, sympy.Integer(1)),
        (sympy.cos(2 * x), 1 - 2 * sympy.sin(x) ** 2),
        (k2 * q1.diff(t) / m1, q1.diff(t) * k2 / m1),
        (sympy.sqrt(x**2), x),
    ],
)
def test_equal(left, right):
    assert prove_equal(left, right).holds


@pytest.mark.parametrize(
    ("left", "right"),
    [
        (x, y),
        (x, -x),
        (x**2, 2 * x),
        (q1.diff(t), q1),
        (sympy.sin(x), sympy.cos(x)),
        (x * (1 + sympy.Rational(1, 10**30)), x),
    ],
)
def test_different(left, right):
    proof = prove_equal(left, right)
    assert not proof.holds
    assert "differ" in proof.method


def test_hard_identity_is_settled_by_points_and_says_so():
    """Machin's formula holds but does not simplify; what is claimed is evaluation, not proof by algebra."""
    left = 4 * sympy.atan(sympy.Rational(1, 5)) - sympy.atan(sympy.Rational(1, 239))
    assert prove_equal(left, sympy.pi / 4).holds
    assert not prove_equal(left, sympy.pi / 4 + sympy.Rational(1, 10**25)).holds


def test_points_alone_are_no_proof_where_one_is_required():
    left = 4 * sympy.atan(sympy.Rational(1, 5)) - sympy.atan(sympy.Rational(1, 239))
    assert prove_equal(left, sympy.pi / 4).sampled
    with pytest.raises(UnprovenError, match="Machin's formula is not proven: difference below"):
        require_equal("Machin's formula", left, sympy.pi / 4)
    with pytest.raises(UnprovenError, match="x is not proven: the sides differ at"):
        require_equal("x", x, x + y)
    assert not require_equal("x", x + y - y, x).sampled


def test_assumption_limits_the_points():
    assert prove_equal(abs(x - y), x - y, assume=sympy.Gt(x, y)).holds
    assert not prove_equal(abs(x - y), x - y).holds
    with pytest.raises(ValueError, match="no random point"):
        prove_equal(x, y, assume=sympy.Gt(0, x))


def test_matrices_need_the_same_shape_and_entries():
    square = sympy.Matrix([[x, y], [y, x]])
    assert prove_equal_matrices(square, square.T).holds
    assert "shapes" in prove_equal_matrices(square, sympy.Matrix([[x, y]])).method
    assert "(2, 1)" in prove_equal_matrices(square, sympy.Matrix([[x, y], [x, x]])).method


def test_a_derivative_of_what_is_no_function_alone_is_carried_out():
    power = sympy.Derivative(q1**3, t)
    assert prove_equal(power, 3 * q1**2 * q1.diff(t)).holds
    assert not prove_equal(power, 2 * q1**2 * q1.diff(t)).holds


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
