"""Orbits of loops whose multipliers hold to one side only: where events coincide, or one is just touched.

What comes at one instant on the orbit comes in one order for neighbours to one side and in another for those
to the other. Mostly it makes no difference to the return (``trimmer.orbits.saltation``); where it does, the
return is linear to each side, but not the same.
"""

from __future__ import annotations

from dataclasses import dataclass
from typing import TYPE_CHECKING

import numpy as np

from trimmer.orbits.return_map import arcs, flow, follow
from trimmer.sides import Sides

if TYPE_CHECKING:
    from trimmer.arrays import Reals
    from trimmer.loops.motion import Motion
    from trimmer.loops.system import LoopModes

TOLD = (
    "events at one instant, or one that is just touched, make its return differ from side to side, so that "
    "its multipliers hold for small disturbances to one side only"
)
"""What is said of such an orbit."""


def one_sided(motion: Motion) -> bool:
    """Say whether small distances from a periodic motion grow differently to either side of it.

    Args:
        motion: The motion over one period.
    """
    modes, duration = motion.loop.modes, motion.duration
    chain = arcs(modes, motion.log, duration)
    longest = int(np.argmax([arc.duration for arc in chain]))
    arc = chain[longest]
    middle = flow(modes, arc.mode, 0.5 * arc.duration) @ arc.state
    sizes = abs(motion.log.state).max(axis=0)[: modes.system.layout.sine]
    sizes = np.where(sizes > 0.0, sizes, 1.0)
    return Sides(_Beside(modes, arc.mode, middle, duration, sizes).end, len(sizes)).differ


@dataclass(frozen=True, eq=False)
class _Beside:
    modes: LoopModes
    mode: int
    state: Reals
    duration: float
    sizes: Reals

    def end(self, step: Reals) -> Reals | None:
        """Return where a motion ends that begins beside the orbit, as shares of the sizes."""
        start = self.state.copy()
        start[: len(step)] += step * self.sizes
        # What the mode holds stays at rest; the drive and the one are no states that could be disturbed.
        start = self.modes[self.mode].hold @ start
        log = follow(self.modes, self.mode, start, self.duration)
        if log is None:
            return None
        last = arcs(self.modes, log, self.duration)[-1]
        end = flow(self.modes, last.mode, last.duration) @ last.state
        scaled: Reals = end[: len(step)] / self.sizes
        return scaled
