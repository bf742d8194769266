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


def power(digits: str) -> str:
    """Return digits for prose: TeX between dollar signs, with an exponent as a power of ten."""
    mantissa, _, exponent = digits.partition("e")
    if not exponent or float(mantissa) == 0:
        return f"${mantissa}$"
    ten = f"10^{{{int(exponent)}}}"
    return f"${ten}$" if mantissa == "1" else f"${mantissa}\\times{ten}$"


def power_of(value: float, places: int = 0) -> str:
    """Return a number in the same way, its mantissa rounded to so many decimals."""
    return power(f"{value:.{places}e}")
