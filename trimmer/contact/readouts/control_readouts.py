"""What is read of controllers: what acts, what is demanded, and at which limit they are."""

from collections.abc import Iterator

import numpy as np

from trimmer.arrays import Reals
from trimmer.contact.machine.statuses import AT_LOWER, AT_UPPER
from trimmer.contact.modes.control_limits import limited
from trimmer.contact.modes.system import MechanismSystem
from trimmer.hybrid.clock import TICKED
from trimmer.hybrid.tables import Modes
from trimmer.motion.course import Course
from trimmer.motion.extremes import largest
from trimmer.motion.part import Part
from trimmer.motion.signals import Signal, Steady


def control_signal(modes: Modes[MechanismSystem], name: str) -> Signal:
    """Return what a controller acts with, N, after limit, hold and delay."""
    layout = modes.system.layout
    if name in layout.held:
        return Steady(np.eye(1, layout.size, layout.held[name].acting)[0])
    control = modes.system.layout.controllers.index(name)

    def row(mode: int) -> Reals:
        machine = modes.system.machine
        status = modes[mode].statuses[machine.first_control + control]
        through = machine.control_through[control] * limited(machine, control, status)
        found: Reals = machine.control_rest[control] + through
        return found

    return row


def largest_demand(course: Course, name: str) -> float:
    """Return the largest modulus of what a controller demands in a motion before its limit, N or N m."""
    layout, machine = course.modes.system.layout, course.modes.system.machine
    if name in layout.held:
        return float(abs(_sampled_demands(course, list(layout.held).index(name))).max(initial=0.0))
    return largest(course, Steady(machine.control_demand[layout.controllers.index(name)]))


def _sampled_demands(course: Course, sampler: int) -> Reals:
    """Return what a sampled controller demands at each sample: of what was measured, and held before it."""
    assert course.modes.samplings is not None
    log, clock = course.log, course.modes.samplings.clock
    count, held = len(clock.limit), course.modes.system.layout.holding
    ticks = np.flatnonzero(log.function <= TICKED)
    sampled = (TICKED - log.function[ticks]) >> count
    rows = ticks[(sampled >> 2 * (count - 1 - sampler)) % 4 > 0]
    states, before = log.state[rows].copy(), np.maximum(rows - 1, 0)
    states[:, held] = np.where((rows > 0)[:, None], log.state[before][:, held], 0.0)
    return np.asarray(np.einsum("ij,ij->i", clock.demand[log.mode[before], sampler], states))


def parts_of_controls(names: tuple[str, ...]) -> Iterator[Part]:
    """Yield the controllers as parts with statuses; to reach a limit is no phase that counts."""
    return (Part(name, {}, {AT_UPPER: AT_LOWER, AT_LOWER: AT_UPPER}) for name in names)
