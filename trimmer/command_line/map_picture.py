"""The picture of a map: kinds of motion as areas, or a stroke over one number."""

from __future__ import annotations

import io
from typing import TYPE_CHECKING

from matplotlib import rc_context
from matplotlib.figure import Figure

if TYPE_CHECKING:
    from trimmer.maps.result import MotionMap
    from trimmer.maps.special_curves import SpecialCurves

_SIZE = (7.2, 4.4)
_DATELESS = {"svg": {"Date": None}, "pdf": {"CreationDate": None}, "png": {}}


def draw(result: MotionMap, file_format: str, special: SpecialCurves | None = None) -> bytes:
    """Draw a map and return the content of the file.

    Args:
        result: The map.
        file_format: ``svg``, ``png`` or ``pdf``.
        special: Curves over it.
    """
    figure = Figure(figsize=_SIZE, layout="constrained")
    axes = figure.add_subplot()
    result.plot(axes, () if special is None else special.drawn)
    axes.set_title(result.inputs.mechanism.title, fontsize="small", parse_math=False)
    content = io.BytesIO()
    with rc_context({"svg.hashsalt": "trimmer", "svg.fonttype": "path"}):
        figure.savefig(content, format=file_format, dpi=160, metadata=_DATELESS[file_format])
    return content.getvalue()
