"""Transfer functions with symbolic coefficients, from the Laplace transform of the equations of motion."""

from collections.abc import Sequence
from dataclasses import dataclass

import sympy
from sympy.polys.matrices import DomainMatrix

from derivations.equations_of_motion import MotionMatrices
from derivations.symbols import s


@dataclass(frozen=True)
class TransferFunctions:
    """Transfer functions from the pin to each of the n displacements, over one common denominator."""

    # The 2n + 1 coefficients of det(M s² + C s + K) / det M, from s^2n down to s^0; that of s^(2n-k) in
    # (rad/s)^k
    denominator: tuple[sympy.Expr, ...]
    # For each of the n bodies the 2n - 1 coefficients of its numerator, from s^(2n-2) down to s^0, with the
    # displacement of the pin as the input; that of s^(2n-2-k) in (rad/s)^(k+2)
    from_displacement: tuple[tuple[sympy.Expr, ...], ...]
    # The same with the velocity of the pin as a separate input, in (rad/s)^(k+1)
    from_velocity: tuple[tuple[sympy.Expr, ...], ...]


def transfer_functions(matrices: MotionMatrices) -> TransferFunctions:
    """Solve (M s² + C s + K) Q = F_u U + F_v V by Cramer's rule, in a ring of polynomials.

    There no quotient arises, so that nothing has to be simplified afterwards.
    """
    dynamic_stiffness = matrices.mass * s**2 + matrices.damping * s + matrices.stiffness
    size = dynamic_stiffness.rows
    mass = matrices.mass.det()
    denominator = _coefficients(_determinant(dynamic_stiffness), mass, 2 * size)

    def numerators(force: sympy.ImmutableMatrix) -> tuple[tuple[sympy.Expr, ...], ...]:
        return tuple(
            _coefficients(_determinant(_with_column(dynamic_stiffness, index, force)), mass, 2 * size - 2)
            for index in range(size)
        )

    return TransferFunctions(
        denominator, numerators(matrices.displacement_force), numerators(matrices.velocity_force)
    )


def numerator_of_force(matrices: MotionMatrices, force: Sequence[int]) -> tuple[sympy.Expr, ...]:
    """Return the numerator that leads from a set of forces to the displacement that does work with them.

    Args:
        matrices: Of n bodies.
        force: For each body its share of the force, and of the displacement, such as 1 and -1 for a pair.

    Returns:
        The 2n - 1 coefficients over the denominator of ``TransferFunctions``, from s^(2n-2) down to s^0, 1/kg
        for the first.
    """
    column = sympy.ImmutableMatrix(list(force))
    dynamic_stiffness = matrices.mass * s**2 + matrices.damping * s + matrices.stiffness
    shares = (
        share * _determinant(_with_column(dynamic_stiffness, index, column))
        for index, share in enumerate(force)
        if share
    )
    return _coefficients(sympy.Add(*shares), matrices.mass.det(), 2 * len(force) - 2)


def _with_column(matrix: sympy.Matrix, index: int, column: sympy.ImmutableMatrix) -> sympy.Matrix:
    replaced = matrix.as_mutable()
    replaced[:, index] = column
    return replaced


def _determinant(matrix: sympy.Matrix) -> sympy.Expr:
    ring_matrix = DomainMatrix.from_Matrix(matrix)
    return ring_matrix.domain.to_sympy(ring_matrix.charpoly()[-1]) * (-1) ** matrix.rows


def _coefficients(determinant: sympy.Expr, divisor: sympy.Expr, degree: int) -> tuple[sympy.Expr, ...]:
    polynomial = sympy.Poly(determinant, s)
    return tuple(polynomial.coeff_monomial(s**power) / divisor for power in range(degree, -1, -1))
