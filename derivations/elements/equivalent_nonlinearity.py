"""Backlash and Coulomb friction as one nonlinearity (thesis, section 2.4), with the units of its two terms.

In figure 2.15 friction acts on the velocity v of the plant G_m, backlash on the displacement G_g v, and both
feed back into the plant. With the integrator G_g = 1/s the friction term becomes one of the displacement.
"""

from dataclasses import dataclass

import sympy

from derivations.dimensions import FORCE, LENGTH, Dimension, DimensionError, dimension_of
from derivations.elements.backlash import GAP
from derivations.elements.friction import FORCE as COULOMB
from derivations.symbols import DIMENSIONS, A, k2, omega

PLANT, FILTER, BACKLASH, FRICTION = sympy.symbols("G_m G_g N_r N_f")
STIFFNESS = FORCE / LENGTH
UNITS = DIMENSIONS | {COULOMB: FORCE, GAP: LENGTH}


def loop() -> sympy.Expr:
    """Return what is zero in a limit cycle: velocity less the plant's response to it, over the velocity."""
    velocity = sympy.Symbol("v")
    drive = -BACKLASH * FILTER * velocity - FRICTION * velocity
    return sympy.expand((velocity - PLANT * drive) / velocity)


def equivalent() -> sympy.Expr:
    """Return N_eq, for which the loop is 1 + N_eq G_m G_g (thesis, equations 2.57 and 2.58)."""
    return (loop() - 1) / (PLANT * FILTER)


def friction_term() -> sympy.Expr:
    """Return N_f/G_g for G_g = 1/s, N/m: friction at the velocity's amplitude ω A, times jω."""
    of_velocity = 4 * COULOMB / (sympy.pi * omega * A)
    return sympy.I * omega * of_velocity


@dataclass(frozen=True)
class UnitsCheck:
    """Dimensions of the two terms of the equivalent nonlinearity; None for a term that is zero."""

    backlash: Dimension | None  # Of N_r
    friction: Dimension | None  # Of N_f/G_g as it stands
    over_stiffness: Dimension | None  # Of N_f/G_g over a stiffness

    def require_sum(self) -> None:
        """Check that friction can be added to backlash over a stiffness, and not as it stands.

        Raises:
            DimensionError: if friction fits as it stands, or does not fit over a stiffness.
        """
        if self.friction == self.backlash or self.over_stiffness != self.backlash:
            raise DimensionError(
                f"backlash has dimension {self.backlash}, friction {self.friction}, over a stiffness "
                f"{self.over_stiffness}: only the last was expected to be that of backlash"
            )


def units_check(backlash: sympy.Expr) -> UnitsCheck:
    """Find the dimensions of both terms.

    Args:
        backlash: Describing function of backlash by gap and amplitude.

    Raises:
        DimensionError: if that is not consistent in its dimensions.
    """
    friction = friction_term()
    return UnitsCheck(*(dimension_of(term, UNITS) for term in (backlash, friction, friction / k2)))
