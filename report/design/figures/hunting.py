"""The map of where an axis rests, and where it hunts."""

import numpy as np
from matplotlib.figure import Figure
from matplotlib.patches import Patch

from report.design.figures.over_numbers import frame, scales
from report.pages.drawing.style import new_figure
from trimmer.design.parameter_studies.kept_map import DesignMap
from trimmer.drawing.cells import draw_cells
from trimmer.maps.cell_motion import CellMotion
from trimmer.response.results.response import MotionKind

LOOKS = {
    "comes to rest": ("#56B4E9", ""),
    "hunts evenly": ("#E69F00", "//"),
    "hunts, not evenly": ("#D55E00", "xx"),
    "cannot be followed": ("#FFFFFF", ""),
}
"""Colours and hatches, which differ in a grey print too."""


def hunting_map(drawn: DesignMap) -> Figure:
    """Draw where an axis comes to rest, and where and how it hunts, with the working point."""
    result = drawn.result
    names = [_name(cell.motions[0]) for cell in result.cells]
    legend = [each for each in LOOKS if each in names]
    numbers = np.array([legend.index(each) for each in names]).reshape(result.shape)
    figure = new_figure(3.5)
    axes = figure.add_subplot()
    across, up = (values / scale.factor for values, scale in zip(result.values, scales(drawn), strict=True))
    looks = {number: LOOKS[each] for number, each in enumerate(legend)}
    colours, hatches = ({number: look[at] for number, look in looks.items()} for at in (0, 1))
    draw_cells(axes, across, up, numbers, colours, hatches)
    frame(axes, drawn)
    patches = [
        Patch(facecolor=LOOKS[each][0], edgecolor="0.4", hatch=2 * LOOKS[each][1], label=each)
        for each in legend
    ]
    axes.legend(handles=patches, loc="upper left", bbox_to_anchor=(1.01, 1.0))
    return figure


def _name(motion: CellMotion) -> str:
    if motion.failure:
        return "cannot be followed"
    words = {MotionKind.REST: "comes to rest", MotionKind.PERIODIC: "hunts evenly"}
    return words.get(motion.kind, "hunts, not evenly")
