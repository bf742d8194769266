"""The whole derivation of the linear trimmer as one record, from energies to transfer functions."""

from __future__ import annotations

from dataclasses import dataclass

import sympy

from derivations.energies import kinetic_energy, potential_energy, rayleigh_function
from derivations.equations_of_motion import MotionMatrices, accelerations, lagrangian, motion_matrices
from derivations.mechanism import Mechanism, trimmer
from derivations.newton_euler import newton_accelerations
from derivations.power_balance import PowerBalance, power_balance
from derivations.state_space import StateSpace, state_space
from derivations.transfer_function import TransferFunctions, transfer_functions


@dataclass(frozen=True)
class LinearTrimmer:
    """All that follows from the declared mechanism of n bodies.

    Attributes:
        mechanism: Bodies, springs, dampers and pin.
        kinetic_energy: T, J.
        potential_energy: U, J.
        rayleigh_function: R, half of the power dissipated, W.
        lagrangian: T - U, J.
        accelerations: Of the n bodies, from the Euler-Lagrange equations, m/s².
        newton: The same from forces alone, the independent way, m/s².
        matrices: Of the equations of motion.
        space: State space with displacement and velocity of the pin as inputs.
        transfer: Transfer functions from the pin to each body.
        power: Power balance along every motion, W.
    """

    mechanism: Mechanism
    kinetic_energy: sympy.Expr
    potential_energy: sympy.Expr
    rayleigh_function: sympy.Expr
    lagrangian: sympy.Expr
    accelerations: tuple[sympy.Expr, ...]
    newton: tuple[sympy.Expr, ...]
    matrices: MotionMatrices
    space: StateSpace
    transfer: TransferFunctions
    power: PowerBalance


def derive_linear_trimmer(mechanism: Mechanism | None = None) -> LinearTrimmer:
    """Derive the linear trimmer from its list of masses, springs and dampers.

    Args:
        mechanism: That of another trimmer with one pin; by default the thesis's.

    Raises:
        ValueError: if the equations of motion are not linear.
    """
    mechanism = mechanism or trimmer()
    matrices = motion_matrices(mechanism)
    return LinearTrimmer(
        mechanism=mechanism,
        kinetic_energy=kinetic_energy(mechanism),
        potential_energy=potential_energy(mechanism),
        rayleigh_function=rayleigh_function(mechanism),
        lagrangian=lagrangian(mechanism),
        accelerations=accelerations(mechanism),
        newton=newton_accelerations(mechanism),
        matrices=matrices,
        space=state_space(matrices),
        transfer=transfer_functions(matrices),
        power=power_balance(mechanism),
    )
