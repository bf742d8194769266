"""Orbits that rest on an edge: the return of what is near them is linear to each side, but not the same.

So it is where a contact just touches at rest, where a force in stick stays at its limit, or where a sliding
velocity touches zero: a disturbance to one side meets an event that one to the other does not. The derivative
of the return (``trimmer.hybrid.variation``), and its eigenvalues, the multipliers, then belong to one side.
Whether what jumps between sides dies out, they do not say: two sides that are stable by themselves may be
unstable together (di Bernardo, Budd, Champneys and Kowalczyk, Piecewise-smooth Dynamical Systems, 2008).

The motion itself is asked (``trimmer.sides``): it is followed from a little to each side.
"""

from dataclasses import dataclass, replace

import numpy as np

from trimmer.arrays import Complexes, Reals
from trimmer.hybrid.stretch import Ending
from trimmer.motion.course import Course
from trimmer.motion.flow import Flow
from trimmer.sides import DIFFERENT, DISTANCES, Sides

KNOWN = 1e-4
"""Distance from 1 that differences give a multiplier: a double one is exact to the root of what each is."""


@dataclass(frozen=True, eq=False)
class Edge:
    """What is known of the other side of an orbit that rests on an edge."""

    # Multipliers of the side that ``Orbit.multipliers`` are not of, largest modulus first, (n,); None where
    # these are of neither side
    other_multipliers: Complexes | None
    trivial: int = 0  # How many of them are 1 because the motion may be shifted, in time or in place

    @property
    def growth(self) -> float | None:
        """Largest modulus to the other side but for shifts, less 1, 0 as far as is known; None if unknown."""
        if self.other_multipliers is None:
            return None
        nearest = np.argsort(abs(self.other_multipliers - 1), kind="stable")
        largest = float(abs(np.delete(self.other_multipliers, nearest[: self.trivial])).max(initial=0.0))
        return 0.0 if abs(largest - 1) < KNOWN else largest - 1

    @property
    def told(self) -> str:
        """What is known, in words."""
        begun = "it rests on an edge, so that these multipliers hold for small disturbances to one side only"
        growth = self.growth
        if growth is None:
            return f"{begun}, and those of other sides are not known"
        size = f"{1 + growth:.6g}, {'less' if growth < 0 else 'more'} than 1"
        stable = ": it is not stable there" if growth > 0 else ""
        if growth == 0:
            size = "1 as far as is known: what is beside it there stays beside it"
        return (
            f"{begun}; to the other side the largest is {size}{stable}. "
            "What becomes of a disturbance that goes from side to side is not known"
        )


def edge_of(flow: Flow, course: Course, sizes: Reals, multipliers: Complexes, trivial: int) -> Edge | None:
    """Return what is known of the other side of an orbit; None if it rests on no edge.

    Args:
        flow: The motion of the mechanism.
        course: The orbit.
        sizes: Scale of each state, (n,).
        multipliers: Those of the orbit, largest modulus first, (n,).
        trivial: How many of them are 1 because the motion may be shifted.
    """
    course = _from_the_middle(flow, course)
    beside = Sides(_Beside(flow, course, sizes).end, len(sizes))
    if not beside.differ:
        return None
    every = [beside.grown(each, DISTANCES[0]) for each in np.eye(len(sizes))]
    if any(one is None or other is None for one, other in every):
        return Edge(None)
    forward, backward = (np.array(columns).T for columns in zip(*every, strict=True))
    own: Reals = course.monodromy * sizes / sizes[:, None]
    scale = DIFFERENT * max(float(abs(own).max()), 1.0)
    ahead, behind = (abs(each - own).max(axis=0) for each in (forward, backward))
    if not (np.minimum(ahead, behind) < scale).all() or not np.isfinite([forward, backward]).all():
        return Edge(None)
    # Where one column is much smaller than another, both sides are within that: the farther one is the other.
    # Where a contact is so short that rounding decides whether it is met, the orbit may have been on either.
    near = ahead <= behind
    sides = [np.linalg.eigvals(np.where(each, forward, backward)).astype(complex) for each in (near, ~near)]
    other = max(sides, key=lambda each: float(abs(np.poly(each) - np.poly(multipliers)).max()))
    return Edge(other[np.argsort(-abs(other), kind="stable")], trivial)


def _from_the_middle(flow: Flow, course: Course) -> Course:
    """Return an orbit from the middle of its longest segment on, far from its ordinary events."""
    lasts = np.diff(np.append(course.log.start, course.duration))
    longest = int(np.argmax(lasts))
    middle = float(course.log.start[longest] + 0.5 * lasts[longest])
    if flow.period and flow.modes.system.clockwork is None:
        return course.turned(middle, (course.begin.phase + middle) % flow.period)
    return flow.timed(flow.timed(course.begin, middle).end, course.duration)


@dataclass(frozen=True, eq=False)
class _Beside:
    flow: Flow
    course: Course
    sizes: Reals

    def end(self, step: Reals) -> Reals | None:
        """Return where a motion ends that begins beside the orbit, as shares of the sizes."""
        begin, flow = self.course.begin, self.flow
        free = begin
        if step.any():
            free = replace(begin, statuses=flow.set_free(begin, step * self.sizes))
        start = flow.at(begin.state + step * self.sizes, begin.phase, like=free)
        nothing = np.zeros_like(start.zeros)
        start = replace(start, zeros=nothing if step.any() else start.zeros)
        course = flow.timed(start, self.course.duration)
        if course.ending is not Ending.REACHED_END:
            return None
        end: Reals = course.end.state / self.sizes
        return end
