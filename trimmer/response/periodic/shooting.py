"""Newton's method for a state that returns after some drive periods, or after an unknown period.

The sequence of events may change from step to step. A trial begins with the statuses with which the motion
before it ended; contact and stick that hold there hold for the correction too, because the derivative of the
return keeps to what is held.
"""

from __future__ import annotations

from dataclasses import dataclass, replace

import numpy as np
from scipy.linalg import lapack

from trimmer.arrays import Reals, identity, norm
from trimmer.hybrid.calm import amid_longest, is_amid
from trimmer.hybrid.stretch import Ending, Instant
from trimmer.kept_property import cached_property
from trimmer.motion.course import Course
from trimmer.motion.flow import Flow
from trimmer.motion.part import mirrored

CLOSED = 1e-10  # Miss of the return, as a share of the sizes of the states, below which it counts as closed
SETTLED = 4e-15  # Miss at which Newton's method stops, since only rounding is left
NEARLY_SETTLED = 5e-14
"""Miss at which it stops too after a step that left no more than ``FAST`` of the miss before."""
FAST = 1e-4
"""Share of the miss that a step leaves where Newton's method is at its best: what is left is rounding."""
ROUNDED = 1e-12  # Miss below which a step that does not reduce it is not shortened: it is rounding
SINGULAR = 1e-12  # Share of the largest singular value of Newton's matrix below which one is rounding
REGULAR = 1e-6  # Estimate of the inverse of its condition from which on a matrix is surely far from singular
SUMMED = 1e-4  # Share of the terms of a sum below which it is not measured by itself
SAMPLES = 16  # Instants at which a motion without events is looked at
MOST_CALM = 3  # How often an instant amid a long segment is looked for, as the motion changes
POLISHED = 40
"""Newton steps beyond the patience for what is closed: near a state that many orbits meet, each is a half."""
LATER, ALIKE = (0.31, 0.62), 1e-2
"""Shares of a period after which motions are compared again, and of the sizes by which they may differ."""
LONGEST = 4.0  # Factor by which an unknown period may grow; a longer one has lost the motion


@dataclass(frozen=True, eq=False)
class Shot:
    """A motion over the time after which it is to return."""

    course: Course  # The motion
    sizes: Reals  # Scale of each state, for comparing them, (n,)
    # The same motion from amid a long segment, where it was solved; None if it begins there
    calm: Shot | None = None
    # What the end is multiplied by, (n,), if it is to be the mirror image of the start; else None
    signs: Reals | None = None

    @cached_property
    def monodromy(self) -> Reals:
        """Derivative of the end by the start, (n, n)."""
        monodromy = self.course.monodromy
        return monodromy if self.signs is None else self.signs[:, None] * monodromy

    def goes_on_alike(self, time: float) -> bool:
        """Say whether it goes on after a time, s, as it did at its start, and does not just pass that state.

        A relay with hysteresis may be on either side there.
        """
        return self.is_like(self.course, time, time)

    def is_like(self, course: Course, time: float, length: float) -> bool:
        """Say whether a course goes from a time, s, as this one does from its start, within a length, s."""
        after = length * np.array(LATER)
        seen = (self.course.states(after), course.states(time + after))
        begun, later = (each[:, : len(self.sizes)] for each in seen)
        return bool((abs(later - begun) <= ALIKE * self.sizes).all())

    @cached_property
    def gap(self) -> Reals:
        """End less start as shares of the sizes, (n,)."""
        # What is held is exact at the start, and drifts by rounding.
        course, end = self.course, self.course.end
        extended = np.concatenate([end.state, _forcing(course, end)])
        reached = course.modes.held(course.modes.number(end.statuses), extended)[: len(end.state)]
        if self.signs is not None:
            reached = self.signs * reached
        difference: Reals = (reached - course.begin.state) / self.sizes
        return difference

    @cached_property
    def miss(self) -> float:
        """The largest modulus of them, from where it was solved."""
        if self.calm is not None:
            return self.calm.miss
        return float(abs(self.gap).max(initial=0.0))

    @property
    def duration(self) -> float:
        """Its duration, s."""
        return self.course.duration

    @property
    def rates(self) -> tuple[Reals, Reals]:
        """Rates of the states at the start and at the end, each (n,)."""
        course = self.course
        begin, end = (_rate(course, each, _forcing(course, each)) for each in (course.begin, course.end))
        return begin, end if self.signs is None else self.signs * end


def _forcing(course: Course, instant: Instant) -> Reals:
    layout = course.modes.system.layout
    forcing: Reals = layout.forcing_at(instant.phase, instant.periods * layout.period)
    return forcing


def _rate(course: Course, instant: Instant, forcing: Reals) -> Reals:
    flow = course.modes[course.modes.number(instant.statuses)].flow
    rate: Reals = (flow @ np.concatenate([instant.state, forcing]))[: len(instant.state)]
    return rate


def _shortest(matrix: Reals, right: Reals) -> Reals:
    """Solve linear equations; where they are singular to rounding, with the shortest solution.

    So of the motions that friction or a free position allows side by side, Newton's method finds the nearest.
    """
    # An estimate by elimination takes a fraction of the time, and mostly tells.
    condition = lapack.dgecon(lapack.dgetrf(matrix)[0], lapack.dlange("1", matrix))[0]
    values = None if condition > REGULAR else np.linalg.svd(matrix, compute_uv=False)
    if values is not None and values[0] * SINGULAR >= values[-1]:
        return np.asarray(np.linalg.lstsq(matrix, right, rcond=SINGULAR)[0], float)
    return np.asarray(np.linalg.solve(matrix, right), float)


@dataclass(frozen=True, eq=False)
class Return:
    """The problem of a state that returns."""

    flow: Flow  # What moves
    periods: int  # Number of drive periods after which it returns; 0 without a drive
    most_steps: int = 200_000  # Steps of one integration
    mirrored: bool = False  # Whether the state returns as its mirror image, after half of an unknown period
    alike: bool = False  # Whether only motions count that end with the statuses that they began with

    def shoot(self, instant: Instant, duration: float = 0.0, sizes: Reals | None = None) -> Shot | None:
        """Follow the motion; None if it ends before its time.

        Args:
            instant: The start.
            duration: The unknown period, s; without effect with a drive.
            sizes: Scale of each state; that of this motion if not given.
        """
        together = self.flow.modes.system.layout.recurrence
        if self.periods and (not together or self.periods % together):
            return None
        if self.periods:
            course = self.flow.course(instant, self.periods, self.most_steps * self.periods)
        else:
            course = self.flow.timed(instant, duration, self.most_steps)
        if course.ending is not Ending.REACHED_END or not np.isfinite(course.end.state).all():
            return None
        if self.alike and self.returned(course.end).statuses != course.begin.statuses:
            return None
        signs = self.flow.mirrored_states if self.mirrored else None
        return Shot(course, sizes_of(course) if sizes is None else sizes, signs=signs)

    def returned(self, end: Instant) -> Instant:
        """Return an end as the beginning of the next return."""
        if not self.mirrored:
            return end
        return replace(
            end, state=self.flow.mirrored_states * end.state, statuses=mirrored(self.flow.parts, end.statuses)
        )

    def step(self, shot: Shot) -> tuple[Reals, float]:
        """Return Newton's correction of the state, (n,), and of the duration, s.

        Raises:
            LinAlgError: if no correction can be told, as of numbers that are not finite.
        """
        matrix = shot.monodromy * shot.sizes / shot.sizes[:, None] - identity(len(shot.gap))
        if self.periods:
            return -_shortest(matrix, shot.gap) * shot.sizes, 0.0
        # The state may slide along the orbit: the correction is to be at right angles to it.
        tangent, rate = (each / shot.sizes for each in shot.rates)
        bordered = np.block([[matrix, rate[:, None]], [tangent[None], np.zeros((1, 1))]])
        if not np.isfinite(bordered).all():  # LAPACK would complain on the terminal.
            raise np.linalg.LinAlgError("the derivative of the return is not finite")
        solution = np.linalg.lstsq(bordered, -np.append(shot.gap, 0.0), rcond=1e-13)[0]
        return solution[:-1] * shot.sizes, float(solution[-1])

    def corrected(self, shot: Shot, share: float, correction: tuple[Reals, float]) -> Shot | None:
        """Follow the motion from a start that is corrected by a share of Newton's step."""
        by, longer = correction
        duration = shot.duration + share * longer
        if not self.periods and not 0 < duration <= LONGEST * shot.duration:
            return None
        begin, end = shot.course.begin, self.returned(shot.course.end)
        start = self.flow.at(begin.state + share * by, begin.phase, like=end)
        return self.shoot(start, duration, shot.sizes)


def sizes_of(course: Course) -> Reals:
    """Return the scale of each state over a motion, (n,): 1 for what does not move at all."""
    layout = course.modes.system.layout
    states = np.vstack([course.log.state[:, : layout.state_count], course.end.state])
    # Without events all may pass by zero where it begins and ends.
    if layout.measured_between or len(states) == 2:
        times = np.linspace(0.0, course.duration, SAMPLES)
        states = np.vstack([states, course.states(times)[:, : layout.state_count]])
    sizes: Reals = layout.sizes(states, course.duration)
    clockwork = course.modes.system.clockwork
    if clockwork is None:
        return sizes
    summed = clockwork.summed(course.modes, course.log.mode[0], abs(course.log.state).max(axis=0))
    found: Reals = np.maximum(sizes, SUMMED * summed[: layout.state_count])
    return found


@dataclass(frozen=True)
class Patience:
    """How long an orbit is looked for."""

    iterations: int = 40  # Number of Newton steps
    halvings: int = 10  # Halvings of a step that does not reduce the miss
    followed: int = 4  # How often the motion is followed once more where no Newton step reduces the miss


def solve(
    problem: Return,
    instant: Instant,
    duration: float = 0.0,
    patience: Patience | None = None,
    sizes: Reals | None = None,
) -> Shot | None:
    """Solve a return by Newton's method from a guess.

    Args:
        problem: What is to return.
        instant: Guess of the start.
        duration: Guess of an unknown period, s.
        patience: How long it is looked for.
        sizes: Scale of each state, (n,); that of the first motion if not given.

    Returns:
        The motion that came closest, which may be far from returning; None if none ran to its end.
    """
    patience = patience or Patience()
    first = problem.shoot(instant, duration, sizes)
    if first is None or not problem.periods:
        return _settled(problem, first, patience)
    found, shot = [first], first
    for _ in range(MOST_CALM):
        calm = _solved_from_calm(problem, shot, patience)
        if calm is None:
            break
        found.append(calm)
        if calm.miss <= CLOSED:
            return calm
        shot = calm
    last = _settled(problem, first, patience)
    return min([*found, *([] if last is None else [last])], key=lambda each: each.miss)


def returned(
    problem: Return,
    instant: Instant,
    duration: float = 0.0,
    patience: Patience | None = None,
    sizes: Reals | None = None,
) -> Shot | None:
    """Solve a return as ``solve`` does; None if what came closest does not close."""
    shot = solve(problem, instant, duration, patience, sizes)
    return None if shot is None or shot.miss > CLOSED else shot


def _solved_from_calm(problem: Return, shot: Shot, patience: Patience) -> Shot | None:
    """Solve from amid the longest segment of a motion, where no event comes to the beginning of its period.

    Returns:
        What was found, from where the motion began; None if it begins amid a long segment already, or nothing
        happens in it, or it cannot be followed.
    """
    flow, course = problem.flow, shot.course
    times, period = np.unique(course.times), course.duration
    if not len(times) or is_amid(times, period):
        return None
    later = amid_longest(times, period)
    ahead = flow.timed(course.begin, later, problem.most_steps * problem.periods)
    if ahead.ending is not Ending.REACHED_END:
        return None
    begin = flow.at(ahead.end.state, ahead.end.phase, like=ahead.end)
    found = _settled(problem, problem.shoot(begin), patience)
    if found is None:
        return None
    again = found.course.turned(period - later, course.begin.phase)
    return Shot(again, found.sizes, found)


def _settled(problem: Return, shot: Shot | None, patience: Patience) -> Shot | None:
    """Take Newton's steps from a motion as long as they bring it nearer to its return."""
    followed, before = 0, 0.0
    for step in range(patience.iterations + POLISHED):
        if shot is None or shot.miss <= SETTLED or (step >= patience.iterations and shot.miss > CLOSED):
            break
        if shot.miss <= min(NEARLY_SETTLED, FAST * before):
            break
        before = shot.miss
        following = _improved(problem, shot, patience.halvings)
        if following is None and shot.miss > CLOSED and followed < patience.followed:
            followed += 1
            following = problem.corrected(shot, 1.0, (shot.gap * shot.sizes, 0.0))
        if following is None:
            break
        shot = following
    return shot


def _improved(problem: Return, shot: Shot, halvings: int) -> Shot | None:
    """Take Newton's step, shortened as long as it does not reduce the miss; None if nothing does."""
    try:
        correction = problem.step(shot)
    except np.linalg.LinAlgError:
        return None
    size = norm(shot.gap)
    share = 1.0
    for _ in range(halvings if shot.miss > ROUNDED else 1):
        trial = problem.corrected(shot, share, correction)
        if trial is not None and norm(trial.gap) < (1.0 - 0.1 * share) * size:
            return trial
        share *= 0.5
    return None
