"""Proof or disproof that two expressions are the same, with the way it was settled.

SymPy's ``equals`` may answer ``None``; that is never agreement here. A difference is first evaluated at
exact rational points, which disproves quickly, and is then reduced to zero, which proves: by expansion, with
sines and cosines as exponentials, or by SymPy's simplification. Where reduction fails the points are what is
left, and the proof says so.
"""

import random
from dataclasses import dataclass, replace
from functools import cache

import sympy
from sympy.core.function import AppliedUndef

from derivations.algebra.exponentials import expands_to_zero

QUICK_POINTS = 2
POINTS = 12
DIGITS = 60
PRIME = "'"
NEGLIGIBLE = sympy.Float(10) ** -40
_CIRCULAR = (sympy.sin, sympy.cos, sympy.exp)


@dataclass(frozen=True)
class IdentityProof:
    """Outcome of the attempt to prove an identity."""

    holds: bool  # Whether both sides are equal, as far as it was settled
    method: str  # How it was settled, in words
    sampled: bool = False  # Whether it rests on evaluation at random points alone, which is no proof


class UnprovenError(ValueError):
    """Two expressions that a derivation takes for equal are not proven to be equal."""


def prove_equal(left: sympy.Expr, right: sympy.Expr, assume: sympy.Basic = sympy.true) -> IdentityProof:
    """Prove or disprove that two scalar expressions are equal for all values of their symbols.

    Args:
        left: one side.
        right: the other side.
        assume: a condition on the symbols; points that violate it are not tried.

    Returns:
        The proof: by evaluation at a point where the sides differ, by reduction of the difference to zero, or
        by evaluation at ``POINTS`` random points to ``DIGITS`` digits; the points are rational, whole or odd
        as the symbols are.

    Raises:
        ValueError: if no random point satisfies the condition.
    """
    difference = _with_plain_symbols(sympy.sympify(left) - sympy.sympify(right))
    counterexample = _find_counterexample(difference, assume, QUICK_POINTS)
    if counterexample is not None:
        return IdentityProof(False, f"the sides differ at {counterexample}")
    expansion = _expansion(difference)
    if expansion is not None:
        return expansion
    if sympy.simplify(difference) == 0:
        return IdentityProof(True, "difference simplifies to zero")
    counterexample = _find_counterexample(difference, assume, POINTS)
    if counterexample is not None:
        return IdentityProof(False, f"the sides differ at {counterexample}")
    method = f"difference below 1e-40 at {POINTS} random rational points, {DIGITS} digits"
    return IdentityProof(True, method, sampled=True)


@cache
def require_equal(name: str, left: sympy.Expr, right: sympy.Expr) -> IdentityProof:
    """Prove that two scalar expressions are equal; expansion alone suffices for most, and is tried first.

    Args:
        name: What is to be proven, for the error message.
        left: one side.
        right: the other side.

    Raises:
        UnprovenError: naming what was to be proven, if they differ or only points speak for it.
    """
    proof = _expansion(_with_plain_symbols(left - right)) or prove_equal(left, right)
    if not proof.holds or proof.sampled:
        raise UnprovenError(f"{name} is not proven: {proof.method}")
    return proof


def prove_equal_matrices(left: sympy.MatrixBase, right: sympy.MatrixBase) -> IdentityProof:
    """Prove or disprove that two matrices have the same shape and equal entries.

    Returns:
        The proof, or for the first entry that differs the disproof. ``sampled`` is set if for any entry only
        points speak; the method is that of the weakest entry.
    """
    if left.shape != right.shape:
        return IdentityProof(False, f"shapes {left.shape} and {right.shape} differ")
    proofs = []
    for row in range(left.rows):
        for column in range(left.cols):
            proof = prove_equal(left[row, column], right[row, column])
            if not proof.holds:
                return IdentityProof(False, f"entry ({row + 1}, {column + 1}): {proof.method}")
            proofs.append(proof)
    weakest = max(proofs, key=_weakness)
    return replace(weakest, method=f"all {len(proofs)} entries agree, {weakest.method}")


def _weakness(proof: IdentityProof) -> tuple[bool, bool]:
    return proof.sampled, "simplifies" in proof.method


def _with_plain_symbols(expression: sympy.Expr) -> sympy.Expr:
    """Replace functions of time and their derivatives by symbols that can take any real value."""
    if any(not isinstance(known.expr, AppliedUndef) for known in expression.atoms(sympy.Derivative)):
        expression = expression.doit()
    known = expression.atoms(sympy.Derivative, AppliedUndef)
    return expression.xreplace({each: sympy.Symbol(_value_name(each), real=True) for each in known})


def _value_name(known: sympy.Expr) -> str:
    """Name the value of a function of time, or of its derivative, with one prime for each order."""
    if isinstance(known, sympy.Derivative):
        return f"{known.expr.func.__name__}{PRIME * known.derivative_count}"
    return str(known.func.__name__)


def _numerator(difference: sympy.Expr) -> sympy.Expr:
    return sympy.expand(sympy.fraction(sympy.together(difference))[0])


def _expansion(difference: sympy.Expr) -> IdentityProof | None:
    """Prove by expansion that a difference is zero; None if it is not, or is not found to be."""
    if difference == 0:
        return IdentityProof(True, "difference is zero when expanded")
    if difference.has(*_CIRCULAR) and expands_to_zero(difference):
        return IdentityProof(True, "difference is zero when expanded in exponentials")
    if sympy.expand(difference) == 0 or _numerator(difference) == 0:
        return IdentityProof(True, "difference is zero when expanded")
    return None


def _find_counterexample(difference: sympy.Expr, assume: sympy.Basic, points: int) -> str | None:
    symbols = sorted(difference.free_symbols | assume.free_symbols, key=str)
    generator = random.Random(20230517)
    for _ in range(points):
        point = _random_point(symbols, assume, generator)
        value = difference.xreplace(point).evalf(DIGITS, maxn=10 * DIGITS)
        if value.is_number and not abs(value) < NEGLIGIBLE:
            shown = ", ".join(f"{symbol} = {number}" for symbol, number in point.items())
            return shown or "every point"
    return None


def _random_point(
    symbols: list[sympy.Symbol], assume: sympy.Basic, generator: random.Random
) -> dict[sympy.Symbol, sympy.Rational]:
    for _ in range(1000):
        point = {symbol: _random_value(symbol, generator) for symbol in symbols}
        if assume == sympy.true or assume.subs(point) == sympy.true:
            return point
    raise ValueError(f"no random point satisfies {assume}")


def _random_value(symbol: sympy.Symbol, generator: random.Random) -> sympy.Rational:
    """Return an odd number from 3 on, a whole number or a fraction, whatever the symbol is declared as."""
    if symbol.is_odd:
        return sympy.Integer(2 * generator.randint(1, 40) + 1)
    if symbol.is_integer:
        return sympy.Integer(generator.randint(1, 97))
    return sympy.Rational(generator.randint(1, 997), generator.randint(1, 97))
