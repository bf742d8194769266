"""An orbit of a branch as one that begins at another instant; see ``trimmer.hybrid.calm``."""

from __future__ import annotations

from dataclasses import dataclass
from typing import TYPE_CHECKING

if TYPE_CHECKING:
    from trimmer.arrays import Reals
    from trimmer.branches.period_maps.period_map import PeriodMap


@dataclass(frozen=True, eq=False)
class Restart:
    """An orbit as one that begins at another instant.

    Attributes:
        map: The map of its period from there.
        state: State there, shape (n,).
        tangent: Which way along the branch its tangent shall point, shape (n + 1,).
    """

    map: PeriodMap
    state: Reals
    tangent: Reals
