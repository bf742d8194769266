"""The law of dry friction with stick, as a statement beside the equations of motion."""

from dataclasses import dataclass

import sympy

from derivations.any_mechanism.curve_law import straight_between
from derivations.any_mechanism.holding_force import holding_force
from derivations.mechanism import Mechanism, elongation_rate
from derivations.parts import Friction


@dataclass(frozen=True)
class FrictionStatement:
    """The law of one friction."""

    friction: Friction  # The friction
    rate: sympy.Expr  # v in the velocities of bodies and pins, m/s
    sliding: sympy.Expr  # Dry force f while v is not zero, N
    held: sympy.Expr | None  # Force f that keeps v at zero, N; None where no body is free to take part
    stick: sympy.Basic  # What holds in stick: v = 0, and the force is at most the static one


def friction_statement(mechanism: Mechanism, friction: Friction) -> FrictionStatement:
    """State the law of one friction of a mechanism."""
    v, force = friction.rate, friction.force
    return FrictionStatement(
        friction,
        rate=elongation_rate(friction),
        sliding=_kinetic_force(friction) * sympy.sign(v),
        held=holding_force(mechanism, friction, friction.force)[1],
        stick=sympy.And(
            sympy.Eq(v, 0, evaluate=False), sympy.Le(sympy.Abs(force), friction.static, evaluate=False)
        ),
    )


def _kinetic_force(friction: Friction) -> sympy.Expr:
    """Return the force in sliding, N, over the speed where it has a curve."""
    if not friction.points:
        return friction.kinetic
    return straight_between(friction.points, sympy.Abs(friction.rate), level=True)
