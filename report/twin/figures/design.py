"""Up to which gap the motion stays regular, over what a designer chooses."""

import numpy as np
from matplotlib.axes import Axes
from matplotlib.figure import Figure

from report.data.figures import figure
from report.numbers.evidence import Evidence
from report.numbers.twin.map_numbers import MapNumbers
from report.pages.drawing.style import FAINT, LINES, panels


@figure("twin-design-limits")
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
