"""Harmonics of a half-wave odd waveform by one complex integral, for a symbolic harmonic too.

With θ = ωt, N_n = (b_n + j a_n)/A = (j/(πA)) ∫ y exp(-jnθ) dθ over a period (thesis, equations 2.29, 2.35).
SymPy's own integration answers with case distinctions where the harmonic is a symbol. Here the integrand is a
sum of powers times exponentials, each with a known antiderivative, and the sum is differentiated back.
"""

from functools import cache

import sympy

from derivations.algebra.identity import require_equal
from derivations.elements.waveform import THETA, Segment, Waveform

HARMONIC = sympy.Symbol("n", odd=True, positive=True)
"""Number of an odd harmonic; for backlash from 3 on, since the pin's own motion is in the first one."""


@cache
def antiderivative(integrand: sympy.Expr, variable: sympy.Symbol) -> sympy.Expr:
    """Return an antiderivative of a sum of products of powers, exponentials, sines and cosines.

    It is made of such functions itself, so it is continuous and may be taken between any two limits.

    Args:
        integrand: The sum.
        variable: The symbol by which it is integrated; other symbols are constants.

    Raises:
        UnprovenError: if its derivative is not the integrand.
        ValueError: if a term is something else than such a product.
    """
    if integrand == 0:
        return sympy.Integer(0)
    terms = sympy.Add.make_args(sympy.expand(integrand.rewrite(sympy.exp)))
    primitive = sympy.Add(*(_primitive(term, variable) for term in terms))
    require_equal(f"the antiderivative of {integrand}", primitive.diff(variable), integrand)
    return primitive


def _primitive(term: sympy.Expr, variable: sympy.Symbol) -> sympy.Expr:
    """Integrate constant · x^k · exp(rate · x) by parts k times."""
    constant, dependent = term.as_independent(variable)
    factors = sympy.Mul.make_args(dependent)
    exponential = sympy.Mul(*(factor for factor in factors if isinstance(factor, sympy.exp)))
    degree = sympy.degree(dependent / exponential, variable)
    rate = sympy.expand(exponential.diff(variable) / exponential)
    if sympy.expand(dependent / exponential) != variable**degree or rate.has(variable):
        raise ValueError(f"{term} is no product of powers and exponentials of {variable}")
    if rate == 0:
        return constant * dependent * variable / (degree + 1)
    parts = (
        (-1) ** step * sympy.ff(degree, step) * variable ** (degree - step) / rate ** (step + 1)
        for step in range(degree + 1)
    )
    return constant * exponential * sympy.Add(*parts)


def evaluated(expression: sympy.Expr) -> sympy.Expr:
    """Replace each definite integral in an expression by its value.

    Raises:
        UnprovenError: if an antiderivative is not proven.
        ValueError: if an integrand is not such as ``antiderivative`` takes.
    """
    values = {}
    for integral in expression.atoms(sympy.Integral):
        variable, start, end = integral.limits[0]
        primitive = antiderivative(integral.function, variable)
        values[integral] = primitive.subs(variable, end) - primitive.subs(variable, start)
    return expression.xreplace(values)


def harmonic_integral(segment: Segment, harmonic: sympy.Expr) -> sympy.Integral:
    """Return ∫ y exp(-jnθ) dθ over a segment, not evaluated."""
    weight = sympy.exp(-sympy.I * harmonic * THETA)
    return sympy.Integral(segment.value * weight, (THETA, segment.start, segment.end))


def first_half(waveform: Waveform) -> tuple[Segment, ...]:
    """Return the segments of the first half of the period.

    Raises:
        UnprovenError: if the second half is not the first one with the other sign, half a period later.
    """
    count = len(waveform.segments) // 2
    halves = zip(waveform.segments[:count], waveform.segments[-count:], strict=True)
    for first, second in halves:
        require_equal("half a period to the next start", second.start - first.start, sympy.pi)
        require_equal("half a period to the next end", second.end - first.end, sympy.pi)
        later = second.value.subs(THETA, THETA + sympy.pi)
        require_equal("the other sign half a period later", later, -first.value)
    return waveform.segments[:count]


def odd_harmonic(waveform: Waveform, amplitude: sympy.Expr, harmonic: sympy.Expr) -> sympy.Expr:
    """Return N_n = (2j/(πA)) ∫ y exp(-jnθ) dθ over half a period, for odd n.

    Args:
        waveform: The output y over a period.
        amplitude: A of the input A sin θ, in the unit of the input.
        harmonic: n, a number or a symbol.

    Returns:
        N_n in the unit of output over input.

    Raises:
        UnprovenError: if the waveform is not half-wave odd, or an antiderivative is not proven.
        ValueError: if a segment is not such as ``antiderivative`` takes.
    """
    integrals = (evaluated(harmonic_integral(segment, harmonic)) for segment in first_half(waveform))
    return 2 * sympy.I / (sympy.pi * amplitude) * sympy.Add(*integrals)
