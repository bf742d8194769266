"""Curves over motions of the twin: filled dots where a motion repeats, open ones where it was not seen to."""

from collections.abc import Mapping, Sequence
from typing import Any

import numpy as np
from matplotlib.axes import Axes


def marked(
    axes: Axes, points: Sequence[tuple[float, float, str]], label: str, line: Mapping[str, Any]
) -> None:
    """Draw one curve with its dots, in the colour and dashes of its line.

    Points are what is varied, what is measured, and the word of the kind of motion.
    """
    x, y = np.array([point[:2] for point in points]).T
    repeats = np.array([kind == "periodic" for *_, kind in points])
    axes.plot(x, y, label=label, **line)
    for chosen, face in ((repeats, line["color"]), (~repeats, "white")):
        if chosen.any():
            look = {"color": line["color"], "markerfacecolor": face, "markersize": 4.5}
            axes.plot(x[chosen], y[chosen], "o", **look)
