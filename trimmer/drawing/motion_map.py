"""The picture of a map: kinds of motion as areas, or a stroke over one number."""

from __future__ import annotations

from typing import TYPE_CHECKING

from matplotlib.figure import Figure

from trimmer.drawing.content import content_of

if TYPE_CHECKING:
    from trimmer.maps.result import MotionMap
    from trimmer.maps.special_curve import SpecialCurves

_SIZE = (7.2, 4.4)


def draw_motion_map(result: MotionMap, special: SpecialCurves | None, file_format: str) -> bytes:
    """Draw a map and return the content of the file.

    Args:
        result: The map.
        special: Curves over it, None for no curves.
        file_format: ``svg``, ``png`` or ``pdf``.
    """
    figure = Figure(figsize=_SIZE, dpi=160, layout="constrained")
    axes = figure.add_subplot()
    result.plot(axes, () if special is None else special.drawn)
    axes.set_title(result.inputs.mechanism.title, fontsize="small", parse_math=False)
    return content_of(figure, file_format)
