"""The map of a mechanism that moves by itself: the period is a part of the state.

With x the n states of the mechanism and T its period the fixed points of (x, T) -> (x(T), T + u a · (x - x₀))
are its orbits, of which the plane a · (x - x₀) = 0 chooses the instant at which they begin; u is a time. The
plane is one across the motion, in the middle of a segment, where nothing happens.
"""

from __future__ import annotations

from dataclasses import dataclass, replace

import numpy as np
import scipy.optimize

from trimmer.arrays import Complexes, Reals
from trimmer.branches.period_maps.driven_map import DrivenMap
from trimmer.branches.period_maps.driven_passage import DrivenPassage, Restart
from trimmer.errors import UnsupportedMotionError
from trimmer.hybrid.calm import amid_longest, is_amid
from trimmer.hybrid.system import NOTHING
from trimmer.kept_property import cached_property
from trimmer.motion.course import Course
from trimmer.response.flows import flow_of

LONGEST = 4.0  # Factor by which the period may differ from that of the plane; beyond it the motion is lost
NEAR = 2.0  # Factor by which the period may differ before another plane is taken
ACROSS = 0.7  # Least cosine of the angle between the motion and the normal of the plane, else it is turned
STANDS = 1e-12  # Share of its size up to which a state moves by rounding in a period
SAMPLES = 256  # Instants of a motion between which it is to pass the plane at most once


@dataclass(frozen=True, eq=False)
class Section:
    """The plane at which orbits begin."""

    point: Reals  # A state on it, (n,)
    normal: Reals  # Across it, in one over the units of the states, (n,)
    period: float  # About that of the orbits, s

    def height(self, states: Reals) -> Reals:
        """Return how far states, (..., n), are beyond it."""
        return np.asarray((states - self.point) @ self.normal)


def section_at(course: Course, time: float, returns: int) -> Section:
    """Return the plane across a motion over some returns at a time, s."""
    count = course.modes.system.layout.state_count
    row = int(np.searchsorted(course.log.start, time, side="right")) - 1
    (extended,) = course.states(np.array([time]))
    rates = (course.modes[int(course.log.mode[row])].flow @ extended)[:count]
    sizes = _sizes(course)
    normal = rates / sizes
    return Section(extended[:count], normal / np.linalg.norm(normal) / sizes, course.duration / returns)


def _sizes(course: Course) -> Reals:
    """Return the largest modulus of each state over a motion, 1 for what does not move, (n,)."""
    states = np.vstack([course.states(np.linspace(0.0, course.duration, 64)), course.log.state])
    sizes = abs(states[:, : course.modes.system.layout.state_count]).max(axis=0)
    return np.where(sizes > 0.0, sizes, 1.0)


@dataclass(frozen=True, eq=False)
class SelfExcitedMap(DrivenMap):
    """The map of (x, T) of a mechanism without a drive.

    Attributes:
        periods: Returns after which the motion repeats; more than one where it was doubled.
        section: Where orbits begin; it is there from the first ``restart`` on.
    """

    section: Section | None = None

    @cached_property
    def size(self) -> int:
        """Number of states, the period among them."""
        return flow_of(self.subject).size + 1

    def begun_on(self, section: Section) -> SelfExcitedMap:
        """Return the map of orbits that begin on a plane."""
        single = self.single
        if isinstance(single, SelfExcitedMap):
            single = single.begun_on(section)
        return replace(self, section=section, single=single)

    def passage(self, value: float, state: Reals) -> SelfExcitedPassage:
        """Follow the motion from a state, (n + 1,), the last entry of which is the period, s.

        Raises:
            UnsupportedMotionError: if the motion cannot be followed, or the period is out of all bounds.
            MechanismError: if the number cannot have that value.
        """
        flow, period = self.flow(value), float(state[-1])
        usual = period if self.section is None else self.section.period
        if not usual / LONGEST < period < usual * LONGEST:
            raise UnsupportedMotionError(f"a period of {period:.6g} s is too far from {usual:.6g} s")
        begin, course = self.followed(flow, state[:-1], self.periods * period)
        return SelfExcitedPassage(self, value, flow, begin, course, state)

    def phases(self, value: float, state: Reals) -> list[Reals]:
        """Return the states at which an orbit passes the plane in its direction."""
        section = self.section
        if section is None:
            return [state]
        course = self.passage(value, state).course
        times = np.unique(np.append(np.linspace(0.0, course.duration, SAMPLES), course.log.start))
        size = len(state) - 1

        def height(time: float) -> float:
            return float(section.height(course.states(np.array([time]))[0, :size]))

        def root(low: float, high: float) -> float:
            # Rounding differs where the heights at many instants are computed at once.
            if height(low) >= 0.0 or height(high) <= 0.0:
                return min(low, high, key=lambda time: abs(height(time)))
            return float(scipy.optimize.brentq(height, low, high))

        heights = section.height(course.states(times)[:, :size])
        rising = np.flatnonzero((heights[:-1] < 0.0) & (heights[1:] >= 0.0))
        found = [root(float(times[at]), float(times[at + 1])) for at in rising]
        return [np.append(course.states(np.array([time]))[0, :size], state[-1]) for time in found]


@dataclass(frozen=True, eq=False)
class SelfExcitedPassage(DrivenPassage):
    """The motion of a mechanism without a drive over its period."""

    start: Reals  # State and period, (n + 1,)

    @property
    def section(self) -> Section:
        """Where orbits begin; here, if nothing else was said."""
        assert isinstance(self.map, SelfExcitedMap)
        if self.map.section is None:
            return section_at(self.course, 0.0, self.map.periods)
        return self.map.section

    @property
    def end(self) -> Reals:
        """State at the end, and the period, longer by how far the start is beyond the plane, (n + 1,)."""
        late = self.section.period * float(self.section.height(self.start[:-1]))
        return np.append(self.course.end.state, self.start[-1] + late)

    @property
    def is_linear(self) -> bool:
        """Whether it is a center of one linear mode, whose course no event changes, such as an impact."""
        return len(self.course.met[0]) == 1 and not self.events

    @cached_property
    def _change(self) -> Reals:
        """Derivative of the state at the end by that at the start, (n, n)."""
        return self.course.monodromy

    @property
    def stands(self) -> bool:
        """Whether no state changes, as where all only moves on with the frame."""
        moved = abs(self._end_rate) * self.course.duration
        return bool((moved <= STANDS * self.sizes[:-1]).all())

    @cached_property
    def _end_rate(self) -> Reals:
        course = self.course
        extended = np.concatenate([course.end.state, course.modes.system.layout.forcing_at(course.end.phase)])
        mode = course.modes[course.modes.number(course.end.statuses)]
        return np.asarray((mode.flow @ extended)[: len(course.end.state)])

    @cached_property
    def jacobian(self) -> Reals:
        """Derivative of the end by state and period, (n + 1, n + 1)."""
        section = self.section
        later = self.map.periods * self._end_rate
        return np.block([[self._change, later[:, None]], [section.period * section.normal, np.ones((1, 1))]])

    @cached_property
    def monodromy(self) -> Reals:
        """The derivative of the return to the plane, (n + 1, n + 1).

        Two of its eigenvalues are 0 in place of the 1 that belongs to a shift in time, and of the period.
        """
        normal, rate = self.section.normal, self._end_rate
        count = len(rate)
        found = np.zeros((count + 1, count + 1))
        found[:count, :count] = self._change - np.outer(rate, normal @ self._change) / (normal @ rate)
        return found

    @cached_property
    def sizes(self) -> Reals:
        """Largest magnitude of each entry, that of the period among them, (n + 1,)."""
        return np.append(_sizes(self.course), self.start[-1])

    @cached_property
    def middle(self) -> Reals | None:
        """State after half of a doubled map, and the period, (n + 1,); None otherwise."""
        middle = super().middle
        return None if middle is None else np.append(middle, self.start[-1])

    @cached_property
    def rate(self) -> Reals:
        """Derivative of the end by the number that is varied, (n + 1,); errors as of ``rate_of``."""
        return np.append(super().rate, 0.0)

    def strobed(self, state: Reals) -> Reals:
        """Return a state of the orbit and its period, (n + 1,): without a drive any is as good."""
        return state

    def restart(self, tangent: Reals) -> Restart | None:
        """Return the orbit as one that begins amid a long segment, on a plane across the motion."""
        time, map = self.better_start, self.map
        assert isinstance(map, SelfExcitedMap)
        if time == 0.0 and map.section is not None and self.slant >= ACROSS:
            longer = self.start[-1] / map.section.period
            if 1.0 / NEAR < longer < NEAR:
                return None
        section = section_at(self.course, time, map.periods)
        # Neither period nor value depend on where an orbit begins.
        ahead = np.append(np.zeros(len(section.point)), tangent[-2:])
        return Restart(map.begun_on(section), np.append(section.point, self.start[-1]), ahead)

    @property
    def halvings(self) -> int:
        """How often the events of each part halve into two like sequences, as after period doublings.

        Events on opposite sides are not alike.
        """
        log, parts = self.course.log, dict[int, list[tuple[int, int]]]()
        for row in np.flatnonzero(log.kind != NOTHING):
            part, status = int(log.part[row]), self.course.modes[int(log.mode[row])].statuses
            parts.setdefault(part, []).append((int(log.kind[row]), status[part]))
        return min(map(_halvings, parts.values()), default=0)

    @property
    def slant(self) -> float:
        """Cosine of the angle between the motion and the normal of the plane, relative to the sizes."""
        sizes = self.sizes[:-1]
        rate, normal = self._end_rate / sizes, self.section.normal * sizes
        return float(rate @ normal / (np.linalg.norm(rate) * np.linalg.norm(normal)))

    @property
    def better_start(self) -> float:
        """Time, s, at which the orbit had better begin: 0 if it does amid a segment that is long enough."""
        starts, duration = np.unique(self.course.log.start)[1:], self.course.duration
        return amid_longest(starts, duration) if len(starts) and not is_amid(starts, duration) else 0.0


def _halvings(events: list[tuple[int, int]]) -> int:
    half = len(events) // 2
    return 1 + _halvings(events[:half]) if half and events == 2 * events[:half] else 0


def with_trivial(multipliers: Complexes) -> Complexes:
    """Return the n multipliers of an orbit, the trivial 1 among them, by falling modulus.

    Args:
        multipliers: Eigenvalues of the ``monodromy`` of a passage by falling modulus, (n + 1,).
    """
    found = np.append(multipliers[:-2], 1.0)
    return found[np.argsort(-abs(found), kind="stable")]
