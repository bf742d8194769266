"""The trimmer's formulas as the thesis prints them, transcribed once for the places that repeat them.

Sources are equations 2.4, 2.5, 2.7, 2.9 and 2.12 to 2.14; appendix D prints the same energies again.
"""

import sympy

from derivations.symbols import coordinates, dampings, masses, stiffnesses, u, u_dot, velocities
from report.judging.comparisons.printed import half, over, product, total

m1, m2, m3, m4 = masses
k1, k2, k3, k4, k5 = stiffnesses
c1, c2, c3, c4 = dampings
q1, q2, q3, q4 = coordinates
v1, v2, v3, v4 = velocities


def kinetic_energy() -> sympy.Expr:
    """Return the kinetic energy of equation 2.4."""
    return total(half(m1, v1), half(m2, v2), half(m3, v3), half(m4, v4))


def potential_energy() -> sympy.Expr:
    """Return the potential energy of equation 2.5."""
    return total(
        half(k1, q1),
        half(k2, total(q2, -q1, -u)),
        half(k3, q3),
        half(k4, total(q4, -q3)),
        half(k5, total(q2, -q3)),
    )


def rayleigh_function() -> sympy.Expr:
    """Return the dissipation function of equation 2.7."""
    return total(half(c1, v1), half(c2, total(v2, -v1, -u_dot)), half(c3, v3), half(c4, total(v4, -v3)))


def accelerations() -> tuple[sympy.Expr, ...]:
    """Return the right-hand sides of equation 2.9."""
    motor = total(product(-1, c1 + c2, v1), c2 * v2, product(-1, k1 + k2, q1), k2 * q2, -k2 * u, -c2 * u_dot)
    cutter = total(c2 * v1, -c2 * v2, k2 * q1, product(-1, k2 + k5, q2), k5 * q3, k2 * u, c2 * u_dot)
    housing = total(product(-1, c3 + c4, v3), c4 * v4, k5 * q2, product(-1, k3 + k4 + k5, q3), k4 * q4)
    guard = total(c4 * v3, -c4 * v4, k4 * q3, -k4 * q4)
    return over(motor, m1), over(cutter, m2), over(housing, m3), over(guard, m4)


def state_matrix() -> sympy.ImmutableMatrix:
    """Return the matrix of equation 2.12 and of lines 30 to 37 of Listing A.1."""

    def minus(bracket: sympy.Expr, mass: sympy.Expr) -> sympy.Expr:
        return product(-1, over(bracket, mass))

    return sympy.ImmutableMatrix(
        [
            [0, 0, 0, 0, 1, 0, 0, 0],
            [0, 0, 0, 0, 0, 1, 0, 0],
            [0, 0, 0, 0, 0, 0, 1, 0],
            [0, 0, 0, 0, 0, 0, 0, 1],
            [minus(k1 + k2, m1), k2 / m1, 0, 0, minus(c1 + c2, m1), c2 / m1, 0, 0],
            [k2 / m2, minus(k2 + k5, m2), k5 / m2, 0, c2 / m2, -c2 / m2, 0, 0],
            [0, k5 / m3, minus(k3 + k4 + k5, m3), k4 / m3, 0, 0, minus(c3 + c4, m3), c4 / m3],
            [0, 0, k4 / m4, -k4 / m4, 0, 0, c4 / m4, -c4 / m4],
        ]
    )


def input_matrix() -> sympy.ImmutableMatrix:
    """Return the matrix of equation 2.13 and of lines 39 to 46 of Listing A.1."""
    return sympy.ImmutableMatrix(
        [[0, 0], [0, 0], [0, 0], [0, 0], [-k2 / m1, -c2 / m1], [k2 / m2, c2 / m2], [0, 0], [0, 0]]
    )


def output_matrix() -> sympy.ImmutableMatrix:
    """Return the row of equation 2.14 and of line 50 of Listing A.1."""
    return sympy.ImmutableMatrix([[0, 1, 0, -1, 0, 0, 0, 0]])
