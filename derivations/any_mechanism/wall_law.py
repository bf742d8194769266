"""The laws of rigid walls: impact, and rest at the gap, as statements beside the equations of motion."""

from dataclasses import dataclass

import sympy

from derivations.any_mechanism.holding_force import holding_force
from derivations.equations_of_motion import accelerations
from derivations.mechanism import Mechanism, elongation
from derivations.parts import Wall
from derivations.symbols import t


@dataclass(frozen=True)
class WallStatement:
    """The law of one wall."""

    wall: Wall  # The wall
    distance: sympy.Expr  # s in the coordinates of bodies and pins, m
    mobility: sympy.Expr  # Relative acceleration of the ends by a force of 1 N between them, 1/kg: w M⁻¹ wᵀ
    impulse: sympy.Expr  # P on both ends where the gap is reached, N s, by the rate ṡ before
    changes: tuple[sympy.Expr, ...]  # By how much the velocity of each body changes, m/s
    held: sympy.Expr  # Force T with which s̈ = 0, N


def wall_statement(mechanism: Mechanism, wall: Wall) -> WallStatement:
    """State the law of one wall of a mechanism."""
    mobility, held = holding_force(mechanism, wall, wall.tension)
    assert held is not None
    impulse = (1 + wall.restitution) / mobility * wall.distance.diff(t)
    return WallStatement(
        wall,
        elongation(wall),
        mobility,
        impulse,
        tuple(sympy.diff(a, wall.tension) * impulse for a in accelerations(mechanism)),
        held,
    )
