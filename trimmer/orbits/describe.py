"""The orbit of a loop from a state that returns, exactly or as its mirror image after half a period."""

from dataclasses import replace

import numpy as np

from trimmer.balance.limit_cycle import LimitCycle
from trimmer.hybrid.work import Log
from trimmer.motion.course import Course
from trimmer.orbits.periodic_orbit import NEUTRAL, PeriodicOrbit
from trimmer.response.periodic.multipliers import multipliers_of
from trimmer.response.periodic.shooting import Return, Shot

SEAM = 1e-13  # Time from the start, as a share of the period, of an event that may as well come at its end


def orbit_of_loop(problem: Return, shot: Shot, prediction: LimitCycle | None = None) -> PeriodicOrbit:
    """Return the orbit of a loop from a solved return.

    Args:
        problem: The return that was solved.
        shot: Its solution.
        prediction: The limit cycle from which it was found, if any.
    """
    course = shot.course
    multipliers = multipliers_of(shot.calm or shot)[0]
    if problem.mirrored:
        course, multipliers = problem.flow.timed(course.begin, 2.0 * shot.duration), multipliers**2
    return PeriodicOrbit(
        flow=problem.flow,
        periods=problem.periods,
        period_count=1,
        course=_with_one_seam(course),
        sizes=shot.sizes,
        multipliers=multipliers,
        residual=shot.miss,
        margins=np.full(len(multipliers), NEUTRAL),
        prediction=prediction,
    )


def _with_one_seam(course: Course) -> Course:
    """Return the motion of a period without what rounding puts at both its ends."""
    log, period = course.log, course.duration
    before = int((log.start <= SEAM * period).sum()) - 1
    if log.mode[before] != log.mode[-1]:
        return course
    log = Log._make(each[before:] for each in log)
    begin = replace(
        course.begin,
        state=log.state[0][: len(course.begin.state)],
        statuses=course.modes[int(log.mode[0])].statuses,
    )
    return replace(course, begin=begin, log=log._replace(start=np.append(0.0, log.start[1:])))
