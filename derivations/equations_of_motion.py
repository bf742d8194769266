"""Equations of motion from the Lagrangian and the dissipation function (thesis, equations 2.2 and 2.6)."""

from dataclasses import dataclass
from functools import lru_cache

import sympy

from derivations.energies import kinetic_energy, potential_energy, rayleigh_function
from derivations.generalised_forces import generalised_forces
from derivations.mechanism import Mechanism
from derivations.symbols import t

KEPT = 8  # Mechanisms whose equations are kept, because several checks ask for the same ones


@dataclass(frozen=True)
class MotionMatrices:
    """Matrices of M q̈ + C q̇ + K q = F_u u + F_v u̇ + F_p p + F_T T + F_f f + f_0."""

    mass: sympy.ImmutableMatrix  # M, n × n for n bodies, kg
    damping: sympy.ImmutableMatrix  # C, n × n, N s/m
    stiffness: sympy.ImmutableMatrix  # K, n × n, N/m
    # F_u, a column for each pin: force on each body per displacement, N/m
    displacement_force: sympy.ImmutableMatrix
    # F_v, a column for each pin: force on each body per velocity, N s/m
    velocity_force: sympy.ImmutableMatrix
    given_force: sympy.ImmutableMatrix  # F_p, a column for each given force, 1 at its body
    contact_force: sympy.ImmutableMatrix  # F_T, a column for each contact: share of its tension on each body
    # F_f, a column for each friction: share of its dry force on each body
    friction_force: sympy.ImmutableMatrix
    # f_0, n × 1, N: of springs that carry nothing at another distance of their ends
    constant_force: sympy.ImmutableMatrix

    @property
    def input_forces(self) -> sympy.ImmutableMatrix:
        """All columns at the right side together, the constant one only if it is not zero."""
        columns = [
            self.displacement_force,
            self.velocity_force,
            self.given_force,
            self.contact_force,
            self.friction_force,
        ]
        if not self.constant_force.is_zero_matrix:
            columns.append(self.constant_force)
        return sympy.ImmutableMatrix.hstack(*columns)


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


@lru_cache(maxsize=KEPT)
def force_balances(mechanism: Mechanism) -> tuple[sympy.Expr, ...]:
    """Return what must be zero for each body, expanded, N, in the order of the bodies.

    It is the Euler-Lagrange expression less the generalised force of contacts, frictions and given forces.
    """
    energy, dissipation = lagrangian(mechanism), rayleigh_function(mechanism)
    return tuple(
        sympy.expand(euler_lagrange(energy, dissipation, body.coordinate) - force)
        for body, force in zip(mechanism.bodies, generalised_forces(mechanism), strict=True)
    )


def inputs(mechanism: Mechanism) -> tuple[tuple[sympy.Expr, ...], ...]:
    """Return all that drives a mechanism, by kind, in the order of ``MotionMatrices``.

    These are the pins' displacements, m, their velocities, m/s, the given forces, the tensions of contacts
    and the dry forces of frictions, N.
    """
    displacements = tuple(pin.displacement for pin in mechanism.pins)
    return (
        displacements,
        tuple(displacement.diff(t) for displacement in displacements),
        tuple(force.value for force in mechanism.forces),
        tuple(contact.tension for contact in mechanism.contacts),
        tuple(friction.force for friction in mechanism.frictions),
    )


def accelerations(mechanism: Mechanism) -> tuple[sympy.Expr, ...]:
    """Return the acceleration of each body that follows from its Euler-Lagrange equation, m/s²."""
    return by_forces(mechanism, resultant_forces(mechanism))


def by_forces(mechanism: Mechanism, forces: tuple[sympy.Expr, ...]) -> tuple[sympy.Expr, ...]:
    """Return the accelerations, m/s², by the resultant force on each body, N."""
    found = {body.coordinate: force / body.mass for body, force in zip(mechanism.bodies, forces, strict=True)}
    on = dict(zip((body.coordinate for body in mechanism.bodies), forces, strict=True))
    for structure in mechanism.structures:
        coordinates = [body.coordinate for body in structure.bodies]
        for row, coordinate in enumerate(coordinates):
            shares = (structure.mobility[row, place] * on[each] for place, each in enumerate(coordinates))
            found[coordinate] = sympy.Add(*shares)
    return tuple(found.values())


def inverse_mass(mechanism: Mechanism) -> sympy.ImmutableMatrix:
    """Return M⁻¹ of all bodies."""
    units = sympy.eye(len(mechanism.bodies)).tolist()
    return sympy.ImmutableMatrix([by_forces(mechanism, tuple(unit)) for unit in units]).T


def inertial_forces(mechanism: Mechanism) -> tuple[sympy.Expr, ...]:
    """Return mass times acceleration of each body, N, with what a structure adds for other coordinates."""
    found = {body.coordinate: body.mass * body.coordinate.diff(t, 2) for body in mechanism.bodies}
    for structure in mechanism.structures:
        moved = structure.mass * structure.coordinates.diff(t, 2)
        found |= dict(zip((body.coordinate for body in structure.bodies), moved, strict=True))
    return tuple(found.values())


@lru_cache(maxsize=KEPT)
def resultant_forces(mechanism: Mechanism) -> tuple[sympy.Expr, ...]:
    """Return mass times acceleration of each body, from its Euler-Lagrange equation, N.

    The terms are collected, and held in the order of the thesis's equations 2.9: velocities, displacements,
    then what drives, displacements of pins first.
    """
    positions = [body.coordinate for body in mechanism.bodies]
    given = [each for kind in inputs(mechanism) for each in kind]
    variables = [*(position.diff(t) for position in positions), *positions, *given]
    return tuple(
        _collected(sympy.expand(inertial) - balance, variables)
        for inertial, balance in zip(inertial_forces(mechanism), force_balances(mechanism), strict=True)
    )


def _collected(force: sympy.Expr, variables: list[sympy.Expr]) -> sympy.Expr:
    coefficients, rest = _linear(force, variables)
    terms = (_term(coefficients[each], each) for each in variables if each in coefficients)
    kept = [term for term in (*terms, rest) if term != 0]
    return sympy.Add(*kept, evaluate=False) if kept else sympy.S.Zero


def _linear(
    expression: sympy.Expr, variables: list[sympy.Expr]
) -> tuple[dict[sympy.Expr, sympy.Expr], sympy.Expr]:
    """Return the coefficient of each variable that occurs in an expanded sum, and what is left of the sum."""
    found: dict[sympy.Expr, list[sympy.Expr]] = {}
    rest, known = [], set(variables)
    for term in sympy.Add.make_args(expression):
        factors = sympy.Mul.make_args(term)
        moved = [factor for factor in factors if factor in known]
        if len(moved) == 1:
            others = (factor for factor in factors if factor != moved[0])
            found.setdefault(moved[0], []).append(sympy.Mul(*others))
        else:
            rest.append(term)
    return {each: sympy.Add(*terms) for each, terms in found.items()}, sympy.Add(*rest)


def _term(coefficient: sympy.Expr, variable: sympy.Expr) -> sympy.Expr:
    if coefficient.could_extract_minus_sign():
        return sympy.Mul(-1, -coefficient, variable)
    return coefficient * variable


def motion_matrices(mechanism: Mechanism) -> MotionMatrices:
    """Return the matrices of the linear equations of motion, from derivatives of the force balances.

    Raises:
        ValueError: if the equations of motion are not linear in coordinates and inputs.
    """
    positions = [body.coordinate for body in mechanism.bodies]
    rates = [position.diff(t) for position in positions]
    second_rates = [position.diff(t, 2) for position in positions]
    kinds = [second_rates, rates, positions, *map(list, inputs(mechanism))]
    variables = [each for kind in kinds for each in kind]
    balances = [_linear(balance, variables) for balance in force_balances(mechanism)]
    constant = sympy.ImmutableMatrix([-rest for _, rest in balances])
    if constant.has(t):
        raise ValueError("the equations of motion are not linear in the coordinates and the inputs")
    mass, damping, stiffness, displacement, velocity, given, contact, friction = (
        _jacobian([coefficients for coefficients, _ in balances], kind) for kind in kinds
    )
    return MotionMatrices(
        mass, damping, stiffness, -displacement, -velocity, -given, -contact, -friction, constant
    )


def _jacobian(
    coefficients: list[dict[sympy.Expr, sympy.Expr]], variables: list[sympy.Expr]
) -> sympy.ImmutableMatrix:
    return sympy.ImmutableMatrix(
        len(coefficients),
        len(variables),
        lambda row, column: coefficients[row].get(variables[column], sympy.S.Zero),
    )
