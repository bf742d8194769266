"""A motion of a mechanism over time with contact and stick marked, its phase plane, its Poincaré section."""

from __future__ import annotations

from typing import TYPE_CHECKING

import numpy as np

from trimmer.contact.assembly import PUSHING
from trimmer.contact.statuses import STICK
from trimmer.drawing.axes import add_legend
from trimmer.drawing.dispatch import draw
from trimmer.drawing.look import BLACK, line, plain_label
from trimmer.drawing.strips import Strip, bars_of, draw_strips
from trimmer.drawing.units import name_axis
from trimmer.response.motion import MechanismMotion
from trimmer.response.motion_signals import output_rows, while_status
from trimmer.response.orbit import MechanismOrbit

if TYPE_CHECKING:
    from collections.abc import Mapping

    from matplotlib.axes import Axes

    from trimmer.arrays import Reals
    from trimmer.contact.flow import Course, ExactFlow

POINTS = 4000
"""Points of a curve."""


def signals_of(flow: ExactFlow) -> Mapping[str, Reals]:
    """Return what is drawn of a mechanism as functionals: its outputs, or its bodies if it has none."""
    layout = flow.modes.system.layout
    bodies = dict(zip(layout.bodies, np.eye(len(layout.bodies), layout.size), strict=True))
    return output_rows(flow.mechanism, layout) or bodies


@draw.register(MechanismMotion)
def draw_simulated(motion: MechanismMotion, axes: Axes) -> None:
    """Draw a simulated motion over time."""
    draw_motion(motion.flow, motion.course, axes)


@draw.register(MechanismOrbit)
def draw_orbit(orbit: MechanismOrbit, axes: Axes) -> None:
    """Draw an orbit in the phase plane."""
    draw_phase_plane(orbit.flow, orbit.course, axes)


def draw_motion(flow: ExactFlow, course: Course, axes: Axes) -> None:
    """Draw outputs, m, over time, s, with contact and stick marked."""
    times = np.linspace(0.0, course.duration, POINTS)
    states = course.states(times)
    for number, (name, row) in enumerate(signals_of(flow).items()):
        axes.plot(times, states @ row, label=plain_label(name), linewidth=1.2, **line(number))
    axes.set_xlim(0.0, course.duration)
    name_axis(axes.yaxis, "displacement", "m")
    name_axis(axes.xaxis, "time", "s")
    axes.grid(alpha=0.3)
    draw_strips(axes, strips_of(flow, course))
    add_legend(axes)


def strips_of(flow: ExactFlow, course: Course) -> list[Strip]:
    """Return when each play and stop is in contact, and when each friction sticks."""
    layout = flow.modes.system.layout
    contacts = [(f"{name}, contact", PUSHING, False) for name in layout.contacts]
    sticks = [(f"{name}, stick", (STICK,), True) for name in layout.frictions]
    return [
        Strip(name, bars_of(course.log.start, course.duration, while_status(course, part, on)), stick)
        for part, (name, on, stick) in enumerate([*contacts, *sticks])
    ]


def draw_phase_plane(flow: ExactFlow, course: Course, axes: Axes) -> None:
    """Draw the rate of the first output, m/s, over itself, m; dots mark the starts of drive periods."""
    (name, row), *_ = signals_of(flow).items()
    rate = row @ flow.modes.system.machine.base
    states = course.states(np.linspace(0.0, course.duration, POINTS))
    axes.plot(states @ row, states @ rate, color=line(0)["color"], linewidth=0.9)
    if flow.period:
        starts = course.states(np.arange(0.0, course.duration * (1 - 1e-9), flow.period))
        axes.plot(
            starts @ row, starts @ rate, "o", color=BLACK, markersize=4, label="start of a drive period"
        )
    _name_plane(axes, name)
    add_legend(axes)


def draw_section(axes: Axes, flow: ExactFlow, states: Reals, label: str, number: int = 0) -> None:
    """Draw the rate of the first output over itself at the start of each drive period.

    Args:
        axes: Where.
        flow: The motion of the mechanism.
        states: At the starts of drive periods, (count, n).
        label: Name of the points.
        number: Number of the colour and of the mark.
    """
    (name, row), *_ = signals_of(flow).items()
    rate = row @ flow.modes.system.machine.base
    forcing = np.tile(flow.modes.system.layout.forcing_at(0.0), (len(states), 1))
    extended = np.hstack([states, forcing])
    mark, size = ("osD^v"[number % 5], 4.0) if len(states) < 50 else (".", 1.5)
    look = {"color": line(number)["color"], "markersize": size, "linestyle": "none"}
    axes.plot(extended @ row, extended @ rate, mark, label=label, **look)
    _name_plane(axes, name)


def _name_plane(axes: Axes, name: str) -> None:
    axes.locator_params(nbins=5)
    name_axis(axes.xaxis, name, "m")
    name_axis(axes.yaxis, f"rate of {name}", "m/s")
    axes.grid(alpha=0.3)
