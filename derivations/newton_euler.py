"""Equations of motion from forces alone: the independent check on the energy method.

Each spring, damper, contact and friction acts on its two ends with equal and opposite forces; a force on a
pin acts on what carries it, and one on a point on each of its bodies as the lever or gear there passes it on:
in proportion to its weight. No energy is used.
"""

from collections.abc import Iterator

import sympy

from derivations.algebra.identity import require_equal
from derivations.equations_of_motion import accelerations, by_forces
from derivations.mechanism import Mechanism, elongation, elongation_rate
from derivations.parts import End, Joint, Pin, Point, RigidBody
from derivations.symbols import t


def newton_accelerations(mechanism: Mechanism) -> tuple[sympy.Expr, ...]:
    """Return the acceleration of each body as the sum of the forces on it over its mass, m/s²."""
    forces = [_force_on(body, mechanism) for body in mechanism.bodies]
    for structure in mechanism.structures:
        first, coordinates = mechanism.bodies.index(structure.bodies[0]), structure.coordinates
        resisted = structure.stiffness * coordinates + structure.damping * coordinates.diff(t)
        for place, force in enumerate(resisted):
            forces[first + place] -= force
    return tuple(map(sympy.expand, by_forces(mechanism, tuple(forces))))


def require_newton_euler(mechanism: Mechanism) -> None:
    """Check that Lagrange's equations and the sums of forces give the same motion.

    Raises:
        UnprovenError: naming the first body for which they differ.
    """
    ways = zip(mechanism.bodies, accelerations(mechanism), newton_accelerations(mechanism), strict=True)
    for body, energy, force in ways:
        require_equal(f"the acceleration of {body.name} by Lagrange and by Newton", energy, force)


def _force_on(body: RigidBody, mechanism: Mechanism) -> sympy.Expr:
    force = sympy.Add(
        *(
            given.value * (_passed(given.on, body) - _passed(given.against, body))
            for given in mechanism.forces
        )
    )
    for joint, tension in _tensions(mechanism):
        force += tension * _passed(joint.start, body) - tension * _passed(joint.end, body)
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


def _passed(end: End, body: RigidBody) -> sympy.Expr:
    """Return how much of a force on an end acts on a body."""
    match end:
        case Pin():
            return _passed(end.carrier, body)
        case Point():
            return sympy.Add(*(weight for each, weight in end.weights if each == body))
        case RigidBody():
            return sympy.Integer(end == body)
        case _:
            return sympy.S.Zero
