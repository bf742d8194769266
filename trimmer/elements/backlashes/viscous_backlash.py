"""Viscous-controlled backlash: the general case, between friction- and inertia-controlled."""

from dataclasses import dataclass
from typing import final

import numpy as np

from trimmer.arrays import Reals
from trimmer.elements.arguments import require_not_negative
from trimmer.elements.backlashes.backlash import Backlash
from trimmer.elements.backlashes.backlash_motion import GAMMA_LIMITS
from trimmer.elements.small_gains import SmallGains, small_gains_of_backlash


@final
@dataclass(frozen=True)
class ViscousBacklash(Backlash):
    """Backlash in front of a load M v' + D v = 0, with gamma = omega M/D.

    Domain: gap/amplitude < (2 + gamma² (1 - exp(-π/gamma))) / sqrt(1 + gamma²), which rises from 2 to π with
    gamma; below that amplitude the load cannot be pushed in every half period. For an amplitude up to gap/2 a
    load at rest in the middle of the gap is never touched; N is that of the load that is. Source: the contact
    and separation conditions of derivations/elements/backlash.py; thesis, section 2.3.4 (equations 2.44 to
    2.47).

    Attributes:
        gap: Total clearance, > 0, in the unit of the input (m).
        time_constant: M/D, s; 0 gives friction-controlled backlash and infinity inertia-controlled.

    Raises:
        ValueError: if the gap is not positive and finite, or the time constant negative or NaN.
    """

    time_constant: float

    depends_on_frequency = True

    def __post_init__(self) -> None:
        super().__post_init__()
        require_not_negative("time_constant", self.time_constant, "s")

    def small_gains(self) -> SmallGains:
        """Tell that N is small only where gamma is, and then as with friction-controlled backlash."""
        return small_gains_of_backlash(self.time_constant)

    def gamma(self, omega: Reals) -> Reals:
        """Return omega M/D, limited to ``GAMMA_LIMITS`` where the time constant is 0 or infinite."""
        return np.asarray(np.clip(self.time_constant * omega, *GAMMA_LIMITS))
