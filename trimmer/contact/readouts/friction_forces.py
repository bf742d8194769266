"""The forces of dry frictions, also in stick, where the motion may leave open how several share them.

Sliding gives the force of a friction, and stick of one alone gives what holds it. Where frictions that stick
depend on each other, as two side by side or three in a ring, the motion determines only the resultant on
each body. Then the share is that with the least sum of squares of the forces relative to their static limits,
among those within the limits (``trimmer.hybrid.dry_friction.admissible_split``): it exists whenever
all can stick, is unique, moves continuously with the resultant, is the same for equal frictions, and does not
depend on the order of the parts.
"""

import numpy as np

from trimmer.arrays import Integers, Places, Reals
from trimmer.contact.machine.statuses import FORWARD
from trimmer.contact.modes.assembly import flow_without_stick
from trimmer.contact.modes.system import MechanismSystem
from trimmer.hybrid.dry_friction import DEPENDENT, admissible_split, independent, least_shares
from trimmer.hybrid.tables import Modes
from trimmer.motion.course import Course


def dry_forces(course: Course, rows: Integers, states: Reals) -> Reals:
    """Return the dry force of each friction, N, positive against an end that moves forward.

    Args:
        course: The motion.
        rows: Rows of its log, (count,).
        states: Extended states in them, (count, N).

    Returns:
        Array (count, frictions), in the order of the layout.
    """
    return hold_forces(course, rows, states)[:, : len(course.modes.system.machine.kinetic)]


def hold_forces(course: Course, rows: Integers, states: Reals) -> Reals:
    """Return the dry force of each friction, then of each wall, N, positive where it pulls its ends together.

    Args:
        course: The motion.
        rows: Rows of its log, (count,).
        states: Extended states in them, (count, N).
    """
    modes = course.modes
    forces = np.empty((len(rows), len(modes.system.machine.held)))
    mode_of_each = course.log.mode[rows]
    for mode in np.unique(mode_of_each):
        here = mode_of_each == mode
        forces[here] = _forces_in_mode(modes, int(mode), states[here])
    return forces


def undetermined(course: Course) -> tuple[str, ...]:
    """Return the frictions, by name, whose force in stick the motion leaves open at some time."""
    modes = course.modes
    found: set[int] = set()
    for mode in np.unique(course.log.mode):
        sticking = _sticking(modes, int(mode))
        if len(sticking) > 1:
            _, free = _shares(modes, sticking, np.zeros((len(sticking), 1)))
            found |= set(sticking[(abs(free) > DEPENDENT).any(axis=1)].tolist())
    names = (*modes.system.layout.frictions, *modes.system.layout.walls)
    return tuple(name for number, name in enumerate(names) if number in found)


def _forces_in_mode(modes: Modes[MechanismSystem], mode: int, states: Reals) -> Reals:
    machine, statuses = modes.system.machine, modes[mode].statuses
    directions = np.array(machine.of_frictions(statuses))
    slides = np.where(directions == FORWARD, machine.kinetic, -machine.kinetic)
    forces = np.tile(np.append(slides, np.zeros(len(machine.restitution))), (len(states), 1))
    sticking = _sticking(modes, mode)
    if not len(sticking):
        return forces
    limits, walls = _limits(modes, sticking), sticking >= len(machine.kinetic)
    shares, free = _shares(modes, sticking, _some_split(modes, mode, sticking))
    split = limits * (states @ shares.T)
    if free.shape[1]:
        beyond = np.where(walls, split < 0, abs(split) > limits)
        for place in np.flatnonzero(beyond.any(axis=1)):
            within = admissible_split(_directions(modes, sticking), limits, split[place], walls)
            if within is not None:
                split[place] = within
    forces[:, sticking] = split
    return forces


def rows_in_mode(modes: Modes[MechanismSystem], mode: int) -> Reals:
    """Return the dry forces in a mode as functionals, N, (frictions + walls, N).

    In stick they are those with the least sum of squares relative to the limits, which some may exceed.
    """
    machine = modes.system.machine
    directions = np.array(machine.of_frictions(modes[mode].statuses))
    rows = np.zeros((len(machine.held), modes.system.layout.size))
    rows[: len(directions), -1] = np.where(directions == FORWARD, machine.kinetic, -machine.kinetic)
    sticking = _sticking(modes, mode)
    if len(sticking):
        shares, _ = _shares(modes, sticking, _some_split(modes, mode, sticking))
        rows[sticking] = _limits(modes, sticking)[:, None] * shares
    return rows


def _limits(modes: Modes[MechanismSystem], sticking: Places) -> Reals:
    """Return the static forces of frictions, N; of walls, which have no limit, what theirs compare with."""
    limits: Reals = modes.system.machine.held[sticking]
    finite = limits[np.isfinite(limits)]
    return np.where(np.isfinite(limits), limits, finite.max(initial=0.0) or 1.0)


def _sticking(modes: Modes[MechanismSystem], mode: int) -> Places:
    """Return the numbers of what holds: frictions, then walls."""
    return np.flatnonzero(np.isin(modes.system.machine.holds, modes[mode].held))


def _directions(modes: Modes[MechanismSystem], sticking: Places) -> Reals:
    machine = modes.system.machine
    directions: Reals = machine.hold_rate[sticking, machine.velocities]
    return directions


def _shares(modes: Modes[MechanismSystem], sticking: Places, split: Reals) -> tuple[Reals, Reals]:
    return least_shares(_directions(modes, sticking), _limits(modes, sticking), split)


def _some_split(modes: Modes[MechanismSystem], mode: int, sticking: Places) -> Reals:
    """Return the forces in stick as functionals, (sticking, N), where those that close a ring are zero."""
    machine = modes.system.machine
    flow = flow_without_stick(machine, modes[mode].statuses)
    tree = sticking[independent(_directions(modes, sticking))]
    rates, push = machine.hold_rate[tree], machine.hold_push[tree]
    split = np.zeros((len(sticking), len(flow)))
    influence = rates[:, machine.velocities] @ push.T
    split[np.searchsorted(sticking, tree)] = np.linalg.solve(influence, rates @ flow)
    return split
