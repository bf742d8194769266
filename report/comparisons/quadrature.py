"""Numeric integrals of waveforms in many digits: the second way for claims on describing functions."""

from __future__ import annotations

from collections.abc import Mapping

import mpmath
import sympy

from derivations.waveform import THETA, Segment, Waveform
from report.claim import Confirmation
from report.comparisons.digits import CloseNumbers

DIGITS = 30
RELATIVE = 1e-12
Values = Mapping[sympy.Expr, sympy.Expr]


def integral(segment: Segment, weight: sympy.Expr, values: Values) -> complex:
    """Return the integral of a segment times a weight by quadrature, for numeric values of the symbols."""
    integrand = sympy.lambdify(THETA, (segment.value * weight).subs(values), "mpmath")
    with mpmath.workdps(DIGITS):
        ends = [mpmath.mpf(end.subs(values).evalf(DIGITS)) for end in (segment.start, segment.end)]
        return complex(mpmath.quad(integrand, ends))


def coefficient(waveform: Waveform, weight: sympy.Expr, values: Values) -> complex:
    """Return (1/π) times the integral over the period."""
    return sum(integral(segment, weight, values) for segment in waveform.segments) / float(sympy.pi)


def confirm(derived: sympy.Expr, numeric: complex, values: Values, means: str = "quadrature") -> Confirmation:
    """Confirm a derived expression at one point; both sides are raised by one, so that zero compares too."""
    symbolic = complex(sympy.sympify(derived).subs(values).evalf(DIGITS))
    return Confirmation(means, CloseNumbers(1 + numeric, 1 + symbolic, RELATIVE))
