"""The motion of a mechanism or a loop over a period, from where it begins on a branch."""

from __future__ import annotations

from collections import Counter
from collections.abc import Mapping
from dataclasses import dataclass
from typing import TYPE_CHECKING

import numpy as np

from trimmer.arrays import Integers, Reals
from trimmer.branches.period_maps.value_rate import ValueChange
from trimmer.hybrid.calm import amid_longest, is_amid
from trimmer.hybrid.stretch import Instant
from trimmer.hybrid.system import NOTHING
from trimmer.kept_property import cached_property
from trimmer.motion.course import Course
from trimmer.motion.flow import Flow
from trimmer.motion.part import Part, Phase, mirrored

if TYPE_CHECKING:
    from trimmer.branches.period_maps.driven_map import DrivenMap

SHARES = np.linspace(0.0, 1.0, 64)
"""Instants of a passage at which its size is looked at, as shares of it."""
Signature = Mapping[tuple[str, Phase], int]
"""How many phases of each kind begin in each part, by name, during a passage."""


@dataclass(frozen=True, eq=False)
class Restart:
    """An orbit of a branch as one that begins at another instant; see ``trimmer.hybrid.calm``."""

    map: DrivenMap  # The map of its period from there
    state: Reals  # State there, shape (n,)
    tangent: Reals  # Which way along the branch its tangent shall point, shape (n + 1,)


@dataclass(frozen=True, eq=False)
class DrivenPassage:
    """The motion from a state over its periods."""

    map: DrivenMap  # The map
    value: float  # Value of the number that is varied
    flow: Flow  # What moves
    begin: Instant  # The instant at which it begins
    course: Course  # The motion

    def returned(self, values: Reals) -> Reals:
        """Return what belongs to the entries of the end, (n, ...), with their signs in a mirrored map."""
        return (self.flow.mirrored_states * values.T).T if self.map.mirrored else values

    @cached_property
    def end(self) -> Reals:
        """State at the end, shape (n,)."""
        return self.returned(self.course.end.state)

    @cached_property
    def jacobian(self) -> Reals:
        """Derivative of the end by the state, all changes of phase included, n x n."""
        return self.returned(self.course.monodromy)

    @property
    def monodromy(self) -> Reals:
        """The matrix whose eigenvalues are the multipliers, n x n: that, unless the state has the period."""
        return self.jacobian

    @cached_property
    def sizes(self) -> Reals:
        """Largest magnitude of each entry at events and equal times, shape (n,), 0 for what is rounding."""
        states = self.course.states(SHARES * self.course.duration), self.course.log.state
        largest = np.maximum(*(abs(each).max(axis=0) for each in states))
        return self.flow.without_rounding(largest[: len(self.course.end.state)])

    @cached_property
    def _segments(self) -> tuple[Reals, Integers]:
        """Times at which segments begin that last, s, and the statuses in each and in the one before it.

        Of the segments at one instant, the last one is that which goes on. Before the first one comes the
        last, since orbits close, as its mirror image in a mirrored map.
        """
        log, duration = self.course.log, self.course.duration
        goes_on = np.append(log.start[1:] > log.start[:-1], log.start[-1] < duration)
        statuses = self.course.modes.tables.statuses[log.mode[goes_on]]
        before = np.concatenate([statuses[-1:], statuses[:-1]])
        if self.map.mirrored:
            before[0] = mirrored(self.flow.parts, tuple(before[0].tolist()))
        return log.start[goes_on], np.array([before, statuses])

    @cached_property
    def signature(self) -> Signature:
        """The phases that begin in it.

        What leaves half a period at its end comes in at its beginning on the other side, so that of a
        mirrored motion the sides are not told apart.
        """
        _, (before, after) = self._segments
        begun: Counter[tuple[str, Phase]] = Counter()
        columns = zip(self._parts, before.T.tolist(), after.T.tolist(), strict=True)
        for part, was, now in columns:
            begins = (part.phases.get(new) for old, new in zip(was, now, strict=True) if old != new)
            begun.update((part.name, phase) for phase in begins if phase is not None)
        return begun

    @cached_property
    def _parts(self) -> tuple[Part, ...]:
        parts = self.flow.parts
        return tuple(part.mirrored for part in parts) if self.map.mirrored else parts

    def shortest(self, part: str, phase: Phase) -> float:
        """Return how long the shortest phase of a kind lasts, or pauses, s; not finite if there is none."""
        return min(self._shortest(part, phase))

    def opens(self, part: str, phase: Phase) -> bool:
        """Say whether the shortest of them is a pause, in which a contact opens or what sticks slips."""
        lasting, pausing = self._shortest(part, phase)
        return pausing < lasting

    def _shortest(self, part: str, phase: Phase) -> tuple[float, float]:
        """Return how long the shortest phase of a kind lasts, s, and the shortest pause between them."""
        starts, (before, after) = self._segments
        number = next(place for place, each in enumerate(self._parts) if each.name == part)
        statuses = self._parts[number].statuses(phase)
        inside, was = (np.isin(each[:, number], statuses) for each in (after, before))
        changes = inside != was
        times, begins = starts[changes], inside[changes]
        lengths = np.diff(times, append=times[:1] + self.course.duration)
        lasting, pausing = (float(lengths[each].min(initial=np.inf)) for each in (begins, ~begins))
        return lasting, pausing

    @property
    def grazed(self) -> tuple[str, ...]:
        """Names of the rigid walls that are touched without speed."""
        return self.flow.grazed(self.course)

    @property
    def is_linear(self) -> bool:
        """Whether nothing but one linear mode of what nothing drives is met: a center."""
        return False

    @property
    def events(self) -> int:
        """Number of events."""
        return int(np.count_nonzero(self.course.log.kind != NOTHING))

    def strobed(self, state: Reals) -> Reals:
        """Return the state at the start of a drive period, (n,), from that at which the passage begins."""
        if not self.map.share:
            return state
        (strobed,) = self.course.states(np.array([(self.map.length - self.map.share) * self.flow.period]))
        return self.returned(strobed[: len(state)])

    def restart(self, tangent: Reals) -> Restart | None:
        """Return the orbit as one that begins amid a long segment; None if it does, or if nothing happens.

        Args:
            tangent: Direction of the branch, shape (n + 1,), in the units of the state and the value.
        """
        period, root = self.flow.period, self.map
        while root.single is not None:
            root = root.single
        times, begun = np.unique(self.course.times % (root.length * period)), self.map.share or 0.0
        share = begun
        if len(times) and not (self.map.share is not None and is_amid(times, root.length * period)):
            share = (begun + amid_longest(times, root.length * period) / period) % root.length
        if share == begun:
            self.map.begin_near(self.flow, self.course)
            return None
        ahead = share - begun if share >= begun else share - begun + self.map.length
        course = self.flow.timed(self.begin, ahead * period)
        state, moved = course.end.state, course.tangents(tangent[:-1, None])[:, 0]
        moved = moved + tangent[-1] * self.rate_of(course)
        if share < begun:
            state, moved = self.returned(state), self.returned(moved)
        return Restart(self.map.begun_at(share), state, np.append(moved, tangent[-1]))

    @cached_property
    def middle(self) -> Reals | None:
        """End of the first half, if the map was doubled, shape (n,); None otherwise."""
        if self.map.single is None:
            return None
        (state,) = self.course.states(np.array([0.5 * self.course.duration]))
        sign = self.flow.mirrored_states if self.map.single.mirrored else 1.0
        return np.asarray(sign * state[: self.flow.size])

    def rate_of(self, course: Course) -> Reals:
        """Return the derivative of the end of the motion, or of a first part of it, by the number, (n,).

        Raises:
            UnsupportedMotionError: if the neighbouring motion cannot be followed.
        """
        known = self.map.flows.slopes(self.value, self.flow)
        if known is not None:
            system, step, slopes, pace = known
            return ValueChange(course, system, step, course.duration * pace, slopes).rate()
        value, subject = self.map.neighbour(self.value)
        step, flow = value - self.value, self.flow.at_other(subject)
        scale = flow.period / self.flow.period if self.flow.period else 1.0
        if not self.flow.is_alike(flow):
            # A part appears or vanishes with the number.
            begin = flow.at(self.begin.state, self.begin.phase * scale)
            end = self.map.course(flow, begin, course.duration * scale).end
            return np.asarray((end.state - course.end.state) / step)
        return ValueChange(course, flow.modes.system, step, course.duration * (scale - 1.0) / step).rate()

    @cached_property
    def rate(self) -> Reals:
        """Derivative of the end by the number that is varied, shape (n,); errors as of ``rate_of``."""
        return self.returned(self.rate_of(self.course))
