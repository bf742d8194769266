"""Equations of motion from the Lagrangian and the dissipation function (thesis, equations 2.2 and 2.6)."""

from __future__ import annotations

from dataclasses import dataclass

import sympy

from derivations.energies import kinetic_energy, potential_energy, rayleigh_function
from derivations.mechanism import Mechanism
from derivations.symbols import t


@dataclass(frozen=True)
class MotionMatrices:
    """Matrices of M q̈ + C q̇ + K q = F_u u + F_v u̇.

    Attributes:
        mass: M, n × n for n bodies, kg.
        damping: C, n × n, N s/m.
        stiffness: K, n × n, N/m.
        displacement_force: F_u, n × 1: force on each body per displacement of the pin, N/m.
        velocity_force: F_v, n × 1: force on each body per velocity of the pin, N s/m.
    """

    mass: sympy.ImmutableMatrix
    damping: sympy.ImmutableMatrix
    stiffness: sympy.ImmutableMatrix
    displacement_force: sympy.ImmutableMatrix
    velocity_force: sympy.ImmutableMatrix


def lagrangian(mechanism: Mechanism) -> sympy.Expr:
    """Return the Lagrangian, kinetic minus potential energy, J."""
    return kinetic_energy(mechanism) - potential_energy(mechanism)


def euler_lagrange(lagrangian: sympy.Expr, dissipation: sympy.Expr, coordinate: sympy.Expr) -> sympy.Expr:
    """Return d/dt(∂L/∂q̇) − ∂L/∂q + ∂R/∂q̇, N (thesis, equation 2.6); without other forces it is zero.

    Args:
        lagrangian: L, J.
        dissipation: Rayleigh's function R, W.
        coordinate: The displacement q, m, a function of time.
    """
    velocity = coordinate.diff(t)
    momentum = lagrangian.diff(velocity)
    return momentum.diff(t) - lagrangian.diff(coordinate) + dissipation.diff(velocity)


def force_balances(mechanism: Mechanism) -> tuple[sympy.Expr, ...]:
    """Return the Euler-Lagrange expression of each body, expanded, N, in the order of the bodies."""
    energy, dissipation = lagrangian(mechanism), rayleigh_function(mechanism)
    return tuple(
        sympy.expand(euler_lagrange(energy, dissipation, body.coordinate)) for body in mechanism.bodies
    )


def accelerations(mechanism: Mechanism) -> tuple[sympy.Expr, ...]:
    """Return the acceleration of each body that follows from its Euler-Lagrange equation, m/s².

    The terms are collected, and held in the order of the thesis's equations 2.9: velocities, displacements,
    displacement of the pin, velocity of the pin.
    """
    positions = [body.coordinate for body in mechanism.bodies]
    pin = mechanism.pin.displacement
    variables = [*(position.diff(t) for position in positions), *positions, pin, pin.diff(t)]
    return tuple(
        _collected(-(balance - body.mass * body.coordinate.diff(t, 2)), variables) / body.mass
        for body, balance in zip(mechanism.bodies, force_balances(mechanism), strict=True)
    )


def _collected(force: sympy.Expr, variables: list[sympy.Expr]) -> sympy.Expr:
    terms = (_term(sympy.diff(force, variable), variable) for variable in variables)
    return sympy.Add(*(term for term in terms if term != 0), evaluate=False)


def _term(coefficient: sympy.Expr, variable: sympy.Expr) -> sympy.Expr:
    if coefficient.could_extract_minus_sign():
        return sympy.Mul(-1, -coefficient, variable)
    return coefficient * variable


def motion_matrices(mechanism: Mechanism) -> MotionMatrices:
    """Return the matrices of the linear equations of motion, from derivatives of the force balances.

    Raises:
        ValueError: if the equations of motion are not linear in coordinates and input.
    """
    balances = sympy.Matrix(force_balances(mechanism))
    positions = [body.coordinate for body in mechanism.bodies]
    rates = [position.diff(t) for position in positions]
    second_rates = [position.diff(t, 2) for position in positions]
    pin = [mechanism.pin.displacement]
    pin_rate = [mechanism.pin.displacement.diff(t)]
    mass, damping, stiffness, displacement, velocity = (
        _jacobian(balances, variables) for variables in (second_rates, rates, positions, pin, pin_rate)
    )
    rebuilt = (
        mass * sympy.Matrix(second_rates)
        + damping * sympy.Matrix(rates)
        + stiffness * sympy.Matrix(positions)
        + displacement * pin[0]
        + velocity * pin_rate[0]
    )
    if (rebuilt - balances).expand() != sympy.zeros(*balances.shape):
        raise ValueError("the equations of motion are not linear in the coordinates and the input")
    return MotionMatrices(mass, damping, stiffness, -displacement, -velocity)


def _jacobian(balances: sympy.Matrix, variables: list[sympy.Expr]) -> sympy.ImmutableMatrix:
    return sympy.ImmutableMatrix(
        balances.rows, len(variables), lambda row, column: sympy.diff(balances[row], variables[column])
    )
