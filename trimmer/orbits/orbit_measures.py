"""The impacts of a periodic motion of a loop, with the speeds at which pin and load meet."""

from collections.abc import Iterator
from dataclasses import dataclass
from typing import final

import numpy as np

from trimmer.hybrid.variation import propagator
from trimmer.loops.components.backlash_component import LOWER, UPPER, BacklashComponent
from trimmer.loops.motion import LoopMotion
from trimmer.showing.shown import ShownFields


@final
@dataclass(frozen=True)
class ImpactEvent(ShownFields):
    """A meeting of the pin with a side of its gap.

    Attributes:
        time: s, from the start of the motion.
        component: Which element, by name.
        mode: Mode of that element afterwards: the side of the gap.
        speed: How fast pin and load approach each other just before, m/s.
    """

    time: float
    component: str
    mode: str
    speed: float


def impacts(motion: LoopMotion) -> Iterator[ImpactEvent]:
    """Yield the impacts of a periodic motion over its period, in order of time.

    One at the very end of the period, which is the beginning of the next, is told at the end.
    """
    log, modes = motion.log, motion.loop.modes
    ends = np.append(log.start[1:], motion.duration)
    following = np.append(log.mode[1:], log.mode[0])
    for segment, (end, after) in enumerate(zip(ends.tolist(), following.tolist(), strict=True)):
        before, state = int(log.mode[segment]), log.state[segment]
        elapsed = end - float(log.start[segment])
        if elapsed > 0:
            state = propagator(modes, before, elapsed) @ state
        changes = zip(modes[before].statuses, modes[after].statuses, strict=True)
        for place, (left, entered) in enumerate(changes):
            component = modes.system.interconnection.components[place]
            if isinstance(component, BacklashComponent) and _is_impact(left, entered):
                mode = modes[before]
                play = mode.signals[place].input - mode.signals[place].output
                speed = abs(float(play @ mode.flow @ state))
                yield ImpactEvent(
                    end, modes.system.interconnection.labels[place], component.mode_names[entered], speed
                )


def _is_impact(left: int, entered: int) -> bool:
    return left not in (UPPER, LOWER) and entered in (UPPER, LOWER)
