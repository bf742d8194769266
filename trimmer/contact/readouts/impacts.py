"""Impacts on walls in a motion: how fast ends meet, with which impulse, and what is lost."""

from __future__ import annotations

from typing import TYPE_CHECKING

import numpy as np

from trimmer.contact.machine.statuses import IMPACT, IMPULSES, RESTS
from trimmer.motion.extremes import TurningPoints, largest, turning_points
from trimmer.motion.signals import Steady, while_status

if TYPE_CHECKING:
    from trimmer.arrays import Reals
    from trimmer.mechanism.mechanism import Mechanism
    from trimmer.motion.course import Course

GRAZING = 1e-6
"""Share of its path by which a body may miss a wall that it touches; its square root for the speed."""


def impact_at(course: Course, row: int) -> tuple[float, float]:
    """Return how fast the ends of a wall meet at a row of the log that is an impulse, m/s, and this, N s."""
    machine = course.modes.system.machine
    wall = int(course.log.part[row]) - machine.first_wall
    rate = machine.wall_rate[wall]
    before, after = (float(rate @ state) for state in (state_before(course, row), course.log.state[row]))
    return before, (before - after) / float(rate[machine.velocities] @ machine.wall_push[wall])


def state_before(course: Course, row: int) -> Reals:
    """Return the extended state, (N,), just before an event."""
    log = course.log
    return course.before(row) if log.start[row] > log.start[row - 1] else np.asarray(log.state[row - 1])


def losses_at_walls(course: Course) -> dict[str, float]:
    """Return what is lost at each wall, J: an impulse P does the work -P (v + v')/2 on all that moves."""
    system, log = course.modes.system, course.log
    lost = dict.fromkeys(system.layout.walls, 0.0)
    for row in rows_of_impulses(course):
        wall = int(log.part[row]) - system.machine.first_wall
        rate, impulse = impact_at(course, row)
        after = float(system.machine.wall_rate[wall] @ log.state[row])
        lost[system.layout.walls[wall]] += 0.5 * impulse * (rate + after)
    return lost


def rows_of_impulses(course: Course) -> list[int]:
    """Return the rows of the log of a motion that are impulses."""
    found: list[int] = np.flatnonzero(np.isin(course.log.kind, IMPULSES)).tolist()
    return found


def speeds_given(course: Course, weights: Reals) -> tuple[Reals, Reals]:
    """Return when walls give impulses, s, (k,), and how much these change the rates of sums, (k, sums).

    Args:
        course: The motion.
        weights: Of the displacements in each sum, (sums, coordinates).
    """
    rows, velocities = rows_of_impulses(course), course.modes.system.machine.velocities
    changed = [(course.log.state[row] - state_before(course, row))[velocities] for row in rows]
    return course.log.start[rows], np.array(changed).reshape(-1, weights.shape[1]) @ weights.T


def work_at_walls(course: Course, mechanism: Mechanism, pin: str, rate: Reals) -> float:
    """Return the work of what moves a pin against impulses of walls, J.

    Args:
        course: The motion.
        mechanism: What moves.
        pin: Name of the pin.
        rate: Its velocity relative to what carries it, as a functional, (N,).
    """
    system, work = course.modes.system, 0.0
    for row in rows_of_impulses(course):
        name = system.layout.walls[int(course.log.part[row]) - system.machine.first_wall]
        start, end = mechanism.walls[name].between
        if pin in (start, end):
            _, impulse = impact_at(course, row)
            work += (1.0 if end == pin else -1.0) * impulse * float(rate @ course.log.state[row])
    return work


def grazed_walls(course: Course) -> tuple[str, ...]:
    """Return the walls, by name, that a motion meets without speed, or just misses, but does not rest on."""
    system, log = course.modes.system, course.log
    found = []
    for wall, name in enumerate(system.layout.walls):
        part = system.machine.first_wall + wall
        distance, rate = (
            Steady(each[wall]) for each in (system.machine.wall_distance, system.machine.wall_rate)
        )
        if while_status(course, part, (RESTS,)).any():
            continue
        rows = np.flatnonzero((log.part == part) & (log.kind == IMPACT)).tolist()
        slow = any(impact_at(course, row)[0] < np.sqrt(GRAZING) * largest(course, rate) for row in rows)
        if slow or _is_just_missed(turning_points(course, distance), log.start[rows]):
            found.append(name)
    return tuple(found)


def _is_just_missed(distance: TurningPoints, impacts: Reals) -> bool:
    """Say whether a distance comes to just below zero, and back, anywhere but at impacts."""
    values = distance.values
    nearest = (values >= np.roll(values, 1)) & (values >= np.roll(values, -1))
    nearest &= ~np.isin(distance.times, impacts)
    return bool((values[nearest] > -GRAZING * np.ptp(values)).any())
