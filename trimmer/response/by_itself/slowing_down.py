"""A motion that slows down for ever, as a load that nothing damps does in its gap.

It never rests nor repeats. It crosses the gap freely, and each contact leaves it a like share of its speed.
So each return takes longer than that before, its speed falls as one over the time, and its kinetic energy as
one over the square of it.
"""

from __future__ import annotations

from collections import Counter
from collections.abc import Iterable, Sequence
from typing import TypeAlias

import numpy as np

from trimmer.arrays import Reals
from trimmer.motion.course import Course
from trimmer.response.results.response import SlowingDown

ALIKE = 0.05  # Share by which what returns cross, speed times duration, may differ
LONGER = 4.0  # By what factor the last return has to be longer than the first of them
LEAST = 1  # Returns between these, at least
FREELY = 0.05  # Share by which a speed may change between two events

Crossing: TypeAlias = "tuple[tuple[int, int], float, float]"
"""Mode and function of an event, when it comes, s, and at which rate."""


def slowing_down(courses: Iterable[Course]) -> SlowingDown | None:
    """Return how a motion that nothing but samples drives slows down; None if it was not seen to.

    Args:
        courses: The motion, in stretches that follow each other; at least one.
    """
    crossings, begin = list[Crossing](), 0.0
    for course in courses:
        log, ends = course.log, course.segment_ends
        for row in np.flatnonzero(log.function[1:] >= 0) + 1:
            mode = course.modes[int(log.mode[row - 1])]
            function = mode.functions[int(log.function[row])]
            rate = float(abs(function.row @ mode.flow @ ends[row - 1]))
            crossings.append(((int(log.mode[row - 1]), int(log.function[row])), begin + log.start[row], rate))
        begin += course.duration
    if not crossings or not _moves_freely(course):
        return None
    ends_of_modes = [((mode, 0), time, rate) for (mode, _), time, rate in crossings]
    return _returning(crossings) or _returning(ends_of_modes)


def _returning(crossings: Sequence[Crossing]) -> SlowingDown | None:
    """Return how what comes most often of late, an event or the end of a mode, comes ever later."""
    ((often, _),) = Counter(each for each, *_ in crossings[len(crossings) // 2 :]).most_common(1)
    times, speeds = np.array([seen for each, *seen in crossings if each == often]).T
    return _seen(np.diff(times), speeds[1:])


def _seen(lasted: Reals, speeds: Reals) -> SlowingDown | None:
    """Return how returns become longer that last so long, s, and end at such speeds, (n,) each."""
    crossed = lasted * speeds
    like = (abs(crossed - crossed[-1:]) <= ALIKE * crossed[-1:]) & (np.diff(lasted, prepend=0.0) > 0)
    count = int(np.argmin(np.append(like[::-1], False)))
    run = lasted[len(lasted) - count :]
    old = np.flatnonzero(run[-1:] >= LONGER * run[: -1 - LEAST])
    if not len(old):
        return None
    run = run[old[-1] :]
    factors = run[1:] / run[:-1]
    return SlowingDown(len(run), float(factors.min()), float(factors.max()), float(run[-1]))


def _moves_freely(course: Course) -> bool:
    """Say whether nothing brakes what moves in the longest of the last segments of a motion."""
    layout, log = course.modes.system.layout, course.log
    lasted = np.diff(np.append(log.start, course.duration))
    row = len(lasted) - 1 - int(np.argmax(lasted[: -1 - 4 : -1]))
    (state,) = course.states(np.array([log.start[row] + 0.5 * lasted[row]]))
    rates = course.modes[int(log.mode[row])].flow @ state
    moving = [kind for kind in layout.rates if abs(state[kind]).any()]
    return bool(moving) and all(
        abs(rates[kind]).max() * lasted[row] <= FREELY * abs(state[kind]).max() for kind in moving
    )
