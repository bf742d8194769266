"""An orbit of a branch as one that begins at another instant; see ``trimmer.hybrid.calm``."""

from __future__ import annotations

from dataclasses import dataclass
from typing import TYPE_CHECKING

if TYPE_CHECKING:
    from trimmer.arrays import Reals
    from trimmer.branches.period_maps.period_map import PeriodMap


@dataclass(frozen=True, eq=False)
class Restart:
    """An orbit as one that begins at another instant."""

    map: PeriodMap  # The map of its period from there
    state: Reals  # State there, shape (n,)
    tangent: Reals  # Which way along the branch its tangent shall point, shape (n + 1,)
