"""Outputs of a mechanism as functionals of its state: sums of motions of ends, and forces of parts."""

from collections.abc import Mapping
from dataclasses import dataclass, field
from functools import cache

import numpy as np

from trimmer.arrays import ROUNDING, Integers, Reals
from trimmer.contact.modes.assembly import PUSHING, force_of
from trimmer.contact.modes.system import MechanismSystem
from trimmer.contact.readouts.control_readouts import control_signal
from trimmer.contact.readouts.curve_forces import force_signal as curve_signal
from trimmer.contact.readouts.friction_forces import hold_forces, rows_in_mode
from trimmer.contact.state.layout import MechanismLayout
from trimmer.contact.state.rows import EndRows
from trimmer.hybrid.tables import Modes
from trimmer.mechanism import Mechanism, Output
from trimmer.mechanism.parts import OutputKind
from trimmer.motion.course import Course
from trimmer.motion.signals import OwnValues, Readout, Signal, Steady, along, rate, row_of_each


def outputs_of(mechanism: Mechanism, modes: Modes[MechanismSystem]) -> dict[str, Readout]:
    """Return each output, in SI units.

    In a frame that moves a displacement is without what the frame moves by, and so is a pin that goes on for
    ever while nothing leans on it: that is its speed.
    """
    return {
        name: Readout(
            signal_of(mechanism, modes, each),
            mechanism.output_units[name],
            speed_beyond(modes.system.layout, each),
        )
        for name, each in mechanism.outputs.items()
    }


def speed_beyond(layout: MechanismLayout, output: Output) -> float:
    """Return how fast an output moves on beyond what its functional says, in its unit per s."""
    if output.kind is not OutputKind.DISPLACEMENT:
        return 0.0
    return sum(weight * layout.speeds[of] for of, weight in output.weights.items())


def signal_of(mechanism: Mechanism, modes: Modes[MechanismSystem], output: Output) -> Signal:
    """Return what an output is as a functional of the state in each mode, in SI units."""
    layout, weights = modes.system.layout, output.weights.items()
    if output.kind is OutputKind.CONTROL:
        return control_signal(modes, str(output.part))
    if output.part is not None:
        return force_signal(mechanism, modes, output.part)
    if output.kind is OutputKind.DISPLACEMENT:
        return Steady(np.asarray(sum((weight * _displacement(layout, of) for of, weight in weights))))
    ends = EndRows(mechanism, layout)
    velocity = np.asarray(sum((weight * ends.velocity(of) for of, weight in weights)))
    if output.kind is OutputKind.VELOCITY:
        return Steady(velocity)
    return rate(modes, Steady(velocity))


def _displacement(layout: MechanismLayout, name: str) -> Reals:
    row: Reals = layout.end_rows[layout.ends.index(name)]
    return row


def force_signal(mechanism: Mechanism, modes: Modes[MechanismSystem], part: str) -> Signal:
    """Return the force of a link, play, stop, wall or friction, N, positive where it pulls its ends together.

    Forces of frictions that hold the same bodies are shared as by ``MechanismMotion.friction_force``.
    """
    layout, ends = modes.system.layout, EndRows(mechanism, modes.system.layout)
    if part in layout.contacts:
        return contact_force(modes, layout.contacts.index(part))
    if part in mechanism.links:
        return _with_curve(modes, Steady(ends.tension(mechanism.links[part])), "links", part)
    if part in mechanism.frictions:
        friction = mechanism.frictions[part]
        viscous = Steady(friction.viscous * ends.speed(friction.between))
        smooth = _with_curve(modes, viscous, "frictions", part)
        if part in layout.frictions:
            return HoldForce(modes, layout.frictions.index(part), smooth)
        return smooth
    if part in layout.walls:
        number = len(layout.frictions) + layout.walls.index(part)
        return HoldForce(modes, number, Steady(np.zeros(layout.size)))
    return Steady(np.zeros(layout.size))


def _with_curve(modes: Modes[MechanismSystem], linear: Steady, section: str, part: str) -> Signal:
    if (section, part) not in modes.system.layout.curves:
        return linear
    curve = curve_signal(modes, section, part)
    return lambda mode: linear.row + curve(mode)


def contact_force(modes: Modes[MechanismSystem], contact: int) -> Signal:
    """Return the force of a contact by its number, N, positive where it pulls the ends together."""

    @cache
    def row(mode: int) -> Reals:
        status = modes[mode].statuses[contact]
        return (
            force_of(modes.system.machine, contact, status)
            if status in PUSHING
            else np.zeros(modes.system.layout.size)
        )

    return row


@dataclass(frozen=True, eq=False)
class HoldForce(OwnValues):
    """The force of a friction or a wall, N."""

    modes: Modes[MechanismSystem]  # The modes
    number: int  # Of the friction, or behind all of them of the wall
    # Its share beside dry friction: the viscous one, and that of a curve beyond the force at rest
    smooth: Signal
    known: dict[int, Reals] = field(default_factory=dict)  # Functionals of modes that were asked for

    def __call__(self, mode: int) -> Reals:
        """Return the row, (N,): where several stick together, of the share with the least squares."""
        if mode not in self.known:
            self.known[mode] = self.smooth(mode) + rows_in_mode(self.modes, mode)[self.number]
        return self.known[mode]

    def along(self, course: Course, rows: Integers, states: Reals) -> Reals:
        """Return the force at states, (count, N), in rows of the log: that of an admissible share."""
        smooth = along(course, self.smooth, rows, states)
        return np.asarray(smooth + hold_forces(course, rows, states)[:, self.number])


def forces_at(mechanism: Mechanism, course: Course, times: Reals) -> Mapping[str, Reals]:
    """Return the force of each link, play, stop, wall, friction and controller, N, at times, s, in order.

    What is only rounding of the terms that make up a force is zero.
    """
    rows, states = course.at(times)
    parts = (*mechanism.links, *mechanism.plays, *mechanism.stops, *mechanism.walls, *mechanism.frictions)
    signals = {name: force_signal(mechanism, course.modes, name) for name in parts}
    signals |= {name: control_signal(course.modes, name) for name in mechanism.controllers}
    forces = {name: along(course, signal, rows, states) for name, signal in signals.items()}
    for name, signal in signals.items():
        if not isinstance(signal, OwnValues):
            terms = (abs(states) * abs(row_of_each(course, signal)[rows])).sum(axis=1)
            forces[name][abs(forces[name]) <= ROUNDING * terms] = 0.0
    return forces
