"""What is read of an orbit, as data of a proof: functionals of the state in each of its modes."""

from collections.abc import Iterable
from typing import Any

import numpy as np

from trimmer.arrays import Reals
from trimmer.contact.flow import MechanismFlow
from trimmer.contact.machine.statuses import CONTACT_MADE, IMPACT, STICK
from trimmer.motion.course import Course
from trimmer.motion.flow import Flow
from trimmer.motion.signals import OwnValues, Readout, Signal, Steady, rate
from trimmer.proof.modes import Coordinates, Seen, begun_amid, instants, modes_used, motion_rows
from trimmer.proof.outcome import UndecidedError
from trimmer.response.periodic.orbit import Orbit

AXES = "displacements", "velocities"  # Names of what a body has


def functionals_data(orbit: Orbit, flow: Flow, names: Iterable[str]) -> list[dict[str, Any]]:
    """Return functionals by name, over the modes of ``orbit_data``.

    Args:
        orbit: The orbit.
        flow: What it is said to be a motion of.
        names: ``outputs.NAME``, ``rates.NAME`` for its rate with that of the frame, ``bodies.NAME`` for its
            acceleration, ``frictions.NAME`` for what is 1 while it sticks and else 0, ``contacts.NAME`` for
            how fast its sides meet, ``displacements.NAME`` and ``velocities.NAME`` of a body.
    """
    course, coordinates = begun_amid(orbit.course), Coordinates.of(flow)
    rows = list(instants(Seen(course.log, course.modes, flow.modes)))
    found = [_functional(course, flow, rows, name) for name in names]
    for each in found:
        each["rows"] = [coordinates.functional(np.array(row), each["about"]) for row in each["rows"]]
    return found


def read_of_motion(course: Course, flow: Flow, names: Iterable[str]) -> dict[str, Any]:
    """Return functionals of a motion from an initial state, and levels, ``outputs.NAME = VALUE``."""
    rows, found = motion_rows(course, flow), {"functionals": list[Any](), "levels": list[Any]()}
    for name in names:
        called, at, level = name.partition(" = ")
        functional = _functional(course, flow, rows, called)
        functional["before"].append(len(rows) - 1)
        if at:
            functional.update(about=f"{called} - {level}", before=[])
            for row in functional["rows"]:
                row[-1] -= float(level)
        found["levels" if at else "functionals"].append(functional)
    return found


def _functional(course: Course, flow: Flow, rows: list[tuple[int, int]], name: str) -> dict[str, Any]:
    signal, before = _signal(course, flow, rows, name)
    if isinstance(signal, OwnValues):
        raise UndecidedError(f"{name} is no functional of the state where several frictions stick")
    used = modes_used(course.log, rows)
    table = [signal(flow.modes.number(course.modes[number].statuses)).tolist() for number in used]
    return {"about": name, "rows": table, "before": before}


def _signal(course: Course, flow: Flow, rows: list[tuple[int, int]], name: str) -> tuple[Signal, list[int]]:
    """Return what is read by a name, and the segments before whose end it is told."""
    kind, _, part = name.partition(".")
    if kind == "outputs" and part in flow.outputs:
        return flow.outputs[part].signal, []
    if kind == "rates" and part in flow.outputs:
        return _rate(flow, flow.outputs[part]), []
    if kind == "bodies" and part in flow.accelerations:
        return flow.accelerations[part], []
    if isinstance(flow, MechanismFlow):
        if kind in AXES and part in flow.axes:
            return Steady(np.eye(flow.modes.system.layout.size)[flow.axes[part][AXES.index(kind)]]), []
        layout = flow.modes.system.layout
        if kind == "frictions" and part in layout.frictions:
            return _stick(flow, layout.frictions.index(part)), []
        if kind == "contacts" and part in (*layout.contacts, *layout.walls):
            return _meeting(course, flow, rows, part)
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


def _meeting(
    course: Course, flow: MechanismFlow, rows: list[tuple[int, int]], name: str
) -> tuple[Signal, list[int]]:
    """Return the speed at which a contact or a wall closes, and the segments that end so."""
    machine, layout, log = flow.modes.system.machine, flow.modes.system.layout, course.log
    if name in layout.walls:
        number, kind, row = layout.walls.index(name), IMPACT, machine.wall_rate
        part = machine.first_wall + number
    else:
        number, kind, row = layout.contacts.index(name), CONTACT_MADE, machine.contact_rate
        part = number
    hit = (log.kind == kind) & (log.part == part)
    ends = [place - 1 for place, (first, last) in enumerate(rows) if hit[first : last + 1].any()]
    return lambda mode: row[number], [place for place in ends if place >= 0]
