"""What a page needs to read values off a figure: where its axes are, and a quantity along its curves."""

import json
import math
import re
from collections.abc import Iterator
from typing import Final

import numpy as np
from matplotlib.axes import Axes
from matplotlib.figure import Figure
from matplotlib.lines import Line2D

from report.pages.drawing.marks import Names
from report.pages.drawing.peaks import peaks
from report.pages.drawing.placed import Place, axes_name, placed
from trimmer.arrays import Reals
from trimmer.drawing.plane import Along as Along
from trimmer.drawing.plane import CurveAlong
from trimmer.drawing.plane import plot_along as plot_along

SCALES: Final = ("linear", "log")
_POINTS_PER_INCH = 72
_STEP = 2.5  # Points of a curve that are nearer than this, in points, say nothing new to the eye
_VALUE_STEP = 0.05  # But a point stays where the quantity has changed by this share
_SAME_PLACE = 0.02  # Share of the figure within which axes stand in one row or column
_SYMBOLS = {"omega": "ω", "gamma": "γ", "beta": "β", "theta": "θ", "phi": "φ", "pi": "π", "mu": "µ"}


def read_out(figure: Figure) -> str:
    """Describe the axes of a figure that has been drawn, as JSON; empty if it has none with scales.

    Each has its ``name``, its ``box`` (left, top, width, height in points, from the upper left corner), ``x``
    and ``y`` with ``limits``, ``scale``, ``label`` and the number of the axes whose range they share,
    ``curves`` whose ``points`` are x, y and value in turn, ``peaks`` of spectra, and what is ``placed`` at
    places of the data. The label is empty where an axis has words in place of numbers.
    """
    described = [
        {
            "name": axes_name(index),
            "box": _box(axes, figure),
            "x": _axis(axes, "x"),
            "y": _axis(axes, "y"),
            "curves": [curve for line in axes.lines for curve in _curves(line, axes, figure)],
            "peaks": [peak for line in axes.lines for peak in _peaks(line, axes, figure)],
            "placed": [
                [name, *(_in_points(place, axes, figure) for place in places)]
                for name, places in placed(axes, index)
            ],
        }
        for index, axes in enumerate(figure.axes)
        if axes.axison and axes.get_xscale() in SCALES and axes.get_yscale() in SCALES
    ]
    return json.dumps(described, ensure_ascii=False, separators=(",", ":")) if described else ""


def plain(label: str) -> str:
    r"""Return a label without the marks of Matplotlib's mathematics: ``$\omega$ [rad]`` as ``ω [rad]``."""
    if label.startswith("_"):
        return ""
    text = re.sub(r"\\dot\s*\{?(\w)\}?", "\\1\u0307", label)
    text = re.sub(r"\\([a-zA-Z]+)", lambda command: _SYMBOLS.get(command[1], command[1]), text)
    text = re.sub(r"\\[,;: ]", " ", text)
    return " ".join(re.sub(r"[${}\\]", "", text).replace("-1/N", "−1/N").split())


def _box(axes: Axes, figure: Figure) -> list[float]:
    width, height = _POINTS_PER_INCH * figure.get_size_inches()
    place = axes.get_position()
    corners = (place.x0 * width, (1 - place.y1) * height, place.width * width, place.height * height)
    return [round(float(corner), 2) for corner in corners]


def _axis(axes: Axes, direction: str) -> dict[str, object]:
    axis, group = getattr(axes, f"{direction}axis"), getattr(axes, f"get_shared_{direction}_axes")()
    siblings = group.get_siblings(axes)
    return {
        "limits": [float(f"{end:.8g}") for end in getattr(axes, f"get_{direction}lim")()],
        "scale": axis.get_scale(),
        "label": "" if isinstance(axis.get_major_formatter(), Names) else _label(axes, direction),
        "shared": min(axes.figure.axes.index(each) for each in siblings),
    }


def _in_points(place: Place, axes: Axes, figure: Figure) -> list[float | None]:
    """Return a place of the data in points from the upper left corner."""
    ends = axes.get_xlim(), axes.get_ylim()
    data = np.array([[low if each is None else each] for each, (low, _) in zip(place, ends, strict=True)])
    ((across, up),) = _points(data.T, axes, figure)
    return [None if place[0] is None else across, None if place[1] is None else up]


def _points(data: Reals, axes: Axes, figure: Figure) -> list[tuple[float, float]]:
    if not len(data):
        return []
    shares = (axes.transData + figure.transFigure.inverted()).transform(data)
    width, height = _POINTS_PER_INCH * figure.get_size_inches()
    return [(round(float(x * width), 2), round(float((1 - y) * height), 2)) for x, y in shares]


def _peaks(line: Line2D, axes: Axes, figure: Figure) -> list[tuple[float, float]]:
    """Return the peaks of a line over a frequency, the highest first."""
    if isinstance(line, CurveAlong) or "frequency" not in _label(axes, "x"):
        return []
    return _points(peaks(line, axes), axes, figure)


def _label(axes: Axes, direction: str) -> str:
    """Return the label of an axis; one without has that of the axes below it, or at its left."""
    place = axes.get_position()

    def distance(other: Axes) -> float:
        there = other.get_position()
        across, up = place.x0 - there.x0, place.y0 - there.y0
        along, aside = (up, across) if direction == "x" else (across, up)
        return float(along) if along >= 0 and abs(aside) < _SAME_PLACE else math.inf

    near = sorted((distance(other), index, other) for index, other in enumerate(axes.figure.axes))
    labels = (getattr(other, f"get_{direction}label")() for far, _, other in near if far < math.inf)
    return plain(next(filter(None, labels), direction))


def _curves(line: Line2D, axes: Axes, figure: Figure) -> Iterator[dict[str, object]]:
    """Describe the parts of a curve that lie inside the axes."""
    if not isinstance(line, CurveAlong):
        return
    to_figure = axes.transData + figure.transFigure.inverted()
    shares = to_figure.transform(np.column_stack(line.get_data()))
    width, height = _POINTS_PER_INCH * figure.get_size_inches()
    places = np.column_stack([shares[:, 0] * width, (1 - shares[:, 1]) * height])
    left, top, across, down = _box(axes, figure)
    inside = (np.abs(places[:, 0] - left - across / 2) <= across / 2) & (
        np.abs(places[:, 1] - top - down / 2) <= down / 2
    )
    for run in np.split(np.arange(len(places)), np.flatnonzero(np.diff(inside)) + 1):
        if inside[run[0]] and len(run) > 1:
            yield {
                "name": plain(str(line.get_label())),
                "quantity": line.along.quantity,
                "unit": line.along.unit,
                "points": _thinned(places[run], line.along.values[run]),
            }


def _thinned(places: Reals, values: Reals) -> list[float]:
    kept = [0]
    for index in range(1, len(values)):
        far = np.hypot(*(places[index] - places[kept[-1]])) >= _STEP
        changed = abs(values[index] - values[kept[-1]]) >= _VALUE_STEP * abs(values[kept[-1]])
        if far or changed or index == len(values) - 1:
            kept.append(index)
    return [
        number
        for index in kept
        for number in (*(round(float(place), 1) for place in places[index]), float(f"{values[index]:.6g}"))
    ]
