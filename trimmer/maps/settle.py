"""What a motion settles to within a number of drive periods: recurrence first, then the exact orbit.

A motion that nearly repeats is taken by Newton's method to the exact orbit near it. It has settled if that
orbit is stable and the motion goes on towards it. What does not settle is followed beside a neighbour: where
their distance grows like an exponential the motion is chaotic, where it neither grows nor shrinks and the
motion keeps its size it is on a torus, and otherwise nothing is said.
"""

from __future__ import annotations

from dataclasses import dataclass
from typing import TYPE_CHECKING

import numpy as np

from trimmer.contact.advance import Ending
from trimmer.maps.closing import ALIKE, Orbit, closed_near
from trimmer.maps.kinds import MotionKind

if TYPE_CHECKING:
    from trimmer.arrays import Reals
    from trimmer.contact.advance import Instant
    from trimmer.contact.flow import ExactFlow

FIRST_LOOK = 24
"""Drive periods after which a motion is first looked at; later looks are half as long again apart."""
RETURNING = 1e-3
"""Difference of two states, relative to their sizes, from which Newton's method begins."""
PROGRESS = 0.2
"""Share of the last difference that is worth another attempt."""
CLOSER = 10.0
"""A return counts that is at most so many times worse than the best; the shortest of them is the period."""
REPEATED = 1e-9
"""Difference below which the motion repeats itself, even where Newton's method finds no orbit."""
BESIDE = 100.0
"""Distance of motion and orbit, by the difference of two returns, up to which they belong together."""
COMPARED = 100
"""Drive periods over which a motion that has not settled is compared with a neighbour."""
APART = 1e-9
"""Distance of the neighbour at first, relative to the sizes of the states."""
SEPARATE = 1e-3
"""Distance from which on it no longer grows like an exponential."""
GROWN = 1e3
"""Growth of the distance that no torus has in so short a time."""
KEPT = 10.0
"""Growth or shrinkage of the distance that a torus may have."""
LEAST = 1e-6
"""Size of a state that hardly moves, relative to the largest, in SI units."""
STEADY = 0.05
"""Share by which the swing of a torus may differ between two halves of the comparison."""


@dataclass(frozen=True, eq=False)
class Settled:
    """What a motion has settled to.

    Attributes:
        kind: Kind of motion.
        periods: Drive periods that it took to know, comparison with a neighbour included.
        end: The last instant of the motion, or that of the orbit.
        orbit: The exact orbit, if the motion is periodic and Newton's method found it.
        period_count: Drive periods after which the motion repeats, 0 if it does not.
        lyapunov: Growth of small distances per drive period, as a logarithm; None where it was not measured.
        ending: Why the motion ended before its time, if it did.
    """

    kind: MotionKind
    periods: int
    end: Instant
    orbit: Orbit | None = None
    period_count: int = 0
    lyapunov: float | None = None
    ending: Ending = Ending.REACHED_END


def settle(flow: ExactFlow, begin: Instant, most_periods: int, most_period_count: int) -> Settled:
    """Follow a motion until it has settled, or for a number of drive periods.

    Args:
        flow: The exact motion of the mechanism.
        begin: Where the motion begins.
        most_periods: Drive periods to wait at most.
        most_period_count: Largest number of drive periods after which a motion may repeat.
    """
    states, instant, tried = begin.state[None], begin, RETURNING / PROGRESS
    compared = min(COMPARED, most_periods)
    for length in _looks(most_periods - compared):
        strobe = flow.strobe(instant, length)
        states, instant = np.concatenate([states, strobe.states[1:]]), strobe.end
        if strobe.ending is not Ending.REACHED_END:
            return Settled(MotionKind.FAILED, len(states) - 1, instant, ending=strobe.ending)
        count, difference = _recurrence(states, most_period_count)
        if difference < PROGRESS * tried:
            tried = difference
            orbit = _attracting(flow, instant, count, difference, sizes_of(states))
            if orbit is not None:
                return _on(orbit, len(states) - 1)
    return _at_last(flow, instant, states, compared, most_period_count)


def _looks(periods: int) -> list[int]:
    """Return the lengths of the parts after each of which the motion is looked at; their sum is given."""
    lengths, length = [], FIRST_LOOK
    while periods > length:
        lengths.append(length)
        periods -= length
        length += length // 2
    return [*lengths, periods] if periods > 0 else lengths


def sizes_of(states: Reals) -> Reals:
    """Return how large each state becomes, (n,); what hardly moves is measured by the others.

    Args:
        states: At the starts of drive periods, (periods, n); the last ones count.
    """
    sizes = abs(states[-2 * FIRST_LOOK :]).max(axis=0)
    return np.asarray(np.maximum(sizes, max(LEAST * float(sizes.max()), np.finfo(float).tiny)))


def _recurrence(states: Reals, most: int) -> tuple[int, float]:
    """Return after how many periods the last state nearly repeats, and how nearly, relative to sizes."""
    back = states[-2 : -2 - most : -1]
    differences = (abs(back - states[-1]) / sizes_of(states)).max(axis=1)
    good = max(CLOSER * float(differences.min()), REPEATED)
    count = int(np.flatnonzero(differences <= good)[0])
    return count + 1, float(differences[count])


def _attracting(
    flow: ExactFlow, instant: Instant, count: int, difference: float, sizes: Reals
) -> Orbit | None:
    """Return the stable orbit near a motion if the motion goes on towards it."""
    orbit = closed_near(flow, instant, count, sizes)
    if orbit is None or orbit.largest >= 1.0:
        return None
    distance = _distance(instant.state, orbit, sizes)
    if distance > max(BESIDE * difference, REPEATED):
        return None
    if distance <= REPEATED:
        return orbit
    later = flow.strobe(instant, count * -(-FIRST_LOOK // (2 * count)))
    near = later.ending is Ending.REACHED_END and _distance(later.end.state, orbit, sizes) < distance
    return orbit if near else None


def _distance(state: Reals, orbit: Orbit, sizes: Reals) -> float:
    return float((abs(state - orbit.states[0]) / sizes).max())


def _on(orbit: Orbit, periods: int) -> Settled:
    return Settled(MotionKind.PERIODIC, periods, orbit.begin, orbit, orbit.period_count)


def _at_last(flow: ExactFlow, instant: Instant, states: Reals, compared: int, most: int) -> Settled:
    """Follow a motion and its neighbour for the last periods, and say what can be said."""
    strobe = flow.strobe(instant, compared)
    whole = np.concatenate([states, strobe.states[1:]])
    done = len(whole) - 1
    if strobe.ending is not Ending.REACHED_END:
        return Settled(MotionKind.FAILED, done, strobe.end, ending=strobe.ending)
    count, difference = _recurrence(whole, most)
    sizes = sizes_of(whole)
    if difference < RETURNING:
        orbit = _attracting(flow, strobe.end, count, difference, sizes)
        if orbit is not None:
            return _on(orbit, done)
        if difference <= REPEATED:
            return Settled(MotionKind.PERIODIC, done, strobe.end, None, count)
    neighbour = flow.strobe(flow.at(instant.state + APART * sizes, like=instant), compared)
    if neighbour.ending is not Ending.REACHED_END:
        return Settled(MotionKind.UNDECIDED, done, strobe.end)
    kind, exponent = _compared(strobe.states, neighbour.states, sizes)
    return Settled(kind, done, strobe.end, lyapunov=exponent)


def _compared(states: Reals, beside: Reals, sizes: Reals) -> tuple[MotionKind, float | None]:
    """Return the kind of a motion that has not settled, and the growth of its distance per period."""
    distances = np.maximum((abs(beside - states) / sizes).max(axis=1), ALIKE * APART)
    separate = np.flatnonzero(distances > SEPARATE)
    last = int(separate[0]) if len(separate) else len(distances) - 1
    if last < 3:
        return MotionKind.UNDECIDED, None
    exponent = float(np.polyfit(np.arange(last + 1), np.log(distances[: last + 1]), 1)[0])
    growth = distances[last] / distances[0]
    if growth > GROWN and exponent * last > np.log(GROWN) / 2:
        return MotionKind.CHAOTIC, exponent
    if len(states) > COMPARED and 1 / KEPT < growth < KEPT and _is_steady(states):
        return MotionKind.TORUS, exponent
    return MotionKind.UNDECIDED, exponent


def _is_steady(states: Reals) -> bool:
    """Return whether the states swing as much in the second half as in the first."""
    half = len(states) // 2
    first, second = np.ptp(states[:half], axis=0), np.ptp(states[half:], axis=0)
    return bool((abs(first - second) <= STEADY * np.maximum(first, second)).all())


def same_orbit(ours: Reals, theirs: Reals) -> bool:
    """Return whether two orbits are one: their states at the starts of periods agree in some order of turns.

    Args:
        ours: States at the start of each drive period, (k, n).
        theirs: Those of the other orbit.
    """
    if ours.shape != theirs.shape:
        return False
    sizes = np.maximum(sizes_of(ours), sizes_of(theirs))
    return any(
        bool((abs(np.roll(ours, turns, axis=0) - theirs) <= 1e2 * ALIKE * sizes).all())
        for turns in range(len(ours))
    )
