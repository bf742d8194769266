"""Equations of motion from forces alone: the independent check on the energy method.

Each spring, damper, contact and friction acts on its two ends with equal and opposite forces; a force on a
pin acts on the body that carries it. No energy is used.
"""

from __future__ import annotations

from collections.abc import Iterator

import sympy

from derivations.algebra.identity import require_equal
from derivations.equations_of_motion import accelerations
from derivations.mechanism import Mechanism, elongation, elongation_rate
from derivations.parts import End, Joint, Pin, RigidBody


def newton_accelerations(mechanism: Mechanism) -> tuple[sympy.Expr, ...]:
    """Return the acceleration of each body as the sum of the forces on it over its mass, m/s²."""
    return tuple(sympy.expand(_force_on(body, mechanism) / body.mass) for body in mechanism.bodies)


def require_newton_euler(mechanism: Mechanism) -> None:
    """Check that Lagrange's equations and the sums of forces give the same motion.

    Raises:
        UnprovenError: naming the first body for which they differ.
    """
    ways = zip(mechanism.bodies, accelerations(mechanism), newton_accelerations(mechanism), strict=True)
    for body, energy, force in ways:
        require_equal(f"the acceleration of {body.name} by Lagrange and by Newton", energy, force)


def _force_on(body: RigidBody, mechanism: Mechanism) -> sympy.Expr:
    force = sympy.Add(*(given.value for given in mechanism.forces if given.body == body))
    for joint, tension in _tensions(mechanism):
        if _loaded_body(joint.start) == body:
            force += tension
        if _loaded_body(joint.end) == body:
            force -= tension
    return force


def _tensions(mechanism: Mechanism) -> Iterator[tuple[Joint, sympy.Expr]]:
    """Yield each joint with the force, N, by which it pulls its two ends together."""
    for spring in mechanism.springs:
        yield spring, spring.stiffness * elongation(spring)
    for damper in mechanism.resistances:
        yield damper, damper.damping * elongation_rate(damper)
    for contact in mechanism.contacts:
        yield contact, contact.tension
    for friction in mechanism.frictions:
        yield friction, friction.force


def _loaded_body(end: End) -> RigidBody | None:
    match end:
        case Pin():
            return _loaded_body(end.carrier)
        case RigidBody():
            return end
        case _:
            return None
