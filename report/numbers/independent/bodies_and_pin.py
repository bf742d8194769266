"""Energies of the bodies and motion of the pin, from work and forces instead of from the Lagrangian."""

from __future__ import annotations

import sympy

from derivations.equations_of_motion import euler_lagrange
from derivations.linear_trimmer import LinearTrimmer
from derivations.symbols import A, accelerations, coordinates, f, masses, t, velocities


def work_from_rest() -> sympy.Expr:
    """Return the work that brings each mass from rest to its velocity, added up, J."""
    speed = sympy.Dummy("v", real=True)
    works = (sympy.integrate(m * speed, (speed, 0, v)) for m, v in zip(masses, velocities, strict=True))
    return sympy.Add(*works)


def sign_of_potential_energy(derivation: LinearTrimmer) -> sympy.Expr:
    """Return σ with which L = T + σ U gives Newton's second law for the motor."""
    sign = sympy.Symbol("sigma")
    energy = derivation.kinetic_energy + sign * derivation.potential_energy
    balance = euler_lagrange(energy, derivation.rayleigh_function, coordinates[0])
    newton = masses[0] * (accelerations[0] - derivation.newton[0])
    (solved,) = sympy.solve(sympy.expand(balance - newton), sign)
    return solved


def pin_from_acceleration() -> sympy.Expr:
    """Return the displacement (m) whose acceleration is (2 π f)² times it, towards the axis."""
    displaced, rate = sympy.Function("x"), 2 * sympy.pi * f
    start = {displaced(0): 0, displaced(t).diff(t).subs(t, 0): A * rate}
    equation = sympy.Eq(displaced(t).diff(t, 2), -(rate**2) * displaced(t))
    return sympy.dsolve(equation, displaced(t), ics=start).rhs
