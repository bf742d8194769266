"""The picture of an identified load: M/D over the frequency of the limit cycle, with what was measured."""

from __future__ import annotations

import math
from typing import TYPE_CHECKING

import numpy as np

from trimmer.drawing.axes import add_legend, axes_for
from trimmer.drawing.look import BLACK, STABLE, UNSTABLE, colour
from trimmer.drawing.units import name_axis

if TYPE_CHECKING:
    from matplotlib.axes import Axes

    from trimmer.arrays import Reals
    from trimmer.balance.feasible_frequencies import FeasibleBand
    from trimmer.balance.identification import Identification

POINTS = 60
"""Frequencies of a band at which M/D is found."""
BEYOND = 2.0
"""How far beyond its lower end, or below its upper one, a band is drawn that has no other end."""


def draw_identification(found: Identification, ax: Axes | None = None) -> Axes:
    """Draw M/D over frequency; see ``Identification.plot``."""
    axes = axes_for(ax)
    for band in found.bands:
        _draw_band(axes, found, band)
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
    return axes


def _draw_band(axes: Axes, found: Identification, band: FeasibleBand) -> None:
    """Draw M/D over a band: stable limit cycles solid, others dashed; M/D of 0 and infinity are left out."""
    each = [
        (frequency, one.time_constant, one.stable)
        for frequency in _frequencies(band)
        for one in found.time_constants_at(frequency)
        if 0 < one.time_constant < math.inf
    ]
    for stable, look, dashes in ((True, colour(0), STABLE), (False, colour(1), UNSTABLE)):
        places = [(f, tau if kind is stable else math.nan) for f, tau, kind in each]
        if any(kind is stable for *_, kind in each):
            label = "stable limit cycle" if stable else "unstable limit cycle"
            axes.plot(*np.array(places).T, color=look, linestyle=dashes, label=label)


def _frequencies(band: FeasibleBand) -> Reals:
    lower, upper = band.frequencies
    lower = lower or upper / BEYOND
    upper = upper if math.isfinite(upper) else lower * BEYOND
    inside = np.sin(np.linspace(-np.pi / 2, np.pi / 2, POINTS + 2)[1:-1])  # close together at both ends
    return np.asarray(lower + (upper - lower) * (1.0 + inside) / 2)
