"""Sums and products that SymPy neither reorders nor multiplies out, for formulas that are shown."""

import sympy


def total(*terms: sympy.Expr) -> sympy.Expr:
    """Return a sum whose terms keep their order; zeros are left out."""
    kept = [sympy.sympify(term) for term in terms if term != 0]
    return sympy.Add(*kept, evaluate=False)


def product(*factors: sympy.Expr) -> sympy.Expr:
    """Return a product whose factors keep their order and are not multiplied out; ones are left out."""
    kept = [sympy.sympify(factor) for factor in factors if factor != 1]
    return sympy.Mul(*kept, evaluate=False)
