"""Orbits that long motions settle on."""

import math
from collections import Counter
from contextlib import suppress
from dataclasses import dataclass, replace
from enum import Enum

import numpy as np

from trimmer.arrays import Reals
from trimmer.hybrid.stretch import Ending
from trimmer.hybrid.variation import propagator
from trimmer.hybrid.work import Log
from trimmer.loops import ClosedLoop, Feedback
from trimmer.loops.flow import LoopFlow
from trimmer.loops.integration import followed, instant_in
from trimmer.motion.part import mirrored as mirrored_statuses
from trimmer.orbits.describe import orbit_of_loop
from trimmer.orbits.distinct import closed, collapsed, same, shortest
from trimmer.orbits.initial_states import initial_states, quiet_time
from trimmer.orbits.periodic_orbit import PeriodicOrbit
from trimmer.orbits.search import OrbitSearch, SimulationSearch
from trimmer.progress import progress_bar
from trimmer.response.periodic.shooting import Patience, Return, Shot

FIRST_EVENTS = 128
"""Events after which the motion is first looked at; then after half as many again, and so on."""
MOST_EVENTS = 5_000  # Events of one motion
RECENT = 64  # Events at the end of a motion that show how far it swings
RETURNING = 1e-2
"""Difference of two states, relative to their sizes, below which the motion may be near an orbit."""
CLOSER = 10.0
"""A return counts that is at most so many times worse than the best one; the latest of them is the period."""
ARRIVED = 1e-8  # Difference below which the motion is on the orbit, to rounding
PATIENCE = Patience(iterations=12, halvings=8, followed=0)
"""Of Newton's method, which needs about five from so near; a spiral into a point would use up any number."""
PROGRESS = 0.2  # Share of the best difference so far that is worth another attempt
SHRUNK = 1e-7
"""Swing of all states, relative to the largest one of the motion, below which it has come to rest."""
NEAR = 0.1  # Change of state and span by Newton's method that leaves them near where they were


class MotionEnd(Enum):
    """How a motion ended."""

    SETTLED = "settled on an orbit"
    AT_REST = "came to rest"
    DIVERGED = "grew without bound"
    ACCUMULATED = "ended as its events accumulate"
    LEFT = "did none of this in time"


ENDED = {
    Ending.DIVERGED: MotionEnd.DIVERGED,
    Ending.CHATTERING: MotionEnd.ACCUMULATED,
    Ending.UNDECIDED: MotionEnd.ACCUMULATED,
    Ending.STEP_LIMIT: MotionEnd.LEFT,
}
"""How a motion ended that does not go on, by how its integration did."""


@dataclass(frozen=True)
class Turn:
    """The last period of a motion, as it seems."""

    mode: int  # Mode at an instant far from events
    state: Reals  # Extended state there
    span: float  # Duration of the period, or of half of it, s
    mirrored: bool  # Whether the state returns with its signs changed
    sizes: Reals  # Size of each entry of the state
    miss: float  # Difference of the states at both ends, relative to the sizes


def settled_orbits(
    loop: ClosedLoop | Feedback, search: OrbitSearch, known: list[PeriodicOrbit]
) -> tuple[list[PeriodicOrbit], SimulationSearch]:
    """Simulate from many initial states and find the orbits that the motions settle on or pass by.

    After two seconds a progress bar shows on a terminal; an interrupt ends the search, and what was found
    until then is returned.

    Args:
        loop: The closed loop.
        search: How many, how long.
        known: Orbits that are known already.

    Returns:
        Those that are not, and how the motions ended.
    """
    orbits, endings = list(known), Counter[MotionEnd]()
    starts = initial_states(loop, search.starts, search.seed)
    bar = progress_bar(starts, "simulate", total=search.starts)
    with suppress(KeyboardInterrupt), bar:
        for mode, state in bar:
            endings[_follow(loop, mode, state, search.steps, orbits)] += 1
    ends = [endings[each] for each in MotionEnd]
    found = SimulationSearch(sum(ends), search.seed, *[*ends, search.starts])
    return orbits[len(known) :], found


def _follow(
    loop: ClosedLoop | Feedback, mode: int, state: Reals, steps: int, orbits: list[PeriodicOrbit]
) -> MotionEnd:
    """Follow a motion until it has settled, and add the orbits that it settles on or passes by."""
    quiet, events, total, best = quiet_time(loop), FIRST_EVENTS, 0, math.inf
    widest = np.zeros(loop.modes.system.layout.order)
    while total < MOST_EVENTS and steps > 0:
        stretch = followed(loop.modes, mode, state, quiet, events, steps)
        log, total = stretch.log, total + events
        if stretch.ending is Ending.REACHED_END and log.start[-1] == 0:
            return MotionEnd.AT_REST
        if stretch.ending in ENDED:
            return ENDED[stretch.ending]
        swing = np.ptp(log.state[-RECENT:, : widest.size], axis=0)
        widest = np.maximum(widest, np.ptp(log.state[:, : widest.size], axis=0))
        if (swing <= SHRUNK * widest).all():
            return MotionEnd.AT_REST
        turn = _last_turn(loop, log)
        if turn is not None and (turn.miss < PROGRESS * best or turn.miss < ARRIVED):
            best = turn.miss
            if _settles(loop, turn, orbits):
                return MotionEnd.SETTLED
        steps -= stretch.steps
        mode, state = _quiet_state(loop, log, stretch.duration)
        events += events // 2
    return MotionEnd.LEFT


def _settles(loop: ClosedLoop | Feedback, turn: Turn, orbits: list[PeriodicOrbit]) -> bool:
    """Add the orbit near a turn, if there is one, and tell whether the motion stays there."""
    found = _polished(loop, turn)
    if found is None or collapsed(found[1], turn.sizes):
        return False
    problem, shot = found
    orbit = orbit_of_loop(*shortest(problem, shot))
    if not any(same(orbit, other) for other in orbits):
        orbits.append(orbit)
    state = shot.course.begin.state
    change = float((abs(state - turn.state[: len(state)]) / turn.sizes[: len(state)]).max())
    near = max(change, abs(shot.duration / turn.span - 1.0)) < NEAR
    return turn.miss < ARRIVED or (orbit.stable and near)


def _polished(loop: ClosedLoop | Feedback, turn: Turn) -> tuple[Return, Shot] | None:
    """Find the orbit near a turn by Newton's method; with the symmetry if it seems to have it."""
    symmetric = Return(LoopFlow(loop), 0, mirrored=True, alike=True)
    sizes = turn.sizes[: symmetric.flow.size]
    trials = [(symmetric, turn.span)] if turn.mirrored else []
    whole = 2.0 * turn.span if turn.mirrored else turn.span
    trials.append((replace(symmetric, mirrored=False), whole))
    for problem, span in trials:
        shot = closed(problem, instant_in(problem.flow.modes, turn.mode, turn.state), span, sizes, PATIENCE)
        if shot is not None:
            return problem, shot
    return None


def _last_turn(loop: ClosedLoop | Feedback, log: Log) -> Turn | None:
    """Return the last period of a motion if its end looks like its beginning."""
    lasting = np.flatnonzero(np.diff(log.start) > 0)
    if len(lasting) < 2:
        return None
    last, earlier = lasting[-1], lasting[:-1]
    free = slice(loop.modes.system.layout.sine)
    recent = log.state[lasting[-RECENT:]]
    sizes = abs(recent).max(axis=0)
    sizes[sizes == 0.0] = 1.0
    flow, state, mode = LoopFlow(loop), log.state[last], int(log.mode[last])
    image = np.append(flow.mirrored_states * state[: flow.size], state[flow.size :])
    opposite = loop.modes.number(mirrored_statuses(flow.parts, loop.modes[mode].statuses))
    returns = []
    for mirrored in (True, False):
        back = earlier[log.mode[earlier] == (opposite if mirrored else mode)]
        target = image if mirrored else state
        misses = (abs(log.state[back] - target) / sizes)[:, free].max(axis=1, initial=0.0)
        returns += [(float(miss), int(place), mirrored) for miss, place in zip(misses, back, strict=True)]
    if not returns:
        return None
    good = max(CLOSER * min(miss for miss, _, _ in returns), ARRIVED)
    if good > CLOSER * RETURNING:
        return None
    miss, place, mirrored = max((each for each in returns if each[0] <= good), key=lambda each: each[1])
    span = float(log.start[last] - log.start[place])
    inside = lasting[(lasting >= place) & (lasting < last)]
    longest = int(inside[np.argmax(log.start[inside + 1] - log.start[inside])])
    part = type(log)._make(column[: longest + 1] for column in log)
    quiet, middle = _quiet_state(loop, part, float(log.start[longest + 1]))
    return Turn(quiet, middle, span, mirrored, np.maximum(sizes, abs(middle)), miss)


def _quiet_state(loop: ClosedLoop | Feedback, log: Log, end: float) -> tuple[int, Reals]:
    """Return mode and extended state in the middle of the last segment that lasts, far from events."""
    stops = np.append(log.start[1:], end)
    last = int(np.flatnonzero(stops > log.start)[-1])
    mode = int(log.mode[last])
    half = 0.5 * float(stops[last] - log.start[last])
    return mode, propagator(loop.modes, mode, half) @ log.state[last]
