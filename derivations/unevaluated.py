"""Sums and products that keep the order in which they are written."""

from __future__ import annotations

import sympy


def total(*terms: sympy.Expr) -> sympy.Expr:
    """Return a sum whose terms keep their order; zeros are left out."""
    kept = [sympy.sympify(term) for term in terms if term != 0]
    return sympy.Add(*kept, evaluate=False) if len(kept) > 1 else sympy.Add(*kept)


def product(*factors: sympy.Expr) -> sympy.Expr:
    """Return a product that is not multiplied out; ones are left out."""
    kept = [sympy.sympify(factor) for factor in factors if factor != 1]
    return sympy.Mul(*kept, evaluate=False) if len(kept) > 1 else sympy.Mul(*kept)
