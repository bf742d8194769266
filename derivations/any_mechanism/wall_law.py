"""The laws of rigid walls: impact, and rest at the gap, as statements beside the equations of motion."""

from __future__ import annotations

from dataclasses import dataclass

import sympy

from derivations.any_mechanism.holding_force import holding_force
from derivations.equations_of_motion import accelerations
from derivations.mechanism import Mechanism, elongation
from derivations.parts import Wall
from derivations.symbols import t


@dataclass(frozen=True)
class WallStatement:
    """The law of one wall.

    Attributes:
        wall: The wall.
        distance: s in the coordinates of bodies and pins, m.
        mobility: Relative acceleration of the ends by a force of 1 N between them, 1/kg: w M⁻¹ wᵀ.
        impulse: P on both ends where the gap is reached, N s, by the rate ṡ before.
        changes: By how much the velocity of each body changes, m/s.
        held: Force T with which s̈ = 0, N.
    """

    wall: Wall
    distance: sympy.Expr
    mobility: sympy.Expr
    impulse: sympy.Expr
    changes: tuple[sympy.Expr, ...]
    held: sympy.Expr


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
