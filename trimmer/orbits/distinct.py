"""When two orbits are one, and the shortest return of an orbit."""

from __future__ import annotations

import math
from dataclasses import replace
from typing import TYPE_CHECKING

from trimmer.orbits.measures import extremes
from trimmer.orbits.return_map import arcs
from trimmer.orbits.shooting import Return, Shot, solve

if TYPE_CHECKING:
    from trimmer.orbits.periodic_orbit import PeriodicOrbit


ALIKE = 1e-6
"""Relative difference below which periods and extremes are the same: shooting is exact to 1e-10, but an orbit
whose multiplier is near one is less well determined than its return."""


def same(first: PeriodicOrbit, second: PeriodicOrbit) -> bool:
    """Tell whether two orbits are one, or mirror images, wherever their motions start.

    A loop of odd elements moves along the mirror image of an orbit, too.
    """
    if not math.isclose(first.period, second.period, rel_tol=ALIKE):
        return False
    ours, theirs = _extremes(first), _extremes(second)
    near = ALIKE * first.amplitude
    return any(
        all(abs(one - other) <= near for one, other in zip(ours, turned, strict=True))
        for turned in (theirs, (-theirs[1], -theirs[0]))
    )


def shortest(problem: Return, shot: Shot) -> tuple[Return, Shot]:
    """Return the shortest return of an orbit, with signs changed if it has this symmetry."""
    events = len(arcs(problem.modes, shot.log, shot.span)) - 1
    for part in _prime_factors(events):
        # After an even number of half periods the signs are the old ones.
        found = None if problem.mirrored and part == 2 else _part_of(problem, shot, part)
        shot = shot if found is None else found
    if not problem.mirrored and not problem.driven:
        mirrored = replace(problem, mirrored=True)
        half = _part_of(mirrored, shot, 2)
        if half is not None:
            return mirrored, half
    return problem, shot


def _part_of(problem: Return, shot: Shot, part: int) -> Shot | None:
    """Return the return after a part of the span, if the motion is back by then; None if not."""
    trial = problem.shoot(shot.mode, shot.state, shot.span / part)
    return (
        None if trial is None or trial.miss > ALIKE else solve(problem, trial.mode, trial.state, trial.span)
    )


def _prime_factors(number: int) -> list[int]:
    """Return the prime factors of a number, each as often as it divides it."""
    factors, factor = [], 2
    while factor * factor <= number:
        while number % factor == 0:
            factors.append(factor)
            number //= factor
        factor += 1
    return [*factors, number] if number > 1 else factors


def _extremes(orbit: PeriodicOrbit) -> tuple[float, float]:
    modes = orbit.motion.loop.modes
    return extremes(modes, arcs(modes, orbit.motion.log, orbit.period))
