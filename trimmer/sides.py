"""How small distances from a motion grow to either side of it: alike, unless the motion rests on an edge.

The motion itself is asked: it is followed from a little to each side. What differs at two distances is no
curvature.
"""

from collections.abc import Callable
from dataclasses import dataclass

import numpy as np

from trimmer.arrays import Reals
from trimmer.kept_property import cached_property

DISTANCES = (1e-7, 1e-9)
"""How far from an orbit neighbours begin, as shares of the sizes; what differs at both is no curvature."""
DIFFERENT = 1e-3
"""Difference of the growth of distances to either side, relative to it, that no rounding makes."""
SEED = 5  # Of the direction in which a neighbour is tried first


@dataclass(frozen=True, eq=False)
class Sides:
    """What is beside a motion."""

    # Where a motion ends, as shares of the sizes, (n,), that begins so far beside this one, as shares too,
    # (n,); None if it cannot be followed
    end: Callable[[Reals], Reals | None]
    count: int  # n

    @cached_property
    def _own(self) -> Reals | None:
        return self.end(np.zeros(self.count))

    def grown(self, direction: Reals, distance: float) -> tuple[Reals | None, Reals | None]:
        """Return what becomes of a distance to one side and to the other, over it, both (n,)."""
        ahead, behind, own = self.end(distance * direction), self.end(-distance * direction), self._own
        if ahead is None or behind is None or own is None:
            return None, None
        return (ahead - own) / distance, (own - behind) / distance

    @cached_property
    def differ(self) -> bool:
        """Whether distances to either side grow to different ones; what cannot be followed does not."""
        generator = np.random.default_rng(SEED)
        # Of both signs: in one in which two like bodies move alike, what parts them is hardly seen.
        direction = generator.uniform(0.5, 1.0, self.count) * generator.choice([-1.0, 1.0], self.count)
        return all(_differ(*self.grown(direction, distance)) for distance in DISTANCES)


def _differ(one: Reals | None, other: Reals | None) -> bool:
    if one is None or other is None:
        return False
    return bool(abs(one - other).max() > DIFFERENT * max(float(abs(one).max()), float(abs(other).max()), 1.0))
