"""The whole derivation of the linear trimmer as one record, from energies to transfer functions."""

from dataclasses import dataclass
from functools import lru_cache

import sympy

from derivations.equations_of_motion import KEPT, accelerations
from derivations.linear_motion import SymbolicMotion, linear_motion
from derivations.mechanism import Mechanism, trimmer
from derivations.newton_euler import newton_accelerations
from derivations.transfer_function import TransferFunctions, transfer_functions


@dataclass(frozen=True)
class LinearTrimmer(SymbolicMotion):
    """All that follows from the declared mechanism of n bodies and one pin: its motion, and besides these."""

    accelerations: tuple[sympy.Expr, ...]  # Of the n bodies, from the Euler-Lagrange equations, m/s²
    newton: tuple[sympy.Expr, ...]  # The same from forces alone, the independent way, m/s²
    transfer: TransferFunctions  # Transfer functions from the pin to each body


def derive_linear_trimmer(mechanism: Mechanism | None = None) -> LinearTrimmer:
    """Derive the linear trimmer from its list of masses, springs and dampers.

    Args:
        mechanism: That of another trimmer with one pin; by default the thesis's.

    Raises:
        UnprovenError: if Newton's law gives another motion, or the power balance does not close.
        ValueError: if the equations of motion are not linear.
    """
    return _derived(mechanism or trimmer())


@lru_cache(maxsize=KEPT)
def _derived(mechanism: Mechanism) -> LinearTrimmer:
    motion = linear_motion(mechanism)
    return LinearTrimmer(
        **vars(motion),
        accelerations=accelerations(motion.mechanism),
        newton=newton_accelerations(motion.mechanism),
        transfer=transfer_functions(motion.matrices),
    )
