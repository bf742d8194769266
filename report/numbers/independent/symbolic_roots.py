"""Roots of short symbolic equations."""

from __future__ import annotations

import sympy


def first_root(expression: sympy.Expr, unknown: sympy.Symbol) -> sympy.Expr:
    """Return the root of an expression in a symbol; the first one, if there are several."""
    return sympy.solve(expression, unknown)[0]


def zeros_in_turn(expression: sympy.Expr, phase: sympy.Symbol) -> set[sympy.Expr]:
    """Return the phases in [0, 2π) at which an expression is zero, rad."""
    return set(sympy.solveset(expression, phase, sympy.Interval.Ropen(0, 2 * sympy.pi)))
