"""Small changes of a printed expression, of the kind that a slip of the pen makes."""

from __future__ import annotations

from collections.abc import Iterator
from itertools import combinations, islice

import sympy
from sympy.core.function import AppliedUndef

from derivations.identity import prove_equal

LARGEST_NUMBER_OF_SUMS = 3


def mutated_expressions(expression: sympy.Expr) -> Iterator[tuple[str, sympy.Expr]]:
    """Yield (what was changed, changed expression) for changes that make a mathematical difference."""
    for description, changed in _candidates(expression):
        if not prove_equal(changed, expression).holds:
            yield description, changed


def _candidates(expression: sympy.Expr) -> Iterator[tuple[str, sympy.Expr]]:
    yield "sign", -expression
    yield "factor 2", 2 * expression
    yield "factor pi", sympy.pi * expression
    yield "one added", expression + 1
    yield from _sign_of_a_term(expression)
    yield from _swapped_symbols(expression)


def _sign_of_a_term(expression: sympy.Expr) -> Iterator[tuple[str, sympy.Expr]]:
    sums = (node for node in sympy.preorder_traversal(expression) if isinstance(node, sympy.Add))
    for node in islice(sums, LARGEST_NUMBER_OF_SUMS):
        term = node.args[-1]
        yield f"sign of the term {term}", expression.xreplace({node: node - 2 * term})


def _swapped_symbols(expression: sympy.Expr) -> Iterator[tuple[str, sympy.Expr]]:
    names = sorted(expression.atoms(sympy.Symbol, AppliedUndef), key=str)
    functions = {argument for name in names if isinstance(name, AppliedUndef) for argument in name.args}
    swappable = [name for name in names if name not in functions]
    for first, second in combinations(swappable, 2):
        swapped = expression.subs({first: second, second: first}, simultaneous=True)
        if not prove_equal(swapped, expression).holds:
            yield f"{first} and {second} swapped", swapped
            return
