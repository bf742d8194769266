"""Equations of motion from forces alone: the independent check on the energy method.

Each spring and damper pulls its two ends together with equal and opposite forces; a force on the pin acts
on the body that carries it. No energy is used.
"""

from __future__ import annotations

import sympy

from derivations.mechanism import (
    Damper,
    End,
    Mechanism,
    Pin,
    RigidBody,
    Spring,
    elongation,
    elongation_rate,
)


def newton_accelerations(mechanism: Mechanism) -> tuple[sympy.Expr, ...]:
    """Return the acceleration of each body as the sum of the forces on it over its mass, m/s²."""
    return tuple(sympy.expand(_force_on(body, mechanism) / body.mass) for body in mechanism.bodies)


def _force_on(body: RigidBody, mechanism: Mechanism) -> sympy.Expr:
    tensions: list[tuple[Spring | Damper, sympy.Expr]] = [
        *((spring, spring.stiffness * elongation(spring)) for spring in mechanism.springs),
        *((damper, damper.damping * elongation_rate(damper)) for damper in mechanism.dampers),
    ]
    force = sympy.Integer(0)
    for element, tension in tensions:
        if _loaded_body(element.start) == body:
            force += tension
        if _loaded_body(element.end) == body:
            force -= tension
    return force


def _loaded_body(end: End) -> RigidBody | None:
    match end:
        case Pin():
            return end.carrier
        case RigidBody():
            return end
        case _:
            return None
