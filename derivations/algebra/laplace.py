"""State space in the Laplace domain, with a general system of two states (thesis, equations 2.17 to 2.21)."""

from dataclasses import dataclass

import sympy

from derivations.symbols import s, t

STATES = 2


@dataclass(frozen=True)
class GeneralSystem:
    """ẋ = A x + B u, y = C x + D u with symbolic entries: two states, one input, one output."""

    a: sympy.ImmutableMatrix  # A, 2 × 2
    b: sympy.ImmutableMatrix  # B, 2 × 1
    c: sympy.ImmutableMatrix  # C, 1 × 2
    d: sympy.Symbol  # D, a scalar
    input_transform: sympy.Symbol  # Laplace transform U of the input


@dataclass(frozen=True)
class TransformedSystem:
    """Response of a system that starts at rest, in the Laplace domain."""

    state: sympy.ImmutableMatrix  # Transform of the state, 2 × 1
    output: sympy.Expr  # Transform of the output, a scalar


def general_system() -> GeneralSystem:
    """Return the system with a symbol of its own for each entry of A, B, C and D."""
    return GeneralSystem(
        a=sympy.ImmutableMatrix(STATES, STATES, lambda row, column: sympy.Symbol(f"a_{row + 1}{column + 1}")),
        b=sympy.ImmutableMatrix(STATES, 1, lambda row, _: sympy.Symbol(f"b_{row + 1}")),
        c=sympy.ImmutableMatrix(1, STATES, lambda _, column: sympy.Symbol(f"c_{column + 1}")),
        d=sympy.Symbol("d"),
        input_transform=sympy.Symbol("U"),
    )


def transform_of_derivative(start: sympy.Expr) -> sympy.Expr:
    """Return the Laplace transform s Q - q(0) of q̇, with Q for the transform of q and ``start`` for q(0)."""
    q = sympy.Function("q")
    transformed = sympy.laplace_transform(q(t).diff(t), t, s, noconds=True)
    named = transformed.subs(sympy.LaplaceTransform(q(t), t, s), sympy.Symbol("Q"))
    return named.subs(q(0), start)


def transform(system: GeneralSystem) -> TransformedSystem:
    """Transform the equations of a system and solve them as scalar ones, without inverting a matrix."""
    unknowns = sympy.symbols(f"Q_1:{STATES + 1}")
    equations = [
        s * unknowns[row]
        - sum(system.a[row, column] * unknowns[column] for column in range(STATES))
        - system.b[row] * system.input_transform
        for row in range(STATES)
    ]
    solution = sympy.solve(equations, unknowns)
    state = [solution[unknown] for unknown in unknowns]
    output = (
        sum(system.c[index] * state[index] for index in range(STATES)) + system.d * system.input_transform
    )
    return TransformedSystem(sympy.ImmutableMatrix(state), sympy.together(output))
