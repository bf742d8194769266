"""Building blocks for printed formulas: held as they are printed, never evaluated."""

from __future__ import annotations

import sympy


def total(*terms: sympy.Expr) -> sympy.Expr:
    """Return a sum whose terms keep their order."""
    return sympy.Add(*terms, evaluate=False)


def product(*factors: sympy.Expr) -> sympy.Expr:
    """Return a product whose factors keep their order."""
    return sympy.Mul(*factors, evaluate=False)


def over(numerator: sympy.Expr, denominator: sympy.Expr) -> sympy.Expr:
    """Return a fraction that is not expanded."""
    return sympy.Mul(sympy.Pow(denominator, -1), numerator, evaluate=False)


def half(coefficient: sympy.Expr, squared: sympy.Expr) -> sympy.Expr:
    """Return half a coefficient times a square."""
    return sympy.Mul(sympy.Rational(1, 2), coefficient, sympy.Pow(squared, 2), evaluate=False)
