"""Kinds of motion in plain words, each with its colour, and strokes over one number in these colours."""

from __future__ import annotations

from typing import TYPE_CHECKING

from matplotlib.colors import to_rgb
from matplotlib.patches import Patch

from trimmer.maps.cells import described

if TYPE_CHECKING:
    from collections.abc import Sequence

    from trimmer.maps.cells import CellMotion

PERIOD_COLOURS = ("#56B4E9", "#0072B2", "#009E73", "#F0E442", "#E69F00", "#D55E00")
"""Of motions of period 1, 2, ...: the colours of Okabe and Ito, which colour-blind readers tell apart."""
LONGER_COLOUR = "#CC79A7"
OTHER_COLOURS = {"torus": "#777777", "chaotic": "#222222", "not settled": "#CCCCCC", "failed": "#FFFFFF"}


def category(motion: CellMotion) -> tuple[str, str]:
    """Return what a motion is in plain words, and its colour."""
    name = described(motion)
    if name in OTHER_COLOURS:
        return name, OTHER_COLOURS[name]
    if motion.period_count <= len(PERIOD_COLOURS):
        return name, PERIOD_COLOURS[motion.period_count - 1]
    return f"period {len(PERIOD_COLOURS) + 1} or more", LONGER_COLOUR


def categories() -> list[tuple[str, str]]:
    """Return all categories with their colours, in the order of the legend."""
    periods = [(f"period {count}", colour) for count, colour in enumerate(PERIOD_COLOURS, start=1)]
    return [*periods, (f"period {len(PERIOD_COLOURS) + 1} or more", LONGER_COLOUR), *OTHER_COLOURS.items()]


def legend_of(legend: Sequence[tuple[str, str]]) -> list[Patch]:
    """Return a patch for each name and colour."""
    return [Patch(facecolor=colour, edgecolor="0.4", label=name) for name, colour in legend]


def in_grey(colour: str) -> float:
    """Return the lightness of a colour as a grey print shows it, 0 to 1."""
    red, green, blue = to_rgb(colour)
    return 0.299 * red + 0.587 * green + 0.114 * blue
