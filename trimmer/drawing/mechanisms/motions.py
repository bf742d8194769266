"""A motion of a mechanism over time with contact and stick marked, its phase plane, its Poincaré section."""

from collections.abc import Iterable
from dataclasses import replace

import numpy as np
from matplotlib.axes import Axes

from trimmer.arrays import Reals
from trimmer.drawing.axes import add_legend, finish
from trimmer.drawing.dispatch import draw
from trimmer.drawing.look import BLACK, line, plain_label
from trimmer.drawing.strips import strips_of
from trimmer.drawing.units import name_axis
from trimmer.motion.course import Course
from trimmer.motion.flow import Flow, signals_of
from trimmer.motion.signals import Steady, rate, read
from trimmer.motion.units import with_unit
from trimmer.response.periodic.orbit import Orbit
from trimmer.response.simulation.motion import MechanismMotion

WORDS = {
    **{"m": "displacement", "m/s": "velocity", "m/s²": "acceleration", "N": "force"},
    **{"rad": "angle", "rad/s": "angular velocity", "rad/s²": "angular acceleration", "N m": "moment"},
}
"""What all signals are if this is their unit."""
POINTS = 4000  # Points of a curve


@draw.register(MechanismMotion)
def draw_simulated(motion: MechanismMotion, axes: Axes) -> None:
    """Draw a simulated motion over time."""
    draw_motion(motion.flow, motion.course, axes, travels=True)


@draw.register(Orbit)
def draw_orbit(orbit: Orbit, axes: Axes) -> None:
    """Draw an orbit in the phase plane."""
    draw_phase_plane(orbit.flow, orbit.course, axes)


def draw_motion(flow: Flow, course: Course, axes: Axes, *, travels: bool = False) -> None:
    """Draw outputs over time, s, with contact and stick marked, and what they travel if that is wanted."""
    times = np.linspace(0.0, course.duration, POINTS)
    rows, states = course.at(times)
    signals = signals_of(flow)
    alike = len({each.unit for each in signals.values()}) == 1
    for number, (name, each) in enumerate(signals.items()):
        (values,) = read(course, [each], rows, states).T
        values = values + each.speed * times * travels
        label = plain_label(name) if alike else with_unit(plain_label(name), each.unit)
        axes.plot(times, values, label=label, linewidth=1.2, **line(number))
    axes.set_xlim(0.0, course.duration)
    strips = strips_of(flow.parts, course.modes, course.log, course.duration)
    finish(axes, ("time", "s"), _shown(each.unit for each in signals.values()), strips)


def _shown(units: Iterable[str]) -> tuple[str, str]:
    """Return what signals of some units are called, and their unit; none if they have several."""
    found = set(units)
    unit = found.pop() if len(found) == 1 else ""
    return WORDS.get(unit, "signals"), unit


def draw_phase_plane(flow: Flow, course: Course, axes: Axes) -> None:
    """Draw the rate of the first output over itself; dots mark the starts of drive periods."""
    (name, first), *_ = signals_of(flow).items()
    plane = first, replace(first, signal=rate(flow.modes, first.signal))
    times = np.linspace(0.0, course.duration, POINTS)
    curve = read(course, plane, *course.at(times)).T
    axes.plot(*curve, color=line(0)["color"], linewidth=0.9)
    if flow.period:
        starts = np.arange(0.0, course.duration * (1 - 1e-9), flow.period)
        points = read(course, plane, *course.at(starts)).T
        axes.plot(*points, "o", color=BLACK, markersize=4, label="start of a drive period")
    _name_plane(axes, name, first.unit)
    add_legend(axes)


def draw_section(axes: Axes, flow: Flow, states: Reals, label: str, number: int) -> None:
    """Draw the rate of the first output over itself at the start of each drive period, (count, n)."""
    (name, first), *_ = signals_of(flow).items()
    forcing = np.tile(flow.modes.system.layout.forcing_at(0.0), (len(states), 1))
    extended = np.hstack([states, forcing])
    # Only the rate of a displacement is the same in every mode.
    alike = isinstance(first.signal, Steady) and first.unit in ("m", "rad")
    modes = [flow.modes.number(flow.at(state).statuses) for state in (states[:1] if alike else states)]
    rows = np.array([(first.signal(mode), rate(flow.modes, first.signal)(mode)) for mode in modes])
    points = (rows @ extended[:, :, None])[:, :, 0]
    mark, size = ("osD^v"[number % 5], 4.0) if len(states) < 50 else (".", 1.5)
    look = {"color": line(number)["color"], "markersize": size, "linestyle": "none"}
    axes.plot(*points.T, mark, label=label, **look)
    _name_plane(axes, name, first.unit)


def _name_plane(axes: Axes, name: str, unit: str) -> None:
    axes.locator_params(nbins=5)
    name_axis(axes.xaxis, name, unit)
    length, per_second, power = unit.partition("/s")
    of_rate = f"{length}/s{'³' if power else '²'}" if per_second else f"{unit or 1}/s"
    name_axis(axes.yaxis, f"rate of {name}", of_rate)
    axes.grid(alpha=0.3)
