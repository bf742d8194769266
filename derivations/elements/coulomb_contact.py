"""Coulomb friction between two bodies, as forces on them and as a term of the equations of motion.

The friction is the gradient of a dissipation function F_c |w| of the relative velocity w, as viscous forces
are of Rayleigh's function (Lurie, Analytical Mechanics, 2002, section 5.7): the force on each body is the
negative derivative by the body's own velocity.
"""

import sympy

from derivations.elements.friction import FORCE
from derivations.mechanism import Mechanism
from derivations.parts import RigidBody
from derivations.symbols import t


def relative_velocity(first: RigidBody, second: RigidBody) -> sympy.Expr:
    """Return the velocity of the first body relative to the second, m/s."""
    return first.coordinate.diff(t) - second.coordinate.diff(t)


def friction_forces(mechanism: Mechanism, first: RigidBody, second: RigidBody) -> tuple[sympy.Expr, ...]:
    """Return the force on each body of a mechanism, N, of Coulomb friction between two of them.

    Args:
        mechanism: The mechanism, whose order of bodies the result has.
        first: One of the two bodies.
        second: The other one.
    """
    rate = sympy.Dummy("w", real=True)
    slope = sympy.diff(FORCE * sympy.Abs(rate), rate).subs(rate, relative_velocity(first, second))
    share = {first: 1, second: -1}
    return tuple(-share.get(body, 0) * slope for body in mechanism.bodies)


def power(mechanism: Mechanism, forces: tuple[sympy.Expr, ...]) -> sympy.Expr:
    """Return the power that forces on the bodies (N, in their order) bring into the motion, W."""
    rates = (body.coordinate.diff(t) for body in mechanism.bodies)
    return sympy.Add(*(force * rate for force, rate in zip(forces, rates, strict=True)))
