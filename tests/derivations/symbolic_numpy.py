"""Running NumPy code on SymPy symbols: what it computes then is an expression that can be proven."""

from __future__ import annotations

from types import SimpleNamespace

import sympy

WEIGHT = sympy.Symbol("W")
NODE = sympy.Symbol("z", real=True)


class SymbolicNumPy:
    """The functions of NumPy that the numeric elements call, for one SymPy expression in place of an array.

    A condition is decided at a sample point, so each branch is reached by a sample that lies in it. Gauss's
    rule has one symbolic node and weight; ``integrated`` makes the integral of them that a rule stands for.
    """

    pi = sympy.pi
    sin, cos, exp, sqrt = (
        staticmethod(sympy.sin),
        staticmethod(sympy.cos),
        staticmethod(sympy.exp),
        sympy.sqrt,
    )

    def __init__(self, sample):
        self.sample = sample
        rule = SimpleNamespace(leggauss=lambda count: ([NODE], [WEIGHT]))
        self.polynomial = SimpleNamespace(legendre=rule)

    def where(self, condition, if_true, if_false):
        return if_true if sympy.sympify(condition).subs(self.sample) == sympy.true else if_false

    def minimum(self, first, second):
        return self.where(sympy.Lt(first, second), first, second)

    @staticmethod
    def expm1(argument):
        return sympy.exp(argument) - 1

    @staticmethod
    def asarray(value):
        return value

    @staticmethod
    def arctan2(sine, cosine):
        """Angle of a point of the unit circle that is given as (cos φ, sin φ)."""
        (angle,) = sine.args
        assert (sine, cosine) == (sympy.sin(angle), sympy.cos(angle))
        return angle


def exact(value):
    """Make rational numbers of floats such as 0.5 and 2.0, and multiply exponents out."""
    rational = sympy.nsimplify(sympy.sympify(value), rational=True)
    return rational.replace(sympy.exp, lambda exponent: sympy.exp(sympy.expand(exponent)))


def integrated(value):
    """Put the integral over -1 <= z <= 1 in the place of a sum over nodes and weights."""
    expanded = sympy.expand(exact(value))
    assert sympy.degree(expanded, WEIGHT) <= 1
    summand = expanded.coeff(WEIGHT, 1)
    return expanded.coeff(WEIGHT, 0) + sympy.Integral(summand, (NODE, -1, 1))
