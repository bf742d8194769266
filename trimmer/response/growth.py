"""Whether a motion that has not settled grows without bound: in proportion to the time, or faster.

Where no event can come it is shown: a constant force meets nothing that holds or damps, or a wave of the
drive meets a free vibration that nothing damps. Else the motion is followed until it is four times as old.
What grows then as it did before, in proportion to its age, is taken to go on so.
"""

from __future__ import annotations

from itertools import pairwise
from typing import TYPE_CHECKING

import numpy as np

from trimmer.hybrid.advance import Ending

if TYPE_CHECKING:
    from collections.abc import Sequence

    from trimmer.arrays import Reals
    from trimmer.contact.flow import ExactFlow
    from trimmer.hybrid.advance import Instant

BLOCK = 32
"""Drive periods over which the size of a motion is taken."""
NEGLIGIBLE = 1e-6
"""Share of the size that a motion has within a period below which its growth is rounding."""
ROUNDING = 1e-9
"""Share of the largest eigenvalue of a matrix below which another one may be zero."""
OLDER = 4
"""Factor of its age at which it is looked at again."""
SUSPECT = 0.5
"""Share of a growth in proportion to the age from which on it is followed further."""
PROPORTIONAL = 0.75
"""Share of a growth in proportion to the age from which on it is taken for one."""


def grows(flow: ExactFlow, end: Instant, states: Reals, age: int) -> bool:
    """Say whether a motion grows in proportion to its age, or faster.

    Args:
        flow: The motion of the mechanism.
        end: The last instant that was followed.
        states: At the starts of the last drive periods, (count, n), shifted so that leaders are at 0.
        age: Drive periods since the start.
    """
    block = min(BLOCK, len(states) // 4)
    younger = age - len(states) + block
    if not block or younger < 1 or len(states) > age + 1 or is_bounded(flow):
        return False
    first, last = state_sizes(flow, states[:block]), state_sizes(flow, states[-block:])
    expected = 1 + SUSPECT * (age / younger - 1)
    course = flow.course(end, 1)
    within = flow.reduced(course.states(np.linspace(0.0, course.duration, BLOCK))[:, : flow.size])
    # Where a motion passes by zero at the start of each period, rounding grows too.
    growing = (first > 0) & (last >= expected * first) & (last > NEGLIGIBLE * state_sizes(flow, within))
    if course.ending is not Ending.REACHED_END or not growing.any():
        return False
    strobe = flow.strobe(end, (OLDER - 1) * age)
    if strobe.ending is not Ending.REACHED_END:
        return strobe.ending is Ending.DIVERGED
    later = state_sizes(flow, flow.reduced(strobe.states[-block:]))
    return bool((later[growing] >= PROPORTIONAL * OLDER * last[growing]).any())


def is_bounded(flow: ExactFlow) -> bool:
    """Say whether no motion can grow without bound: links hold and damp every displacement of the bodies.

    Contacts and friction only take energy, and periodic forces and pins bring no more than in proportion to
    the speed. So the energy falls wherever it is large, unless a pin goes on for ever.
    """
    if any(pin.velocity for pin in flow.mechanism.pins.values()):
        return False
    roots = np.sqrt([body.mass for body in flow.mechanism.bodies.values()])
    count, base = len(roots), flow.modes.system.machine.base
    for block in (slice(0, count), slice(count, 2 * count)):  # of stiffness, of damping
        resisting = -base[count : 2 * count, block] * roots[:, None] / roots
        values = np.linalg.eigvalsh(0.5 * (resisting + resisting.T))
        if values[0] <= ROUNDING * abs(values[-1]):
            return False
    return True


def grew(reached: Sequence[tuple[float, Reals]]) -> bool:
    """Say whether a motion without a drive has grown in proportion to its age each time it was looked at.

    Args:
        reached: Times, s, and sizes then, as of ``state_sizes``.
    """
    pairs = list(pairwise(reached))[1:]
    growing = [sizes >= PROPORTIONAL * (age / younger) * before for (younger, before), (age, sizes) in pairs]
    moving = reached[0][1] > 0
    return bool(growing) and bool((np.all(growing, axis=0) & moving).any())


def state_sizes(flow: ExactFlow, states: Reals) -> Reals:
    """Return the largest displacement, m, and the largest velocity, m/s, among states, (2,)."""
    count = len(flow.modes.system.layout.bodies)
    moduli = abs(states).max(axis=0)
    return np.array([moduli[:count].max(initial=0.0), moduli[count : 2 * count].max(initial=0.0)])
