"""How large a gap is borne, over what a designer chooses."""

from __future__ import annotations

from typing import TYPE_CHECKING

import numpy as np

from report.judging.record import figure
from report.numbers.evidence import Evidence
from report.numbers.twin.map_numbers import MapNumbers
from report.pages.drawing.style import FAINT, LINES, panels

if TYPE_CHECKING:
    from matplotlib.axes import Axes
    from matplotlib.figure import Figure


@figure(
    "twin-design-limits",
    "The gap that is borne",
    caption="""The largest gap up to which every cell of a row repeats with the drive: over friction at 110
    Hz (a), over speed with 0.5 N (b), over the stiffness of the bridge at 110 Hz with 0.5 N (c). From the
    kept maps; dotted: 0.5 N, 110 Hz, and the 30 kN/m of Listing A.1. Panel (c) ends at the largest gap of
    its map.""",
    alternative_text="""Three step curves. Over friction about 0.1 mm from 0.4 N, 0.2 mm from 3.5 N. Over
    speed ragged, below 0.12 mm up to 124 Hz but for 74 Hz, up to 0.36 mm at 150 Hz. Over stiffness 0.5 mm
    up to 10 kN/m, 0.1 mm up to 35 kN/m, and 25 micrometres or less beyond.""",
)
def design_limits(known: Evidence) -> Figure:
    """Draw the reach of the rows of three maps."""
    twin = known.twin
    drawn, (friction, speed, stiffness) = panels(2.8, 1, 3)
    _reach(friction, twin.friction, 1.0, 0.5)
    _reach(speed, twin.speed, 1.0, 110.0)
    _reach(stiffness, twin.stiffness, 1e-3, 30.0)
    friction.set(xlabel="friction [N]", ylabel="gap [µm]")
    speed.set(xlabel="drive [Hz]")
    stiffness.set(xlabel="stiffness [kN/m]")
    return drawn


def _reach(axes: Axes, numbers: MapNumbers, factor: float, chosen: float) -> None:
    axes.step(factor * numbers.second, 1e6 * np.nan_to_num(numbers.reaches), where="mid", **LINES[0])
    axes.axvline(chosen, **FAINT)
    axes.set_ylim(0, 520)
