"""Inertia-controlled backlash: the load keeps its velocity while it is not pushed."""

from dataclasses import dataclass
from typing import final

import numpy as np

from trimmer.arrays import Reals
from trimmer.elements.backlashes.backlash import Backlash
from trimmer.elements.backlashes.backlash_motion import GAMMA_LIMITS


@final
@dataclass(frozen=True)
class InertiaBacklash(Backlash):
    """Backlash in front of a load that keeps its velocity while it is not pushed (time constant M/D → ∞).

    Domain: amplitude > gap/π; below, the load cannot be pushed in every half period. For an amplitude up to
    gap/2 a load at rest in the middle of the gap is never touched; N is that of the load that is. Source:
    Gelb and Vander Velde (1968); thesis, section 2.3.4.

    Attributes:
        gap: Total clearance, > 0, in the unit of the input (m).

    Raises:
        ValueError: if the gap is not positive and finite.
    """

    def gamma(self, omega: Reals) -> Reals:
        """Return the upper one of ``GAMMA_LIMITS`` in place of infinity, for which formulas give NaN."""
        return np.full(omega.shape, GAMMA_LIMITS[1])
