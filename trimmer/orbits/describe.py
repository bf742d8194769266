"""The description of an orbit from a state that returns: amplitude, period, multipliers."""

from __future__ import annotations

from dataclasses import replace
from typing import TYPE_CHECKING

import numpy as np

from trimmer.hybrid.advance import Ending
from trimmer.hybrid.variation import propagator
from trimmer.hybrid.work import Log
from trimmer.loops.flow import LoopFlow
from trimmer.motion.flow import Course
from trimmer.orbits.periodic_orbit import NEUTRAL, PeriodicOrbit
from trimmer.orbits.return_map import follow

if TYPE_CHECKING:
    from trimmer.arrays import Complexes, Reals
    from trimmer.balance.limit_cycle import LimitCycle
    from trimmer.loops.loops import Loop
    from trimmer.orbits.shooting import Return, Shot

SEAM = 1e-13
"""Time from the start, as a share of the period, of an event that may as well come at its end."""


def orbit_of(
    loop: Loop,
    problem: Return,
    shot: Shot,
    prediction: LimitCycle | None,
    begin: tuple[int, Reals] | None = None,
) -> PeriodicOrbit:
    """Return the orbit of a state that returns.

    Args:
        loop: The loop.
        problem: The return that was solved.
        shot: Its solution.
        prediction: The limit cycle from which it was found, if any.
        begin: Mode and extended state on the orbit at which its motion begins; those of the solution if not
            given.
    """
    modes, flow = loop.modes, LoopFlow(loop)
    period = 2.0 * shot.span if problem.mirrored else shot.span
    log = follow(modes, *(begin or (shot.mode, shot.state)), period)
    assert log is not None, "half of it was followed before"
    log, count = _with_one_seam(log, period), modes.system.layout.state_count
    multipliers = _multipliers(problem, shot)
    first = flow.at(log.state[0][:count])
    start = replace(first, statuses=modes[int(log.mode[0])].statuses)
    last = propagator(modes, int(log.mode[-1]), period - float(log.start[-1])) @ log.state[-1]
    end = replace(start, state=last[:count], statuses=modes[int(log.mode[-1])].statuses)
    course = Course(modes, start, end, Ending.REACHED_END, period, log)
    driven = int(problem.driven)
    return PeriodicOrbit(
        flow=flow,
        periods=driven,
        period_count=1,
        course=replace(course, end=replace(end, periods=driven)),
        sizes=problem.sizes[:count],
        multipliers=multipliers,
        residual=shot.miss,
        margins=np.full(len(multipliers), NEUTRAL),
        prediction=prediction,
    )


def _with_one_seam(log: Log, period: float) -> Log:
    """Return the segments of a period without those before an event that rounding puts at both its ends."""
    before = 0 if log.mode[0] == log.mode[-1] else int((log.start <= SEAM * period).sum()) - 1
    if log.mode[before] != log.mode[-1]:
        return log
    log = Log._make(each[before:] for each in log)
    return log._replace(start=np.append(0.0, log.start[1:]))


def _multipliers(problem: Return, shot: Shot) -> Complexes:
    """Return the eigenvalues of the derivative of the return map, by falling modulus.

    What is left of a load's velocity follows from the time since its separation and nothing depends on it, so
    it is left out.
    """
    modes = problem.modes
    kept = [*range(modes.system.layout.order)]
    for first, component in zip(
        modes.system.layout.first_states, modes.system.interconnection.components, strict=True
    ):
        kept += range(first, first + component.state_count - component.even_states)
    sizes = problem.sizes[kept]
    values = np.linalg.eigvals(shot.slope[np.ix_(kept, kept)] * sizes / sizes[:, None])
    over_period = values**2 if problem.mirrored else values
    largest_first = np.argsort(-abs(over_period), kind="stable")
    return over_period[largest_first].astype(complex)
