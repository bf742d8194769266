"""Confirmation of a derived expression by a numeric integral in many digits."""

from __future__ import annotations

import sympy

from report.claim import Confirmation
from report.numbers.independent.waveforms import DIGITS, Values
from report.numbers.independent.waveforms import coefficient as coefficient
from report.numbers.independent.waveforms import integral as integral
from report.parts import small

RELATIVE = 1e-12


def confirm(derived: sympy.Expr, numeric: complex, values: Values, means: str = "quadrature") -> Confirmation:
    """Confirm a derived expression, which may be zero, at one point."""
    symbolic = complex(sympy.sympify(derived).subs(values).evalf(DIGITS))
    return small(means, abs(numeric - symbolic), RELATIVE * max(1.0, abs(symbolic)))
