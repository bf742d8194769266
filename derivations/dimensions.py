"""Physical dimensions, and the check that a formula is consistent in them.

The check is independent of how a formula was derived: a lost factor that carries a unit (an amplitude, a
mass) shows up as a sum of unlike terms or as a wrong dimension of the whole.
"""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass

import sympy
from sympy.core.function import AppliedUndef


class DimensionError(ValueError):
    """A formula that adds, compares or raises quantities in a way that their dimensions forbid."""


@dataclass(frozen=True)
class Dimension:
    """A physical dimension mass^a length^b time^c; an angle is a pure number."""

    mass: sympy.Rational | int = 0  # Exponent of mass, kg in SI units
    length: sympy.Rational | int = 0  # Exponent of length, m
    time: sympy.Rational | int = 0  # Exponent of time, s

    def __mul__(self, other: Dimension) -> Dimension:
        return Dimension(self.mass + other.mass, self.length + other.length, self.time + other.time)

    def __pow__(self, exponent: sympy.Rational | int) -> Dimension:
        return Dimension(self.mass * exponent, self.length * exponent, self.time * exponent)

    def __truediv__(self, other: Dimension) -> Dimension:
        return self * other**-1

    def __str__(self) -> str:
        names = {"kg": self.mass, "m": self.length, "s": self.time}
        return (
            " ".join(f"{name}^{power}" if power != 1 else name for name, power in names.items() if power)
            or "1"
        )


NUMBER = Dimension()
MASS = Dimension(mass=1)
LENGTH = Dimension(length=1)
TIME = Dimension(time=1)
FORCE = MASS * LENGTH / TIME**2
ENERGY = FORCE * LENGTH
POWER = ENERGY / TIME


def dimension_of(expression: sympy.Expr, dimensions: Mapping[sympy.Expr, Dimension]) -> Dimension | None:
    """Find the dimension of an expression from those of its symbols.

    Args:
        expression: scalar SymPy expression.
        dimensions: dimension of each free symbol and of each undefined function of time.

    Returns:
        The dimension, or None for an exact zero, which has every dimension.

    Raises:
        DimensionError: if unlike terms are added, or a function or an exponent has a dimension.
        KeyError: if a symbol has no entry in ``dimensions``.
    """
    if expression.is_zero:
        return None
    if expression.is_number:
        return NUMBER
    if expression.is_Symbol or isinstance(expression, AppliedUndef):
        return dimensions[expression]
    if isinstance(expression, sympy.Derivative):
        return _of_derivative(expression, dimensions)
    if expression.is_Add:
        return _of_sum(expression, dimensions)
    if expression.is_Mul:
        return _of_product(expression, dimensions)
    if expression.is_Pow:
        return _of_power(expression, dimensions)
    for argument in expression.args:
        _require_number(argument, expression, dimensions)
    return NUMBER


def _of_derivative(
    expression: sympy.Derivative, dimensions: Mapping[sympy.Expr, Dimension]
) -> Dimension | None:
    result = dimension_of(expression.expr, dimensions)
    for variable, count in expression.variable_count:
        variable_dimension = dimension_of(variable, dimensions)
        if result is not None and variable_dimension is not None:
            result = result / variable_dimension ** sympy.Integer(count)
    return result


def _of_sum(expression: sympy.Expr, dimensions: Mapping[sympy.Expr, Dimension]) -> Dimension | None:
    found: Dimension | None = None
    for term in expression.args:
        dimension = dimension_of(term, dimensions)
        if dimension is None or dimension == found:
            continue
        if found is not None:
            raise DimensionError(
                f"{expression}: the term {term} has dimension {dimension}, the others have {found}"
            )
        found = dimension
    return found


def _of_product(expression: sympy.Expr, dimensions: Mapping[sympy.Expr, Dimension]) -> Dimension | None:
    result = NUMBER
    for factor in expression.args:
        dimension = dimension_of(factor, dimensions)
        if dimension is None:
            return None
        result = result * dimension
    return result


def _of_power(expression: sympy.Expr, dimensions: Mapping[sympy.Expr, Dimension]) -> Dimension | None:
    base, exponent = expression.as_base_exp()
    _require_number(exponent, expression, dimensions)
    dimension = dimension_of(base, dimensions)
    if dimension is None or dimension == NUMBER:
        return dimension
    if not exponent.is_Rational:
        raise DimensionError(
            f"{expression}: a quantity with a dimension is raised to a power that is no fraction"
        )
    return dimension**exponent


def _require_number(
    argument: sympy.Expr, whole: sympy.Expr, dimensions: Mapping[sympy.Expr, Dimension]
) -> None:
    dimension = dimension_of(argument, dimensions)
    if dimension not in (None, NUMBER):
        raise DimensionError(f"{whole}: {argument} has dimension {dimension}, but must be a pure number")
