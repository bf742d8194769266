"""What a motion settles to within a number of drive periods, cheaply enough for thousands of cells.

Orbits are solved for and accepted as by ``respond``, but only from where the motion returns closely, since in
chaos many an attempt is in vain. A neutral one, as where friction holds a body wherever it stopped, is
accepted once the motion comes again to rounding. What does not settle is not watched for as long: the last
drive periods are compared with those of a neighbour. Where their distance grows like an exponential the
motion is chaotic, where it neither grows nor shrinks and the motion keeps its size it is on a torus, and
otherwise nothing is said.
"""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

from trimmer.arrays import Reals
from trimmer.hybrid.stretch import Ending, Instant
from trimmer.motion.flow import Flow
from trimmer.motion.time_scale import is_brief
from trimmer.response.periodic.orbit import Orbit
from trimmer.response.results.response import MotionKind
from trimmer.response.settling.recurrence import has_returned, settles_to
from trimmer.response.settling.settling import MOST_REPEATS, orbit_near
from trimmer.response.settling.solved import rest_of, solved
from trimmer.response.statistics.growth import OLDER, grows
from trimmer.response.without_events.linear_motion import LinearMotion, grows_for_ever

FIRST_LOOK = 24
"""Drive periods after which a motion is first looked at; later looks are half as long again apart."""
RETURNING = 1e-3
"""Difference of two states, relative to their sizes, from which an orbit is solved for."""
PROGRESS = 0.2
"""Share of the last difference that is worth another attempt."""
CLOSER = 10.0
"""A return counts that is at most so many times worse than the best; the shortest of them is the period."""
REPEATED = 1e-9
"""Difference that cannot be told from none."""
COMPARED = 100
"""Drive periods over which a motion that has not settled is compared with a neighbour."""
LOOK = 20
"""Of which so many at a time, until the neighbour is far from it."""
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
        orbit: The exact orbit, if the motion is periodic, or rests where a drive could move it.
        lyapunov: Growth of small distances per drive period, as a logarithm; None where it was not measured.
        ending: Why the motion ended before its time, if it did.
        linear: The motion in closed form, if it was seen that no event comes any more.
    """

    kind: MotionKind
    periods: int
    end: Instant
    orbit: Orbit | None = None
    lyapunov: float | None = None
    ending: Ending = Ending.REACHED_END
    linear: LinearMotion | None = None


def settle(flow: Flow, begin: Instant, most_periods: int) -> Settled:
    """Follow a motion until it has settled, or for a number of drive periods.

    Args:
        flow: What moves.
        begin: Where the motion begins, the start of a drive period.
        most_periods: Drive periods to wait at most.
    """
    compared = min(COMPARED, most_periods)
    following = _Following(flow, begin, flow.reduced(begin.state[None]), [])
    for length in _looks(most_periods - compared):
        settled = following.on(length)
        if settled is not None:
            return settled
    before = following.instant
    settled = following.on(compared)
    return settled or beside(flow, following.states, before, following.instant, compared)


def _looks(periods: int) -> list[int]:
    """Return the lengths of the parts after each of which the motion is looked at; their sum is given."""
    lengths, length = [], FIRST_LOOK
    while periods > length:
        lengths.append(length)
        periods -= length
        length += length // 2
    return [*lengths, periods] if periods > 0 else lengths


@dataclass(eq=False)
class _Following:
    """A motion that is followed.

    Attributes:
        flow: What moves.
        instant: Where it is.
        states: At the start of each drive period so far, (periods + 1, n), shifted so that leaders are at 0.
        known: Stable orbits that were found on the way.
        tried: Difference of the last return from which an orbit was solved for.
    """

    flow: Flow
    instant: Instant
    states: Reals
    known: list[Orbit]
    tried: float = RETURNING / PROGRESS

    def on(self, periods: int) -> Settled | None:
        """Go on for some drive periods; returns what the motion has settled to by then, or why it ended."""
        together = self.flow.modes.system.layout.recurrence or 1
        periods += -(self.instant.periods + periods) % together
        strobe = self.flow.strobe(self.instant, periods)
        self.instant = strobe.end
        self.states = np.concatenate([self.states, self.flow.reduced(strobe.states[1:])])
        done = len(self.states) - 1
        if strobe.ending is not Ending.REACHED_END:
            grew = strobe.ending is Ending.DIVERGED and done > 0
            kind = MotionKind.DIVERGING if grew else MotionKind.UNDECIDED
            return Settled(kind, done, self.instant, ending=strobe.ending)
        quiet = not strobe.counts[-1].any()
        held = self._solve(quiet and self.flow.modes.system.clockwork is not None and not self.known)
        if held is not None:
            return on_orbit(held, done)
        for orbit in self.known:
            if settles_to(orbit, self.states):
                return on_orbit(orbit, done)
        return self._without_events(done) if quiet else None

    def _without_events(self, done: int) -> Settled | None:
        """Return what the motion comes to if it meets no event any more."""
        found = solved(self.flow, self.instant)
        if found is None:
            grown = grows_for_ever(self.flow, self.instant)
            return Settled(MotionKind.DIVERGING, done, self.instant) if grown else None
        end = found.motion.limit if found.orbit is None else found.orbit.instant
        lyapunov = 0.0 if found.orbit is None else None
        return Settled(found.kind, done, end, found.orbit, lyapunov, linear=found.motion)

    def _solve(self, linear: bool) -> Orbit | None:
        """Solve for the orbit near the motion, if it returns closely; return a neutral one that it is on.

        Args:
            linear: Whether nothing but samples happens, so that there is one, far or near.
        """
        together = self.flow.modes.system.layout.recurrence
        if not together or len(self.states) <= together:
            return None
        alike = self.states[(len(self.states) - 1) % together :: together]
        count, difference = recurrence(alike)
        count *= together
        if difference >= PROGRESS * self.tried and not linear:
            return None
        self.tried = difference
        orbit = orbit_near(self.flow, self.instant.state, self.instant, count)
        if orbit is not None and orbit.stable:
            self.known.append(orbit)
        elif orbit is not None and orbit.neutral and has_returned(self.states, orbit.sizes, orbit.periods):
            return orbit
        return None


def on_orbit(orbit: Orbit, periods: int) -> Settled:
    """Return a motion that has settled to an orbit after some drive periods: one that repeats, or rests."""
    kind = MotionKind.PERIODIC if rest_of(orbit) is None else MotionKind.REST
    return Settled(kind, periods, orbit.instant, orbit)


def recurrence(states: Reals) -> tuple[int, float]:
    """Return after how many periods the last state nearly repeats, and how nearly, relative to sizes."""
    back = states[-2 : -2 - MOST_REPEATS : -1]
    differences = (abs(back - states[-1]) / strobed_sizes(states[-2 * MOST_REPEATS :])).max(axis=1)
    good = max(CLOSER * float(differences.min()), REPEATED)
    count = int(np.flatnonzero(differences <= good)[0])
    return count + 1, float(differences[count])


def beside(flow: Flow, every: Reals, begin: Instant, end: Instant, compared: int, before: int = 0) -> Settled:
    """Follow a neighbour over the last drive periods of a motion, and say what can be said.

    Args:
        flow: What moves.
        every: Its states at the start of each drive period, (periods + 1, n); leaders are at 0.
        begin: Where the last periods begin.
        end: Where they end.
        compared: Their number.
        before: Drive periods that it went on before, with other numbers.
    """
    periods, states = len(every) - 1, every[-1 - compared :]
    sizes = strobed_sizes(states)
    distances = _distances(flow, flow.at(begin.state + APART * sizes, like=begin), states, sizes)
    if distances is None:
        return Settled(MotionKind.UNDECIDED, periods, end)
    kind, exponent = _compared(states, distances)
    if grows(flow, end, states, before + periods):
        return Settled(MotionKind.DIVERGING, OLDER * (before + periods), end)
    if kind is MotionKind.TORUS and is_brief(flow, periods * flow.period):
        kind = MotionKind.UNDECIDED
    follows = exponent is not None and exponent < 0 and not flow.modes.system.layout.recurrence
    if follows and kind is MotionKind.UNDECIDED:
        kind = MotionKind.TORUS
    return Settled(kind, periods, end, lyapunov=exponent)


def strobed_sizes(states: Reals) -> Reals:
    """Return how large each state becomes, (n,); what hardly moves is measured by the others.

    Args:
        states: At the starts of drive periods, (periods, n).
    """
    sizes = abs(states).max(axis=0)
    return np.asarray(np.maximum(sizes, max(LEAST * float(sizes.max()), np.finfo(float).tiny)))


def _distances(flow: Flow, beside: Instant, states: Reals, sizes: Reals) -> Reals | None:
    """Return how far a neighbour is from a motion at the start of each drive period, relative to the sizes.

    Args:
        flow: What moves.
        beside: Where the neighbour begins.
        states: The motion at the start of each drive period, (count, n).
        sizes: Scale of each state, (n,).

    Returns:
        The distances up to the first one from which they do not grow like an exponential any more, or all,
        (count,) at most; None if the neighbour cannot be followed so far.
    """
    found = np.full(len(states), APART)
    for first in range(0, len(states) - 1, LOOK):
        last = min(first + LOOK, len(states) - 1)
        strobe = flow.strobe(beside, last - first)
        if strobe.ending is not Ending.REACHED_END:
            return None
        apart = abs(flow.reduced(strobe.states) - states[first : last + 1]) / sizes
        found[first : last + 1] = np.maximum(apart.max(axis=1), SMALLEST)
        separate = np.flatnonzero(found[: last + 1] > SEPARATE)
        if len(separate):
            return np.asarray(found[: int(separate[0]) + 1])
        beside = strobe.end
    return found


def _compared(states: Reals, distances: Reals) -> tuple[MotionKind, float | None]:
    """Return the kind of a motion that has not settled, and the growth of its distance per period."""
    last = len(distances) - 1
    if last < 3:
        return MotionKind.UNDECIDED, None
    exponent = float(np.polyfit(np.arange(last + 1), np.log(distances), 1)[0])
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
