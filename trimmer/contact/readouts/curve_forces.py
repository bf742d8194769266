"""The forces of curves in a motion, and the energy that they hold."""

from __future__ import annotations

from itertools import pairwise
from typing import TYPE_CHECKING

import numpy as np

from trimmer.contact.modes.curves import curve_force
from trimmer.motion.signals import Steady, along

if TYPE_CHECKING:
    from trimmer.arrays import Integers, Reals
    from trimmer.contact.machine.machine import Machine
    from trimmer.contact.modes.system import MechanismSystem
    from trimmer.hybrid.tables import Modes
    from trimmer.motion.course import Course
    from trimmer.motion.signals import Signal


def force_signal(modes: Modes[MechanismSystem], section: str, name: str) -> Signal:
    """Return the force of the curve of a part, positive where it pulls, N; 0 without a curve."""
    system = modes.system
    if (section, name) not in system.layout.curves:
        return Steady(np.zeros(system.layout.size))
    curve = system.layout.curves.index((section, name))
    place = system.machine.first_curve + curve
    return lambda mode: curve_force(system.machine, curve, modes[mode].statuses[place])


def curve_forces(course: Course, section: str, name: str, rows: Integers, states: Reals) -> Reals:
    """Return the force of the curve of a part at extended states in rows of the log, N; 0 without one."""
    return along(course, force_signal(course.modes, section, name), rows, states)


def stored_energy(machine: Machine, curve: int, state: Reals) -> float:
    """Return the energy that a curve over a distance holds beside that at the elongation zero, J."""
    knots = machine.curve_knots[curve][np.isfinite(machine.curve_knots[curve])]
    value = float(machine.curve_over[curve] @ state)
    first, last = min(value, 0.0), max(value, 0.0)
    ends = [first, *(each for each in knots if first < each < last), last]
    energy = 0.0
    for low, high in pairwise(ends):
        segment = int(np.searchsorted(knots, 0.5 * (low + high)))
        slope, height = machine.curve_slopes[curve, segment], machine.curve_heights[curve, segment]
        energy += (high - low) * (0.5 * slope * (low + high) + height)
    return energy if value > 0 else -energy
