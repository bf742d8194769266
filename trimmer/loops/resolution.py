"""Where a motion has become so large that double precision does not resolve a gap any more."""

from __future__ import annotations

from typing import TYPE_CHECKING

import numpy as np

from trimmer.loops.components.backlash_component import BacklashComponent

if TYPE_CHECKING:
    from trimmer.hybrid.work import Log
    from trimmer.loops.system import LoopModes

FINEST = 1e-13
"""Smallest gap over the position of its pin whose sides are told apart, about 450 units of rounding.

In random loops rounding began to repeat events at one instant with 1.4e-14.
"""


def unresolved_segment(modes: LoopModes, log: Log) -> int | None:
    """Return the first segment whose pin starts further than 1 / ``FINEST`` gaps from zero, if any.

    Beyond it the side of a gap would follow from the last bits of the position, and so from the
    processor.
    """
    backlashes = [
        (place, component.gap)
        for place, component in enumerate(modes.system.interconnection.components)
        if isinstance(component, BacklashComponent)
    ]
    first = len(log.mode)
    for number in np.unique(log.mode) if backlashes else ():
        signals = modes[int(number)].signals
        segments = np.flatnonzero(log.mode == number)
        for place, gap in backlashes:
            positions = abs(log.state[segments] @ signals[place].input)
            beyond = segments[~(FINEST * positions <= gap)]
            first = min(first, int(beyond[0]) if beyond.size else first)
    return first if first < len(log.mode) else None
