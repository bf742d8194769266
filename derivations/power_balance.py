"""Proof of where the energy of a mechanism comes from and where it goes.

It changes by the power of pins and given forces, less what dampers, frictions and contacts take.
"""

from dataclasses import dataclass, replace

import sympy

from derivations.energies import kinetic_energy, potential_energy, rayleigh_function
from derivations.equations_of_motion import inertial_forces, resultant_forces
from derivations.mechanism import Mechanism, displacement, elongation, elongation_rate
from derivations.parts import Friction, Pin, Tensioned
from derivations.symbols import t


@dataclass(frozen=True)
class PowerBalance:
    """Terms of dE/dt = P − D − S along the equations of motion, E being the energy of a mechanism."""

    input_power: sympy.Expr  # P, power of the pins and of the given forces, W
    dissipated_power: sympy.Expr  # D, power that dampers and viscous friction take, W
    # S, power that contacts, dry frictions and structures take, W; a contact may give some of it back
    contact_power: sympy.Expr
    residual: sympy.Expr  # dE/dt − P + D + S, W; zero when the balance holds

    @property
    def holds(self) -> bool:
        """Whether the balance closes and no motion whatever has negative dissipation."""
        rates = self.dissipated_power.atoms(sympy.Derivative)
        real_rates = {rate: sympy.Dummy(real=True) for rate in rates}
        return self.residual == 0 and self.dissipated_power.xreplace(real_rates).is_nonnegative is True


def power_balance(mechanism: Mechanism) -> PowerBalance:
    """Derive the power balance along every motion of a mechanism.

    A pin's power is its velocity times the force that all on it asks for, of springs and dampers
    ∂U/∂u + ∂R/∂u̇; the dampers take 2 R, a sum of squares with coefficients that are not negative. A contact
    takes T ṡ and a dry friction f v.
    """
    potential, dissipation = potential_energy(mechanism), rayleigh_function(mechanism)
    inputs = (
        *(pin.displacement.diff(t) * _pin_force(pin, mechanism) for pin in mechanism.pins),
        *(force.value * displacement(force).diff(t) for force in mechanism.forces),
    )
    input_power = sympy.Add(*inputs)
    rates = [body.coordinate.diff(t) for body in mechanism.bodies]
    # The kinetic energy changes by the power of M q̈, and that is the resultant force.
    inertial, resultant = inertial_forces(mechanism), resultant_forces(mechanism)
    kinetic_rate = kinetic_energy(mechanism).diff(t) + _power(resultant, rates) - _power(inertial, rates)
    energy_rate = kinetic_rate + potential.diff(t)
    alone = rayleigh_function(replace(mechanism, structures=()))
    dissipated_power = sympy.Add(*(2 * term for term in sympy.Add.make_args(alone)))
    contacts = (force * elongation_rate(each) for each, force in _contact_forces(mechanism))
    contact_power = sympy.Add(*contacts, *((2 * (dissipation - alone),) if mechanism.structures else ()))
    residual = sympy.expand(energy_rate - input_power + dissipated_power + contact_power)
    return PowerBalance(input_power, dissipated_power, contact_power, residual)


def _power(forces: tuple[sympy.Expr, ...], rates: list[sympy.Expr]) -> sympy.Expr:
    return sympy.Add(*(force * rate for force, rate in zip(forces, rates, strict=True)))


def _pin_force(pin: Pin, mechanism: Mechanism) -> sympy.Expr:
    """Return the force that drives a pin, N."""
    u = pin.displacement
    of_links = potential_energy(mechanism).diff(u) + rayleigh_function(mechanism).diff(u.diff(t))
    of_contacts = (force * elongation(each).diff(u) for each, force in _contact_forces(mechanism))
    return sympy.Add(of_links, *of_contacts)


def _contact_forces(mechanism: Mechanism) -> tuple[tuple[Tensioned | Friction, sympy.Expr], ...]:
    contacts = ((contact, contact.tension) for contact in mechanism.contacts)
    return (*contacts, *((friction, friction.force) for friction in mechanism.frictions))
