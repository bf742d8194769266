"""A motion over time with contact and stick marked, its phase plane, and its Poincaré section."""

from __future__ import annotations

from typing import TYPE_CHECKING

import numpy as np

from trimmer.contact.assembly import PUSHING
from trimmer.contact.statuses import STICK
from trimmer.drawing.units import name_axis
from trimmer.response.motion_signals import durations, output_rows, while_status

if TYPE_CHECKING:
    from collections.abc import Mapping

    from matplotlib.axes import Axes

    from trimmer.arrays import Flags, Reals
    from trimmer.contact.flow import Course, ExactFlow

POINTS = 4000
"""Points of a curve."""


def signals_of(flow: ExactFlow) -> Mapping[str, Reals]:
    """Return what is drawn of a mechanism as functionals: its outputs, or its bodies if it has none."""
    layout = flow.modes.layout
    bodies = dict(zip(layout.bodies, np.eye(len(layout.bodies), layout.size), strict=True))
    return output_rows(flow.mechanism, layout) or bodies


def draw_motion(axes: Axes, flow: ExactFlow, course: Course) -> None:
    """Draw outputs over time."""
    times = np.linspace(0.0, course.duration, POINTS)
    states = course.states(times)
    for name, row in signals_of(flow).items():
        axes.plot(times, states @ row, linewidth=1.0, label=name)
    name_axis(axes.yaxis, "displacement", "m")
    name_axis(axes.xaxis, "time", "s")
    axes.legend(fontsize="x-small", loc="upper right")
    axes.grid(alpha=0.3)


def draw_statuses(axes: Axes, flow: ExactFlow, course: Course) -> None:
    """Draw a bar for each time of contact and of stick, a row for each play, stop and friction."""
    layout = flow.modes.layout
    contacts = len(layout.contacts)
    named: list[tuple[str, tuple[int, ...]]] = [(f"{name}, contact", PUSHING) for name in layout.contacts]
    named += [(f"{name}, stick", (STICK,)) for name in layout.frictions]
    for part, (_, statuses) in enumerate(named):
        bars = _bars(course, while_status(course, part, statuses))
        axes.broken_barh(bars, (part - 0.35, 0.7), color="C0" if part < contacts else "C3")
    axes.set_yticks(range(len(named)), [name for name, _ in named], fontsize="x-small", parse_math=False)
    axes.set_ylim(len(named) - 0.4, -0.6)
    axes.set_xlim(0.0, course.duration)
    name_axis(axes.xaxis, "time", "s")


def _bars(course: Course, on: Flags) -> list[tuple[float, float]]:
    """Return start and length of each time at which something is on, s; what touches is one."""
    bars: list[tuple[float, float]] = []
    for start, length, each in zip(course.log.start, durations(course), on, strict=True):
        if not each or length == 0:
            continue
        if bars and np.isclose(sum(bars[-1]), start, rtol=0, atol=1e-12 * course.duration):
            bars[-1] = bars[-1][0], float(start + length - bars[-1][0])
        else:
            bars.append((float(start), float(length)))
    return bars


def draw_phase_plane(axes: Axes, flow: ExactFlow, course: Course) -> None:
    """Draw the rate of the first output over itself, with a dot at the start of each drive period."""
    (name, row), *_ = signals_of(flow).items()
    rate = row @ flow.modes.machine.base
    states = course.states(np.linspace(0.0, course.duration, POINTS))
    axes.plot(states @ row, states @ rate, linewidth=0.8)
    if flow.period:
        starts = course.states(np.arange(0.0, course.duration * (1 - 1e-9), flow.period))
        axes.plot(starts @ row, starts @ rate, "o", color="black", markersize=4)
    _name_plane(axes, name)


def draw_section(axes: Axes, flow: ExactFlow, states: Reals, label: str | None = None) -> None:
    """Draw the first output and its rate at the start of each drive period.

    Args:
        axes: Where.
        flow: The motion of the mechanism.
        states: At the starts of drive periods, (count, n).
        label: Name of the points.
    """
    (name, row), *_ = signals_of(flow).items()
    rate = row @ flow.modes.machine.base
    forcing = np.tile(flow.modes.layout.forcing_at(0.0), (len(states), 1))
    extended = np.hstack([states, forcing])
    few = len(states) < 50
    axes.plot(extended @ row, extended @ rate, "o" if few else ".", markersize=4 if few else 1.5, label=label)
    _name_plane(axes, name)


def _name_plane(axes: Axes, name: str) -> None:
    axes.locator_params(nbins=5)
    name_axis(axes.xaxis, name, "m")
    name_axis(axes.yaxis, f"rate of {name}", "m/s")
    axes.grid(alpha=0.3)
