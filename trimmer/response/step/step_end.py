"""How long a controlled mechanism is followed after a step: until it rests, or what it does swings evenly.

What hunts slowly is followed for some of its periods; what hunts without repeating until two stretches of it,
one after the other, are alike. A motion that comes to rest is followed until it does.
"""

import math
from dataclasses import dataclass, replace

import numpy as np

from trimmer.arrays import Reals
from trimmer.contact.flow import MechanismFlow
from trimmer.hybrid.stretch import Ending
from trimmer.motion.course import Course
from trimmer.motion.extremes import extremes, turning_points
from trimmer.motion.signals import along
from trimmer.motion.time_scale import time_scale
from trimmer.response.by_itself.asymptotic import asymptotic_rest
from trimmer.response.by_itself.dying_away import rest_dying_away
from trimmer.response.by_itself.slowing_down import slowing_down
from trimmer.response.periodic.orbit import Orbit
from trimmer.response.settling.solved import rest_after
from trimmer.response.without_events.rest import at_rest

STRETCHES = (5, 20, 80, 320, 1280)  # How long is followed at most, in periods of the slowest mode
CYCLES = (5, 20, 80)  # The same in periods of a cycle
MOST_EVENTS = 1500
"""Events, as far as they can be foreseen, up to which a further stretch is followed without a known cycle."""
MOST_NODES = 2_000_000
"""Instants between events, likewise: where fast modes stand beside slow ones there are many."""
ALIKE, AT_LAST = 1e-3, 0.1
"""Share by which two stretches of a motion that hunts evenly may differ in size; at the end of the wait."""
ON_CYCLE = 1e-3  # Share of its size by which a motion may still miss the cycle that it settles to
STILL = 1e-12  # Share of its largest value by which an output moves at most that has come to rest
SEEN = 1000  # Instants at which it is looked at


@dataclass(frozen=True, eq=False)
class StepEnd:
    """A motion through a step, and what an output does at its end."""

    flow: MechanismFlow  # What moves
    course: Course  # The motion
    rests: bool  # Whether it comes to rest
    # lowest, highest: Of the output at rest, in the last period of the cycle, or in the last half
    lowest: float
    highest: float
    mean: float  # Its mean there
    settled: bool  # Whether it rests, or swings evenly
    mirrored: bool = False  # Whether it swings as the mirror image of the cycle does

    @property
    def amplitude(self) -> float:
        """Half of peak to peak at the end; 0 at rest."""
        return 0.0 if self.rests else 0.5 * (self.highest - self.lowest)


def followed(
    flow: MechanismFlow, output: str, at: float, wanted: float, *, cycle: Orbit | None, rests: bool | None
) -> StepEnd:
    """Follow a motion from its start through a step until it has settled, or the wait is over.

    What comes to a known cycle too slowly for that ends after its first periods.

    Args:
        flow: What moves.
        output: The output that is looked at.
        at: Time of the step, s.
        wanted: What the output shall be at last.
        cycle: The cycle that it settles to, if that is known.
        rests: Whether it is known that it comes to rest, or that it does not; None if neither is.
    """
    unit = time_scale(flow, flow.rest())
    lengths = [each * unit for each in STRETCHES] if cycle is None else [n * cycle.period for n in CYCLES]
    ends = list[StepEnd]()
    for length in lengths:
        course = flow.timed(flow.rest(), at + length)
        reached = course.ending is Ending.REACHED_END
        if reached and cycle is None and rests is not False:
            value, limit = _at_rest(flow, course, output, unit, known=rests is True)
            if value is not None:
                return StepEnd(flow, course, True, value, value, value, settled=True)
            if limit is not None and length == lengths[-1]:
                return StepEnd(flow, course, True, limit, limit, limit, settled=False)
            rests = True if limit is not None else rests
        begin = at + 0.5 * length if cycle is None else course.duration - cycle.period
        last = length == lengths[-1] or (cycle is None and _is_much(course))
        end = _end(flow, course, output, begin, wanted, cycle, AT_LAST if last else ALIKE)
        ends.append(end)
        if last or not reached or (end.settled and not rests):
            break
    return replace(ends[0], mean=end.mean) if cycle is not None and not end.settled else end


def _is_much(course: Course) -> bool:
    """Say whether four times as long a motion would be more than is followed."""
    return 4 * len(course.events) > MOST_EVENTS or 4 * len(course.nodes.times) > MOST_NODES


def _at_rest(
    flow: MechanismFlow, course: Course, output: str, unit: float, *, known: bool
) -> tuple[float | None, float | None]:
    """Return where an output rests, None if it does not yet; and where it will, None if that is not known.

    Where rest is known to come, it is there once the output stands still; else an integral may run on, and
    tear out later what sticks.
    """
    late = read_at(flow, course, output, np.linspace(0.5, 1.0, SEEN) * course.duration)
    fading = rest_dying_away(flow, course)
    if (known or fading is not None) and float(np.ptp(late)) <= STILL * abs(late).max():
        return float(late[-1]), None
    ahead = fading or rest_after(flow, course, math.inf)
    rest = asymptotic_rest(flow, course, unit) if ahead is None else rest_after(flow, course)
    if rest is not None and rest.asymptotic:
        return rest.measures.outputs[output].mean, None
    there = rest is not None or (ahead is None and at_rest(course, unit))
    limit = None if ahead is None else ahead.measures.outputs[output].mean
    return float(late[-1]) if there else None, limit


def read_at(flow: MechanismFlow, course: Course, output: str, times: Reals) -> Reals:
    """Return an output at times that do not decrease, in its unit, (n,)."""
    return along(course, flow.outputs[output].signal, *course.at(times))


def _end(
    flow: MechanismFlow,
    course: Course,
    output: str,
    begin: float,
    wanted: float,
    cycle: Orbit | None,
    alike: float,
) -> StepEnd:
    """Return what an output does from a time on, s, beside a cycle, or by how much it is alike."""
    signal, until = flow.outputs[output].signal, course.duration
    late = course.since(begin)
    points = turning_points(late, signal)
    edges = read_at(flow, late, output, np.array([begin, 0.5 * (begin + until)]))
    spans = [points.values[(points.times >= start)] for start in (begin, 0.5 * (begin + until))]
    lowest, highest = (float(f(np.append(spans[0], edges[0]))) for f in (np.min, np.max))
    mirrored, mean = False, _mean(flow, late, output, begin)
    if cycle is None:
        first = points.values[(points.times >= begin) & (points.times <= 0.5 * (begin + until))]
        sizes = [float(np.ptp(np.append(each, edges[1]))) for each in (first, spans[1])]
        settled = min(sizes) > (1.0 - alike) * max(sizes) and slowing_down([course]) is None
        return StepEnd(flow, course, False, lowest, highest, mean, settled)
    own = np.array(extremes(cycle.course, cycle.flow.outputs[output].signal))
    apart = [abs(each - (lowest, highest)).max() for each in (own, 2 * wanted - own[::-1])]
    nearest = ON_CYCLE * np.ptp(own)
    # A cycle may be its own mirror image, of which rounding would choose either.
    settled, mirrored = min(apart) <= nearest, bool(apart[0] > nearest >= apart[1])
    if settled:
        exact = cycle.measures.outputs[output].mean
        mean = 2 * wanted - exact if mirrored else exact
    return StepEnd(flow, course, False, lowest, highest, mean, bool(settled), mirrored)


def _mean(flow: MechanismFlow, course: Course, output: str, begin: float) -> float:
    """Return the mean of an output from a time on, s, to a node of quadrature."""
    nodes = course.nodes
    late = nodes.times >= begin
    values = along(course, flow.outputs[output].signal, nodes.rows[late], nodes.states[late])
    return float(nodes.weights[late] @ values / nodes.weights[late].sum())
