"""Periodic orbits of a loop in the phase plane of the element's input."""

from collections.abc import Sequence

import numpy as np
from matplotlib.axes import Axes

from trimmer.arrays import Reals
from trimmer.drawing.axes import finish
from trimmer.drawing.dispatch import draw
from trimmer.drawing.look import BLACK, STABLE, UNSTABLE, colour
from trimmer.drawing.units import with_prefix
from trimmer.orbits import PeriodicOrbit, PeriodicOrbits

POINTS = 2000  # Points of an orbit, beside its events


@draw.register(PeriodicOrbit)
def draw_orbit(orbit: PeriodicOrbit, axes: Axes) -> None:
    """Draw one orbit, with a dot where a mode changes."""
    draw_orbits([orbit], axes)


@draw.register(PeriodicOrbits)
def draw_orbits(orbits: Sequence[PeriodicOrbit], axes: Axes) -> None:
    """Draw orbits, stable ones solid and others dashed, with dots where a mode changes."""
    for number, orbit in enumerate(orbits):
        events = orbit.switching_times
        times = np.union1d(np.linspace(0.0, orbit.period, POINTS), events[events <= orbit.period])
        dashes = STABLE if orbit.stable else UNSTABLE
        axes.plot(*in_plane(orbit, times), color=colour(number), linestyle=dashes, label=_words(orbit))
        where = in_plane(orbit, events[events <= orbit.period])
        axes.plot(*where, "o", color=BLACK, markersize=3.0, linestyle="none", label="change of mode")
    unit = next(iter(orbits)).unit if orbits else ""
    finish(axes, ("input of the element", unit), ("its rate", f"{unit or 1}/s"))


def in_plane(orbit: PeriodicOrbit, times: Reals) -> Reals:
    """Return the element's input, m, and its rate, m/s, at times, s, (2, times)."""
    modes = orbit.motion.loop.modes
    return orbit.motion.values(
        times, lambda mode: np.array([modes[mode].signals[0].input, modes[mode].signals[0].input_rate])
    )


def _words(orbit: PeriodicOrbit) -> str:
    return f"{orbit.steadiness}: {orbit.frequency:.5g} Hz,\nA = {with_prefix(orbit.amplitude, orbit.unit)}"
