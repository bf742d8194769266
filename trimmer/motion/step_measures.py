"""How a signal follows a step: rise, overshoot, settling and error, on the exact motion.

Levels are shares of the step in the reference, not of what is reached at last. The signal is cut into pieces
in which it only rises or only falls, so that no crossing is missed and each is found as a zero.
"""

import math
from dataclasses import dataclass

import numpy as np

from trimmer.arrays import Reals
from trimmer.hybrid.nodes import sample
from trimmer.hybrid.work import Log
from trimmer.linear.extrema import polished_root
from trimmer.motion.course import Course
from trimmer.motion.extremes import TurningPoints, largest, turning_points
from trimmer.motion.signals import Signal, along

RISE = 0.1, 0.9  # Shares of the step from the first reaching of which to that of the other it rises
BAND = 0.02  # Share of the step within which the signal stays once it has settled
ROUNDING = 1e-12  # Share of the step beyond it up to which nothing overshoots


@dataclass(frozen=True)
class Step:
    """A step of a reference from 0 to its size, in the unit of the signal, at a time, s."""

    size: float
    at: float = 0.0

    def reference(self, times: Reals) -> Reals:
        """Return the reference at times, s."""
        return np.where(times >= self.at, self.size, 0.0)


@dataclass(frozen=True)
class StepMeasures:
    """How a signal follows a step. None stands for what does not happen, or for a control that is not there.

    Attributes:
        rise_time: From first reaching 10 % to first reaching 90 % of the step, s.
        overshoot: Of the largest value beyond the reference, % of the step; 0 if it stays below.
        settling_time: From the step until it stays within 2 % of the step around the reference, s.
        final_error: Reference less signal, at the end or as the mean of what it settles to, in its unit.
        largest_control: Largest modulus of what acts, in the unit of the control.
        largest_demand: The same of what is asked for before the limit.
    """

    rise_time: float | None
    overshoot: float
    settling_time: float | None
    final_error: float
    largest_control: float | None = None
    largest_demand: float | None = None


def step_measures(
    course: Course,
    output: Signal,
    step: Step,
    *,
    settled_mean: float | None = None,
    control: Signal | None = None,
    largest_demand: float | None = None,
) -> StepMeasures:
    """Return how a signal follows a step of its reference, which lies within the motion.

    The mean of the cycle that it settles to counts as its end, or else the end of the motion.
    """
    if not step.size or not 0 <= step.at < course.duration:
        raise ValueError(f"{step} must not be 0, and lie within the motion of {course.duration:g} s")
    sign = math.copysign(1.0, step.size)
    pieces = _Monotone(course, lambda mode: sign * output(mode), _from(course, output, step.at, sign))
    size = abs(step.size)
    first, last = (pieces.first_reaching(share * size) for share in RISE)
    settling = pieces.settling(size, BAND * size)
    final = sign * float(pieces.points.values[-1]) if settled_mean is None else settled_mean
    beyond = float(pieces.points.values.max()) / size - 1
    return StepMeasures(
        rise_time=None if first is None or last is None else last - first,
        overshoot=100 * beyond if beyond > ROUNDING else 0.0,
        settling_time=None if settling is None else settling - step.at,
        final_error=step.size - final,
        largest_control=None if control is None else largest(course, control),
        largest_demand=largest_demand,
    )


def _from(course: Course, signal: Signal, begin: float, sign: float) -> TurningPoints:
    """Return the turning points of a signal from an instant on, s, with the sign of the step."""
    found = turning_points(course, signal)
    later = found.times >= begin
    if later.all():
        return found._replace(values=sign * found.values)
    rows, states = course.at(np.array([begin]))
    start = TurningPoints(np.array([begin]), rows, along(course, signal, rows, states))
    kept = (each[later] for each in found)
    times, rows, values = (np.concatenate(pair) for pair in zip(start, kept, strict=True))
    return TurningPoints(times, rows, sign * values)


@dataclass(frozen=True, eq=False)
class _Monotone:
    """A signal between whose points, in each row of the log, it only rises or only falls."""

    course: Course
    signal: Signal
    points: TurningPoints

    def first_reaching(self, level: float) -> float | None:
        """Return when the signal is first as large as a level, s; None if it never is."""
        reached = np.flatnonzero(self.points.values >= level)
        return self._passing(int(reached[0]), level) if len(reached) else None

    def settling(self, reference: float, band: float) -> float | None:
        """Return when the signal last comes into a band around the reference, s; None if it is outside."""
        apart = self.points.values - reference
        outside = np.flatnonzero(abs(apart) > band)
        if not len(outside):
            return float(self.points.times[0])
        last = int(outside[-1])
        if last == len(apart) - 1:
            return None
        return self._passing(last + 1, reference + math.copysign(band, apart[last]))

    def _passing(self, place: int, level: float) -> float:
        """Return when the signal passes a level on the way to a point; by a jump, at the start of its row."""
        times, rows, values = self.points
        row = int(rows[place])
        if not place or rows[place - 1] != row:
            return float(times[place])
        tables, functional = self.course.modes.tables, self.signal(int(self.course.log.mode[row]))
        log = Log._make(each[row : row + 1] for each in self.course.log)
        side = math.copysign(1.0, values[place] - values[place - 1])

        def beyond(time: float) -> float:
            return side * (float(sample(tables, log, np.array([time]))[0] @ functional) - level)

        low, high = float(times[place - 1]), float(times[place])
        if beyond(low) >= 0:  # To rounding it is there at an end.
            return low
        return high if beyond(high) <= 0 else polished_root(beyond, low, high)
