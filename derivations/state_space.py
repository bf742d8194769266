"""State space of a mechanism: the pins' displacements and velocities are inputs, and so are forces.

Source: thesis, equations 2.10 to 2.14.
"""

from dataclasses import dataclass

import sympy

from derivations.equations_of_motion import MotionMatrices


@dataclass(frozen=True)
class StateSpace:
    """Matrices of ẋ = A x + B w with the state x = (q, q̇), for n bodies; SI units."""

    a: sympy.ImmutableMatrix  # A, 2n × 2n
    # B, with a column for each input in the order of ``MotionMatrices.input_forces``; with one pin alone 2n ×
    # 2, for its displacement u and its velocity
    b: sympy.ImmutableMatrix


def state_space(matrices: MotionMatrices, inverse_mass: sympy.ImmutableMatrix | None = None) -> StateSpace:
    """Turn the n equations of second order into 2n of first order (thesis, equations 2.10 to 2.13).

    Args:
        matrices: Of the equations of second order.
        inverse_mass: M⁻¹, if it has symbols of its own.
    """
    size = matrices.mass.rows
    inverse_mass = matrices.mass.inv() if inverse_mass is None else inverse_mass
    zero, identity = sympy.zeros(size, size), sympy.eye(size)
    lower = sympy.Matrix.hstack(-inverse_mass * matrices.stiffness, -inverse_mass * matrices.damping)
    inputs = inverse_mass * matrices.input_forces
    a = sympy.Matrix.vstack(sympy.Matrix.hstack(zero, identity), lower)
    b = sympy.Matrix.vstack(sympy.zeros(size, inputs.cols), inputs)
    return StateSpace(sympy.ImmutableMatrix(a), sympy.ImmutableMatrix(b))


def output_row(of: int, relative_to: int | None, size: int) -> sympy.ImmutableMatrix:
    """Return the 1 × 2n output matrix of one displacement, or of the difference of two.

    Args:
        of: Index of the body from 0.
        relative_to: Index of the body whose displacement is subtracted; None for the ground.
        size: Number n of bodies.
    """
    row = [sympy.Integer(0)] * (2 * size)
    row[of] += 1
    if relative_to is not None:
        row[relative_to] -= 1
    return sympy.ImmutableMatrix([row])
