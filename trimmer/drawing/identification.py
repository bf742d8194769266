"""The picture of an identified load: M/D over the frequency of the limit cycle, with what was measured."""

import itertools
import math

import numpy as np
from matplotlib.axes import Axes

from trimmer.balance.identification import Identification
from trimmer.drawing.axes import add_legend
from trimmer.drawing.dispatch import draw
from trimmer.drawing.look import BLACK, STABLE, UNSTABLE, colour
from trimmer.drawing.units import name_axis

POINTS = 49  # Time constants for which the limit cycles are found
DECADES = 3.0
"""How far M/D is drawn on either side of one over the angular frequency, and beyond what was found."""


@draw.register(Identification)
def draw_identification(found: Identification, axes: Axes) -> None:
    """Draw M/D over frequency."""
    _draw_bands(axes, found)
    low, high = found.frequency - found.frequency_uncertainty, found.frequency + found.frequency_uncertainty
    axes.axvspan(low, high, color="0.85", zorder=0)
    axes.axvline(found.frequency, color=BLACK, linestyle=":", linewidth=1.0, label="measured")
    finite = [each for each in found.time_constants if 0 < each.time_constant < math.inf]
    if finite:
        places = [found.frequency] * len(finite), [each.time_constant for each in finite]
        axes.plot(*places, "o", color=BLACK, markersize=5, linestyle="none", label="M/D found")
    name_axis(axes.xaxis, "frequency of the limit cycle", "Hz")
    axes.set_yscale("log")
    axes.set_ylabel("M/D of the load, s")
    axes.grid(alpha=0.3)
    add_legend(axes)


def _draw_bands(axes: Axes, found: Identification) -> None:
    """Draw M/D over each band: stable limit cycles solid, others dashed."""
    points = [
        (cycle.frequency, time_constant, cycle.stable)
        for time_constant in _time_constants(found)
        for cycle in found.limit_cycles_with(time_constant)
    ]
    for band in found.bands:
        inside = [each for each in points if band.holds(each[0])]
        for stable, group in itertools.groupby(inside, key=lambda each: each[2]):
            frequencies, time_constants, _ = zip(*group, strict=True)
            dashes, number = (STABLE, 0) if stable else (UNSTABLE, 1)
            label = "stable limit cycle" if stable else "unstable limit cycle"
            axes.plot(frequencies, time_constants, color=colour(number), linestyle=dashes, label=label)


def _time_constants(found: Identification) -> list[float]:
    """Return time constants, s, in equal ratios around one over the angular frequency."""
    middle = math.log10(1.0 / (2.0 * math.pi * found.frequency))
    taken = [
        math.log10(each.time_constant) for each in found.time_constants if 0 < each.time_constant < math.inf
    ]
    low, high = min([middle - DECADES, *taken]), max([middle + DECADES, *taken])
    values: list[float] = np.logspace(low, high, POINTS).tolist()
    return values
