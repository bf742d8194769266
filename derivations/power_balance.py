"""Proof that the energy of a mechanism changes by the power of the pin less what the dampers dissipate."""

from __future__ import annotations

from dataclasses import dataclass

import sympy

from derivations.energies import kinetic_energy, potential_energy, rayleigh_function
from derivations.equations_of_motion import accelerations
from derivations.mechanism import Mechanism
from derivations.symbols import t


@dataclass(frozen=True)
class PowerBalance:
    """Terms of dE/dt = P − D along the equations of motion, E being the energy of a mechanism.

    Attributes:
        input_power: P, power of the pin, W.
        dissipated_power: D, power that the dampers take, W.
        residual: dE/dt − P + D, W; zero when the balance holds.
    """

    input_power: sympy.Expr
    dissipated_power: sympy.Expr
    residual: sympy.Expr

    @property
    def holds(self) -> bool:
        """Whether the balance closes and no motion whatever has negative dissipation."""
        rates = self.dissipated_power.atoms(sympy.Derivative)
        real_rates = {rate: sympy.Dummy(real=True) for rate in rates}
        return self.residual == 0 and self.dissipated_power.xreplace(real_rates).is_nonnegative is True


def power_balance(mechanism: Mechanism) -> PowerBalance:
    """Derive the power balance along every motion of a mechanism.

    The pin's power is its velocity times the force that the spring and damper on it ask for,
    u̇ (∂U/∂u + ∂R/∂u̇); the dampers take 2 R, a sum of squares with coefficients that are not negative.
    """
    potential, dissipation = potential_energy(mechanism), rayleigh_function(mechanism)
    pin = mechanism.pin.displacement
    pin_velocity = pin.diff(t)
    input_power = pin_velocity * (potential.diff(pin) + dissipation.diff(pin_velocity))
    motion = dict(
        zip((body.coordinate.diff(t, 2) for body in mechanism.bodies), accelerations(mechanism), strict=True)
    )
    energy_rate = (kinetic_energy(mechanism) + potential).diff(t).subs(motion)
    dissipated_power = sympy.Add(*(2 * term for term in sympy.Add.make_args(dissipation)))
    residual = sympy.expand(energy_rate - input_power + dissipated_power)
    return PowerBalance(input_power, dissipated_power, residual)
