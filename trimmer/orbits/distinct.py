"""When two orbits are one, and the shortest return of an orbit."""

from dataclasses import replace

import numpy as np

from trimmer.arrays import Reals
from trimmer.hybrid.stretch import Instant
from trimmer.one_orbit import SAME, ClosedCurve, are_one, inaccuracy
from trimmer.orbits.periodic_orbit import PeriodicOrbit
from trimmer.response.periodic.shooting import LONGEST, Patience, Return, Shot, returned

COLLAPSED = 1e-6
"""Swing of all states, relative to their sizes, below which Newton's method has found an equilibrium."""
POINTS = 64  # Points of a period at which two orbits are compared
LEAST = 1e-9
"""Scale of a state relative to the largest one, below which it is rounding, or says nothing of its own."""


def same(first: PeriodicOrbit, second: PeriodicOrbit) -> bool:
    """Tell whether two orbits are one, or mirror images, wherever their motions start.

    A loop of odd elements moves along the mirror image of an orbit, too.
    """
    ours, theirs = curve_of(first), curve_of(second)
    path = theirs.path
    assert path is not None, "a closed loop may begin anywhere"
    mirrored = replace(theirs, states=-theirs.states, path=lambda times: -path(times))
    return are_one(ours, theirs) or are_one(ours, mirrored)


def curve_of(orbit: PeriodicOrbit) -> ClosedCurve:
    """Return an orbit as the closed curve of the linear system's states, by which it is compared."""

    def path(times: Reals) -> Reals:
        return np.ascontiguousarray(orbit.motion.state(times).T)

    states = path(orbit.period * np.arange(POINTS) / POINTS)
    sizes = abs(states).max(axis=0)
    return ClosedCurve(
        period=orbit.period,
        states=states[None],
        sizes=np.maximum(sizes, LEAST * sizes.max()),
        inaccuracy=inaccuracy(orbit.residual, orbit.nontrivial_multipliers),
        path=path,
    )


def shortest(problem: Return, shot: Shot) -> tuple[Return, Shot]:
    """Return the shortest return of an orbit, with signs changed if it has this symmetry."""
    for part in _prime_factors(len(np.unique(shot.course.times))):
        # After an even number of half periods the signs are the old ones.
        found = None if problem.mirrored and part == 2 else _part_of(problem, shot, part)
        shot = shot if found is None else found
    if not problem.mirrored and not problem.periods:
        mirrored = replace(problem, mirrored=True)
        half = _part_of(mirrored, shot, 2)
        if half is not None:
            return mirrored, half
    return problem, shot


def _part_of(problem: Return, shot: Shot, part: int) -> Shot | None:
    """Return the return after a part of the span, if the motion is back by then; None if not."""
    trial = problem.shoot(shot.course.begin, shot.duration / part, shot.sizes)
    if trial is None or trial.miss > SAME:
        return None
    return closed(problem, trial.course.begin, trial.duration, trial.sizes)


def closed(
    problem: Return, instant: Instant, duration: float, sizes: Reals, patience: Patience | None = None
) -> Shot | None:
    """Return a solved return from a guess of start and span, s; None if Newton's method does not find one."""
    shot = returned(problem, instant, duration, patience, sizes[: problem.flow.size])
    return None if shot is None or shot.duration > LONGEST * duration else shot


def collapsed(shot: Shot, sizes: Reals) -> bool:
    """Tell whether Newton's method has ended where nothing moves, or nothing happens."""
    course, count = shot.course, len(shot.course.begin.state)
    swing = np.ptp(np.vstack([course.log.state[:, :count], course.begin.state]), axis=0)
    return len(course.log.start) < 2 or float((swing / sizes[:count]).max()) < COLLAPSED


def _prime_factors(number: int) -> list[int]:
    """Return the prime factors of a number, each as often as it divides it."""
    factors, factor = [], 2
    while factor * factor <= number:
        while number % factor == 0:
            factors.append(factor)
            number //= factor
        factor += 1
    return [*factors, number] if number > 1 else factors
