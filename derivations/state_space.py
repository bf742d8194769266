"""State space with both inputs of the pin, displacement and velocity (thesis, equations 2.10 to 2.14)."""

from __future__ import annotations

from dataclasses import dataclass

import sympy

from derivations.equations_of_motion import MotionMatrices


@dataclass(frozen=True)
class StateSpace:
    """Matrices of ẋ = A x + B (u, u̇) with the state x = (q, q̇): ``a`` is 2n × 2n, ``b`` is 2n × 2."""

    a: sympy.ImmutableMatrix
    b: sympy.ImmutableMatrix


def state_space(matrices: MotionMatrices) -> StateSpace:
    """Turn the second-order equations into first-order ones."""
    size = matrices.mass.rows
    inverse_mass = matrices.mass.inv()
    zero, identity = sympy.zeros(size, size), sympy.eye(size)
    lower = sympy.Matrix.hstack(-inverse_mass * matrices.stiffness, -inverse_mass * matrices.damping)
    inputs = sympy.Matrix.hstack(
        inverse_mass * matrices.displacement_force, inverse_mass * matrices.velocity_force
    )
    a = sympy.Matrix.vstack(sympy.Matrix.hstack(zero, identity), lower)
    b = sympy.Matrix.vstack(sympy.zeros(size, 2), inputs)
    return StateSpace(sympy.ImmutableMatrix(a), sympy.ImmutableMatrix(b))


def output_row(of: int, relative_to: int | None, size: int) -> sympy.ImmutableMatrix:
    """Return the 1 × 2n output matrix of displacement ``of`` minus ``relative_to`` (indices from 0)."""
    row = [sympy.Integer(0)] * (2 * size)
    row[of] += 1
    if relative_to is not None:
        row[relative_to] -= 1
    return sympy.ImmutableMatrix([row])
