"""Outputs, contact forces, contact and stick of a motion over time, as pictures show them."""

from collections.abc import Mapping
from dataclasses import dataclass, field

import numpy as np

from trimmer.arrays import Flags, Reals
from trimmer.contact.machine.statuses import STICK
from trimmer.contact.modes.assembly import PUSHING
from trimmer.contact.readouts.outputs import contact_force
from trimmer.contact.readouts.readouts import acceleration
from trimmer.motion.course import Course
from trimmer.motion.flow import Flow
from trimmer.motion.signals import along, read, while_status
from trimmer.motion.spans import spans_of

POINTS = 1200  # Instants at which signals are kept

Spans = tuple[tuple[float, float], ...]  # Begin and length of times at which something is on, s


@dataclass(frozen=True, eq=False)
class MotionSignals:
    """Outputs, contact forces, contact and stick of a motion over time.

    Attributes:
        times: s, (n,).
        outputs: By name, (n,).
        forces: Of each play and stop by name, positive where it pulls its ends together, (n,).
        touching: When each is in contact.
        sticking: When each dry friction sticks.
        accelerations: Of each body, m/s², between impulses, (n,).
        units: SI unit of each output.
        force_units: Of the force of each play and stop.
    """

    times: Reals
    outputs: Mapping[str, Reals]
    forces: Mapping[str, Reals]
    touching: Mapping[str, Spans]
    sticking: Mapping[str, Spans]
    accelerations: Mapping[str, Reals] = field(default_factory=dict)
    units: Mapping[str, str] = field(default_factory=dict)
    force_units: Mapping[str, str] = field(default_factory=dict)


def signals_of(flow: Flow, course: Course, share: float) -> MotionSignals:
    """Return the signals of a motion up to a share of its duration."""
    layout, log = flow.modes.system.layout, course.log
    end = share * course.duration
    times = np.union1d(np.linspace(0.0, end, POINTS), log.start[log.start <= end])
    rows, states = course.at(times)
    contacts = len(layout.contacts)
    return MotionSignals(
        times,
        dict(zip(flow.outputs, read(course, flow.outputs.values(), rows, states).T, strict=True)),
        {
            name: along(course, contact_force(course.modes, part), rows, states)
            for part, name in enumerate(layout.contacts)
        },
        {
            name: _spans(course, while_status(course, p, PUSHING), end)
            for p, name in enumerate(layout.contacts)
        },
        {
            name: _spans(course, while_status(course, contacts + number, (STICK,)), end)
            for number, name in enumerate(layout.frictions)
        },
        {name: along(course, acceleration(course.modes, name), rows, states) for name in layout.shaken},
        {name: output.unit for name, output in flow.outputs.items()},
        {name: flow.force_unit(name) for name in layout.contacts},
    )


def _spans(course: Course, on: Flags, end: float) -> Spans:
    """Return the times up to an end at which something is on."""
    found = spans_of(course.log.start, course.duration, on)
    return tuple((begin, min(length, end - begin)) for begin, length in found if begin < end)
