"""Energies and equations of motion of any mechanism as one record, checked in two ways."""

from dataclasses import dataclass

import sympy

from derivations.algebra.identity import UnprovenError
from derivations.energies import kinetic_energy, potential_energy, rayleigh_function
from derivations.equations_of_motion import (
    MotionMatrices,
    inverse_mass,
    lagrangian,
    motion_matrices,
    resultant_forces,
)
from derivations.generalised_forces import generalised_forces
from derivations.mechanism import Mechanism
from derivations.newton_euler import require_newton_euler
from derivations.power_balance import PowerBalance, power_balance
from derivations.state_space import StateSpace, state_space


@dataclass(frozen=True)
class SymbolicMotion:
    """Energies and linear equations of motion of a mechanism, checked by Newton's law and by its power."""

    mechanism: Mechanism  # The mechanism
    kinetic_energy: sympy.Expr  # T, J
    potential_energy: sympy.Expr  # U of the springs, J
    rayleigh_function: sympy.Expr  # R of dampers and viscous frictions, half of the power that they take, W
    lagrangian: sympy.Expr  # T − U, J
    generalised_forces: tuple[sympy.Expr, ...]  # Of contacts, dry frictions and given forces on each body, N
    resultant_forces: tuple[sympy.Expr, ...]  # Mass times acceleration of each body, N
    matrices: MotionMatrices  # Of the equations of motion
    space: StateSpace  # State space
    power: PowerBalance  # Power balance along every motion, W


def linear_motion(mechanism: Mechanism) -> SymbolicMotion:
    """Derive energies and equations of motion, contacts and dry frictions being forces, and check them.

    Raises:
        UnprovenError: if Newton's law gives another motion, or the power balance does not close.
        ValueError: if the equations of motion are not linear.
    """
    matrices = motion_matrices(mechanism)
    require_newton_euler(mechanism)
    power = power_balance(mechanism)
    if not power.holds:
        raise UnprovenError(f"the power balance of the mechanism does not close: {power.residual}")
    return SymbolicMotion(
        mechanism=mechanism,
        kinetic_energy=kinetic_energy(mechanism),
        potential_energy=potential_energy(mechanism),
        rayleigh_function=rayleigh_function(mechanism),
        lagrangian=lagrangian(mechanism),
        generalised_forces=generalised_forces(mechanism),
        resultant_forces=resultant_forces(mechanism),
        matrices=matrices,
        space=state_space(matrices, inverse_mass(mechanism)),
        power=power,
    )
