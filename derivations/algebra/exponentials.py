"""Whether an expression in powers, exponentials, sines and cosines is zero, by arithmetic of polynomials.

Sines and cosines go over into exponentials, and an exponential of a sum into a product of powers of
exponentials of single terms. These and the symbols are then generators of a field of fractions over the
integers. One more stands for a root of unity, of which the imaginary unit is a power; it is reduced by its
cyclotomic polynomial. A numerator of zero proves the identity; another one disproves nothing, as generators
may be related in ways that are not looked for.
"""

import sympy
from sympy.polys.fields import field

_ROOT, _PI = sympy.Dummy("root"), sympy.Dummy("pi")
_HALF_TURN = sympy.I * sympy.pi
_CIRCULAR = (sympy.sin, sympy.cos)
Terms = dict[sympy.Expr, tuple[sympy.Expr, ...]]


def expands_to_zero(expression: sympy.Expr) -> bool:
    """Return whether an expression is proven to be zero.

    False proves nothing: it is also returned for an expression that holds other functions, or roots.
    """
    exponential = expression.rewrite(_CIRCULAR, sympy.exp)
    terms = {each: sympy.Add.make_args(sympy.expand(each.exp)) for each in exponential.atoms(sympy.exp)}
    denominators = _denominators(terms)
    share = sympy.ilcm(2, denominators.pop(_HALF_TURN, 1))  # the root is exp(jπ/share)
    generators = {monomial: sympy.Dummy(f"exp({monomial})") for monomial in denominators}
    bases = {monomial: (generators[monomial], count) for monomial, count in denominators.items()}
    powers = _as_powers(terms, bases | {_HALF_TURN: (_ROOT, share)})
    units = {sympy.I: _ROOT ** (share // 2), sympy.pi: _PI}
    rational = exponential.xreplace(powers).xreplace(units)
    if not rational.is_rational_function() or rational.has(sympy.Float, sympy.NumberSymbol):
        return False
    fractions = field(sorted(rational.free_symbols | {_ROOT}, key=sympy.default_sort_key), sympy.ZZ)[0]
    relation = fractions.ring.from_expr(sympy.cyclotomic_poly(2 * share, _ROOT))
    return not fractions.from_expr(rational).numer.rem([relation])


def _denominators(terms: Terms) -> dict[sympy.Expr, int]:
    """Return for each monomial in the exponents the common denominator of its coefficients."""
    denominators: dict[sympy.Expr, int] = {}
    for term in (term for sums in terms.values() for term in sums):
        coefficient, monomial = term.as_coeff_Mul()
        denominators[monomial] = sympy.ilcm(denominators.get(monomial, 1), coefficient.q)
    return denominators


def _as_powers(
    terms: Terms, bases: dict[sympy.Expr, tuple[sympy.Symbol, int]]
) -> dict[sympy.Expr, sympy.Expr]:
    """Write each exponential as a product of whole powers of the bases, and of numbers such as exp(jπn)."""

    def power(term: sympy.Expr) -> sympy.Expr:
        value = sympy.exp(term)
        coefficient, monomial = term.as_coeff_Mul()
        if monomial != _HALF_TURN and not isinstance(value, sympy.exp):
            return value
        base, count = bases[monomial]
        return base ** (coefficient * count)

    return {each: sympy.Mul(*map(power, sums)) for each, sums in terms.items()}
