"""When orbits of cells, of which the states at the starts of drive periods are kept, are one."""

from __future__ import annotations

from typing import TYPE_CHECKING

import numpy as np

from trimmer.maps.settle import sizes_of

if TYPE_CHECKING:
    from trimmer.arrays import Reals

SAME = 1e-6
"""Difference of two orbits of one mechanism, relative to their sizes, below which they are one."""


def same_orbit(ours: Reals, theirs: Reals, apart: float = SAME) -> bool:
    """Return whether two orbits agree, wherever in their period they begin.

    Args:
        ours: States at the start of each drive period, (k, n).
        theirs: Those of the other orbit.
        apart: Difference that is allowed, relative to the sizes.
    """
    if ours.shape != theirs.shape:
        return False
    allowed = apart * np.maximum(sizes_of(ours), sizes_of(theirs))
    return any(
        bool((abs(np.roll(ours, turns, axis=0) - theirs) <= allowed).all()) for turns in range(len(ours))
    )
