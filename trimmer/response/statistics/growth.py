"""Whether a motion that has not settled grows without bound: in proportion to the time, or faster.

Where no event can come it is shown: a constant force meets nothing that holds or damps, or a wave of the
drive meets a free vibration that nothing damps. Else the motion is followed until it is four times as old.
What grows then as it did before, in proportion to its age, is taken to go on so.
"""

from __future__ import annotations

from collections.abc import Sequence
from itertools import pairwise

import numpy as np

from trimmer.arrays import Reals
from trimmer.hybrid.stretch import Ending, Instant
from trimmer.motion.flow import Flow
from trimmer.motion.time_scale import is_brief

BLOCK = 32
"""Drive periods over which the size of a motion is taken."""
NEGLIGIBLE = 1e-6
"""Share of the size that a motion has within a period below which its growth is rounding."""
OLDER = 4
"""Factor of its age at which it is looked at again."""
SUSPECT = 0.5
"""Share of a growth in proportion to the age from which on it is followed further."""
TWICE = 2
"""Factor of the age from which on two sizes tell a growth from what swings on and on."""
PROPORTIONAL = 0.75
"""Share of a growth in proportion to the age from which on it is taken for one."""


def grows(flow: Flow, end: Instant, states: Reals, age: int) -> bool:
    """Say whether a motion grows in proportion to its age, or faster.

    Args:
        flow: The motion of the mechanism.
        end: The last instant that was followed.
        states: At the starts of the last drive periods, (count, n), shifted so that leaders are at 0.
        age: Drive periods since the start.
    """
    block = min(BLOCK, len(states) // 4)
    younger = age - len(states) + block
    if not block or younger < 1 or len(states) > age + 1:
        return False
    first, last = state_sizes(flow, states[:block]), state_sizes(flow, states[-block:])
    expected = 1 + SUSPECT * (age / younger - 1)
    growing = (first > 0) & (last >= expected * first)
    if not growing.any() or flow.is_bounded or is_brief(flow, OLDER * age * flow.period):
        return False
    course = flow.course(end, 1)
    within = flow.reduced(course.states(np.linspace(0.0, course.duration, BLOCK))[:, : flow.size])
    # Where a motion passes by zero at the start of each period, rounding grows too.
    growing &= last > NEGLIGIBLE * state_sizes(flow, within)
    if course.ending is not Ending.REACHED_END or not growing.any():
        return False
    strobe = flow.strobe(end, (OLDER - 1) * age)
    if strobe.ending is not Ending.REACHED_END:
        return strobe.ending is Ending.DIVERGED
    if not strobe.counts.any() and nears_event(flow, end, strobe.end):
        return False
    later = state_sizes(flow, flow.reduced(strobe.states[-block:]))
    return bool((later[growing] >= PROPORTIONAL * OLDER * last[growing]).any())


def nears_event(flow: Flow, begin: Instant, end: Instant) -> bool:
    """Say whether a motion came nearer to an event on its way between two instants in one mode.

    So a body drifts through a wide gap: it goes in proportion to the time, until it meets its other side.
    """
    if begin.statuses != end.statuses:
        return True
    mode, forcing = flow.modes[flow.modes.number(end.statuses)], flow.modes.system.layout.forcing_at
    first, last = (np.concatenate([each.state, forcing(each.phase)]) for each in (begin, end))
    return any(function.row @ (last - first) < 0 for function in mode.functions)


def grew(reached: Sequence[tuple[float, Reals]], at_last: bool = False) -> bool:
    """Say whether a motion without a drive has grown in proportion to its age each time it was looked at.

    Args:
        reached: Times, s, and sizes then, as of ``state_sizes``.
        at_last: Whether the last time is asked alone.
    """
    pairs = [(first, last) for first, last in list(pairwise(reached))[1:] if last[0] >= TWICE * first[0]]
    pairs = pairs[-1:] if at_last else pairs
    growing = [sizes >= PROPORTIONAL * (age / younger) * before for (younger, before), (age, sizes) in pairs]
    moving = reached[-1][1] > NEGLIGIBLE * np.max([sizes for _, sizes in reached], axis=0)
    return bool(growing) and bool((np.all(growing, axis=0) & moving).any())


def state_sizes(flow: Flow, states: Reals) -> Reals:
    """Return the largest modulus of each kind among states, (kinds,), as of displacements and velocities."""
    moduli = flow.modes.system.layout.lengths * abs(states).max(axis=0)
    return np.array([moduli[kind].max(initial=0.0) for kind in flow.modes.system.layout.kinds])
