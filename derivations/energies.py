"""Kinetic energy, potential energy and Rayleigh's dissipation function of a mechanism."""

import sympy

from derivations.mechanism import Mechanism, elongation, elongation_rate
from derivations.symbols import t

HALF = sympy.Rational(1, 2)


def kinetic_energy(mechanism: Mechanism) -> sympy.Expr:
    """Return T = Σ m q̇² / 2 over the bodies, J; velocities are absolute (thesis, equations 2.3 and 2.4)."""
    alone = (HALF * body.mass * body.coordinate.diff(t) ** 2 for body in mechanism.bodies)
    coupled = (
        HALF * _form(each.mass - sympy.diag(*each.mass.diagonal()), each.coordinates.diff(t))
        for each in mechanism.structures
    )
    return sympy.Add(*alone, *coupled)


def potential_energy(mechanism: Mechanism) -> sympy.Expr:
    """Return U = Σ k e² / 2 over the springs, e being the elongation, J (thesis, equation 2.5)."""
    springs = (HALF * spring.stiffness * elongation(spring) ** 2 for spring in mechanism.springs)
    return sympy.Add(*springs, *(HALF * _form(s.stiffness, s.coordinates) for s in mechanism.structures))


def rayleigh_function(mechanism: Mechanism) -> sympy.Expr:
    """Return R = Σ c ė² / 2 over dampers and viscous frictions, W: half of the power dissipated.

    Source: thesis, equation 2.7.
    """
    rates = ((damper.damping, elongation_rate(damper)) for damper in mechanism.resistances)
    structures = (HALF * _form(s.damping, s.coordinates.diff(t)) for s in mechanism.structures)
    return sympy.Add(*(HALF * damping * rate**2 for damping, rate in rates), *structures)


def _form(matrix: sympy.MatrixBase, vector: sympy.MatrixBase) -> sympy.Expr:
    """Return the quadratic form vᵀ A v, expanded."""
    return sympy.expand((vector.T * matrix * vector)[0])
