"""What axes get after their data: names, grid, strips, and a legend where it leaves the data free."""

from collections.abc import Iterable, Sequence
from typing import Any

from matplotlib.artist import Artist
from matplotlib.axes import Axes
from matplotlib.transforms import ScaledTranslation

from trimmer.drawing.strips import Strip, draw_strips
from trimmer.drawing.units import name_axis

Label = tuple[str, str]

NARROW = 4.0  # Width of axes, inches, below which a legend stands under them and not beside them
UNDER = 3.6  # How far under the axes, in font sizes: below ticks and label


def finish(axes: Axes, across: Label, up: Label, strips: Sequence[Strip] = ()) -> None:
    """Name both axes of drawn curves, by what they show and SI unit, and add grid, strips and legend."""
    name_axis(axes.yaxis, *up)
    name_axis(axes.xaxis, *across)
    axes.grid(alpha=0.3)
    draw_strips(axes, strips)
    add_legend(axes)


def label(axes: Axes, across: str, up: str) -> None:
    """Name both axes of drawn curves in words as they are, and add grid and legend."""
    axes.set_xlabel(across)
    axes.set_ylabel(up, parse_math=False)
    axes.grid(alpha=0.3)
    add_legend(axes)


def add_legend(axes: Axes, handles: Iterable[Artist] | None = None, title: str = "") -> None:
    """Add a legend outside of the data in which each label stands once; none without a label.

    It stands at the right of wide axes, and under narrow ones.
    """
    shown = axes.get_legend_handles_labels()[0] if handles is None else list(handles)
    once = {str(each.get_label()): each for each in shown}
    if not once:
        return
    look: dict[str, Any] = {"fontsize": "small", "borderaxespad": 0.0, "loc": "upper left"}
    look |= {"title": title or None, "title_fontsize": "small"}
    figure = axes.get_figure(root=True)
    assert figure is not None
    if axes.get_position().width * figure.get_size_inches()[0] >= NARROW:
        axes.legend(once.values(), once.keys(), bbox_to_anchor=(1.02, 1.0), **look)
        return
    down = ScaledTranslation(0.0, -UNDER * _font_size() / 72, figure.dpi_scale_trans)
    look |= {"bbox_to_anchor": (0.0, 0.0), "bbox_transform": axes.transAxes + down}
    axes.legend(once.values(), once.keys(), **look)


def _font_size() -> float:
    from matplotlib import rcParams

    return float(rcParams["font.size"])
