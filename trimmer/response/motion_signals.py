"""What is measured of a motion, as functionals of its extended state in each mode.

A signal is given by a function from the number of a mode to a row (N,); its rate is that row times the flow.
"""

from __future__ import annotations

from collections.abc import Callable
from typing import TYPE_CHECKING, TypeAlias

import numpy as np

from trimmer.contact.assembly import PUSHING, force_of

if TYPE_CHECKING:
    from trimmer.arrays import Flags, Integers, Reals
    from trimmer.contact.flow import Course
    from trimmer.contact.layout import Layout
    from trimmer.contact.system import MechanismSystem
    from trimmer.hybrid.tables import Modes
    from trimmer.mechanism.mechanism import Mechanism

Signal: TypeAlias = Callable[[int], "Reals"]


def output_rows(mechanism: Mechanism, layout: Layout) -> dict[str, Reals]:
    """Return each output as a functional of the extended state, (N,).

    In a frame that moves it is without what the frame moves by, and so is a pin that goes on for ever while
    nothing leans on it: see ``output_speeds``.
    """
    return {
        name: np.asarray(sum((weight * _row(layout, of) for of, weight in output.weights.items())))
        for name, output in mechanism.outputs.items()
    }


def output_speeds(mechanism: Mechanism, layout: Layout) -> dict[str, float]:
    """Return how fast each output moves on beyond what its functional says, m/s."""
    return {
        name: sum(weight * layout.speeds[of] for of, weight in output.weights.items())
        for name, output in mechanism.outputs.items()
    }


def _row(layout: Layout, name: str) -> Reals:
    if name in layout.pins:
        row: Reals = layout.pin_rows[layout.pins.index(name)]
        return row
    row = np.zeros(layout.size)
    row[layout.bodies.index(name)] = 1.0
    return row


def steady(row: Reals) -> Signal:
    """Return a signal that has the same row in every mode."""
    return lambda mode: row


def acceleration(modes: Modes[MechanismSystem], body: int) -> Signal:
    """Return the acceleration of a body by its number, m/s²."""
    return lambda mode: np.asarray(modes[mode].flow[len(modes.system.layout.bodies) + body])


def contact_force(modes: Modes[MechanismSystem], contact: int) -> Signal:
    """Return the force of a contact by its number, N, positive where it pulls the ends together."""

    def row(mode: int) -> Reals:
        status = modes[mode].statuses[contact]
        return (
            force_of(modes.system.machine, contact, status)
            if status in PUSHING
            else np.zeros(modes.system.layout.size)
        )

    return row


def rate(modes: Modes[MechanismSystem], signal: Signal) -> Signal:
    """Return the rate of a signal."""
    return lambda mode: np.asarray(signal(mode) @ modes[mode].flow)


def along(course: Course, signal: Signal, rows: Integers, states: Reals) -> Reals:
    """Return a signal at states, (count, N), that lie in rows, (count,), of the log of a motion."""
    return np.asarray(np.einsum("ij,ij->i", states, row_of_each(course, signal)[rows]))


def row_of_each(course: Course, signal: Signal) -> Reals:
    """Return the functional of a signal in each row of the log, (rows, N)."""
    modes, places = np.unique(course.log.mode, return_inverse=True)
    table = np.array([signal(int(mode)) for mode in modes])
    return np.asarray(table[places])


def while_status(course: Course, part: int, statuses: tuple[int, ...]) -> Flags:
    """Say of each row of the log whether a part has one of some statuses, (rows,)."""
    return np.isin(course.modes.tables.statuses[course.log.mode, part], statuses)


def durations(course: Course) -> Reals:
    """Return how long each row of the log lasts, s, (rows,)."""
    return np.diff(np.append(course.log.start, course.duration))
