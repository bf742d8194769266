"""Bars under a motion over time that mark when a part is in contact or sticks."""

from collections.abc import Iterable, Sequence
from dataclasses import dataclass
from typing import Any

import numpy as np
from matplotlib.axes import Axes
from matplotlib.collections import PolyCollection

from trimmer.drawing.look import COLOURS
from trimmer.hybrid.tables import Modes
from trimmer.hybrid.work import Log
from trimmer.motion.part import TOUCHING, Part, Phase
from trimmer.motion.spans import spans_of

HEIGHT = 0.06  # Height of a strip, as a share of the axes
MOST = 0.45  # Share of the axes that all strips take at most
NAME: dict[str, Any] = {"xycoords": "axes fraction", "textcoords": "offset points", "va": "center"}
NAME |= {"fontsize": "x-small", "parse_math": False, "annotation_clip": False}
"""How the name of a strip stands beside the axes."""


@dataclass(frozen=True)
class Strip:
    """Starts and lengths, s, at which a part is in contact or sticks, which looks otherwise."""

    name: str
    bars: Sequence[tuple[float, float]]
    stick: bool


def strips_of(parts: Iterable[Part], modes: Modes[Any], log: Log, duration: float) -> list[Strip]:
    """Return when each play and stop is in contact, and when each friction and relay is held."""
    here, found = modes.tables.statuses[log.mode], []
    for number, part in enumerate(parts):
        for phases, word, stick in ((TOUCHING, "contact", False), ((Phase.STICK,), "stick", True)):
            statuses = part.statuses(*phases)
            if statuses:
                bars = spans_of(log.start, duration, np.isin(here[:, number], statuses))
                found.append(Strip(f"{part.name}, {word}", bars, stick))
    return found


def draw_strips(axes: Axes, strips: Sequence[Strip]) -> None:
    """Make room under the curves and draw a row of bars for each strip, with its name at the right."""
    if not strips:
        return
    height = min(HEIGHT, MOST / len(strips))
    low, high = axes.get_ylim()
    room = height * (len(strips) + 0.3)
    axes.set_ylim(low - (high - low) * room / (1.0 - room), high)
    for number, strip in enumerate(reversed(strips)):
        middle = height * (number + 0.5)
        _add_bars(axes, strip, middle, 0.7 * height)
        axes.annotate(strip.name, (1.0, middle), (5, 0), **NAME)
    axes.plot([0, 1], [room, room], transform=axes.transAxes, color="0.6", linewidth=0.6)


def _add_bars(axes: Axes, strip: Strip, middle: float, height: float) -> None:
    """Add bars in the axes' share of height; the hatching tells stick without colours."""
    low, high = middle - height / 2, middle + height / 2
    corners = [
        [(start, low), (start, high), (start + length, high), (start + length, low)]
        for start, length in strip.bars
    ]
    look: dict[str, Any] = {"facecolor": COLOURS[0], "edgecolor": "none", "linewidth": 0}
    if strip.stick:
        look |= {"facecolor": COLOURS[1], "edgecolor": "white", "hatch": "////"}
    bars = PolyCollection(corners, **look)
    bars.set_transform(axes.get_xaxis_transform())
    bars.set_label(f"_{strip.name}")  # no legend shows it
    axes.add_collection(bars, autolim=False)
