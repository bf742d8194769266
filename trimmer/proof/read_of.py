"""What is read of an orbit, as data of a proof: functionals of the state in each of its modes."""

from __future__ import annotations

from collections.abc import Iterable
from typing import TYPE_CHECKING, Any

import numpy as np

from trimmer.contact.flow import MechanismFlow
from trimmer.contact.impulses import first_wall
from trimmer.contact.statuses import CONTACT_MADE, IMPACT, STICK
from trimmer.motion.signals import OwnValues, rate
from trimmer.proof.modes import begun_amid, instants, modes_used
from trimmer.proof.outcome import UndecidedError

if TYPE_CHECKING:
    from trimmer.arrays import Reals
    from trimmer.motion.course import Course
    from trimmer.motion.flow import Flow
    from trimmer.motion.signals import Readout, Signal
    from trimmer.response.orbit import Orbit


def functionals_data(orbit: Orbit, flow: Flow, names: Iterable[str]) -> list[dict[str, Any]]:
    """Return functionals by name, over the modes of ``orbit_data``.

    Args:
        orbit: The orbit.
        flow: What it is said to be a motion of.
        names: ``outputs.NAME``, ``rates.NAME`` for its rate with that of the frame, ``bodies.NAME`` for its
            acceleration, ``frictions.NAME`` for what is 1 while it sticks and else 0, ``contacts.NAME`` for
            how fast its sides meet.
    """
    course = begun_amid(orbit.course)
    modes = [flow.modes.number(course.modes[number].statuses) for number in modes_used(course.log)]
    found = []
    for name in names:
        signal, before = _signal(course, flow, name)
        if isinstance(signal, OwnValues):
            raise UndecidedError(f"{name} is no functional of the state where several frictions stick")
        found.append({"about": name, "rows": [signal(mode).tolist() for mode in modes], "before": before})
    return found


def _signal(course: Course, flow: Flow, name: str) -> tuple[Signal, list[int]]:
    """Return what is read by a name, and the segments before whose end it is told."""
    kind, _, part = name.partition(".")
    if kind == "outputs" and part in flow.outputs:
        return flow.outputs[part].signal, []
    if kind == "rates" and part in flow.outputs:
        return _rate(flow, flow.outputs[part]), []
    if kind == "bodies" and part in flow.accelerations:
        return flow.accelerations[part], []
    if isinstance(flow, MechanismFlow):
        layout = flow.modes.system.layout
        if kind == "frictions" and part in layout.frictions:
            return _stick(flow, layout.frictions.index(part)), []
        if kind == "contacts" and part in (*layout.contacts, *layout.walls):
            return _meeting(course, flow, part)
    raise UndecidedError(f"{name} is nothing that is read of this motion")


def _rate(flow: Flow, output: Readout) -> Signal:
    """Return the rate of an output, with how fast it moves on beyond what its functional says."""
    beyond = output.speed * np.eye(flow.modes.system.layout.size)[-1]
    return lambda mode: np.asarray(rate(flow.modes, output.signal)(mode) + beyond)


def _stick(flow: MechanismFlow, friction: int) -> Signal:
    system = flow.modes.system
    place = len(system.machine.stiffness) + friction
    one = np.eye(system.layout.size)[-1]

    def row(mode: int) -> Reals:
        return np.asarray(one * (flow.modes[mode].statuses[place] == STICK))

    return row


def _meeting(course: Course, flow: MechanismFlow, name: str) -> tuple[Signal, list[int]]:
    """Return the speed at which a contact or a wall closes, and the segments that end so."""
    machine, layout, log = flow.modes.system.machine, flow.modes.system.layout, course.log
    if name in layout.walls:
        number, kind, row = layout.walls.index(name), IMPACT, machine.wall_rate
        part = first_wall(machine) + number
    else:
        number, kind, row = layout.contacts.index(name), CONTACT_MADE, machine.contact_rate
        part = number
    hit = (log.kind == kind) & (log.part == part)
    ends = [place - 1 for place, (first, last) in enumerate(instants(log)) if hit[first : last + 1].any()]
    return lambda mode: row[number], [place for place in ends if place >= 0]
