"""What is read of the motion of a mechanism: outputs, accelerations, forces, and what its parts do."""

import numpy as np

from trimmer.contact.machine.statuses import (
    ALWAYS,
    BACKWARD,
    COMPLETED,
    CONTACT_MADE,
    FORWARD,
    IMPACT,
    IMPULSES,
    MINUS,
    PLUS,
    RELEASED_MINUS,
    RELEASED_PLUS,
    RESTS,
    STICK,
)
from trimmer.contact.modes.assembly import PUSHING
from trimmer.contact.modes.curves import mirror_of
from trimmer.contact.modes.system import MechanismSystem
from trimmer.contact.readouts.control_readouts import parts_of_controls
from trimmer.contact.readouts.curve_forces import curve_forces
from trimmer.contact.readouts.impacts import impact_at
from trimmer.contact.readouts.outputs import HoldForce, contact_force
from trimmer.hybrid.system import NOTHING
from trimmer.hybrid.tables import Modes
from trimmer.motion.course import Course
from trimmer.motion.extremes import largest
from trimmer.motion.part import Part, Phase
from trimmer.motion.part_measures import ContactMeasures, FrictionMeasures
from trimmer.motion.signals import Signal, Steady, share_of_time, while_status

_SIDES = {PLUS: Phase.UPPER, MINUS: Phase.LOWER, ALWAYS: Phase.EITHER}
_OTHER_SIDE = {PLUS: MINUS, MINUS: PLUS, RELEASED_PLUS: RELEASED_MINUS, RELEASED_MINUS: RELEASED_PLUS}
_OTHER_WAY = {FORWARD: BACKWARD, BACKWARD: FORWARD}


def parts_of(system: MechanismSystem) -> tuple[Part, ...]:
    """Return the contacts, then the frictions, the curves, the controllers and the walls."""
    layout = system.layout
    contacts = (Part(name, _SIDES, _OTHER_SIDE) for name in layout.contacts)
    frictions = (Part(name, {STICK: Phase.STICK}, _OTHER_WAY) for name in layout.frictions)
    curves = (
        Part(name, {}, mirror_of(system.machine, number)) for number, (_, name) in enumerate(layout.curves)
    )
    walls = (Part(name, {RESTS: Phase.UPPER}) for name in layout.walls)
    return (*contacts, *frictions, *curves, *parts_of_controls(layout.controllers), *walls)


def acceleration(modes: Modes[MechanismSystem], end: str) -> Signal:
    """Return the acceleration of a coordinate, or of a point of modes, m/s²."""
    layout = modes.system.layout
    count = len(layout.coordinates)
    if end in layout.coordinates:
        return lambda mode: np.asarray(modes[mode].flow[count + layout.coordinates.index(end)])
    weights = layout.weights(end)
    return lambda mode: np.asarray(weights @ modes[mode].flow[count : 2 * count])


def contact_measures(course: Course, part: int, periods: int) -> ContactMeasures:
    """Return what a play or a stop, by its number, does over a motion that spans some periods."""
    modes = course.modes
    made = (course.log.part == part) & (course.log.kind == CONTACT_MADE)
    speeds = abs(course.log.state[made] @ modes.system.machine.contact_rate[part])
    share = share_of_time(course, while_status(course, part, PUSHING))
    force = largest(course, contact_force(modes, part))
    return ContactMeasures(len(speeds) / periods, tuple(speeds.tolist()), force, share, 0.0)


def wall_measures(course: Course, number: int, periods: int) -> ContactMeasures:
    """Return what a wall, by its number, does over a motion; forces are those at rest."""
    machine, log = course.modes.system.machine, course.log
    part = machine.first_wall + number
    hit = np.flatnonzero((log.part == part) & (log.kind == IMPACT)).tolist()
    resting = while_status(course, part, (RESTS,))
    held = HoldForce(
        course.modes, len(machine.kinetic) + number, Steady(np.zeros(course.modes.system.layout.size))
    )
    force = largest(course, held)
    speeds = tuple(impact_at(course, row)[0] for row in hit)
    completed = int(((log.part == part) & (log.kind == COMPLETED)).sum())
    return ContactMeasures(
        len(hit) / periods, speeds, force, share_of_time(course, resting), completed / periods
    )


def friction_measures(course: Course, number: int, periods: int) -> FrictionMeasures:
    """Return what a friction, by its number, does over a motion that spans some periods."""
    machine, nodes = course.modes.system.machine, course.nodes
    sticking = while_status(course, len(machine.stiffness) + number, (STICK,))
    rates = np.where(sticking[nodes.rows], 0.0, nodes.states @ machine.friction_rate[number])
    name = course.modes.system.layout.frictions[number]
    curve = curve_forces(course, "frictions", name, nodes.rows, nodes.states)
    lost = float(nodes.weights @ (machine.kinetic[number] * abs(rates) + curve * rates))
    return FrictionMeasures(lost / periods, lost / course.duration, share_of_time(course, sticking))


def event_rates(course: Course) -> list[tuple[float, float | None]]:
    """Return the rate of end less start at each event that counts, m/s, and the impulse, N s.

    The rate is that before an impact, and 0 of frictions; the impulse is None for what gives none.
    """
    log, rates = course.log, course.modes.system.machine.contact_rate
    found: list[tuple[float, float | None]] = []
    for row in np.flatnonzero(log.kind != NOTHING).tolist():
        part = int(log.part[row])
        if int(log.kind[row]) in IMPULSES:
            found.append(impact_at(course, row))
        else:
            found.append((float(rates[part] @ log.state[row]) if part < len(rates) else 0.0, None))
    return found
