"""What a motion settles to within a number of drive periods, cheaply enough for thousands of cells.

Orbits are found and accepted as by ``respond``. What does not settle is not watched for as long: the last
drive periods are compared with those of a neighbour. Where their distance grows like an exponential the
motion is chaotic, where it neither grows nor shrinks and the motion keeps its size it is on a torus, and
otherwise nothing is said.
"""

from __future__ import annotations

from dataclasses import dataclass
from typing import TYPE_CHECKING

import numpy as np

from trimmer.contact.advance import Ending
from trimmer.response.response import MotionKind
from trimmer.response.settling import Settling

if TYPE_CHECKING:
    from trimmer.arrays import Reals
    from trimmer.contact.advance import Instant
    from trimmer.contact.flow import ExactFlow
    from trimmer.response.orbit import MechanismOrbit

COMPARED = 100
"""Drive periods over which a motion that has not settled is compared with a neighbour."""
APART = 1e-9
"""Distance of the neighbour at first, relative to the sizes of the states."""
SMALLEST = 1e-16
"""Distance below which nothing is left of it."""
SEPARATE = 1e-3
"""Distance from which on it no longer grows like an exponential."""
GROWN = 1e3
"""Growth of the distance that no torus has in so short a time."""
KEPT = 10.0
"""Growth or shrinkage of the distance that a torus may have."""
STEADY = 0.05
"""Share by which the swing of a torus may differ between two halves of the comparison."""
LEAST = 1e-6
"""Size of a state that hardly moves, relative to the largest, in SI units."""


@dataclass(frozen=True, eq=False)
class Settled:
    """What a motion has settled to.

    Attributes:
        kind: Kind of motion.
        periods: Drive periods that it took to know, the comparison with a neighbour included.
        end: The last instant of the motion, or that of the orbit.
        orbit: The exact orbit, if the motion is periodic.
        lyapunov: Growth of small distances per drive period, as a logarithm; None where it was not measured.
        ending: Why the motion ended before its time, if it did.
    """

    kind: MotionKind
    periods: int
    end: Instant
    orbit: MechanismOrbit | None = None
    lyapunov: float | None = None
    ending: Ending = Ending.REACHED_END


def settle(flow: ExactFlow, begin: Instant, most_periods: int) -> Settled:
    """Follow a motion until it has settled, or for a number of drive periods.

    Args:
        flow: The exact motion of the mechanism.
        begin: Where the motion begins, the start of a drive period.
        most_periods: Drive periods to wait at most.
    """
    settling = Settling(flow, begin)
    compared = min(COMPARED, most_periods)
    orbit = settling.until_settled(most_periods - compared)
    before = settling.instant
    if orbit is None and settling.ending is Ending.REACHED_END:
        orbit = settling.until_settled(most_periods)
    if orbit is not None:
        return Settled(MotionKind.PERIODIC, settling.periods, orbit.instant, orbit)
    if settling.ending is not Ending.REACHED_END:
        return Settled(MotionKind.UNDECIDED, settling.periods, settling.instant, ending=settling.ending)
    states = settling.states[-1 - compared :]
    sizes = sizes_of(states)
    neighbour = flow.strobe(flow.at(before.state + APART * sizes, like=before), compared)
    if neighbour.ending is not Ending.REACHED_END:
        return Settled(MotionKind.UNDECIDED, settling.periods, settling.instant)
    kind, exponent = _compared(states, neighbour.states, sizes)
    return Settled(kind, settling.periods, settling.instant, lyapunov=exponent)


def sizes_of(states: Reals) -> Reals:
    """Return how large each state becomes, (n,); what hardly moves is measured by the others.

    Args:
        states: At the starts of drive periods, (periods, n).
    """
    sizes = abs(states).max(axis=0)
    return np.asarray(np.maximum(sizes, max(LEAST * float(sizes.max()), np.finfo(float).tiny)))


def _compared(states: Reals, beside: Reals, sizes: Reals) -> tuple[MotionKind, float | None]:
    """Return the kind of a motion that has not settled, and the growth of its distance per period."""
    distances = np.maximum((abs(beside - states) / sizes).max(axis=1), SMALLEST)
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
