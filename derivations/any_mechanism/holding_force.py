"""The force that keeps two ends from accelerating against each other."""

import sympy

from derivations.equations_of_motion import accelerations
from derivations.mechanism import Mechanism, elongation_rate
from derivations.parts import Friction, Wall
from derivations.symbols import t


def holding_force(
    mechanism: Mechanism, joint: Friction | Wall, force: sympy.Expr
) -> tuple[sympy.Expr, sympy.Expr | None]:
    """Return the relative acceleration by a force of 1 N, 1/kg, and the force, N, with which there is none.

    With the direction n of the joint these are n·M⁻¹n and (n·a + ẇ) / (n·M⁻¹n), a being the accelerations
    without it and ẇ those of the pins. The force is None where nothing between the ends can be moved.

    Args:
        mechanism: The mechanism.
        joint: What holds.
        force: The symbol of its force, which pulls the ends together.
    """
    motion = zip(mechanism.bodies, accelerations(mechanism), strict=True)
    change = elongation_rate(joint).diff(t).subs({each.coordinate.diff(t, 2): a for each, a in motion})
    change = sympy.expand(change)
    mobility = sympy.factor_terms(-sympy.diff(change, force))
    if mobility == 0:
        return mobility, None
    return mobility, sympy.together((change + mobility * force).expand() / mobility)
